// Five couplings of water and solid on three scenes: what each gives for four support radii and four spacings, how long
// its steps are, what it costs, how near it lets the water come. Prints tables and writes the curves.
//
//   build-benchmark/studies/couplings scaling            what K_f holds in the paper's scene, at once
//   build-benchmark/studies/couplings plate              half a metre of water on a soft plate, minutes
//   build-benchmark/studies/couplings gate               water pushes a rubber gate open
//   build-benchmark/studies/couplings sponge             one row of pores of the paper's sponge, an hour
//   build-benchmark/studies/couplings sponge --only "extrapolated pressure" --vary support
//   build-benchmark/studies/couplings plate --vary step  how long steps can be: bisected, for each coupling
#include <cases/couplings/gate.hpp>
#include <cases/couplings/plate.hpp>
#include <cases/couplings/sponge.hpp>
#include <cases/support/largest_stable.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <functional>

namespace {

using namespace couplings;

struct Named {
    std::string name;
    std::function<Outcome(const Numerics&)> run;
};

/// A scene with every coupling, and the numerics over which it is run: of spacing and support ratio one varies, and the
/// other stays as usual.
struct SceneToRun {
    std::vector<Named> contacts;
    Numerics usual;
    std::vector<double> spacings, ratios;
    double end;
    const char* value;
};

/// Every coupling, each run by `run(type, numerics)`.
template <class... Kit, class Run>
std::vector<Named> each(sph::TypeList<Kit...>, const Run& run) {
    return {{Kit::name, [run](const Numerics& n) { return run(std::type_identity<Kit>{}, n); }}...};
}
using All = sph::TypeList<Extrapolated, Riemann, AlongNormals, ModifiedRepulsion, StiffRepulsion, ScaledRepulsion>;

SceneToRun scene_by(const std::string& name) {
    if (name == "plate")
        return {
            each(All{}, []<class Kit>(std::type_identity<Kit>, const Numerics& n) { return plate::run_with<Kit>(n); }),
            {0.02, 2.6, 0.4},
            {0.02, 0.025, 0.0125, 0.01},
            {2.6, 2, 2.3, 3},
            plate::end,
            "sag over that of the dry plate"};
    if (name == "gate")
        return {
            each(All{}, []<class Kit>(std::type_identity<Kit>, const Numerics& n) { return gate::run_with<Kit>(n); }),
            {1e-3, 2.6, 0.4},
            {1e-3, 5e-3 / 3, 1.25e-3, 5e-3 / 6},
            {2.6, 2, 2.3, 3},
            gate::end,
            "greatest way aside [mm]"};
    return {each(All{}, []<class Kit>(std::type_identity<Kit>, const Numerics& n) { return sponge::run_with<Kit>(n); }),
            {0.7e-3, 2.6, sph::presets::SpongeCase{}.cfl},
            {0.7e-3, 1e-3, 0.875e-3, 0.5e-3},
            {2.5, 2.75, 3, 3.25}, // twice the 1, 1.1, 1.2, 1.3 mm of the paper over its 0.8 mm
            sponge::end,
            "greatest mean displacement [mm]"};
}

/// What K_f holds in the paper's scene, for its four support radii: the K_f that leaves no gap, and how far apart the
/// first layers rest with the paper's K_f and with a hundredth of it.
void print_scaling() {
    const double weight = 560; // of the paper's water, Pa
    std::printf("| h [mm] | K_f/p without a gap | distance over h, K_f = 1e8 Pa | K_f = 1e6 Pa |\n|---|---|---|---|\n");
    for (const double h : {1e-3, 1.1e-3, 1.2e-3, 1.3e-3}) {
        const Layers layers{h, 0.8e-3, 0.5e-3, 3};
        std::printf("| %.1f | %.2f | %.3f | %.3f |\n", h * 1e3,
                    1 / pressure_over_stiffness(0.5 * (layers.water + layers.solid), layers),
                    distance_of_repulsion(weight / 1e8, layers) / h, distance_of_repulsion(weight / 1e6, layers) / h);
    }
    const Layers plate{0.052, 0.02, 0.01, 2}; // H = 2.6 spacings
    std::printf("\nOn the soft plate, with K_f = 1e5 p: %.2f mean spacings\n",
                distance_of_repulsion(1e-5, plate) / (0.5 * (plate.water + plate.solid)));
}

/// How far curves are apart at most in the first `samples` of their values, as a share of the greatest of these.
double spread_of(const std::vector<Outcome>& outcomes, std::size_t samples) {
    double most = 0, apart = 0;
    for (std::size_t k = 0; k < samples; ++k) {
        double low = 1e300, high = -1e300;
        for (const Outcome& o : outcomes) {
            if (k >= o.curve.size())
                return std::numeric_limits<double>::quiet_NaN(); // one broke off
            low = std::min(low, o.curve[k]);
            high = std::max(high, o.curve[k]);
        }
        most = std::max(most, high);
        apart = std::max(apart, high - low);
    }
    return apart / most;
}

void write_curves(const std::filesystem::path& path, const std::vector<std::string>& names,
                  const std::vector<Outcome>& outcomes, double end) {
    std::vector<sph::Column> columns{{"time", "s"}};
    for (const auto& name : names)
        columns.push_back({name, "mm"});
    std::filesystem::remove(path); // or a table over time would be continued
    sph::Table table(path, columns);
    for (std::size_t k = 0; k < outcomes.front().curve.size(); ++k) {
        std::vector<double> row{end * double(k + 1) / double(outcomes.front().curve.size())};
        for (const Outcome& o : outcomes)
            row.push_back(k < o.curve.size() ? o.curve[k] : std::numeric_limits<double>::quiet_NaN());
        table.row(row);
    }
}

/// Bisects the greatest CFL number with which each coupling carries the scene to its end, its value within 5 % of that
/// with the usual one, and prints a table.
void print_edges(const std::string& name, const SceneToRun& scene, const std::string& only) {
    constexpr double allowed = 0.05, lowest = 0.1, highest = 2; // 2: more the settings do not take
    std::printf("\n%s, how long steps can be\n\n| coupling | greatest CFL number | mean step there [us] | with a CFL "
                "number of %g [us] | what limits that | what happens beyond |\n|---|---|---|---|---|---|\n",
                name.c_str(), scene.usual.cfl);
    for (const Named& contact : scene.contacts) {
        if (!only.empty() && only != contact.name)
            continue;
        const Outcome usual = contact.run(scene.usual);
        if (!usual.failure.empty()) {
            std::printf("| %s | - | - | - | - | breaks off with %g: %s |\n", contact.name.c_str(), scene.usual.cfl,
                        usual.failure.c_str());
            continue;
        }
        double step = 0;          // with the greatest number that is stable, which is the last of these
        std::string beyond = "-"; // and with the least that is not
        const double largest = sph::bench::largest_stable(lowest, 0.5 * highest, highest, [&](double cfl) {
            Numerics longer = scene.usual;
            longer.cfl = cfl;
            const Outcome outcome = contact.run(longer);
            const double off = outcome.value / usual.value - 1;
            const bool stable = outcome.failure.empty() && std::abs(off) <= allowed;
            if (stable)
                step = outcome.step;
            else
                beyond = outcome.failure.empty() ? sph::text(100 * off, " % off")
                                                 : outcome.failure.substr(0, outcome.failure.find(';'));
            return stable;
        });
        const char* bound = largest == 0 ? "below " : largest >= highest ? "above " : "";
        std::printf("| %s | %s%.2g | %.3g | %.3g | %s | %s |\n", contact.name.c_str(), bound,
                    largest == 0 ? lowest : largest, step * 1e6, usual.step * 1e6, usual.limit.c_str(), beyond.c_str());
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    std::string scene_name, only, vary = "both", folder = "out-couplings";
    CLI::App app{"Five couplings of water and solid on three scenes."};
    app.add_option("scene", scene_name, "scaling, plate, gate or sponge")
        ->required()
        ->check(CLI::IsMember({"scaling", "plate", "gate", "sponge"}));
    app.add_option("--only", only, "one coupling, by its name in the table");
    app.add_option("--vary", vary, "support, spacing, both, or step: how long steps can be")
        ->check(CLI::IsMember({"support", "spacing", "both", "step"}))
        ->capture_default_str();
    app.add_option("--output", folder, "folder for the curves, of which --vary step has none")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        if (scene_name == "scaling") {
            print_scaling();
            return 0;
        }
        const SceneToRun scene = scene_by(scene_name);
        if (vary == "step") {
            print_edges(scene_name, scene, only);
            return 0;
        }
        sph::require_writable(folder);
        for (const bool supports : {true, false}) {
            if (vary != "both" && (vary == "support") != supports)
                continue;
            const auto& values = supports ? scene.ratios : scene.spacings;
            std::printf("\n%s, %s over %s\n\n| coupling |", scene_name.c_str(), scene.value,
                        supports ? "H in spacings" : "the spacing in mm");
            for (double v : values)
                std::printf(" %.3g |", supports ? v : v * 1e3);
            std::printf(
                " spread until %g s | until %g s | mean step [us] | seconds | least distance [spacings] |\n|---|",
                0.5 * scene.end, scene.end);
            for (std::size_t k = 0; k < values.size() + 5; ++k)
                std::printf("---|");
            std::printf("\n");
            for (const Named& contact : scene.contacts) {
                if (!only.empty() && only != contact.name)
                    continue;
                std::vector<Outcome> outcomes;
                std::vector<std::string> names;
                std::printf("| %s |", contact.name.c_str());
                for (double v : values) {
                    Numerics varied = scene.usual;
                    (supports ? varied.ratio : varied.spacing) = v;
                    outcomes.push_back(contact.run(varied));
                    names.push_back(supports ? sph::text("H = ", v, " spacings")
                                             : sph::text("spacing ", v * 1e3, " mm"));
                    if (outcomes.back().failure.empty())
                        std::printf(" %.4g |", outcomes.back().value);
                    else
                        std::printf(" failed |");
                    std::fflush(stdout);
                }
                const Outcome& first = outcomes.front();
                const std::size_t samples = first.curve.size();
                std::printf(" %.1f %% | %.1f %% | %.3g | %.3g | %.2f |\n", 100 * spread_of(outcomes, samples / 2),
                            100 * spread_of(outcomes, samples), first.step * 1e6, first.seconds, first.gap);
                for (std::size_t k = 0; k < outcomes.size(); ++k)
                    if (!outcomes[k].failure.empty())
                        std::fprintf(stderr, "%s, %s: %s\n", contact.name.c_str(), names[k].c_str(),
                                     outcomes[k].failure.c_str());
                std::string stem = scene_name + "-" + contact.name + (supports ? "-support" : "-spacing");
                std::replace(stem.begin(), stem.end(), '/', ' '); // K_f = p/S(d) is no folder
                write_curves(folder + "/" + stem + ".csv", names, outcomes, scene.end);
            }
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "couplings: %s\n", error.what());
        return 2;
    }
}
