// A beam that does not lie along the lattice: how far its end moves, by how its particles were placed.
//
// Reference: Timoshenko's theory of a clamped beam under its own weight, plane strain, at its end.
// Geometry: 1 m x 0.1 m, nu = 0.3, E = 1 MPa, turned by an angle; clamped beyond its root.
// Scheme: TotalLagrangianSolid, support of 1.5 spacings (2 where the faces run across the lattice), a load across the
// beam that bends it by 7 mm, and damping until it is at rest.
// Measure: the mean deflection of the last spacing. `fitted(rotated(box))` fills the box in its own frame; "across the
// lattice" hides that it is a turned box, as a body of any shape is.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/fitted.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <numbers>

namespace validation::turned_beam {

namespace sph = imbibe;

struct Beam : sph::Solid<sph::TotalLagrangianSolid<>, sph::Clamped> {};

/// A shape of which only the points are known.
struct Plain {
    sph::Transformed<sph::Box<2>> shape;
    bool contains(const sph::Point<2>& x) const { return shape.contains(x); }
    sph::Box<2> bounds() const { return shape.bounds(); }
};

/// Which particles.
enum class Placing { fitted, across_the_lattice, filled };

/// The deflection of the end over that of Timoshenko's theory.
inline double deflection(double degrees, int across, double support, Placing placing) {
    const double angle = degrees * std::numbers::pi / 180, dx = 0.1 / across;
    const double E = 1e6, nu = 0.3, rho = 1000, load = 0.05, length = 1, thick = 0.1;
    const sph::Point<2> along(std::cos(angle), std::sin(angle)), down(std::sin(angle), -std::cos(angle));
    const auto shape = sph::rotated(sph::Box<2>({-4 * dx, 0}, {length, thick}), angle);
    const auto points = placing == Placing::fitted               ? sph::fitted(shape, dx)
                        : placing == Placing::across_the_lattice ? sph::fitted(Plain{shape}, dx)
                                                                 : sph::fill(shape, dx);
    sph::Solver<2, double, sph::SymplecticEuler, Beam> scene({.gravity = {load * down[0], load * down[1]},
                                                              .support_radius = support * dx,
                                                              .cfl = 0.4,
                                                              .threads = 1,
                                                              .on_warning = {}});
    const double G = sph::shear_modulus_of(E, nu);
    const auto beam = scene.add(
        Beam{{.density = rho, .sound_speed = sph::sound_speed_of(E, nu, rho), .shear_modulus = G}}, points, dx);
    scene.hold(beam, [&](const auto& x) { return x.dot(along) < 0; });
    double before = 0;
    scene.run_until(4.2, [&](auto& s) {
        s[beam][sph::velocity] *= 1 - 5.3 * (s.time() - before);
        before = s.time();
    });
    // w(x) = q x^2 (6 l^2 - 4 l x + x^2)/(24 E' I) + q (l x - x^2/2)/(5/6 G t)
    const double q = rho * load * thick, EI = E / (1 - nu * nu) * thick * thick * thick / 12;
    double moved = 0, theory = 0;
    const auto view = scene[beam];
    for (int i = 0; i < view.size(); ++i) {
        const sph::Point<2> at = view[sph::reference_position].row(i).transpose(),
                            now = view[sph::position].row(i).transpose();
        if (const double x = at.dot(along); x > length - dx) {
            moved += (now - at).dot(down);
            theory += q * x * x * (6 * length * length - 4 * length * x + x * x) / (24 * EI) +
                      q * (length * x - x * x / 2) / (5.0 / 6 * G * thick);
        }
    }
    return moved / theory;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 45.0})
        found.push_back({sph::text("deflection at ", degrees, " degrees, fitted"), "8 % at 6, 4 % at 12",
                         deflection(degrees, across, 1.5, Placing::fitted), 1});
    for (const double degrees : {0.0, 10.0, 30.0})
        found.push_back({sph::text("at ", degrees, " degrees, fitted across the lattice, support of 2"), "none given",
                         deflection(degrees, across, 2, Placing::across_the_lattice), 1});
    for (const double degrees : {10.0, 30.0})
        found.push_back({sph::text("at ", degrees, " degrees, fill()"), "none given",
                         deflection(degrees, across, 1.5, Placing::filled), 1});
    return found;
}

} // namespace validation::turned_beam
