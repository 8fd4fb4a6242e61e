// One sponge by both ways, with pores that particles resolve and as a mixture: slats of an elastic material with slots
// between them. Liquid that stands on it runs through.
//
// Reference: flow between plates, k = n h^2/12, and a falling head: the liquid stands H above the sponge and leaves it
// below, d H/d t = -k g (L + H)/(nu L). Both leave out what the ends of the slots cost. The dry sponge sags under its
// own weight by rho g L^2/(2 E). Geometry: plane, periodic to the sides; slots and slats 1 mm wide, n = 0.5; L = 10 mm,
// H = 10 mm at the start; the slats are held at their lower end. E = 20 kPa, Poisson's ratio 0, both densities 1000
// kg/m^3, nu = 2e-5 m^2/s. Scheme: resolved, WeaklyCompressible and MorrisViscosity, a total-Lagrangian solid with
// hourglass control, to which the liquid sticks (NoSlipVelocity, NoSlipViscosity); the particles are counted across a
// slot. Mixed, SeepingFluid and PorousSkeleton with n, k and (1 - n) E; the particles are counted over L. Both with
// Wendland C2 and a support of 3 spacings, c = 5 m/s. Measure: the permeability from the speed and the slope of the
// pressure in the middle half of the sponge, while the head falls from 8 to 4 mm; how long that takes; the mean sag of
// the dry sponge over some swings.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/monitor/dynamic_relaxation.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace validation::slotted_sponge {

namespace sph = imbibe;
using K = sph::WendlandC2;

inline constexpr double L = 0.01, slot = 1e-3, n = 0.5, rho = 1000, nu = 2e-5, young = 2e4, g = 9.81, sound = 5,
                        k = n * slot * slot / 12;

// Lets the head fall and looks on. @param share of the volume over which particles of the liquid are spread, to which
// their pressure belongs
inline std::vector<Measured> drain(auto& scene, const auto& liquid, double dx, double share) {
    double sums[5]{}, flow = 0, from = 0, before = L;
    for (double part = 5e-4, end = part;; end += part) {
        scene.run_until(end);
        const auto x = scene[liquid][sph::position];
        const auto p = scene[liquid][sph::pressure];
        const auto v = scene[liquid][sph::velocity];
        const double head = x.col(1).maxCoeff() + dx / 2 - L;
        if (head < 0.008 && from == 0)
            from = end - part * (0.008 - head) / (before - head);
        if (head < 0.004) {
            const double slope = (sums[0] * sums[3] - sums[1] * sums[2]) / (sums[0] * sums[4] - sums[1] * sums[1]);
            return {{"permeability, m^2", "3 %", n * flow / sums[0] * rho * nu / (slope / share + rho * g), k},
                    {"the head falls from 8 to 4 mm, s", "3 %", end - part * (0.004 - head) / (before - head) - from,
                     nu * L / (k * g) * std::log(18.0 / 14.0)}};
        }
        if (from > 0)
            for (int i = 0; i < x.rows(); ++i)
                if (const double y = x(i, 1); y > 0.25 * L && y < 0.75 * L) {
                    const double here = p(i);
                    for (int s = 0; s < 5; ++s)
                        sums[s] += std::array{1.0, y, here, y * here, y * y}[static_cast<std::size_t>(s)];
                    flow -= v(i, 1);
                }
        before = head;
        sph::require(end < 1, "slotted-sponge: after a second the head is still ", head, " m");
    }
}

struct Elastic
    : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::TotalLagrangianViscosity<K>, sph::Clamped> {
};

// The elastic sponge, of which a share of the volume is there.
inline Elastic elastic(double share) {
    return {{.density = share * rho,
             .sound_speed = sph::sound_speed_of(young, 0, rho),
             .shear_modulus = share * sph::shear_modulus_of(young, 0)}};
}

// The mean sag of the top of a dry sponge at rest, m.
inline Measured dry_sag(const sph::Settings<2>& settings, double share, std::vector<sph::Point<2>> places, double dx) {
    sph::Solver<2, double, sph::SymplecticEuler, Elastic> scene(settings);
    for (std::size_t i = 0, all = places.size(); i < all; ++i)
        if (places[i][1] < 3 * dx)
            places.push_back({places[i][0], -places[i][1]}); // held below it
    const auto sponge = scene.add(elastic(share), places, dx);
    scene.hold(sponge, [](const auto& x) { return x[1] < 0; });
    sph::DynamicRelaxation relaxation;
    auto view = scene[sponge];
    const double swing = 4 * L / std::sqrt(young / rho);
    while (scene.time() < 10 * swing) {
        scene.step();
        relaxation(view, scene.time());
    }
    double sum = 0;
    int looks = 0;
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::reference_position](i, 1) > L - dx) {
            sum += view[sph::reference_position](i, 1) - view[sph::position](i, 1);
            ++looks;
        }
    return {"sag when dry, m", "3 %", sum / looks, rho * g * L * L / (2 * young)};
}

namespace resolved {

struct Liquid : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MorrisViscosity<K>> {};
struct Contact : sph::CouplingOf<Liquid, Elastic, sph::Into<Elastic, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {
};

inline std::vector<Measured> measure(int across) {
    const double dx = slot / across;
    const sph::Settings<2> settings{
        .gravity = {0, -g}, .support_radius = 3 * dx, .cfl = 0.8, .periodic_length = {2 * slot, 0}};
    const auto places = sph::fill(sph::Box<2>{{slot, 0}, {2 * slot, L}}, dx);
    sph::Solver<2, double, sph::SymplecticEuler, Liquid, Elastic, Contact> scene(settings);
    Liquid oil{{.density = rho, .sound_speed = sound, .viscosity = rho * nu}};
    auto all = sph::fill(sph::Box<2>{{0, 0}, {slot, L}}, dx);
    for (const auto& x : sph::fill(sph::Box<2>{{0, L}, {2 * slot, 2 * L}}, dx))
        all.push_back(x);
    const auto liquid = scene.add(oil, all, dx);
    scene.hold(scene.add(elastic(1), places, dx), [&](const auto& x) { return x[1] < 3 * dx; });
    auto found = drain(scene, liquid, dx, 1);
    found.push_back(dry_sag(settings, 1, places, dx));
    return found;
}

} // namespace resolved

namespace mixed {

struct Liquid : sph::Fluid<sph::InPores<>, sph::SeepingFluid<K>, sph::MorrisViscosity<K>> {};
struct Sponge
    : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, K>, sph::TotalLagrangianViscosity<K>, sph::Clamped> {
};
struct Soaking : sph::CouplingOf<Liquid, Sponge> {};

inline std::vector<Measured> measure(int across) {
    const double dx = L / across, width = 8 * dx;
    const sph::Settings<2> settings{
        .gravity = {0, -g}, .support_radius = 3 * dx, .cfl = 0.8, .periodic_length = {width, 0}};
    Sponge body{{.density = (1 - n) * rho,
                 .sound_speed = sph::sound_speed_of(young, 0, rho),
                 .shear_modulus = (1 - n) * sph::shear_modulus_of(young, 0)}};
    body.set(sph::PorousSkeletonParameters{.porosity = n});
    const auto places = sph::fill(sph::Box<2>{{0, 0}, {width, L}}, dx);
    sph::Solver<2, double, sph::SymplecticEuler, Liquid, Sponge, Soaking> scene(settings);
    const auto liquid = scene.add(Liquid{{.density = rho, .sound_speed = sound, .viscosity = rho * nu}},
                                  sph::fill(sph::Box<2>{{0, 0}, {width, 2 * L}}, dx), dx);
    const auto sponge = scene.add(body, places, dx);
    scene.hold(sponge, [&](const auto& x) { return x[1] < 3 * dx; });
    scene.coupling<Soaking>().set(sph::DarcyDragParameters{.permeability = k});
    sph::fill_pores(scene, liquid, sponge);
    auto found = drain(scene, liquid, dx, n);
    found.push_back(dry_sag(settings, 1 - n, places, dx));
    return found;
}

} // namespace mixed

} // namespace validation::slotted_sponge
