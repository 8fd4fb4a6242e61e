// A square lattice of vortices (Taylor and Green 1937) that decays; L = U = 1, Re = 100. Started from a lattice that is
// jittered by a fifth of a spacing, twice, or from one that is not.
#include "cases.hpp"

#include "../validation/taylor_green.hpp"

#include <imbibe/imbibe.hpp>

namespace cost {
namespace {

namespace square = validation::taylor_green;
using square::Antuono, square::Corrected, square::Plain, square::Riemann, square::Shifted;

template <class Liquid>
constexpr bool is_shifted = true;
template <class K>
constexpr bool is_shifted<Plain<K>> = false;

/// The error of the velocity at t = 1, root mean square, as a share of the exact one's.
template <class Liquid, class Real = double, class Integrator = sph::SymplecticEuler>
accuracy::Outcome vortices(const accuracy::Choices& choose) {
    square::Run run{.across = choose.number("across"),
                    .support = choose.number("support"),
                    .cfl = choose.number("cfl"),
                    .seed = static_cast<unsigned>(choose.repetition + 1),
                    .neighbours = false};
    if (choose["start"] == "from a lattice")
        run.jitter = 0;
    if (choose["pressure"] == "pressure raised")
        run.raised = 0.5; // none is below zero, so that voids do not open
    Liquid liquid;
    const bool strongly = choose["shifting"] == "strong shifting of all";
    if constexpr (is_shifted<Liquid>) {
        if (strongly)
            liquid.set(square::strong_shifting);
    } else {
        sph::require(!strongly, "this fluid is not shifted");
    }
    const auto seen = square::decay<Liquid, Real, Integrator>(run, {1}, liquid);
    return {seen.at.front().error, seen.pair_evaluations};
}

using C2 = sph::WendlandC2;
using C4 = sph::WendlandC4;
using Quintic = sph::QuinticSpline;
using Dual = sph::DualStepping<sph::MorrisViscosity<C2>, sph::ParticleShifting<C2>>;
using DualCorrected =
    sph::DualStepping<sph::CurrentCorrection<C2>, sph::CorrectedViscosity<C2>, sph::ParticleShifting<C2>>;

const Compositions<>
    compositions({{"scheme", "delta-SPH, shifted"},
                  {"kernel", "Wendland C2"},
                  {"integrator", "symplectic Euler"},
                  {"precision", "double"}},
                 {{{}, vortices<Shifted<C2>>},
                  {{{"scheme", "without shifting"}}, vortices<Plain<C2>>},
                  {{{"scheme", "Antuono's diffusion"}}, vortices<Antuono<C2>>},
                  {{{"scheme", "Riemann"}}, vortices<Riemann<C2>>},
                  {{{"scheme", "corrected gradients"}}, vortices<Corrected<C2>>},
                  {{{"kernel", "Wendland C4"}}, vortices<Shifted<C4>>},
                  {{{"kernel", "quintic spline"}}, vortices<Shifted<Quintic>>},
                  {{{"integrator", "dual stepping"}}, vortices<Shifted<C2>, double, Dual>},
                  {{{"integrator", "position Verlet"}}, vortices<Shifted<C2>, double, sph::PositionVerlet>},
                  {{{"integrator", "staggered leapfrog"}}, vortices<Shifted<C2>, double, sph::StaggeredLeapfrog>},
                  {{{"integrator", "predictor-corrector"}}, vortices<Shifted<C2>, double, sph::PredictorCorrector>},
                  {{{"precision", "float"}}, vortices<Shifted<C2>, float>},
                  {{{"scheme", "corrected gradients"}, {"integrator", "dual stepping"}},
                   vortices<Corrected<C2>, double, DualCorrected>}});

} // namespace

Rows taylor_green(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"25", "50"} : Words{"25", "50", "100"});
    compositions.add_to(study);
    study.axis("start", {"jittered", "from a lattice"}).axis("pressure", {"pressure not raised", "pressure raised"});
    study.axis("shifting", {"usual shifting", "strong shifting of all"});
    study.axis("support", {"3", "2.6", "4"}).axis("cfl", {"0.4", "0.2", "0.8"}).repeat(2);
    study.also({{"start", "from a lattice"}, {"shifting", "strong shifting of all"}});
    study.also({{"kernel", "quintic spline"}, {"pressure", "pressure raised"}});
    study.also({{"scheme", "corrected gradients"}, {"pressure", "pressure raised"}, {"support", "2.6"}});
    study.also({{"scheme", "corrected gradients"},
                {"integrator", "dual stepping"},
                {"pressure", "pressure raised"},
                {"support", "2.6"}});
    return study.one_at_a_time(compositions, {"across"});
}

} // namespace cost
