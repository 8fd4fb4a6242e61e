// A compiler that takes every number for a finite one leaves out the checks for those that are not.
// options: -O1 -ffast-math
// expect: imbibe: -ffast-math and -Ofast drop the checks for NaN
// expect: -fno-finite-math-only
#include "scene.hpp"

int main() {}
