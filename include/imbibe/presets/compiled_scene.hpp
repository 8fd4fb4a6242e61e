// The parts of a scene that take long to compile, and how a program compiles them in one file. The presets are compiled
// so in the library imbibe::presets; a program of several files can do the same with a scene of its own, in a header
//
//     using Scene = imbibe::Solver<3, float, imbibe::SymplecticEuler, Water, Tank, Contact>;
//     IMBIBE_SCENE_FUNCTIONS(extern, imbibe::Solver<3, float, imbibe::SymplecticEuler, Water, Tank, Contact>);
//     IMBIBE_PHASE_FUNCTIONS(extern, Water, Scene);
//     IMBIBE_PHASE_FUNCTIONS(extern, Tank, Scene);
//
// and in one of its files the same three lines without `extern`.
#pragma once

#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>

/// The solver itself, its description, and the observers that work with all scenes, as explicit instantiations. Use it
/// outside of all namespaces.
/// @param linkage `extern` says that another file has them; empty, this file does
/// The other argument is the scene, a `Solver<...>` written out: C++ takes no other name for it here.
#define IMBIBE_SCENE_FUNCTIONS(linkage, ...)                                                                           \
    linkage template class __VA_ARGS__;                                                                                \
    linkage template std::string imbibe::describe(__VA_ARGS__&);                                                       \
    linkage template double imbibe::estimate_wall_seconds(const __VA_ARGS__&, double, int);                            \
    linkage template void imbibe::Progress::operator()(const __VA_ARGS__&);                                            \
    linkage template void imbibe::Snapshots::operator()(const __VA_ARGS__&);                                           \
    linkage template void imbibe::Snapshots::resume(const __VA_ARGS__&, std::size_t);                                  \
    linkage template std::string imbibe::keep_offending_state(const __VA_ARGS__&, const std::filesystem::path&);       \
    linkage template void imbibe::write_checkpoint(__VA_ARGS__&, const std::filesystem::path&,                         \
                                                   const imbibe::CheckpointNotes&);                                    \
    linkage template imbibe::CheckpointNotes imbibe::read_checkpoint(__VA_ARGS__&, const std::filesystem::path&)

/// The functions that add the particles of a phase to a scene.
/// @param linkage as above @param Phase the phase
/// The other argument is the scene, or a name of it.
#define IMBIBE_PHASE_FUNCTIONS(linkage, Phase, ...)                                                                    \
    linkage template imbibe::PhaseHandle<Phase> __VA_ARGS__::add(                                                      \
        const Phase&, const std::vector<imbibe::Point<__VA_ARGS__::dimension>>&, double)
