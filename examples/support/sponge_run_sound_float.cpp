// The sponge in the `sound` composition, computed in float, and the functions of that scene for other examples.
#include <imbibe/presets/compiled_scene.hpp>
#include <imbibe/presets/sound_sponge.hpp>

#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::SoundSponge, float>(const imbibe::presets::SpongeCase&,
                                                                 const imbibe::RunSettings&);

#ifndef IMBIBE_COMPILED_PRESETS // else imbibe::presets has them
IMBIBE_SOUND_SPONGE_FUNCTIONS(, float);
#endif
