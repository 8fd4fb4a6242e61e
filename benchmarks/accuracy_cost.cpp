// What accuracy costs in time: cases with a reference, run over spacings, schemes, kernels, supports, time steps and
// number types. Writes a table; tools/plot_accuracy.py draws it.
//
//   build-benchmark/benchmarks/accuracy_cost taylor-green -o taylor-green.csv     vortices that decay, Re = 100
//   build-benchmark/benchmarks/accuracy_cost poiseuille -o poiseuille.csv         the start of a flow between plates
//   build-benchmark/benchmarks/accuracy_cost taylor-green --quick                 coarse spacings only
#include "validation/plates.hpp"

#include <imbibe/imbibe.hpp>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace sph = imbibe;
namespace accuracy = imbibe::accuracy;

namespace {

// ---- a square lattice of vortices (Taylor and Green 1937), decaying; L = U = 1, Re = 100 ----

template <class K>
struct Plain : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MorrisViscosity<K>> {};
template <class K>
struct Shifted : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>,
                            sph::VolumePressure<K>, sph::MorrisViscosity<K>, sph::ParticleShifting<K>> {};
template <class K>
struct Antuono
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::CurrentCorrection<K>, sph::AntuonoDiffusion<K>,
                 sph::VolumePressure<K>, sph::MorrisViscosity<K>, sph::ParticleShifting<K>> {};
template <class K>
struct Riemann : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>,
                            sph::ClearyViscosity<K>, sph::ParticleShifting<K>> {};

/// The error of the velocity at t = 1, root mean square, as a share of the exact one's.
template <class Water, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices(const accuracy::Choices& choose) {
    const double spacing = 1 / choose.number("across"), k = 2 * std::numbers::pi, nu = 0.01, end = 1;
    sph::Solver<2, Real, Integrator, Water> scene({.support_radius = choose.number("support") * spacing,
                                                   .cfl = choose.number("cfl"),
                                                   .periodic_length = {1, 1},
                                                   .threads = 1});
    const auto start = sph::jitter<2>(sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, spacing), 0.2 * spacing,
                                      static_cast<unsigned>(choose.repetition + 1));
    const auto water = scene.add(Water{{.density = 1, .sound_speed = 10, .viscosity = nu}}, start, spacing);
    const auto exact = [&](double x, double y, double time) {
        const double decay = std::exp(-2 * nu * k * k * time);
        return Eigen::RowVector2d(-std::cos(k * x) * std::sin(k * y) * decay,
                                  std::sin(k * x) * std::cos(k * y) * decay);
    };
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        const double x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity].row(i) = exact(x, y, 0).template cast<Real>();
        view[sph::density](i) -= static_cast<Real>(0.25 * (std::cos(2 * k * x) + std::cos(2 * k * y)) / 100);
    }
    scene.run_until(end);
    double error2 = 0, norm2 = 0;
    const auto now = scene[water];
    for (int i = 0; i < now.size(); ++i) {
        const auto v = exact(now[sph::position](i, 0), now[sph::position](i, 1), end);
        error2 += (now[sph::velocity].row(i).template cast<double>() - v).squaredNorm();
        norm2 += v.squaredNorm();
    }
    return {std::sqrt(error2 / norm2), accuracy::pair_evaluations(scene)};
}

accuracy::Outcome vortices_by(const accuracy::Choices& choose) {
    using C2 = sph::WendlandC2;
    const std::string& method = choose["method"];
    if (method == "delta-SPH, shifted")
        return vortices<Shifted<C2>>(choose);
    if (method == "without shifting")
        return vortices<Plain<C2>>(choose);
    if (method == "Antuono's diffusion")
        return vortices<Antuono<C2>>(choose);
    if (method == "Riemann")
        return vortices<Riemann<C2>>(choose);
    if (method == "Wendland C4")
        return vortices<Shifted<sph::WendlandC4>>(choose);
    if (method == "quintic spline")
        return vortices<Shifted<sph::QuinticSpline>>(choose);
    if (method == "float")
        return vortices<Shifted<C2>, float>(choose);
    if (method == "position Verlet")
        return vortices<Shifted<C2>, double, sph::PositionVerlet>(choose);
    if (method == "predictor-corrector")
        return vortices<Shifted<C2>, double, sph::PredictorCorrector>(choose);
    throw sph::Error("taylor-green: there is no method '" + method + "'");
}

// ---- the start of a flow between plates: gap 1 mm, nu = 1e-6 m^2/s, body force 1e-4 m/s^2 ----

using validation::plates::Oil, validation::plates::OnPlates, validation::plates::Plates;

/// The series solution of the velocity at height y and time t, m/s.
double plate_flow(double y, double t) {
    constexpr double gap = 1e-3, nu = 1e-6, force = 1e-4, pi = std::numbers::pi;
    double v = force / (2 * nu) * y * (gap - y);
    for (int n = 0; n < 40; ++n)
        v -= 4 * force * gap * gap / (nu * std::pow(pi * (2 * n + 1), 3)) * std::sin(pi * y / gap * (2 * n + 1)) *
             std::exp(-std::pow((2 * n + 1) * pi / gap, 2) * nu * t);
    return v;
}

/// The error of the velocity at t = 0.1125 s, root mean square, as a share of the exact one's.
template <class K, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome plates(const accuracy::Choices& choose) {
    constexpr double gap = 1e-3, end = 0.1125;
    const double spacing = gap / choose.number("across"), length = 8 * spacing, H = choose.number("support") * spacing;
    sph::Solver<2, Real, Integrator, Oil<K>, Plates, OnPlates<K>> scene({.gravity = {1e-4, 0},
                                                                         .support_radius = H,
                                                                         .cfl = choose.number("cfl"),
                                                                         .periodic_length = {length, 0},
                                                                         .threads = 1});
    const sph::Box<2> between{{0, 0}, {length, gap}};
    const auto oil = scene.add(Oil<K>{{.density = 1000, .sound_speed = 1e-3, .viscosity = 1e-3}},
                               sph::fill(between, spacing), spacing);
    scene.add(Plates{{.density = 1000}},
              sph::tank(between, spacing, static_cast<int>(std::ceil(H / spacing)), sph::Sides::x), spacing);
    scene.run_until(end);
    double error2 = 0, norm2 = 0;
    const auto now = scene[oil];
    for (int i = 0; i < now.size(); ++i) {
        const double exact = plate_flow(static_cast<double>(now[sph::position](i, 1)), end);
        error2 += sph::sq(static_cast<double>(now[sph::velocity](i, 0)) - exact);
        norm2 += sph::sq(exact);
    }
    return {std::sqrt(error2 / norm2), accuracy::pair_evaluations(scene)};
}

accuracy::Outcome plates_by(const accuracy::Choices& choose) {
    const std::string& method = choose["method"];
    if (method == "Wendland C2")
        return plates<sph::WendlandC2>(choose);
    if (method == "Wendland C4")
        return plates<sph::WendlandC4>(choose);
    if (method == "quintic spline")
        return plates<sph::QuinticSpline>(choose);
    if (method == "float")
        return plates<sph::WendlandC2, float>(choose);
    if (method == "predictor-corrector")
        return plates<sph::WendlandC2, double, sph::PredictorCorrector>(choose);
    throw sph::Error("poiseuille: there is no method '" + method + "'");
}

} // namespace

int main(int argc, char** argv) {
    std::string name, output = "accuracy.csv";
    bool quick = false;
    CLI::App app{
        "What accuracy costs in time: a case with a reference over spacings, schemes, supports and time steps."};
    app.add_option("case", name, "taylor-green or poiseuille")
        ->required()
        ->check(CLI::IsMember({"taylor-green", "poiseuille"}));
    app.add_option("-o,--output", output, "the table to write")->capture_default_str();
    app.add_flag("--quick", quick, "the coarsest two spacings only");
    CLI11_PARSE(app, argc, argv);

    accuracy::Study study;
    study.progress([](const accuracy::Choices& choices, std::size_t done, std::size_t of) {
        std::printf("%3zu of %zu:", done + 1, of);
        for (const auto& [axis, value] : choices.all())
            std::printf("  %s %s", axis.c_str(), value.c_str());
        std::printf("\n");
        std::fflush(stdout);
    });
    std::vector<accuracy::Row> rows;
    try {
        using Words = std::vector<std::string>;
        if (name == "taylor-green") {
            study.axis("across", quick ? Words{"25", "50"} : Words{"25", "50", "100"});
            study.axis("method", {"delta-SPH, shifted", "without shifting", "Antuono's diffusion", "Riemann",
                                  "Wendland C4", "quintic spline", "float", "position Verlet", "predictor-corrector"});
            study.axis("support", {"3", "2.6", "4"}).axis("cfl", {"0.4", "0.2", "0.8"}).repeat(2);
            rows = study.one_at_a_time(vortices_by, {"across"});
        } else {
            study.axis("across", quick ? Words{"10", "20"} : Words{"10", "20", "40", "80"});
            study.axis("method", {"Wendland C2", "Wendland C4", "quintic spline", "float", "predictor-corrector"});
            study.axis("support", {"2.6", "2", "3.5"}).axis("cfl", {"0.4", "0.2", "0.8"});
            rows = study.one_at_a_time(plates_by, {"across"});
        }
        accuracy::write(rows, output);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "accuracy_cost: %s\n", error.what());
        return 2;
    }
    for (const auto& row : rows)
        if (row.on_front) {
            std::printf("on the front: %8.2f s, error %.4f:", row.seconds, row.error);
            for (const auto& [axis, value] : row.choices.all())
                std::printf("  %s %s", axis.c_str(), value.c_str());
            std::printf("\n");
        }
    return 0;
}
