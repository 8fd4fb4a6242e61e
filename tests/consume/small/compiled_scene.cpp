// The file of the program that compiles the small scene for all others.
#include "compiled_scene.hpp"

IMBIBE_SCENE_FUNCTIONS(, imbibe::Solver<2, float, imbibe::SymplecticEuler, SmallWater>);
IMBIBE_PHASE_FUNCTIONS(, SmallWater, SmallScene);
