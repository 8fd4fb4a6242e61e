// Water at rest in a tank whose walls do not stick.
//
// Reference: its weight, p = rho c^2 (exp(g (S - y)/c^2) - 1) under a surface at S, for p = c^2 (density - rho).
// Geometry: 1 m x 1 m, started with that pressure and the mass that goes with it, or with rho and no pressure: then the
// surface sinks to S = c^2/g log(1 + g H/c^2), 1/400 lower.
// Scheme: Wendland C2 of 3 spacings, density diffusion, MonaghanViscosity with alpha = 0.02; sound is ten times as fast
// as what falls from the surface.
// Measure: the pressure, the mean over t sqrt(g/H) = 50 to 55 (the column goes on breathing for a while, with a period
// of 4 H/c), in its lowest row, and where it is furthest off.
#pragma once

#include "case.hpp"
#include "free_surface.hpp"

#include <imbibe/fluid/summation_density.hpp>

#include <algorithm>

namespace validation::still_water {

using K = sph::WendlandC2;
struct Still : Water<K, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct StillInTank : sph::Coupling<Still, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                                   sph::Into<Still, sph::VolumeContinuity<K>>> {};

/// The same with SummationFloor.
struct Floored : Water<K, sph::MonaghanViscosity<K>, sph::SummationFloor<K>> {};
struct FlooredInTank
    : sph::Coupling<Floored, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                    sph::Into<Floored, sph::VolumeContinuity<K>>, sph::Into<Floored, sph::SummationNeighbours<K>>> {};

constexpr double g = 9.81, rho = 1000, side = 1;
constexpr double weight = rho * g * side; // Pa: 9810
constexpr double sound2 = 200 * g * side; // of the speed of sound, m^2/s^2

/// Deviation of the pressure from the reference, in rho g H.
struct Deviation {
    double bottom; ///< the mean over the lowest row
    double worst;  ///< the greatest in all of the water
    int row;       ///< particles in the lowest row
};

template <class Liquid = Still, class Contact = StillInTank>
class Column {
    using Scene = sph::Solver<2, double, sph::SymplecticEuler, Liquid, Tank, Contact>;

public:
    /// @param across particles along a side
    /// @param hydrostatic does it start with the pressure of its weight?
    Column(int across, bool hydrostatic)
        : spacing(side / across), surface(hydrostatic ? side : sound2 / g * std::log1p(g * side / sound2)),
          scene({.gravity = {0, -g}, .support_radius = 3 * spacing, .cfl = 0.4, .threads = 1}) {
        Liquid still{{.density = rho, .sound_speed = std::sqrt(sound2)}};
        still.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
        water = scene.add(still, sph::fill(sph::Box<2>{{0, 0}, {side, side}}, spacing), spacing);
        scene.add(Tank{{.density = rho}},
                  sph::tank(sph::Box<2>{{0, 0}, {side, 1.2 * side}}, spacing, 3, sph::Sides::y_high), spacing);
        auto view = scene[water];
        if (hydrostatic)
            for (int i = 0; i < view.size(); ++i) {
                const double denser = 1 + pressure(view[sph::position](i, 1)) / (rho * sound2);
                view[sph::density](i) *= denser;
                view[sph::mass](i) *= denser;
            }
    }
    /// The greatest kinetic energy until `end`, in units of t sqrt(g/H).
    double greatest_kinetic_until(double end) {
        double greatest = 0;
        scene.run_until(end * std::sqrt(side / g), [&](const Scene& s) {
            greatest = std::max(greatest, static_cast<double>(sph::kinetic_energy(s[water])));
        });
        return greatest;
    }
    /// Of the mean over time from now until `end`, in units of t sqrt(g/H).
    Deviation deviation_until(double end) {
        const auto number = static_cast<std::size_t>(scene[water].size());
        std::vector<double> excess(number), height(number); // sums over time of each particle, in the order of adding
        double samples = 0;
        scene.run_until(end * std::sqrt(side / g), [&](const Scene& s) {
            const auto view = s[water];
            for (int i = 0; i < view.size(); ++i) {
                const auto id = view.ids()[static_cast<std::size_t>(i)];
                height[id] += view[sph::position](i, 1);
                excess[id] += (view[sph::pressure](i) - pressure(view[sph::position](i, 1))) / weight;
            }
            ++samples;
        });
        Deviation found{0, 0, 0};
        for (std::size_t id = 0; id < number; ++id) {
            found.worst = std::max(found.worst, std::abs(excess[id] / samples));
            if (height[id] / samples < spacing) {
                found.bottom += excess[id] / samples;
                ++found.row;
            }
        }
        found.bottom /= found.row;
        return found;
    }

    /// How high the highest particle reaches, and the water on average, m.
    double top() const { return scene[water][sph::position].col(1).maxCoeff() + spacing / 2; }
    double mean_level() const { return 2 * scene[water][sph::position].col(1).mean(); }

private:
    /// The reference.
    double pressure(double y) const { return rho * sound2 * std::expm1(g * (surface - y) / sound2); }

    double spacing, surface;
    Scene scene;
    sph::PhaseHandle<Liquid> water;
};

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> measured;
    for (const bool hydrostatic : {true, false}) {
        Column<> column(across, hydrostatic);
        column.greatest_kinetic_until(50);
        const Deviation off = column.deviation_until(55);
        const std::string start = hydrostatic ? ", started with it" : ", started without pressure";
        measured.push_back({"pressure at the bottom, rho g H" + start, "0.5 %", 1 + off.bottom, 1});
        measured.push_back({"1 + the greatest deviation" + start, "0.5 %", 1 + off.worst, 1});
    }
    return measured;
}

} // namespace validation::still_water
