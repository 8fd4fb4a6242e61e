// The options that the programs with the sponge have in common.
#pragma once

#include "sponge_run.hpp"

#include <imbibe/core/error.hpp>

#include <CLI/CLI.hpp>

namespace imbibe::example {

/// An option in millimetres for a length in metres.
inline void add_millimetres(CLI::App& app, const char* name, double& value, const char* text) {
    app.add_option_function<double>(
           name, [&value](double mm) { value = mm * 1e-3; }, text)
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
    add_millimetres(app, "--pore-radius", numbers.pore_radius, "pore radius, mm");
    add_millimetres(app, "--support", numbers.support_radius, "kernel support radius h of the paper's composition, mm");
    app.add_option("--support-ratio", numbers.support_ratio, "support of the water, sound composition, in spacings")
        ->capture_default_str();
    app.add_option("--sponge-support-ratio", numbers.solid_support_ratio, "of the sponge, sound composition, in spacings")
        ->capture_default_str();
    add_millimetres(app, "--water-spacing", numbers.water_spacing, "distance of the water particles, mm");
    add_millimetres(app, "--sponge-spacing", numbers.solid_spacing, "distance of the sponge particles, mm");
    app.add_option("--shear-modulus", numbers.shear_modulus, "of the sponge, paper's composition, Pa (printed: 2e-6)")
        ->capture_default_str();
    app.add_option("--young-modulus", numbers.young_modulus, "of the sponge, sound composition, Pa")
        ->capture_default_str();
    app.add_option("--artificial-stress", numbers.artificial_stress, "epsilon of Eq. (17), paper's composition")
        ->capture_default_str();
    app.add_option("--stiffness", numbers.stiffness, "K_f of Eq. (24), paper's composition, Pa")->capture_default_str();
    app.add_option("--time-step", numbers.time_step, "fixed time step, s; 0: adaptive (sound), 1e-5 s (paper)")
        ->capture_default_str();
    app.add_option("--cfl", numbers.cfl, "share of the shortest limit that an adaptive step takes, sound composition")
        ->capture_default_str();
    app.add_option("--search-interval", numbers.search_interval,
                   "greatest number of steps between two searches for neighbours; 0: 4 (sound), 100 (paper)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_flag("--strip", numbers.strip, "one row of pores, periodic across");
    add_millimetres(app, "--pool", numbers.pool,
                    "fill the tank with water to this height instead of the paper's block, mm");
    add_millimetres(app, "--freeboard", numbers.freeboard,
                    "how far the walls reach above the water, mm; 0: 5 above a pool, 120 above the block");
    app.add_option("--threads", numbers.threads, "threads; 0: all")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
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
