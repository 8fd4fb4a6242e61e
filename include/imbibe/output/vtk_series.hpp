// A time series of one set of particles: numbered `.vtp` files and the `.pvd` file that lists them with their times.
#pragma once

#include <imbibe/output/vtk.hpp>

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// Writes `<folder>/<phase>_000000.vtp`, `_000001.vtp`, ... and after each of them `<folder>/<phase>.pvd`, the file to
/// open in ParaView. The list is replaced in one step and only ever names complete files, so a run that is killed
/// leaves a series that can be read up to its last snapshot.
class VtkSeries {
public:
    /// Checks the folder (require_writable) and the name of the phase, which becomes part of file names.
    VtkSeries(std::filesystem::path folder, std::string phase, VtkPrecision precision = VtkPrecision::as_given)
        : folder_(std::move(folder)), phase_(std::move(phase)), precision_(precision) {
        require(!phase_.empty() && phase_.find_first_of("/\\:") == std::string::npos, "VTK series: the phase name '",
                phase_, "' cannot be part of a file name; it must not be empty or contain / \\ :");
        require_writable(folder_);
    }

    /// Writes the next snapshot, at `seconds`, and the list. Throws Error when the disk refuses it, or when `seconds`
    /// is not later than the last snapshot; earlier files stay whole.
    void write(double seconds, VtkFile file) {
        require(entries_.empty() || seconds > entries_.back().first, "VTK series ", phase_, ": a snapshot at ", seconds,
                " s cannot follow one at ", entries_.empty() ? 0. : entries_.back().first, " s; times must increase");
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

    /// Continues the series of an earlier run from its first `snapshots` files, as after a restart: reads their times
    /// from `<phase>.pvd` and goes on numbering behind them. Throws Error if the list is missing or shorter.
    void resume(std::size_t snapshots) {
        std::vector<std::pair<double, std::string>> found;
        std::ifstream in(list());
        for (std::string line; found.size() < snapshots && std::getline(in, line);) {
            constexpr std::string_view start = "<DataSet timestep=\"";
            if (!line.starts_with(start))
                continue;
            double seconds = 0;
            const char* digits = line.data() + start.size();
            if (std::from_chars(digits, line.data() + line.size(), seconds).ec == std::errc{})
                found.emplace_back(seconds, file_name(found.size()));
        }
        require(found.size() == snapshots, "VTK series ", phase_, ": cannot continue after ", snapshots,
                " snapshots, because ", list().string(), " lists ", found.size(),
                "; continue in the folder of the earlier run, or start a new series in another folder");
        entries_ = std::move(found);
    }

    /// How many snapshots the series has.
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    /// The path of the `.pvd` file.
    [[nodiscard]] std::filesystem::path list() const { return folder_ / (phase_ + ".pvd"); }

private:
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
    std::vector<std::pair<double, std::string>> entries_;
};

} // namespace imbibe
