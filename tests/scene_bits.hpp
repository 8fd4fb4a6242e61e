// Everything a scene holds, bit by bit: for tests that two runs are the same.
#pragma once

#include <imbibe/solver/solver.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace imbibe_test {

/// The bytes of all fields of all phases as they lie in memory, and the particles' numbers.
template <class Scene>
std::vector<unsigned char> bits_of(const Scene& scene) {
    std::vector<unsigned char> bits;
    const auto append = [&](const auto* from, std::size_t n) {
        const std::size_t before = bits.size();
        bits.resize(before + n * sizeof(*from));
        if (n > 0)
            std::memcpy(bits.data() + before, from, n * sizeof(*from));
    };
    scene.engine().for_each_phase([&](auto, const auto& s) {
        for (int k = 0; k < std::remove_cvref_t<decltype(s)>::component_total; ++k)
            append(s.column(k), static_cast<std::size_t>(s.size()));
        append(s.ids.data(), s.ids.size());
    });
    return bits;
}

} // namespace imbibe_test
