// Channel flow round a cylinder with a flag behind it: FSI1, which comes to rest, FSI2 and FSI3, which flutter.
//
// Reference: Turek and Hron (2006), finite elements: the displacement of the middle of the flag's free end, and drag
// and lift on cylinder and flag.
// Geometry: channel 2.5 x 0.41 m, cylinder of radius 0.05 m about (0.2, 0.2) m, flag to x = 0.6 m, 0.02 m thick, its
// root inside the cylinder; channel and flag of one square lattice, the water jittered by a twentieth of a spacing. The
// cylinder is four rings: points of the lattice would make a staircase of its surface, and a greater drag.
// Flow: periodic in x. Before water returns to the inlet its velocity is led to the parabola that enters there, and
// its density to that of no pressure, where the reference has a free outlet.
// Scheme: Wendland C2 of 2.6 spacings, sound 25 times the mean speed of the flow, density diffusion, Morris
// viscosity, shifting; no-slip walls with extrapolated pressure. Shifting off the walls makes densities drift from
// places; SummationRelaxation leads them back within 0.3 of the time in which the flow crosses the channel. Flag: St.
// Venant-Kirchhoff, sub-cycled, with the modulus of `bending_modulus`; TotalLagrangianViscosity with alpha = 0.2,
// without which its particles rattle and push water away.
// Measure: FSI1, means over the last third of 12 s. FSI2 and FSI3, half the sum and half the difference of the
// greatest and the least displacement in the last third, and the frequency from the times at which the end rises
// through that middle.
#pragma once

#include "free_surface.hpp"
#include "solid.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/summation_relaxation.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/time/subcycled.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/reaction_force.hpp>

#include <algorithm>
#include <numbers>

namespace validation::turek_hron_flow {

using K = sph::WendlandC2;

struct Flow : Water<K, sph::MorrisViscosity<K>, sph::ParticleShifting<K>, sph::SummationRelaxation<K>> {};
struct Walls : sph::Wall<> {};
struct Cylinder : sph::Wall<> {};
struct Flag : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::TotalLagrangianViscosity<K>,
                         sph::Clamped, sph::TimeAveragedMotion> {};
template <class Body, class... More>
struct Meets : sph::Coupling<Flow, Body, sph::Into<Body, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Flow, sph::VolumeContinuity<K>>, sph::Into<Body, sph::NoSlipVelocity<K>>,
                             sph::NoSlipViscosity<K>, sph::Into<Flow, sph::ShiftingNeighbours<K>>,
                             sph::Into<Flow, sph::SummationNeighbours<K>>, More...> {};
using Load = sph::ReactionForce<sph::VolumePressure<K>, sph::NoSlipViscosity<K>>;
using Scene = sph::Solver<2, double, sph::Subcycled<Flag>, Flow, Walls, Cylinder, Flag, Meets<Walls>,
                          Meets<Cylinder, sph::Into<Cylinder, Load>>, Meets<Flag, sph::Into<Flag, Load>>>;

constexpr double length = 2.5, height = 0.41, radius = 0.05, thickness = 0.02; // m
constexpr double water_density = 1000, water_viscosity = 1;                    // kg/m^3, Pa s

/// One of the three set-ups.
struct Setup {
    double mean_speed;    ///< of the flow, m/s
    double flag_density;  ///< kg/m^3
    double shear_modulus; ///< of the flag, Pa; its Poisson ratio is 0.4
    double end;           ///< of the run, s
};
constexpr Setup fsi1{0.2, 1000, 0.5e6, 12}, fsi2{1, 10'000, 0.5e6, 15}, fsi3{2, 1000, 2e6, 6};

/// The flow that enters: grows for two seconds and is a parabola over the height.
inline double inflow(const Setup& setup, double t, double y) {
    const double grown = t < 2 ? 0.5 * (1 - std::cos(0.5 * std::numbers::pi * t)) : 1;
    return grown * setup.mean_speed * 6 * y * (height - y) / (height * height);
}

/// Points on `count` rings inside a circle, the outermost half a spacing from it. Each is open on its right where it
/// would come nearer than half a spacing to a bar of that thickness, which lies along x through the middle.
inline std::vector<sph::Point<2>> open_rings(const sph::Point<2>& middle, double circle, int count, double bar,
                                             double spacing) {
    std::vector<sph::Point<2>> points;
    for (int k = 0; k < count; ++k) {
        const double r = circle - (k + 0.5) * spacing, from = std::asin((bar + spacing) / 2 / r),
                     over = 2 * (std::numbers::pi - from);
        const auto steps = std::lround(over * r / spacing);
        for (long i = 0; i <= steps; ++i) {
            const double angle = from + over * static_cast<double>(i) / static_cast<double>(steps);
            points.push_back(middle + r * sph::Point<2>(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

/// The points of the whole channel, each in what it belongs to.
struct Points {
    std::vector<sph::Point<2>> water, cylinder, flag;
};
inline Points part(double spacing) {
    constexpr int rings = 4; // more than the support reaches
    const sph::Box<2> flag{{0.25 - rings * spacing, 0.2 - thickness / 2}, {0.6, 0.2 + thickness / 2}};
    const sph::Point<2> middle(0.2, 0.2);
    Points points;
    points.flag = sph::fill(flag, spacing);
    points.cylinder = open_rings(middle, radius, rings, thickness, spacing);
    points.water = sph::fill(sph::Box<2>{{0, 0}, {length, height}}, spacing);
    std::erase_if(points.water, [&](const auto& x) { return flag.contains(x) || (x - middle).norm() < radius; });
    return points;
}

/// What a run shows, step by step.
struct History {
    std::vector<double> time;              ///< s
    std::vector<sph::Point<2>> end;        ///< how far the middle of the flag's end has moved, m
    std::vector<double> drag, lift, inlet; ///< on cylinder and flag, N/m; mean speed of the water before x = 0.1 m, m/s
};

/// Leads the water near the end of the channel, over a step of `dt`, to what enters at its beginning.
template <class View>
void renew(const View& water, const Setup& setup, double t, double dt) {
    const double sound = water.material().sound_speed;
    auto x = water[sph::position];
    auto v = water[sph::velocity];
    auto rho = water[sph::density];
    const auto towards = [&](double lower, double upper, double rate, double at) { // share of the way, in this step
        if (at < lower || at > upper)
            return 0.0;
        const double bell = std::sin(std::numbers::pi * (at - lower) / (upper - lower));
        return 1 - std::exp(-rate * bell * bell * dt);
    };
    for (int i = 0; i < water.size(); ++i) {
        if (const double share = towards(1.9, 2.5, 500 * setup.mean_speed, x(i, 0)); share > 0) {
            v(i, 0) += share * (inflow(setup, t, x(i, 1)) - v(i, 0));
            v(i, 1) -= share * v(i, 1);
        }
        rho(i) += towards(1.6, 2.1, 8 * sound, x(i, 0)) * (water_density - rho(i));
    }
}

/// @param layers of particles over the flag's thickness; even, so that all parts share one lattice
inline History run(const Setup& setup, int layers) {
    sph::require(layers % 2 == 0, "turek-hron-flow: ", layers, " particles over the thickness of the flag; it must be ",
                 "an even number, so that channel and flag share one lattice");
    const double spacing = thickness / layers, H = 2.6 * spacing;
    Scene scene({.support_radius = H, .cfl = 0.4, .periodic_length = {length, 0}, .search_interval = 4, .threads = 1});

    const Points points = part(spacing);
    Flow flow{{.density = water_density, .sound_speed = 25 * setup.mean_speed, .viscosity = water_viscosity}};
    flow.set(sph::ParticleShiftingParameters{.least_speed = 0.1 * setup.mean_speed});
    flow.set(sph::SummationRelaxationParameters{.time = 0.3 * height / setup.mean_speed});
    const auto water = scene.add(flow, sph::jitter<2>(points.water, 0.05 * spacing, 1), spacing);
    scene.add(Walls{{.density = water_density}},
              sph::tank(sph::Box<2>{{0, 0}, {length, height}}, spacing, 3, sph::Sides::x_low | sph::Sides::x_high),
              spacing);
    const auto cylinder = scene.add(Cylinder{{.density = water_density}}, points.cylinder, spacing);
    const double young = 2 * (1 + 0.4) * setup.shear_modulus;
    Flag material = elastic<Flag>(sph::bending_modulus(young, layers), 0.4, setup.flag_density);
    material.support_radius = 1.5 * spacing;
    material.set(sph::TotalLagrangianViscosityParameters{.alpha = 0.2});
    const auto flag = scene.add(material, points.flag, spacing);
    scene.hold(flag, [](const auto& x) { return x[0] < 0.25; });
    const EndProbe probe(scene[flag], layers);

    History seen;
    double before = 0;
    scene.run_until(setup.end, [&](Scene& s) {
        renew(s[water], setup, s.time(), s.time() - before);
        before = s.time();
        sph::Point<2> force = sph::Point<2>::Zero();
        const auto sum = [&](const auto& body) { force += body[sph::reaction_force].colwise().sum().transpose(); };
        sum(s[cylinder]);
        sum(s[flag]);
        double entering = 0;
        int entered = 0;
        const auto view = s[water];
        const auto x = view[sph::position], v = view[sph::velocity];
        for (int i = 0; i < view.size(); ++i)
            if (x(i, 0) < 0.1) {
                entering += v(i, 0);
                ++entered;
            }
        seen.time.push_back(s.time());
        seen.end.push_back(probe.displacement(s[flag]));
        seen.drag.push_back(force[0]);
        seen.lift.push_back(force[1]);
        seen.inlet.push_back(entering / std::max(entered, 1));
    });
    return seen;
}

/// Mean over the steps from a time on.
template <class Of>
double mean_from(const History& seen, double start, const Of& of) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < seen.time.size(); ++i)
        if (seen.time[i] >= start) {
            sum += of(i);
            ++count;
        }
    return sum / count;
}

/// How the flag's end swings from a time on.
struct Swing {
    double mean, amplitude, frequency; ///< m, m, 1/s
};
inline Swing swing_from(const History& seen, double start, int axis) {
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < seen.time.size(); ++i)
        if (seen.time[i] >= start) {
            low = std::min(low, seen.end[i][axis]);
            high = std::max(high, seen.end[i][axis]);
        }
    const double middle = (low + high) / 2, amplitude = (high - low) / 2;
    std::vector<double> upward;
    bool was_low = false; // it must have been well below between two passages, or ripples count
    for (std::size_t i = 1; i < seen.time.size(); ++i) {
        if (seen.time[i] < start)
            continue;
        const double last = seen.end[i - 1][axis] - middle, now = seen.end[i][axis] - middle;
        was_low = was_low || now < -0.3 * amplitude;
        if (was_low && last < 0 && now >= 0) {
            upward.push_back(seen.time[i] - (seen.time[i] - seen.time[i - 1]) * now / (now - last));
            was_low = false;
        }
    }
    const double periods = static_cast<double>(upward.size()) - 1;
    return {middle, amplitude, periods > 0 ? periods / (upward.back() - upward.front()) : 0};
}

inline std::vector<Measured> measure_fsi1(int layers) {
    const History seen = run(fsi1, layers);
    const double start = fsi1.end * 2 / 3;
    return {{"FSI1, u_x, m", "1 to 7 %", mean_from(seen, start, [&](auto i) { return seen.end[i][0]; }), 2.27e-5},
            {"FSI1, u_y, m", "1 to 7 %", mean_from(seen, start, [&](auto i) { return seen.end[i][1]; }), 0.8209e-3},
            {"FSI1, drag, N/m", "1 to 7 %", mean_from(seen, start, [&](auto i) { return seen.drag[i]; }), 14.295},
            {"FSI1, lift, N/m", "1 to 7 %", mean_from(seen, start, [&](auto i) { return seen.lift[i]; }), 0.7638},
            {"FSI1, mean speed near the inlet, m/s", "none given",
             mean_from(seen, start, [&](auto i) { return seen.inlet[i]; }), fsi1.mean_speed}};
}

/// The rows of a flag that flutters.
/// @param known  the reference's swing of u_y
/// @param drag   its mean drag, N/m
inline std::vector<Measured> measure_flutter(const std::string& name, const Setup& setup, int layers,
                                             const Swing& known, double drag) {
    const History seen = run(setup, layers);
    const double start = setup.end * 2 / 3;
    const Swing swing = swing_from(seen, start, 1);
    return {{name + ", mean u_y, m", "1 to 7 %", swing.mean, known.mean},
            {name + ", amplitude of u_y, m", "1 to 7 %", swing.amplitude, known.amplitude},
            {name + ", frequency of u_y, 1/s", "1 to 7 %", swing.frequency, known.frequency},
            {name + ", mean drag, N/m", "1 to 7 %", mean_from(seen, start, [&](auto i) { return seen.drag[i]; }), drag},
            {name + ", mean speed near the inlet, m/s", "none given",
             mean_from(seen, start, [&](auto i) { return seen.inlet[i]; }), setup.mean_speed}};
}
inline std::vector<Measured> measure_fsi2(int layers) {
    return measure_flutter("FSI2", fsi2, layers, {1.23e-3, 80.6e-3, 2.0}, 208.83);
}
inline std::vector<Measured> measure_fsi3(int layers) {
    return measure_flutter("FSI3", fsi3, layers, {1.48e-3, 34.38e-3, 5.3}, 457.3);
}

} // namespace validation::turek_hron_flow
