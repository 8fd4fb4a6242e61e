// For the library imbibe::core: scenes in the plane in double.
#include "engine.hpp"

IMBIBE_ENGINE(2, double)
