// A column of water collapses in a tank: the dam break that docs/peers.md describes for other codes, and the report of
// it. Measured: how far from the wall behind the water its front is after 0.2 and 0.3 s, m.
//
//   build-benchmark/benchmarks/peers_dam_break float             on one thread, with a spacing of 1/110 m
//   build-benchmark/benchmarks/peers_dam_break double 2 20       on two, with 20 mm
#include "../support/dam_break.hpp"
#include "report.hpp"

#include <functional>

using namespace imbibe;

int main(int argc, char** argv) {
    return peers::main_of(argc, argv, 1e3 / 110, 2, []<class Real>(int threads, double dx) {
        using Scene = typename bench::DamBreak<Real>::Scene;
        auto scene = bench::DamBreak<Real>::at_rest(dx, threads);
        const auto water = scene.template get<bench::DamBreakWater>();
        const auto front = [&] { return static_cast<double>(water[position].col(0).maxCoeff()) + dx / 2; };

        peers::Meter<Scene> meter;
        scene.run_until(0.2, std::ref(meter));
        const double early = front();
        scene.run_until(0.3, std::ref(meter));
        meter.print("dam_break", scene, Real{}, dx, {early, front()});
    });
}
