// A sponge between two liquids that do not mix: one that drinks, and one whose pores hold an oil that water drives out.
#pragma once

#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/presets/two_liquids.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

namespace imbibe::presets {

/// TwoLiquids and an elastic solid, to which both stick and which their interface meets at a given angle. The interface
/// pulls at the solid, and the liquids push it. Solid: total-Lagrangian, neo-Hookean, with corrected gradients,
/// hourglass control and a viscosity that damps its sound.
///
/// For pores from 8 spacings of the liquids on, and solid parts of at least a support radius, 3 spacings. The pressure
/// of 1.5 sigma/spacing that both liquids are under bears on the solid too: with a bulk modulus of a hundred times
/// that it is smaller by 1 % in volume.
struct SpongeInTwoLiquids : TwoLiquids {
    /// The solid. What is held of it, does not move (`scene.hold`).
    struct Sponge : Solid<TotalLagrangianSolid<CompressibleNeoHookean, K>, TotalLagrangianViscosity<K>, Clamped> {};
    /// One with a Young's modulus, Pa, and a Poisson's ratio, and with a support of 2 of its spacings.
    static Sponge elastic(double young, double poisson, double density, double spacing) {
        return {{.density = density,
                 .sound_speed = sound_speed_of(young, poisson, density),
                 .shear_modulus = shear_modulus_of(young, poisson),
                 .support_radius = 2 * spacing}};
    }
    /// Between a liquid and the sponge. @tparam Liquid Water or Oil
    template <class Liquid>
    struct Pores : CouplingOf<Liquid, Sponge, Into<Sponge, NoSlipVelocity<K>>, NoSlipViscosity<K>> {};

    /// The scene. @tparam dim 2 or 3 @tparam Real float or double
    template <int dim, class Real>
    using Scene = Solver<dim, Real, SymplecticEuler, Water, Oil, Vessel, Sponge, Between, Sides<Water>, Sides<Oil>,
                         Pores<Water>, Pores<Oil>>;

    using TwoLiquids::set_coefficients;
    /// The coefficients of the couplings, after all was added: one contact angle with walls and sponge.
    static void set_coefficients(auto& scene, const Interface& interface) {
        TwoLiquids::set_coefficients(scene, interface);
        set_contact_angle<Pores>(scene, interface);
    }
};

} // namespace imbibe::presets
