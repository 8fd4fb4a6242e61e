// A rigid body on a floor: a wall whose particles the program moves, and a floor that pushes it back. A box is let go
// tilted, falls, rocks from corner to corner and comes to rest flat on the floor, which bears its weight.
//
//   build/guide_box_on_a_floor
#include <imbibe/imbibe.hpp>

#include <Eigen/Geometry>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
struct Floor : sph::Wall<> {};
struct Box : sph::Wall<> {};
/// Two walls push each other where they are nearer than a spacing; what the box feels is summed for the program.
struct Contact
    : sph::Coupling<Floor, Box, sph::KernelRepulsion<>, sph::Into<Box, sph::ReactionForce<sph::KernelRepulsion<>>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Floor, Box, Contact>;
using Vector = Eigen::Vector2d;

int main() {
    const double dx = 0.01, g = 9.81, width = 0.2, height = 0.1, end = 1.5, friction = 0.5, loss = 0.6;
    const double mass = 500 * width * height, inertia = mass * (width * width + height * height) / 12; // kg/m, kg m
    Vector place(0, 0.15), velocity(0, 0); // of the box's middle
    double angle = 20 * std::numbers::pi / 180, spin = 0;

    // The limit of a repulsion follows from speeds, which these walls do not store: the program gives the step.
    Scene scene({.support_radius = 2 * dx, .time_step = 5e-5});
    scene.coupling<Contact>().set(sph::KernelRepulsionParameters{.stiffness = 2e6, .range = 1});
    scene.add(Floor{{.density = 500}}, sph::fill(sph::Box<2>({-0.3, -3 * dx}, {0.3, 0}), dx), dx);
    const std::vector<Vector> of_the_box =
        sph::fill(sph::Box<2>({-width / 2, -height / 2}, {width / 2, height / 2}), dx);
    const auto at = [&](const Vector& from) -> Vector { return place + Eigen::Rotation2Dd(angle) * from; };
    std::vector<Vector> there;
    for (const Vector& from : of_the_box)
        there.push_back(at(from));
    const auto body = scene.add(Box{{.density = 500}}, there, dx);

    double borne = 0, times = 0;
    const auto move = [&](Scene& s) { // is called before the first step and after every one
        const auto force = s[body][sph::reaction_force];
        auto x = s[body][sph::position];
        const double step = s.steps() == 0 ? 0 : s.last_step().seconds;
        Vector push(0, -mass * g);
        double torque = 0;
        for (int i = 0; i < s[body].size(); ++i) {
            Vector of_floor = force.row(i);
            const Vector arm(x(i, 0) - place[0], x(i, 1) - place[1]), v = velocity + spin * Vector(-arm[1], arm[0]);
            // The program's own law of contact: friction along the floor, and less of a push on the way back.
            of_floor[0] -= friction * of_floor[1] * std::tanh(v[0] / 0.01);
            of_floor[1] *= 1 - loss * std::tanh(v[1] / 0.1);
            push += of_floor;
            torque += arm[0] * of_floor[1] - arm[1] * of_floor[0];
        }
        velocity += step * push / mass;
        spin += step * torque / inertia;
        place += step * velocity;
        angle += step * spin;
        for (int i = 0; i < s[body].size(); ++i) // sorted on the way, so found by their numbers
            x.row(i) = at(of_the_box[s[body].ids()[static_cast<std::size_t>(i)]]);
        if (s.time() > end - 0.5) {
            borne += force.col(1).sum();
            ++times;
        }
    };
    scene.run_until(end, move, sph::every(0.25, [&](const Scene& s) {
                        std::printf("t %.2f s  middle %.4f m  angle %6.2f deg  floor bears %6.1f N/m\n", s.time(),
                                    place[1], angle * 180 / std::numbers::pi,
                                    s[body][sph::reaction_force].col(1).sum());
                    }));
    borne /= times;
    std::printf("at rest %.4f m above the floor (half its height is %.4f), at %.2f deg; it bears %.2f N/m of %.2f\n",
                place[1], height / 2, angle * 180 / std::numbers::pi, borne, mass * g);
    const bool flat = std::abs(place[1] - height / 2) < 0.2 * dx && std::abs(angle) < 0.01;
    return flat && std::abs(borne / (mass * g) - 1) < 0.01 ? 0 : 1;
}
