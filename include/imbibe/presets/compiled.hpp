// Which functions of the preset scenes the library imbibe::presets holds ready: a program that is linked with it takes
// them from there instead of compiling them (docs/compile_time.md). presets/sponge.hpp brings this where CMake has
// linked imbibe::presets, which defines IMBIBE_COMPILED_PRESETS.
#pragma once

#include <imbibe/output/snapshots.hpp>
#include <imbibe/presets/sponge.hpp>
#include <imbibe/solver/describe.hpp>

/// The functions of one preset that take a compiler long.
/// @param linkage `extern` says that another file has them; empty, this file does
/// @param Preset PaperSponge or SoundSponge, @param Real float or double
#define IMBIBE_PRESET_FUNCTIONS(linkage, Preset, Real)                                                                 \
    linkage template imbibe::PhaseHandle<imbibe::presets::Preset::Water> imbibe::presets::Preset::Scene<Real>::add(    \
        const imbibe::presets::Preset::Water&, const std::vector<imbibe::Point<3>>&, double);                          \
    linkage template imbibe::PhaseHandle<imbibe::presets::Preset::Sponge> imbibe::presets::Preset::Scene<Real>::add(   \
        const imbibe::presets::Preset::Sponge&, const std::vector<imbibe::Point<3>>&, double);                         \
    linkage template imbibe::PhaseHandle<imbibe::presets::Preset::Vessel> imbibe::presets::Preset::Scene<Real>::add(   \
        const imbibe::presets::Preset::Vessel&, const std::vector<imbibe::Point<3>>&, double);                         \
    linkage template void imbibe::presets::Preset::Scene<Real>::prepare();                                             \
    linkage template void imbibe::presets::Preset::Scene<Real>::take(const imbibe::TimeStepLimit&);                    \
    linkage template std::vector<imbibe::TimeStepLimit> imbibe::presets::Preset::Scene<Real>::time_step_limits()       \
        const;                                                                                                         \
    linkage template std::string imbibe::describe(imbibe::presets::Preset::Scene<Real>&);                              \
    linkage template void imbibe::Snapshots::operator()(const imbibe::presets::Preset::Scene<Real>&)

#ifdef IMBIBE_COMPILED_PRESETS
IMBIBE_PRESET_FUNCTIONS(extern, PaperSponge, float);
IMBIBE_PRESET_FUNCTIONS(extern, PaperSponge, double);
IMBIBE_PRESET_FUNCTIONS(extern, SoundSponge, float);
IMBIBE_PRESET_FUNCTIONS(extern, SoundSponge, double);
#endif
