// The parts of a run of the sponge that depend on neither composition nor number type.
#include "sponge_run.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/pore_report.hpp>
#include <imbibe/monitor/progress.hpp>

#include <cstdio>

namespace imbibe::presets {
struct PaperSponge;
struct SoundSponge;
} // namespace imbibe::presets

namespace imbibe::example {

SpongeResult run_sponge(const std::string& composition, const std::string& precision,
                        const presets::SpongeCase& numbers, double end, const SpongeOutput& output) {
    const bool paper = composition == "paper", single = precision == "float";
    require(paper || composition == "sound", "composition = ", composition, "; it must be paper or sound");
    require(single || precision == "double", "precision = ", precision, "; it must be float or double");
    numbers.check();
    if (!output.quiet)
        std::printf("Pores: %s\n",
                    pore_report(presets::paper_slab(numbers.slab()), numbers.water_spacing).sentence.c_str());
    if (paper)
        return single ? run_sponge<presets::PaperSponge, float>(numbers, end, output)
                      : run_sponge<presets::PaperSponge, double>(numbers, end, output);
    return single ? run_sponge<presets::SoundSponge, float>(numbers, end, output)
                  : run_sponge<presets::SoundSponge, double>(numbers, end, output);
}

void print_summary(const presets::SpongeCase& numbers, const SpongeResult& r, const SpongeOutput& output) {
    std::printf("\nSummary (%s composition, pore radius %g mm)\n", r.composition.c_str(), numbers.pore_radius * 1e3);
    if (!r.failure.empty())
        std::printf("  BROKE OFF at t = %g s: %s\n", r.end, r.failure.c_str());
    std::printf("  %lld steps to t = %g s in %s\n", r.steps, r.end, clock_text(r.wall_seconds).c_str());
    std::printf("  The sponge gave way by %.3f mm on average at t = %.3f s, its greatest;\n", r.peak * 1e3,
                r.peak_time);
    std::printf("  over the last 40 %% of the run it hung %.3f mm from where it was.\n", r.late_mean * 1e3);
    const bool long_enough = r.end >= 0.25; // by then much of it has left through wide pores
    std::printf("  %.1f %% of the water went through%s.\n", 100 * r.drained,
                r.drained >= 0.01 ? "" : long_enough ? ": the pores are closed to it" : " so far");
    if (r.spilled > 0)
        std::printf("  %.1f %% jumped over the rim of the tank.\n", 100 * r.spilled);
    std::printf("  Water particles are %s.\n", r.conserved ? "all accounted for" : "MISSING");
    std::printf("  Curves: %s/sponge.csv, for ParaView: %s/water.pvd, sponge.pvd, vessel.pvd\n", output.folder.c_str(),
                output.folder.c_str());
}

} // namespace imbibe::example
