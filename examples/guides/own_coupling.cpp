// A coupling of one's own: the drag between water and the matrix of a porous solid that occupy the same place (here the
// matrix flows as a fluid does: what holds it together is left out). What one loses the other gains, and they come to
// one velocity at the rate that Darcy's law asks for.
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct DarcyDragParameters {
    double resistance = 2e3; ///< viscosity over permeability, Pa s/m^2
};

/// dv_a/dt = resistance/m_a sum_b V_a V_b W_ab (v_b - v_a): the force of a pair changes sign with a and b.
struct DarcyDrag {
    using Parameters = DarcyDragParameters;
    using reads = sph::Fields<sph::mass, sph::density, sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    Parameters parameters{};

    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const auto volume_over_density = b[sph::mass] / (a[sph::density] * b[sph::density]);
        return (parameters.resistance * volume_over_density * ab.value(K{})) * (b[sph::velocity] - a[sph::velocity]);
    }
    static constexpr const char* limit_name = "drag";
    static double time_step_limit(const auto& first, const auto& second, const sph::TimeStepInput&,
                                  const Parameters& drag) {
        return 1 / (drag.resistance * (1 / first.density + 1 / second.density));
    }
};

struct Water : sph::Fluid<> {};
struct Matrix : sph::Fluid<> {};
struct Seepage : sph::Coupling<Water, Matrix, DarcyDrag> {}; // without Into<...>: acts on both
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Matrix, Seepage>;

int main() {
    const double dx = 0.1, dt = 1e-3, end = 0.3, resistance = 4e3;
    Scene scene({.support_radius = 2.6 * dx, .periodic_length = {1, 1}});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 1}}, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    const auto matrix =
        scene.add(Matrix{{.density = 2000, .sound_speed = 1}}, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    scene.coupling<Seepage>().set(DarcyDragParameters{.resistance = resistance});
    scene[water][sph::velocity].col(0).setConstant(1);
    const auto momentum = [&] {
        return scene[water][sph::mass].col(0).dot(scene[water][sph::velocity].col(0)) +
               scene[matrix][sph::mass].col(0).dot(scene[matrix][sph::velocity].col(0));
    };

    const double before = momentum();
    while (scene.time() < end - dt / 2)
        scene.step(dt);
    const double slip = scene[water][sph::velocity].col(0).mean() - scene[matrix][sph::velocity].col(0).mean();
    const double expected = std::exp(-resistance * (1.0 / 1000 + 1.0 / 2000) * end);
    std::printf("after %g s the slip is %.4f m/s, expected %.4f m/s; momentum %.12f, before %.12f N s/m\n", end, slip,
                expected, momentum(), before);
    return std::abs(slip / expected - 1) < 0.03 && std::abs(momentum() / before - 1) < 1e-12 ? 0 : 1;
}
