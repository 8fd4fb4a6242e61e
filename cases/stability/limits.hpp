// One scene for every reason that limits a time step but `acceleration`: the reason is the only one, or by far the
// shortest.
#pragma once

#include "fluids.hpp"
#include "solids.hpp"

#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/fluid/cleary_viscosity.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/gradient_correction.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/summation_relaxation.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/frozen_stress.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/interface/settle_surface.hpp>
#include <imbibe/methods/cohesive_fluid.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/mixture/pore_heat.hpp>
#include <imbibe/monitor/longest_stable_step.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/time/dual_stepping.hpp>
#include <imbibe/wall/corrected_no_slip.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/riemann_wall.hpp>

namespace stability {

/// Shakes a phase particle by particle, with up to `speed`, m/s, and watches it for 400 of its longest steps.
template <int dim>
Outcome march_shaken(auto& scene, const auto& phase, double speed, const Plan& plan) {
    shake(scene[phase], speed);
    Growth growth;
    scene.prepare();
    const Watch<dim> watch{.end = 400 * scene.time_step_limits().front().seconds,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"kinetic energy over that at the start", 4}},
                           .expected_steps = 400};
    const double asked = plan.ask ? sph::longest_stable_step(scene) / scene.time_step_limits().front().seconds : 0;
    Outcome out = march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[phase])}; });
    out.asked = asked;
    return out;
}

/// A periodic square (cube) of a material, shaken particle by particle in velocity and density.
/// @param support H in spacings
/// @param disorder how far the particles are from a lattice, in spacings
template <class Phase, int dim = 2>
Outcome shaken_box(const Plan& plan, Phase material, double support, double disorder = 0) {
    constexpr int across = dim == 2 ? 16 : 8;
    constexpr double length = across * dx;
    using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Phase>;
    sph::Settings<dim> settings{.support_radius = support * dx, .threads = 1};
    settings.periodic_length.fill(length);
    Scene scene(settings);
    const sph::Point<dim> lower = sph::Point<dim>::Zero(), upper = sph::Point<dim>::Constant(length);
    const auto lattice = sph::fill(sph::Box<dim>{lower, upper}, dx);
    const auto phase = scene.add(material, sph::jitter<dim>(lattice, disorder * dx, 1), dx);
    return march_shaken<dim>(scene, phase, 1e-4 * material.sound_speed, plan);
}

/// A square (cube) of a fluid with a free surface all around, shaken in the same way.
template <class Phase, int dim = 2>
Outcome shaken_drop(const Plan& plan, Phase material, double support, double disorder = 0) {
    constexpr double length = (dim == 2 ? 16 : 8) * dx;
    sph::Solver<dim, double, sph::SymplecticEuler, Phase> scene({.support_radius = support * dx, .threads = 1});
    const sph::Point<dim> lower = sph::Point<dim>::Zero(), upper = sph::Point<dim>::Constant(length);
    const auto lattice = sph::fill(sph::Box<dim>{lower, upper}, dx);
    const auto drop = scene.add(material, sph::jitter<dim>(lattice, disorder * dx, 1), dx);
    return march_shaken<dim>(scene, drop, 1e-4 * material.sound_speed, plan);
}

struct Plates : sph::Wall<> {};
/// The same between two plates, periodic along them.
template <class Phase, class Contact, class... Parameters>
Outcome shaken_channel(const Plan& plan, Phase material, double support, const Parameters&... parameters) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Phase, Plates, Contact> scene(
        {.support_radius = support * dx, .periodic_length = {across, 0}, .threads = 1});
    (scene.template coupling<Contact>().set(parameters), ...);
    const sph::Box<2> between{{0, 0}, {across, across}};
    const auto phase = scene.add(material, sph::fill(between, dx), dx);
    scene.add(Plates{{.density = material.density}}, sph::tank(between, dx, 3, sph::Sides::x), dx);
    return march_shaken<2>(scene, phase, 1e-4 * material.sound_speed, plan);
}

using C2 = sph::WendlandC2;
template <class... Terms>
using Liquid = sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::VolumePressure<C2>, Terms...>;
struct Sound : Liquid<> {};
struct Diffusing : Liquid<sph::DensityDiffusion<C2>> {};
struct Antuono : Liquid<sph::CurrentCorrection<C2>, sph::AntuonoDiffusion<C2>> {};
struct Morris : Liquid<sph::MorrisViscosity<C2>> {};
struct Cleary : Liquid<sph::ClearyViscosity<C2>> {};
struct Laminar : Liquid<sph::LaminarViscosity<sph::ViscosityKernel2D>> {};
struct Monaghan : Liquid<sph::MonaghanViscosity<C2>> {};
struct Floored : Liquid<sph::DensityFloor> {};
struct Relaxed : Liquid<sph::SummationRelaxation<C2>> {};
struct RaisedToSum : Liquid<sph::SummationFloor<C2>> {};
struct Waves : sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::RiemannPressure<C2>> {};
struct CorrectedLiquid : sph::Fluid<sph::LinearState, sph::CurrentCorrection<C2>, sph::CorrectedContinuity<C2>,
                                    sph::CorrectedPressure<C2>> {};
struct CorrectedSyrup : sph::Fluid<sph::LinearState, sph::CurrentCorrection<C2>, sph::VolumeContinuity<C2>,
                                   sph::VolumePressure<C2>, sph::CorrectedViscosity<C2>> {};
struct CohesiveLiquid : sph::Fluid<sph::CohesiveFluid> {};
struct NoSlipPlates
    : sph::Coupling<Morris, Plates, sph::Into<Plates, sph::NoSlipVelocity<C2>>, sph::NoSlipViscosity<C2>> {};
struct CorrectedNoSlipPlates
    : sph::Coupling<CorrectedSyrup, Plates, sph::Into<CorrectedSyrup, sph::CorrectionNeighbours<C2>>,
                    sph::Into<Plates, sph::Volume>, sph::Into<Plates, sph::NoSlipVelocity<C2>>,
                    sph::CorrectedNoSlipViscosity<C2>> {};
struct RiemannPlates : sph::Coupling<Sound, Plates, sph::Into<Sound, sph::RiemannWallNormal<C2>>,
                                     sph::RiemannWallPressure<C2>, sph::Into<Sound, sph::RiemannWallContinuity<C2>>> {};

/// Shakes the heat of a fluid at rest, particle by particle, and watches it for 400 of its longest steps.
template <int dim>
Outcome march_warm(auto& scene, const auto& phase, const Plan& plan) {
    std::mt19937 dice(5);
    const auto view = scene[phase];
    for (int i = 0; i < view.size(); ++i)
        view[sph::enthalpy](i) = dice() % 2 == 0 ? 1 : -1;
    scene.prepare();
    const Watch<dim> watch{.end = 400 * scene.time_step_limits().front().seconds,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"greatest enthalpy over that at the start", 1.5}},
                           .expected_steps = 400};
    return march(scene, plan, watch,
                 [&](const auto& s) { return std::vector{s[phase][sph::enthalpy].cwiseAbs().maxCoeff()}; });
}
struct Warm : sph::Fluid<sph::HeatCapacity, sph::HeatConduction<C2>> {};
struct Warmer : sph::Fluid<sph::HeatCapacity, sph::HeatConduction<C2>> {};
struct Touching : sph::Coupling<Warm, Warmer, sph::HeatTransfer<C2>> {};
struct Heated : sph::Wall<sph::SurfaceTemperature> {};
struct Heating
    : sph::Coupling<Warm, Heated, sph::Into<Heated, sph::TemperatureExtrapolation<C2>>, sph::HeatTransfer<C2>> {};
template <class Phase>
Phase warm(double conductivity) {
    Phase phase{{.density = 1000, .sound_speed = 1e-6}};
    phase.set(sph::HeatParameters{.heat_capacity = 1, .heat_conductivity = conductivity, .reference_temperature = 0});
    return phase;
}
/// A square (cube) of heat, insulated all around. @param disorder spacings
template <int dim>
Outcome warm_drop(const Plan& plan, double support, double disorder) {
    constexpr double length = (dim == 2 ? 16 : 8) * dx;
    sph::Solver<dim, double, sph::SymplecticEuler, Warm> scene(
        {.support_radius = support * dx, .max_time_step = 1e3, .threads = 1});
    const sph::Point<dim> lower = sph::Point<dim>::Zero(), upper = sph::Point<dim>::Constant(length);
    const auto lattice = sph::fill(sph::Box<dim>{lower, upper}, dx);
    return march_warm<dim>(scene, scene.add(warm<Warm>(1), sph::jitter<dim>(lattice, disorder * dx, 1), dx), plan);
}
/// The same between two walls at a temperature.
inline Outcome warm_channel(const Plan& plan, double support, double disorder) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Warm, Heated, Heating> scene(
        {.support_radius = support * dx, .max_time_step = 1e3, .periodic_length = {across, 0}, .threads = 1});
    const sph::Box<2> between{{0, 0}, {across, across}};
    const auto lattice = sph::jitter<2>(sph::fill(between, dx), disorder * dx, 1);
    const auto phase = scene.add(warm<Warm>(1), lattice, dx);
    Heated wall{{.density = 1000}};
    wall.set(sph::SurfaceTemperatureParameters{.surface_temperature = 0});
    scene.add(wall, sph::tank(between, dx, 3, sph::Sides::x), dx);
    return march_warm<2>(scene, phase, plan);
}
/// Two layers, of which the other conducts so much better.
inline Outcome warm_layers(const Plan& plan, double better) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Warm, Warmer, Touching> scene(
        {.support_radius = 2.6 * dx, .max_time_step = 1e3, .periodic_length = {across, across}, .threads = 1});
    const auto phase = scene.add(warm<Warm>(1), sph::fill(sph::Box<2>{{0, 0}, {across, across / 2}}, dx), dx);
    scene.add(warm<Warmer>(better), sph::fill(sph::Box<2>{{0, across / 2}, {across, across}}, dx), dx);
    return march_warm<2>(scene, phase, plan);
}

struct Seeping : sph::Fluid<sph::InPores<>, sph::SeepingFluid<C2>, sph::Instead<sph::PoreDensityFloor>> {};
struct Foam : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, C2>> {};
struct InFoam : sph::CouplingOf<Seeping, Foam> {};
/// A periodic square of water in a soft skeleton of the same or another density, which is shaken.
inline Outcome shaken_foam(const Plan& plan, double porosity, double density) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Seeping, Foam, InFoam> scene(
        {.support_radius = 3 * dx, .periodic_length = {across, across}, .threads = 1});
    const auto places = sph::fill(sph::Box<2>{{0, 0}, {across, across}}, dx);
    const auto water = scene.add(Seeping{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}}, places, dx);
    auto foam = elastic<Foam>(1e4, 0.3, density);
    foam.set(sph::PorousSkeletonParameters{.porosity = porosity});
    const auto body = scene.add(foam, places, dx);
    scene.template coupling<InFoam>().set(sph::DarcyDragParameters{.permeability = 1e-9});
    sph::fill_pores(scene, water, body);
    return march_shaken<2>(scene, body, 1e-3, plan);
}

struct WarmSeeping : sph::Fluid<sph::InPores<>, sph::SeepingFluid<C2>, sph::Instead<sph::PoreDensityFloor>,
                                sph::HeatCapacity, sph::PoreHeatConduction<C2>> {};
struct WarmFoam : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, C2>, sph::HeatCapacity,
                             sph::HeatConduction<C2, sph::Reference>> {};
struct InWarmFoam : sph::CouplingOf<WarmSeeping, WarmFoam, sph::PoreHeatExchange<C2>> {};
/// A periodic square of a fluid at rest in a skeleton, whose heat is shaken; the skeleton holds less heat.
inline Outcome warm_pores(const Plan& plan, double porosity) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, WarmSeeping, WarmFoam, InWarmFoam> scene(
        {.support_radius = 3 * dx, .max_time_step = 1e3, .periodic_length = {across, across}, .threads = 1});
    const auto places = sph::fill(sph::Box<2>{{0, 0}, {across, across}}, dx);
    auto fluid = warm<WarmSeeping>(1);
    fluid.viscosity = 1e-3;
    const auto water = scene.add(fluid, places, dx);
    WarmFoam foam{{.density = 300, .sound_speed = 1e-6, .shear_modulus = 1e-10}};
    foam.set(sph::PorousSkeletonParameters{.porosity = porosity});
    foam.set(sph::HeatParameters{.heat_capacity = 1, .heat_conductivity = 0.1, .reference_temperature = 0});
    const auto body = scene.add(foam, places, dx);
    scene.template coupling<InWarmFoam>().set(sph::DarcyDragParameters{.permeability = 1e-9});
    scene.template coupling<InWarmFoam>().set(sph::PoreHeatExchangeParameters{.exchange = 10 / sph::sq(dx)});
    sph::fill_pores(scene, water, body);
    return march_warm<2>(scene, water, plan);
}

struct Ice : Liquid<sph::Melting, sph::HeatConduction<C2>, sph::VelocityGradient<C2>, sph::FrozenStress<C2>> {};
/// Water that is frozen, three times as stiff against shear as against compression.
inline Ice frozen() {
    Ice ice{{.density = 1000, .sound_speed = 30}};
    ice.set(sph::MeltingParameters{1, 1, 1e-9, 1e-9, 1, 0, 0, -1});
    ice.set(sph::FrozenStressParameters{.shear_modulus = 3 * 1000 * sph::sq(30.0)});
    return ice;
}

template <class Phase>
Phase liquid(double viscosity = 0) {
    return Phase{{.density = 1000, .sound_speed = 30, .viscosity = viscosity}};
}

/// A disc of a liquid whose kappa is so many times rho c^2, its surface at rest, shaken.
inline Outcome shaken_cohesion(const Plan& plan, double times) {
    constexpr double radius = 12 * dx;
    using Scene = sph::Solver<2, double, sph::SymplecticEuler, CohesiveLiquid>;
    auto water = liquid<CohesiveLiquid>();
    const double strength = times * water.density * sph::sq(water.sound_speed);
    water.set(sph::CohesionParameters{.surface_tension = strength * sph::detail::CohesionConstants::tension * dx});
    std::vector<sph::Point<2>> disc;
    for (const auto& x : sph::fill(sph::Box<2>{{-radius, -radius}, {radius, radius}}, dx))
        if (x.norm() < radius)
            disc.push_back(x);
    Scene before({.support_radius = 5 * dx, .cfl = 0.3, .threads = 1});
    before.add(water, disc, dx);
    for (int again = 0; again < 3; ++again)
        sph::settle_surface<CohesiveLiquid>(before);
    const auto settled = before.get<CohesiveLiquid>()[sph::position].eval();
    for (std::size_t i = 0; i < disc.size(); ++i)
        disc[i] = settled.row(static_cast<Eigen::Index>(i)).transpose();
    Scene scene({.support_radius = 5 * dx, .threads = 1});
    const auto phase = scene.add(water, disc, dx);
    return march_shaken<2>(scene, phase, 0.02 * std::sqrt(strength / water.density), plan);
}

/// A free body of so many particles each way of a solid with parameters of choice, shaken.
template <int dim, class Body, class... Parameters>
Outcome shaken_body(const Plan& plan, const std::array<int, dim>& particles, double poisson, double support,
                    const Parameters&... parameters) {
    constexpr double spacing = 1e-2;
    sph::Solver<dim, double, sph::SymplecticEuler, Body> scene({.support_radius = support * spacing, .threads = 1});
    auto body = elastic<Body>(young, poisson, rho);
    (body.set(parameters), ...);
    const sph::Point<dim> lower = sph::Point<dim>::Zero();
    sph::Point<dim> upper;
    for (int d = 0; d < dim; ++d)
        upper[d] = spacing * particles[static_cast<std::size_t>(d)];
    const auto block = scene.add(body, sph::fill(sph::Box<dim>{lower, upper}, spacing), spacing);
    return march_shaken<dim>(scene, block, 1e-4 * body.longitudinal_wave_speed(), plan);
}
/// A block of twelve by twelve, in 3D six by six by six.
template <int dim, class Body, class... Parameters>
Outcome shaken_block(const Plan& plan, double poisson, double support, const Parameters&... parameters) {
    std::array<int, dim> particles;
    particles.fill(dim == 2 ? 12 : 6);
    return shaken_body<dim, Body>(plan, particles, poisson, support, parameters...);
}

/// A sheet of single particles of a total-Lagrangian solid, in 2D a row, moved by up to `rough` spacings, shaken.
template <int dim>
Outcome shaken_sheet(const Plan& plan, double rough) {
    constexpr double spacing = 1e-2;
    using Body = Hookean::Body;
    sph::Solver<dim, double, sph::SymplecticEuler, Body> scene({.support_radius = 2.01 * spacing, .threads = 1});
    const auto body = elastic<Body>(young, 0.3, rho);
    const sph::Point<dim> lower = sph::Point<dim>::Zero();
    sph::Point<dim> upper = sph::Point<dim>::Constant(dim == 2 ? 0.14 : 0.08);
    upper[dim - 1] = spacing;
    const auto flat = sph::fill(sph::Box<dim>{lower, upper}, spacing);
    const auto sheet = scene.add(body, sph::jitter<dim>(flat, rough * spacing, 7), spacing);
    return march_shaken<dim>(scene, sheet, 1e-4 * body.longitudinal_wave_speed(), plan);
}

struct ShearFromPairs : sph::Solid<sph::ReferenceCorrection<C2>, sph::DeformationGradient<C2>,
                                   sph::PairwiseShearForce<C2>, sph::TotalLagrangianViscosity<C2>> {};

struct Gas : Liquid<> {};
struct SoundMeetsGas : sph::Coupling<Sound, Gas, sph::VolumeContinuity<C2>, sph::VolumePressure<C2>> {};
using Raft = Kirchhoff::Body;
struct RaftWithNormals
    : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, C2>, sph::ReferenceSurfaceNormal<C2>> {};
struct RaftOnPressure : sph::Coupling<Sound, Raft, sph::Into<Raft, sph::PressureExtrapolation<C2>>,
                                      sph::VolumePressure<C2>, sph::Into<Sound, sph::VolumeContinuity<C2>>> {};
struct RaftOnNormals : sph::Coupling<Monaghan, RaftWithNormals, sph::SurfaceNormalPressure<C2>,
                                     sph::Into<Monaghan, sph::VolumeContinuity<C2>>> {};
struct RaftOnRiemann : sph::Coupling<Sound, Raft, sph::Into<Sound, sph::RiemannWallNormal<C2>>,
                                     sph::RiemannWallPressure<C2>, sph::Into<Sound, sph::RiemannWallContinuity<C2>>> {};

/// A layer of water, periodic on all sides, under one of something light, which is shaken.
template <class Contact, class Water, class Light>
Outcome shaken_layers(const Plan& plan, const Water& water, const Light& light) {
    constexpr double across = 16 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Water, Light, Contact> scene(
        {.support_radius = 2.6 * dx, .periodic_length = {across, across}, .threads = 1});
    scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {across, across / 2}}, dx), dx);
    const auto above = scene.add(light, sph::fill(sph::Box<2>{{0, across / 2}, {across, across}}, dx), dx);
    return march_shaken<2>(scene, above, 1e-4 * light.sound_speed, plan);
}
/// A soft solid that is `light` times as heavy as water, its waves a third as fast as sound.
template <class Body>
Body raft(double light) {
    return elastic<Body>(sph::sq(10.0) * 1000 * light, 0.3, 1000 * light);
}

struct Shifted : sph::Fluid<sph::ParticleShifting<C2>> {};
/// A periodic square (cube) of particles that are shifted and nothing else, as in the long steps of DualStepping, a
/// hundredth of a spacing off their lattice. Where steps are too long it grows rougher.
template <int dim>
Outcome shifted_box(const Plan& plan, double support) {
    constexpr double length = (dim == 2 ? 16 : 10) * dx, speed = 1;
    sph::Settings<dim> settings{.support_radius = support * dx, .search_skin = 0.1, .threads = 1};
    settings.periodic_length.fill(length);
    sph::Solver<dim, double, sph::DualStepping<sph::ParticleShifting<C2>>, Shifted> scene(settings);
    const sph::Point<dim> lower = sph::Point<dim>::Zero(), upper = sph::Point<dim>::Constant(length);
    const auto lattice = sph::fill(sph::Box<dim>{lower, upper}, dx);
    Shifted material{{.density = 1000, .sound_speed = 30}};
    material.set(sph::ParticleShiftingParameters{.least_speed = speed});
    const auto all = scene.add(material, sph::jitter<dim>(lattice, 0.01 * dx, 3), dx);
    double first = 0;
    const Watch<dim> watch{.end = 100 * scene.time_step_limits().front().seconds,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"shifting speed over that at the start", 4}},
                           .every = 1,
                           .expected_steps = 100};
    return march(scene, plan, watch, [&](const auto& s) {
        const double now = s.steps() > 0 ? s[all][sph::transport_correction].norm() : 0;
        if (s.steps() == 1)
            first = now;
        return std::vector{s.steps() > 0 ? now / first : 0};
    });
}

/// p = 0.
struct NoPressure {
    using reads = sph::Fields<>;
    using sets = sph::Fields<sph::pressure>;
    constexpr auto operator()(const auto& a) const { return typename std::remove_cvref_t<decltype(a)>::Scalar(0); }
};
struct Dust : sph::Fluid<NoPressure> {};
struct DustAtPlates
    : sph::Coupling<Dust, Plates, sph::Into<Dust, sph::RiemannWallNormal<C2>>, sph::RiemannWallPressure<C2>> {};
/// Particles without pressure, which see each other not at all, at the surface of a wall and on their way into it. Its
/// Riemann problems slow them down, and where steps are too long throw them back faster than they came.
inline Outcome dust_at_wall(const Plan& plan, double support) {
    sph::Solver<2, double, sph::SymplecticEuler, Dust, Plates, DustAtPlates> scene(
        {.support_radius = support * dx, .threads = 1});
    scene.template coupling<DustAtPlates>().set(sph::RiemannWallPressureParameters{.eta = 1e6});
    std::vector<sph::Point<2>> grains;
    for (int k = 0; k < 12; ++k)
        grains.push_back({(0.3 + 4.07 * k) * dx, 0});
    const auto dust = scene.add(Dust{{.density = 1000, .sound_speed = 30}}, grains, dx);
    scene.add(Plates{{.density = 1000}}, sph::fill(sph::Box<2>{{-4 * dx, -4 * dx}, {52 * dx, 0}}, dx), dx);
    scene[dust][sph::velocity].col(1).setConstant(-0.1);
    Growth growth;
    const Watch<2> watch{.end = 60 * dx / 30,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"kinetic energy over that at the start", 1}},
                         .every = 1};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[dust])}; });
}

struct Floor : sph::Wall<> {};
struct Stones : sph::Fluid<> {};
template <class Repulsion>
struct Bounce : sph::Coupling<Stones, Floor, Repulsion> {};
/// A row of particles that see each other not at all falls on a floor of particles, with 1 m/s, and bounces between
/// it and a lid: a repulsion alone. Where its steps are too long, energy comes in.
template <class Repulsion, class... Parameters>
Outcome bounce(const Plan& plan, double support, const Parameters&... parameters) {
    sph::Solver<2, double, sph::SymplecticEuler, Stones, Floor, Bounce<Repulsion>> scene(
        {.support_radius = support * dx, .threads = 1});
    std::vector<sph::Point<2>> stones, floor;
    for (int k = 0; k < 12; ++k) // further apart than they can see, each above another place of the floor
        stones.push_back({(0.3 + 4.07 * k) * dx, 3 * dx});
    for (int k = -3; k < 52; ++k)
        for (const double y : {0.0, 6.0})
            floor.push_back({k * dx, y * dx});
    (scene.template coupling<Bounce<Repulsion>>().set(parameters), ...);
    const auto row = scene.add(Stones{{.density = 1000, .sound_speed = 30}}, stones, dx);
    scene.add(Floor{{.density = 1000}}, floor, dx);
    scene[row][sph::velocity].col(1).setConstant(-1);
    Growth growth;
    const Watch<2> watch{.end = 60 * dx,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"kinetic energy over that at the start", 1.5}},
                         .every = 1};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[row])}; });
}

/// The same row of particles at rest, `near` supports above a floor: what the repulsion stores it gives back, and no
/// more.
inline Outcome let_go(const Plan& plan, double near, double stiffness) {
    constexpr double H = 1.25 * dx;
    using K = sph::Spiky;
    sph::Solver<2, double, sph::SymplecticEuler, Stones, Floor, Bounce<sph::KernelRepulsion<K>>> scene(
        {.support_radius = H, .threads = 1});
    std::vector<sph::Point<2>> stones, floor;
    for (int k = 0; k < 12; ++k)
        stones.push_back({(0.3 + 4.07 * k) * dx, near * H});
    for (int k = -3; k < 52; ++k)
        floor.push_back({k * dx, 0});
    double stored = 0; // K_f V_a V_b W
    for (const auto& a : stones)
        for (const auto& b : floor)
            if (const double r = (a - b).norm(); r < H)
                stored += stiffness * sph::sq(dx * dx) * sph::kernel_value<K, 2>(r, H);
    scene.template coupling<Bounce<sph::KernelRepulsion<K>>>().set(
        sph::KernelRepulsionParameters{.stiffness = stiffness});
    const auto row = scene.add(Stones{{.density = 1000, .sound_speed = 1e6}}, stones, dx);
    scene.add(Floor{{.density = 1000}}, floor, dx);
    const double speed = std::sqrt(2 * stored / (12 * 1000 * dx * dx)); // about that of all when they are out of reach
    const Watch<2> watch{.end = 400 * dx / speed, // free flight, nearly all of it: nothing else limits the steps
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"kinetic energy over what was stored", 1.5}},
                         .every = 1};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{sph::kinetic_energy(s[row]) / stored}; });
}

struct Marbles : sph::Fluid<sph::KernelRepulsion<>> {};
/// Rows of two particles each that meet head-on, again and again, on a ring: a repulsion within a phase, alone. They
/// have `share` of the energy that it takes to come through each other.
inline Outcome marbles(const Plan& plan, double share) {
    constexpr double H = 1.25 * dx, around = 8 * dx, stiffness = 1e6, volume = dx * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Marbles> scene(
        {.support_radius = H, .periodic_length = {around, 0}, .threads = 1});
    std::vector<sph::Point<2>> points;
    for (int row = 0; row < 12; ++row) // out of sight of each other, and not in step
        for (const double x : {0.03 * row, 4.0 - 0.03 * row})
            points.push_back({x * dx, 2 * row * dx});
    Marbles material{{.density = 1000, .sound_speed = 1e6}};
    material.set(sph::KernelRepulsionParameters{.stiffness = stiffness});
    const auto all = scene.add(material, points, dx);
    const double barrier = stiffness * volume * volume * sph::kernel_value<sph::Spiky, 2>(0.0, H);
    const double speed = std::sqrt(share * barrier / (1000 * volume)); // of each: m v^2 is what a pair has
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        scene[all][sph::velocity](i, 0) = i % 2 == 0 ? speed : -speed;
    Growth growth;
    const Watch<2> watch{.end = 40 * around / speed,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"kinetic energy over that at the start", 1.5}},
                         .every = 1};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[all])}; });
}

/// dv_a/dt = - k x_a: a spring to the origin, which says how long a step may be: 2 over its frequency, s.
struct Spring {
    static constexpr double k = 1e6; // 1/s^2
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return -k * a[sph::position]; }
    static constexpr const char* limit_name = "spring";
    static double time_step_limit(const auto&, const sph::TimeStepInput&) { return 2 / std::sqrt(k); }
};
struct Swinging : sph::Fluid<Spring> {};

/// One particle on a spring, let go so near that the spring's own limit is shorter than that on the acceleration.
inline Outcome swing(const Plan& plan) {
    constexpr double start = 0.1 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Swinging> scene({.support_radius = dx, .threads = 1});
    const auto one = scene.add(Swinging{{.density = 1000, .sound_speed = 1}}, {{start, 0}}, dx);
    const double most = std::sqrt(Spring::k) * start; // its greatest speed, were the steps short
    scene.step(1e-9);                                 // from here on there is an acceleration to limit the steps
    const Watch<2> watch{.end = 100 / std::sqrt(Spring::k),
                         .guard = {.speed = 1e6, .energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"speed over that of the exact swing", 4}},
                         .every = 1};
    return march(scene, plan, watch,
                 [&](const auto& s) { return std::vector{s[one][sph::velocity].row(0).norm() / most}; });
}

} // namespace stability
