// How a program names a phase of a scene and accesses its particles.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace imbibe {

/// Names a phase of a scene: what `add` returns and `scene[...]` takes.
template <class P>
struct PhaseHandle {};

/// One phase of the scene. The views of its fields are valid until the next step, which sorts particles.
template <class P, class S>
struct PhaseView {
    /// The columns of its particles.
    S state;
    /// A view of the particles of `where`.
    explicit PhaseView(const S& where) : state(where) {}
    /// A view of the same particles.
    PhaseView(const PhaseView&) = default;
    /// Points to the particles of `other`: `view = scene[water]`. Copies no numbers; assignment to a view of a field
    /// copies them.
    PhaseView& operator=(const PhaseView& other) {
        const S where = other.state; // taken first: `other` may be this view
        return *std::construct_at(this, where);
    }
    /// A field of all particles, n rows and one column per component, no copy: `scene[water][velocity]`.
    template <class F>
    auto operator[](F f) const {
        return state.view(f);
    }
    /// How many particles the phase has.
    int size() const { return state.size(); }
    /// ids()[i] is the number particle i had when it was added.
    const std::vector<std::uint32_t>& ids() const { return state.ids; }
    /// Its material and coefficients, to read or to change.
    auto& material() const { return state.material; }
};

} // namespace imbibe
