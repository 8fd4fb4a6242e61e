// For the library imbibe::presets: the scene of SoundSponge in double.
#include <imbibe/presets/compiled.hpp>

IMBIBE_PRESET_FUNCTIONS(, SoundSponge, double);
