// The sponge in the `sound` composition, computed in double, and the functions of that scene for other examples.
#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::SoundSponge, double>(const imbibe::presets::SpongeCase&, double,
                                                                  const imbibe::example::SpongeOutput&);

IMBIBE_SOUND_SPONGE_FUNCTIONS(, double);
