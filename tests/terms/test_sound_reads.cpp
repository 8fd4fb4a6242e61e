// What the terms of the sound composition read, and on which side of a pair: the dry run against the intention.
#include "cloud.hpp"

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

using namespace cloud;

namespace {

using Bed = Wall<>;

template <int dim>
void check_sides() {
    CHECK(sides<Volume, dim, Water>() == "mass density |");
    CHECK(sides<VolumePressure<>::Push, dim, Water>() == "mass volume pressure | volume pressure");
    CHECK(sides<VolumePressure<>::Push, dim, Water, Bed>() == "mass volume pressure | volume pressure");
    CHECK(sides<DensityDiffusion<>::Smooth, dim, Water>() == "density | density volume");
    CHECK(sides<DensityFloor, dim, Water>() == "density |");
    CHECK(sides<MorrisViscosity<>, dim, Water>() == "density velocity | mass density velocity");
    CHECK(sides<PressureExtrapolation<>::Sum, dim, Bed, Water>() == "| pressure density");
    CHECK(sides<PressureExtrapolation<>::Divide, dim, Bed>() == "extrapolation_weight extrapolation_sum |");
    CHECK(sides<NoSlipVelocity<>::Sum, dim, Bed, Water>() == "velocity | velocity");
    CHECK(sides<NoSlipVelocity<>::Reflect, dim, Bed>() == "velocity no_slip_weight no_slip_sum |");
    CHECK(sides<NoSlipViscosity<>, dim, Water, Bed>() == "density velocity | mass density no_slip_velocity");
    CHECK(sides<NoSlipViscosity<>, dim, Sponge, Water>() == "density no_slip_velocity | mass density velocity");

    CHECK(sides<Displacement, dim, Sponge>() == "position reference_position |");
    CHECK(sides<ReferenceCorrection<>::Moments, dim, Sponge>() == "| mass");
    CHECK(sides<ReferenceCorrection<>::Invert, dim, Sponge>() == "moment_matrix |");
    CHECK(sides<DeformationGradient<>::Sum, dim, Sponge>() == "displacement | mass displacement");
    CHECK(sides<DeformationGradient<>::Correct, dim, Sponge>() == "raw_displacement_gradient gradient_correction |");
    CHECK(sides<StVenantKirchhoff, dim, Sponge>() == "deformation_gradient |");
    CHECK(sides<NeoHookean, dim, Sponge>() == "deformation_gradient |");
    CHECK(sides<CauchyStress, dim, Sponge>() == "deformation_gradient first_piola_stress |");
    CHECK(sides<TotalLagrangianForce<>::Prepare, dim, Sponge>() == "first_piola_stress gradient_correction |");
    CHECK(sides<TotalLagrangianForce<>::Push, dim, Sponge>() == "corrected_piola_stress | mass corrected_piola_stress");
    CHECK(sides<HourglassControl<>::Push, dim, Sponge>() ==
          "displacement deformation_gradient | mass displacement deformation_gradient");
    CHECK(sides<TotalLagrangianViscosity<>::Push, dim, Sponge>() ==
          "displacement velocity | mass displacement velocity");
}

// Every lane of a pack, in float, gives what one particle gives.
template <class Part, class A, class B>
void check_lanes(const Part& part, const A& a, const std::vector<B>& neighbours) {
    using T = Pack<float, native_width<float>>;
    using F = Number<float>;
    constexpr int dim = A::dimension;
    const auto wide_a = as<T>(a);
    const auto wide_b = lanes<T>(neighbours);
    const double support = a.material.support_radius;
    const auto where = [](const auto& p) {
        if constexpr (detail::uses_reference<Part>)
            return p[reference_position];
        else
            return p[position];
    };
    const auto pair = [&]<class N>(const Vector<N, dim>& offset) {
        return Pair<dim, N>{offset, norm(offset), N(support), N(1 / support), Vector<double, dim>::filled(-3.0)};
    };
    const auto wide_ab = pair(where(wide_a) - where(wide_b));
    const auto wide = contribution(wide_ab, part(wide_a, wide_b, wide_ab));
    const auto narrow_a = as<F>(a);
    for (int k = 0; k < std::min(T::size, static_cast<int>(neighbours.size())); ++k) {
        const auto narrow_b = as<F>(neighbours[static_cast<std::size_t>(k)]);
        const auto ab = pair(where(narrow_a) - where(narrow_b));
        const auto one = numbers(contribution(ab, part(narrow_a, narrow_b, ab))), same = numbers(wide, k);
        for (std::size_t i = 0; i < one.size(); ++i) {
            CHECK(std::isfinite(same[i]));
            CHECK(same[i] == Approx(one[i]).epsilon(1e-4).margin(1e-4 * std::abs(one[0])));
        }
    }
}

} // namespace

TEST_CASE("the terms of the sound composition read what they should, where they should") {
    check_sides<2>();
    check_sides<3>();
}

TEST_CASE("the terms of the sound composition run on packs, the particle itself among its neighbours") {
    Water w = water();
    w.support_radius = 2.6 * w.spacing;
    auto fluid = block<3>(w, 3, 0.2);
    Sponge s = sponge();
    s.support_radius = 2.6 * s.spacing;
    auto solid = block<3>(s, 3, 0.2);
    Dice dice(5);
    for (auto& p : fluid) {
        p.set(density, 1000 * dice(0.95, 1.05)).set(pressure, dice(-1e3, 1e4));
        p.set(volume, p[mass] / p[density]).set(velocity, dice.vector<3>(1));
    }
    for (auto& p : solid) {
        p.set(displacement, dice.vector<3>(2e-4)).set(velocity, dice.vector<3>(1));
        Tensor<Number<double>, 3> t = identity<Number<double>, 3>();
        for (auto& c : t.c)
            c += dice(-0.1, 0.1);
        p.set(deformation_gradient, t).set(corrected_piola_stress, t);
    }
    const auto &a = fluid[0], &b = fluid[13];
    for (const auto* p : {&a, &b}) {
        check_lanes(VolumePressure<>::Push{}, *p, fluid);
        check_lanes(DensityDiffusion<>::Smooth{}, *p, fluid);
        check_lanes(MorrisViscosity<>{}, *p, fluid);
    }
    for (const auto* p : {&solid[0], &solid[13]}) {
        check_lanes(ReferenceCorrection<>::Moments{}, *p, solid);
        check_lanes(DeformationGradient<>::Sum{}, *p, solid);
        check_lanes(TotalLagrangianForce<>::Push{}, *p, solid);
        check_lanes(HourglassControl<>::Push{}, *p, solid);
        check_lanes(TotalLagrangianViscosity<>::Push{}, *p, solid);
    }
}
