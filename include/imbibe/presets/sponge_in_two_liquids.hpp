// A sponge between two immiscible liquids: one that soaks, or one from whose pores water displaces an oil.
#pragma once

#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/presets/two_liquids.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

namespace imbibe::presets {

/// TwoLiquids and an elastic solid, with no-slip for both and a given contact angle of their interface. The interface
/// pulls at the solid, and the liquids push it. Solid: total-Lagrangian, neo-Hookean, with corrected gradients,
/// hourglass control and a viscosity that damps its sound.
///
/// For pores of at least 8 spacings of the liquids, and solid parts of at least a support radius, 3 spacings. The
/// background pressure of both liquids, 1.5 sigma/spacing, acts on the solid too: with a bulk modulus of a hundred
/// times that its volume is smaller by 1 %.
struct SpongeInTwoLiquids : TwoLiquids {
    /// The solid. Its held parts do not move (`scene.hold`).
    struct Sponge : Solid<TotalLagrangianSolid<CompressibleNeoHookean, K>, TotalLagrangianViscosity<K>, Clamped> {};
    /// A sponge with a Young's modulus, Pa, and a Poisson's ratio, and with a support of 2 of its spacings.
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
    /// The coefficients of the couplings, set after everything was added: one contact angle with walls and sponge.
    static void set_coefficients(auto& scene, const Interface& interface) {
        TwoLiquids::set_coefficients(scene, interface);
        set_contact_angle<Pores>(scene, interface);
    }
};

} // namespace imbibe::presets
