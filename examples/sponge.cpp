// Water falls onto an elastic sponge, presses it down, and drains through its pores.
//
// The first case of "A Particle Based Solver for the Three Dimensional Fluid Flow through an Elastic Porous Medium" at
// its full size: 68,231 water particles, about 41,400 sponge particles, 0.5 s. Curves and pictures: out-sponge/.
//
//   build/sponge                                   the paper's case, in the composition that converges
//   build/sponge --composition paper               the same with the method of the paper, mended
//   build/sponge --pore-radius 2 --end 0.25        wider pores, shorter (lengths in mm)
//   build/sponge --accuracy draft                  coarser water (docs/accuracy.md); also: standard, reference
//   build/sponge --quick                           one row of pores, a true picture in about a minute
//   build/sponge --restart                         after Ctrl-C, a crash or a power cut: go on from the last checkpoint
//   build/sponge --overwrite                       or begin anew; without either, a run that is not finished is kept
#include "support/quiet_waiting.hpp"
#include "support/sponge_options.hpp"

#include <imbibe/presets/sponge_accuracy.hpp>

namespace sph = imbibe;

int main(int argc, char** argv) {
    sph::example::sleep_while_waiting(argv);
    sph::presets::SpongeCase numbers;
    sph::RunSettings run = sph::example::sponge_run_settings();
    run.end = 0.5;
    std::string composition = "sound", precision = "float", accuracy;
    bool quick = false;

    CLI::App app{"Water falls onto an elastic sponge and drains through its pores."};
    sph::example::add_method_options(app, composition, precision);
    sph::example::add_case_options(app, numbers);
    app.add_option("--accuracy", accuracy,
                   "draft, standard or reference, sound composition: how fine the water is (docs/accuracy.md)")
        ->check(CLI::IsMember({"draft", "standard", "reference"}))
        ->excludes("--water-spacing")
        ->excludes("--support-ratio");
    sph::example::add_output_options(app, run);
    app.add_option("--checkpoints", run.checkpoint_interval,
                   "wall time between checkpoints, s; 0: one at every search for neighbours")
        ->check(sph::example::Range{0, 1e6, " s"}.only())
        ->capture_default_str();
    app.add_flag("--restart", run.restart, "go on from the checkpoint in the output folder; other options as before")
        ->excludes("--overwrite");
    app.add_flag("--previous", run.previous,
                 "go on from the one before and give up the last, as where that is damaged")
        ->needs("--restart");
    app.add_flag("--quick", quick, "one row of wide pores under 14 mm of water, to 0.12 s");
    CLI11_PARSE(app, argc, argv);

    if (quick) {
        const auto unless_given = [&](const char* option, double& value, double quick_value) {
            value = app.count(option) > 0 ? value : quick_value;
        };
        numbers.strip = true;
        unless_given("--pool", numbers.pool, 14e-3);
        unless_given("--pore-radius", numbers.pore_radius, 2e-3);
        unless_given("--end", run.end, 0.12);
        unless_given("--snapshots", run.snapshot_interval, 4e-3);
    }
    try {
        sph::example::refuse_options_of_the_other(app, composition);
        sph::example::finish_case(app, numbers);
        if (app.count("--accuracy") > 0) {
            const auto& chosen = sph::presets::set_accuracy(numbers, accuracy);
            std::printf(
                "Accuracy: %s, water %.3g mm apart; the sponge's mean displacement differs by about %.0f %% from "
                "that of the finest run (on a strip, until 0.15 s: docs/accuracy.md)\n\n",
                accuracy.c_str(), 1e3 * numbers.water_spacing, 100 * chosen.difference);
        }
        const auto result = sph::example::run_sponge(composition, precision, numbers, run);
        sph::example::print_summary(numbers, result, run);
        return result.failure.empty() && result.conserved ? 0 : 1;
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "sponge: %s\n", error.what());
        return 2;
    }
}
