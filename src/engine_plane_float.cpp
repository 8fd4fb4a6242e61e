// For the library imbibe::core: scenes in the plane in float.
#include "engine.hpp"

IMBIBE_ENGINE(2, float)
