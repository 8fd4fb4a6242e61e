// A run: takes a scene to its end with all output of a long computation, and continues it where it stopped.
#pragma once

#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/output/run_folder.hpp>
#include <imbibe/output/stop_on_signal.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/solver/describe.hpp>

#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace imbibe {

/// Takes a scene to its end and writes what a long computation needs into a folder: a table of numbers over time,
/// snapshots for ParaView, checkpoints. A Guard checks the scene. A run that is stopped, by Ctrl-C, a kill or a power
/// cut, continues from its last checkpoint bit by bit as if it had not been stopped.
///
/// A folder holds one run. An unfinished run is not overwritten, nor continued with other physics, unless the program
/// asks for it; the files of a finished run are removed before another begins.
/// <!-- tests/output/test_run.cpp -->
/// ```
/// imbibe::Run run(scene, {.folder = folder, .end = 0.02, .table_interval = 2e-3, .snapshot_interval = 0.01});
/// run.column("height", "m", [&] { return scene[water][imbibe::position].col(1).maxCoeff(); });
/// const imbibe::RunOutcome outcome = run.go();
/// ```
/// @tparam Scene a Solver
template <class Scene>
class Run {
public:
    static constexpr int dim = Scene::dimension; ///< 2 or 3

    /// Nothing is written yet.
    /// @param scene before its first step, with all particles added; it must live as long as the run
    /// @param settings where it writes, what, and how it begins
    /// @throws Error for numbers out of range; for a folder that cannot be written, or holds another run that has not
    ///     reached its end; where there is no checkpoint to go on from
    Run(Scene& scene, RunSettings settings)
        : scene_(scene), folder_(std::move(settings)), progress_(folder_.settings().end, RunFolder::is_terminal()) {
        folder_.check_beginning();
    }

    /// Adds a column to the table: `value()` is called for each row. Columns stand after the first, the time, and
    /// before the last two, the step's length and what limits it.
    Run& column(std::string name, std::string unit, std::function<double()> value) {
        columns_.push_back({std::move(name), std::move(unit)});
        values_.push_back(std::move(value));
        return *this;
    }
    /// A number of the program that belongs to the run, such as the mass that has left the scene: checkpoints carry it,
    /// and a restart sets it.
    template <class Number>
    Run& keep(std::string name, Number& value) {
        folder_.keep(std::move(name), &value);
        return *this;
    }
    /// A number that the scene depends on. A restart with another value is refused or, if it may change, reported.
    Run& depends_on(RunNumber number) {
        folder_.depends_on(std::move(number));
        return *this;
    }
    /// `observer(scene)` is called before the first step and after every one, before anything is written.
    Run& each(std::function<void(Scene&)> observer) {
        observers_.push_back(std::move(observer));
        return *this;
    }
    /// The guard that checks the scene, with default bounds unless others are set: `run.guard() = ...`.
    Guard<dim>& guard() { return guard_; }

    /// Runs to the end. Failures of the scene or the files are reported in the outcome, and everything written before
    /// stays.
    /// @throws Error for a checkpoint that is not of this run; what observers and columns throw, but Diverged
    RunOutcome go();

private:
    struct Stopped {}; // thrown when the user ends the run

    // Work on files, or in the program's own functions: its failures are not the scene's.
    template <class Work>
    void during(bool& what, const Work& work) {
        what = true;
        work();
        what = false;
    }
    void write() {
        during(writing_, [&] { write_checkpoint(scene_, folder_.checkpoint(), folder_.notes()); });
    }
    void add_row(Table& table) {
        std::vector<Cell> cells{scene_.time()};
        during(in_program_, [&] {
            for (const auto& value : values_)
                cells.push_back(value());
        });
        const TimeStepLimit& step = scene_.last_step();
        cells.push_back(step.seconds);
        cells.push_back(step.reason + ", " + step.where);
        during(writing_, [&] { table.row(std::span<const Cell>(cells)); });
        ++folder_.rows;
    }
    std::optional<Table> begin(Snapshots& snapshots);
    void run(std::optional<Table>& table, Snapshots& snapshots);

    Scene& scene_;
    RunFolder folder_;
    Progress progress_;
    Guard<dim> guard_;
    std::vector<Column> columns_;
    std::vector<std::function<double()>> values_;
    std::vector<std::function<void(Scene&)>> observers_;
    bool writing_ = false, in_program_ = false;
};

/// A run takes the type of its scene.
template <class Scene>
Run(Scene&, RunSettings) -> Run<Scene>;

// Brings the scene, the table and the snapshots to the state at which the run begins or continues, and prints what it
// does.
template <class Scene>
std::optional<Table> Run<Scene>::begin(Snapshots& snapshots) {
    const RunSettings& s = folder_.settings();
    std::string changes;
    if (s.restart) {
        const CheckpointNotes notes = read_checkpoint(scene_, folder_.continued());
        changes = folder_.restore(notes, scene_.time());
    } else {
        folder_.clear(Snapshots::lists(scene_));
    }
    if (!s.quiet) {
        std::printf("%s%s", changes.c_str(), describe(scene_).c_str());
        std::printf("Expected wall time: about %s for %g s\n\n",
                    clock_text(estimate_wall_seconds(scene_, s.end)).c_str(), s.end);
        std::fflush(stdout);
    }
    std::vector<Column> columns{{"time", "s"}};
    columns.insert(columns.end(), columns_.begin(), columns_.end());
    columns.insert(columns.end(), {{"time step", "s"}, {"what limits the time step"}});
    const auto path = folder_.file(s.table);
    const auto rows = static_cast<std::size_t>(folder_.rows);
    snapshots.resume(scene_, static_cast<std::size_t>(folder_.snapshots));
    const bool with_table = s.table_interval > 0;
    if (s.restart && s.previous) { // from here on no table fits the later one
        if (with_table)
            Table::require_resumable(path, columns, rows);
        return_to_previous_checkpoint(folder_.checkpoint());
    }
    std::optional<Table> table;
    if (with_table)
        table.emplace(s.restart ? Table::resume(path, columns, rows) : Table(path, columns));
    folder_.set_finished(false); // not before everything needed to continue is there
    return table;
}

template <class Scene>
void Run<Scene>::run(std::optional<Table>& table, Snapshots& snapshots) {
    const RunSettings& s = folder_.settings();
    const auto never = std::numeric_limits<double>::max();
    auto rows = every(s.table_interval > 0 ? s.table_interval : never, [&](Scene&) { add_row(*table); });
    auto pictures = every(s.snapshot_interval > 0 ? s.snapshot_interval : never, [&](Scene& now) {
        during(writing_, [&] { snapshots(now); });
        folder_.snapshots = static_cast<long long>(snapshots.size());
    });
    if (s.restart) {
        rows.resume(scene_.time());
        pictures.resume(scene_.time());
    }
    Checkpoints checkpoints(folder_.checkpoint(), s.checkpoint_interval);
    scene_.run_until(s.end, [&](Scene& now) {
        during(in_program_, [&] {
            for (const auto& observer : observers_)
                observer(now);
        });
        if (table)
            rows(now);
        if (s.snapshot_interval > 0)
            pictures(now);
        if (!s.quiet)
            progress_(now);
        if (s.stop_on_signal && StopOnSignal::asked() && now.search_is_due()) { // a checkpoint changes nothing here
            guard_.look(now);
            throw Stopped{};
        }
        guard_(now);
        if (now.steps() == 0) { // so that there is always one to go back to
            write();
        } else if (checkpoints.due(now)) {
            guard_.look(now); // a bad one is not written
            during(writing_, [&] { checkpoints(now, [&] { return folder_.notes(); }); });
        }
    });
    guard_.look(scene_);
    write(); // so that the run can continue to a later end
    during(writing_, [&] { folder_.set_finished(true); });
}

template <class Scene>
RunOutcome Run<Scene>::go() {
    Snapshots snapshots(folder_.settings().folder);
    auto table = begin(snapshots);
    RunOutcome outcome;
    std::optional<StopOnSignal> stopping;
    if (folder_.settings().stop_on_signal)
        stopping.emplace();
    const auto remedy = [&](RunFolder::At what) {
        return folder_.remedy(what, scene_.settings().cfl, scene_.settings().time_step);
    };
    const auto broke_off = [&](const Error& error) {
        outcome.failure = error.what();
        if (!writing_)
            outcome.failure += keep_offending_state(scene_, folder_.file("broken"));
        outcome.failure += "; " + remedy(writing_ ? RunFolder::At::files : RunFolder::At::scene);
    };
    writing_ = in_program_ = false;
    progress_ = Progress(folder_.settings().end, RunFolder::is_terminal());
    try {
        run(table, snapshots);
    } catch (const Stopped&) {
        outcome.stopped = true;
        try {
            write();
            outcome.failure = remedy(RunFolder::At::stopped);
        } catch (const Error& error) {
            outcome.failure = std::string("no checkpoint could be written: ") + error.what();
        }
    } catch (const Diverged& error) {
        broke_off(error);
    } catch (const Error& error) {
        if (in_program_)
            throw;
        broke_off(error);
    }
    outcome.time = scene_.time();
    outcome.steps = scene_.steps();
    outcome.snapshots = snapshots.size();
    outcome.wall_seconds = progress_.wall_seconds();
    return outcome;
}

} // namespace imbibe
