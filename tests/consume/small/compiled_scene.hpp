// The small scene, its functions left to one file of the program.
#pragma once

#include "scene.hpp"
#include <imbibe/presets/compiled_scene.hpp>

IMBIBE_SCENE_FUNCTIONS(extern, imbibe::Solver<2, float, imbibe::SymplecticEuler, SmallWater>);
IMBIBE_PHASE_FUNCTIONS(extern, SmallWater, SmallScene);
