// The parts of a run of the sponge that depend on neither composition nor number type.
#include "sponge_run.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/pore_report.hpp>
#include <imbibe/monitor/progress.hpp>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace imbibe::presets {
struct PaperSponge;
struct SoundSponge;
} // namespace imbibe::presets

namespace imbibe::example {

namespace {

/// How an option is spoken of.
struct OptionWords {
    const char* unit;
    bool of_the_scheme; ///< it may change within a run: it says how, not what is computed
};

OptionWords words_of(const std::string& option) {
    if (option == "--time-step")
        return {" s", true};
    if (option == "--cfl")
        return {"", true};
    if (option == "--search-interval")
        return {" steps", true};
    if (option == "--shear-modulus" || option == "--young-modulus" || option == "--stiffness")
        return {" Pa", false};
    if (option == "--support-ratio" || option == "--sponge-support-ratio")
        return {" spacings", false};
    return {option == "--artificial-stress" || option == "--strip" ? "" : " mm", false};
}

std::string shown(const std::string& option, double value) {
    if (option == "--strip")
        return value != 0 ? "given" : "not given";
    if (value == 0 && (option == "--time-step" || option == "--search-interval"))
        return "the composition's own";
    return text(value, words_of(option).unit);
}

/// How far the table of a run reaches, s: the first number of its last whole line; 0 where there is none.
double time_reached(const std::filesystem::path& table) {
    std::ifstream file(table);
    double time = 0;
    for (std::string line; std::getline(file, line) && !file.eof();)
        if (!line.empty() && (std::isdigit(static_cast<unsigned char>(line[0])) != 0))
            time = std::strtod(line.c_str(), nullptr);
    return time;
}

} // namespace

std::map<std::string, double> numbers_by_option(const presets::SpongeCase& n, bool paper) {
    std::map<std::string, double> all{{"--pore-radius", n.pore_radius * 1e3},
                                      {"--water-spacing", n.water_spacing * 1e3},
                                      {"--sponge-spacing", n.solid_spacing * 1e3},
                                      {"--strip", n.strip ? 1 : 0},
                                      {"--pool", n.pool * 1e3},
                                      {"--freeboard", n.freeboard * 1e3},
                                      {"--time-step", n.time_step},
                                      {"--search-interval", n.search_interval}};
    if (paper)
        all.insert({{"--support", n.support_radius * 1e3},
                    {"--shear-modulus", n.shear_modulus},
                    {"--artificial-stress", n.artificial_stress},
                    {"--stiffness", n.stiffness}});
    else
        all.insert({{"--support-ratio", n.support_ratio},
                    {"--sponge-support-ratio", n.solid_support_ratio},
                    {"--young-modulus", n.young_modulus},
                    {"--cfl", n.cfl}});
    return all;
}

std::string changed_since(const std::map<std::string, double>& notes, const presets::SpongeCase& numbers, bool paper) {
    std::string changes;
    for (const auto& [option, now] : numbers_by_option(numbers, paper)) {
        const auto noted = notes.find(option);
        // 14 mm typed and 14e-3 m of a default may differ in the last bit
        if (noted == notes.end() || std::abs(noted->second - now) <= 1e-12 * std::abs(now))
            continue;
        const std::string before = shown(option, noted->second), after = shown(option, now);
        require(words_of(option).of_the_scheme, "the run in the folder has ", option, ": ", before, ", this command ",
                after, "; a run goes on with the physics that it began with: give ", option,
                " as before, or begin anew ", "in another folder (--output)");
        changes += text("From here on ", option, ": ", after, "; until now: ", before, "\n");
    }
    return changes;
}

void refuse_to_lose_a_run(const SpongeOutput& output) {
    std::error_code unknown;
    const bool unfinished = std::filesystem::exists(output.folder / "checkpoint", unknown) &&
                            !std::filesystem::exists(finished_file(output), unknown);
    require(!unfinished || output.overwrite, "the folder ", output.folder.string(), " holds a run to ",
            unfinished ? time_reached(output.folder / "sponge.csv") : 0.0, " s that has not reached its end; ",
            output.ways_on.as_before,
            " from its last checkpoint, --overwrite begins anew, --output takes another folder");
}

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
        std::printf("  %s at t = %g s: %s\n", r.stopped ? "Stopped" : "BROKE OFF", r.end, r.failure.c_str());
    std::printf("  %lld steps to t = %g s in %s\n", r.steps, r.end, clock_text(r.wall_seconds).c_str());
    std::printf("  The sponge gave way by %.3f mm on average at t = %.3f s, its greatest;\n", r.peak * 1e3,
                r.peak_time);
    std::printf("  over the last 40 %% of the run it hung %.3f mm from where it was.\n", r.late_mean * 1e3);
    const bool long_enough = r.end >= 0.25; // by then much of it has left through wide pores
    std::printf("  %.1f %% of the water went through%s.\n", 100 * r.drained,
                r.drained >= 0.01 ? ""
                : long_enough     ? ": the pores are closed to it"
                                  : " so far");
    if (r.spilled > 0)
        std::printf("  %.1f %% jumped over the rim of the tank.\n", 100 * r.spilled);
    std::printf("  Water particles are %s.\n", r.conserved ? "all accounted for" : "MISSING");
    const std::string folder = output.folder.string();
    std::printf("  Curves: %s/sponge.csv\n", folder.c_str());
    if (r.snapshots > 0)
        std::printf("  For ParaView: %s/water.pvd, sponge.pvd, vessel.pvd\n", folder.c_str());
}

} // namespace imbibe::example
