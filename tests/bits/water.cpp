// Water: the preset's dam break in the plane, Riemann's in space, bars in a periodic flow with dual stepping and
// shifting, two liquids, corrected gradients.
#include "bits.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sound_water.hpp>

namespace imbibe_test {
namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.02;

struct Wave
    : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>, sph::MorrisViscosity<K>> {};
struct Basin : sph::Wall<> {};
struct Shore : sph::Coupling<Wave, Basin, sph::Into<Wave, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                             sph::Into<Wave, sph::RiemannWallContinuity<K>>, sph::Into<Basin, sph::NoSlipVelocity<K>>,
                             sph::NoSlipViscosity<K>> {};

struct Syrup : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MorrisViscosity<K>, sph::ParticleShifting<K>> {};
struct Bars : sph::Wall<> {};
struct AtBars : sph::Coupling<Syrup, Bars, sph::Into<Bars, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                              sph::Into<Syrup, sph::VolumeContinuity<K>>, sph::Into<Bars, sph::NoSlipVelocity<K>>,
                              sph::NoSlipViscosity<K>, sph::Into<Syrup, sph::ShiftingNeighbours<K>>> {};
using Dual = sph::DualStepping<sph::MorrisViscosity<K>, sph::NoSlipViscosity<K>, sph::ParticleShifting<K>,
                               sph::ShiftingNeighbours<K>>;

struct Heavy : sph::Fluid<sph::Tait<7>, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::ClearyViscosity<K>,
                          sph::Xsph<K>, sph::XsphTransport> {};
struct Light : sph::Fluid<sph::LinearState, sph::SummationDensity<K>, sph::VolumePressure<K>, sph::ClearyViscosity<K>> {
};
struct Interface
    : sph::Coupling<Heavy, Light, sph::VolumePressure<K>, sph::ClearyViscosity<K>,
                    sph::Into<Heavy, sph::VolumeContinuity<K>>, sph::Into<Light, sph::SummationNeighbours<K>>> {};

struct Exact : sph::Fluid<sph::LinearState, sph::CurrentCorrection<K>, sph::CorrectedContinuity<K>,
                          sph::AntuonoDiffusion<K>, sph::CorrectedPressure<K>, sph::MonaghanViscosity<K>> {};

template <int dim>
std::vector<sph::Point<dim>> shaken(std::vector<sph::Point<dim>> points) {
    return sph::jitter<dim>(std::move(points), 0.1 * dx, 3);
}

} // namespace

void run_water(Record& record) {
    using Preset = sph::presets::SoundWater;
    record.run_both("dam break 2D", []<class Real>(Real, int threads) {
        Preset::Scene<2, Real> scene(
            {.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .cfl = 0.4, .threads = threads});
        Preset::Water water{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}};
        Preset::set_coefficients(water);
        Preset::set_coefficients(scene.template coupling<Preset::Sides>(), water);
        scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.4, 0.6}), dx), dx);
        scene.add(Preset::Vessel{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {1, 0.8}), dx, 3), dx);
        return scene;
    });
    record.run_both("Riemann's dam break 3D", []<class Real>(Real, int threads) {
        sph::Solver<3, Real, sph::SymplecticEuler, Wave, Basin, Shore> scene(
            {.gravity = {0, 0, -9.81}, .support_radius = 2.6 * dx, .cfl = 0.4, .threads = threads});
        scene.add(Wave{{.density = 1000, .sound_speed = 20, .viscosity = 1}},
                  sph::fill(sph::Box<3>({0, 0, 0}, {0.16, 0.12, 0.2}), dx), dx);
        scene.add(Basin{{.density = 1000, .viscosity = 1}},
                  sph::tank(sph::Box<3>({0, 0, 0}, {0.3, 0.12, 0.3}), dx, 3, sph::Sides::z_high), dx);
        return scene;
    });
    record.run_both("bars with dual stepping", []<class Real>(Real, int threads) {
        const sph::Box<2> plane({0, 0}, {0.6, 0.6});
        const sph::Sphere<2> bar({0.3, 0.3}, 0.15);
        sph::Solver<2, Real, Dual, Syrup, Bars, AtBars> scene({.gravity = {1, 0},
                                                               .support_radius = 2.6 * dx,
                                                               .cfl = 0.4,
                                                               .periodic_length = {0.6, 0.6},
                                                               .search_skin = 0.1,
                                                               .threads = threads});
        scene.add(Syrup{{.density = 1000, .sound_speed = 20, .viscosity = 1}}, shaken<2>(sph::fill(plane - bar, dx)),
                  dx);
        scene.add(Bars{{.density = 1000, .viscosity = 1}}, sph::fill(plane & bar, dx, {0, 0}), dx);
        return scene;
    });
    record.run_both("two liquids", []<class Real>(Real, int threads) {
        sph::Solver<2, Real, sph::MidpointRungeKutta, Heavy, Light, Interface> scene({.gravity = {0, -1},
                                                                                      .support_radius = 2.6 * dx,
                                                                                      .cfl = 0.4,
                                                                                      .periodic_length = {0.6, 0},
                                                                                      .threads = threads});
        scene.add(Heavy{{.density = 1000, .sound_speed = 10, .viscosity = 1}},
                  shaken<2>(sph::fill(sph::Box<2>({0, 0}, {0.6, 0.3}), dx)), dx);
        scene.add(Light{{.density = 500, .sound_speed = 10, .viscosity = 1}},
                  shaken<2>(sph::fill(sph::Box<2>({0, 0.3}, {0.6, 0.6}), dx)), dx);
        return scene;
    });
    record.run_both("corrected gradients, periodic, many steps a search", []<class Real>(Real, int threads) {
        sph::Solver<2, Real, sph::PredictorCorrector, Exact> scene({.support_radius = 2.6 * dx,
                                                                    .cfl = 0.4,
                                                                    .periodic_length = {0.6, 0.6},
                                                                    .search_interval = 4,
                                                                    .search_skin = 0.1,
                                                                    .threads = threads});
        const auto water = scene.add(Exact{{.density = 1000, .sound_speed = 10}},
                                     shaken<2>(sph::fill(sph::Box<2>({0, 0}, {0.6, 0.6}), dx)), dx);
        for (int i = 0; i < scene[water].size(); ++i)
            scene[water][sph::velocity](i, 0) = static_cast<Real>(i % 7) / 7;
        return scene;
    });
}

} // namespace imbibe_test
