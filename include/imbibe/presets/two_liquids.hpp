// Two liquids that do not mix, or a liquid and the gas around it, in rigid walls: drops, bubbles, layers, and one that
// drives the other out of a channel. A program that wants nothing else need not compose anything.
#pragma once

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/methods/capillary_fluid.hpp>
#include <imbibe/methods/corrected_gradients.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/under_pressure.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>

#include <numbers>

namespace imbibe::presets {

/// Two liquids with the tension of their interface, by corrected gradients with WendlandC2, for a support of 3
/// spacings, in walls to which both stick and which the interface meets at a given angle. They fill what they are in:
/// there is no free surface. Both have the same spacing. Choose sound speeds that make rho c^2 of both the same, and c
/// of the heavier one ten times the greatest speed.
///
/// For densities that differ by up to 10 (docs/validation.md, rising-bubble). With more the sound of the lighter one
/// makes steps short.
struct TwoLiquids {
    /// The kernel of all terms.
    using K = WendlandC2;
    /// What both are made of.
    using Immiscible = Fluid<UnderPressure<LinearState>, CorrectedGradients<K>, Instead<DensityFloor>,
                             MorrisViscosity<K>, CapillaryFluid<K>>;
    /// The one in which the contact angle is measured.
    struct Water : Immiscible {};
    /// The other one: an oil, or a gas.
    struct Oil : Immiscible {};
    struct Vessel : Wall<> {};
    /// Between the two liquids.
    struct Between : CouplingOf<Water, Oil, MorrisViscosity<K>> {};
    /// Between a liquid and the walls. @tparam Liquid Water or Oil
    template <class Liquid>
    struct Sides : CouplingOf<Liquid, Vessel, Into<Vessel, NoSlipVelocity<K>>, NoSlipViscosity<K>> {};

    /// The scene. @tparam dim 2 or 3 @tparam Real float or double
    template <int dim, class Real>
    using Scene = Solver<dim, Real, SymplecticEuler, Water, Oil, Vessel, Between, Sides<Water>, Sides<Oil>>;

    /// What there is to choose of the interface.
    struct Interface {
        double surface_tension = 0;                    ///< sigma, N/m
        double contact_angle = 0.5 * std::numbers::pi; ///< with the walls, rad, measured in the water
    };

    /// The coefficients of a liquid, before it is added: a pressure of 1.5 sigma/spacing under both.
    static void set_coefficients(auto& liquid, const Interface& interface, double spacing) {
        detail::require_positive(spacing, "TwoLiquids::set_coefficients", "spacing", "m");
        liquid.set(UnderPressureParameters{.background = 1.5 * interface.surface_tension / spacing});
    }
    /// Those of the couplings, after all was added.
    static void set_coefficients(auto& scene, const Interface& interface) {
        scene.template coupling<Between>().set(
            InterfaceTensionParameters{.surface_tension = interface.surface_tension});
        set_contact_angle<Sides>(scene, interface);
    }
    /// Those of the couplings With<Water> and With<Oil> with one wall or solid, such as Sides.
    template <template <class> class With>
    static void set_contact_angle(auto& scene, const Interface& interface) {
        const double angle = interface.contact_angle;
        scene.template coupling<With<Water>>().set(ContactAngleParameters{.contact_angle = angle});
        scene.template coupling<With<Oil>>().set(ContactAngleParameters{.contact_angle = std::numbers::pi - angle});
    }
};

} // namespace imbibe::presets
