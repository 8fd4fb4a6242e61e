// A time series of one set of particles: numbered `.vtp` files and the `.pvd` file that lists them with their times.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/number_in_text.hpp>
#include <imbibe/output/vtk.hpp>

#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// Writes `<folder>/<phase>_000000.vtp`, `_000001.vtp`, ... and after each of them `<folder>/<phase>.pvd`, the file to
/// open in ParaView. The list is replaced in one step and names only complete files, so a killed run leaves a series
/// that is readable up to its last snapshot.
///
/// A snapshot replaces those that are not earlier, as when a run has gone back to a checkpoint. The first one of an
/// object, if its time is above 0 s, continues what `<phase>.pvd` lists before that time, as after a restart; at or
/// before 0 s it begins a new series. Times that differ by a billionth are the same. resume() overrides this.
///
/// Replaced files leave the list before the first of them is overwritten; those that the new run does not reach stay in
/// the folder, unlisted.
class VtkSeries {
public:
    /// Checks the folder (require_writable) and the name of the phase, which becomes part of file names.
    VtkSeries(std::filesystem::path folder, std::string phase, VtkPrecision precision = VtkPrecision::as_given);

    /// Writes the snapshot at `seconds`, and the list. Throws Error when the disk refuses it, for a time that is not
    /// finite, or when the list to be continued is not one of a series of this phase, or names a missing file; earlier
    /// files stay complete.
    void write(double seconds, VtkFile file);

    /// Continues the series of an earlier run after its first `snapshots` files, for any time of the next one: reads
    /// their times from `<phase>.pvd` and continues the numbering. With 0 a new series begins. Throws Error if the list
    /// is missing or shorter, or as write() does.
    void resume(std::size_t snapshots);

    /// The number of snapshots of the series; 0 before the first one, even if it will continue a list.
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    /// The path of the `.pvd` file.
    [[nodiscard]] std::filesystem::path list() const { return folder_ / (phase_ + ".pvd"); }

private:
    using Entries = std::vector<std::pair<double, std::string>>; ///< time, s, and file

    void begin_with(Entries entries);
    void keep_earlier_than(double seconds);
    // The files in the folder's list, up to `most` files and before `end`, s.
    Entries listed(std::size_t most, double end) const;
    std::string file_name(std::size_t number) const;
    void write_list() const;

    std::filesystem::path folder_;
    std::string phase_;
    VtkPrecision precision_;
    Entries entries_;
    bool begun_ = false;           ///< has it been decided what the series continues?
    bool list_names_more_ = false; ///< does the folder's list name more than `entries_`?
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/vtk_series_code.hpp>
#endif
