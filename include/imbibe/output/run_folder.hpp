// The folder of a run: its files, whether a run may begin or continue there, and the numbers that checkpoints carry.
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

/// The file that says how far a finished run has come.
std::filesystem::path finished_file(const std::filesystem::path& folder);

/// Throws Error if the folder holds a run that can be continued, unless it may be overwritten. Writes nothing.
void refuse_to_lose_a_run(const RunSettings& settings);

/// The part of a Run that knows no scene.
class RunFolder {
public:
    /// Throws Error for numbers out of range.
    explicit RunFolder(RunSettings settings);

    /// The settings it was made with.
    [[nodiscard]] const RunSettings& settings() const { return settings_; }
    /// The file `name` in the folder.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return settings_.folder / name; }
    /// The last checkpoint.
    [[nodiscard]] std::filesystem::path checkpoint() const { return file("checkpoint"); }
    /// The checkpoint that a restart continues from.
    [[nodiscard]] std::filesystem::path continued() const {
        return file(settings_.previous ? "checkpoint.previous" : "checkpoint");
    }
    /// Does the program print to a terminal?
    [[nodiscard]] static bool is_terminal();

    using Kept = std::variant<double*, int*, long long*>; ///< address of a number that checkpoints carry
    /// See Run::keep.
    void keep(std::string name, Kept where) { kept_.emplace_back(std::move(name), where); }
    /// See Run::depends_on.
    void depends_on(RunNumber number) { depends_on_.push_back(std::move(number)); }

    /// Throws Error if a run may not begin or continue in the folder, or it cannot be written.
    void check_beginning() const;
    /// Removes the files of an earlier run. @param lists the lists of its snapshots
    void clear(const std::vector<std::string>& lists) const;
    /// Sets the kept numbers to those of a checkpoint, made at `time`, s. Returns a line for each number that changes
    /// from now on; throws Error if it may not change.
    std::string restore(const CheckpointNotes& notes, double time);
    /// The numbers for a checkpoint.
    [[nodiscard]] CheckpointNotes notes() const;
    /// What has ended a run.
    enum class At {
        scene,  ///< the scene has gone wrong
        files,  ///< its files cannot be written
        stopped ///< the user wanted it to end
    };
    /// How to continue a run that has ended early; `cfl` and `time_step` as in Settings.
    [[nodiscard]] std::string remedy(At what, double cfl, double time_step) const;
    /// Marks the run as finished or unfinished.
    void set_finished(bool finished) const;

    long long rows = 0;      ///< of the table
    long long snapshots = 0; ///< number of them

private:
    RunSettings settings_;
    std::vector<std::pair<std::string, Kept>> kept_;
    std::vector<RunNumber> depends_on_;
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/run_folder_code.hpp>
#endif
