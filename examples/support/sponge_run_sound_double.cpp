// The sponge in the `sound` composition, computed in double.
#include <imbibe/presets/sound_sponge.hpp>

#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::SoundSponge, double>(const imbibe::presets::SpongeCase&,
                                                                  const imbibe::RunSettings&);
