// For the library imbibe::presets: the scenes of SoundWater in the plane.
#include <imbibe/presets/compiled_scene.hpp>
#include <imbibe/presets/sound_water.hpp>

IMBIBE_SOUND_WATER_FUNCTIONS(, 2, float);
IMBIBE_SOUND_WATER_FUNCTIONS(, 2, double);
