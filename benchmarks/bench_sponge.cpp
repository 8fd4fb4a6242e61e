// Measures whole steps of the sponge: the sound composition as a strip and in full, the paper's composition as a strip.
// The water stands 1 mm above the sponge, so that the two see each other from the first step on. Names: scene/real/1
// for the strip, 5 for the full scene (rows of pores)/threads. For the counters see support/steps.hpp. Run it:
//
//   build-benchmark/benchmarks/bench_sponge
#include "support/steps.hpp"

#include <imbibe/presets/sponge.hpp>

namespace {

using namespace imbibe;

template <class Preset, class Real>
auto make(int rows, int threads) {
    presets::SpongeCase c;
    c.strip = rows == 1;
    if (c.strip)
        c.water_spacing = 0.7e-3; // ten to its width
    c.gap = c.support_radius;     // nearer, and the repulsion K_f of the paper's would throw the water off
    c.threads = threads;
    return Preset::template make<Real>(c);
}

template <class Preset, class Real>
void add(const std::string& name, const std::vector<std::int64_t>& rows) {
    bench::add_steps<typename Preset::template Scene<Real>>(name + "/" + bench::real_name<Real>, make<Preset, Real>,
                                                            rows);
}

} // namespace

int main(int argc, char** argv) {
    add<presets::SoundSponge, float>("sound_sponge", {1, 5});
    add<presets::SoundSponge, double>("sound_sponge", {1, 5});
    add<presets::PaperSponge, float>("paper_sponge", {1});
    add<presets::PaperSponge, double>("paper_sponge", {1});
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
}
