// Half a metre of water on a soft elastic plate, through every coupling of water and a total-Lagrangian solid: how far
// the plate hangs down. After Fourey et al. (2017), with a softer plate and less water.
#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace plate_couplings {

namespace sph = imbibe;
using K = sph::WendlandC2;

/// One metre of plate, 0.05 m thick, clamped at both ends: E 6.75e8 Pa, nu 0.34, 2700 kg/m^3.
template <class... Extra>
struct Plate : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped, Extra...> {};
struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MonaghanViscosity<K>> {};
struct Sides : sph::Wall<> {};
struct WaterAtSides : sph::Coupling<Water, Sides, sph::Into<Sides, sph::PressureExtrapolation<K>>,
                                    sph::VolumePressure<K>, sph::Into<Water, sph::VolumeContinuity<K>>> {};

// The couplings that are compared, each with the plate it needs.
struct PlateA : Plate<> {};
struct Extrapolated : sph::Coupling<Water, PlateA, sph::Into<PlateA, sph::PressureExtrapolation<K>>,
                                    sph::VolumePressure<K>, sph::Into<Water, sph::VolumeContinuity<K>>> {};
struct PlateB : Plate<sph::ReferenceSurfaceNormal<K>> {};
struct AlongNormals
    : sph::Coupling<Water, PlateB, sph::SurfaceNormalPressure<K>, sph::Into<Water, sph::VolumeContinuity<K>>> {};
struct PlateC : Plate<> {};
struct Repelled : sph::Coupling<Water, PlateC, sph::ModifiedRepulsion> {};
struct PlateD : Plate<> {};
struct Guarded : sph::Coupling<Water, PlateD, sph::Into<PlateD, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>, sph::ModifiedRepulsion> {};

constexpr double soft_plate = 2.10e-3; // m, two-dimensional elasticity, +- 4 %
constexpr double weight = 9.81, depth = 0.5, thickness = 0.05, water_spacing = 0.02;
constexpr double damping = 120; // 1/s, a little below critical for the plate with the water on it
constexpr double end = 0.1;     // s: by then less than half a per cent of the motion is left

template <class P, class Scene>
auto add_plate(Scene& scene, int across) {
    const double spacing = thickness / across;
    P material;
    material.density = 2700;
    material.sound_speed = sph::sound_speed_of(6.75e8, 0.34, 2700);
    material.shear_modulus = sph::shear_modulus_of(6.75e8, 0.34);
    material.support_radius = 1.5 * spacing;
    const sph::Box<2> box{{-4 * spacing, -thickness}, {1 + 4 * spacing, 0}};
    const auto plate = scene.add(material, sph::fill(box, spacing), spacing);
    scene.hold(plate, [](const auto& x) { return x[0] < 0 || x[0] > 1; });
    return plate;
}

/// How far the middle of the plate hangs down, m.
double sag(const auto& plate) {
    double sum = 0;
    int number = 0;
    const auto X = plate[sph::reference_position], x = plate[sph::position];
    for (int i = 0; i < plate.size(); ++i)
        if (std::abs(X(i, 0) - 0.5) < plate.material().spacing) {
            sum += X(i, 1) - x(i, 1);
            ++number;
        }
    return sum / number;
}

/// The same plate under the weight of the water as a body force: what this discretisation makes of the load.
inline double dry_sag(int across) {
    const double g = weight * (1 + 1000 * depth / (2700 * thickness));
    sph::Solver<2, double, sph::SymplecticEuler, PlateA> scene(
        {.gravity = {0, -g}, .support_radius = 1.5 * thickness / across, .threads = 1});
    auto plate = scene[add_plate<PlateA>(scene, across)];
    while (scene.time() < 1.5 * end)
        plate[sph::velocity] *= 1 - damping * scene.step();
    return sag(plate);
}

/// The sag under the water itself.
template <class P, class Contact, class... Parameters>
double wet_sag(int across, const Parameters&... parameters) {
    constexpr double spacing = water_spacing;
    using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, P, Sides, WaterAtSides, Contact>;
    Scene scene({.gravity = {0, -weight}, .support_radius = 3 * spacing, .threads = 1});
    Water material{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * weight * depth)}};
    material.set(sph::MonaghanViscosityParameters{.alpha = 0.05});
    const auto water = scene.add(material, sph::fill(sph::Box<2>{{0, 0}, {1, depth}}, spacing), spacing);
    const auto plate = add_plate<P>(scene, across);
    auto sides = sph::fill(sph::Box<2>{{-3 * spacing, 0}, {0, 1.2 * depth}}, spacing);
    for (const auto& x : sph::fill(sph::Box<2>{{1, 0}, {1 + 3 * spacing, 1.2 * depth}}, spacing))
        sides.push_back(x);
    scene.add(Sides{{.density = 1000}}, sides, spacing);
    (scene.template coupling<Contact>().set(parameters), ...);
    auto fluid = scene[water];
    for (int i = 0; i < fluid.size(); ++i)
        fluid[sph::density](i) += 1000 * weight * (depth - fluid[sph::position](i, 1)) / sph::sq(material.sound_speed);
    auto solid = scene[plate];
    while (scene.time() < end) {
        const double left = 1 - damping * scene.step();
        solid[sph::velocity] *= left;
        fluid[sph::velocity] *= left;
    }
    return sag(solid);
}

} // namespace plate_couplings

using namespace plate_couplings;

// Measured, relative to the dry plate: 0.995 extrapolated and guarded, 0.991 along normals, 0.97 repelled (with
// restitution 0 too). The dry plate itself: 1.11 of the reference.
TEST_CASE("Water on a soft plate weighs the same through every coupling", "[validation][solid]") {
    constexpr int across = 5;
    // With 5 particles across the plate alone is 11 % too soft. What the coupling adds to that is looked at here.
    const double dry = dry_sag(across);
    const double extrapolated = wet_sag<PlateA, Extrapolated>(across) / dry;
    const double along_normals = wet_sag<PlateB, AlongNormals>(across) / dry;
    const double repelled =
        wet_sag<PlateC, Repelled>(across, sph::ModifiedRepulsionParameters{.speed = 40, .restitution = 1}) / dry;
    const double guarded =
        wet_sag<PlateD, Guarded>(across, sph::ModifiedRepulsionParameters{.speed = 1, .range = 0.7}) / dry;
    CAPTURE(dry / soft_plate, extrapolated, along_normals, repelled, guarded);
    CHECK(extrapolated == Approx(1).epsilon(0.04));
    CHECK(along_normals == Approx(1).epsilon(0.04));
    CHECK(repelled == Approx(1).epsilon(0.04));
    CHECK(guarded == Approx(extrapolated).epsilon(0.001)); // a guard that has nothing to do
}

// Measured: 1.044 dry, 1.037 extrapolated, 1.033 along normals.
TEST_CASE("Water on a soft plate of ten particles across bends it as elasticity says", "[validation][solid]") {
    const double extrapolated = wet_sag<PlateA, Extrapolated>(10) / soft_plate;
    const double along_normals = wet_sag<PlateB, AlongNormals>(10) / soft_plate;
    CAPTURE(extrapolated, along_normals);
    CHECK(extrapolated == Approx(1).epsilon(0.04)); // the reference's own tolerance
    CHECK(along_normals == Approx(1).epsilon(0.04));
}
