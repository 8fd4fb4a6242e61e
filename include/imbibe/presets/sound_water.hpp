// Water with a free surface in rigid walls, in two or three dimensions, with schemes that converge: dam breaks,
// sloshing tanks. A program that needs nothing else composes no scene, and if CMake links it with imbibe::presets it
// does not compile the scene either (docs/compile_time.md).
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
/// its viscosity and a little artificial viscosity, and walls to which its pressure is extrapolated (Adami, Hu and
/// Adams 2012), with a guard over less than a spacing against penetration. Choose a sound speed of ten times the
/// greatest speed. `examples/guides/from_a_preset.cpp` is a program with it; docs/stability.md has its limits ("weakly
/// compressible").
struct SoundWater {
    /// The kernel of all terms except the guard.
    using K = WendlandC2;
    /// Takes its coefficients from set_coefficients(), as Sides.
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
    static void set_coefficients(auto& water) {
        water.set(MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
        // The remaining tension keeps spinning water closed, and drops together. It wets a sponge no more than
        // capillarity does in such pores. The walls have none, or single drops would hang at them.
        water.set(DensityFloorParameters{.slack = 1e-3});
        // In jets and films that are drawn out, particles approach each other across them: without this a fifth of the
        // water would be in pairs. Soft, so that it neither limits the step nor throws apart particles that start near
        // each other.
        water.set(KernelRepulsionParameters{.stiffness = 1e-3 * bulk_modulus(water), .range = 0.7});
    }
    /// The same for water and its walls (Sides) or a solid: no suction, and a guard with which one layer of wall
    /// particles holds a metre of water.
    static void set_coefficients(auto& contact, const auto& water) {
        // Without suction, single particles would sink into the surface along which they slide; the guard prevents
        // that.
        contact.set(PressureExtrapolationParameters{.suction = false});
        contact.set(KernelRepulsionParameters{.stiffness = 0.005 * bulk_modulus(water), .range = 0.8});
    }

private:
    // rho c^2, Pa.
    static double bulk_modulus(const auto& water) { return water.density * sq(water.sound_speed); }
};

} // namespace imbibe::presets

/// The parts of `SoundWater::Scene<dim, Real>` that take long to compile (compiled_scene.hpp).
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
