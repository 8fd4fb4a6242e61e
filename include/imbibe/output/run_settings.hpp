// The settings of a run and its outcome; see run.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace imbibe {

/// The words that messages of a run use for the user's choices: by default the member names of RunSettings and
/// Settings; a program with a command line names its options.
struct RunWords {
    std::string restart = "restart";     ///< RunSettings::restart
    std::string overwrite = "overwrite"; ///< RunSettings::overwrite
    std::string folder = "folder";       ///< RunSettings::folder
    std::string end = "end";             ///< RunSettings::end
    std::string cfl = "cfl";             ///< Settings::cfl
    std::string time_step = "time_step"; ///< Settings::time_step
    std::string goes_on = {};            ///< empty: "<restart> goes on"; " from here" or the like follows
    std::string in_shorter_steps = {};   ///< empty: "<restart> goes on from the last ..."; "with <cfl> 0.2" follows
};

/// Where a Run writes, what, and how it begins.
struct RunSettings {
    std::filesystem::path folder;    ///< for everything that is written; made if need be
    double end = 0;                  ///< the time that the run goes to, s
    double table_interval = 0;       ///< between two rows of the table, s; 0: no table
    std::string table = "run.csv";   ///< the table's file in the folder
    double snapshot_interval = 0;    ///< between two snapshots, s; 0: none
    double checkpoint_interval = 60; ///< of wall time between two checkpoints, s; 0: one at every search for neighbours
    bool restart = false;            ///< go on from the checkpoint in the folder instead of from the start
    bool previous = false;           ///< and from the one before the last; the last is then given up
    bool overwrite = false;          ///< begin anew in the folder of a run that has not reached its end
    bool quiet = false;              ///< print no description of the scene and no progress
    bool stop_on_signal = true;      ///< Ctrl-C and a polite kill end the run with a checkpoint, not the program
    /// Files that the program makes in the folder from the run's output, such as pictures: removed before another run
    /// begins there.
    std::vector<std::string> products = {};
    RunWords words = {}; ///< for messages
};

/// A number that a run depends on, so that a restart with another one is noticed.
struct RunNumber {
    std::string name;        ///< as the user gives it: an option, say
    double value = 0;        ///< in `unit`
    std::string unit = {};   ///< empty for a pure number
    bool may_change = false; ///< within a run: it affects how something is computed, not what
    /// For values that are more than a number: their text; null: the value and its unit.
    std::string (*in_words)(double) = nullptr;
};

/// What came of a Run.
struct RunOutcome {
    std::string failure;       ///< empty if the run reached its end; else why it did not, and how to continue it
    bool stopped = false;      ///< the user ended it (Ctrl-C)
    double time = 0;           ///< the time reached, s
    long long steps = 0;       ///< taken since the run began, also before a restart
    std::size_t snapshots = 0; ///< number of snapshots of the run
    double wall_seconds = 0;   ///< since this object was made, s
};

} // namespace imbibe
