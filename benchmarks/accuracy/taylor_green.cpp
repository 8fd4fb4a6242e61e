// A square lattice of vortices (Taylor and Green 1937) that decays; L = U = 1, Re = 100. Started from a lattice that is
// jittered by a fifth of a spacing, twice, and from one that is not.
#include "cases.hpp"

#include <imbibe/imbibe.hpp>

#include <cmath>
#include <numbers>

namespace cost {
namespace {

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

/// How the vortices start.
struct Start {
    double jitter = 0.2; ///< of the lattice, spacings
    double raised = 0;   ///< the pressure, rho U^2; by a half it is zero where it is least, in a vortex' middle
};

/// The error of the velocity at t = 1, root mean square, as a share of the exact one's.
template <class Water, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices_from(const Start& at_first, const accuracy::Choices& choose, Water liquid = {}) {
    const double spacing = 1 / choose.number("across"), k = 2 * std::numbers::pi, nu = 0.01, end = 1;
    sph::Solver<2, Real, Integrator, Water> scene({.support_radius = choose.number("support") * spacing,
                                                   .cfl = choose.number("cfl"),
                                                   .periodic_length = {1, 1},
                                                   .threads = 1});
    const auto start =
        sph::jitter<2>(sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, spacing), at_first.jitter * spacing,
                       static_cast<unsigned>(choose.repetition + 1));
    liquid.density = 1;
    liquid.sound_speed = 10;
    liquid.viscosity = nu;
    const auto water = scene.add(liquid, start, spacing);
    const auto exact = [&](double x, double y, double time) {
        const double decay = std::exp(-2 * nu * k * k * time);
        return Eigen::RowVector2d(-std::cos(k * x) * std::sin(k * y) * decay,
                                  std::sin(k * x) * std::cos(k * y) * decay);
    };
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        const double x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity].row(i) = exact(x, y, 0).template cast<Real>();
        const double pressure = at_first.raised - 0.25 * (std::cos(2 * k * x) + std::cos(2 * k * y));
        view[sph::density](i) += static_cast<Real>(pressure / 100);
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

template <class Water, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices(const accuracy::Choices& choose) {
    return vortices_from<Water, Real, Integrator>({}, choose);
}

using C2 = sph::WendlandC2;
using Quintic = sph::QuinticSpline;
const Methods<> methods("method", {{"delta-SPH, shifted", vortices<Shifted<C2>>},
                                   {"without shifting", vortices<Plain<C2>>},
                                   {"Antuono's diffusion", vortices<Antuono<C2>>},
                                   {"Riemann", vortices<Riemann<C2>>},
                                   {"Wendland C4", vortices<Shifted<sph::WendlandC4>>},
                                   {"quintic spline", vortices<Shifted<Quintic>>},
                                   {"quintic spline, pressure raised",
                                    [](const accuracy::Choices& choose) {
                                        return vortices_from<Shifted<Quintic>>({.raised = 0.5}, choose);
                                    }},
                                   {"from a lattice",
                                    [](const accuracy::Choices& choose) {
                                        return vortices_from<Shifted<C2>>({.jitter = 0}, choose);
                                    }},
                                   {"from a lattice, all shifted, twice as strongly",
                                    [](const accuracy::Choices& choose) {
                                        Shifted<C2> liquid;
                                        liquid.set(sph::ParticleShiftingParameters{.strength = 4, .least_speed = 1});
                                        return vortices_from({.jitter = 0}, choose, liquid);
                                    }},
                                   {"float", vortices<Shifted<C2>, float>},
                                   {"position Verlet", vortices<Shifted<C2>, double, sph::PositionVerlet>},
                                   {"predictor-corrector", vortices<Shifted<C2>, double, sph::PredictorCorrector>}});

} // namespace

Rows taylor_green(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"25", "50"} : Words{"25", "50", "100"});
    study.axis("method", methods.names());
    study.axis("support", {"3", "2.6", "4"}).axis("cfl", {"0.4", "0.2", "0.8"}).repeat(2);
    return study.one_at_a_time(methods, {"across"});
}

} // namespace cost
