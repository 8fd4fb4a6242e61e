// The scene of the paper in numbers and points: the positions of water, sponge and walls. presets/sponge.hpp has the
// equations.
#pragma once

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/paper_slab.hpp>
#include <imbibe/solver/settings.hpp>

namespace imbibe::presets {

/// The numbers of the scene, in SI units. The defaults are the paper's first case.
struct SpongeCase {
    double pore_radius = 1e-3;       ///< m
    double support_radius = 1e-3;    ///< H, m (`PaperSponge`)
    double support_ratio = 2.6;      ///< H of the water in spacings (`SoundSponge`)
    double solid_support_ratio = 2;  ///< H of the sponge in its spacings (`SoundSponge`)
    double water_spacing = 0.8e-3;   ///< m
    double solid_spacing = 0.5e-3;   ///< m
    double gap = 4.5e-3;             ///< between the lowest water particles and the highest of the sponge, m
    double gravity = 9.8;            ///< m/s^2
    double viscosity = 3.5e-3;       ///< of the water, Pa s
    double shear_modulus = 1e6;      ///< of the sponge (`PaperSponge`), Pa; the printed 2e-6 Pa would be a liquid
    double young_modulus = 7e4;      ///< of the sponge (`SoundSponge`), Pa
    double poisson_ratio = 0.3;      ///< of the sponge (`SoundSponge`)
    double stiffness = 1e8;          ///< K_f (`PaperSponge`), Pa
    double artificial_stress = 0;    ///< epsilon of Eq. (17) (`PaperSponge`)
    double artificial_viscosity = 1; ///< alpha of Eq. (16) (`PaperSponge`)
    double time_step = 0;            ///< s; 0: the composition's own choice
    double cfl = 0.75;               ///< share of the shortest time step limit that an adaptive step takes
    int search_interval = 0;         ///< steps between two searches for neighbours; 0: the composition's own choice
    double search_skin = 0;          ///< Settings::search_skin; 0: the composition's own choice
    double drain = 30e-3;            ///< distance below the slab at which water leaves the scene, m
    double freeboard = 0;            ///< height of the walls above the water, m; 0: as high as splashes reach
    bool strip = false;              ///< one row of pores, periodic in y, instead of five rows in a tank
    double pool = 0;     ///< m; above 0: water that fills the tank to this height instead of the paper's block
    double wall_gap = 0; ///< between a pool and the walls, m; `PaperSponge` needs a support radius (K_f)
    int threads = 0;     ///< 0: all of the machine

    /// Rows of pores.
    int rows() const { return strip ? 1 : 5; }
    /// Length of the slab, along x, m.
    double length() const { return 35e-3; }
    /// Width of the slab, along y, m.
    double width() const { return rows() * 7e-3; }
    /// Thickness of the slab, m.
    double thickness() const { return 4e-3; }
    /// The slab's particles represent more than its 4 mm: they lie on both faces.
    double solid_layers() const { return thickness() / solid_spacing + 1; }
    /// The bottom of the water, m.
    double water_bottom() const { return thickness() + gap; }
    /// The paper's block: 31 x 31 x 71 particles.
    double block_height() const { return 71 * 0.8e-3; }
    /// The height of the walls above the water, m. The block slams down between them and climbs: drops reach 120 mm
    /// above its top. A pool fills the tank already.
    double walls_above() const { return freeboard > 0 ? freeboard : pool > 0 ? 5e-3 : 120e-3; }
    /// Height of the block or the pool, m.
    double water_height() const { return pool > 0 ? pool : block_height(); }
    /// The greatest expected speed: a fall from the top of the water to where it leaves the scene, m/s.
    double fall_speed() const { return std::sqrt(2 * gravity * (water_height() + water_bottom() + drain)); }

    /// Throws Error for a number out of range.
    void check() const {
        const auto positive = [](double value, const char* name, const char* unit) {
            require(std::isfinite(value) && value > 0, name, " = ", value, " ", unit, "; it must be above 0 ", unit);
        };
        positive(pore_radius, "pore radius", "m");
        require(pore_radius < 3.5e-3, "pore radius = ", pore_radius,
                " m; it must be below 3.5e-3 m, half the distance of the pores");
        positive(support_radius, "support radius", "m");
        positive(support_ratio, "support ratio", "spacings");
        positive(solid_support_ratio, "support ratio of the sponge", "spacings");
        positive(water_spacing, "water spacing", "m");
        positive(solid_spacing, "solid spacing", "m");
        positive(gap, "gap", "m");
        positive(cfl, "cfl", "(a share)");
        positive(shear_modulus, "shear modulus", "Pa");
        positive(young_modulus, "Young's modulus", "Pa");
        require(poisson_ratio > -1 && poisson_ratio < 0.5, "Poisson's ratio = ", poisson_ratio,
                "; it must be above -1 and below 0.5");
        require(solid_spacing <= thickness() / 2, "solid spacing = ", solid_spacing,
                " m; it must be at most 2e-3 m, half the thickness of the slab");
        const double rows_across = width() / water_spacing;
        require(!strip || std::abs(rows_across - std::round(rows_across)) < 1e-3 * rows_across,
                "water spacing = ", water_spacing, " m; on a strip, which is periodic, it must divide its width of ",
                width(), " m, as 0.7e-3 and 0.875e-3 m do");
        require(freeboard >= 0 && freeboard < 1, "freeboard = ", freeboard, " m; it must be from 0 (chosen) to 1 m");
        require(search_interval >= 0, "search interval = ", search_interval, " steps; it must be 0 (chosen) or more");
        require(pool >= 0 && pool < 1, "height of the pool = ", pool,
                " m; it must be from 0 (the paper's block) to 1 m");
    }
    /// The positions of the water particles, m.
    std::vector<Point<3>> water() const {
        if (pool > 0 || strip) {
            const double across = strip ? 0 : wall_gap, low = water_bottom() - water_spacing / 2;
            const Box<3> box{{wall_gap, across, low}, {length() - wall_gap, width() - across, low + water_height()}};
            return fill(box, water_spacing);
        }
        const auto whole = [&](double extent) { return std::round(extent / water_spacing) * water_spacing; };
        const double side = whole(31 * 0.8e-3), height = whole(block_height()), x = length() / 2, y = width() / 2,
                     z = water_bottom() - water_spacing / 2;
        return fill(Box<3>{{x - side / 2, y - side / 2, z}, {x + side / 2, y + side / 2, z + height}}, water_spacing);
    }
    /// The positions of the sponge particles, m.
    std::vector<Point<3>> sponge() const { return paper_slab_particles(slab()); }
    /// The parameters of its shape.
    PaperSlab slab() const { return {.pore_radius = pore_radius, .spacing = solid_spacing, .rows = rows()}; }
    /// The wall particles: the tank is as long and wide as the slab, open above and below.
    std::vector<Point<3>> vessel(double reach) const {
        const Box<3> inner{{0, 0, -drain}, {length(), width(), water_bottom() + water_height() + walls_above()}};
        const int layers = static_cast<int>(std::ceil(reach / water_spacing - 1e-9));
        return tank(inner, water_spacing, layers, strip ? Sides::y | Sides::z : Sides::z);
    }
    /// The settings of the scene, with the support radius H, m.
    Settings<3> settings(double support) const {
        Settings<3> s{.gravity = {0, 0, -gravity},
                      .support_radius = support,
                      .cfl = cfl,
                      .time_step = time_step,
                      .search_interval = std::max(search_interval, 1),
                      .search_skin = search_skin,
                      .threads = threads};
        if (strip) {
            s.periodic_lower[1] = 0;
            s.periodic_length[1] = width();
        }
        return s;
    }
    /// The outer millimetre at both ends is held.
    bool clamped(const Point<3>& x) const { return x[0] < 1e-3 || x[0] > length() - 1e-3; }
};

} // namespace imbibe::presets
