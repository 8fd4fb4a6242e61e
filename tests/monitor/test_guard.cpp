// The guard: it leaves good runs alone and names what is wrong with bad ones.
#include "scenes.hpp"

#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace guard_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

/// A field of a program's own that nothing but its own term reads.
struct Temperature : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
    static constexpr std::string_view rate_name = "temperature_rate", rate_unit = "K/s";
};
inline constexpr Temperature temperature{};
struct Cooling {
    using reads = sph::Fields<temperature>;
    using adds = sph::Fields<sph::Rate<Temperature>{}>;
    constexpr auto operator()(const auto& a) const { return -1.0 * a[temperature]; }
};
struct WarmWater : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, Cooling> {};

namespace {

using imbibe_test::contains;

struct Water
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>> {};
using Pool = sph::Solver<2, float, sph::SymplecticEuler, Water, Tank, Sides>;
constexpr double dx = 0.05;

/// A column of water that falls apart in a tank of 1 x 1 m.
Pool pool() {
    Pool scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .cfl = 0.4});
    scene.add(Water{{.density = 1000, .sound_speed = 40}}, sph::fill(sph::Box<2>({0, 0}, {0.4, 0.6}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {1, 1}), dx, 3, sph::Sides::y_high), dx);
    return scene;
}
const sph::PhaseHandle<Water> water{};

/// The Diverged that `run` throws.
template <class Run>
sph::Diverged thrown_by(const Run& run) {
    try {
        run();
    } catch (const sph::Diverged& error) {
        return error;
    }
    FAIL("nothing was thrown");
    throw 0;
}

/// A drop somewhere in or round a box of side 1 m with walls of three layers; the scene takes one short step, and a
/// guard looks at it.
template <int dim>
void drop_at(const sph::Point<dim>& x) {
    sph::Solver<dim, float, sph::SymplecticEuler, Water, Tank, Sides> scene({.support_radius = 2.6 * dx});
    const sph::Point<dim> low = sph::Point<dim>::Zero(), high = sph::Point<dim>::Ones();
    scene.add(Water{{.density = 1000, .sound_speed = 40}}, {x}, dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<dim>(low, high), dx, 3), dx);
    sph::Guard<dim> guard;
    scene.step(1e-9);
    guard.look(scene);
}

template <int>
struct Numbered : sph::Fluid<> {};

using monitor_test::Dust;
using Flight = monitor_test::DustScene<2>;

/// dv_a/dt = k v_a: energy from nowhere.
struct Tailwind {
    using reads = sph::Fields<sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return 2.0 * a[sph::velocity]; }
};
struct Leaf : sph::Fluid<Tailwind> {};
struct Strap : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                          sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped> {};
struct Gale : sph::Solid<Tailwind, sph::Clamped> {};

} // namespace

TEST_CASE("A guard leaves a good run alone", "[guard]") {
    auto watched = pool(), alone = pool();
    sph::Guard<2> guard({.interval = 3, .lower = {-0.2, -0.2}, .upper = {1.2, 1.2}});
    watched.run_until(0.4, guard);
    alone.run_until(0.4);
    REQUIRE(watched.steps() == alone.steps());
    CHECK(watched[water][sph::position] == alone[water][sph::position]);
}

TEST_CASE("A guard knows that steps may be too short for a float's last bit", "[guard]") {
    // Water gains speed in steps of which the first hundreds do not change its place by a bit: it seems to gain energy.
    auto scene = pool();
    const std::array<double, 2> gravity{0, -9.81};
    const double start = sph::potential_energy(scene[water], gravity);
    sph::Guard<2> guard({.interval = 10});
    for (int k = 0; k < 40; ++k) {
        scene.step(1e-6);
        REQUIRE_NOTHROW(guard(scene));
    }
    CHECK(start - sph::potential_energy(scene[water], gravity) < 0.5 * sph::kinetic_energy(scene[water]));
}

TEST_CASE("A guard stops a run whose steps are too long, and says so", "[guard]") {
    auto scene = pool();
    scene.prepare();
    const double limit = scene.time_step_limits().front().seconds;
    sph::Guard<2> guard({.interval = 1});
    const auto error = thrown_by([&] {
        for (int k = 0; k < 2000; ++k) {
            scene.step(4 * limit);
            guard(scene);
        }
    });
    CHECK_THAT(error.what(), contains("times the limit"));
    CHECK_THAT(error.what(), contains("take shorter steps"));
    CHECK(error.steps == scene.steps());
    CHECK(error.time == scene.time());
    CHECK(scene.steps() < 200);
}

TEST_CASE("A guard names the particle that is wrong", "[guard]") {
    auto scene = pool();
    scene.step();
    sph::Guard<2> guard({.lower = {-0.2, -0.2}, .upper = {1.2, 1.2}});
    auto view = scene[water];
    const int i = 17;
    const auto id = std::to_string(view.ids()[i]);
    SECTION("too dense") {
        view[sph::density](i, 0) = 1700;
        const auto error = thrown_by([&] { guard.look(scene); });
        CHECK(error.cause == sph::Cause::wrong_density);
        CHECK_THAT(error.what(), contains("particle " + id + " of phase") && contains("1700 kg/m^3"));
        CHECK(error.position == std::vector<double>{view[sph::position](i, 0), view[sph::position](i, 1)});
    }
    SECTION("outside") {
        view[sph::position](i, 1) = 1.5f;
        const auto error = thrown_by([&] { guard.look(scene); });
        CHECK(error.cause == sph::Cause::left_domain);
        CHECK_THAT(error.what(), contains("particle " + id) && contains("from -0.2 to 1.2 m"));
    }
    SECTION("not a number") {
        view[sph::velocity](i, 1) = std::numeric_limits<float>::quiet_NaN();
        const auto error = thrown_by([&] { guard.look(scene); });
        CHECK(error.cause == sph::Cause::not_finite);
        CHECK_THAT(error.what(), contains("particle " + id) && contains("velocity"));
    }
    SECTION("not a number, in a field that nothing else reads") {
        sph::Solver<2, float, sph::SymplecticEuler, WarmWater> warm({.support_radius = 2.6 * dx});
        const auto phase = warm.add(WarmWater{{.density = 1000, .sound_speed = 40}},
                                    sph::fill(sph::Box<2>({0, 0}, {0.4, 0.6}), dx), dx);
        warm[phase][temperature].setConstant(300);
        warm.step();
        guard.look(warm);
        warm[phase][temperature](7) = std::numeric_limits<float>::infinity();
        const auto error = thrown_by([&] { guard.look(warm); });
        CHECK(error.cause == sph::Cause::not_finite);
        CHECK_THAT(error.what(), contains("has a temperature that is not finite"));
    }
    SECTION("not a number, at a glance") {
        view[sph::velocity](i + 1, 0) = 70; // the fastest is another one
        scene.step();
        scene[water][sph::velocity](i, 1) = std::numeric_limits<float>::quiet_NaN();
        const auto wrong = std::to_string(scene[water].ids()[i]);
        const auto error = thrown_by([&] { sph::Guard<2>({.interval = 1000})(scene); });
        CHECK(error.cause == sph::Cause::not_finite);
        CHECK_THAT(error.what(), contains("particle " + wrong + " of phase"));
    }
    SECTION("not a number, at a glance, with nothing fast") {
        view[sph::velocity](i, 1) = std::numeric_limits<float>::quiet_NaN();
        scene.step(1e-5);
        const auto error = thrown_by([&] { sph::Guard<2>({.interval = 1000})(scene); });
        CHECK(error.cause == sph::Cause::not_finite);
    }
    SECTION("faster than sound") {
        view[sph::velocity](i, 0) = 70;
        scene.step();
        const auto error = thrown_by([&] { guard(scene); });
        CHECK(error.cause == sph::Cause::too_fast);
        CHECK_THAT(error.what(), contains("particle " + id) && contains("times its sound speed"));
    }
}

TEST_CASE("A guard keeps the bounds that it is given", "[guard]") {
    auto scene = pool();
    scene.step();
    auto view = scene[water];
    const int i = 17;
    const sph::Guard<2> usual;
    SECTION("too thin") {
        view[sph::density](i, 0) = 400;
        const auto error = thrown_by([&] { sph::Guard<2>(usual).look(scene); });
        CHECK(error.cause == sph::Cause::wrong_density);
        CHECK_THAT(error.what(), contains("400 kg/m^3"));
    }
    SECTION("narrower bounds of the density") {
        for (const float rho : {950.f, 1050.f}) {
            view[sph::density](i, 0) = rho;
            CHECK_NOTHROW(sph::Guard<2>(usual).look(scene));
            const auto error =
                thrown_by([&] { sph::Guard<2>({.least_density = 0.96, .greatest_density = 1.04}).look(scene); });
            CHECK(error.cause == sph::Cause::wrong_density);
        }
    }
    SECTION("half the speed of sound") {
        view[sph::velocity](i, 0) = 30;
        scene.step();
        CHECK_NOTHROW(sph::Guard<2>(usual).look(scene));
        CHECK(thrown_by([&] { sph::Guard<2>({.speed = 0.5}).look(scene); }).cause == sph::Cause::too_fast);
    }
}

TEST_CASE("A guard's domain is in the coordinates of the world", "[guard]") {
    Flight scene({.support_radius = 0.1, .time_step = 0.01, .origin = {100, 50}});
    scene.add(Dust{{.density = 1, .sound_speed = 100}}, {{100.5, 50.5}}, 0.05);
    scene.step();
    CHECK_NOTHROW(sph::Guard<2>({.lower = {100, 50}, .upper = {101, 51}}).look(scene));
    for (const auto& bounds : {sph::GuardSettings<2>{.lower = {100.6, 50}, .upper = {101, 51}},
                               sph::GuardSettings<2>{.lower = {100, 50}, .upper = {101, 50.4}}}) {
        const auto error = thrown_by([&] { sph::Guard<2>(bounds).look(scene); });
        CHECK(error.cause == sph::Cause::left_domain);
        CHECK(error.position[0] == Approx(100.5));
    }
}

TEST_CASE("A guard notices a particle that is on its way through a wall, and none that stands in a corner", "[guard]") {
    CHECK_NOTHROW(drop_at<2>({0.5, dx / 2}));          // at a wall, as a layer of water
    CHECK_NOTHROW(drop_at<2>({0.5, -0.1 * dx}));       // pressed a little behind its face
    CHECK_NOTHROW(drop_at<2>({-0.2 * dx, -0.2 * dx})); // pressed into a corner
    for (const double depth : {1.0, 1.3, 1.6, 2.0}) {
        const auto error = thrown_by([&] { drop_at<2>({0.5, -depth * dx}); });
        CHECK(error.cause == sph::Cause::inside_wall);
        CHECK_THAT(error.what(), contains("Water") && contains("Tank") && contains("inside"));
        CHECK(error.position[1] == Approx(-depth * dx).epsilon(1e-5));
    }
}

TEST_CASE("A guard notices it in space, too, and where the particle has just left a periodic side", "[guard]") {
    CHECK_NOTHROW(drop_at<3>({-0.2 * dx, -0.2 * dx, -0.2 * dx})); // a fifth of a spacing behind each of three walls
    CHECK(thrown_by([&] { drop_at<3>({0.5, 0.5, -1.5 * dx}); }).cause == sph::Cause::inside_wall);

    Pool scene({.support_radius = 2.6 * dx, .periodic_length = {1, 0}, .search_interval = 100});
    const auto drop = scene.add(Water{{.density = 1000, .sound_speed = 40}}, {{0.9995, -1.5 * dx}}, dx);
    scene.add(Tank{{.density = 1000}}, sph::fill(sph::Box<2>({0, -3 * dx}, {1, 0}), dx), dx);
    scene[drop][sph::velocity](0, 0) = 1;
    scene.step(1e-3);
    REQUIRE(scene[drop][sph::position](0, 0) > 1); // not moved back into the box yet
    sph::Guard<2> guard;
    CHECK(thrown_by([&] { guard.look(scene); }).cause == sph::Cause::inside_wall);
}

TEST_CASE("A guard notices energy without work, and not what falls or leaves", "[guard]") {
    const std::vector<sph::Point<2>> row{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    sph::Solver<2, double, sph::SymplecticEuler, Leaf> leaves({.support_radius = 0.1, .time_step = 0.01});
    const auto leaf = leaves.add(Leaf{{.density = 1, .sound_speed = 100}}, row, 0.05);
    leaves[leaf][sph::velocity].col(0).setConstant(1);
    sph::Guard<2> guard;
    const auto error = thrown_by([&] { leaves.run_until(1, guard); });
    CHECK(error.cause == sph::Cause::energy);
    CHECK(error.position.empty());
    CHECK(error.time == Approx(0.06).margin(0.06)); // kinetic energy grows as exp(4 t): a fifth of it after 0.056 s

    Flight stones({.gravity = {0, -9.81}, .support_radius = 0.1, .time_step = 0.01});
    const auto stone = stones.add(Dust{{.density = 1, .sound_speed = 100}}, row, 0.05);
    sph::Guard<2> calm({.interval = 2});
    stones.run_until(2, [&](auto& scene) {
        if (scene.steps() % 50 == 49)
            scene.remove_if(stone, [&](const auto& x) { return x[0] < 0.015 * static_cast<double>(scene.steps()); });
        calm(scene);
    });
    CHECK(stones.particles() == 1);

    // Rain: what has fallen out is let fall again from above, so that as many go as come.
    Flight rain({.gravity = {0, -9.81}, .support_radius = 0.1, .time_step = 0.01});
    const auto drop = rain.add(Dust{{.density = 1, .sound_speed = 100}}, row, 0.05);
    sph::Guard<2> umbrella({.interval = 1});
    int fallen = 0;
    rain.run_until(2, [&](auto& scene) {
        if (scene[drop][sph::position].col(1).minCoeff() < -1) {
            scene.remove_if(drop, [](const auto& x) { return x[1] < -1; });
            scene.add(Dust{{.density = 1, .sound_speed = 100}}, row, 0.05);
            ++fallen;
        }
        umbrella(scene);
    });
    CHECK(fallen == 4);
}

TEST_CASE("A guard takes what a turning gravity does for no energy from nowhere, and looks again once it stays",
          "[guard]") {
    const std::vector<sph::Point<2>> row{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    Flight stones({.gravity = {0, -1}, .support_radius = 0.1, .time_step = 0.01});
    stones.add(Dust{{.density = 1, .sound_speed = 100}}, row, 0.05);
    const auto turn = [](auto& scene) {
        const double angle = 4 * scene.time();
        scene.set_gravity({std::sin(angle), -std::cos(angle)});
    };
    sph::Guard<2> guard({.interval = 1});
    stones.run_until(2, turn, guard);

    sph::Solver<2, double, sph::SymplecticEuler, Leaf> leaves(
        {.gravity = {0, -1}, .support_radius = 0.1, .time_step = 0.01});
    const auto leaf = leaves.add(Leaf{{.density = 1, .sound_speed = 100}}, row, 0.05);
    leaves[leaf][sph::velocity].col(0).setConstant(1);
    sph::Guard<2> again({.interval = 1});
    leaves.run_until(0.2, turn, again);
    const auto error = thrown_by([&] { leaves.run_until(1, again); });
    CHECK(error.cause == sph::Cause::energy);
    CHECK(error.time > 0.2);
    CHECK_THAT(error.what(), contains("GuardSettings::energy is to be infinite"));
}

TEST_CASE("A guard takes what grips do that the program moves for no energy from nowhere", "[guard]") {
    sph::Solver<2, double, sph::SymplecticEuler, Strap> scene({.support_radius = 2 * dx});
    const auto strap = scene.add(Strap{{.density = 1000, .sound_speed = 30, .shear_modulus = 3e5}},
                                 sph::fill(sph::Box<2>({0, 0}, {0.5, 0.2}), dx), dx);
    scene.hold(strap, [](const auto& x) { return x[0] > 0.4; });
    sph::Guard<2> guard({.interval = 1});
    const double speed = 0.5;
    while (scene.time() < 0.1) {
        auto view = scene[strap];
        const double dt = scene.next_step().seconds;
        for (int i = 0; i < view.size(); ++i)
            if (view[sph::mobility](i) == 0) {
                view[sph::velocity](i, 0) = speed;
                view[sph::position](i, 0) += speed * dt;
            }
        scene.step(dt);
        REQUIRE_NOTHROW(guard(scene));
    }
    CHECK(sph::kinetic_energy(scene[strap]) > 5); // the strap comes along

    // What is held and stays is no excuse.
    sph::Solver<2, double, sph::SymplecticEuler, Gale> leaves({.support_radius = 0.1, .time_step = 0.01});
    const auto leaf = leaves.add(Gale{{.density = 1, .sound_speed = 100, .shear_modulus = 1}}, {{0, 0}, {1, 0}}, 0.05);
    leaves[leaf][sph::velocity].col(0).setConstant(1);
    leaves.hold(leaf, [](const auto& x) { return x[0] > 0.5; });
    CHECK(thrown_by([&] { leaves.run_until(1, sph::Guard<2>({.interval = 1})); }).cause == sph::Cause::energy);
}

TEST_CASE("The domain of a guard is that of what moves: walls reach out of it", "[guard]") {
    Pool scene = pool();
    sph::Guard<2> guard({.lower = {-dx, -dx}, .upper = {1 + dx, 1 + dx}});
    guard.look(scene);
    scene.run_until(0.05, guard);
    scene[water][sph::position](0, 0) = -1.5F * float(dx);
    CHECK(thrown_by([&] { guard.look(scene); }).cause == sph::Cause::left_domain);
}

TEST_CASE("A guard tells phases of one name apart", "[guard]") {
    sph::Solver<2, double, sph::SymplecticEuler, Numbered<0>, Numbered<1>> scene({.support_radius = 0.1});
    scene.add(Numbered<0>{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 0.05);
    scene.add(Numbered<1>{{.density = 1, .sound_speed = 1}}, {{1, 5}}, 0.05);
    scene.step(1e-3);
    const auto error = thrown_by([&] { sph::Guard<2>({.upper = {2, 2}}).look(scene); });
    CHECK(error.phase == "Numbered_2");
    CHECK_THAT(error.what(), contains("of phase Numbered_2"));
}

TEST_CASE("A guard that begins where stress is stored knows what it may release", "[guard]") {
    struct Beam : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                             sph::TotalLagrangianForce<K>, sph::Clamped> {};
    struct Averaged : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::VolumetricDeviatoric<>,
                                 sph::TotalLagrangianForce<K>, sph::Clamped> {};
    // A beam that swings under its weight, watched from about the lowest point on.
    const auto swing = []<class Body>(std::type_identity<Body>, double energy) {
        const double spacing = 2.5e-3, E = 2e7, nu = 0.3, rho = 1100;
        sph::Solver<2, double, sph::SymplecticEuler, Body> scene(
            {.gravity = {0, -9.81}, .support_radius = 2 * spacing, .threads = 1});
        const auto beam = scene.add(Body{{.density = rho,
                                          .sound_speed = sph::sound_speed_of(E, nu, rho),
                                          .shear_modulus = sph::shear_modulus_of(E, nu)}},
                                    sph::fill(sph::Box<2>({-2 * spacing, -0.005}, {0.2, 0.005}), spacing), spacing);
        scene.hold(beam, [](const auto& x) { return x[0] < 0; });
        double lowest = 0;
        while (scene[beam][sph::position].col(1).minCoeff() <= lowest) {
            lowest = scene[beam][sph::position].col(1).minCoeff();
            scene.run_until(scene.time() + 2e-3);
        }
        const double kinetic = sph::kinetic_energy(scene[beam]);
        scene.run_until(scene.time() + 0.04, sph::Guard<2>({.energy = energy}));
        return sph::kinetic_energy(scene[beam]) / std::max(kinetic, 1e-12);
    };
    CHECK(swing(std::type_identity<Beam>{}, 0.2) > 10); // it came back up, faster and higher than it was then
    CHECK(swing(std::type_identity<Beam>{}, 0.05) > 10);
    CHECK(swing(std::type_identity<Averaged>{}, 0.2) > 10); // whose law says nothing of its energy
}

TEST_CASE("A guard does not take the ends of a periodic side for a fall or for a way out", "[guard]") {
    using Plume = monitor_test::DustScene<2>;
    const std::vector<sph::Point<2>> row{{0, 0.5}, {0.25, 0.5}, {0.5, 0.5}, {0.75, 0.5}};
    const auto run = [&](std::array<double, 2> gravity) { // once round and some more, in steps of 0.02 m
        Plume scene({.gravity = gravity,
                     .support_radius = 0.1,
                     .time_step = 0.02,
                     .periodic_length = {1, 0},
                     .search_interval = 20});
        const auto stone = scene.add(Dust{{.density = 1, .sound_speed = 100}}, row, 0.05);
        scene[stone][sph::velocity].col(0).setConstant(1);
        bool outside = false;
        scene.run_until(1.5, sph::Guard<2>({.interval = 1, .lower = {0, -20}, .upper = {1, 1}}),
                        [&](const auto& s) { outside = outside || s[stone][sph::position].col(0).maxCoeff() > 1; });
        return outside;
    };
    CHECK(run({0, 0})); // so that there was something to be taken amiss
    CHECK_NOTHROW(run({1, 0}));
    CHECK_NOTHROW(run({0, -1}));
    // The other side still has its ends.
    CHECK(thrown_by([&] { run({0, 1}); }).cause == sph::Cause::left_domain);
    // And energy from nowhere is still noticed where gravity does not drive the flow round.
    sph::Solver<2, double, sph::SymplecticEuler, Leaf> leaves(
        {.gravity = {0, -1}, .support_radius = 0.1, .time_step = 0.01, .periodic_length = {1, 0}});
    const auto leaf = leaves.add(Leaf{{.density = 1, .sound_speed = 100}}, row, 0.05);
    leaves[leaf][sph::velocity].col(0).setConstant(1);
    CHECK(thrown_by([&] { leaves.run_until(1, sph::Guard<2>()); }).cause == sph::Cause::energy);
}

TEST_CASE("A guard that stops before the first step speaks of the start, and later of leaks", "[guard]") {
    const auto told = [](const sph::Point<2>& x, bool step, const sph::GuardSettings<2>& bounds) {
        Pool scene({.support_radius = 2.6 * dx});
        scene.add(Water{{.density = 1000, .sound_speed = 40}}, {x}, dx);
        scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {1, 1}), dx, 3), dx);
        scene.prepare();
        if (step)
            scene.step(1e-9);
        sph::Guard<2> guard(bounds);
        return std::string(thrown_by([&] { guard.look(scene); }).what());
    };
    const sph::Point<2> in_the_wall{0.5, -1.5 * dx}, outside{0.5, 1.2};
    CHECK_THAT(told(in_the_wall, false, {}),
               contains("overlap as they were added") && !contains("Look at how the scene starts"));
    CHECK_THAT(told(in_the_wall, false, {}), !contains("KernelRepulsion"));
    CHECK_THAT(told(in_the_wall, true, {}), contains("KernelRepulsion"));
    const sph::GuardSettings<2> bounds{.lower = {-0.2, -0.2}, .upper = {1.19, 1.19}};
    CHECK_THAT(told(outside, false, bounds), contains("before the first step"));
    CHECK_THAT(told(outside, true, bounds), contains("fewer layers") && contains("a phase without a coupling"));
}

TEST_CASE("A guard can be made with nothing, with braces and with bounds", "[guard]") {
    auto scene = pool();
    scene.prepare();
    CHECK_NOTHROW(sph::Guard<2>().look(scene));
    CHECK_NOTHROW(sph::Guard<2>({}).look(scene));
    const sph::GuardSettings<2> bounds;
    CHECK_NOTHROW(sph::Guard<2>(bounds).look(scene));
    CHECK_NOTHROW(sph::Guard(bounds).look(scene));
    sph::Guard<2> one({.upper = {0.1, 0.1}});
    sph::Guard<2> copy(one);
    CHECK_THROWS_AS(copy.look(scene), sph::Diverged);
}

TEST_CASE("Bounds of a guard that make no sense are refused", "[guard]") {
    REQUIRE_THROWS_WITH(sph::Guard<2>({.interval = 0}), contains("interval = 0"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.speed = -1}), contains("-1 sound speeds"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.least_density = 1.2}), contains("1.2"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.lower = {0, 2}, .upper = {1, 1}}), contains("begins at 2 m"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.energy = 0}), contains("energy = 0"));
}

} // namespace guard_test
