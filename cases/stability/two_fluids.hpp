// Two fluids on top of each other, one much lighter: is the pressure continuous where they meet? Row 18.
#pragma once

#include "fluids.hpp"

namespace stability {

/// Water below a light fluid, each with the terms of presets::SoundSponge's water without its floor.
struct TwoFluids {
    using K = sph::WendlandC2;
    template <int number>
    struct Layer : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>,
                              sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
    struct Heavy : Layer<0> {};
    struct Light : Layer<1> {};
    struct Ground : sph::Wall<> {};
    struct Meeting : sph::Coupling<Heavy, Light, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
    template <class Fluid>
    using Bed = sph::Coupling<Fluid, Ground, sph::Into<Ground, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                              sph::Into<Fluid, sph::VolumeContinuity<K>>>;
    struct HeavyBed : Bed<Heavy> {};
};

/// Six spacings of water under five of a fluid that is `value` times lighter, periodic sideways, let go without
/// pressure. The light fluid is as stiff as water up to a ratio of 10, and above it a tenth of that.
inline Outcome layers(const Plan& plan) {
    using T = TwoFluids;
    constexpr double wide = 8 * dx, deep = 6 * dx, high = 5 * dx;
    const double c = 10 * std::sqrt(2 * g * (deep + high)), ratio = plan.value, unit = std::sqrt(deep / g);
    const double c_light = c * std::sqrt(std::max(std::min(ratio, 1.0), ratio / 10));
    sph::Solver<2, double, sph::SymplecticEuler, T::Heavy, T::Light, T::Ground, T::Meeting, T::HeavyBed> scene(
        {.gravity = {0, -g}, .support_radius = 2.6 * dx, .periodic_length = {wide, 0}, .threads = 1});
    T::Heavy heavy{{{.density = 1000, .sound_speed = c}}};
    T::Light light{{{.density = 1000 / ratio, .sound_speed = c_light}}};
    heavy.set(sph::MonaghanViscosityParameters{.alpha = 0.05});
    light.set(sph::MonaghanViscosityParameters{.alpha = 0.05});
    const auto below = scene.add(heavy, sph::fill(sph::Box<2>{{0, 0}, {wide, deep}}, dx), dx);
    const auto above = scene.add(light, sph::fill(sph::Box<2>{{0, deep}, {wide, deep + high}}, dx), dx);
    scene.add(T::Ground{{.density = 1000}}, sph::fill(sph::Box<2>{{0, -3 * dx}, {wide, 0}}, dx), dx);
    const double end = 3 * unit, released = 1000 * g * deep * deep * wide / 600;
    const Watch<2> watch{.end = end,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"jump of the pressure over that of a spacing of water", 1},
                                   {"kinetic energy over what is set free", 1},
                                   {"depth to which the fluids mix, spacings", 1.5}},
                         .every = 20,
                         .expected_steps = end * std::max(c, c_light) / dx};
    double jump = 0, weights = 0;
    return march(scene, plan, watch, [&](const auto& s) {
        const auto xw = s[below][sph::position], xa = s[above][sph::position];
        const auto pw = s[below][sph::pressure], pa = s[above][sph::pressure];
        const double top = xw.col(1).maxCoeff(), bottom = xa.col(1).minCoeff();
        if (s.time() > 1.5 * unit) { // both brought to the place in between, by hydrostatics; the mean over time counts
            double of_water = 0, of_air = 0;
            int n_water = 0, n_air = 0;
            const double middle = (top + bottom) / 2;
            for (Eigen::Index i = 0; i < xw.rows(); ++i)
                if (xw(i, 1) > top - 0.7 * dx)
                    of_water += pw(i) - 1000 * g * (middle - xw(i, 1)), ++n_water;
            for (Eigen::Index i = 0; i < xa.rows(); ++i)
                if (xa(i, 1) < bottom + 0.7 * dx)
                    of_air += pa(i) + 1000 / ratio * g * (xa(i, 1) - middle), ++n_air;
            jump += of_water / n_water - of_air / n_air;
            ++weights;
        }
        return std::vector{s.time() > 2.5 * unit ? std::abs(jump / weights) / (1000 * g * dx) : 0,
                           s.time() > 1.5 * unit ? sph::kinetic_energy(s[below]) / released : 0,
                           std::max((top - bottom) / dx + 1, 0.0)};
    });
}

} // namespace stability
