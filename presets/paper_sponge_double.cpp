// For the library imbibe::presets: the scene of PaperSponge in double.
#include <imbibe/presets/compiled.hpp>

IMBIBE_PRESET_FUNCTIONS(, PaperSponge, double);
