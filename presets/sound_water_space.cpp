// For the library imbibe::presets: the scenes of SoundWater in space.
#include <imbibe/presets/compiled_scene.hpp>
#include <imbibe/presets/sound_water.hpp>

IMBIBE_SOUND_WATER_FUNCTIONS(, 3, float);
IMBIBE_SOUND_WATER_FUNCTIONS(, 3, double);
