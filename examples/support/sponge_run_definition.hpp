// What a run of the sponge does: tables, snapshots and pictures, for any composition of presets/sponge.hpp:
// include that of yours before this.
#pragma once

#include "pictures.hpp"
#include "sponge_run.hpp"

#include <imbibe/monitor/displacement.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/solver/describe.hpp>

#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace imbibe::presets {
struct PaperSponge; // one file compiles one composition: the other's scene is not so much as looked at
}

namespace imbibe::example {

/// Set by Ctrl-C and by a polite kill while a run is going on.
inline volatile std::sig_atomic_t stop_asked = 0;

/// While it lives, Ctrl-C does not end the program but asks the run to.
class StopOnSignal {
public:
    StopOnSignal() : interrupt(std::signal(SIGINT, ask)), terminate(std::signal(SIGTERM, ask)) { stop_asked = 0; }
    ~StopOnSignal() {
        std::signal(SIGINT, interrupt);
        std::signal(SIGTERM, terminate);
    }
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

private:
    static void ask(int) { stop_asked = 1; }
    void (*interrupt)(int);
    void (*terminate)(int);
};
/// Thrown by the run's observer when the user wants it to end.
struct StoppedByUser {};

inline void remove_if_there(const std::filesystem::path& path) {
    std::error_code none_there;
    std::filesystem::remove(path, none_there);
}

/// What to do about a step that was too long, by what chooses it: "with --cfl 0.375".
template <bool paper>
std::string shorter_steps(const presets::SpongeCase& numbers) {
    const double fixed = paper && numbers.time_step == 0 ? 1e-5 : numbers.time_step;
    return fixed > 0 ? text("with --time-step ", 0.5 * fixed) : text("with --cfl ", 0.5 * numbers.cfl);
}

template <class C, class Real>
SpongeResult run_sponge(const presets::SpongeCase& numbers, double end, const SpongeOutput& output) {
    using Water = typename C::Water;
    using Sponge = typename C::Sponge;
    require(std::isfinite(end) && end > 0, "end time = ", end, " s; it must be above 0 s");
    C::check(numbers); // before a folder is made
    constexpr bool paper = std::is_same_v<C, presets::PaperSponge>;
    const auto checkpoint = output.folder / "checkpoint";
    const auto continued = output.previous ? checkpoint.string() + ".previous" : checkpoint.string();
    if (output.restart) // before a folder is made
        require(std::filesystem::exists(checkpoint) || std::filesystem::exists(checkpoint.string() + ".previous"),
                "there is no checkpoint ", checkpoint.string(), " to go on from; the folder of a run is named by ",
                "--output, and without --restart one begins");
    else
        refuse_to_lose_a_run(output);
    require_writable(output.folder);

    auto scene = C::template make<Real>(numbers);
    const auto water = scene.template get<Water>();
    const auto sponge = scene.template get<Sponge>();
    const int water_at_start = water.size();
    const DisplacementProbe<3> probe(sponge, scene.settings());
    CheckpointNotes notes;
    if (output.restart) {
        const int sponge_at_start = sponge.size();
        notes = read_checkpoint(scene, continued);
        const std::string changes = changed_since(notes, numbers, paper);
        if (!output.quiet)
            std::printf("%s", changes.c_str());
        require(sponge.size() == sponge_at_start && notes["water at start"] == water_at_start, "the checkpoint in ",
                output.folder.string(), " is of another case: it began with ", notes["water at start"], " water and ",
                sponge.size(), " sponge particles, this one with ", water_at_start, " and ", sponge_at_start,
                "; give the same options as before, besides --restart");
        require(scene.time() <= end, "the checkpoint in ", output.folder.string(), " was made at t = ", scene.time(),
                " s, after the end time of ", end, " s; give a later --end");
    } else {
        // what is left of an earlier run must not be taken for a part of this
        for (const char* name : {"checkpoint", "checkpoint.previous", "water.pvd", "sponge.pvd", "vessel.pvd",
                                 "snapshots.png", "displacement.png", "drained.png"})
            remove_if_there(output.folder / name);
        remove_if_there(finished_file(output));
    }
    const std::string report = describe(scene);
    if (!output.quiet) {
        std::printf("%s", report.c_str());
        std::printf("Expected wall time: about %s for %g s\n\n", clock_text(estimate_wall_seconds(scene, end)).c_str(),
                    end);
        std::fflush(stdout);
    }

    const std::vector<Column> columns{{"time", "s"},
                                      {"mean displacement", "m"},
                                      {"mean vertical displacement", "m"},
                                      {"greatest displacement", "m"},
                                      {"drained mass", "kg"},
                                      {"drained fraction", "1"},
                                      {"kinetic energy of the water", "J"},
                                      {"potential energy of the water", "J"},
                                      {"compression energy of the water", "J"},
                                      {"kinetic energy of the sponge", "J"},
                                      {"potential energy of the sponge", "J"},
                                      {"elastic energy of the sponge", "J"},
                                      {"momentum along x", "kg m/s"},
                                      {"momentum along y", "kg m/s"},
                                      {"momentum along z", "kg m/s"},
                                      {"least density of the water", "kg/m^3"},
                                      {"greatest density of the water", "kg/m^3"},
                                      {"time step", "s"},
                                      {"what limits the time step"}};
    const auto path = output.folder / "sponge.csv";
    auto row_count = static_cast<std::size_t>(notes["rows"]);
    Snapshots snapshots(output.folder);
    snapshots.resume(scene, static_cast<std::size_t>(notes["snapshots"]));
    if (output.restart && output.previous) { // from here on the later one has no table that fits it
        Table::require_resumable(path, columns, row_count);
        return_to_previous_checkpoint(checkpoint);
    }
    Table table = output.restart ? Table::resume(path, columns, row_count) : Table(path, columns);
    remove_if_there(finished_file(output)); // not before all is there that a run goes on from
    Progress progress(end, isatty(1) != 0);
    SpongeResult result;
    result.composition = C::name;
    result.peak = notes["peak"];
    result.peak_time = notes["peak time"];
    int left = static_cast<int>(notes["left"]), spilled = static_cast<int>(notes["spilled"]);
    const double late_from = 0.6 * end;
    const bool same_end = notes["late from"] == late_from; // a run may be continued to a later end
    double late_sum = same_end ? notes["late sum"] : 0, late_count = same_end ? notes["late count"] : 0;
    const auto keep_notes = [&] {
        notes = {{"peak", result.peak},
                 {"peak time", result.peak_time},
                 {"left", left},
                 {"spilled", spilled},
                 {"water at start", water_at_start},
                 {"late from", late_from},
                 {"late sum", late_sum},
                 {"late count", late_count},
                 {"rows", static_cast<double>(row_count)},
                 {"snapshots", static_cast<double>(snapshots.size())}};
        notes.merge(numbers_by_option(numbers, paper));
        return notes;
    };

    // What falls outside the tank has jumped over its rim, not gone through the sponge. What has gone through may
    // spread by a part of a spacing below the walls, which are thicker than that.
    const auto in_the_tank = [&](double x, double y) {
        const double margin = numbers.water_spacing;
        return x > -margin && x < numbers.length() + margin &&
               (numbers.strip || (y > -margin && y < numbers.width() + margin));
    };
    const auto below = [&] {
        int n = left;
        const auto x = water[position];
        for (int i = 0; i < water.size(); ++i)
            n += x(i, 2) < 0 && in_the_tank(x(i, 0), x(i, 1));
        return static_cast<double>(n) / water_at_start;
    };
    const auto measure = [&](const auto& s) {
        const double mean = probe.mean(sponge);
        if (mean > result.peak) {
            result.peak = mean;
            result.peak_time = s.time();
        }
        if (s.time() >= late_from) {
            late_sum += mean;
            late_count += 1;
        }
        ++row_count;
        result.drained = below();
        const Point<3> all = momentum(water) + momentum(sponge);
        const double particle = 1000 * numbers.water_spacing * numbers.water_spacing * numbers.water_spacing;
        table.row({s.time(), mean, probe.mean_vector(sponge)[2], probe.greatest(sponge),
                   result.drained * water_at_start * particle, result.drained, kinetic_energy(water),
                   potential_energy(water, s.settings().gravity), compression_energy(water), kinetic_energy(sponge),
                   potential_energy(sponge, s.settings().gravity), stored_energy(sponge), all[0], all[1], all[2],
                   water.size() > 0 ? static_cast<double>(water[density].minCoeff()) : 0.0,
                   water.size() > 0 ? static_cast<double>(water[density].maxCoeff()) : 0.0, s.last_step().seconds,
                   s.last_step().reason + ", " + s.last_step().where});
    };
    auto rows = every(output.table_interval, measure);
    auto pictures =
        every(output.snapshot_interval > 0 ? output.snapshot_interval : end, [&](const auto& s) { snapshots(s); });
    if (output.restart) {
        rows.resume(scene.time());
        pictures.resume(scene.time());
    }
    Checkpoints checkpoints(checkpoint, output.checkpoint_interval);
    Guard<3> guard;
    const StopOnSignal stopping;
    const auto& ways_on = output.ways_on;
    bool writing = false; // is what goes wrong a matter of files?
    const auto with_files = [&writing](const auto& work) {
        writing = true;
        work();
        writing = false;
    };
    const auto write = [&] { with_files([&] { write_checkpoint(scene, checkpoint, keep_notes()); }); };
    try {
        scene.run_until(end, [&](auto& s) {
            if (s.steps() % 20 == 0)
                s.remove_if(PhaseHandle<Water>{}, [&](const Point<3>& x) {
                    const bool gone = x[2] < -numbers.drain;
                    if (gone)
                        ++(in_the_tank(x[0], x[1]) ? left : spilled);
                    return gone;
                });
            with_files([&] {
                rows(s);
                if (output.snapshot_interval > 0)
                    pictures(s);
            });
            if (!output.quiet)
                progress(s);
            if (stop_asked && s.search_is_due()) { // where a checkpoint does not change what comes after it
                guard.look(s);
                throw StoppedByUser{};
            }
            guard(s);
            with_files([&] {
                checkpoints(s, keep_notes, [&](const auto& now) { // a bad one is not written
                    writing = false;
                    guard.look(now);
                    writing = true;
                });
            });
            if (s.steps() == 0) // so that there is always one to go back to
                write();
        });
        guard.look(scene);
        write(); // from which the run can go on to a later end
        with_files([&] {
            AtomicFile file(finished_file(output));
            file << text("to ", end, " s\n");
            file.commit();
        });
    } catch (const StoppedByUser&) {
        result.failure = ways_on.as_before + " from here";
        result.stopped = true;
        try {
            write();
        } catch (const Error& error) {
            result.failure = std::string("no checkpoint could be written: ") + error.what();
        }
    } catch (const Error& error) {
        const bool good_one = std::filesystem::exists(checkpoint);
        result.failure = error.what();
        if (!writing)
            result.failure += keep_offending_state(scene, output.folder / "broken");
        result.failure += "; ";
        if (!good_one)
            result.failure += "there is no checkpoint yet, so the run is to begin anew";
        else if (writing)
            result.failure += ways_on.as_before + " from the last checkpoint once the folder can be written again";
        else
            result.failure += ways_on.in_shorter_steps + ' ' + shorter_steps<paper>(numbers);
    }
    result.drained = below();
    result.end = scene.time();
    result.steps = scene.steps();
    result.snapshots = snapshots.size();
    result.wall_seconds = progress.wall_seconds();
    result.late_mean = late_count > 0 ? late_sum / late_count : 0;
    result.spilled = static_cast<double>(spilled) / water_at_start;
    result.conserved = water.size() + left + spilled == water_at_start;

    if (output.pictures && result.snapshots > 0) {
        const std::string folder = output.folder.string();
        draw("render_sponge.py", {folder, "--count", "4", "-o", folder + "/snapshots.png"});
        draw("plot_curves.py",
             {folder + "/sponge.csv", "--y", "mean displacement", "--title",
              std::string("Mean displacement of the sponge, ") + C::name, "-o", folder + "/displacement.png"});
        draw("plot_curves.py",
             {folder + "/sponge.csv", "--y", "drained fraction", "--title",
              std::string("Water that has passed the sponge, ") + C::name, "-o", folder + "/drained.png"});
    }
    return result;
}

} // namespace imbibe::example
