// The sponge in the `paper` composition, computed in double, and the functions of that scene for other examples.
#include "sponge_run_definition.hpp"

template imbibe::example::SpongeResult
imbibe::example::run_sponge<imbibe::presets::PaperSponge, double>(const imbibe::presets::SpongeCase&, double,
                                                                  const imbibe::example::SpongeOutput&);

IMBIBE_PAPER_SPONGE_FUNCTIONS(, double);
