// One run of the sponge: what it may write, what comes of it, and the function that does it.
#pragma once

#include <imbibe/presets/sponge_case.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace imbibe::example {

/// How a run that did not reach its end is gone on with, in the words of the program that began it: programs have
/// different options for that.
struct WaysOn {
    std::string as_before = "--restart goes on"; ///< with the same numbers; " from here" or the like follows
    /// In shorter steps; how short, "with --cfl 0.375" or the like, follows.
    std::string in_shorter_steps = "--restart goes on from the last checkpoint, which was good, for example";
};

/// What a run writes, and where.
struct SpongeOutput {
    std::filesystem::path folder = "out-sponge";
    double table_interval = 1e-3;     ///< s
    double snapshot_interval = 10e-3; ///< s; 0: no snapshots
    double checkpoint_interval = 60;  ///< of wall time, s
    bool restart = false;             ///< go on from the checkpoint in the folder instead of from the start
    bool previous = false;            ///< and that from the checkpoint before the last
    bool overwrite = false;           ///< begin anew in the folder of a run that has not reached its end
    bool pictures = true;
    bool quiet = false; ///< no progress line, no report
    WaysOn ways_on;
};

/// What came of it.
struct SpongeResult {
    std::string composition, failure; ///< failure: empty when the run reached its end
    double end = 0;                   ///< the time reached, s
    double peak = 0, peak_time = 0;   ///< greatest mean displacement, m, and when, s
    double late_mean = 0;             ///< mean of the mean displacement over the last 40 % of the run, m
    double drained = 0;               ///< fraction of the water that is below the slab or has left through it
    double spilled = 0;               ///< fraction of the water that has left over the rim of the tank
    double wall_seconds = 0;
    long long steps = 0;
    std::size_t snapshots = 0; ///< that there are of this run
    bool conserved = false;    ///< water in the scene plus water drained is what there was
    bool stopped = false;      ///< the user wanted the run to end
};

/// Runs one case to `end`, s. Throws Error for bad input before anything is computed; a run that breaks off in the
/// middle, or that the user stops by Ctrl-C, is reported in the result, with what it had written until then left in
/// place. It can be continued from `<folder>/checkpoint`, to the same bits as if it had not stopped.
///
/// Defined in sponge_run_definition.hpp; compiled for each composition and number type in a file of its own, because
/// each takes a compiler some 20 seconds.
/// @tparam Composition presets::PaperSponge or presets::SoundSponge
/// @tparam Real float or double
template <class Composition, class Real>
SpongeResult run_sponge(const presets::SpongeCase& numbers, double end, const SpongeOutput& output);

/// The same with the composition ("paper" or "sound") and the precision ("float" or "double") by name.
SpongeResult run_sponge(const std::string& composition, const std::string& precision,
                        const presets::SpongeCase& numbers, double end, const SpongeOutput& output);

/// The numbers of the case by the option that gives them, as a checkpoint's notes carry them (lengths in mm).
std::map<std::string, double> numbers_by_option(const presets::SpongeCase& numbers, bool paper);

/// Compares the case with the one that a checkpoint's notes tell of. Returns a sentence for each number of the scheme
/// that is another from now on (a share of the time step's limit may change in a run), and nothing for a checkpoint
/// that says nothing of its case. Throws Error, naming the option and both values, where the physics is another.
std::string changed_since(const std::map<std::string, double>& notes, const presets::SpongeCase& numbers, bool paper);

/// Throws Error where the output's folder holds a run that can be gone on with, unless it may be overwritten. Nothing
/// is written.
void refuse_to_lose_a_run(const SpongeOutput& output);

/// A run has such a file, which says how far it came, if it has reached its end.
inline std::filesystem::path finished_file(const SpongeOutput& output) {
    return output.folder / "finished.txt";
}

/// Prints what happened, in words.
void print_summary(const presets::SpongeCase& numbers, const SpongeResult& result, const SpongeOutput& output);

} // namespace imbibe::example
