// The folder of a run: what is in it, whether a run may begin or go on there, and the numbers that checkpoints carry.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/output/run_settings.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace imbibe {

/// The file that says how far a run has come that has reached its end.
std::filesystem::path finished_file(const std::filesystem::path& folder);

/// Throws Error where the folder holds a run that can be gone on with, unless it may be overwritten. Nothing is
/// written.
void refuse_to_lose_a_run(const RunSettings& settings);

/// The part of a Run that knows no scene.
class RunFolder {
public:
    /// Throws Error for numbers out of range.
    explicit RunFolder(RunSettings settings);

    /// What it was made with.
    [[nodiscard]] const RunSettings& settings() const { return settings_; }
    /// The file `name` in the folder.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return settings_.folder / name; }
    /// The last checkpoint.
    [[nodiscard]] std::filesystem::path checkpoint() const { return file("checkpoint"); }
    /// The checkpoint that a restart goes on from.
    [[nodiscard]] std::filesystem::path continued() const {
        return file(settings_.previous ? "checkpoint.previous" : "checkpoint");
    }
    /// Does the program print to a terminal?
    [[nodiscard]] static bool is_terminal();

    using Kept = std::variant<double*, int*, long long*>; ///< where a number is that checkpoints carry
    /// See Run::keep.
    void keep(std::string name, Kept where) { kept_.emplace_back(std::move(name), where); }
    /// See Run::depends_on.
    void depends_on(RunNumber number) { depends_on_.push_back(std::move(number)); }

    /// Throws Error where a run may not begin, or go on, in the folder as it is, or it cannot be written.
    void check_beginning() const;
    /// Takes away what an earlier run left. @param lists the lists of its snapshots
    void clear(const std::vector<std::string>& lists) const;
    /// Sets the kept numbers to those of a checkpoint, made at `time`, s. Returns a line for each number that is
    /// another from now on; throws Error where that may not be.
    std::string restore(const CheckpointNotes& notes, double time);
    /// What a checkpoint is to carry.
    [[nodiscard]] CheckpointNotes notes() const;
    /// What has ended a run.
    enum class At {
        scene,  ///< the scene has gone wrong
        files,  ///< its files cannot be written
        stopped ///< the user wanted it to end
    };
    /// How a run that has ended early is gone on with; `cfl` and `time_step` as in Settings.
    [[nodiscard]] std::string remedy(At what, double cfl, double time_step) const;
    /// From now on the run has not reached its end; or it has.
    void set_finished(bool finished) const;

    long long rows = 0;      ///< that the table has
    long long snapshots = 0; ///< that there are

private:
    RunSettings settings_;
    std::vector<std::pair<std::string, Kept>> kept_;
    std::vector<RunNumber> depends_on_;
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/run_folder_code.hpp>
#endif
