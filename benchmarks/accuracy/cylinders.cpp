// Creeping flow through a square array of cylinders that take a fifth of the cell: the drag, beside Sangani and Acrivos
// (1982). The scene is that of the reference cases.
#include "cases.hpp"

#include "../validation/cylinders.hpp"

namespace cost {
namespace {

accuracy::Outcome cylinders_by(const accuracy::Choices& choose) {
    constexpr double fraction = 0.2, known = 51.53;
    const int across = static_cast<int>(choose.number("across"));
    const double support = choose.number("support");
    const auto outcome = [](const validation::cylinders::Flow& flow) {
        return accuracy::Outcome{std::abs(flow.drag / known - 1), flow.pair_evaluations};
    };
    using validation::cylinders::flow;
    const std::string& method = choose["method"];
    if (method == "quintic spline")
        return outcome(flow<sph::QuinticSpline>(across, fraction, 0, support));
    if (method == "Wendland C2")
        return outcome(flow<sph::WendlandC2>(across, fraction, 0, support));
    if (method == "Wendland C4")
        return outcome(flow<sph::WendlandC4>(across, fraction, 0, support));
    if (method == "float")
        return outcome(flow<sph::QuinticSpline, float>(across, fraction, 0, support));
    no_such_method("cylinders", method);
}

} // namespace

Rows cylinders(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"12", "25"} : Words{"12", "25", "50"});
    study.axis("method", {"quintic spline", "Wendland C2", "Wendland C4", "float"});
    study.axis("support", {"3", "2.6", "3.5"});
    return study.one_at_a_time(cylinders_by, {"across"});
}

} // namespace cost
