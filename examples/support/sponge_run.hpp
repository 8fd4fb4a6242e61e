// One run of the sponge: what it writes, what comes of it, and the function that does it.
#pragma once

#include <imbibe/output/run_settings.hpp>
#include <imbibe/presets/sponge_case.hpp>

#include <string>
#include <vector>

namespace imbibe::example {

/// What a run of the sponge writes, and where, unless an option says otherwise; messages name the options.
RunSettings sponge_run_settings();

/// What came of it.
struct SpongeResult : RunOutcome {
    std::string composition;
    double peak = 0, peak_time = 0; ///< greatest mean displacement, m, and when, s
    double late_mean = 0;           ///< mean of the mean displacement over the last 40 % of the run, m
    double drained = 0;             ///< fraction of the water that is below the slab or has left through it
    double spilled = 0;             ///< fraction of the water that has left over the rim of the tank
    bool conserved = false;         ///< water in the scene plus water drained is what there was
};

/// Runs one case. Throws Error for bad input before anything is computed; a run that breaks off in the middle, or that
/// the user stops by Ctrl-C, is reported in the result (see Run).
///
/// Defined in sponge_run_definition.hpp; compiled for each composition and number type in a file of its own, because
/// each takes a compiler some 20 seconds.
/// @tparam Composition presets::PaperSponge or presets::SoundSponge
/// @tparam Real float or double
template <class Composition, class Real>
SpongeResult run_sponge(const presets::SpongeCase& numbers, const RunSettings& settings);

/// The same with the composition ("paper" or "sound") and the precision ("float" or "double") by name.
SpongeResult run_sponge(const std::string& composition, const std::string& precision,
                        const presets::SpongeCase& numbers, const RunSettings& settings);

/// The numbers of the case by the option that gives them (lengths in mm).
std::vector<RunNumber> numbers_by_option(const presets::SpongeCase& numbers, bool paper);

/// Draws what a run has left in its folder: snapshots.png, displacement.png, drained.png.
void draw_pictures(const std::string& folder, const std::string& composition);

/// Prints what happened, in words.
void print_summary(const presets::SpongeCase& numbers, const SpongeResult& result, const RunSettings& settings);

} // namespace imbibe::example
