// The drag between a skeleton and the fluid in its pores.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/fluid/implicit_drag.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// Coefficients of DarcyDrag.
struct DarcyDragParameters {
    double permeability = required; ///< k of the stress-free skeleton, m^2: a kitchen sponge 1e-9, sand 1e-11
    double forchheimer_length = 0;  ///< c_F sqrt(k), m: inertial drag, with c_F = 0.55 for packed grains (Ward 1964)

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require(
            std::isfinite(permeability) && permeability > 0, where,
            ": DarcyDragParameters::permeability = ", permeability, " m^2",
            permeability == required ? " (not given)" : "",
            "; it must be a finite number above 0 m^2 (a kitchen sponge 1e-9, sand 1e-11; permeability() measures it)");
        require_not_negative(forchheimer_length, where, "DarcyDragParameters::forchheimer_length", "m");
    }
};

/// The numbers that DarcyDrag prepares from the lattice.
struct PreparedDarcyDrag {
    double per_moment = 1; ///< 1 over sum_b V_b |grad_a W_ab| |x_ab|: 1/dim within some per cent
};

namespace detail {

// K_ab of DarcyDrag.
template <class Kernel>
struct DarcyLaw {
    struct Numbers {
        DarcyDragParameters parameters{};
        PreparedDarcyDrag prepared{};
    };
    using Reads = Fields<volume, solid_volume, present_volume, velocity>;

    IMBIBE_INLINE static constexpr auto coefficient(const Numbers& of, const auto& a, const auto& b, const auto& ab) {
        const DarcyDragParameters& p = of.parameters;
        const auto& f = one_of<true>(a, b);
        const auto& s = one_of<false>(a, b);
        const double n_0 = skeleton_of(a.material, b.material).porosity;
        const auto n = 1 - s[solid_volume] / s[present_volume];
        // n^2/k with Kozeny and Carman's k/k_0 = (n/n_0)^3 ((1 - n_0)/(1 - n))^2
        const auto per_permeability = sq((1 - n) / (1 - n_0)) * power<3>(n_0) / (p.permeability * max(n, 1e-3));
        const auto speed = sqrt(squared_norm(f[velocity] - s[velocity]));
        const auto eta = f.material.viscosity + p.forchheimer_length * f.material.density * n * speed;
        return -of.prepared.per_moment * eta * per_permeability * f[volume] * s[present_volume] *
               (squared_norm(ab.offset) * ab.gradient(Kernel{}));
    }
};

} // namespace detail

/// A drag between a particle a of a fluid and a particle b of the PorousSkeleton whose pores it fills: with
///
///     K_ab = (n^2 eta/k) V_a V_b |grad_a W_ab| |x_ab|/M,    k = k_0 (n/n_0)^3 ((1 - n_0)/(1 - n))^2,
///
/// in kg/s, the porosity n of the skeleton at b, the viscosity eta of the fluid, the volumes V (per total volume) and
/// M, the sum of V_b |grad_a W_ab| |x_ab| over a lattice. The force per volume is n^2 eta/k times the velocity
/// difference (Darcy 1856). It is implicit, so that it does not limit the step, and equal and opposite. A Forchheimer
/// drag adds c_F sqrt(k_0) n rho |v_f - v_s| to eta.
///
/// In the coupling of a fluid with InPores and a skeleton.
///
/// Not for pores some spacings wide, which particles resolve.
///
/// Source: Darcy (1856); Forchheimer (1901); Kozeny (1927) and Carman (1937) for k; the implicit form, own.
template <class Kernel = WendlandC2>
struct DarcyDrag : NotStiff { // implicit: no limit on the step
    using Parameters = DarcyDragParameters;
    using Prepared = PreparedDarcyDrag;
    static constexpr bool between_fluid_and_other = true;
    static constexpr bool needs_viscosity = true;
    using Drag = detail::ImplicitDrag<detail::DarcyLaw<Kernel>>; ///< its two parts
    using parts = Parts<Volume, typename Drag::Rate, typename Drag::Slow>;

    /// Computed from the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const Lattice<dim>& lattice, const Parameters&) {
        const double all =
            lattice.volume() * lattice.sum([](const auto& ab) { return -sq(ab.distance) * ab.gradient(Kernel{}); });
        return {.per_moment = all > 0 ? 1 / all : 0};
    }
};

} // namespace imbibe
