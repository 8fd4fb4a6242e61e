// All of the library, and a scene that uses much of it, for compilers with their strictest warnings: see strict.cmake.
#include "platform_macros.hpp"

#include <imbibe/accuracy/study.hpp>
#include <imbibe/imbibe.hpp>
#include <imbibe/input/input.hpp>
#include <imbibe/porous/permeability.hpp>
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
struct Push : sph::Coupling<Water, Rubber, sph::Into<Rubber, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Water, sph::VolumeContinuity<K>>,
                            sph::Into<Rubber, sph::ReactionForce<sph::VolumePressure<K>>>> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>> {};
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
    scene.run_until(0.01, sph::Progress(0.01, false), sph::every(0.005, sph::Snapshots("out-strict")),
                    sph::Checkpoints("out-strict/checkpoint", 600, 0.005));
    sph::Table table("out-strict/gauges.csv", {{"time", "s"}, {"pressure", "Pa"}, {"height", "m"}});
    const sph::DisplacementProbe<2> probe(scene[rubber], scene.settings());
    sph::Guard<2> guard({.least_pore = 1});
    sph::run_and_recover(
        scene, 0.02, guard, "out-strict/checkpoint", 600, 1, [](const auto&) {},
        [&](const Scene& s) {
            table.row({s.time(), sph::value_at(s, water, sph::pressure, {0.1, 0.1}),
                       sph::surface_height(s, water, {0.1, 0})});
        });
    const double energy = sph::kinetic_energy(scene[water]) + sph::compression_energy(scene[water]) +
                          sph::elastic_energy<2>(scene[rubber]) + sph::stored_energy(scene[rubber]) +
                          sph::potential_energy(scene[rubber], scene.settings().gravity);
    const bool sane = energy > 0 && probe.mean(scene[rubber]) > 0 && sph::momentum(scene[water]).allFinite() &&
                      scene[rubber][sph::reaction_force].allFinite() && sph::longest_stable_step(scene) > 0;
    scene.remove_if(water, [](const auto& x) { return x[0] > 0.25; });
    sph::read_checkpoint(scene, "out-strict/checkpoint");
    return sane && !sph::describe(scene).empty() ? 0 : 1;
}
