// A drag that holds frozen fluid to walls and solids, which may move.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/implicit_drag.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// Coefficients of FrozenDrag.
struct FrozenDragParameters {
    double drag = 1e7;        ///< A, kg/(m^3 s): 1e5 to 1e8, from mush that creeps to ice
    double mush_limit = 1e-3; ///< q, without unit: keeps the drag of ice finite, A/q

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(drag, where, "FrozenDragParameters::drag", "kg/(m^3 s)");
        require(std::isfinite(mush_limit) && mush_limit > 0, where, ": FrozenDragParameters::mush_limit = ", mush_limit,
                "; it must be a finite number above 0 (1e-3)");
    }
};

namespace detail {

// A (1 - f)^2/(f^3 + q), kg/(m^3 s).
IMBIBE_INLINE constexpr auto mush_drag(const FrozenDragParameters& p, const auto& f) {
    return p.drag * sq(1 - f) / (power<3>(f) + p.mush_limit);
}

// The liquid fraction of the fluid of the pair.
IMBIBE_INLINE constexpr auto liquid_of_pair(const auto& a, const auto& b) {
    if constexpr (is_fluid<typename std::remove_cvref_t<decltype(a)>::Material>)
        return a[liquid_fraction];
    else
        return b[liquid_fraction];
}

// K_ab of FrozenDrag.
template <class Kernel>
struct FrozenDragLaw {
    struct Numbers {
        FrozenDragParameters parameters{};
    };
    using Reads = Fields<volume, liquid_fraction>;

    IMBIBE_INLINE static constexpr auto coefficient(const Numbers& of, const auto& a, const auto& b, const auto& ab) {
        constexpr double dim = decltype(ab.offset)::size;
        return (-1 / dim) * mush_drag(of.parameters, liquid_of_pair(a, b)) * (a[volume] * b[volume]) *
               (squared_norm(ab.offset) * ab.gradient(Kernel{}));
    }
};

} // namespace detail

/// A drag between a frozen particle a of a fluid and a particle b of a wall or solid: with the coefficient K_ab = A g
/// V_a V_b |grad_a W_ab| |x_ab|/dim, in kg/s, g = (1 - f)^2/(f^3 + q), the liquid fraction f and volumes V = m/rho,
///
///     dv_a/dt = - 1/m_a sum_b K_ab/(1 + dt (L_a + L_b)) (v*_a - v*_b),    L_a = 1/m_a sum_b K_ab,
///
/// in m/s^2, with the velocities v* that the particles would have at the end of the step without it. It does not limit
/// the step, however large A is, and conserves momentum: the force on the solid is opposite. At f = 1 there is no drag.
///
/// In the couplings of a fluid that has Melting with solids, and `Into` the fluid in those with walls: the ice moves
/// with the body to which it is frozen, and holds it. The drag acts within a support radius; FrozenStress in the fluid
/// lets that ice hold the ice further away. If nothing moves, EnthalpyPorosity is cheaper.
///
/// Not for ice that breaks off.
///
/// Source: Voller and Prakash (1987), Eq. (13), between pairs of particles instead of towards a skeleton at rest; the
/// implicit form, own.
template <class Kernel = WendlandC2>
struct FrozenDrag : NotStiff { // implicit: no limit on the step
    static constexpr bool between_fluid_and_other = true;
    using Parameters = FrozenDragParameters;
    using Drag = detail::ImplicitDrag<detail::FrozenDragLaw<Kernel>>; ///< its two parts
    using parts = Parts<Volume, typename Drag::Rate, typename Drag::Slow>;
};

} // namespace imbibe
