// All of the library, and a scene that uses much of it, for compilers with their strictest warnings: see strict.cmake.
#include <imbibe/accuracy/study.hpp>
#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sponge.hpp>
#include <imbibe/presets/sponge_accuracy.hpp>

namespace user {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::Tait<7>, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MonaghanViscosity<K>> {};
struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                           sph::TotalLagrangianForce<K>, sph::Clamped> {};
struct Tank : sph::Wall<> {};
struct Push : sph::Coupling<Water, Rubber, sph::Into<Rubber, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>> {};
using Scene = sph::Solver<2, float, sph::Leapfrog, Water, Rubber, Tank, Push, Sides>;

} // namespace user

int main() {
    using namespace user;
    constexpr double dx = 0.02;
    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 45}}, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.2}), dx), dx);
    const auto rubber = scene.add(Rubber{{.density = 1100, .sound_speed = 40, .shear_modulus = 1e5}},
                                  sph::fill(sph::Box<2>({0.2, 0}, {0.3, 0.2}), dx), dx);
    scene.hold(rubber, [](const auto& x) { return x[1] < 0.05; });
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {1, 0.5}), dx, 3, sph::Sides::y_high), dx);
    scene.run_until(0.01, sph::Progress(0.01, false), sph::every(0.005, sph::Snapshots("out-strict")));
    scene.remove_if(water, [](const auto& x) { return x[0] > 0.25; });
    return sph::describe(scene).empty() ? 1 : 0;
}
