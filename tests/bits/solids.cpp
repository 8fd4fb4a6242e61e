// Solids: two rings of the hypoelastic kind, a sub-cycled gate that water pushes, total-Lagrangian bodies of each law,
// some of them across periodic sides.
#include "bits.hpp"

#include <imbibe/imbibe.hpp>

namespace imbibe_test {
namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.01;

struct Rings : sph::Solid<sph::LinearState, sph::Continuity<sph::CubicSpline>, sph::VelocityGradient<sph::CubicSpline>,
                          sph::JaumannStress, sph::StressForce<sph::CubicSpline>,
                          sph::ArtificialStress<sph::CubicSpline>, sph::MonaghanViscosity<sph::CubicSpline>> {};

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::DensityFloor,
                          sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Gate
    : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                 sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped, sph::TimeAveragedMotion> {};
struct Tank : sph::Wall<> {};
struct Push : sph::Coupling<Water, Gate, sph::Into<Gate, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Water, sph::VolumeContinuity<K>>,
                            sph::Into<Gate, sph::ReactionForce<sph::VolumePressure<K>>>> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>> {};

struct Soft : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::VolumetricDeviatoric<>,
                         sph::TotalLagrangianForce<K>, sph::TotalLagrangianViscosity<K>> {};
struct Hard : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>,
                         sph::FiniteStrainLimit<sph::StVenantKirchhoff>, sph::TotalLagrangianForce<K>,
                         sph::HourglassControl<K>> {};
struct Bump : sph::Coupling<Soft, Hard, sph::KernelRepulsion<>> {};

} // namespace

void run_solids(Record& record) {
    record.run_both("rubber rings", []<class Real>(Real, int threads) {
        sph::Solver<2, Real, sph::Leapfrog, Rings> scene({.support_radius = 2.6 * dx, .cfl = 0.4, .threads = threads});
        const auto ring = [&](double x) {
            return sph::fill(sph::Sphere<2>{{x, 0}, 0.2} - sph::Sphere<2>{{x, 0}, 0.13}, dx);
        };
        const Rings rubber{{.density = 1000, .sound_speed = 40, .shear_modulus = 3e5}};
        scene.add(rubber, ring(-0.205), dx);
        const auto rings = scene.add(rubber, ring(0.205), dx);
        for (int i = 0; i < scene[rings].size(); ++i)
            scene[rings][sph::velocity](i, 0) = scene[rings][sph::position](i, 0) < 0 ? 2 : -2;
        return scene;
    });
    record.run_both("sub-cycled gate", []<class Real>(Real, int threads) {
        sph::Solver<2, Real, sph::Subcycled<Gate>, Water, Gate, Tank, Push, Sides> scene(
            {.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .cfl = 0.4, .search_interval = 3, .threads = threads});
        scene.add(Water{{.density = 1000, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.3}), dx), dx);
        const auto gate = scene.add(Gate{{.density = 1100, .sound_speed = 60, .shear_modulus = 1e6}},
                                    sph::fill(sph::Box<2>({0.2, 0.5 * dx}, {0.24, 0.4}), dx, {0, 0.5 * dx}), dx);
        scene.hold(gate, [](const auto& x) { return x[1] > 0.35; });
        scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {0.5, 0.4}), dx, 3, sph::Sides::y_high), dx);
        return scene;
    });
    record.run_both("bodies across periodic sides", []<class Real>(Real, int threads) {
        sph::Solver<3, Real, sph::PositionVerlet, Soft, Hard, Bump> scene(
            {.support_radius = 1.5 * dx, .cfl = 0.4, .periodic_length = {0.2, 0.2, 0.2}, .threads = threads});
        const auto soft = scene.add(Soft{{.density = 1000, .sound_speed = 30, .shear_modulus = 2e5}},
                                    sph::fill(sph::Box<3>({0.15, 0, 0}, {0.2, 0.06, 0.06}), dx), dx);
        const auto hard = scene.add(Hard{{.density = 2000, .sound_speed = 40, .shear_modulus = 1e6}},
                                    sph::fill(sph::Box<3>({0.03, 0, 0}, {0.08, 0.06, 0.06}), dx), dx);
        scene[soft][sph::velocity].col(0).setConstant(5);
        scene[hard][sph::velocity].col(1).setConstant(-1);
        return scene;
    });
}

} // namespace imbibe_test
