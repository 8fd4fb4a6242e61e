// The tension of an interface and the pull at a contact line, summed up over scenes of two liquids whose sums are
// known.
#include "cloud.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/interface/interface_tension.hpp>
#include <imbibe/methods/capillary_fluid.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/under_pressure.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace interface_test {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<UnderPressure<>, WeaklyCompressible<K>, Instead<DensityFloor>, CapillaryFluid<K>> {};
struct Oil : Fluid<UnderPressure<>, WeaklyCompressible<K>, Instead<DensityFloor>, CapillaryFluid<K>> {};
struct Between : CouplingOf<Water, Oil> {};
struct Vessel : Wall<> {};
struct Wet : CouplingOf<Water, Vessel> {};
struct Dry : CouplingOf<Oil, Vessel> {};
template <class Real>
using InVessel = Solver<2, Real, SymplecticEuler, Water, Oil, Vessel, Between, Wet, Dry>;

/// Two layers of 16 spacings each way, dx = 1, in a periodic square or cube; the interface is at half the height.
template <int dim>
auto layers(double tension, double jittered) {
    using Scene = Solver<dim, double, SymplecticEuler, Water, Oil, Between>;
    Settings<dim> settings{.support_radius = 3, .threads = 1};
    settings.periodic_length.fill(16);
    Scene scene(settings);
    std::vector<Point<dim>> below, above;
    const Point<dim> size = Point<dim>::Constant(16);
    for (const auto& x : jitter<dim>(fill(Box<dim>{Point<dim>::Zero(), size}, 1), jittered, 1))
        (x[1] < 8 ? below : above).push_back(x);
    scene.add(Water{{.density = 1, .sound_speed = 20}}, below, 1);
    scene.add(Oil{{.density = 2, .sound_speed = 20}}, above, 1);
    scene.template coupling<Between>().set(InterfaceTensionParameters{.surface_tension = tension});
    return scene;
}

TEMPLATE_TEST_CASE_SIG("The stress of an interface is its tension, along it", "", ((int dim), dim), 2, 3) {
    auto scene = layers<dim>(3, 0);
    scene.step();
    double along = 0, across = 0, area = dim == 2 ? 16 : 256;
    const auto add = [&](const auto& view) {
        for (int i = 0; i < view.size(); ++i) {
            const auto T = view[interface_stress].row(i);
            const double y = view[position](i, 1);
            if (y < 4 || y > 12)
                continue; // that of the other interface, through the periodic sides
            const double V = view[mass](i) / view[density](i);
            along += V * T[0];            // xx
            across += V * std::abs(T[1]); // yy
        }
    };
    add(scene.template get<Water>());
    add(scene.template get<Oil>());
    CHECK(along / area == Approx(3).epsilon(0.01));
    CHECK(across < 1e-10);
}

TEST_CASE("An interface of disorder pulls with no force in sum, and not at all without a tension") {
    auto scene = layers<2>(5, 0.2);
    scene.run_until(0.5);
    Eigen::Vector2d momentum = Eigen::Vector2d::Zero();
    double size = 0;
    const auto add = [&](const auto& view) {
        for (int i = 0; i < view.size(); ++i) {
            const Eigen::Vector2d p = view[mass](i) * view[velocity].row(i).transpose();
            momentum += p;
            size += p.norm();
        }
    };
    add(scene.get<Water>());
    add(scene.get<Oil>());
    CHECK(size > 1); // it moves
    CHECK(momentum.norm() < 1e-13 * size);
    // Far from the interfaces there is no gradient at all.
    auto start = layers<2>(5, 0.2);
    start.step();
    const auto water = start.get<Water>();
    int inside = 0;
    for (int i = 0; i < water.size(); ++i)
        if (water[position](i, 1) > 3.25 && water[position](i, 1) < 4.75) {
            CHECK(water[interface_gradient].row(i).norm() == 0);
            ++inside;
        }
    CHECK(inside > 0);
    auto none = layers<2>(0, 0.2);
    none.step();
    CHECK(none.get<Water>()[interface_stress].norm() == 0);
}

TEST_CASE("A disc under the tension of its interface is under Laplace's pressure") {
    // The jump of the normal force across the interface, from the stress alone: sum_b V_b (T_a + T_b) grad W is the
    // force per volume; along a ray it sums up to sigma/R.
    using Scene = Solver<2, double, SymplecticEuler, Water, Oil, Between>;
    const double spacing = 1.0 / 16;
    Scene scene({.support_radius = 3 * spacing, .threads = 1});
    std::vector<Point<2>> inside, outside;
    for (const auto& x : fill(Box<2>{{-2, -2}, {2, 2}}, spacing))
        (x.norm() < 1 ? inside : outside).push_back(x);
    scene.add(Water{{.density = 1, .sound_speed = 20}}, inside, spacing);
    scene.add(Oil{{.density = 1, .sound_speed = 20}}, outside, spacing);
    scene.coupling<Between>().set(InterfaceTensionParameters{.surface_tension = 1});
    scene.step(1e-6); // from rest, without a pressure: v = dt a
    double work = 0;  // of a growth of all radii by 1: - sum m a . e_r = 2 pi R sigma/R
    const auto add = [&](const auto& view) {
        for (int i = 0; i < view.size(); ++i) {
            const Eigen::Vector2d x = view[position].row(i);
            if (x.norm() < 1.5)
                work -= view[mass](i) * view[velocity].row(i).dot(x.normalized()) / 1e-6;
        }
    };
    add(scene.get<Water>());
    add(scene.get<Oil>());
    CHECK(work == Approx(2 * std::numbers::pi).epsilon(0.03));
}

TEST_CASE("The pull at a contact line is sigma cos theta along the surface, and about sigma sin theta into it") {
    using Scene = InVessel<double>;
    // A wall below y = 0; the fluids meet it at x = 0, in a line that leans by 45 degrees or stands.
    for (const double lean : {0.0, 1.0}) {
        Scene scene({.support_radius = 6, .threads = 1});
        std::vector<Point<2>> left, right;
        for (const auto& x : fill(Box<2>{{-30, 0}, {30, 20}}, 1))
            (x[0] + lean * x[1] < 0 ? left : right).push_back(x);
        scene.add(Water{{.density = 1, .sound_speed = 20}}, left, 1);
        scene.add(Oil{{.density = 1, .sound_speed = 20}}, right, 1);
        scene.add(Vessel{{.density = 1}}, fill(Box<2>{{-40, -8}, {40, 0}}, 1), 1);
        scene.coupling<Between>().set(InterfaceTensionParameters{.surface_tension = 2});
        scene.coupling<Wet>().set(ContactAngleParameters{.contact_angle = std::numbers::pi / 3});
        scene.coupling<Dry>().set(ContactAngleParameters{.contact_angle = 2 * std::numbers::pi / 3});
        scene.step(1e-6);
        double along = 0, into = 0;
        const auto add = [&](const auto& view) {
            for (int i = 0; i < view.size(); ++i) {
                const auto f = view[contact_line_pull].row(i);
                const double share = view[solid_gradient].row(i).norm() * view[mass](i) / view[density](i);
                if (view[position](i, 1) > 7)
                    CHECK(f.norm() == 0);
                along += share * f[0];
                into -= share * f[1];
            }
        };
        add(scene.get<Water>());
        add(scene.get<Oil>());
        CAPTURE(lean);
        CHECK(along == Approx(2 * std::cos(std::numbers::pi / 3)).epsilon(0.002));
        CHECK(into == Approx(2 / std::sqrt(1 + lean * lean)).epsilon(0.1)); // the sine that G shows, not the exact one
    }
    CHECK_THROWS_WITH(ContactAngleParameters{.contact_angle = 60}.check("Wet"),
                      imbibe_test::contains("Wet: ContactAngleParameters::contact_angle = 60 rad; it must be from 0"));
    CHECK_THROWS_WITH(InterfaceTensionParameters{.surface_tension = -1}.check("Between"),
                      imbibe_test::contains("Between: InterfaceTensionParameters::surface_tension = -1 N/m"));
}

TEST_CASE("A solid at the rim of the support pulls at no contact line, in float either") {
    using Scene = InVessel<float>;
    Scene scene({.support_radius = 1, .threads = 1});
    scene.add(Water{{.density = 1, .sound_speed = 20}}, std::vector<Point<2>>{{0, 0}}, 0.1);
    scene.add(Oil{{.density = 1, .sound_speed = 20}}, std::vector<Point<2>>{{0.3, 0.4}}, 0.1);
    scene.add(Vessel{{.density = 1}}, std::vector<Point<2>>{{0, -0.9999999}}, 0.1);
    scene.coupling<Between>().set(InterfaceTensionParameters{.surface_tension = 1});
    scene.step(1e-6);
    const auto water = scene.get<Water>();
    CHECK(water[solid_gradient].norm() > 0);
    CHECK(water[solid_gradient].norm() < 1e-19); // its square is 0
    CHECK(water[solid_direction].norm() < 1e-10);
    CHECK(water[contact_line_pull].norm() < 2.1 * water[interface_gradient].norm());
}

TEST_CASE("A tension whose force is not in both fluids is refused") {
    struct Plain : Fluid<LinearState, WeaklyCompressible<K>> {};
    struct Wrong : CouplingOf<Water, Plain> {};
    Solver<2, double, SymplecticEuler, Water, Plain, Wrong> scene({.support_radius = 3, .threads = 1});
    scene.add(Water{{.density = 1, .sound_speed = 20}}, fill(Box<2>{{0, 0}, {4, 4}}, 1), 1);
    scene.add(Plain{{.density = 1, .sound_speed = 20}}, fill(Box<2>{{4, 0}, {8, 4}}, 1), 1);
    CHECK_THROWS_WITH(scene.step(), imbibe_test::contains("Wrong: InterfaceTension without InterfaceForce"));
}

TEST_CASE("A step is short enough for the capillary waves of two particles") {
    const Water water{{.density = 1, .sound_speed = 20}};
    const Oil oil{{.density = 3, .sound_speed = 20}};
    const TimeStepInput in{.support_radius = 0.3,
                           .spacing = 0.1,
                           .max_speed = 0,
                           .max_acceleration = 0,
                           .dimension = 2,
                           .other_spacing = 0.1};
    CHECK(InterfaceTension<>::time_step_limit(water, oil, in, {.surface_tension = 5}) ==
          Approx(0.4 * std::sqrt(2 * 1e-3 / 5)));
    CHECK(std::isinf(InterfaceTension<>::time_step_limit(water, oil, in, {})));
}

TEST_CASE("A pressure that all of a fluid is under is added to that of its equation of state") {
    Water water{{.density = 1000, .sound_speed = 10}};
    water.set(UnderPressureParameters{.background = 500});
    // What start_hydrostatic asks: at a pressure above the one that all of the fluid is under.
    CHECK(UnderPressure<>::density_at(water, 0) == Approx(1000));
    CHECK(UnderPressure<>::density_at(water, 100) == Approx(1001));
    CHECK_THROWS_WITH(UnderPressureParameters{.background = -1}.check("Water"),
                      imbibe_test::contains("Water: UnderPressureParameters::background = -1 Pa"));
    struct Floored : Fluid<UnderPressure<>, WeaklyCompressible<K>> {};
    Floored floored{{.density = 1000, .sound_speed = 10}};
    UnderPressure<>::check(floored, "Floored");
    floored.set(UnderPressureParameters{.background = 500});
    CHECK_THROWS_WITH(UnderPressure<>::check(floored, "Floored"),
                      imbibe_test::contains("background = 500 Pa beside DensityFloor"));

    auto scene = layers<2>(0, 0);
    scene.get<Water>().material().set(UnderPressureParameters{.background = 7});
    scene.step();
    CHECK(scene.get<Water>()[pressure].mean() == Approx(7));
}

} // namespace interface_test
