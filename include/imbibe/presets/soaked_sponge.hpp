// A cross-section of a kitchen sponge with unresolved pores: it falls into a tray of water, soaks up water, is squeezed
// by a plate and soaks again.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/reaction_force.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe::presets {

/// The numbers of the scene, in SI units.
struct SoakedSpongeCase {
    double spacing = 1.5e-3;    ///< of all particles, m; 0.5 to 3 mm
    double length = 90e-3;      ///< of the dry sponge, m
    double height = 30e-3;      ///< of the dry sponge, m
    double porosity = 0.9;      ///< of the dry sponge, without unit
    double permeability = 1e-9; ///< of the dry sponge, m^2
    double suction = 400;       ///< suction of the dry pores, Pa: 2 sigma/r of a radius r of 0.36 mm
    double young_modulus = 2e4; ///< of the dry sponge, Pa
    double poisson_ratio = 0.2; ///< of the sponge, without unit
    double density = 150;       ///< of the dry sponge per total volume, kg/m^3
    double swelling = 0.05;     ///< the strain in each direction of a saturated sponge, without unit
    double softening = 0.5;     ///< the share of its moduli that a saturated sponge loses, without unit
    double tray = 200e-3;       ///< the width of the tray, m
    double level = 12e-3;       ///< of the water at the start, m
    double squeezed_to = 20e-3; ///< height to which the plate squeezes the sponge, m
    double pressed_from = 3.5;  ///< when the plate starts to move down, s
    double pressed_for = 1.5;   ///< how long it moves down, and up again, s
    double released_at = 7;     ///< when it starts to move up, s
    double viscosity = 1e-3;    ///< of the water, Pa s
    double sound_speed = 10;    ///< of the water, m/s: ten times its greatest speed

    /// Throws Error for a number out of range, with the allowed range.
    void check() const {
        constexpr const char* who = "SoakedSpongeCase";
        const auto within = [&](double value, const char* name, double least, double most, const char* unit) {
            require(value >= least && value <= most, who, "::", name, " = ", value, " ", unit, "; it must be ", least,
                    " to ", most, " ", unit);
        };
        within(height, "height", 5e-3, 1, "m");
        within(length, "length", height, 10, "m");
        within(spacing, "spacing", height / 200, height / 8, "m (8 to 200 particles over the height)");
        within(tray, "tray", length + 20 * spacing, 20, "m (20 spacings more than the sponge, at least)");
        within(level, "level", 3 * spacing, height, "m (3 spacings to the height of the sponge)");
        within(squeezed_to, "squeezed_to", 0.3 * height, height, "m (0.3 to 1 of the height of the sponge)");
        within(pressed_for, "pressed_for", 0.1, 1e3, "s");
        within(released_at, "released_at", pressed_from + pressed_for, 1e6, "s (when the plate is down)");
        detail::require_positive(density, who, "density", "kg/m^3");
    }
    /// The underside of the plate at the time t, m.
    double plate(double t) const {
        const double up = level + 2 * spacing + 1.2 * height;
        const double down = std::clamp((t - pressed_from) / pressed_for, 0.0, 1.0) -
                            std::clamp((t - released_at) / pressed_for, 0.0, 1.0);
        return up + down * (squeezed_to - up);
    }
};

/// A kitchen sponge in a tray, as a mixture: SeepingFluid and PorousSkeleton, with WendlandC2 for a support of 3
/// spacings. In the plane, per metre of depth.
struct SoakedSponge {
    /// The kernel of all terms.
    using K = WendlandC2;
    struct Water : Fluid<InPores<>, SeepingFluid<K>, MorrisViscosity<K>> {};
    struct Sponge
        : Solid<TotalLagrangianSolid<PorousSkeleton<CompressibleNeoHookean>, K>, TotalLagrangianViscosity<K>> {};
    struct Tray : Wall<> {};
    struct Plate : Wall<> {
        using motion = Prescribed; ///< with the velocity that Run gives it
    };
    struct Soaking : CouplingOf<Water, Sponge> {};
    struct InTray : CouplingOf<Water, Tray> {};
    struct UnderPlate : CouplingOf<Water, Plate> {};
    struct OnTray : Coupling<Sponge, Tray, KernelRepulsion<K>> {};
    struct Pressed : Coupling<Sponge, Plate, KernelRepulsion<K>, Into<Plate, ReactionForce<KernelRepulsion<K>>>> {};

    /// The scene. @tparam Real float or double
    template <class Real>
    using Scene =
        Solver<2, Real, SymplecticEuler, Water, Sponge, Tray, Plate, Soaking, InTray, UnderPlate, OnTray, Pressed>;

    /// A scene, and its phases.
    template <class Real>
    struct Run {
        SoakedSpongeCase numbers;   ///< the parameters
        Scene<Real> scene;          ///< the scene
        PhaseHandle<Water> water;   ///< in the tray, and in the sponge
        PhaseHandle<Sponge> sponge; ///< the skeleton
        PhaseHandle<Plate> plate;   ///< above it

        /// Continues until the time t, s, while the plate moves.
        void run_until(double t) {
            const double begin = scene.time();
            const int parts = static_cast<int>(std::ceil((t - begin) / 0.01 - 1e-6));
            for (int part = 0; part < parts; ++part) {
                const double from = begin + part * (t - begin) / parts, to = begin + (part + 1) * (t - begin) / parts;
                auto moving = scene[plate][velocity];
                for (int i = 0; i < moving.rows(); ++i)
                    moving(i, 1) = static_cast<Real>((numbers.plate(to) - numbers.plate(from)) / (to - from));
                scene.run_until(to);
            }
        }
        /// The mass of the water in the sponge, kg/m.
        double drunk() const {
            const auto all = scene[water];
            double sum = 0;
            for (int i = 0; i < all.size(); ++i)
                if (all[skeleton_sum](i) > 0.5)
                    sum += all[mass](i);
            return sum;
        }
        /// The mass of water that would fill all pores at the start, kg/m.
        double room() const { return 1000 * numbers.porosity * numbers.length * numbers.height; }
        /// The height of the sponge in its middle, m.
        double sponge_height() const {
            const auto x = scene[sponge][position];
            const auto X = scene[sponge][reference_position];
            double low = std::numeric_limits<double>::max(), high = -low;
            for (int i = 0; i < x.rows(); ++i)
                if (std::abs(X(i, 0)) < 0.25 * numbers.length) {
                    low = std::min(low, double(x(i, 1)));
                    high = std::max(high, double(x(i, 1)));
                }
            return high - low + numbers.spacing;
        }
        /// The force of the sponge on the plate, upwards, N/m.
        double force() const { return double(scene[plate][reaction_force].col(1).sum()); }
    };

    /// The scene with its particles. Throws Error for a number that is out of range.
    template <class Real>
    static Run<Real> make(const SoakedSpongeCase& c) {
        c.check();
        const double dx = c.spacing, g = 9.81, wide = 0.5 * c.tray, half = 0.5 * c.length;
        Run<Real> run{c, Scene<Real>({.gravity = {0, -g}, .support_radius = 3 * dx, .cfl = 0.8}), {}, {}, {}};
        Scene<Real>& scene = run.scene;
        Water liquid{{.density = 1000, .sound_speed = c.sound_speed, .viscosity = c.viscosity}};
        run.water = scene.add(liquid, fill(Box<2>{{-wide, 0}, {wide, c.level}}, dx), dx);
        Sponge dry{{.density = c.density,
                    .sound_speed = sound_speed_of(c.young_modulus, c.poisson_ratio, c.density),
                    .shear_modulus = shear_modulus_of(c.young_modulus, c.poisson_ratio)}};
        dry.set(PorousSkeletonParameters{c.porosity, c.swelling, c.softening});
        const double above = c.level + dx, top = c.plate(0);
        run.sponge = scene.add(dry, fill(Box<2>{{-half, above}, {half, above + c.height}}, dx), dx);
        const double rim = std::max(1.5 * c.height, 2 * c.level);
        scene.add(Tray{{.density = 1000}}, tank(Box<2>{{-wide, 0}, {wide, rim}}, dx, 3, Sides::y_high), dx);
        run.plate = scene.add(Plate{{.density = 1000}}, fill(Box<2>{{-half, top}, {half, top + 3 * dx}}, dx), dx);
        scene.template coupling<Soaking>().set(DarcyDragParameters{.permeability = c.permeability});
        scene.template coupling<Soaking>().set(PoreSpaceParameters{.suction = c.suction});
        const KernelRepulsionParameters contact{.stiffness = 2 * c.young_modulus, .range = 1};
        scene.template coupling<OnTray>().set(contact);
        scene.template coupling<Pressed>().set(contact);
        // Keeps drops from hanging at walls.
        scene.template coupling<InTray>().set(PressureExtrapolationParameters{.suction = false});
        scene.template coupling<UnderPlate>().set(PressureExtrapolationParameters{.suction = false});
        start_hydrostatic(scene, run.water, c.level);
        fill_pores(scene, run.water, run.sponge);
        return run;
    }
};

} // namespace imbibe::presets
