// The start of a flow between plates: gap 1 mm, nu = 1e-6 m^2/s, body force 1e-4 m/s^2.
#include "cases.hpp"

#include "../validation/plates.hpp"

#include <imbibe/imbibe.hpp>

#include <cmath>
#include <numbers>

namespace cost {
namespace {

using validation::plates::gap, validation::plates::nu;
using validation::plates::OnPlates, validation::plates::Plates;

/// The series solution of the velocity at height y and time t, m/s.
double plate_flow(double y, double t) {
    constexpr double force = validation::plates::poiseuille.force, pi = std::numbers::pi;
    double v = force / (2 * nu) * y * (gap - y);
    for (int n = 0; n < 40; ++n)
        v -= 4 * force * gap * gap / (nu * std::pow(pi * (2 * n + 1), 3)) * std::sin(pi * y / gap * (2 * n + 1)) *
             std::exp(-std::pow((2 * n + 1) * pi / gap, 2) * nu * t);
    return v;
}

/// The error of the velocity at t = 0.1125 s, root mean square, as a share of the exact one's.
template <class K, class Real = double, class Integrator = sph::SymplecticEuler, class Oil = validation::plates::Oil<K>>
accuracy::Outcome plates(const accuracy::Choices& choose) {
    constexpr double end = 0.1125;
    const double spacing = gap / choose.number("across"), length = 8 * spacing, H = choose.number("support") * spacing;
    sph::Solver<2, Real, Integrator, Oil, Plates, OnPlates<K, Oil>> scene(
        {.gravity = {validation::plates::poiseuille.force, 0},
         .support_radius = H,
         .cfl = choose.number("cfl"),
         .periodic_length = {length, 0},
         .threads = 1});
    const sph::Box<2> between{{0, 0}, {length, gap}};
    // From the second repetition on the particles begin off their lattice by up to a twentieth of a spacing.
    const auto oil = scene.add(Oil{{.density = 1000, .sound_speed = 1e-3, .viscosity = 1000 * nu}},
                               sph::jitter(sph::fill(between, spacing), choose.repetition > 0 ? 0.05 * spacing : 0,
                                           static_cast<std::uint64_t>(choose.repetition)),
                               spacing);
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

using C2 = sph::WendlandC2;
using C4 = sph::WendlandC4;
using Quintic = sph::QuinticSpline;
using validation::plates::CorrectedOil, validation::plates::Oil;
template <class K>
accuracy::Outcome corrected(const accuracy::Choices& choose) {
    return plates<K, double, sph::SymplecticEuler, CorrectedOil<K>>(choose);
}

const Compositions<>
    compositions({{"kernel", "Wendland C2"},
                  {"gradients", "plain gradients"},
                  {"viscosity", "Morris' viscosity"},
                  {"integrator", "symplectic Euler"},
                  {"precision", "double"}},
                 {{{}, plates<C2>},
                  {{{"kernel", "Wendland C4"}}, plates<C4>},
                  {{{"kernel", "quintic spline"}}, plates<Quintic>},
                  {{{"gradients", "corrected gradients"}}, corrected<C2>},
                  {{{"viscosity", "Cleary's viscosity"}},
                   plates<C2, double, sph::SymplecticEuler, Oil<C2, sph::ClearyViscosity<C2>>>},
                  {{{"integrator", "predictor-corrector"}}, plates<C2, double, sph::PredictorCorrector>},
                  {{{"precision", "float"}}, plates<C2, float>},
                  {{{"kernel", "quintic spline"}, {"gradients", "corrected gradients"}}, corrected<Quintic>},
                  {{{"kernel", "quintic spline"}, {"precision", "float"}}, plates<Quintic, float>}});

} // namespace

Rows poiseuille(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"10", "20"} : Words{"10", "20", "40", "80"});
    compositions.add_to(study);
    study.axis("support", {"2.6", "2", "3.5"}).axis("cfl", {"0.4", "0.2", "0.8"});
    return study.one_at_a_time(compositions, {"across"});
}

} // namespace cost
