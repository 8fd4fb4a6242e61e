// Water with a free surface in rigid walls, in the plane or in space, by schemes that are known to converge: dams that
// break, tanks that slosh. A program that wants nothing else need not compose anything, and where CMake has linked it
// with imbibe::presets it need not compile the scene either (docs/compile_time.md).
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace imbibe::presets {

/// Weakly compressible water: Wendland C2, for a support of 2.6 spacings, density diffusion, the volume-based pressure,
/// its viscosity and a little artificial one, and walls to which its pressure is continued (Adami, Hu and Adams 2012),
/// with a guard over less than a spacing against what comes too near. Choose a sound speed of ten times the greatest
/// speed. `examples/guides/from_a_preset.cpp` is a program with it; docs/stability.md says what it bears ("weakly
/// compressible").
struct SoundWater {
    /// The kernel of all terms but the guard.
    using K = WendlandC2;
    /// To be given its coefficients by set_coefficients(), as Sides.
    struct Water
        : Fluid<LinearState, WeaklyCompressible<K>, MorrisViscosity<K>, MonaghanViscosity<K>, KernelRepulsion<Spiky>> {
    };
    struct Vessel : Wall<> {};
    struct Sides : Coupling<Water, Vessel, Into<Vessel, PressureExtrapolation<K>>, VolumePressure<K, Tension::none>,
                            Into<Water, VolumeContinuity<K>>, KernelRepulsion<Spiky>> {};

    /// The scene. @tparam dim 2 or 3 @tparam Real float or double
    template <int dim, class Real>
    using Scene = Solver<dim, Real, SymplecticEuler, Water, Vessel, Sides>;

    /// The coefficients of the scheme.
    static void set_coefficients(Water& water) {
        water.set(MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
        // The tension that is left keeps water closed that spins, and drops together. It wets a sponge, with no more
        // than capillarity has in such pores, but not the walls: single drops would hang at them.
        water.set(DensityFloorParameters{.slack = 1e-3});
        // Where jets and films are drawn out, particles come nearer to each other across them: without this a fifth of
        // the water would be in pairs. Soft, so that it neither limits the step nor throws apart what starts near.
        water.set(KernelRepulsionParameters{.stiffness = 1e-3 * bulk_modulus(water), .range = 0.7});
    }
    /// The same for water and what it meets, walls (Sides) or a solid: no suction, and a guard with which one layer of
    /// wall particles holds a metre of water.
    static void set_coefficients(auto& contact, const Water& water) {
        // Where suction is cut off, single particles would sink into the surface along which they slide, but for the
        // guard.
        contact.set(PressureExtrapolationParameters{.suction = false});
        contact.set(KernelRepulsionParameters{.stiffness = 0.005 * bulk_modulus(water), .range = 0.8});
    }

private:
    // rho c^2, Pa.
    static double bulk_modulus(const Water& water) { return water.density * sq(water.sound_speed); }
};

} // namespace imbibe::presets

/// What takes a compiler long of `SoundWater::Scene<dim, Real>` (compiled_scene.hpp).
#define IMBIBE_SOUND_WATER_FUNCTIONS(linkage, dim, Real)                                                               \
    IMBIBE_SCENE_FUNCTIONS(linkage,                                                                                    \
                           imbibe::Solver<dim, Real, imbibe::SymplecticEuler, imbibe::presets::SoundWater::Water,      \
                                          imbibe::presets::SoundWater::Vessel, imbibe::presets::SoundWater::Sides>);   \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::SoundWater::Water,                                                \
                           imbibe::presets::SoundWater::Scene<dim, Real>);                                             \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::SoundWater::Vessel, imbibe::presets::SoundWater::Scene<dim, Real>)

#ifdef IMBIBE_COMPILED_PRESETS
#include <imbibe/presets/compiled_scene.hpp>
IMBIBE_SOUND_WATER_FUNCTIONS(extern, 2, float);
IMBIBE_SOUND_WATER_FUNCTIONS(extern, 2, double);
IMBIBE_SOUND_WATER_FUNCTIONS(extern, 3, float);
IMBIBE_SOUND_WATER_FUNCTIONS(extern, 3, double);
#endif
