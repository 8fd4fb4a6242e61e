// A plate that is held at one end and swings: the mean period of five swings, beside finite elements. The scene is that
// of the reference cases.
#include "cases.hpp"

#include "../validation/oscillating_plate.hpp"

#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>

namespace cost {
namespace {

namespace plate_case = validation::oscillating_plate;
using validation::ElasticPlate;

struct NeoHookeanPlate : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::CompressibleNeoHookean,
                                    sph::TotalLagrangianForce<>, sph::HourglassControl<>, sph::Clamped> {};
struct WithoutControl : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::StVenantKirchhoff,
                                   sph::TotalLagrangianForce<>, sph::Clamped> {};

struct ShearFromPairs : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::PairwiseShearForce<>,
                                   sph::TotalLagrangianViscosity<>, sph::Clamped> {};

/// The error of the mean period, as a share of it.
template <class Plate, class Integrator = sph::SymplecticEuler>
accuracy::Outcome period(const accuracy::Choices& choose) {
    const int across = static_cast<int>(choose.number("across"));
    const double support = choose.number("support");
    sph::require(!std::is_same_v<Plate, ShearFromPairs> || support >= 2,
                 "PairwiseShearForce takes 2 spacings of support and more, not ", support);
    const double young = choose["modulus"] == "modulus for its layers"
                             ? sph::bending_modulus(plate_case::young_modulus, across)
                             : plate_case::young_modulus;
    const auto seen = plate_case::swing<Integrator>(
        plate_case::rubber<Plate>(young),
        {.across = across, .support_ratio = support, .periods = 5, .cfl = choose.number("cfl")});
    sph::require(seen.peaks.size() == 5, "the plate swung ", seen.peaks.size(), " times where 5 were expected");
    sph::require(seen.period() > 0.1, "the plate trembles: it passes where it rests every ", seen.period(),
                 " s, and a swing takes 0.2552 s; this integrator makes undamped waves grow");
    return {std::abs(seen.period() / 0.2552 - 1), seen.pair_evaluations};
}

const Compositions<>
    compositions({{"force", "St. Venant-Kirchhoff"},
                  {"hourglass control", "with hourglass control"},
                  {"integrator", "symplectic Euler"}},
                 {{{}, period<ElasticPlate>},
                  {{{"force", "neo-Hookean"}}, period<NeoHookeanPlate>},
                  {{{"force", "shear from pairs, with viscosity"}}, period<ShearFromPairs>},
                  {{{"hourglass control", "without hourglass control"}}, period<WithoutControl>},
                  {{{"integrator", "leapfrog"}}, period<ElasticPlate, sph::Leapfrog>},
                  {{{"integrator", "position Verlet"}}, period<ElasticPlate, sph::PositionVerlet>},
                  {{{"integrator", "staggered leapfrog"}}, period<ElasticPlate, sph::StaggeredLeapfrog>},
                  {{{"integrator", "predictor-corrector"}}, period<ElasticPlate, sph::PredictorCorrector>},
                  {{{"integrator", "midpoint Runge-Kutta"}}, period<ElasticPlate, sph::MidpointRungeKutta>}});

} // namespace

Rows plate(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"4", "6"} : Words{"4", "6", "10", "16"});
    compositions.add_to(study);
    study.axis("modulus", {"modulus of the material", "modulus for its layers"});
    study.axis("support", {"1.5", "2", "2.6"}).axis("cfl", {"0.4", "0.8"});
    study.also({{"force", "shear from pairs, with viscosity"}, {"support", "2"}}); // which it needs: PairwiseShearForce
    return study.one_at_a_time(compositions, {"across"});
}

} // namespace cost
