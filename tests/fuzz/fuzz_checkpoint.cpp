// Any bytes for a checkpoint: they are restored or refused with an Error, and nothing else happens. For clang's
// libFuzzer with the address and undefined-behaviour sanitizers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz && build-fuzz/tests/fuzz_checkpoint -max_total_time=60
//
// Bytes as they are hardly ever get past the checksum. So the first one says what is made of the others: nothing; a
// right checksum is put behind them; the right head before them and a right checksum behind; or a whole checkpoint is
// changed where they say, and gets a right checksum. What was restored takes a step.
#include <imbibe/imbibe.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::Clamped> {};
using Scene = sph::Solver<2, float, sph::SymplecticEuler, Water, Block>;

Scene make() {
    Scene scene({.support_radius = 0.26, .threads = 1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>{{0, 0.5}, {0.4, 0.9}}, 0.1), 0.1);
    scene.add(Block{{.density = 1000, .sound_speed = 10, .shear_modulus = 1e4}},
              sph::fill(sph::Box<2>{{0, 0}, {0.4, 0.2}}, 0.1), 0.1);
    scene.prepare();
    return scene;
}

/// `whole` without its checksum, after changes of four bytes each: a place, and what its byte is xored with.
std::string changed(std::string whole, const std::string& changes) {
    whole.resize(whole.size() - sizeof(std::uint64_t));
    for (std::size_t k = 0; k + 4 <= changes.size(); k += 4) {
        std::uint32_t change = 0;
        std::memcpy(&change, changes.data() + k, 4);
        whole[(change >> 8) % whole.size()] ^= static_cast<char>(change & 0xff);
    }
    return whole;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scene original = make();
    static const std::string head = [] {
        Scene scene = original;
        return sph::detail::checkpoint_head(scene);
    }();
    static const std::string whole = [] {
        Scene scene = original;
        return sph::detail::checkpoint_bytes(scene);
    }();
    if (size == 0)
        return 0;
    std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    if (data[0] % 4 == 2)
        bytes = head + bytes;
    if (data[0] % 4 == 3)
        bytes = changed(whole, bytes);
    if (data[0] % 4 > 0) {
        const std::uint64_t sum = sph::detail::checksum(bytes);
        bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    }
    Scene scene = original;
    try {
        sph::detail::restore(scene, bytes, "input");
        scene.step();
    } catch (const sph::Error&) {
        return 0;
    }
    if (scene.particles() > 1000000) // more than any input has bytes for
        std::abort();
    return 0;
}
