// Creeping flow through a square array of cylinders that take a fifth of the cell: the drag, beside Sangani and Acrivos
// (1982). The scene is that of the reference cases.
#include "cases.hpp"

#include "../validation/cylinders.hpp"

namespace cost {
namespace {

template <class K, class Real = double>
accuracy::Outcome drag(const accuracy::Choices& choose) {
    constexpr double fraction = 0.2, known = 51.53;
    const int across = static_cast<int>(choose.number("across"));
    // From the second repetition on the liquid's particles begin off their lattice by up to a twentieth of a spacing.
    const auto flow = validation::cylinders::flow<K, Real>(across, fraction, 0,
                                                           {.support = choose.number("support"),
                                                            .cfl = choose.number("cfl"),
                                                            .jitter = choose.repetition > 0 ? 0.05 : 0,
                                                            .seed = static_cast<std::uint64_t>(choose.repetition)});
    return {std::abs(flow.drag / known - 1), flow.pair_evaluations};
}

const Compositions<> compositions({{"kernel", "quintic spline"}, {"precision", "double"}},
                                  {{{}, drag<sph::QuinticSpline>},
                                   {{{"kernel", "Wendland C2"}}, drag<sph::WendlandC2>},
                                   {{{"kernel", "Wendland C4"}}, drag<sph::WendlandC4>},
                                   {{{"precision", "float"}}, drag<sph::QuinticSpline, float>}});

} // namespace

Rows cylinders(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"12", "25"} : Words{"12", "25", "50"});
    compositions.add_to(study);
    study.axis("support", {"3", "2.6", "3.5"}).axis("cfl", {"0.4"});
    return study.one_at_a_time(compositions, {"across"});
}

} // namespace cost
