// A time series of one set of particles: numbered `.vtp` files and the `.pvd` file that lists them with their times.
#pragma once

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
/// open in ParaView. The list is replaced in one step and only ever names complete files, so a run that is killed
/// leaves a series that can be read up to its last snapshot.
///
/// A series tells one story: a snapshot replaces those that are not earlier than it, as where a run has gone back to a
/// checkpoint. The first one of an object, where its time is above 0 s, continues what `<phase>.pvd` lists before that
/// time, as after a restart; at 0 s or before it begins a new series. Times that differ by a billionth are the same.
/// resume() says otherwise.
///
/// Files that are replaced leave the list before the first of them is overwritten; those that the new run does not come
/// to stay in the folder, unlisted.
class VtkSeries {
public:
    /// Checks the folder (require_writable) and the name of the phase, which becomes part of file names.
    VtkSeries(std::filesystem::path folder, std::string phase, VtkPrecision precision = VtkPrecision::as_given)
        : folder_(std::move(folder)), phase_(std::move(phase)), precision_(precision) {
        require(!phase_.empty() && phase_.find_first_of("/\\:") == std::string::npos, "VTK series: the phase name '",
                phase_, "' cannot be part of a file name; it must not be empty or contain / \\ :");
        require_writable(folder_);
    }

    /// Writes the snapshot at `seconds`, and the list. Throws Error when the disk refuses it, for a time that is not
    /// finite, or when the list that is to be continued is not one of a series of this phase, or names a file that is
    /// not there; earlier files stay whole.
    void write(double seconds, VtkFile file) {
        require(std::isfinite(seconds), "VTK series ", phase_, ": a snapshot at ", seconds,
                " s; the time must be a finite number");
        keep_earlier_than(seconds);
        if (list_names_more_) { // else a kill before the list is written would leave it with a file of another time
            write_list();
            list_names_more_ = false;
        }
        const auto name = file_name(entries_.size());
        file.time(seconds).write(folder_ / name, precision_);
        entries_.emplace_back(seconds, name);
        try {
            write_list();
        } catch (...) {
            entries_.pop_back();
            throw;
        }
    }

    /// Continues the series of an earlier run from its first `snapshots` files, whatever the time of the next one:
    /// reads their times from `<phase>.pvd` and goes on numbering behind them. With 0 a new series begins. Throws Error
    /// if the list is missing or shorter, or as write() does.
    void resume(std::size_t snapshots) {
        auto found = listed(snapshots, std::numeric_limits<double>::max());
        require(found.size() == snapshots, "VTK series ", phase_, ": cannot continue after ", snapshots,
                " snapshots, because ", list().string(), " lists ", found.size(),
                "; continue in the folder of the earlier run, or start a new series in another folder");
        begin_with(std::move(found));
    }

    /// How many snapshots the series has; before the first one none, also where it will continue a list.
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    /// The path of the `.pvd` file.
    [[nodiscard]] std::filesystem::path list() const { return folder_ / (phase_ + ".pvd"); }

private:
    using Entries = std::vector<std::pair<double, std::string>>; ///< time, s, and file

    void begin_with(Entries entries) {
        entries_ = std::move(entries);
        begun_ = true;
        std::error_code unknown;
        list_names_more_ = std::filesystem::exists(list(), unknown);
    }
    void keep_earlier_than(double seconds) {
        if (!begun_)
            begin_with(seconds > 0 ? listed(std::numeric_limits<std::size_t>::max(), seconds) : Entries{});
        for (; !entries_.empty() && !detail::earlier(entries_.back().first, seconds); list_names_more_ = true)
            entries_.pop_back();
    }
    // What the list in the folder names, up to `most` files and before `end`, s.
    Entries listed(std::size_t most, double end) const {
        const auto remedy = "; put back the folder of the earlier run, or write this series into another folder";
        Entries found;
        std::ifstream in(list());
        for (std::string line; found.size() < most && std::getline(in, line);) {
            constexpr std::string_view start = "<DataSet timestep=\"";
            if (!line.starts_with(start))
                continue;
            const auto time = detail::number_in_text(line.substr(start.size()));
            if (!time)
                continue;
            const double seconds = time->value;
            if (!detail::earlier(seconds, end))
                break;
            const auto name = file_name(found.size());
            require(line.find(" file=\"" + detail::xml_escaped(name) + "\"") != std::string::npos, "VTK series ",
                    phase_, ": cannot continue ", list().string(), ", which names another file than ", name,
                    " for the time ", seconds, " s", remedy);
            std::error_code unknown;
            require(std::filesystem::exists(folder_ / name, unknown), "VTK series ", phase_, ": cannot continue ",
                    list().string(), ", because ", name, ", which it names, is not there", remedy);
            found.emplace_back(seconds, name);
        }
        return found;
    }
    std::string file_name(std::size_t number) const {
        char digits[24];
        std::snprintf(digits, sizeof digits, "_%06zu", number);
        return phase_ + digits + ".vtp";
    }
    void write_list() const {
        AtomicFile file(list());
        file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\""
             << detail::byte_order() << "\">\n<Collection>\n";
        for (const auto& [seconds, name] : entries_)
            file << "<DataSet timestep=\"" << detail::shortest(seconds) << "\" part=\"0\" name=\""
                 << detail::xml_escaped(phase_) << "\" file=\"" << detail::xml_escaped(name) << "\"/>\n";
        file << "</Collection>\n</VTKFile>\n";
        file.commit();
    }

    std::filesystem::path folder_;
    std::string phase_;
    VtkPrecision precision_;
    Entries entries_;
    bool begun_ = false;           ///< is it settled what the series continues?
    bool list_names_more_ = false; ///< does the list in the folder, than `entries_`?
};

} // namespace imbibe
