// The sponge scene by the paper's method: K_f between water and solids, Tait's equation, Jaumann's stress rate.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/presets/sponge_case.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>

namespace imbibe::presets {

/// The method of the paper, with its misprints corrected (docs/paper.md lists them).
///
/// Choices where the paper is silent: walls are fixed particles like the water's, with the coupling of the sponge
/// (pressure, viscosity and K_f); gamma = 7 for water and 1 for the sponge; alpha = 1; XSPH velocities in the gradients
/// and the density of the sponge, not in its motion; artificial stress in principal axes, off by default (epsilon = 0),
/// because with the spiky kernel it tears the stretched sponge apart; StaggeredLeapfrog, because with SymplecticEuler
/// at the paper's step the block of water falls apart after 70 ms.
struct PaperSponge {
    static constexpr const char* name = "paper";
    struct Water : Fluid<Tait<7>, Continuity<Spiky>, SymmetricPressure<Spiky>, LaminarViscosity<ViscosityKernel>> {};
    struct Sponge : Solid<LinearState, Xsph<Poly6>, Continuity<Spiky, smoothed_velocity>,
                          VelocityGradient<Spiky, smoothed_velocity>, JaumannStress, StressForce<Spiky>,
                          MonaghanViscosity<Spiky>, ArtificialStress<Spiky>, Clamped> {};
    struct Vessel : Wall<Tait<7>> {};
    struct Contact : Coupling<Water, Sponge, VolumeContinuity<Spiky>, SymmetricPressure<Spiky>,
                              LaminarViscosity<ViscosityKernel>, KernelRepulsion<Spiky>> {};
    struct Sides : Coupling<Water, Vessel, VolumeContinuity<Spiky>, SymmetricPressure<Spiky>,
                            LaminarViscosity<ViscosityKernel>, KernelRepulsion<Spiky>> {};

    /// The scene.
    template <class Real>
    using Scene = Solver<3, Real, StaggeredLeapfrog, Water, Sponge, Vessel, Contact, Sides>;

    /// Throws Error for a number of the case that is out of range.
    static void check(const SpongeCase& c) { c.check(); }
    /// The scene with its particles. Throws Error as check().
    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        check(c);
        if (c.time_step == 0)
            c.time_step = 1e-5; // the paper's
        if (c.search_interval == 0)
            c.search_interval = 100;
        if (c.search_skin == 0)
            c.search_skin = 0.1;       // no pair may be missed: K_f is strong even at the rim
        c.wall_gap = c.support_radius; // the distance at which K_f lets water come to rest
        Scene<Real> scene(c.settings(c.support_radius));
        scene.add(Water{{.density = 1000, .sound_speed = 30, .viscosity = c.viscosity}}, c.water(), c.water_spacing);
        Sponge sponge{{.density = 950, .sound_speed = 31.6, .shear_modulus = c.shear_modulus}};
        sponge.set(ArtificialStressParameters{.epsilon = c.artificial_stress});
        sponge.set(MonaghanViscosityParameters{.alpha = c.artificial_viscosity});
        const auto slab = scene.add(sponge, c.sponge(), c.solid_spacing);
        scene.hold(slab, [&](const Point<3>& x) { return c.clamped(x); });
        scene.add(Vessel{{.density = 1000, .sound_speed = 30, .viscosity = c.viscosity}}, c.vessel(c.support_radius),
                  c.water_spacing);
        scene.template coupling<Contact>().set(KernelRepulsionParameters{.stiffness = c.stiffness});
        scene.template coupling<Sides>().set(KernelRepulsionParameters{.stiffness = c.stiffness});
        return scene;
    }
};

} // namespace imbibe::presets

/// The parts of `PaperSponge::Scene<Real>` that take long to compile (compiled_scene.hpp).
#define IMBIBE_PAPER_SPONGE_FUNCTIONS(linkage, Real)                                                                   \
    IMBIBE_SCENE_FUNCTIONS(                                                                                            \
        linkage, imbibe::Solver<3, Real, imbibe::StaggeredLeapfrog, imbibe::presets::PaperSponge::Water,               \
                                imbibe::presets::PaperSponge::Sponge, imbibe::presets::PaperSponge::Vessel,            \
                                imbibe::presets::PaperSponge::Contact, imbibe::presets::PaperSponge::Sides>);          \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::PaperSponge::Water, imbibe::presets::PaperSponge::Scene<Real>);   \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::PaperSponge::Sponge, imbibe::presets::PaperSponge::Scene<Real>);  \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::PaperSponge::Vessel, imbibe::presets::PaperSponge::Scene<Real>)

#ifdef IMBIBE_COMPILED_PRESETS
#include <imbibe/presets/compiled_scene.hpp>
IMBIBE_PAPER_SPONGE_FUNCTIONS(extern, float);
IMBIBE_PAPER_SPONGE_FUNCTIONS(extern, double);
#endif
