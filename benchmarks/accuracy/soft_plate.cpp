// Half a metre of water on a soft plate: how far it hangs down, beside the same plate under the same weight without
// water. The scene is that of the couplings.
#include "cases.hpp"

#include "../couplings/plate.hpp"

namespace cost {
namespace {

template <class Kit>
accuracy::Outcome sag_of(const accuracy::Choices& choose) {
    const couplings::Outcome run =
        couplings::plate::run_with<Kit>({choose.number("spacing"), choose.number("support")});
    sph::require(run.failure.empty(), run.failure);
    return {std::abs(run.value - 1), run.pair_evaluations};
}

/// The sag with the coupling of these that has the name on the axis.
template <class... Kit>
accuracy::Outcome sag_by_name(sph::TypeList<Kit...>, const accuracy::Choices& choose) {
    const std::string& name = choose["coupling"];
    accuracy::Outcome outcome{};
    if (!((name == Kit::name && (outcome = sag_of<Kit>(choose), true)) || ...))
        no_such_method("soft-plate", name);
    return outcome;
}
template <class... Kit>
Words names_of(sph::TypeList<Kit...>) {
    return {Kit::name...};
}

using Couplings = sph::TypeList<couplings::Extrapolated, couplings::Riemann, couplings::AlongNormals,
                                couplings::ModifiedRepulsion, couplings::StiffRepulsion, couplings::ScaledRepulsion>;

} // namespace

Rows soft_plate(accuracy::Study study, bool quick) {
    study.axis("spacing", quick ? Words{"0.025", "0.02"} : Words{"0.025", "0.02", "0.0125"});
    study.axis("coupling", names_of(Couplings{}));
    study.axis("support", {"2.6", "2", "3"});
    return study.one_at_a_time([](const accuracy::Choices& choose) { return sag_by_name(Couplings{}, choose); },
                               {"spacing"});
}

} // namespace cost
