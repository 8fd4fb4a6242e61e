// A ring, a ball and a plate with a round hole, of fitted particles, under loads that have closed forms.
//
// Reference: the theory of elasticity, plane strain but for the ball. A ring (radii 0.5 m and 1 m) in a field of force
// c (x, -y) per mass, which bends it to an oval: Michell's solution for cos 2 theta. A ball in a field c x, which
// swells it. A plate with a hole, of which the outer particles are held where Kirsch's solution for a pull along x has
// them. Geometry: all by fitted(), across the lattice. Scheme: TotalLagrangianSolid with a support of 2 spacings, E = 1
// MPa, nu = 0.3, small strains, DynamicRelaxation until at rest. Measure: ring and ball: the displacement along the
// reference's, over all particles. Plate: the stretch of the hole, and the stress along the pull in the first layer
// beside it, where it is threefold.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/monitor/dynamic_relaxation.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <Eigen/LU>

namespace validation::fitted_bodies {

namespace sph = imbibe;

inline constexpr double E = 1e6, nu = 0.3, rho = 1000, mu = E / (2 * (1 + nu)),
                        lambda = E * nu / ((1 + nu) * (1 - 2 * nu));

/// Coefficients of Field.
struct FieldParameters {
    double stretch = 0; ///< c, 1/s^2
    double turn = 1;    ///< 1: c (x, y, z), -1: c (x, -y)

    /// Are the two the same?
    bool operator==(const FieldParameters&) const = default;
};
/// A force per mass in proportion to the place, m/s^2.
struct Field {
    using Parameters = FieldParameters;
    using reads = sph::Fields<sph::reference_position>;
    using adds = sph::Fields<sph::acceleration>;
    Parameters parameters{};

    constexpr auto operator()(const auto& a) const {
        auto force = parameters.stretch * a[sph::reference_position];
        force[1] = parameters.turn * force[1];
        return force;
    }
};
struct Body : sph::Solid<sph::TotalLagrangianSolid<>, sph::Clamped, Field> {};

template <int dim>
using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Body>;

template <int dim>
Scene<dim> scene_of(double dx) {
    return Scene<dim>({.support_radius = 2 * dx, .cfl = 0.5, .threads = 1, .on_warning = {}});
}
inline Body material(double stretch, double turn) {
    Body body{{.density = rho, .sound_speed = sph::sound_speed_of(E, nu, rho), .shear_modulus = mu}};
    body.set(FieldParameters{.stretch = stretch, .turn = turn});
    return body;
}

/// Takes the motion of the body as a whole out of its velocities: packed particles are not quite even, so that a field of
/// force pushes and turns what nothing holds.
template <int dim, class View>
void hold_as_a_whole(const View& view) {
    view[sph::velocity].rowwise() -= view[sph::velocity].colwise().mean().eval();
    for (int j = 0; j < dim; ++j)
        for (int i = 0; i < j; ++i) {
            const auto x = view[sph::position].col(i), y = view[sph::position].col(j);
            auto u = view[sph::velocity].col(i), v = view[sph::velocity].col(j);
            const double rate = (x.dot(v) - y.dot(u)) / (x.squaredNorm() + y.squaredNorm());
            u += rate * y;
            v -= rate * x;
        }
}

/// Brings the body to rest: until what moves would go less than 1e-4 of the largest displacement further.
template <int dim>
void come_to_rest(Scene<dim>& scene, sph::PhaseHandle<Body> body, bool held) {
    sph::DynamicRelaxation relaxation;
    const auto view = scene[body];
    for (int step = 1;; ++step) {
        scene.step();
        if (!held)
            hold_as_a_whole<dim>(view);
        relaxation(view, scene.time());
        if (step % 50 == 0 &&
            view[sph::velocity].rowwise().norm().maxCoeff() <
                1e-4 * relaxation.rate() *
                    (view[sph::position] - view[sph::reference_position]).rowwise().norm().maxCoeff())
            return;
    }
}

/// How far the body has moved along what `exact` gives, over that; 1 where it is right.
template <int dim, class Exact>
double along(const Scene<dim>& scene, sph::PhaseHandle<Body> body, const Exact& exact) {
    const auto view = scene[body];
    double moved = 0, expected = 0;
    for (int i = 0; i < view.size(); ++i) {
        const sph::Point<dim> X = view[sph::reference_position].row(i).transpose(),
                              u = view[sph::position].row(i).transpose() - X, known = exact(X);
        moved += u.dot(known);
        expected += known.squaredNorm();
    }
    return moved / expected;
}

/// The ring. @param across particles over its thickness
inline double ring(int across) {
    constexpr double a = 0.5, b = 1, c = 1e-2;
    const double dx = (b - a) / across;
    auto scene = scene_of<2>(dx);
    const auto body =
        scene.add(material(c, -1), sph::fitted(sph::Sphere<2>{{0, 0}, b} - sph::Sphere<2>{{0, 0}, a}, dx), dx);
    come_to_rest(scene, body, false);

    // u_r = sum k alpha r^p cos 2t, u_t = sum k beta r^p sin 2t, of which four are free and the last bears the force.
    struct Mode {
        double p, alpha, beta;
    };
    const Mode modes[]{{1, 1, -1},
                       {-3, 1, 1},
                       {3, 1, -(2 * lambda + 3 * mu) / lambda},
                       {-1, 1, -mu / (lambda + 2 * mu)},
                       {3, -rho * c / (8 * lambda + 12 * mu), 0}};
    const auto stress = [](const Mode& m, double r) { // rr, rt
        const double power = std::pow(r, m.p - 1);
        return Eigen::Vector2d((lambda * ((m.p + 1) * m.alpha + 2 * m.beta) + 2 * mu * m.p * m.alpha) * power,
                               mu * ((m.p - 1) * m.beta - 2 * m.alpha) * power);
    };
    Eigen::Matrix4d free;
    Eigen::Vector4d load;
    for (int k = 0; k < 4; ++k)
        free.col(k) << stress(modes[k], a), stress(modes[k], b);
    load << stress(modes[4], a), stress(modes[4], b);
    const Eigen::Vector4d share = -free.fullPivLu().solve(load);
    return along<2>(scene, body, [&](const sph::Point<2>& X) {
        const double r = X.norm(), t = std::atan2(X[1], X[0]);
        double radial = 0, round = 0;
        for (int k = 0; k < 5; ++k) {
            const double part = (k < 4 ? share[k] : 1) * std::pow(r, modes[k].p);
            radial += part * modes[k].alpha * std::cos(2 * t);
            round += part * modes[k].beta * std::sin(2 * t);
        }
        return sph::Point<2>((radial * X - round * sph::Point<2>(X[1], -X[0])) / r);
    });
}

/// The ball. @param across particles over its radius
inline double ball(int across) {
    constexpr double R = 1, c = 1e-2, stiff = lambda + 2 * mu;
    const double dx = R / across;
    auto scene = scene_of<3>(dx);
    const auto body = scene.add(material(c, 1), sph::fitted(sph::Sphere<3>{{0, 0, 0}, R}, dx), dx);
    come_to_rest(scene, body, false);
    // u = A r - rho c r^3/(10 (lambda + 2 mu)), with no stress at R
    constexpr double A = rho * c * R * R * (5 * lambda + 6 * mu) / (10 * stiff * (3 * lambda + 2 * mu));
    return along<3>(scene, body, [&](const sph::Point<3>& X) {
        return sph::Point<3>(X * (A - rho * c * X.squaredNorm() / (10 * stiff)));
    });
}

/// The plate.
struct Plate {
    double stretch; ///< of the hole along the pull, over Kirsch's
    double stress;  ///< along the pull beside the hole, over Kirsch's at the same places
};
/// @param across particles over the radius of the hole
inline Plate plate(int across) {
    constexpr double a = 0.25, half = 1, pull = 100, kappa = 3 - 4 * nu;
    const double dx = a / across;
    auto scene = scene_of<2>(dx);
    const auto body = scene.add(
        material(0, 1), sph::fitted(sph::Box<2>({-half, -half}, {half, half}) - sph::Sphere<2>{{0, 0}, a}, dx), dx);
    const auto exact = [&](const sph::Point<2>& X) {
        const double r = X.norm(), t = std::atan2(X[1], X[0]), k = pull * a / (8 * mu);
        const double radial =
            k * (r / a * (kappa - 1 + 2 * std::cos(2 * t)) + 2 * a / r * (1 + (kappa + 1) * std::cos(2 * t)) -
                 2 * sph::power<3>(a / r) * std::cos(2 * t));
        const double round = -k * (2 * r / a + 2 * a / r * (kappa - 1) + 2 * sph::power<3>(a / r)) * std::sin(2 * t);
        return sph::Point<2>((radial * X - round * sph::Point<2>(X[1], -X[0])) / r);
    };
    const auto outside = [&](const sph::Point<2>& X) { return X.cwiseAbs().maxCoeff() > half - 2.5 * dx; };
    scene.hold(body, outside);
    auto view = scene[body];
    for (int i = 0; i < view.size(); ++i) {
        const sph::Point<2> X = view[sph::reference_position].row(i).transpose();
        view[sph::position].row(i) += exact(X).transpose(); // the others from there to where they come to rest
    }
    come_to_rest(scene, body, true);

    double moved = 0, expected = 0, stress = 0, known = 0;
    for (int i = 0; i < view.size(); ++i) {
        const sph::Point<2> X = view[sph::reference_position].row(i).transpose(),
                            u = view[sph::position].row(i).transpose() - X;
        if (X.norm() > a + dx)
            continue;
        moved += u.dot(exact(X));
        expected += exact(X).squaredNorm();
        if (std::abs(X[0]) > 0.3 * std::abs(X[1]))
            continue;
        const double t = std::atan2(X[1], X[0]), s = sph::sq(a / X.norm());
        // of the stresses in polar coordinates, along x
        const double rr = pull / 2 * (1 - s + (1 - 4 * s + 3 * s * s) * std::cos(2 * t)),
                     tt = pull / 2 * (1 + s - (1 + 3 * s * s) * std::cos(2 * t)),
                     rt = -pull / 2 * (1 + 2 * s - 3 * s * s) * std::sin(2 * t);
        known += rr * sph::sq(std::cos(t)) + tt * sph::sq(std::sin(t)) - rt * std::sin(2 * t);
        stress += view[sph::first_piola_stress](i, 0);
    }
    return {moved / expected, stress / known};
}

inline std::vector<Measured> measure(int across) {
    const Plate with_hole = plate(across);
    return {{"ring, bent to an oval", "none given", ring(across), 1},
            {"ball, swollen", "none given", ball(across), 1},
            {"plate with a hole, stretch of the hole", "none given", with_hole.stretch, 1},
            {"plate with a hole, stress beside it", "none given", with_hole.stress, 1}};
}

} // namespace validation::fitted_bodies
