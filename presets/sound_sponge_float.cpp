// For the library imbibe::presets: the scene of SoundSponge in float.
#include <imbibe/presets/compiled_scene.hpp>
#include <imbibe/presets/sound_sponge.hpp>

IMBIBE_SOUND_SPONGE_FUNCTIONS(, float);
