// ReactionForce: what a fluid does to a wall or a solid is minus what it gets, for every force a coupling may have; a
// floor bears the weight of the water on it.
#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>
#include <imbibe/wall/riemann_wall.hpp>

#include <catch_shim.hpp>

#include <cmath>
#include <random>

namespace reaction_force_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.05;

struct Water
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>> {};
struct Floor : sph::Wall<> {};
struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::ReferenceSurfaceNormal<K>> {};

struct Sticky : sph::Coupling<Water, Floor, sph::Into<Floor, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                              sph::Into<Floor, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>,
                              sph::Into<Floor, sph::ReactionForce<sph::VolumePressure<K>, sph::NoSlipViscosity<K>>>> {};
struct Repelling : sph::Coupling<Water, Floor, sph::KernelRepulsion<>,
                                 sph::Into<Floor, sph::ReactionForce<sph::KernelRepulsion<>>>> {};
struct OneSided : sph::Coupling<Water, Floor, sph::Into<Water, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                                sph::Into<Floor, sph::ReactionForce<sph::RiemannWallPressure<K>>>> {};
struct AlongNormals : sph::Coupling<Water, Block, sph::SurfaceNormalPressure<K>,
                                    sph::Into<Block, sph::ReactionForce<sph::SurfaceNormalPressure<K>>>> {};

/// Water in disorder that moves, above a body; after a step, the sum of the forces on the water but its weight, and
/// that of the reactions, as shares of the latter's size.
template <int dim, class Body, class Contact, class... Parameters>
void check_balance(const Body& material, const Parameters&... parameters) {
    sph::Solver<dim, double, sph::SymplecticEuler, Water, Body, Contact> scene({.support_radius = 2.6 * dx});
    (scene.template coupling<Contact>().set(parameters), ...);
    sph::Point<dim> lower = sph::Point<dim>::Zero(), upper = sph::Point<dim>::Constant(0.4), deep = lower, flat = upper;
    deep[dim - 1] = -0.15;
    flat[dim - 1] = 0;
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 10, .viscosity = 1}},
                                 sph::jitter<dim>(sph::fill(sph::Box<dim>{lower, upper}, dx), 0.2 * dx, 1), dx);
    const auto body = scene.add(material, sph::fill(sph::Box<dim>{deep, flat}, dx), dx);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        view[sph::density](i) += 5 * any(random);
        for (int d = 0; d < dim; ++d)
            view[sph::velocity](i, d) = any(random);
    }
    scene.step(1e-6);
    const auto force = scene[body][sph::reaction_force];
    const sph::Point<dim> reaction = force.colwise().sum().transpose();
    const sph::Point<dim> push =
        (scene[water][sph::acceleration].array().colwise() * scene[water][sph::mass].array().col(0)).colwise().sum();
    CAPTURE(dim, reaction.transpose(), push.transpose());
    REQUIRE(reaction.norm() > 1e-3 * force.rowwise().norm().sum());
    CHECK((reaction + push).norm() < 1e-11 * force.rowwise().norm().sum());
}

TEST_CASE("a wall or a solid gets the opposite of what the water gets from it", "[reaction]") {
    const Floor floor{{.density = 1000}};
    check_balance<2, Floor, Sticky>(floor);
    check_balance<3, Floor, Sticky>(floor);
    check_balance<2, Floor, Repelling>(floor, sph::KernelRepulsionParameters{.stiffness = 1e4});
    check_balance<3, Floor, OneSided>(floor, sph::RiemannWallPressureParameters{.eta = 1, .suction = false});
    const Block block{{.density = 900, .sound_speed = 20, .shear_modulus = 1e5}};
    check_balance<2, Block, AlongNormals>(block);
    check_balance<3, Block, AlongNormals>(block);
}

TEST_CASE("a floor bears the weight of the water on it", "[reaction]") {
    struct Contact : sph::Coupling<Water, Floor, sph::Into<Floor, sph::PressureExtrapolation<K>>,
                                   sph::VolumePressure<K>, sph::Into<Water, sph::VolumeContinuity<K>>,
                                   sph::Into<Floor, sph::ReactionForce<sph::VolumePressure<K>>>> {};
    const double wide = 0.5, deep = 1, g = 9.81;
    sph::Solver<2, double, sph::SymplecticEuler, Water, Floor, Contact> scene(
        {.gravity = {0, -g}, .support_radius = 2.6 * dx, .periodic_length = {wide, 0}});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 45}}, sph::fill(sph::Box<2>{{0, 0}, {wide, deep}}, dx), dx);
    const auto floor = scene.add(Floor{{.density = 1000}}, sph::fill(sph::Box<2>{{0, -0.15}, {wide, 0}}, dx), dx);
    sph::start_hydrostatic(scene, water, deep);
    const double weight = g * scene[water][sph::mass].sum();
    double mean = 0;
    int looks = 0;
    scene.run_until(0.5, [&](const auto& s) {
        if (s.steps() > 0) {
            mean += s[floor][sph::reaction_force].col(1).sum();
            ++looks;
        }
    });
    CHECK(-mean / looks == Approx(weight).epsilon(0.005));
}

} // namespace reaction_force_test
