// Two immiscible liquids, or a liquid and a surrounding gas, in rigid walls: drops, bubbles, layers, displacement in a
// channel. A program that needs nothing else composes no scene.
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

/// Two liquids with interface tension, by corrected gradients with WendlandC2, for a support of 3 spacings, in no-slip
/// walls with a given contact angle. They fill their container: there is no free surface. Both have the same spacing.
/// Choose sound speeds that make rho c^2 of both the same, and c of the heavier one ten times the greatest speed.
///
/// For density ratios up to 1000 (docs/validation.md, drop-in-gas). The sound of the lighter one, c times the root of
/// the ratio, limits the step.
struct TwoLiquids {
    /// The kernel of all terms.
    using K = WendlandC2;
    /// The terms of both.
    using Immiscible = Fluid<UnderPressure<LinearState>, CorrectedGradients<K>, Instead<DensityFloor>,
                             MorrisViscosity<K>, CapillaryFluid<K>>;
    /// The liquid in which the contact angle is measured.
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

    /// The parameters of the interface.
    struct Interface {
        double surface_tension = 0;                    ///< sigma, N/m
        double contact_angle = 0.5 * std::numbers::pi; ///< with the walls, rad, measured in the water
    };

    /// The coefficients of a liquid, set before it is added: a background pressure of 1.5 sigma/spacing for both.
    static void set_coefficients(auto& liquid, const Interface& interface, double spacing) {
        detail::require_positive(spacing, "TwoLiquids::set_coefficients", "spacing", "m");
        liquid.set(UnderPressureParameters{.background = 1.5 * interface.surface_tension / spacing});
    }
    /// Those of the couplings, set after everything was added.
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
