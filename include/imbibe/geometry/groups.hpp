// Groups of things, from a list of pairs that belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace imbibe::detail {

/// Things by their numbers, in groups.
class Groups {
public:
    explicit Groups(std::size_t number) : parent_(number) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    /// A number that all of a group have in common.
    std::size_t of(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t i, std::size_t j) { parent_[of(i)] = static_cast<std::uint32_t>(of(j)); }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace imbibe::detail
