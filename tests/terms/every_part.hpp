// Every pair part of the terms in one list, with the materials it runs between, for the tests that ask the same of all.
#pragma once

#include "hand.hpp"

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/fluid/cleary_viscosity.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/generalised_newtonian.hpp>
#include <imbibe/fluid/gradient_correction.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/strain_shifting.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/transport_advection.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_advection.hpp>
#include <imbibe/heat/frozen_drag.hpp>
#include <imbibe/heat/frozen_stress.hpp>
#include <imbibe/heat/heat_flux.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/interface/interface_tension.hpp>
#include <imbibe/interface/liquid_pressure.hpp>
#include <imbibe/kernels/poly6.hpp>
#include <imbibe/mixture/darcy_drag.hpp>
#include <imbibe/mixture/pore_pressure.hpp>
#include <imbibe/mixture/pore_space.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/corrected_gradients.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/wall/corrected_no_slip.hpp>
#include <imbibe/wall/generalised_no_slip.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>
#include <imbibe/wall/riemann_wall.hpp>

namespace hand {

/// A pair part, what its two sides are made of, and whether it is a force (equal and opposite times the masses).
template <class Part_, class A_, class B_, bool force>
struct Case {
    using Part = Part_;
    using A = A_;
    using B = B_;
    static constexpr bool is_force = force;
};

template <int dim>
using Laminar = LaminarViscosity<std::conditional_t<dim == 3, ViscosityKernel, ViscosityKernel2D>>;

/// ModifiedRepulsion with the reach of the support, where these tests expect the rim.
struct WideRepulsion : ModifiedRepulsion {
    constexpr WideRepulsion() { parameters.range = 2; }
};

/// The sum of an interface that has a tension, without which it is 0.
struct SomeInterface : InterfaceTension<>::Sum {
    constexpr SomeInterface() { parameters.surface_tension = 2; }
};

/// Cohesion and adhesion of some strength, without which they are 0.
struct SomeCohesion : Cohesion::Pull {
    constexpr SomeCohesion() { prepared.strength = 2; }
};
struct SomeAdhesion : Adhesion::Pull {
    constexpr SomeAdhesion() { prepared.share = 0.5; }
};
struct SomeCohesionVirial : CohesionVirial::Sum {
    constexpr SomeCohesionVirial() { prepared.strength = 2; }
};

template <int dim>
using EveryPairPart = TypeList<
    Case<Continuity<Spiky>, Water, Water, false>, Case<Continuity<Poly6, smoothed_velocity>, Sponge, Sponge, false>,
    Case<VolumeContinuity<Spiky>::Sweep, Water, Sponge, false>,
    Case<SymmetricPressure<Spiky>::Push, Water, Water, true>, Case<SymmetricPressure<Spiky>::Push, Water, Sponge, true>,
    Case<Laminar<dim>, Water, Water, true>, Case<Laminar<dim>, Water, Sponge, true>,
    Case<MonaghanViscosity<Spiky>, Sponge, Sponge, true>, Case<MonaghanViscosity<Spiky>, Water, Sponge, true>,
    Case<VelocityGradient<Spiky>, Sponge, Sponge, false>, Case<StressForce<Spiky>::Push, Sponge, Sponge, true>,
    Case<ArtificialStress<Spiky>::Push, Sponge, Sponge, true>,
    Case<ArtificialStress<Spiky, ComponentWise, Poly6, 3>::Push, Sponge, Sponge, true>,
    Case<Xsph<Poly6>::Sum, Sponge, Sponge, false>, Case<KernelRepulsion<>, Water, Sponge, true>,
    Case<VolumePressure<>::Push, Water, Water, true>, Case<VolumePressure<>::Push, Water, Sponge, true>,
    Case<VolumePressure<WendlandC2, Tension::none>::Push, Water, Sponge, true>,
    Case<DensityDiffusion<>::Smooth, Water, Water, false>, Case<MorrisViscosity<>, Water, Water, true>,
    Case<NoSlipViscosity<>, Water, Sponge, true>, Case<NoSlipContinuity<>::Sweep, Water, Sponge, false>,
    Case<ReferenceCorrection<>::Moments, Sponge, Sponge, false>,
    Case<DeformationGradient<>::Sum, Sponge, Sponge, false>, Case<TotalLagrangianForce<>::Push, Sponge, Sponge, true>,
    Case<HourglassControl<>::Push, Sponge, Sponge, true>, Case<TotalLagrangianViscosity<>::Push, Sponge, Sponge, true>,
    Case<RiemannPressure<>::Push, Water, Water, true>, Case<RiemannContinuity<>, Water, Water, false>,
    Case<RiemannWallNormal<>, Water, Sponge, false>, Case<RiemannWallPressure<>::Push, Water, Sponge, true>,
    Case<RiemannWallPressure<>::Push, Sponge, Water, true>, Case<RiemannWallContinuity<>, Water, Sponge, false>,
    Case<ClearyViscosity<>, Water, Water, true>, Case<ClearyViscosity<>, Water, Sponge, true>,
    Case<CorrectionNeighbours<>::Sum, Water, Water, false>, Case<AntuonoDiffusion<>::Sum, Water, Water, false>,
    Case<AntuonoDiffusion<>::Smooth, Water, Water, false>, Case<WideRepulsion, Water, Sponge, true>,
    Case<SurfaceNormalPressure<>::Push, Water, Sponge, true>, Case<SurfaceNormalPressure<>::Push, Sponge, Water, true>,
    Case<SurfaceNormal<>::Sum, Sponge, Sponge, false>, Case<ReferenceSurfaceNormal<>::Sum, Sponge, Sponge, false>,
    Case<PairwiseShearForce<>::Push, Sponge, Sponge, true>, Case<CorrectedContinuity<>::Sum, Water, Water, false>,
    Case<CorrectedPressure<>::Push, Water, Water, true>, Case<CorrectedViscosity<>, Water, Water, true>,
    Case<CorrectedVelocityGradient<>, Sponge, Sponge, false>, Case<CorrectedStressForce<>::Push, Sponge, Sponge, true>,
    Case<CorrectedNoSlipViscosity<>, Water, Sponge, true>, Case<ConcentrationNeighbours<>::Sum, Water, Water, false>,
    Case<TransportAdvection<>, Water, Water, false>,
    Case<GeneralisedNewtonianViscosity<Carreau>::Sum, Water, Water, false>,
    Case<GeneralisedNewtonianViscosity<Carreau>::Push, Water, Water, true>, Case<SomeInterface, Water, Water, false>,
    Case<SomeCohesion, Water, Water, true>, Case<CohesiveContact::Push, Water, Sponge, true>,
    Case<SomeAdhesion, Water, Sponge, true>, Case<PressureVirial::Sum, Water, Water, false>,
    Case<SomeCohesionVirial, Water, Water, false>, Case<InterfaceForce<>::Pull, Water, Water, true>,
    Case<ContactLineForce<>::Pull, Water, Sponge, true>, Case<NoSlipStrainRate<>::Sum, Water, Sponge, false>,
    Case<NoSlipApparentViscosity<>, Water, Sponge, true>, Case<HeatConduction<>::Conduct, Water, Water, false>,
    Case<HeatTransfer<>::Conduct, Water, Sponge, false>, Case<EnthalpyAdvection<>::Carry, Water, Water, false>,
    Case<FrozenStress<>::Pull, Water, Water, true>, Case<FrozenDrag<>::Drag::Rate, Water, Sponge, false>,
    Case<FrozenDrag<>::Drag::Slow, Water, Sponge, false>, Case<PorePressure<>::Push, Water, Sponge, true>,
    Case<PoreDensityDiffusion<>::Smooth, Water, Water, false>,
    Case<detail::ReactionTo<VolumePressure<>::Push>, Sponge, Water, false>,
    Case<detail::ReactionTo<NoSlipViscosity<>>, Sponge, Water, false>>;

/// Those that are no force and not zero for the particle itself, or have two results.
using OtherPairParts = TypeList<
    Case<PressureExtrapolation<>::Sum, Sponge, Water, false>, Case<NoSlipVelocity<>::Sum, Sponge, Water, false>,
    Case<LinearNoSlipVelocity<>::Sum, Sponge, Water, false>, Case<ShiftingNeighbours<>, Water, Water, false>,
    Case<ParticleShifting<>::Approach, Water, Water, false>, Case<ContactAngle<>::Sum, Water, Sponge, false>,
    Case<HeatConduction<>::Moment, Water, Water, false>, Case<HeatTransfer<>::Moment, Water, Sponge, false>,
    Case<TemperatureExtrapolation<>::Sum, Sponge, Water, false>, Case<HeatFromWalls<>::Sum, Water, Sponge, false>,
    Case<PoreSpace<>::Sum, Water, Sponge, false>, Case<PoreContents<>::Sum, Sponge, Water, false>,
    Case<PorousSkeleton<>::Count, Sponge, Sponge, false>, Case<SummationNeighbours<>, Water, Water, false>>;

template <class F, class... C>
void for_each_case(TypeList<C...>, F f) {
    (f(C{}), ...);
}

template <class Material>
Material material_of() {
    if constexpr (std::is_same_v<Material, Water>)
        return water();
    else
        return sponge();
}

/// A random particle that also has what the terms prepare.
template <class Material, int dim>
Particle<dim, Number<double>, Material> ready_particle(Dice& dice, Vector<Number<double>, dim> where) {
    auto p = dice.particle<dim>(material_of<Material>(), where);
    p.set(pressure_over_density2, typename SymmetricPressure<Spiky>::Prepare{}(p));
    p.set(stress_over_density2, typename StressForce<Spiky>::Prepare{}(p));
    p.set(artificial_stress_over_density2, typename ArtificialStress<Spiky>::Prepare{}(p));
    p.set(volume, p[mass] / p[density]).set(displacement, dice.vector<dim>(2e-4));
    Tensor<Number<double>, dim> t = identity<Number<double>, dim>();
    for (auto& c : t.c)
        c += dice(-0.1, 0.1);
    p.set(deformation_gradient, t).set(corrected_piola_stress, t);
    p.set(no_slip_velocity, dice.vector<dim>(1));
    p.set(supported_share, dice(0, 1))
        .set(wall_direction, dice.vector<dim>(1e3))
        .set(density_gradient, dice.vector<dim>(1e4));
    p.set(pressure_over_impedance, p[pressure] / detail::impedance(p.material)).set(surface_indicator, dice(0, 1));
    p.set(surface_normal, dice.vector<dim>(0.5));
    p.set(gradient_correction, symmetric_part(t)).set(corrected_stress, t);
    p.set(shear_scale, dice(0.9, 1.1)).set(isotropic_piola_stress, t);
    p.set(interface_stress, symmetric_part(t))
        .set(solid_direction, dice.vector<dim>(1))
        .set(contact_line_pull, dice.vector<dim>(1e3))
        .set(cohesion_strength, dice(500, 1500));
    p.set(transport_correction, dice.vector<dim>(0.1)).set(apparent_viscosity, dice(1e-3, 1));
    p.set(enthalpy, dice(-1e3, 1e3)).set(temperature, dice(-20, 20)).set(conductivity, dice(0.1, 3));
    p.set(conduction_potential, dice(-20, 20)).set(conduction_correction, dice(1, 2));
    p.set(solid_volume, 0.4 * p[volume]).set(present_volume, p[volume]).set(skeleton_sum, dice(0.5, 1.05));
    p.set(porosity, dice(0.5, 1)).set(pore_pressure, dice(-1e3, 1e3)).set(wetting, dice(0, 500));
    p.time_step = 1e-3; // in a step of 0 implicit drags do nothing
    p.set(liquid_fraction, dice(0, 1)).set(drag_rate, dice(1, 100)).set(mobility, 1.0);
    p.set(acceleration, dice.vector<dim>(10)).set(deviatoric_stress, symmetric_part(t));
    p.set(surface_temperature, dice(-20, 20)).set(heat_flux, dice(-1e3, 1e3));
    return p;
}

} // namespace hand
