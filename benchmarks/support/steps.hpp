// Measures whole steps of a scene.
#pragma once

#include "measure.hpp"
#include "working.hpp"

#include <imbibe/core/fields.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace imbibe::bench {

/// Takes steps of the scene that `make(size, threads)` returns, both from the benchmark's arguments.
/// Counters: `particle`, the time per step and particle that the step has work for, and `moving`, per particle that is
/// not a wall's; `searched`, in what share of the steps neighbours are looked for; `bytes`, what a particle stores, and
/// `list_bytes`, its runs; `neighbours`, those of the first phase among its own.
template <class Scene, class Make>
void steps(benchmark::State& state, Make make) {
    const auto size = state.range(0), threads = state.range(1);
    auto& scene = kept<Scene>(std::pair{size, threads}, [&](const auto&) {
        auto made = make(static_cast<int>(size), static_cast<int>(threads));
        for (int k = 0; k < 3; ++k) // all memory is there, and the caches are warm
            made.step();
        return made;
    });
    double searches = 0;
    for (auto _ : state) {
        searches += scene.engine().search_is_due();
        scene.step();
    }
    const auto n = static_cast<double>(scene.particles());
    double moving = 0, at_work = 0;
    scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& phase) {
        at_work += working<P>(scene.engine(), phase.size());
        if constexpr (P::moves) {
            moving += phase.size();
            if (!(static_cast<double>(phase.view(velocity).cwiseAbs().maxCoeff()) < phase.material.sound_speed))
                state.SkipWithError("the scene has blown up: its time is not that of a run");
        }
    });
    per_item(state, "particle", at_work);
    per_item(state, "moving", moving);
    state.counters["particles"] = n;
    state.counters["working"] = at_work;
    state.counters["threads"] = static_cast<double>(threads);
    state.counters["searched"] = searches / static_cast<double>(state.iterations());
    state.counters["bytes"] = static_cast<double>(scene.engine().particle_bytes()) / n;
    state.counters["list_bytes"] = static_cast<double>(scene.engine().list_bytes()) / n;
    state.counters["neighbours"] = neighbours_in(scene.engine());
}

/// Registers the benchmark `name` for each size, on one thread (CPU time) and on two (real time).
/// @param at_once how many steps are measured at once, 0: as long as the options say. Where steps differ, because
///   neighbours serve several, the least of few at once would be that of steps without a search.
template <class Scene, class Make>
void add_steps(const std::string& name, Make make, const std::vector<std::int64_t>& sizes, int at_once = 0) {
    const auto run = [make](benchmark::State& state) { steps<Scene>(state, make); };
    const auto registered = [&](std::int64_t threads) {
        auto* const made = benchmark::RegisterBenchmark(name.c_str(), run)->ArgsProduct({sizes, {threads}});
        return at_once > 0 ? made->Iterations(at_once) : made;
    };
    registered(1);
#ifdef _OPENMP
    registered(2)->UseRealTime();
#endif
}

} // namespace imbibe::bench
