// One liquid with a free surface that has a tension, in rigid walls and on elastic bodies that it wets: drops, menisci,
// capillary rise. A program that needs nothing else composes no scene.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/interface/settle_surface.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/methods/cohesive_fluid.hpp>
#include <imbibe/presets/sponge_in_two_liquids.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>

#include <numbers>

namespace imbibe::presets {

/// A liquid with surface tension and no gas around it, in no-slip walls and beside elastic bodies with a given contact
/// angle. The scene's support radius is 5 spacings; walls are 7 layers thick. Choose a sound speed of ten times the
/// greatest speed.
///
/// Add all, then `set_coefficients(scene, interface)`, then `settle_surface<WettingLiquid::Water>(scene)`.
///
/// Not for a gas that matters, bubbles, or a second liquid: TwoLiquids and SpongeInTwoLiquids.
struct WettingLiquid {
    /// The kernel of the liquid's terms.
    using K = WendlandC6;
    struct Water : Fluid<CohesiveFluid, MorrisViscosity<K>, KernelRepulsion<>> {};
    struct Vessel : Wall<> {};
    /// An elastic body.
    using Sponge = SpongeInTwoLiquids::Sponge;
    /// Between the liquid and walls or a sponge.
    template <class Body>
    struct On : CouplingOf<Water, Body, Into<Body, NoSlipVelocity<K>>, NoSlipViscosity<K>> {};

    /// The scene of a liquid in walls. @tparam dim 2 or 3 @tparam Real float or double
    template <int dim, class Real>
    using Scene = Solver<dim, Real, SymplecticEuler, Water, Vessel, On<Vessel>>;
    /// The same with an elastic body.
    template <int dim, class Real>
    using ElasticScene = Solver<dim, Real, SymplecticEuler, Water, Vessel, Sponge, On<Vessel>, On<Sponge>>;

    /// A sponge with a Young's modulus, Pa, and a Poisson's ratio, and with a support of 2 of its spacings.
    static Sponge elastic(double young, double poisson, double density, double spacing) {
        return SpongeInTwoLiquids::elastic(young, poisson, density, spacing);
    }

    /// The parameters of the surface.
    struct Interface {
        double surface_tension = 0;                    ///< sigma, N/m
        double contact_angle = 0.5 * std::numbers::pi; ///< with walls and sponge, rad, measured in the water
    };
    /// The coefficients, set after everything was added: of the surface, of its contact, and of a repulsion below half
    /// a spacing, which keeps the particles of small drops apart.
    template <int dim, class Real>
    static void set_coefficients(Scene<dim, Real>& scene, const Interface& interface) {
        set_surface(scene.template get<Water>().material(), interface);
        set_contact_angle<Vessel>(scene, interface);
    }
    /// The same with an elastic body.
    template <int dim, class Real>
    static void set_coefficients(ElasticScene<dim, Real>& scene, const Interface& interface) {
        set_surface(scene.template get<Water>().material(), interface);
        set_contact_angle<Vessel>(scene, interface);
        set_contact_angle<Sponge>(scene, interface);
    }
    /// Those of the liquid alone, with its spacing.
    static void set_surface(auto& liquid, const Interface& interface) {
        detail::require_positive(liquid.spacing, "WettingLiquid::set_surface", "spacing", "m");
        liquid.set(CohesionParameters{.surface_tension = interface.surface_tension});
        liquid.set(
            KernelRepulsionParameters{.stiffness = 0.05 * interface.surface_tension / liquid.spacing, .range = 0.5});
    }
    /// That with one kind of body, Vessel or Sponge.
    template <class Body>
    static void set_contact_angle(auto& scene, const Interface& interface) {
        scene.template coupling<On<Body>>().set(AdhesionParameters{.contact_angle = interface.contact_angle});
    }
};

} // namespace imbibe::presets
