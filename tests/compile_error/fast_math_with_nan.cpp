// The rest of what -ffast-math allows is up to the program.
// options: -O1 -ffast-math -fno-finite-math-only
// expect: nothing
#include "scene.hpp"

int main() {}
