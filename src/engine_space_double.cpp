// For the library imbibe::core: scenes in space in double.
#include "engine.hpp"

IMBIBE_ENGINE(3, double)
