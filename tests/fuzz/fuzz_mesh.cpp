// Any bytes as a mesh: they are read or refused with an Error, and so is what is made of them. For clang's libFuzzer
// with the address and undefined-behaviour sanitizers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz && build-fuzz/tests/fuzz_mesh -max_total_time=60
//
// The first byte chooses the kind of file; half of the inputs get a right beginning before them.
#include <imbibe/input/read_mesh.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

namespace sph = imbibe;

sph::Triangles read(unsigned kind, const std::string& bytes) {
    const bool helped = (kind & 4) != 0;
    switch (kind & 3) {
    case 0:
        return sph::parse_stl((helped ? "solid x\n" : "") + bytes, sph::millimetres);
    case 1:
        return sph::parse_obj((helped ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n" : "") + bytes, sph::metres);
    case 2: {
        std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty "
                           "float y\nproperty float z\nelement face 2\nproperty list uchar int "
                           "vertex_indices\nend_header\n";
        return sph::parse_ply((helped ? head : "") + bytes, sph::inches);
    }
    default: {
        std::string head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                           "float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
        return sph::parse_ply((helped ? head : "") + bytes, sph::metres);
    }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    try {
        const sph::Triangles mesh = read(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
        for (const auto& triangle : mesh.triangles)
            for (const int corner : triangle)
                if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.corners.size())
                    std::abort();
        (void)sph::mend(mesh);
    } catch (const sph::Error&) {
    }
    return 0;
}
