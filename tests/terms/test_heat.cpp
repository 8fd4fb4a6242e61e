// Heat: what is conserved, how fast it flows inside a phase, between phases, from walls and along surfaces, and the
// temperature of what melts.
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/heat/boussinesq.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_advection.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/heat/heat_flux.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace heat_test {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<HeatCapacity, HeatConduction<K>> {};
struct Oil : Fluid<HeatCapacity, HeatConduction<K>> {};
struct Between : Coupling<Water, Oil, HeatTransfer<K>> {};
struct Rubber : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, HeatCapacity, HeatConduction<K, Reference>> {};
struct Plate : Wall<SurfaceTemperature> {};
struct AtPlate : Coupling<Water, Plate, Into<Plate, TemperatureExtrapolation<K>>, HeatTransfer<K>> {};
struct Heater : Wall<HeatFlux> {};
struct AtHeater : Coupling<Water, Heater, Into<Water, HeatFromWalls<K>>> {};

/// Moves particles beside their velocity.
struct Push {
    using reads = Fields<>;
    using sets = Fields<transport_correction>;
    constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        return Vector<T, 2>{{T(0.3), T(0.1)}};
    }
};

/// rho c = 1 J/(m^3 K), k = kappa.
template <class Phase>
Phase with_heat(Phase phase, double kappa, double capacity = 1) {
    phase.set(HeatParameters{.heat_capacity = capacity, .heat_conductivity = kappa, .reference_temperature = 0});
    return phase;
}

/// The sides of the body: the wave goes along the first.
enum class Sides { periodic, free, free_along };
/// How fast a cosine decays in a phase, over kappa k^2: one wave in a periodic length, half of one in a square that is
/// free all around.
template <int dim, class Phase, class Real = double>
double decay(Phase material, double across, Sides sides, double jittered) {
    const double length = 1, spacing = length / across, kappa = 0.1;
    Settings<dim> settings{.support_radius = 3 * spacing, .cfl = 0.4, .threads = 1}; // errors of space, not of time
    Point<dim> size = Point<dim>::Constant(length);
    if (dim == 3)
        size[2] = 8 * spacing;
    if (sides == Sides::free_along)
        size[1] = 10 * spacing;
    for (int d = 0; d < dim; ++d)
        if (sides == Sides::periodic || (sides == Sides::free_along && d == 0))
            settings.periodic_length[static_cast<std::size_t>(d)] = size[d];
    Solver<dim, Real, SymplecticEuler, Phase> scene(settings);
    const double wave = (sides == Sides::free ? 1 : 2) * std::numbers::pi;
    const auto phase =
        scene.add(with_heat(material, kappa),
                  jitter<dim>(fill(Box<dim>{Point<dim>::Zero(), size}, spacing), jittered * spacing, 1), spacing);
    auto view = scene[phase];
    const auto shape = [&](int i) { return std::cos(wave * double(view[position](i, 0))); };
    for (int i = 0; i < view.size(); ++i)
        view[enthalpy](i) = static_cast<Real>(shape(i));
    const double end = 1 / (kappa * sq(wave));
    scene.run_until(end);
    double height = 0;
    for (int i = 0; i < view.size(); ++i)
        height += 2 * double(view[enthalpy](i)) * shape(i) / view.size();
    return -std::log(height);
}

TEST_CASE("A wave of heat decays as it must, in fluids and solids") {
    CHECK(decay<2>(Water{{.density = 1, .sound_speed = 1}}, 24, Sides::periodic, 0) == Approx(1).epsilon(0.01));
    CHECK(decay<2, Water, float>({{.density = 1, .sound_speed = 1}}, 24, Sides::periodic, 0) ==
          Approx(1).epsilon(0.01));
    CHECK(decay<3>(Water{{.density = 1, .sound_speed = 1}}, 24, Sides::periodic, 0) == Approx(1).epsilon(0.01));
    CHECK(decay<2>(Water{{.density = 1, .sound_speed = 1}}, 24, Sides::periodic, 0.2) == Approx(1).epsilon(0.02));
    CHECK(decay<2>(Rubber{{.density = 1, .sound_speed = 1, .shear_modulus = 0.3}}, 24, Sides::periodic, 0) ==
          Approx(1).epsilon(0.01));
}
TEST_CASE("Free surfaces are insulated, and heat flows along them as well as inside") {
    // A strip of ten particles, of which none has all of its neighbours, and a square that half a wave crosses.
    const Water water{{.density = 1, .sound_speed = 1}};
    CHECK(decay<2>(water, 24, Sides::free_along, 0) == Approx(1).epsilon(0.004));
    const double coarse = decay<2>(water, 20, Sides::free, 0), fine = decay<2>(water, 40, Sides::free, 0);
    CHECK(coarse == Approx(1).epsilon(0.005));
    CHECK(std::abs(fine - 1) < 0.6 * std::abs(coarse - 1));
}

TEST_CASE("No heat is lost between two fluids, wherever their particles are") {
    const double spacing = 1.0 / 16;
    Solver<2, double, SymplecticEuler, Water, Oil, Between> scene({.support_radius = 3 * spacing, .threads = 1});
    std::vector<Point<2>> left, right;
    for (const auto& x : jitter<2>(fill(Box<2>{{0, 0}, {1, 1}}, spacing), 0.3 * spacing, 1))
        (x[0] < 0.5 ? left : right).push_back(x);
    const auto water = scene.add(with_heat(Water{{.density = 1, .sound_speed = 1}}, 0.1), left, spacing);
    const auto oil = scene.add(with_heat(Oil{{.density = 3, .sound_speed = 1}}, 2, 0.3), right, spacing);
    std::mt19937 dice(1);
    double size = 0;
    const auto heat_up = [&](const auto& view) {
        for (int i = 0; i < view.size(); ++i) {
            view[enthalpy](i) = static_cast<double>(dice() % 1000) / 1000;
            size += view[mass](i) * view[enthalpy](i);
        }
    };
    heat_up(scene[water]);
    heat_up(scene[oil]);
    const auto all = [&] { return thermal_energy(scene[water]) + thermal_energy(scene[oil]); };
    const double before = all(), of_water = thermal_energy(scene[water]);
    for (int n = 0; n < 200; ++n)
        scene.step();
    CHECK(std::abs(thermal_energy(scene[water]) - of_water) > 1e-3 * size); // some was exchanged
    CHECK(std::abs(all() - before) < 1e-13 * size);
}

TEST_CASE("Two bodies that touch are as warm there as their effusivities say") {
    // T = (e_1 T_1 + e_2 T_2)/(e_1 + e_2), e^2 = k rho c (Carslaw and Jaeger 1959, section 2.15): here 0.8.
    const double spacing = 1.0 / 40, width = 8 * spacing;
    Solver<2, double, SymplecticEuler, Water, Oil, Between> scene(
        {.support_radius = 3 * spacing, .periodic_length = {0, width}, .threads = 1});
    const auto cold = scene.add(with_heat(Water{{.density = 1, .sound_speed = 1}}, 1),
                                fill(Box<2>{{-1, 0}, {0, width}}, spacing), spacing);
    const auto warm = scene.add(with_heat(Oil{{.density = 2, .sound_speed = 1}}, 8),
                                fill(Box<2>{{0, 0}, {1, width}}, spacing), spacing);
    for (int i = 0; i < scene[warm].size(); ++i)
        scene[warm][enthalpy](i) = 1; // J/kg, 1 K
    scene.run_until(0.01);
    const auto near_surface = [&](const auto& view) { // of the layer next to the other
        double sum = 0;
        int n = 0;
        for (int i = 0; i < view.size(); ++i)
            if (std::abs(view[position](i, 0)) < spacing) {
                sum += view[temperature](i);
                ++n;
            }
        return sum / n;
    };
    // The flux is the same on both sides, so the surface is as far from either layer as its share of the resistance.
    const double T = (1 * near_surface(scene[cold]) + 8 * near_surface(scene[warm])) / 9;
    CHECK(T == Approx(0.8).epsilon(0.01));
}

TEST_CASE("Between two walls the temperature is a straight line, and what one gives the other takes") {
    const double spacing = 1.0 / 20, width = 8 * spacing;
    struct Warm : Wall<SurfaceTemperature> {};
    struct AtWarm : Coupling<Water, Warm, Into<Warm, TemperatureExtrapolation<K>>, HeatTransfer<K>> {};
    Solver<2, double, SymplecticEuler, Water, Plate, Warm, AtPlate, AtWarm> scene(
        {.support_radius = 3 * spacing, .max_time_step = 1, .periodic_length = {0, width}, .threads = 1});
    const auto water = scene.add(with_heat(Water{{.density = 1, .sound_speed = 1}}, 1),
                                 fill(Box<2>{{0, 0}, {1, width}}, spacing), spacing);
    Plate plate{{.density = 1}};
    plate.set(SurfaceTemperatureParameters{.surface_temperature = 3});
    Warm warm{{.density = 1}};
    warm.set(SurfaceTemperatureParameters{.surface_temperature = 5});
    const auto left = scene.add(plate, fill(Box<2>{{-3 * spacing, 0}, {0, width}}, spacing), spacing);
    const auto right = scene.add(warm, fill(Box<2>{{1, 0}, {1 + 3 * spacing, width}}, spacing), spacing);
    scene.run_until(2);
    const auto view = scene[water];
    for (int i = 0; i < view.size(); ++i)
        CHECK(view[temperature](i) == Approx(3 + 2 * view[position](i, 0)).margin(0.006));
    const double left_before = thermal_energy(scene[left]), right_before = thermal_energy(scene[right]),
                 before = scene.time();
    scene.run_until(3);
    const double flux = 2 * width * (scene.time() - before); // k 2 K/m times the area, J
    CHECK(thermal_energy(scene[left]) - left_before == Approx(flux).epsilon(0.005));
    CHECK(thermal_energy(scene[right]) - right_before == Approx(-flux).epsilon(0.005));
    CHECK(std::abs(thermal_energy(view) + thermal_energy(scene[left]) + thermal_energy(scene[right])) < 1e-12);
}

TEMPLATE_TEST_CASE_SIG("A wall with a flux gives its area times that", "", ((int dim), dim), 2, 3) {
    const double spacing = 0.125, q = -40;
    Settings<dim> settings{.support_radius = 3 * spacing, .cfl = 0.4, .threads = 1}; // errors of space, not of time
    Point<dim> upper = Point<dim>::Constant(1), below = upper;
    for (int d = 1; d < dim; ++d)
        settings.periodic_length[static_cast<std::size_t>(d)] = 1;
    Point<dim> lower = Point<dim>::Zero();
    lower[0] = -3 * spacing;
    below[0] = 0;
    Solver<dim, double, SymplecticEuler, Water, Heater, AtHeater> scene(settings);
    const auto water = scene.add(with_heat(Water{{.density = 2, .sound_speed = 1}}, 1, 3),
                                 fill(Box<dim>{Point<dim>::Zero(), upper}, spacing), spacing);
    Heater heater{{.density = 1}};
    heater.set(HeatFluxParameters{.heat_flux = q});
    scene.add(heater, fill(Box<dim>{lower, below}, spacing), spacing);
    scene.run_until(0.01);
    CHECK(thermal_energy(scene[water]) == Approx(q * 0.01).epsilon(1e-12));
}

TEST_CASE("Warm fluid rises") {
    struct Air : Fluid<HeatCapacity, HeatConduction<K>, Boussinesq> {};
    Solver<2, double, SymplecticEuler, Air> scene({.gravity = {0, -10}, .support_radius = 3, .threads = 1});
    Air air = with_heat(Air{{.density = 1, .sound_speed = 100}}, 1);
    air.set(BoussinesqParameters{.thermal_expansion = 0.01, .neutral_temperature = -5});
    const auto cell = scene.add(air, {{0, 0}}, 1);
    scene[cell][enthalpy](0) = 15; // K above the reference, 20 above what is neutral
    scene.step(1e-3);
    CHECK(scene[cell][velocity](0, 1) == Approx(-10 * 1e-3 * (1 - 0.01 * 20)).epsilon(1e-12));
    CHECK(scene[cell][velocity](0, 0) == 0);
}

TEST_CASE("A particle that is shifted takes the enthalpy of where it comes") {
    // dh/dt = delta v . grad h: a straight line of enthalpy, particles on a lattice.
    struct Shifted : Fluid<HeatCapacity, Push, EnthalpyAdvection<K>> {};
    Solver<2, double, SymplecticEuler, Shifted> scene({.support_radius = 3, .threads = 1});
    const auto oil =
        scene.add(with_heat(Shifted{{.density = 1, .sound_speed = 1}}, 1), fill(Box<2>{{0, 0}, {9, 9}}, 1), 1);
    auto view = scene[oil];
    for (int i = 0; i < view.size(); ++i)
        view[enthalpy](i) = 2 * view[position](i, 0) - view[position](i, 1);
    scene.step(1e-6);
    for (int i = 0; i < view.size(); ++i)
        if (std::abs(view[position](i, 0) - 4.5) < 0.1 && std::abs(view[position](i, 1) - 4.5) < 0.1)
            CHECK(view[enthalpy_rate](i) == Approx(0.6 - 0.1).epsilon(0.02));
}

TEST_CASE("What melts is as warm as its enthalpy says, from frozen to molten") {
    struct Ice : Fluid<Melting, HeatConduction<K>> {};
    for (const double range : {0.0, 2.0})
        for (const double at_start : {250.0, 300.0}) {
            MeltingParameters water{.solid_heat_capacity = 2,
                                    .liquid_heat_capacity = 4,
                                    .solid_conductivity = 3,
                                    .liquid_conductivity = 1,
                                    .latent_heat = 100,
                                    .melting_temperature = 273,
                                    .melting_range = range,
                                    .reference_temperature = at_start};
            CHECK(water.enthalpy_at(at_start) == Approx(0).margin(1e-12));
            Solver<2, double, SymplecticEuler, Ice> scene({.support_radius = 3, .threads = 1});
            Ice ice{{.density = 1, .sound_speed = 1}};
            ice.set(water);
            const auto block = scene.add(ice, {{0, 0}, {9, 0}, {18, 0}, {27, 0}}, 1);
            auto view = scene[block];
            view[enthalpy](0) = water.enthalpy_at(260);
            view[enthalpy](1) = water.enthalpy_at(273 + 0.25 * range, 0.25);
            view[enthalpy](2) = water.enthalpy_at(280);
            scene.step(1e-6);
            CHECK(view[temperature](0) == Approx(260));
            CHECK(view[temperature](1) == Approx(273 + 0.25 * range));
            CHECK(view[temperature](2) == Approx(280));
            CHECK(view[temperature](3) == Approx(at_start));
            CHECK(view[liquid_fraction](0) == 0);
            CHECK(view[liquid_fraction](1) == Approx(0.25));
            CHECK(view[liquid_fraction](2) == 1);
            CHECK(view[conductivity](0) == 3);
            CHECK(view[conductivity](1) == Approx(2.5));
            CHECK(view[conduction_potential](0) == Approx(-13 * 3));
            CHECK(view[conduction_potential](2) == Approx(range * 2 + (7 - range) * 1));
            // From first melt to last it takes the latent heat.
            CHECK(water.enthalpy_at(273 + range, 1) - water.enthalpy_at(273, 0) == Approx(100));
        }
}

TEST_CASE("Heat that cannot be is refused") {
    Solver<2, double, SymplecticEuler, Water> scene({.support_radius = 3, .threads = 1});
    scene.add(Water{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 1);
    CHECK_THROWS_WITH(scene.step(), imbibe_test::contains("HeatParameters::heat_capacity = -1 J/(kg K) (not given)"));
    struct Ice : Fluid<Melting, HeatConduction<K>> {};
    Solver<2, double, SymplecticEuler, Ice> frozen({.support_radius = 3, .threads = 1});
    Ice ice{{.density = 1, .sound_speed = 1}};
    ice.set(MeltingParameters{.solid_heat_capacity = 2,
                              .liquid_heat_capacity = 4,
                              .solid_conductivity = 3,
                              .liquid_conductivity = 1,
                              .latent_heat = 100,
                              .melting_temperature = 273,
                              .melting_range = 2,
                              .reference_temperature = 274});
    frozen.add(ice, {{0, 0}}, 1);
    CHECK_THROWS_WITH(frozen.step(), imbibe_test::contains("where it is partly molten (273 to 275 K)"));
}

} // namespace heat_test
