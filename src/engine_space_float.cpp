// For the library imbibe::core: scenes in space in float.
#include "engine.hpp"

IMBIBE_ENGINE(3, float)
