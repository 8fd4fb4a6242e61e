// Measures the search for neighbours, on one thread: sorting by cell, carrying values into the new order, finding the
// runs, and all of it together; beside it nanoflann's k-d tree, which lists the neighbours one by one. Counter
// `particle` is the time per particle. Names: operation/real/order/particles/support in tenths of the spacing. Run it:
//
//   build-benchmark/benchmarks/bench_search
//   build-benchmark/benchmarks/bench_search --benchmark_filter='find_runs/float/sorted/100000'
#include "support/cloud.hpp"
#include "support/measure.hpp"

#include <nanoflann.hpp>

#include <string>
#include <tuple>

namespace {

using namespace imbibe;
using bench::Cloud;
using bench::Order;

template <class Real>
Cloud<Real>& cloud(const benchmark::State& state, Order order) {
    const std::tuple key{state.range(0), state.range(1), order};
    return bench::kept<Cloud<Real>>(key, [&](const auto&) {
        return Cloud<Real>(static_cast<int>(state.range(0)), static_cast<double>(state.range(1)) * 0.1 * bench::spacing,
                           order);
    });
}

/// Bounds, grid and counting sort. For points that are sorted already this is what it costs to find that out.
template <class Real>
void sort(benchmark::State& state, Order order) {
    auto& points = cloud<Real>(state, order);
    for (auto _ : state)
        benchmark::DoNotOptimize(points.find_order());
    bench::per_item(state, "particle", points.count);
}

/// Brings one number of every particle into the order by cell: the solver does it for each that is stored.
template <class Real>
void reorder(benchmark::State& state, Order order) {
    auto& points = cloud<Real>(state, order);
    points.find_order();
    std::vector<Real> to = points.x[0];
    for (auto _ : state) {
        points.reorder(points.x[0], to);
        benchmark::ClobberMemory();
    }
    bench::per_item(state, "particle", points.count);
}

/// The runs of every particle, the points being in the order of the cells; for `shuffled`, those asked for are not.
template <class Real>
void find_runs(benchmark::State& state, Order order) {
    auto sources = cloud<Real>(state, order);
    const auto asked = sources;
    sources.sort();
    search::RunList runs;
    const auto find = [&] {
        search::find_runs<native_width<Real>>(runs, asked.points(), sources.points(), sources.grid, sources.table,
                                              sources.support, 1);
    };
    find(); // a list keeps its memory from step to step
    for (auto _ : state)
        find();
    bench::per_item(state, "particle", sources.count);
    state.counters["runs"] = bench::runs_per_particle(runs);
    state.counters["width"] = native_width<Real>;
}

/// Everything a step of a fluid needs: order, three coordinates brought into it, runs.
template <class Real>
void neighbours(benchmark::State& state, Order order) {
    const auto& start = cloud<Real>(state, order);
    auto now = start;
    search::RunList runs;
    const auto find = [&] {
        if (!now.find_order())
            for (std::size_t d = 0; d < 3; ++d)
                now.reorder(start.x[d], now.x[d]);
        search::find_runs<native_width<Real>>(runs, now.points(), now.points(), now.grid, now.table, now.support, 1);
    };
    find(); // what is allocated is kept from step to step
    now.x = start.x;
    for (auto _ : state) {
        find();
        state.PauseTiming();
        now.x = start.x;
        state.ResumeTiming();
    }
    bench::per_item(state, "particle", now.count);
}

template <class Real>
struct Adaptor {
    const Cloud<Real>& points;
    std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.count); }
    Real kdtree_get_pt(std::size_t i, std::size_t d) const { return points.x[d][i]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
template <class Real>
void nanoflann_lists(benchmark::State& state, Order order) {
    const Adaptor<Real> adaptor{cloud<Real>(state, order)};
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<Real, Adaptor<Real>>, Adaptor<Real>,
                                                     3, std::uint32_t>;
    const auto n = adaptor.kdtree_get_point_count();
    const Real support2 = static_cast<Real>(adaptor.points.support * adaptor.points.support);
    std::vector<std::vector<std::pair<std::uint32_t, Real>>> lists(n);
    std::size_t found = 0;
    for (auto _ : state) {
        const Tree tree(3, adaptor);
        found = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Real at[] = {adaptor.points.x[0][i], adaptor.points.x[1][i], adaptor.points.x[2][i]};
            found += tree.radiusSearch(at, support2, lists[i], nanoflann::SearchParams(32, 0, false));
        }
    }
    bench::per_item(state, "particle", static_cast<double>(n));
    state.counters["neighbours"] = static_cast<double>(found) / static_cast<double>(n) - 1;
}

using Function = void (*)(benchmark::State&, Order);
void add(const std::string& operation, const char* real, Function f, Order order,
         const std::vector<std::int64_t>& particles, const std::vector<std::int64_t>& supports) {
    const std::string name = operation + "/" + real + "/" + bench::order_name(order);
    benchmark::RegisterBenchmark(name.c_str(), f, order)->ArgsProduct({particles, supports});
}
template <class Real>
void add_all() {
    const std::vector<std::int64_t> sizes{10'000, 100'000, 1'000'000}, usual{100'000}, supports{20, 26, 35},
        support{26};
    const char* const real = bench::real_name<Real>;
    for (const Order order : {Order::sorted, Order::moved, Order::shuffled}) {
        add("sort", real, sort<Real>, order, sizes, support);
        add("neighbours", real, neighbours<Real>, order, sizes, support);
    }
    add("reorder", real, reorder<Real>, Order::moved, sizes, support);
    add("reorder", real, reorder<Real>, Order::shuffled, sizes, support);
    add("find_runs", real, find_runs<Real>, Order::sorted, sizes, supports);
    add("find_runs", real, find_runs<Real>, Order::shuffled, usual, support);
    add("nanoflann", real, nanoflann_lists<Real>, Order::sorted, usual, support);
    add("nanoflann", real, nanoflann_lists<Real>, Order::shuffled, usual, support);
}

} // namespace

int main(int argc, char** argv) {
    add_all<float>();
    add_all<double>();
    return bench::run_registered(argc, argv);
}
