// A rigid body that floats: a wall whose particles the program moves, by the force of the water on them and by its own
// mechanics of rigid bodies. A box of half the density of water is let go too deep and tilted; it comes to rest upright
// and half under water (Archimedes).
//
//   build/guide_floating_box
//   python3 tools/render_plane.py out-floating-box --walls basin --times 0 200 500 3000 --dpi 75 -o floating_box.png
#include <imbibe/imbibe.hpp>

#include <Eigen/Geometry>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Basin : sph::Wall<> {};
struct Box : sph::Wall<> {};
struct Sides : sph::CouplingOf<Water, Basin> {};
struct Hull : sph::CouplingOf<Water, Box, sph::Into<Box, sph::ReactionForce<sph::VolumePressure<K>>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Basin, Box, Sides, Hull>;
using Vector = Eigen::Vector2d;

int main() {
    const double dx = 0.01, length = 1, depth = 0.3, g = 9.81, width = 0.2, height = 0.1, end = 4;
    const double mass = 500 * width * height, inertia = mass * (width * width + height * height) / 12; // kg/m, kg m
    Vector place(length / 2, depth - 0.02), velocity(0, 0); // of the box's middle
    double angle = 10 * std::numbers::pi / 180, spin = 0;

    Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx});
    Water material{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * g * depth)}};
    material.set(sph::MonaghanViscosityParameters{.alpha = 0.3}); // much, so that waves and box soon come to rest
    const sph::Box<2> pool({0, 0}, {length, depth}), box({-width / 2, -height / 2}, {width / 2, height / 2});
    const auto turned = sph::translated(sph::rotated(box, angle), place);
    const auto water = scene.add(material, sph::fill(pool - turned, dx), dx);
    scene.add(Basin{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {length, 0.5}), dx, 3, sph::Sides::y_high), dx);
    const std::vector<Vector> of_the_box = sph::fill(box, dx); // from its middle; number k of the particles is the k-th
    std::vector<Vector> there = of_the_box;
    for (Vector& x : there)
        x = place + Eigen::Rotation2Dd(angle) * x;
    const auto body = scene.add(Box{{.density = 1000}}, there, dx);
    const double area = scene[water].size() * dx * dx;
    sph::start_hydrostatic(scene, water, depth);

    const auto move = [&](Scene& s) { // is called before the first step and after every one
        const auto force = s[body][sph::reaction_force];
        auto x = s[body][sph::position], v = s[body][sph::velocity];
        const double step = s.steps() == 0 ? 0 : s.last_step().seconds;
        double torque = 0;
        for (int i = 0; i < s[body].size(); ++i)
            torque += (x(i, 0) - place[0]) * force(i, 1) - (x(i, 1) - place[1]) * force(i, 0);
        velocity += step * (Vector(force.colwise().sum()) / mass + Vector(0, -g));
        spin += step * torque / inertia;
        place += step * velocity;
        angle += step * spin;
        for (int i = 0; i < s[body].size(); ++i) { // sorted on the way, so found by their numbers
            const Vector from = Eigen::Rotation2Dd(angle) * of_the_box[s[body].ids()[static_cast<std::size_t>(i)]];
            x.row(i) = place + from;
            v.row(i) = velocity + spin * Vector(-from[1], from[0]);
        }
    };
    double sum = 0, steps = 0;
    const auto measure = [&](const Scene& s) {
        if (s.time() > end - 1) { // beside the box the water stands at (area + width draught)/length
            sum += (area - length * (place[1] - height / 2)) / (length - width);
            ++steps;
        }
    };
    scene.run_until(end, move, measure, sph::every(0.1, sph::Snapshots("out-floating-box")));

    std::printf("the box is %.1f mm under water, by Archimedes %.1f mm, and tilted by %.2f degrees\n",
                1e3 * sum / steps, 1e3 * height / 2, angle * 180 / std::numbers::pi);
    return std::abs(sum / steps / (height / 2) - 1) < 0.02 && std::abs(angle) < 0.01 ? 0 : 1;
}
