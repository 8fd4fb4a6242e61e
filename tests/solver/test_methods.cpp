// A method stands for its terms: a scene with methods is the scene with the terms that they stand for.
#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/methods/riemann_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>

#include <catch_shim.hpp>

namespace methods_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
using imbibe_test::contains;

template <class A, class... Terms>
inline constexpr bool has = std::is_same_v<typename A::terms, sph::TypeList<Terms...>>;

struct Water : sph::Fluid<sph::Tait<7>, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
static_assert(has<Water, sph::Tait<7>, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::DensityFloor,
                  sph::VolumePressure<K>, sph::MonaghanViscosity<K>>);
struct Rubber : sph::Solid<sph::TotalLagrangianSolid<sph::CompressibleNeoHookean, K>, sph::Clamped> {};
static_assert(has<Rubber, sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                  sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped>);
struct Tank : sph::Wall<> {};

// A coupling has what the fluid's method says, and what is listed besides.
struct Sides : sph::CouplingOf<Water, Tank> {};
static_assert(has<Sides, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                  sph::Into<Water, sph::VolumeContinuity<K>>>);
struct Load : sph::CouplingOf<Water, Rubber, sph::KernelRepulsion<>> {};
static_assert(has<Load, sph::Into<Rubber, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                  sph::Into<Water, sph::VolumeContinuity<K>>, sph::KernelRepulsion<>>);
struct Waves : sph::Fluid<sph::Tait<7>, sph::RiemannFluid<K>> {};
struct Shore : sph::CouplingOf<Waves, Tank> {};
static_assert(has<Waves, sph::Tait<7>, sph::RiemannContinuity<K>, sph::RiemannPressure<K>>);
static_assert(has<Shore, sph::Into<Waves, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                  sph::Into<Waves, sph::RiemannWallContinuity<K>>>);

// A term of a method is left out, or another stands in its place and acts where it acted.
struct Oil : sph::Fluid<sph::Instead<sph::DensityFloor>, sph::Tait<7>, sph::WeaklyCompressible<K>> {};
static_assert(has<Oil, sph::Tait<7>, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>>);
struct Pan
    : sph::CouplingOf<Oil, Tank, sph::Instead<sph::VolumePressure<K>, sph::VolumePressure<K, sph::Tension::none>>,
                      sph::Instead<sph::PressureExtrapolation<K>, sph::NoSlipVelocity<K>, sph::KernelRepulsion<>>> {};
static_assert(has<Pan, sph::Into<Tank, sph::NoSlipVelocity<K>>, sph::Into<Tank, sph::KernelRepulsion<>>,
                  sph::VolumePressure<K, sph::Tension::none>, sph::Into<Oil, sph::VolumeContinuity<K>>>);

// Methods of methods, and methods in a list that acts on one phase.
struct Both : sph::Method<sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Syrup : sph::Fluid<Both> {};
struct OneSided : sph::Coupling<Syrup, Tank, sph::Into<Syrup, Both>, sph::Instead<sph::DensityFloor>> {};
static_assert(has<OneSided, sph::Into<Syrup, sph::VolumeContinuity<K>>, sph::Into<Syrup, sph::DensityDiffusion<K>>,
                  sph::Into<Syrup, sph::VolumePressure<K>>, sph::Into<Syrup, sph::MonaghanViscosity<K>>>);

TEST_CASE("A scene of methods has the coefficients of their terms, and describe names the terms", "[methods]") {
    sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides> scene({.support_radius = 0.1, .threads = 1});
    Water water{{.density = 1000, .sound_speed = 10}};
    water.set(sph::DensityDiffusionParameters{.delta = 0.05});
    CHECK(water.coefficients.get<sph::DensityDiffusionParameters>().delta == 0.05);
    scene.coupling<Sides>().set(sph::PressureExtrapolationParameters{.suction = false});
    scene.add(water, {{0, 0}, {0.04, 0}}, 0.04);
    scene.add(Tank{{.density = 1000}}, {{0, -0.04}, {0.04, -0.04}}, 0.04);
    const std::string said = sph::describe(scene);
    for (const char* words : {"effects: Tait<7>, VolumeContinuity<WendlandC2>, DensityDiffusion<", // clang++: <>
                              ">, DensityFloor, VolumePressure<WendlandC2>, MonaghanViscosity<WendlandC2>\n",
                              "Sides (Water, Tank): Into<methods_test::Tank, PressureExtrapolation<"})
        CHECK_THAT(said, contains(words));
}

} // namespace methods_test
