// A kernel of the plane and of space, asked for on a line.
// expect: KernelOfAnotherDimension
// expect: this kernel is not made for this dimension
// expect: WendlandC2
// expect: use_CubicSpline_or_QuinticSpline_on_a_line
#include "scene.hpp"

double on_a_line(double r) {
    return sph::kernel_value<sph::WendlandC2, 1>(r, 0.1);
}
