// The sponge on one row of pores with all four pore radii of the paper, in both compositions, to the end of what the
// ordinary tests begin. Of the full slab's runs tools/sponge_bars.py asks the same.
//
// The bars were set from prototypes before these runs; where a number was chosen after one, it says so.
#include "sponge_strip.hpp"

#include <catch_shim.hpp>

namespace strip = validation::sponge_strip;
namespace presets = imbibe::presets;

namespace sponge_on_a_strip {

std::map<double, strip::Seen> run_all(auto composition, double end) {
    std::map<double, strip::Seen> runs; // by the radius of the pores, mm
    for (const double r : {0.5, 1.0, 1.5, 2.0})
        runs[r] = strip::run<decltype(composition)>(strip::strip(r * 1e-3), end);
    return runs;
}

} // namespace sponge_on_a_strip

TEST_CASE("The sound sponge on a strip, all pores, to 0.25 s", "[validation][sponge]") {
    const auto runs = sponge_on_a_strip::run_all(presets::SoundSponge{}, 0.25);
    for (const auto& [r, seen] : runs) {
        CAPTURE(r, seen.peak, seen.late_mean, seen.drained.back(), seen.lightest, seen.densest, seen.off_density,
                seen.off_later, seen.in_the_sponge, seen.in_pairs, seen.beyond_the_walls);
        CHECK(seen.lost == 0);
        CHECK(seen.in_the_sponge <= 1e-3);
        CHECK(seen.in_pairs <= 1e-3);
        CHECK(seen.beyond_the_walls < 0.1 * 0.7e-3); // of the half spacing that the walls' first particles lie back
        CHECK(seen.off_density <= 0.05);             // the impact: its pressure is that of sound
        CHECK(seen.off_later <= 0.02);               // single particles in splashes; chosen after a run
    }
    CHECK(runs.at(0.5).drained.back() < 0.01);
    CHECK(runs.at(2).drained.back() > 0.85);
    for (const double wide : {1.5, 2.0})
        for (const double narrow : {0.5, 1.0})
            CHECK(runs.at(wide).late_mean < runs.at(narrow).late_mean); // the paper's order
    const strip::Seen* narrower = nullptr;
    for (const auto& [r, seen] : runs) {
        CAPTURE(r);
        CHECK(seen.peak > 0.5e-3);
        CHECK(seen.peak == Approx(runs.at(0.5).peak).epsilon(0.05));
        // From 50 ms after the impact on, more has gone through the wider pores.
        for (std::size_t k = 0; narrower != nullptr && k < seen.times.size(); ++k)
            if (seen.times[k] > 0.077) {
                CAPTURE(seen.times[k]);
                CHECK(narrower->drained[k] < seen.drained[k]);
            }
        narrower = &seen;
    }
}

TEST_CASE("The paper's sponge on a strip, all pores, to 0.1 s", "[validation][sponge]") {
    const auto runs = sponge_on_a_strip::run_all(presets::PaperSponge{}, 0.1);
    for (const auto& [r, seen] : runs) {
        CAPTURE(r, seen.peak, seen.late_mean, seen.drained.back(), seen.lightest, seen.densest, seen.off_density,
                seen.in_the_sponge, seen.beyond_the_walls);
        CHECK(seen.lost == 0);
        CHECK(seen.in_the_sponge == 0);
        CHECK(seen.beyond_the_walls == 0);
        CHECK(seen.lightest > 900); // chosen after runs of the full slab, which stay within 5.4 %
        CHECK(seen.densest < 1100);
        CHECK(seen.peak < 1e-3); // whole: what tears goes through the clamps
    }
    CHECK(runs.at(0.5).drained.back() < 0.01);
    CHECK(runs.at(2).drained.back() > runs.at(1.5).drained.back());
    CHECK(runs.at(1.5).drained.back() > runs.at(1).drained.back());
}
