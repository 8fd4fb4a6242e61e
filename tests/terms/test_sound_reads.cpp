// What the terms of the sound composition read, and on which side of a pair: the dry run against the intention.
#include "cloud.hpp"

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace sound_reads_test {

using namespace cloud;

namespace {

using Bed = Wall<>;

template <int dim>
void check_sides() {
    CHECK(sides<Volume, dim, Water>() == "mass density |");
    CHECK(sides<VolumePressure<>::Push, dim, Water>() == "mass volume pressure | volume pressure");
    CHECK(sides<VolumePressure<>::Push, dim, Water, Bed>() == "mass volume pressure | volume pressure");
    CHECK(sides<DensityDiffusion<>::Smooth, dim, Water>() ==
          "density supported_share | density volume supported_share");
    CHECK(sides<DensityFloor, dim, Water>() == "density |");
    CHECK(sides<MorrisViscosity<>, dim, Water>() == "density velocity | mass density velocity");
    CHECK(sides<PressureExtrapolation<>::Sum, dim, Bed, Water>() == "| pressure density");
    CHECK(sides<PressureExtrapolation<>::Divide, dim, Bed>() == "extrapolation_weight extrapolation_sum |");
    CHECK(sides<NoSlipVelocity<>::Sum, dim, Bed, Water>() == "velocity | velocity");
    CHECK(sides<NoSlipVelocity<>::Reflect, dim, Bed>() == "velocity no_slip_weight no_slip_sum |");
    CHECK(sides<LinearNoSlipVelocity<>::Sum, dim, Bed, Water>() == "velocity | velocity");
    CHECK(sides<LinearNoSlipVelocity<>::Continue, dim, Bed>() ==
          "velocity no_slip_weight no_slip_sum no_slip_offset |");
    CHECK(sides<NoSlipViscosity<>, dim, Water, Bed>() == "density velocity | mass density no_slip_velocity");
    CHECK(sides<NoSlipViscosity<>, dim, Sponge, Water>() == "density no_slip_velocity | mass density velocity");
    CHECK(sides<NoSlipContinuity<>::Sweep, dim, Water, Bed>() == "density velocity | volume no_slip_velocity");

    CHECK(sides<Displacement, dim, Sponge>() == "position reference_position |");
    CHECK(sides<ReferenceCorrection<>::Moments, dim, Sponge>() == "| mass");
    CHECK(sides<ReferenceCorrection<>::Share, dim, Sponge>() == "moment_matrix |");
    CHECK(sides<ReferenceCorrection<>::Invert, dim, Sponge>() == "moment_matrix stress_share |");
    CHECK(sides<DeformationGradient<>::Sum, dim, Sponge>() == "displacement | mass displacement");
    CHECK(sides<DeformationGradient<>::Correct, dim, Sponge>() == "raw_displacement_gradient gradient_correction |");
    CHECK(sides<StVenantKirchhoff, dim, Sponge>() == "deformation_gradient |");
    CHECK(sides<CompressibleNeoHookean, dim, Sponge>() == "deformation_gradient |");
    CHECK(sides<IsochoricNeoHookean, dim, Sponge>() == "deformation_gradient |");
    CHECK(sides<CauchyStress, dim, Sponge>() == "deformation_gradient first_piola_stress |");
    CHECK(sides<TotalLagrangianForce<>::Prepare, dim, Sponge>() ==
          "first_piola_stress gradient_correction stress_share |");
    CHECK(sides<TotalLagrangianForce<>::Push, dim, Sponge>() == "corrected_piola_stress | mass corrected_piola_stress");
    CHECK(sides<HourglassControl<>::Push, dim, Sponge>() ==
          "displacement deformation_gradient | mass displacement deformation_gradient");
    CHECK(sides<TotalLagrangianViscosity<>::Push, dim, Sponge>() ==
          "displacement velocity | mass displacement velocity");
}

} // namespace

TEST_CASE("the terms of the sound composition read what they should, where they should") {
    check_sides<2>();
    check_sides<3>();
}

} // namespace sound_reads_test
