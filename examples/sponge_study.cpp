// The two studies of the paper: the sponge with four radii of its pores, and with four support radii of the kernel.
//
//   build/sponge_study pores                          r = 0.5, 1, 1.5, 2 mm
//   build/sponge_study support                        h = 1, 1.1, 1.2, 1.3 mm at r = 1.5 mm
//   build/sponge_study pores --composition paper      the same with the method of the paper, mended
//   build/sponge_study pores --strip --pool 14 --water-spacing 0.7 --end 0.25   one row of pores: a few minutes
//   build/sponge_study support --repeats 4            each case four times: what of the differences is chance
//
// Each run keeps its tables in a folder of its own. A run that is finished is not repeated, one that was interrupted,
// or that is wanted to a later --end, goes on from its last checkpoint, and the two studies share the case they have in
// common, if they have one (the paper's composition). An interrupted run is not replaced by one with other options, but
// with --overwrite.
#include "support/pictures.hpp"
#include "support/quiet_waiting.hpp"
#include "support/sponge_options.hpp"

#include <imbibe/output/run_folder.hpp>

#include <fstream>

namespace sph = imbibe;

namespace {

struct Case {
    std::string name, label;
    sph::presets::SpongeCase numbers;
};

/// The sound composition takes the paper's h for the smoothing length of its kernel, half the support, and counts in
/// spacings, of which the paper's are 0.8 mm: h = 1 mm is a support of 2.5 spacings, h = 1.3 mm one of 3.25.
double ratio_of(double h) {
    return std::round(100 * 2 * h / 0.8e-3) / 100;
}

/// Each of `repeats` runs of a case takes steps that are 2.5 % shorter than those of the one before. That is no other
/// scene, but as water breaks up into drops it becomes another of the ways in which the scene may go on.
void shorten_steps(sph::presets::SpongeCase& numbers, const std::string& composition, int repeat) {
    const double share = 1 - 0.025 * repeat;
    numbers.cfl *= share;
    if (composition == "paper" && numbers.time_step == 0 && repeat > 0)
        numbers.time_step = 1e-5;
    numbers.time_step *= share;
}

std::vector<Case> cases_of(const std::string& study, const std::string& composition, sph::presets::SpongeCase numbers,
                           int repeats) {
    std::vector<Case> cases;
    const auto add = [&](double pore_radius, double support, const std::string& label) {
        numbers.pore_radius = pore_radius;
        numbers.support_radius = support;
        if (study == "support")
            numbers.support_ratio = ratio_of(support);
        const double shown = composition == "paper" ? support * 1e3 : numbers.support_ratio;
        for (int k = 0; k < repeats; ++k) {
            sph::presets::SpongeCase repeated = numbers;
            shorten_steps(repeated, composition, k);
            const std::string which = k == 0 ? "" : sph::text("-repeat", k + 1);
            cases.push_back({sph::text(composition, "-r", pore_radius * 1e3, "-h", shown, which), label, repeated});
        }
    };
    if (study == "pores")
        for (const double r : {0.5e-3, 1e-3, 1.5e-3, 2e-3})
            add(r, 1e-3, sph::text("r = ", r * 1e3, " mm"));
    else
        for (const double h : {1e-3, 1.1e-3, 1.2e-3, 1.3e-3})
            add(1.5e-3, h,
                composition == "paper" ? sph::text("h = ", h * 1e3, " mm")
                                       : sph::text("H = ", ratio_of(h), " spacings"));
    return cases;
}

/// What makes one run another than the next; written beside its tables when it begins, and again, with the time it has
/// reached, when it is through.
std::string signature(const Case& c, const std::string& precision) {
    const auto& n = c.numbers;
    return sph::text(c.name, " ", precision, " spacings ", n.water_spacing, " ", n.solid_spacing, " pool ", n.pool,
                     " freeboard ", n.freeboard, " strip ", n.strip, " G ", n.shear_modulus, " E ", n.young_modulus,
                     " H of the sponge ", n.solid_support_ratio, " K_f ", n.stiffness, " epsilon ", n.artificial_stress,
                     " step ", n.time_step, " cfl ", n.cfl);
}

bool says(const std::filesystem::path& path, const std::string& what) {
    std::ifstream file(path);
    std::string line;
    return std::getline(file, line) && line == what;
}

} // namespace

int main(int argc, char** argv) {
    sph::example::sleep_while_waiting(argv);
    sph::presets::SpongeCase numbers;
    std::string study, composition = "sound", precision = "float";
    int repeats = 1;
    sph::RunSettings chosen = sph::example::sponge_run_settings();
    chosen.folder = "out-study";
    chosen.end = 0.5;
    chosen.snapshot_interval = 25e-3;
    chosen.words.goes_on = "the command that it was begun with goes on";
    chosen.words.in_shorter_steps = "--overwrite begins the study anew, for example";

    CLI::App app{"The sponge with four pore radii, or with four support radii."};
    app.add_option("study", study, "pores or support")->required()->check(CLI::IsMember({"pores", "support"}));
    sph::example::add_method_options(app, composition, precision);
    sph::example::add_case_options(app, numbers);
    app.remove_option(app.get_option("--pore-radius")); // these are what the studies vary
    app.remove_option(app.get_option("--support"));
    app.remove_option(app.get_option("--support-ratio"));
    sph::example::add_output_options(app, chosen);
    app.add_option("--repeats", repeats, "runs of each case, their steps 2.5 % shorter each time")
        ->check(sph::example::Range{1, 16, ""}.only())
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    const std::filesystem::path root = chosen.folder;
    int failures = 0;
    std::vector<std::string> tables, labels;
    try {
        sph::example::refuse_options_of_the_other(app, composition);
        sph::example::finish_case(app, numbers);
        for (const Case& c : cases_of(study, composition, numbers, repeats)) {
            sph::RunSettings run = chosen;
            run.folder = root / c.name;
            const std::string what = signature(c, precision), through = sph::text(what, " to ", run.end, " s");
            tables.push_back((run.folder / run.table).string());
            labels.push_back(c.label);
            if (says(sph::finished_file(run.folder), through)) {
                std::printf("%s: finished before\n", c.name.c_str());
                continue;
            }
            run.restart = !chosen.overwrite && says(run.folder / "running.txt", what) &&
                             std::filesystem::exists(run.folder / "checkpoint");
            std::printf("\n==== %s%s ====\n", c.name.c_str(), run.restart ? ", continued" : "");
            if (!run.restart) {
                sph::refuse_to_lose_a_run(run);
                run.overwrite = true; // that has been asked
                // before this run says that it is the one in the folder; half of it must not pass for all of another
                std::filesystem::remove(run.folder / "checkpoint");
                std::filesystem::remove(sph::finished_file(run.folder));
            }
            sph::require_writable(run.folder);
            std::ofstream(run.folder / "running.txt") << what << '\n';
            const auto result = sph::example::run_sponge(composition, precision, c.numbers, run);
            sph::example::print_summary(c.numbers, result, run);
            if (result.failure.empty())
                std::ofstream(sph::finished_file(run.folder)) << through << '\n';
            else
                ++failures;
            if (result.stopped)
                return 1;
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "sponge_study: %s\n", error.what());
        return 2;
    }

    const std::string stem = (root / (composition + "-" + study)).string();
    if (repeats > 1) {
        std::vector<std::string> words = tables;
        words.insert(words.end(), {"--repeats", sph::text(repeats), "-o", stem + "-repeats.png", "--labels"});
        for (std::size_t k = 0; k < labels.size(); k += static_cast<std::size_t>(repeats))
            words.push_back(labels[k]);
        sph::example::draw("sponge_repeats.py", words);
        return failures == 0 ? 0 : 1;
    }
    const auto plot = [&](const std::string& column, const std::string& title, const std::string& end_of_name) {
        std::vector<std::string> words = tables;
        words.insert(words.end(),
                     {"--y", column, "--title", title + ", " + composition, "-o", stem + end_of_name, "--labels"});
        words.insert(words.end(), labels.begin(), labels.end());
        sph::example::draw("plot_curves.py", words);
    };
    plot("mean displacement", "Mean displacement of the sponge", "-displacement.png");
    plot("drained fraction", "Water that has passed the sponge", "-drained.png");
    std::vector<std::string> words = {study, composition};
    words.insert(words.end(), tables.begin(), tables.end());
    words.insert(words.end(), {"-o", stem + "-claims.md"});
    sph::example::draw("sponge_claims.py", words);
    return failures == 0 ? 0 : 1;
}
