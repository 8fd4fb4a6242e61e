// A gradient by one kernel, its correction by another: a rigid turn would be a strain.
// expect: a gradient and its correction are made with two kernels
// expect: TwoKernels<imbibe::WendlandC2, imbibe::CubicSpline, imbibe::ReferenceCorrection<
// expect: give_both_the_same_kernel
#include "scene.hpp"

#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

struct Block : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<sph::CubicSpline>,
                          sph::CompressibleNeoHookean, sph::TotalLagrangianForce<sph::CubicSpline>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
