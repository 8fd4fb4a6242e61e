// A plate that is held at one end and swings: the mean period of five swings, beside finite elements. The scene is that
// of the reference cases.
#include "cases.hpp"

#include "../validation/oscillating_plate.hpp"

#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>

namespace cost {
namespace {

namespace plate_case = validation::oscillating_plate;
using validation::ElasticPlate;

struct NeoHookeanPlate : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::NeoHookean,
                                    sph::TotalLagrangianForce<>, sph::HourglassControl<>, sph::Clamped> {};
struct WithoutControl : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::StVenantKirchhoff,
                                   sph::TotalLagrangianForce<>, sph::Clamped> {};

struct ShearFromPairs : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::PairwiseShearForce<>,
                                   sph::TotalLagrangianViscosity<>, sph::Clamped> {};

/// @param least_support in spacings
template <class Plate>
accuracy::Outcome period_of(const accuracy::Choices& choose, double young_modulus, double least_support = 0) {
    const auto material = plate_case::rubber<Plate>(young_modulus);
    const auto seen = plate_case::swing(material, {.across = static_cast<int>(choose.number("across")),
                                                   .support_ratio = std::max(choose.number("support"), least_support),
                                                   .periods = 5});
    sph::require(seen.peaks.size() == 5, "the plate swung ", seen.peaks.size(), " times where 5 were expected");
    return {std::abs(seen.period() / 0.2552 - 1), seen.pair_evaluations};
}

template <class Plate>
accuracy::Outcome period(const accuracy::Choices& choose) {
    return period_of<Plate>(choose, plate_case::young_modulus);
}
accuracy::Outcome period_with_modulus_for_layers(const accuracy::Choices& choose) {
    const int across = static_cast<int>(choose.number("across"));
    return period_of<ElasticPlate>(choose, sph::bending_modulus(plate_case::young_modulus, across));
}
accuracy::Outcome period_with_shear_from_pairs(const accuracy::Choices& choose) {
    return period_of<ShearFromPairs>(choose, plate_case::young_modulus, 2); // its comment says why
}

const Methods<> methods("method", {{"St. Venant-Kirchhoff", period<ElasticPlate>},
                                   {"neo-Hookean", period<NeoHookeanPlate>},
                                   {"without hourglass control", period<WithoutControl>},
                                   {"modulus for its layers", period_with_modulus_for_layers},
                                   {"shear from pairs, with viscosity", period_with_shear_from_pairs}});

} // namespace

Rows plate(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"4", "6"} : Words{"4", "6", "10", "16"});
    study.axis("method", methods.names());
    study.axis("support", {"1.5", "2", "2.6"});
    return study.one_at_a_time(methods, {"across"});
}

} // namespace cost
