// Measures whole steps (Solver::step): a cube of water in free fall, a dam break in a tank, an elastic column that
// sways. Names: scene/real/particles of the moving phase/threads. For the counters see support/steps.hpp. Run it:
//
//   build-benchmark/benchmarks/bench_steps
//   build-benchmark/benchmarks/bench_steps --benchmark_filter='dam_break/float/100000'
#include "support/cloud.hpp"
#include "support/dam_break.hpp"
#include "support/fluid.hpp"
#include "support/steps.hpp"

#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace {

using namespace imbibe;
using K = WendlandC2;

/// The fluid that other codes are compared with, and nothing else. Its neighbours are found in every step, or in one of
/// `search_interval`.
template <class Real, int search_interval = 1>
struct Cube {
    using Scene = Solver<3, Real, SymplecticEuler, bench::Water>;
    static Scene make(int particles, int threads) {
        Scene scene({.gravity = {0, 0, -9.81},
                     .support_radius = 2.6 * bench::spacing,
                     .search_interval = search_interval,
                     .threads = threads});
        scene.add(bench::water<bench::Water>(), bench::cube(particles), bench::spacing);
        return scene;
    }
};

/// A total-Lagrangian column, five times as high as wide, held at its foot, that has been pushed. With all that keeps
/// it quiet and a support of 2 spacings, or its law alone and 2.3 spacings: some 50 neighbours.
struct Rubber : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, TotalLagrangianViscosity<K>, Clamped> {};
struct LawAlone
    : Solid<ReferenceCorrection<K>, DeformationGradient<K>, StVenantKirchhoff, TotalLagrangianForce<K>, Clamped> {};
template <class Real, class Rubber>
struct Column {
    using Scene = Solver<3, Real, SymplecticEuler, Rubber>;
    static Scene make(int particles, int threads) {
        const double dx = std::cbrt(0.2 * 0.2 * 1.0 / particles);
        const double support = (std::is_same_v<Rubber, LawAlone> ? 2.3 : 2) * dx;
        Scene scene({.gravity = {0, 0, -9.81}, .support_radius = support, .threads = threads});
        const Rubber rubber{{.density = 1000, .sound_speed = 40, .shear_modulus = 7e5}};
        const auto column = scene.add(rubber, fill(Box<3>({0, 0, 0}, {0.2, 0.2, 1.0}), dx), dx);
        for (int i = 0; i < scene[column].size(); ++i)
            scene[column][velocity](i, 0) = scene[column][position](i, 2);
        scene.hold(column, [&](const Point<3>& x) { return x[2] < 2 * dx; });
        return scene;
    }
};

template <class Real>
void add_all() {
    const std::vector<std::int64_t> sizes{10'000, 100'000, 1'000'000};
    const auto add = [&]<class Case>(const char* name, Case, int at_once = 0) {
        bench::add_steps<typename Case::Scene>(name + ("/" + std::string(bench::real_name<Real>)), Case::make, sizes,
                                               at_once);
    };
    add("cube", Cube<Real>{});
    add("cube_searched_in_1_of_4", Cube<Real, 4>{}, 12);
    if (std::is_same_v<Real, float>) // 2.6 GB
        bench::add_steps<typename Cube<Real>::Scene>("cube/float", Cube<Real>::make, {10'000'000});
    add("dam_break", bench::DamBreak<Real>{}, 12);
    add("dam_break_searched_in_every_step", bench::DamBreak<Real, 1>{});
    add("column", Column<Real, Rubber>{});
    add("column_of_law_alone", Column<Real, LawAlone>{});
}

} // namespace

int main(int argc, char** argv) {
    add_all<float>();
    add_all<double>();
    return bench::run_registered(argc, argv);
}
