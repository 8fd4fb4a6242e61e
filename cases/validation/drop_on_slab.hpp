// A drop on a soft slab: the interface lifts the slab's surface at the contact lines, the drop's pressure dents it.
//
// Reference: linear elasticity in plane strain of a slab of thickness h, bonded to a rigid base, under two lines of
// force sigma upwards at the rim of the drop and the pressure sigma/R between them, which balance. The displacement is
// a Fourier series, with the slab's compliance at a wave number k (Xu, Engl, Jerison, Wallenstein, Hyland, Wilen and
// Dufresne 2010; here for any Poisson's ratio):
// (1 - nu)/(G k) ((3 - 4 nu) sinh 2kh - 2kh)/((3 - 4 nu) cosh 2kh + 2 k^2 h^2 + 5 - 12 nu + 8 nu^2).
// Geometry: half a disc of R = 1, rho = sigma = 1, at a contact angle of 90 degrees on a slab of thickness 1, in a box
// of 6 by 3 above it, periodic along x; shear modulus 100, Poisson's ratio 0.45; both liquids with a viscosity of 0.1.
// The liquids' background pressure squeezes the slab by 1.6 % with 12 particles over R, 3.3 % with 24. By the series
// that alone makes the dent 1.3 and 2.6 % shallower.
// Scheme: presets::SpongeInTwoLiquids; sound is 20.
// Measure: the mean height of the slab's surface up to 0.5 from the drop's centre, and from 0.75 to 1.25, over that
// from 2.5 to 3, the mean from t = 4 to 6.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/sponge_in_two_liquids.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace validation::drop_on_slab {

namespace sph = imbibe;
using Preset = sph::presets::SpongeInTwoLiquids;
using Point = Eigen::Vector2d;

constexpr double pi = std::numbers::pi, wide = 6, thick = 1, shear_modulus = 100, poisson = 0.45;
/// Where heights are measured, from and to which distance from the drop's centre.
struct Ring {
    double from, to;
};
constexpr Ring dent{0, 0.5}, ridge{0.75, 1.25}, beside{2.5, wide / 2};

/// The mean height of the slab's surface in a ring over that of all of it, by the reference.
inline double exact(const Ring& ring) {
    const auto [from, to] = ring;
    double height = 0;
    for (int n = 1; n < 400; ++n) {
        const double k = 2 * pi * n / wide, two_kh = 2 * k * std::min(thick, 50 / k);
        const double compliance =
            (1 - poisson) / (shear_modulus * k) * ((3 - 4 * poisson) * std::sinh(two_kh) - two_kh) /
            ((3 - 4 * poisson) * std::cosh(two_kh) + 0.5 * sph::sq(two_kh) + 5 - 12 * poisson + 8 * sph::sq(poisson));
        const double load = 2 * std::cos(k) - 2 * std::sin(k) / k;
        height += 2 / wide * compliance * load * (std::sin(k * to) - std::sin(k * from)) / (k * (to - from));
    }
    return height;
}

/// What becomes of the slab's surface, at `surface` before, over that beside the drop, the mean from 4 to 6 after now.
/// @tparam Sponge the phase of the slab
struct Heights {
    double dent = 0, ridge = 0;
};
template <class Sponge>
Heights heights(auto& scene, double spacing, double surface, const auto& start) {
    const auto mean_height = [&](const auto& x, const Ring& ring) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < x.rows(); ++i) {
            const double r = std::abs(start(i, 0) - wide / 2);
            if (start(i, 1) > surface - spacing && r > ring.from && r < ring.to)
                sum += x(i, 1) - start(i, 1), ++count;
        }
        return sum / count;
    };
    Heights seen;
    int times = 0;
    const double begin = scene.time();
    scene.run_until(begin + 6, [&](const auto& s) {
        if (s.time() < begin + 4)
            return;
        const auto x = s.template get<Sponge>()[sph::position];
        const double level = mean_height(x, beside);
        seen.dent += mean_height(x, dent) - level;
        seen.ridge += mean_height(x, ridge) - level;
        ++times;
    });
    return {seen.dent / times, seen.ridge / times};
}

/// These beside the reference.
inline std::vector<Measured> measured(const Heights& seen) {
    const double level = exact(beside);
    return {{"height of the dent", "5 % at 16", seen.dent, exact(dent) - level},
            {"height of the ridge", "none given", seen.ridge, exact(ridge) - level}};
}

inline std::vector<Measured> measure(int across) {
    const double spacing = 1.0 / across, base = 4 * spacing, surface = base + thick;
    Preset::Scene<2, double> scene({.support_radius = 3 * spacing, .periodic_length = {wide, 0}, .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = pi / 2 };
    Preset::Water water{{.density = 1, .sound_speed = 20, .viscosity = 0.1}};
    Preset::Oil oil{{.density = 1, .sound_speed = 20, .viscosity = 0.1}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    const sph::Box<2> above({0, surface}, {wide, surface + 3}), slab({0, 0}, {wide, surface});
    std::vector<Point> drop, around;
    for (const auto& x : sph::fill(above, spacing))
        ((x - Point(wide / 2, surface)).norm() < 1 ? drop : around).push_back(x);
    scene.add(water, drop, spacing);
    scene.add(oil, around, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.1}},
              sph::tank(sph::Box<2>({0, 0}, above.upper()), spacing, 4, sph::Sides::x), spacing);
    const auto body = scene.add(Preset::elastic(2 * shear_modulus * (1 + poisson), poisson, 1, spacing),
                                sph::fill(slab, spacing), spacing);
    Preset::set_coefficients(scene, interface);
    scene.hold(body, [&](const Point& x) { return x[1] < base; });
    const auto start = scene.get<Preset::Sponge>()[sph::position].eval();
    return measured(heights<Preset::Sponge>(scene, spacing, surface, start));
}

} // namespace validation::drop_on_slab
