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

accuracy::Outcome soft_plate_by(const accuracy::Choices& choose) {
    const std::string& method = choose["coupling"];
    if (method == couplings::Extrapolated::name)
        return sag_of<couplings::Extrapolated>(choose);
    if (method == couplings::Riemann::name)
        return sag_of<couplings::Riemann>(choose);
    if (method == couplings::AlongNormals::name)
        return sag_of<couplings::AlongNormals>(choose);
    if (method == couplings::ModifiedRepulsion::name)
        return sag_of<couplings::ModifiedRepulsion>(choose);
    if (method == couplings::StiffRepulsion::name)
        return sag_of<couplings::StiffRepulsion>(choose);
    if (method == couplings::ScaledRepulsion::name)
        return sag_of<couplings::ScaledRepulsion>(choose);
    no_such_method("soft-plate", method);
}

} // namespace

Rows soft_plate(accuracy::Study study, bool quick) {
    using namespace couplings;
    study.axis("spacing", quick ? Words{"0.025", "0.02"} : Words{"0.025", "0.02", "0.0125"});
    study.axis("coupling", {Extrapolated::name, Riemann::name, AlongNormals::name, ModifiedRepulsion::name,
                            StiffRepulsion::name, ScaledRepulsion::name});
    study.axis("support", {"2.6", "2", "3"});
    return study.one_at_a_time(soft_plate_by, {"spacing"});
}

} // namespace cost
