// Half a metre of water on a soft plate: how far it hangs down, beside the same plate under the same weight without
// water. The scene is that of the couplings.
#include "cases.hpp"

#include "../couplings/plate.hpp"

namespace cost {
namespace {

template <class Kit>
accuracy::Outcome sag_of(const accuracy::Choices& choose) {
    const couplings::Outcome run =
        couplings::plate::run_with<Kit>({choose.number("spacing"), choose.number("support"), choose.number("cfl")});
    sph::require(run.failure.empty(), run.failure);
    return {std::abs(run.value - 1), run.pair_evaluations};
}

template <class... Kit>
Compositions<> sag_with() {
    return {{{"coupling", couplings::Extrapolated::name}}, {{{{"coupling", Kit::name}}, sag_of<Kit>}...}};
}
const Compositions<> compositions =
    sag_with<couplings::Extrapolated, couplings::Riemann, couplings::AlongNormals, couplings::ModifiedRepulsion,
             couplings::StiffRepulsion, couplings::ScaledRepulsion>();

} // namespace

Rows soft_plate(accuracy::Study study, bool quick) {
    study.axis("spacing", quick ? Words{"0.025", "0.02"} : Words{"0.025", "0.02", "0.0125"});
    compositions.add_to(study);
    study.axis("support", {"2.6", "2", "3"}).axis("cfl", {"0.4", "0.2", "0.8"});
    return study.one_at_a_time(compositions, {"spacing"});
}

} // namespace cost
