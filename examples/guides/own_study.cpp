// What accuracy costs in a case of one's own: a wave of shear that viscosity damps, by spacing, kernel and support.
#include <imbibe/accuracy/study.hpp>
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
namespace accuracy = imbibe::accuracy;

template <class K>
struct Oil : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                        sph::MorrisViscosity<K>> {};

/// v_x = 0.1 m/s sin(2 pi y) decays as exp(-(2 pi)^2 nu t). The error is that of its height at the end.
template <class K>
accuracy::Outcome shear_wave(const accuracy::Choices& choose) {
    const double dx = choose.number("spacing"), nu = 0.05, end = 0.25, k = 2 * std::numbers::pi;
    sph::Solver<2, double, sph::SymplecticEuler, Oil<K>> scene(
        {.support_radius = choose.number("support") * dx, .periodic_length = {0.5, 1}, .threads = 1});
    const auto oil = scene.add(Oil<K>{{.density = 1, .sound_speed = 2, .viscosity = nu}},
                               sph::fill(sph::Box<2>({0, 0}, {0.5, 1}), dx), dx);
    auto view = scene[oil];
    const auto wave = [&] { return (k * view[sph::position].col(1)).array().sin(); };
    view[sph::velocity].col(0) = 0.1 * wave().matrix();
    scene.run_until(end);
    const double height = 2 * (view[sph::velocity].col(0).array() * wave()).mean();
    return {std::abs(height / (0.1 * std::exp(-k * k * nu * end)) - 1), accuracy::pair_evaluations(scene)};
}

int main() {
    accuracy::Study study;
    study.axis("spacing", {"0.05", "0.025"})
        .axis("kernel", {"Wendland C2", "cubic spline"})
        .axis("support", {"2.6", "2", "3.2"});
    const auto rows = study.run([](const accuracy::Choices& choose) {
        return choose["kernel"] == "cubic spline" ? shear_wave<sph::CubicSpline>(choose)
                                                  : shear_wave<sph::WendlandC2>(choose);
    });
    accuracy::write(rows, "shear_wave.csv"); // python3 tools/plot_accuracy.py shear_wave.csv -o shear_wave.png
    double least = 1;
    for (const auto& row : rows) {
        least = std::min(least, row.error);
        std::printf("%-5s m, %-12s of %-3s spacings: error %5.2f %% in %.3f s, %.2f million pairs%s\n",
                    row.choices["spacing"].c_str(), row.choices["kernel"].c_str(), row.choices["support"].c_str(),
                    100 * row.error, row.seconds, row.pair_evaluations / 1e6, row.on_front ? ", on the front" : "");
    }
    return least < 0.01 ? 0 : 1;
}
