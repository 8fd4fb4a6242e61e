// A square lattice of vortices (Taylor and Green 1937) that decays; L = U = 1, Re = 100. Started from a lattice that is
// jittered by a fifth of a spacing, twice, and from one that is not.
#include "cases.hpp"

#include "../validation/taylor_green.hpp"

#include <imbibe/imbibe.hpp>

namespace cost {
namespace {

namespace square = validation::taylor_green;
using square::Antuono, square::Corrected, square::Plain, square::Riemann, square::Shifted;

/// The error of the velocity at t = 1, root mean square, as a share of the exact one's.
/// @param narrower the support as a share of the one that is chosen
template <class Liquid, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices_from(square::Run run, const accuracy::Choices& choose, const Liquid& liquid = {},
                                double narrower = 1) {
    run.across = choose.number("across");
    run.support = narrower * choose.number("support");
    run.cfl = choose.number("cfl");
    run.seed = static_cast<unsigned>(choose.repetition + 1);
    run.neighbours = false;
    const auto seen = square::decay<Liquid, Real, Integrator>(run, {1}, liquid);
    return {seen.at.front().error, seen.pair_evaluations};
}

template <class Liquid, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices(const accuracy::Choices& choose) {
    return vortices_from<Liquid, Real, Integrator>({}, choose);
}

using C2 = sph::WendlandC2;
using Quintic = sph::QuinticSpline;
using Dual = sph::DualStepping<sph::MorrisViscosity<C2>, sph::ParticleShifting<C2>>;
using DualCorrected =
    sph::DualStepping<sph::CurrentCorrection<C2>, sph::CorrectedViscosity<C2>, sph::ParticleShifting<C2>>;

/// With no pressure below zero voids do not open, and corrected gradients do with 2.6 spacings for 3.
template <class Integrator = sph::SymplecticEuler>
accuracy::Outcome corrected_at_its_best(const accuracy::Choices& choose) {
    return vortices_from<Corrected<C2>, double, Integrator>({.raised = 0.5}, choose, {}, 2.6 / 3);
}

const Methods<>
    methods("method",
            {{"delta-SPH, shifted", vortices<Shifted<C2>>},
             {"without shifting", vortices<Plain<C2>>},
             {"Antuono's diffusion", vortices<Antuono<C2>>},
             {"Riemann", vortices<Riemann<C2>>},
             {"Wendland C4", vortices<Shifted<sph::WendlandC4>>},
             {"quintic spline", vortices<Shifted<Quintic>>},
             {"quintic spline, pressure raised",
              [](const accuracy::Choices& choose) { return vortices_from<Shifted<Quintic>>({.raised = 0.5}, choose); }},
             {"corrected gradients", vortices<Corrected<C2>>},
             {"corrected gradients, pressure raised, 2.6 for 3 spacings", corrected_at_its_best<>},
             {"the same, dual stepping", corrected_at_its_best<DualCorrected>},
             {"from a lattice",
              [](const accuracy::Choices& choose) { return vortices_from<Shifted<C2>>({.jitter = 0}, choose); }},
             {"from a lattice, all shifted, twice as strongly",
              [](const accuracy::Choices& choose) {
                  Shifted<C2> liquid;
                  liquid.set(square::strong_shifting);
                  return vortices_from({.jitter = 0}, choose, liquid);
              }},
             {"float", vortices<Shifted<C2>, float>},
             {"dual stepping", vortices<Shifted<C2>, double, Dual>},
             {"position Verlet", vortices<Shifted<C2>, double, sph::PositionVerlet>},
             {"staggered leapfrog", vortices<Shifted<C2>, double, sph::StaggeredLeapfrog>},
             {"predictor-corrector", vortices<Shifted<C2>, double, sph::PredictorCorrector>}});

} // namespace

Rows taylor_green(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"25", "50"} : Words{"25", "50", "100"});
    study.axis("method", methods.names());
    study.axis("support", {"3", "2.6", "4"}).axis("cfl", {"0.4", "0.2", "0.8"}).repeat(2);
    return study.one_at_a_time(methods, {"across"});
}

} // namespace cost
