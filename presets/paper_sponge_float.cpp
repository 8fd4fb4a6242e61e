// For the library imbibe::presets: the scene of PaperSponge in float.
#include <imbibe/presets/compiled_scene.hpp>
#include <imbibe/presets/paper_sponge.hpp>

IMBIBE_PAPER_SPONGE_FUNCTIONS(, float);
