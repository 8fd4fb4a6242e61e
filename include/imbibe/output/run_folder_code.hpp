// The code of run_folder.hpp.
#pragma once

#include <imbibe/core/number_in_text.hpp>
#include <imbibe/output/run_folder.hpp>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace imbibe {

namespace detail {

/// The last time in the table of a run, s: the first number of its last complete line; empty if there is none.
inline std::optional<double> time_reached(const std::filesystem::path& table) {
    std::ifstream file(table);
    std::optional<double> time;
    std::string line;
    std::getline(file, line); // the names of the columns
    while (std::getline(file, line) && !file.eof())
        if (const auto number = number_in_text(line))
            time = number->value;
    return time;
}

inline void remove_if_there(const std::filesystem::path& path) {
    std::error_code none_there;
    std::filesystem::remove(path, none_there);
}

inline bool is_there(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(path, unknown);
}

inline std::string goes_on(const RunWords& words) {
    return words.goes_on.empty() ? words.restart + " goes on" : words.goes_on;
}

inline std::string shown(const RunNumber& number, double value) {
    const std::string words = number.in_words != nullptr ? number.in_words(value) : "";
    return !words.empty() ? words : number.unit.empty() ? text(value) : text(value, " ", number.unit);
}

} // namespace detail

IMBIBE_CODE std::filesystem::path finished_file(const std::filesystem::path& folder) {
    return folder / "finished.txt";
}

IMBIBE_CODE void refuse_to_lose_a_run(const RunSettings& run) {
    if (run.overwrite || !detail::is_there(run.folder / "checkpoint") || detail::is_there(finished_file(run.folder)))
        return;
    const auto time = detail::time_reached(run.folder / run.table);
    throw Error(text("the folder ", run.folder.string(), " holds a run ", time ? text("to ", *time, " s ") : "",
                     "that has not reached its end; ", detail::goes_on(run.words), " from its last checkpoint, ",
                     run.words.overwrite, " begins anew, ", run.words.folder, " takes another folder"));
}

IMBIBE_CODE RunFolder::RunFolder(RunSettings settings) : settings_(std::move(settings)) {
    const auto& s = settings_;
    require(!s.folder.empty(), "a run needs a folder; RunSettings::folder is empty");
    require(std::isfinite(s.end) && s.end > 0, "end time = ", s.end, " s; it must be above 0 s");
    const auto not_negative = [](const char* name, double interval) {
        require(std::isfinite(interval) && interval >= 0, "RunSettings::", name, " = ", interval,
                " s; it must be a finite number not below 0 s");
    };
    not_negative("table_interval", s.table_interval);
    not_negative("snapshot_interval", s.snapshot_interval);
    not_negative("checkpoint_interval", s.checkpoint_interval);
    require(!s.previous || s.restart, "RunSettings::previous without restart: it says from which checkpoint to go on");
    require(!s.overwrite || !s.restart, "RunSettings::restart and overwrite: a run either goes on or begins anew");
}

IMBIBE_CODE bool RunFolder::is_terminal() {
#if __has_include(<unistd.h>)
    return ::isatty(1) != 0;
#else
    return false;
#endif
}

IMBIBE_CODE void RunFolder::check_beginning() const {
    if (settings_.restart)
        require(detail::is_there(checkpoint()) || detail::is_there(file("checkpoint.previous")),
                "there is no checkpoint ", checkpoint().string(), " to go on from; the folder of a run is named by ",
                settings_.words.folder, ", and without ", settings_.words.restart, " one begins");
    else
        refuse_to_lose_a_run(settings_);
    require_writable(settings_.folder);
}

IMBIBE_CODE void RunFolder::clear(const std::vector<std::string>& lists) const {
    detail::remove_if_there(checkpoint());
    detail::remove_if_there(file("checkpoint.previous"));
    for (const auto* names : {&lists, &settings_.products})
        for (const std::string& name : *names)
            detail::remove_if_there(file(name));
    set_finished(false);
}

IMBIBE_CODE std::string RunFolder::restore(const CheckpointNotes& notes, double time) {
    const auto& s = settings_;
    const auto noted = [&notes](const std::string& name) -> std::optional<double> {
        const auto found = notes.find(name);
        return found == notes.end() ? std::nullopt : std::optional(found->second);
    };
    std::string changes;
    for (const RunNumber& now : depends_on_) {
        const auto before = noted("depends on " + now.name);
        // 14 mm typed and 14e-3 m of a default may differ in the last bit
        if (!before || std::abs(*before - now.value) <= 1e-12 * std::abs(now.value))
            continue;
        const std::string was = detail::shown(now, *before), is = detail::shown(now, now.value);
        require(now.may_change, "the run in the folder ", s.folder.string(), " has ", now.name, ": ", was,
                "; now it is ", is, "; a run goes on with the physics that it began with: give ", now.name,
                " as before, or begin anew in another folder (", s.words.folder, ")");
        changes += text("From here on ", now.name, ": ", is, "; until now: ", was, "\n");
    }
    require(time <= s.end, "the checkpoint in ", s.folder.string(), " was made at t = ", time,
            " s, after the end time of ", s.end, " s; give a later ", s.words.end);
    for (const auto& [name, where] : kept_)
        if (const auto value = noted("kept " + name))
            std::visit([&](auto* number) { *number = static_cast<std::remove_pointer_t<decltype(number)>>(*value); },
                       where);
    rows = static_cast<long long>(noted("rows").value_or(0));
    snapshots = static_cast<long long>(noted("snapshots").value_or(0));
    return changes;
}

IMBIBE_CODE CheckpointNotes RunFolder::notes() const {
    CheckpointNotes notes{{"rows", static_cast<double>(rows)}, {"snapshots", static_cast<double>(snapshots)}};
    for (const auto& [name, where] : kept_)
        notes["kept " + name] = std::visit([](const auto* number) { return static_cast<double>(*number); }, where);
    for (const RunNumber& number : depends_on_)
        notes["depends on " + number.name] = number.value;
    return notes;
}

IMBIBE_CODE std::string RunFolder::remedy(At what, double cfl, double time_step) const {
    const RunWords& words = settings_.words;
    if (what == At::stopped)
        return detail::goes_on(words) + " from here";
    if (!detail::is_there(checkpoint()))
        return "there is no checkpoint yet, so the run is to begin anew";
    if (what == At::files)
        return detail::goes_on(words) + " from the last checkpoint once the folder can be written again";
    return text(words.in_shorter_steps.empty()
                    ? words.restart + " goes on from the last checkpoint, which was good, for example"
                    : words.in_shorter_steps,
                " with ", time_step > 0 ? words.time_step : words.cfl, " ", 0.5 * (time_step > 0 ? time_step : cfl));
}

IMBIBE_CODE void RunFolder::set_finished(bool finished) const {
    if (!finished)
        return detail::remove_if_there(finished_file(settings_.folder));
    AtomicFile file(finished_file(settings_.folder));
    file << text("to ", settings_.end, " s\n");
    file.commit();
}

} // namespace imbibe
