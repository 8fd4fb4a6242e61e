// The parts of a run of the sponge that depend on neither composition nor number type.
#include "sponge_run.hpp"

#include "pictures.hpp"

#include <imbibe/geometry/pore_report.hpp>
#include <imbibe/monitor/progress.hpp>

#include <cstdio>

namespace imbibe::presets {
struct PaperSponge;
struct SoundSponge;
} // namespace imbibe::presets

namespace imbibe::example {

RunSettings sponge_run_settings() {
    RunSettings settings;
    settings.folder = "out-sponge";
    settings.table = "sponge.csv";
    settings.table_interval = 1e-3;
    settings.snapshot_interval = 10e-3;
    settings.products = {"snapshots.png", "displacement.png", "drained.png"};
    settings.words = {.restart = "--restart",
                      .overwrite = "--overwrite",
                      .folder = "--output",
                      .end = "--end",
                      .cfl = "--cfl",
                      .time_step = "--time-step"};
    return settings;
}

std::vector<RunNumber> numbers_by_option(const presets::SpongeCase& n, bool paper) {
    const auto own = [](double value) -> std::string { return value == 0 ? "the composition's own" : ""; };
    std::vector<RunNumber> all{
        {"--pore-radius", n.pore_radius * 1e3, "mm"},
        {"--water-spacing", n.water_spacing * 1e3, "mm"},
        {"--sponge-spacing", n.solid_spacing * 1e3, "mm"},
        {.name = "--strip",
         .value = n.strip ? 1.0 : 0.0,
         .in_words = [](double given) -> std::string { return given != 0 ? "given" : "not given"; }},
        {"--pool", n.pool * 1e3, "mm"},
        {"--freeboard", n.freeboard * 1e3, "mm"},
        {"--time-step", n.time_step, "s", true, own},
        {"--search-interval", static_cast<double>(n.search_interval), "steps", true, own}};
    const std::vector<RunNumber> of_the_paper{{"--support", n.support_radius * 1e3, "mm"},
                                              {"--shear-modulus", n.shear_modulus, "Pa"},
                                              {"--artificial-stress", n.artificial_stress},
                                              {"--stiffness", n.stiffness, "Pa"}};
    const std::vector<RunNumber> of_the_sound{{"--support-ratio", n.support_ratio, "spacings"},
                                              {"--sponge-support-ratio", n.solid_support_ratio, "spacings"},
                                              {"--young-modulus", n.young_modulus, "Pa"},
                                              {"--cfl", n.cfl, "", true}};
    const auto& others = paper ? of_the_paper : of_the_sound;
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

SpongeResult run_sponge(const std::string& composition, const std::string& precision,
                        const presets::SpongeCase& numbers, const RunSettings& settings) {
    const bool paper = composition == "paper", single = precision == "float";
    require(paper || composition == "sound", "composition = ", composition, "; it must be paper or sound");
    require(single || precision == "double", "precision = ", precision, "; it must be float or double");
    numbers.check();
    if (!settings.quiet)
        std::printf("Pores: %s\n",
                    pore_report(presets::paper_slab(numbers.slab()), numbers.water_spacing).sentence.c_str());
    if (paper)
        return single ? run_sponge<presets::PaperSponge, float>(numbers, settings)
                      : run_sponge<presets::PaperSponge, double>(numbers, settings);
    return single ? run_sponge<presets::SoundSponge, float>(numbers, settings)
                  : run_sponge<presets::SoundSponge, double>(numbers, settings);
}

void draw_pictures(const std::string& folder, const std::string& composition) {
    draw("render_sponge.py", {folder, "--count", "4", "-o", folder + "/snapshots.png"});
    draw("plot_curves.py", {folder + "/sponge.csv", "--y", "mean displacement", "--title",
                            "Mean displacement of the sponge, " + composition, "-o", folder + "/displacement.png"});
    draw("plot_curves.py", {folder + "/sponge.csv", "--y", "drained fraction", "--title",
                            "Water that has passed the sponge, " + composition, "-o", folder + "/drained.png"});
}

void print_summary(const presets::SpongeCase& numbers, const SpongeResult& r, const RunSettings& settings) {
    std::printf("\nSummary (%s composition, pore radius %g mm)\n", r.composition.c_str(), numbers.pore_radius * 1e3);
    if (!r.failure.empty())
        std::printf("  %s at t = %g s: %s\n", r.stopped ? "Stopped" : "BROKE OFF", r.time, r.failure.c_str());
    std::printf("  %lld steps to t = %g s in %s\n", r.steps, r.time, clock_text(r.wall_seconds).c_str());
    std::printf("  The sponge gave way by %.3f mm on average at t = %.3f s, its greatest;\n", r.peak * 1e3,
                r.peak_time);
    std::printf("  over the last 40 %% of the run it hung %.3f mm from where it was.\n", r.late_mean * 1e3);
    const bool long_enough = r.time >= 0.25; // by then much of it has left through wide pores
    std::printf("  %.1f %% of the water went through%s.\n", 100 * r.drained,
                r.drained >= 0.01 ? ""
                : long_enough     ? ": the pores are closed to it"
                                  : " so far");
    if (r.spilled > 0)
        std::printf("  %.1f %% jumped over the rim of the tank.\n", 100 * r.spilled);
    std::printf("  Water particles are %s.\n", r.conserved ? "all accounted for" : "MISSING");
    const std::string folder = settings.folder.string();
    std::printf("  Curves: %s/sponge.csv\n", folder.c_str());
    if (r.snapshots > 0)
        std::printf("  For ParaView: %s/water.pvd, sponge.pvd, vessel.pvd\n", folder.c_str());
}

} // namespace imbibe::example
