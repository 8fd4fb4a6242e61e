// The scene of the paper: a block of water falls onto an elastic slab with pores. Two compositions of it.
//
// `PaperSponge` is the method of the paper with its misprints mended; `SoundSponge` is the same scene with schemes that
// are known to converge. Both are named structs of types and makers, so that one program can run either.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/presets/sponge_case.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace imbibe::presets {

/// The method of the paper, mended (the equations' misprints are listed in docs/paper.md).
///
/// Where the paper is silent: walls are particles of the water's kind that do not move, with the coupling of the
/// sponge (pressure, viscosity and K_f); gamma = 7 for water and 1 for the sponge; alpha = 1; XSPH velocities in the
/// gradients and the density of the sponge, not in its motion; artificial stress in principal axes, off by default
/// (epsilon = 0), because with the spiky kernel it tears the stretched sponge apart; StaggeredLeapfrog, because with
/// SymplecticEuler at the paper's step the block of water falls apart after 70 ms.
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

    /// The scene with its particles. Throws Error for a number of the case that is out of range.
    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        c.check();
        if (c.time_step == 0)
            c.time_step = 1e-5; // the paper's
        if (c.search_interval == 0)
            c.search_interval = 100;
        if (c.search_skin == 0)
            c.search_skin = 0.1;       // no pair may be missed: K_f acts hard at the very rim
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

/// The same scene with schemes that converge: Wendland C2 with 2.6 spacings of support, density diffusion, the
/// volume-based pressure, walls and sponge as one kind of obstacle to the water, to which its pressure is continued
/// (Adami, Hu and Adams 2012) instead of K_f, which is left as a guard over less than a spacing, within the water too,
/// and a total-Lagrangian neo-Hookean sponge with corrected gradients and hourglass control. Sound speed: ten times the
/// speed of the fall. The sponge has a support of its own, 2 spacings: with 2.6 a plate of ten layers swings 5 % too
/// slowly, and costs twice as much. Its Young's modulus is made up for its few layers (bending_modulus).
struct SoundSponge {
    static constexpr const char* name = "sound";
    /// The kernel of all terms but the guard.
    using K = WendlandC2;
    /// To be given its coefficients by set_coefficients(), as Contact and Sides.
    struct Water : Fluid<LinearState, VolumeContinuity<K>, DensityDiffusion<K>, DensityFloor, VolumePressure<K>,
                         MorrisViscosity<K>, MonaghanViscosity<K>, KernelRepulsion<Spiky>> {};
    struct Sponge : Solid<ReferenceCorrection<K>, DeformationGradient<K>, NeoHookean, TotalLagrangianForce<K>,
                          HourglassControl<K>, TotalLagrangianViscosity<K>, Clamped> {};
    struct Vessel : Wall<> {};
    struct Contact : Coupling<Water, Sponge, Into<Sponge, PressureExtrapolation<K>>, VolumePressure<K>,
                              Into<Water, VolumeContinuity<K>>, KernelRepulsion<Spiky>> {};
    struct Sides : Coupling<Water, Vessel, Into<Vessel, PressureExtrapolation<K>>, VolumePressure<K, Tension::none>,
                            Into<Water, VolumeContinuity<K>>, KernelRepulsion<Spiky>> {};

    /// The scene.
    template <class Real>
    using Scene = Solver<3, Real, SymplecticEuler, Water, Sponge, Vessel, Contact, Sides>;

    /// The coefficients of the scheme, for this scene and for others made of its phases.
    static void set_coefficients(Water& water) {
        water.set(MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
        // The tension that is left keeps water closed that spins, and drops together. It wets the sponge, with no more
        // than capillarity has in such pores, but not the walls: single drops would hang at them.
        water.set(DensityFloorParameters{.slack = 1e-3});
        // Where jets and films are drawn out, particles come nearer to each other across them: without this a fifth of
        // the water would be in pairs. Soft, so that it neither limits the step nor throws apart what starts near.
        water.set(KernelRepulsionParameters{.stiffness = 1e-3 * bulk_modulus(water), .range = 0.7});
    }
    /// The same for water and what it meets, the sponge (Contact) or walls (Sides): no suction, and a guard with which
    /// one layer of wall particles holds a metre of water.
    static void set_coefficients(auto& contact, const Water& water) {
        // Where suction is cut off, single particles would sink into the surface along which they slide, but for the
        // guard.
        contact.set(PressureExtrapolationParameters{.suction = false});
        contact.set(KernelRepulsionParameters{.stiffness = 0.005 * bulk_modulus(water), .range = 0.8});
    }

    /// The sponge with the numbers of the case.
    static Sponge sponge(const SpongeCase& c) {
        const double young = bending_modulus(c.young_modulus, static_cast<int>(std::lround(c.solid_layers())));
        return {{.density = 950,
                 .sound_speed = sound_speed_of(young, c.poisson_ratio, 950),
                 .shear_modulus = shear_modulus_of(young, c.poisson_ratio),
                 .support_radius = c.solid_support_ratio * c.solid_spacing}};
    }

    /// The scene with its particles. Throws Error for a number of the case that is out of range.
    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        c.check();
        if (c.search_interval == 0) // fast drops make it 2; displacements stay within 0.5 % of their peak
            c.search_interval = 4;
        const double reach = c.support_ratio * c.water_spacing, sound_speed = 10 * c.fall_speed();
        Scene<Real> scene(c.settings(reach));
        Water water{{.density = 1000, .sound_speed = sound_speed, .viscosity = c.viscosity}};
        set_coefficients(water);
        scene.add(water, c.water(), c.water_spacing);
        const auto slab = scene.add(sponge(c), c.sponge(), c.solid_spacing);
        scene.hold(slab, [&](const Point<3>& x) { return c.clamped(x); });
        scene.add(Vessel{{.density = 1000}}, c.vessel(reach), c.water_spacing);
        set_coefficients(scene.template coupling<Contact>(), water);
        set_coefficients(scene.template coupling<Sides>(), water);
        return scene;
    }

private:
    // rho c^2, Pa.
    static double bulk_modulus(const Water& water) { return water.density * sq(water.sound_speed); }
};

} // namespace imbibe::presets

#ifdef IMBIBE_COMPILED_PRESETS
#include <imbibe/presets/compiled.hpp>
#endif
