// The code of vtk_series.hpp: writes snapshots and the list of them.
#pragma once

#include <imbibe/output/vtk_series.hpp>

namespace imbibe {

IMBIBE_CODE VtkSeries::VtkSeries(std::filesystem::path folder, std::string phase, VtkPrecision precision)
    : folder_(std::move(folder)), phase_(std::move(phase)), precision_(precision) {
    require(!phase_.empty() && phase_.find_first_of("/\\:") == std::string::npos, "VTK series: the phase name '",
            phase_, "' cannot be part of a file name; it must not be empty or contain / \\ :");
    require_writable(folder_);
}

IMBIBE_CODE void VtkSeries::write(double seconds, VtkFile file) {
    require(std::isfinite(seconds), "VTK series ", phase_, ": a snapshot at ", seconds,
            " s; the time must be a finite number");
    keep_earlier_than(seconds);
    if (list_names_more_) { // else a kill before the list is written leaves it with a file of another time
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

IMBIBE_CODE void VtkSeries::resume(std::size_t snapshots) {
    auto found = listed(snapshots, std::numeric_limits<double>::max());
    require(found.size() == snapshots, "VTK series ", phase_, ": cannot continue after ", snapshots,
            " snapshots, because ", list().string(), " lists ", found.size(),
            "; continue in the folder of the earlier run, or start a new series in another folder");
    begin_with(std::move(found));
}

IMBIBE_CODE void VtkSeries::begin_with(Entries entries) {
    entries_ = std::move(entries);
    begun_ = true;
    std::error_code unknown;
    list_names_more_ = std::filesystem::exists(list(), unknown);
}

IMBIBE_CODE void VtkSeries::keep_earlier_than(double seconds) {
    if (!begun_)
        begin_with(seconds > 0 ? listed(std::numeric_limits<std::size_t>::max(), seconds) : Entries{});
    for (; !entries_.empty() && !detail::earlier(entries_.back().first, seconds); list_names_more_ = true)
        entries_.pop_back();
}

IMBIBE_CODE VtkSeries::Entries VtkSeries::listed(std::size_t most, double end) const {
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
        require(line.find(" file=\"" + detail::xml_escaped(name) + "\"") != std::string::npos, "VTK series ", phase_,
                ": cannot continue ", list().string(), ", which names another file than ", name, " for the time ",
                seconds, " s", remedy);
        std::error_code unknown;
        require(std::filesystem::exists(folder_ / name, unknown), "VTK series ", phase_, ": cannot continue ",
                list().string(), ", because ", name, ", which it names, is not there", remedy);
        found.emplace_back(seconds, name);
    }
    return found;
}

IMBIBE_CODE std::string VtkSeries::file_name(std::size_t number) const {
    char digits[24];
    std::snprintf(digits, sizeof digits, "_%06zu", number);
    return phase_ + digits + ".vtp";
}

IMBIBE_CODE void VtkSeries::write_list() const {
    AtomicFile file(list());
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\""
         << detail::byte_order() << "\">\n<Collection>\n";
    for (const auto& [seconds, name] : entries_)
        file << "<DataSet timestep=\"" << detail::shortest(seconds) << "\" part=\"0\" name=\""
             << detail::xml_escaped(phase_) << "\" file=\"" << detail::xml_escaped(name) << "\"/>\n";
    file << "</Collection>\n</VTKFile>\n";
    file.commit();
}

} // namespace imbibe
