// The sponge in the `paper` composition, computed in float.
#include <imbibe/presets/paper_sponge.hpp>

#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::PaperSponge, float>(const imbibe::presets::SpongeCase&,
                                                                 const imbibe::RunSettings&);
