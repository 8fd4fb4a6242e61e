// The options that the programs with the sponge have in common.
#pragma once

#include "sponge_run.hpp"

#include <imbibe/core/error.hpp>

#include <CLI/CLI.hpp>

#include <cmath>

namespace imbibe::example {

/// The numbers that an option takes, in its own unit, and how that is said.
struct Range {
    double low, high;
    const char* unit; ///< with a space before it, or empty
    bool with_low = true, with_high = true;
    const char* why = "";

    /// Refuses others. What is no number is left to the option itself.
    CLI::Validator only() const {
        return CLI::Validator(
            [range = *this](const std::string& typed) -> std::string {
                double value = 0;
                if (!CLI::detail::lexical_cast(typed, value))
                    return {};
                const bool inside = (range.with_low ? value >= range.low : value > range.low) &&
                                    (range.with_high ? value <= range.high : value < range.high);
                return inside
                           ? std::string()
                           : imbibe::text(value, range.unit, "; it must be ", range.with_low ? "at least " : "above ",
                                          range.low, " and ", range.with_high ? "at most " : "below ", range.high,
                                          range.unit, range.why);
            },
            "");
    }
};

/// An option in millimetres for a length in metres.
inline void add_millimetres(CLI::App& app, const char* name, double& value, const Range& range, const char* text) {
    app.add_option_function<double>(
           name, [&value](double mm) { value = mm * 1e-3; }, text)
        ->check(range.only())
        ->default_str(imbibe::text(value * 1e3));
}

/// Which equations, and in which numbers.
inline void add_method_options(CLI::App& app, std::string& composition, std::string& precision) {
    app.add_option("--composition", composition, "paper: the paper's method, mended; sound: schemes that converge")
        ->check(CLI::IsMember({"paper", "sound"}))
        ->capture_default_str();
    app.add_option("--precision", precision, "float: 32 bits a number; double: 64")
        ->check(CLI::IsMember({"float", "double"}))
        ->capture_default_str();
}

/// Everything that is a number of the scene.
inline void add_case_options(CLI::App& app, presets::SpongeCase& numbers) {
    const Range length{0, 1000, " mm", false, false}, length_or_0{0, 1000, " mm", true, false};
    add_millimetres(app, "--pore-radius", numbers.pore_radius,
                    {0, 3.5, " mm", false, false, ", half the distance of the pores"}, "pore radius, mm");
    add_millimetres(app, "--support", numbers.support_radius, length,
                    "kernel support radius h of the paper's composition, mm");
    app.add_option("--support-ratio", numbers.support_ratio, "support of the water, sound composition, in spacings")
        ->capture_default_str();
    app.add_option("--sponge-support-ratio", numbers.solid_support_ratio,
                   "of the sponge, sound composition, in spacings")
        ->capture_default_str();
    add_millimetres(app, "--water-spacing", numbers.water_spacing, length,
                    "distance of the water particles, mm; a strip has 0.875 by default");
    add_millimetres(app, "--sponge-spacing", numbers.solid_spacing,
                    {0, 2, " mm", false, true, ", half the thickness of the slab"},
                    "distance of the sponge particles, mm; they lie on both faces, so the slab weighs and bends as one "
                    "of 4 mm and a spacing");
    app.add_option("--shear-modulus", numbers.shear_modulus, "of the sponge, paper's composition, Pa (printed: 2e-6)")
        ->capture_default_str();
    app.add_option("--young-modulus", numbers.young_modulus, "of the sponge, sound composition, Pa")
        ->capture_default_str();
    app.add_option("--artificial-stress", numbers.artificial_stress, "epsilon of Eq. (17), paper's composition")
        ->capture_default_str();
    app.add_option("--stiffness", numbers.stiffness, "K_f of Eq. (24), paper's composition, Pa")->capture_default_str();
    app.add_option("--time-step", numbers.time_step, "fixed time step, s; 0: adaptive (sound), 1e-5 s (paper)")
        ->check(Range{0, 1, " s"}.only())
        ->capture_default_str();
    app.add_option("--cfl", numbers.cfl, "share of the shortest limit that an adaptive step takes, sound composition")
        ->capture_default_str();
    app.add_option("--search-interval", numbers.search_interval,
                   "greatest number of steps between two searches for neighbours; 0: 4 (sound), 100 (paper)")
        ->check(Range{0, 10000, " steps"}.only())
        ->capture_default_str();
    app.add_flag("--strip", numbers.strip, "one row of pores, periodic across");
    add_millimetres(app, "--pool", numbers.pool, length_or_0,
                    "fill the tank with water to this height instead of the paper's block, mm");
    add_millimetres(app, "--freeboard", numbers.freeboard, length_or_0,
                    "how far the walls reach above the water, mm; 0: 5 above a pool, 120 above the block");
    app.add_option("--threads", numbers.threads, "threads; 0: all")
        ->check(Range{0, 1024, "", true, true, " (0: as many as the machine has)"}.only())
        ->capture_default_str();
}

/// How far a run goes, how often it writes, and whether it may write over another.
inline void add_output_options(CLI::App& app, RunSettings& run) {
    app.add_option("--end", run.end, "end time, s")->check(Range{0, 1000, " s", false, true}.only())->capture_default_str();
    app.add_option_function<double>(
           "--snapshots", [&run](double ms) { run.snapshot_interval = ms * 1e-3; },
           "time between snapshots, ms; 0: none")
        ->check(Range{0, 1e6, " ms"}.only())
        ->default_str(imbibe::text(run.snapshot_interval * 1e3));
    app.add_option_function<std::string>(
           "--output", [&run](const std::string& folder) { run.folder = folder; },
           "folder for everything that is written")
        ->default_str(run.folder.string());
    app.add_flag("--overwrite", run.overwrite,
                 "begin anew in a folder that holds a run which has not reached its end");
}

/// Chooses what the command line leaves open. Throws Error for options that contradict each other.
inline void finish_case(const CLI::App& app, presets::SpongeCase& numbers) {
    require(app.count("--cfl") == 0 || numbers.time_step == 0, "--time-step ", numbers.time_step,
            " s fixes the step, so that --cfl has no effect; give one of the two");
    if (!numbers.strip)
        return;
    if (app.count("--water-spacing") == 0)
        numbers.water_spacing = 0.875e-3; // eight to the period; 0.8 mm does not divide it
    const double across = numbers.width() / numbers.water_spacing;
    require(std::abs(across - std::round(across)) < 1e-3 * across, "--water-spacing: ", numbers.water_spacing * 1e3,
            " mm; on a strip, which is periodic, it must divide its width of ", numbers.width() * 1e3,
            " mm, as 0.7 and 0.875 mm do");
}

/// Throws Error for an option on the command line that the composition would not listen to.
inline void refuse_options_of_the_other(const CLI::App& app, const std::string& composition) {
    const bool paper = composition == "paper";
    for (const auto& [name, of_the_paper] : {std::pair{"--support", true},
                                             {"--shear-modulus", true},
                                             {"--artificial-stress", true},
                                             {"--stiffness", true},
                                             {"--support-ratio", false},
                                             {"--sponge-support-ratio", false},
                                             {"--accuracy", false},
                                             {"--young-modulus", false},
                                             {"--cfl", false}}) {
        const CLI::Option* option = app.get_option_no_throw(name);
        require(option == nullptr || option->count() == 0 || paper == of_the_paper, name,
                " has no effect in the composition ", composition, "; leave it out, or say --composition ",
                of_the_paper ? "paper" : "sound");
    }
}

} // namespace imbibe::example
