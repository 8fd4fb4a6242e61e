// The sponge in the `sound` composition, computed in float, and the functions of that scene for other examples.
#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::SoundSponge, float>(const imbibe::presets::SpongeCase&, double,
                                                                 const imbibe::example::SpongeOutput&);

IMBIBE_SOUND_SPONGE_FUNCTIONS(, float);
