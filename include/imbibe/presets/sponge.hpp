// The scene of the paper: a block of water falls onto an elastic slab with pores. Two compositions of it.
//
// `PaperSponge` is the method of the paper with its misprints corrected; `SoundSponge` is the same scene with schemes
// that converge. Both are named structs of types and makers, so that one program can run either.
#pragma once

#include <imbibe/presets/paper_sponge.hpp>
#include <imbibe/presets/sound_sponge.hpp>
