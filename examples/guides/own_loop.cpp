// A host program that owns the time loop and a force of its own, and works on the particles where they are: the views
// of a scene are Eigen maps of its memory. Here a trap pulls a drop of water to and fro.
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

// The host: knows nothing of particles, only of columns of numbers.
void pull(Eigen::Ref<Eigen::MatrixXd> velocities, const Eigen::Ref<const Eigen::MatrixXd>& places, double frequency,
          double dt) {
    velocities -= dt * frequency * frequency * places;
}

int main() {
    const double dx = 0.05, period = 1, frequency = 2 * std::numbers::pi / period;
    Scene scene({.support_radius = 2.6 * dx});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 20}}, sph::fill(sph::Sphere<2>{{0.5, 0}, 0.3}, dx), dx);
    scene.prepare(); // sorts the particles and finds their neighbours
    const double* const memory = scene[water][sph::velocity].data();
    const Eigen::RowVector2d start = scene[water][sph::position].colwise().mean();

    double leftmost = start[0];
    while (scene.time() < period) {
        const double dt = std::min(scene.next_step().seconds, period - scene.time() + 1e-12);
        auto view = scene[water]; // of now: a step may sort the particles anew
        pull(view[sph::velocity], view[sph::position], frequency, dt);
        scene.step(dt);
        leftmost = std::min(leftmost, scene[water][sph::position].col(0).mean());
    }

    // Inner forces cancel: the centre is a pendulum, whatever the water does.
    const Eigen::RowVector2d end = scene[water][sph::position].colwise().mean();
    auto velocities = scene[water][sph::velocity];
    velocities(0, 0) = 42;
    const bool no_copy = scene[water][sph::velocity](0, 0) == 42 &&
                         scene.engine().state<Water>().field(sph::velocity) == velocities.data();
    std::printf("%lld steps; the centre went from %.4f m to %.4f m and back to %.4f m; velocities at %s as at first\n",
                scene.steps(), start[0], leftmost, end[0], memory == velocities.data() ? "the same place" : "another");
    return no_copy && (end - start).norm() < 0.01 * start[0] && std::abs(leftmost + start[0]) < 0.01 * start[0] ? 0 : 1;
}
