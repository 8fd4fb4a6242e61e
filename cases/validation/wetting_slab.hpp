// A drop of one liquid on a soft slab, with nothing around it.
//
// Reference and measure: those of drop-on-slab (cases/validation/drop_on_slab.hpp).
// Geometry: half a disc of R = 1, rho = sigma = 1, viscosity 0.1, at a contact angle of 90 degrees on a slab of
// thickness 1 and shear modulus 100, Poisson's ratio 0.45, periodic along x.
// Scheme: presets::WettingLiquid, settled; sound is 20.
#pragma once

#include "drop_on_slab.hpp"

#include <imbibe/presets/wetting_liquid.hpp>

namespace validation::wetting_slab {

namespace sph = imbibe;
namespace slab = drop_on_slab;
using Preset = sph::presets::WettingLiquid;
using Point = Eigen::Vector2d;

inline std::vector<Measured> measure(int across) {
    const double spacing = 1.0 / across, base = 7 * spacing, surface = base + slab::thick;
    Preset::ElasticScene<2, double> scene(
        {.support_radius = 5 * spacing, .periodic_length = {slab::wide, 0}, .threads = 1});
    std::vector<Point> drop;
    for (const auto& x : sph::fill(sph::Box<2>({0, surface}, {slab::wide, surface + 2}), spacing))
        if ((x - Point(slab::wide / 2, surface)).norm() < 1)
            drop.push_back(x);
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = 0.1}}, drop, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.1}},
              sph::fill(sph::Box<2>({0, -2}, {slab::wide, -1}), spacing), spacing); // far below, touches nothing
    const auto body =
        scene.add(Preset::elastic(2 * slab::shear_modulus * (1 + slab::poisson), slab::poisson, 1, spacing),
                  sph::fill(sph::Box<2>({0, 0}, {slab::wide, surface}), spacing), spacing);
    Preset::set_coefficients(scene, {.surface_tension = 1, .contact_angle = slab::pi / 2});
    scene.hold(body, [&](const Point& x) { return x[1] < base; });
    const auto start = scene.get<Preset::Sponge>()[sph::position].eval();
    sph::settle_surface<Preset::Water>(scene);
    return slab::measured(slab::heights<Preset::Sponge>(scene, spacing, surface, start));
}

} // namespace validation::wetting_slab
