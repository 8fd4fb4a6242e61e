// The scene of the paper: a block of water falls onto an elastic slab with pores. Two compositions of it.
//
// `PaperSponge` is the method of the paper with its misprints mended; `SoundSponge` is the same scene with schemes that
// are known to converge. Both are named structs of types and makers, so that one program can run either.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/paper_slab.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace imbibe::presets {

/// The numbers of the scene, in SI units. The defaults are the paper's first case.
struct SpongeCase {
    double pore_radius = 1e-3;     ///< m
    double support_radius = 1e-3;  ///< H, m (`PaperSponge`)
    double support_ratio = 2.6;    ///< H of the water in spacings (`SoundSponge`); the sponge's is 2/2.6 of it
    double water_spacing = 0.8e-3; ///< m
    double solid_spacing = 0.5e-3; ///< m
    double gap = 4.5e-3;           ///< between the lowest water particles and the highest of the sponge, m
    double gravity = 9.8;          ///< m/s^2
    double viscosity = 3.5e-3;     ///< of the water, Pa s
    double shear_modulus = 1e6;    ///< of the sponge (`PaperSponge`), Pa; the printed 2e-6 Pa would be a liquid
    double young_modulus = 7e4;    ///< of the sponge (`SoundSponge`), Pa
    double poisson_ratio = 0.3;    ///< of the sponge (`SoundSponge`)
    double stiffness = 1e8;        ///< K_f (`PaperSponge`), Pa
    double artificial_stress = 0;  ///< epsilon of Eq. (17) (`PaperSponge`)
    double artificial_viscosity = 1; ///< alpha of Eq. (16) (`PaperSponge`)
    double time_step = 0;          ///< s; 0: the composition's own choice
    double drain = 30e-3;          ///< how far below the slab water leaves the scene, m
    bool strip = false;            ///< one row of pores, periodic in y, instead of five rows in a tank
    double pool = 0;               ///< m; above 0: water that fills the tank to this height instead of the paper's block
    double wall_gap = 0;           ///< between a pool and the walls, m; `PaperSponge` needs a support radius (K_f)
    int threads = 0;               ///< 0: all of the machine

    int rows() const { return strip ? 1 : 5; }
    double length() const { return 35e-3; }
    double width() const { return rows() * 7e-3; }
    double thickness() const { return 4e-3; }
    /// The slab's particles stand for more than its 4 mm: they lie on both faces.
    double solid_layers() const { return thickness() / solid_spacing + 1; }
    /// The lowest water, m.
    double water_bottom() const { return thickness() + gap; }
    /// The paper's block: 31 x 31 x 71 particles.
    double block_height() const { return 71 * 0.8e-3; }
    double water_height() const { return pool > 0 ? pool : block_height(); }
    /// The greatest speed to be expected: a fall from the top of the water to the sponge, m/s.
    double fall_speed() const { return std::sqrt(2 * gravity * (gap + water_height())); }

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
        positive(water_spacing, "water spacing", "m");
        positive(solid_spacing, "solid spacing", "m");
        positive(gap, "gap", "m");
        positive(shear_modulus, "shear modulus", "Pa");
        positive(young_modulus, "Young's modulus", "Pa");
        require(poisson_ratio > -1 && poisson_ratio < 0.5, "Poisson's ratio = ", poisson_ratio,
                "; it must be above -1 and below 0.5");
        require(solid_spacing <= thickness() / 2, "solid spacing = ", solid_spacing,
                " m; it must be at most 2e-3 m, half the thickness of the slab");
        require(pool >= 0 && pool < 1, "height of the pool = ", pool, " m; it must be from 0 (the paper's block) to 1 m");
    }
    std::vector<Point<3>> water() const {
        if (pool > 0 || strip) {
            const double across = strip ? 0 : wall_gap, low = water_bottom() - water_spacing / 2;
            const Box<3> box{{wall_gap, across, low}, {length() - wall_gap, width() - across, low + water_height()}};
            return fill(box, water_spacing);
        }
        const double side = 31 * water_spacing, x = length() / 2, y = width() / 2, z = water_bottom() - water_spacing / 2;
        const double height = std::round(block_height() / water_spacing) * water_spacing;
        return fill(Box<3>{{x - side / 2, y - side / 2, z}, {x + side / 2, y + side / 2, z + height}}, water_spacing);
    }
    std::vector<Point<3>> sponge() const {
        return paper_slab_particles({.pore_radius = pore_radius, .spacing = solid_spacing, .rows = rows()});
    }
    /// The walls around: the tank is as long and wide as the slab, open above and below.
    std::vector<Point<3>> vessel(double reach) const {
        const Box<3> inner{{0, 0, -drain}, {length(), width(), water_bottom() + water_height() + 5e-3}};
        const int layers = static_cast<int>(std::ceil(reach / water_spacing - 1e-9));
        return tank(inner, water_spacing, layers, strip ? Sides::y | Sides::z : Sides::z);
    }
    Settings<3> settings(double support) const {
        Settings<3> s{.gravity = {0, 0, -gravity}, .support_radius = support, .time_step = time_step, .threads = threads};
        if (strip) {
            s.periodic_lower[1] = 0;
            s.periodic_length[1] = width();
        }
        return s;
    }
    /// The outer millimetre at both ends is held.
    bool clamped(const Point<3>& x) const { return x[0] < 1e-3 || x[0] > length() - 1e-3; }
};

/// The method of the paper, mended (the equations' misprints are listed in docs/paper.md).
///
/// Where the paper is silent: walls are particles of the water's kind that do not move, with the coupling of the
/// sponge (pressure, viscosity and K_f); gamma = 7 for water and 1 for the sponge; alpha = 1; XSPH velocities in the
/// gradients and the density of the sponge, not in its motion; artificial stress in principal axes, off by default
/// (epsilon = 0), because with the spiky kernel it tears the stretched sponge apart.
struct PaperSponge {
    static constexpr const char* name = "paper";
    struct Water : Fluid<Tait<7>, Continuity<Spiky>, SymmetricPressure<Spiky>, LaminarViscosity<ViscosityKernel>> {};
    struct Sponge : Solid<LinearState, Xsph<Poly6>, Continuity<Spiky, smoothed_velocity>,
                          VelocityGradient<Spiky, smoothed_velocity>, JaumannStress, StressForce<Spiky>,
                          MonaghanViscosity<Spiky>, ArtificialStress<Spiky>, Clamped> {};
    struct Vessel : Wall<Tait<7>> {};
    struct Contact : Coupling<Water, Sponge, VolumeContinuity<Spiky>, SymmetricPressure<Spiky>,
                              LaminarViscosity<ViscosityKernel>, KernelRepulsion<Spiky>> {};
    struct Sides : Coupling<Water, Vessel, VolumeContinuity<Spiky>, SymmetricPressure<Spiky>,
                            LaminarViscosity<ViscosityKernel>, KernelRepulsion<Spiky>> {};

    template <class Real>
    using Scene = Solver<3, Real, SymplecticEuler, Water, Sponge, Vessel, Contact, Sides>;

    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        c.check();
        if (c.time_step == 0)
            c.time_step = 1e-5; // the paper's
        c.wall_gap = c.support_radius; // the distance at which K_f lets water come to rest
        Scene<Real> scene(c.settings(c.support_radius));
        scene.add(Water{{.density = 1000, .sound_speed = 30, .viscosity = c.viscosity}}, c.water(), c.water_spacing);
        Sponge sponge{{.density = 950, .sound_speed = 31.6, .shear_modulus = c.shear_modulus}};
        sponge.set(ArtificialStressParameters{.epsilon = c.artificial_stress});
        sponge.set(MonaghanViscosityParameters{.alpha = c.artificial_viscosity});
        const auto slab = scene.add(sponge, c.sponge(), c.solid_spacing);
        scene.hold(slab, [&](const Point<3>& x) { return c.clamped(x); });
        scene.add(Vessel{{.density = 1000, .sound_speed = 30, .viscosity = c.viscosity}}, c.vessel(c.support_radius),
                  c.water_spacing);
        scene.template coupling<Contact>().set(KernelRepulsionParameters{.stiffness = c.stiffness});
        scene.template coupling<Sides>().set(KernelRepulsionParameters{.stiffness = c.stiffness});
        return scene;
    }
};

/// The same scene with schemes that converge: Wendland C2 with 2.6 spacings of support, density diffusion, the
/// volume-based pressure, walls and sponge as one kind of obstacle to the water, to which its pressure is continued
/// (Adami, Hu and Adams 2012) instead of K_f, and a total-Lagrangian St. Venant-Kirchhoff sponge with corrected
/// gradients and hourglass control. Sound speed: ten times the speed of the fall. The sponge has a support of its own,
/// 2 spacings: with 2.6 a plate of nine layers swings 5 % too fast, and costs twice as much.
struct SoundSponge {
    static constexpr const char* name = "sound";
    using K = WendlandC2;
    struct Water : Fluid<LinearState, VolumeContinuity<K>, DensityDiffusion<K>, DensityFloor, VolumePressure<K>,
                         MorrisViscosity<K>, MonaghanViscosity<K>> {};
    struct Sponge : Solid<ReferenceCorrection<K>, DeformationGradient<K>, StVenantKirchhoff, TotalLagrangianForce<K>,
                          HourglassControl<K>, TotalLagrangianViscosity<K>, Clamped> {};
    struct Vessel : Wall<> {};
    struct Contact : Coupling<Water, Sponge, Into<Sponge, PressureExtrapolation<K>>, VolumePressure<K>,
                              Into<Water, VolumeContinuity<K>>> {};
    struct Sides : Coupling<Water, Vessel, Into<Vessel, PressureExtrapolation<K>>, VolumePressure<K>,
                            Into<Water, VolumeContinuity<K>>> {};

    template <class Real>
    using Scene = Solver<3, Real, SymplecticEuler, Water, Sponge, Vessel, Contact, Sides>;

    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        c.check();
        const double reach = c.support_ratio * c.water_spacing, sound_speed = 10 * c.fall_speed();
        Scene<Real> scene(c.settings(reach));
        Water water{{.density = 1000, .sound_speed = sound_speed, .viscosity = c.viscosity}};
        water.set(MonaghanViscosityParameters{.alpha = 0.02});
        scene.add(water, c.water(), c.water_spacing);
        Sponge sponge{{.density = 950,
                       .sound_speed = sound_speed_of(c.young_modulus, c.poisson_ratio, 950),
                       .shear_modulus = shear_modulus_of(c.young_modulus, c.poisson_ratio),
                       .support_radius = c.support_ratio / 1.3 * c.solid_spacing}};
        const auto slab = scene.add(sponge, c.sponge(), c.solid_spacing);
        scene.hold(slab, [&](const Point<3>& x) { return c.clamped(x); });
        scene.add(Vessel{{.density = 1000}}, c.vessel(reach), c.water_spacing);
        scene.template coupling<Contact>().set(PressureExtrapolationParameters{.suction = false});
        scene.template coupling<Sides>().set(PressureExtrapolationParameters{.suction = false});
        return scene;
    }
};

} // namespace imbibe::presets
