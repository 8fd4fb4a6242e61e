// Water falls onto an elastic sponge, presses it down, and drains through its pores.
//
// The first case of "A Particle Based Solver for the Three Dimensional Fluid Flow through an Elastic Porous Medium" at
// its full size: 68,231 water particles, about 41,400 sponge particles, 0.5 s.
//
//   build/sponge                                   the paper's case, in the composition that converges
//   build/sponge --composition paper               the same with the method of the paper, mended
//   build/sponge --pore-radius 2 --end 0.25        wider pores, shorter (lengths in mm)
//   build/sponge --quick                           one row of pores, a true picture in about a minute
#include "support/sponge_run.hpp"

#include <CLI/CLI.hpp>

namespace sph = imbibe;

int main(int argc, char** argv) {
    sph::presets::SpongeCase numbers;
    sph::example::SpongeOutput output;
    std::string composition = "sound", folder = output.folder.string();
    double end = 0.5, snapshots = 10;
    bool quick = false;

    CLI::App app{"Water falls onto an elastic sponge and drains through its pores."};
    const auto millimetres = [&](const char* name, double& value, const char* text) {
        app.add_option_function<double>(name, [&value](double mm) { value = mm * 1e-3; }, text)
            ->default_str(sph::text(value * 1e3));
    };
    app.add_option("--composition", composition, "paper: the paper's method, mended; sound: schemes that converge")
        ->check(CLI::IsMember({"paper", "sound"}))
        ->capture_default_str();
    millimetres("--pore-radius", numbers.pore_radius, "pore radius, mm");
    millimetres("--support", numbers.support_radius, "kernel support radius h of the paper's composition, mm");
    app.add_option("--support-ratio", numbers.support_ratio, "supports of the sound composition, in spacings")
        ->capture_default_str();
    millimetres("--water-spacing", numbers.water_spacing, "distance of the water particles, mm");
    millimetres("--sponge-spacing", numbers.solid_spacing, "distance of the sponge particles, mm");
    app.add_option("--shear-modulus", numbers.shear_modulus, "of the sponge, paper's composition, Pa (printed: 2e-6)")
        ->capture_default_str();
    app.add_option("--young-modulus", numbers.young_modulus, "of the sponge, sound composition, Pa")
        ->capture_default_str();
    app.add_option("--artificial-stress", numbers.artificial_stress, "epsilon of Eq. (17), paper's composition")
        ->capture_default_str();
    app.add_option("--stiffness", numbers.stiffness, "K_f of Eq. (24), paper's composition, Pa")->capture_default_str();
    app.add_option("--time-step", numbers.time_step, "fixed time step, s; 0: adaptive (sound), 1e-5 s (paper)")
        ->capture_default_str();
    app.add_flag("--strip", numbers.strip, "one row of pores, periodic across");
    millimetres("--pool", numbers.pool, "fill the tank with water to this height instead of the paper's block, mm");
    app.add_option("--end", end, "end time, s")->capture_default_str();
    app.add_option("--snapshots", snapshots, "time between snapshots, ms; 0: none")->capture_default_str();
    app.add_option("--output", folder, "folder for everything that is written")->capture_default_str();
    app.add_option("--threads", numbers.threads, "threads; 0: all")->check(CLI::NonNegativeNumber)->capture_default_str();
    app.add_flag("--quick", quick, "one row of wide pores under 14 mm of water, to 0.12 s");
    CLI11_PARSE(app, argc, argv);

    if (quick) {
        numbers.strip = true;
        numbers.pool = 14e-3;
        numbers.pore_radius = 2e-3;
        numbers.water_spacing = 0.875e-3; // eight to the period of 7 mm
        end = app.count("--end") > 0 ? end : 0.12;
        snapshots = app.count("--snapshots") > 0 ? snapshots : 4;
    }
    output.folder = folder;
    output.snapshot_interval = snapshots * 1e-3;
    try {
        const auto result = composition == "paper"
                                ? sph::example::run_sponge<sph::presets::PaperSponge, double>(numbers, end, output)
                                : sph::example::run_sponge<sph::presets::SoundSponge, double>(numbers, end, output);
        sph::example::print_summary(numbers, result, output);
        return result.failure.empty() && result.conserved ? 0 : 1;
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "sponge: %s\n", error.what());
        return 2;
    }
}
