// Any bytes for a checkpoint: they are restored or refused with an Error, and nothing else happens. For clang's
// libFuzzer with the address and undefined-behaviour sanitizers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz && build-fuzz/tests/fuzz_checkpoint -max_total_time=60
//
// Bytes as they are hardly ever get past the checksum. So the first one says what is put around the others: nothing, a
// right checksum behind them, or the right head before them and a right checksum behind.
#include <imbibe/imbibe.hpp>

#include <cstdint>
#include <cstdlib>

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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scene original = make();
    static const std::string head = [] {
        Scene scene = original;
        return sph::detail::checkpoint_head(scene);
    }();
    if (size == 0)
        return 0;
    std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    if (data[0] % 3 == 2)
        bytes = head + bytes;
    if (data[0] % 3 > 0) {
        const std::uint64_t sum = sph::detail::checksum(bytes);
        bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    }
    Scene scene = original;
    try {
        sph::detail::restore(scene, bytes, "input");
    } catch (const sph::Error&) {
        return 0;
    }
    if (scene.particles() > 1000000) // more than any input has bytes for
        std::abort();
    return 0;
}
