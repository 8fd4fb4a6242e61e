// What a host does to a scene between steps is seen: walls that it moves, fields and gravity that it sets, numbers that
// are none; and what is doubtful about a scene is said before it runs.
#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>
#include <scene_bits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace hosts_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.05, nan = std::numeric_limits<double>::quiet_NaN();

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Oil : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Tank : sph::Wall<> {};
struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                           sph::TotalLagrangianForce<K>> {};
struct Strap : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                          sph::TotalLagrangianForce<K>, sph::Clamped> {};
/// Water that remembers where it came in, and has no neighbours by that.
struct Marked : sph::Fluid<sph::Displacement> {};
template <class Liquid>
struct Sides : sph::Coupling<Liquid, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Liquid, sph::VolumeContinuity<K>>> {};
const Water water{{.density = 1000, .sound_speed = 10}};

using Pool = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides<Water>>;

sph::Settings<2> settings(int interval = 1, double skin = 0) {
    return {.support_radius = 2.6 * dx, .search_interval = interval, .search_skin = skin, .threads = 1};
}
std::vector<sph::Point<2>> block(double x, double y, double width, double height) {
    return sph::fill(sph::Box<2>{{x, y}, {x + width, y + height}}, dx);
}

/// The water's mean velocity after a wall that was out of its reach has been driven into it.
double pushed(int interval, double skin) {
    Pool scene(settings(interval, skin));
    const auto pool = scene.add(water, block(0, 0, 0.5, 0.3), dx);
    const auto wall = scene.add(Tank{{.density = 1000}}, block(-0.35, 0, 0.15, 0.3), dx);
    for (int k = 0; k < 300; ++k) {
        scene[wall][sph::position].col(0).array() += 1e-3;
        scene[wall][sph::velocity].col(0).setConstant(1);
        scene.step(1e-3);
    }
    return scene[pool][sph::velocity].col(0).mean();
}

TEST_CASE("A wall that the host moves is found by lists that may serve many steps", "[hosts]") {
    const double known = pushed(1, 0);
    CHECK(known > 0.3);
    CHECK(pushed(1000, 0.1) == Approx(known).epsilon(1e-9)); // nothing is missed
    CHECK(pushed(1000, 0) == Approx(known).epsilon(0.02));   // but what is at the rim of the support
}

struct Syrup : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {
};
struct Sticky : sph::Coupling<Syrup, Tank, sph::Into<Tank, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};

TEST_CASE("The speed of a wall counts in limits as soon as the host has set it", "[hosts]") {
    sph::Solver<2, double, sph::SymplecticEuler, Syrup, Tank, Sticky> scene(settings());
    scene.add(Syrup{{.density = 1000, .sound_speed = 10, .viscosity = 1}}, block(0, 0, 0.3, 0.3), dx);
    const auto wall = scene.add(Tank{{.density = 1000}}, block(0, -0.15, 0.3, 0.15), dx);
    scene.step();
    CHECK(scene.engine().motion_now<Tank>().speed == 0);
    scene[wall][sph::velocity].col(0).setConstant(3);
    CHECK(scene.engine().motion_now<Tank>().speed == 3);
    scene.step(); // speeds are measured against the wall
    CHECK(scene.engine().motion_now<Tank>().speed == 0);
    CHECK(scene.engine().motion<Syrup>().speed == Approx(3).epsilon(0.1));
}

template <class Integrator>
void check_late_fields() {
    const auto first_step = [](bool late) {
        sph::Solver<2, double, Integrator, Water> scene(settings());
        const auto pool = scene.add(water, block(0, 0, 0.5, 0.5), dx);
        if (late)
            scene.prepare();
        const auto x = scene[pool][sph::position];
        for (int i = 0; i < scene[pool].size(); ++i) {
            scene[pool][sph::velocity](i, 0) = 100 * std::sin(20 * x(i, 1));
            scene[pool][sph::density](i) = 1000 + 10 * std::cos(20 * x(i, 0));
        }
        const double dt = scene.step();
        return std::pair(dt, scene[pool][sph::velocity].cwiseAbs().sum());
    };
    const auto early = first_step(false), late = first_step(true);
    CHECK(early.first < 5e-4); // sound alone would allow 1e-2
    CHECK(late.first == early.first);
    CHECK(late.second == Approx(early.second).epsilon(1e-12)); // the accelerations a step begins with as well
}
TEST_CASE("Fields that are set after a look at the scene count in the first step", "[hosts]") {
    check_late_fields<sph::SymplecticEuler>();
    check_late_fields<sph::Leapfrog>();
    check_late_fields<sph::PredictorCorrector>();
}

template <int dim>
void check_feeder(const sph::Settings<dim>& with) {
    using Vector = sph::Point<dim>;
    const double spacing = 0.1, side = 0.3, g = 10, H = 0.2;
    const Rubber rubber{{.density = 1000, .sound_speed = 30, .shear_modulus = 2e5}};
    sph::Settings<dim> settings = with;
    settings.support_radius = H;
    settings.gravity[1] = -g;
    settings.time_step = 1e-3;
    sph::Solver<dim, double, sph::SymplecticEuler, Rubber> scene(settings);
    const Vector origin = Eigen::Map<const Vector>(settings.origin.data());
    const auto body = [&](const Vector& from) {
        return sph::fill(sph::Box<dim>(from, from + Vector::Constant(side)), spacing);
    };
    const auto rubbers = scene.add(rubber, body(origin), spacing);
    const int n = scene[rubbers].size();

    // Before anything has moved a second call makes the body longer.
    CHECK_NOTHROW(scene.add(rubber, body(origin + side * Vector::Unit(1)), spacing));
    scene.run_until(0.5); // by 1.25 m
    for (const double up : {0.0, 0.013, -H - 0.05 + 0.01})
        CHECK_THROWS_WITH(scene.add(rubber, body(origin + up * Vector::Unit(1)), spacing),
                          imbibe_test::contains("one body that is torn apart") &&
                              imbibe_test::contains("at least the support radius of 0.2 m"));
    REQUIRE(scene[rubbers].size() == 2 * n);

    // Where none was it falls by itself; and shifted as a whole it is not strained.
    const Vector far = origin + 2 * side * Vector::Unit(1) + (H + 0.01) * Vector::Unit(1);
    CHECK_NOTHROW(scene.add(rubber, body(far), spacing));
    auto view = scene[rubbers];
    view[sph::position].bottomRows(n).rowwise() += (origin - far).transpose();
    scene.run_until(0.8);
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i < 3 * n; ++i)
        if (scene[rubbers].ids()[static_cast<std::size_t>(i)] >= static_cast<unsigned>(2 * n)) {
            lowest = std::min(lowest, scene[rubbers][sph::velocity](i, 1));
            highest = std::max(highest, scene[rubbers][sph::velocity](i, 1));
        }
    CHECK(lowest == Approx(-3).epsilon(1e-6));
    CHECK(highest == Approx(-3).epsilon(1e-6));
}
TEST_CASE("A body is not added where another of its total-Lagrangian phase was when it was free of stress", "[hosts]") {
    check_feeder<2>({.threads = 1});
    check_feeder<2>({.origin = {3, -4}, .threads = 1});
    check_feeder<3>({.threads = 1});
}

TEST_CASE("Nor is it across a periodic side, or where a body has been shifted before the first step", "[hosts]") {
    const double spacing = 0.1;
    const Rubber rubber{{.density = 1000, .sound_speed = 30, .shear_modulus = 2e5}};
    sph::Solver<2, double, sph::SymplecticEuler, Rubber> scene({.support_radius = 0.2, .periodic_length = {2, 2}});
    const auto body = scene.add(rubber, sph::fill(sph::Box<2>({0, 0}, {0.3, 0.3}), spacing), spacing);
    const auto beside = sph::fill(sph::Box<2>({1.7, 1.7}, {2, 2}), spacing);
    scene[body][sph::position].col(0).array() += 0.02; // a tenth of 0.14 m is less
    CHECK_THROWS_WITH(scene.add(rubber, beside, spacing), imbibe_test::contains("torn apart"));
    scene[body][sph::position].col(0).array() -= 0.015;
    CHECK_NOTHROW(scene.add(rubber, beside, spacing));
}

TEST_CASE("Water that only remembers where it came in may come in there again", "[hosts]") {
    sph::Solver<2, double, sph::SymplecticEuler, Marked> scene({.support_radius = 2 * dx, .time_step = 0.01});
    const Marked marked{{.density = 1000, .sound_speed = 10}};
    for (int k = 0; k < 3; ++k) {
        CHECK_NOTHROW(scene.add(marked, {{0, 0}}, dx));
        scene.get<Marked>()[sph::velocity].col(0).setConstant(10);
        scene.step();
    }
    CHECK(scene.get<Marked>()[sph::displacement].col(0).maxCoeff() > 0.1);
}

TEST_CASE("What holds particles bears minus the sum of their masses times their accelerations", "[hosts]") {
    const double spacing = 0.1, dt = 1e-4, g = 10;
    sph::Solver<2, double, sph::SymplecticEuler, Strap> scene(
        {.gravity = {0, -g}, .support_radius = 0.2, .time_step = dt, .threads = 1});
    const auto strap = scene.add(Strap{{.density = 1000, .sound_speed = 30, .shear_modulus = 2e5}},
                                 sph::fill(sph::Box<2>({0, 0}, {0.3, 1}), spacing), spacing);
    scene.hold(strap, [](const auto& x) { return x[1] < 0.2 || x[1] > 0.8; });
    const auto view = scene[strap];
    const double weight = view[sph::mass].sum() * g;
    double before = 0, pull = 0;
    for (int k = 0; k < 100; ++k) {
        for (int i = 0; i < view.size(); ++i) // the upper grip is moved, which pulls
            if (view[sph::mobility](i) == 0 && view[sph::reference_position](i, 1) > 0.5)
                view[sph::position](i, 1) += 0.1 * dt;
        scene.step();
        double momentum = 0, held = 0;
        for (int i = 0; i < view.size(); ++i)
            if (view[sph::mobility](i) == 0)
                held -= view[sph::mass](i) * view[sph::acceleration](i, 1);
            else
                momentum += view[sph::mass](i) * view[sph::velocity](i, 1);
        REQUIRE(momentum - before == Approx(dt * (held - weight)).margin(1e-12 * weight));
        before = momentum;
        pull = std::max(pull, std::abs(held / weight - 1));
    }
    CHECK(pull > 0.1);
}

TEST_CASE("What an observer adds to a run is prepared as what a host adds between steps", "[hosts]") {
    const auto run = [](auto by_observer) {
        const double spacing = 0.1;
        const Rubber rubber{{.density = 1000, .sound_speed = 30, .shear_modulus = 2e5}};
        sph::Solver<2, double, sph::SymplecticEuler, Rubber> scene(
            {.gravity = {0, -9.81}, .support_radius = 2.6 * spacing, .time_step = 1e-4, .threads = 1});
        const auto block = scene.add(rubber, sph::fill(sph::Box<2>({0, 0}, {1, 1}), spacing), spacing);
        scene[block][sph::velocity].col(0) = 0.1 * scene[block][sph::position].col(0);
        const auto add = [&](auto& s) {
            if (s.steps() == 3)
                s.add(rubber, sph::fill(sph::Box<2>({5, 0}, {6, 1}), spacing), spacing);
        };
        if constexpr (by_observer)
            scene.run_until(19.5e-4, add);
        else
            while (scene.time() < 19.5e-4) {
                add(scene);
                scene.step(std::min(1e-4, 19.5e-4 - scene.time()));
            }
        return imbibe_test::bits_of(scene);
    };
    CHECK((run(std::true_type{}) == run(std::false_type{})));
}

TEST_CASE("Drops that are far away change nothing for the others", "[hosts]") {
    struct Pond : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
    const auto run = [](double far_away) {
        const double spacing = 0.01;
        sph::Solver<2, double, sph::SymplecticEuler, Pond> scene(
            {.support_radius = 2.6 * spacing, .time_step = 1e-4, .search_interval = 3, .threads = 2});
        auto points = sph::fill(sph::Box<2>({0, 0}, {0.6, 0.6}), spacing);
        const std::size_t count = points.size();
        if (far_away > 0) {
            points.push_back({far_away, far_away}); // in the list of cells they are where others are
            points.push_back({far_away, far_away + spacing});
            points.push_back({-far_away, far_away});
        }
        const auto pond = scene.add(Pond{{.density = 1000, .sound_speed = 20}}, points, spacing);
        const Eigen::MatrixXd x = scene[pond][sph::position];
        scene[pond][sph::velocity].col(0) = (x.col(1) * 40).array().sin().matrix();
        for (int k = 0; k < 10; ++k)
            scene.step();
        Eigen::MatrixXd places(static_cast<Eigen::Index>(count), 2);
        for (int i = 0; i < scene[pond].size(); ++i)
            if (const auto id = scene[pond].ids()[static_cast<std::size_t>(i)]; id < count)
                places.row(id) = scene[pond][sph::position].row(i);
        return places;
    };
    const Eigen::MatrixXd alone = run(0);
    for (const double far_away : {1e2, 1e5, 1e9})
        CHECK((run(far_away) - alone).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("Gravity may change during a run", "[hosts]") {
    sph::Solver<2, double, sph::SymplecticEuler, Water> scene(settings());
    const auto drop = scene.add(water, {{0, 0}}, dx);
    scene.step(0.1);
    CHECK(scene[drop][sph::velocity](0, 1) == 0);
    scene.set_gravity({1, -10});
    CHECK(scene.settings().gravity[1] == -10);
    scene.step(0.1);
    CHECK(scene[drop][sph::velocity](0, 0) == Approx(0.1));
    CHECK(scene[drop][sph::velocity](0, 1) == Approx(-1));
    REQUIRE_THROWS_WITH(scene.set_gravity({0, nan}), imbibe_test::contains("gravity"));
    CHECK(scene.settings().gravity[0] == 1);
}

TEST_CASE("Numbers that are none end a run in a periodic box too", "[hosts]") {
    const auto disturbed = [](auto field, double value) {
        auto s = settings();
        s.periodic_length = {1, 1};
        sph::Solver<2, double, sph::SymplecticEuler, Water> scene(s);
        const auto pool = scene.add(water, block(0, 0, 1, 1), dx);
        scene.step();
        scene[pool][field](7, 1) = value;
        for (int k = 0; k < 3; ++k)
            scene.step();
    };
    for (const double bad : {nan, std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_WITH(disturbed(sph::position, bad), imbibe_test::contains("not a finite number"));
    REQUIRE_THROWS_WITH(disturbed(sph::velocity, nan), imbibe_test::contains("not a finite number"));
    REQUIRE_THROWS_WITH(disturbed(sph::velocity, std::numeric_limits<double>::infinity()),
                        imbibe_test::contains("is 0 s"));
}

TEST_CASE("The end of a run leaves no step of round-off, and must be a number", "[hosts]") {
    auto s = settings();
    s.time_step = 1e-5; // a hundred thousand of them come to 1 - 2e-12
    sph::Solver<2, double, sph::SymplecticEuler, Water> scene(s);
    scene.add(water, {{0, 0}}, dx);
    scene.run_until(1);
    CHECK(scene.steps() == 100'000);
    CHECK(scene.time() == Approx(1).epsilon(1e-12));
    CHECK(scene.last_step().reason == "fixed");
    scene.run_until(1 + 0.5e-5);
    CHECK(scene.last_step().reason == "end of run");
    REQUIRE_THROWS_WITH(scene.run_until(nan), imbibe_test::contains("run_until(nan)"));
}

TEST_CASE("What a host sets after prepare() counts in the first step, what is computed once included", "[hosts]") {
    const auto sum_after = [](bool prepared, auto change) {
        sph::Solver<2, double, sph::SymplecticEuler, Rubber> scene({.support_radius = 2 * dx});
        const auto rubber = scene.add(Rubber{{.density = 1000, .sound_speed = 20, .shear_modulus = 1e5}},
                                      sph::fill(sph::Box<2>({0, 0}, {0.3, 0.3}), dx), dx);
        if (prepared)
            scene.prepare();
        change(scene[rubber]);
        scene[rubber][sph::position] *= 1.05;
        for (int k = 0; k < 10; ++k)
            scene.step(1e-4);
        return scene[rubber][sph::velocity].squaredNorm();
    };
    const auto heavier = [](auto view) { view[sph::mass] *= 2; };
    const auto stretched = [](auto view) { view[sph::reference_position] *= 0.9; };
    for (bool prepared : {false, true}) {
        CHECK(sum_after(prepared, heavier) > 0);
        CHECK(sum_after(prepared, heavier) == sum_after(false, heavier));
        CHECK(sum_after(prepared, stretched) == sum_after(false, stretched));
    }
}

TEST_CASE("Velocities that a host sets during a run limit the next step", "[hosts]") {
    sph::Solver<2, double, sph::SymplecticEuler, Water> scene({.support_radius = 2.6 * dx, .cfl = 0.4});
    const auto phase = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.5, 0.5}), dx), dx);
    scene.step();
    auto copy = scene;
    scene[phase][sph::velocity].col(0).setConstant(1000);
    CHECK(scene.step() * 1000 < dx);
    // to look at what may be written to changes nothing
    CHECK(copy.get<Water>()[sph::velocity].allFinite());
    const double step = copy.step();
    auto other = copy;
    other.get<Water>();
    CHECK(other.step() == std::as_const(copy).next_step().seconds);
    CHECK(step > 0);
}

TEST_CASE("A support radius that a host sets is looked at", "[hosts]") {
    auto s = settings();
    s.periodic_length = {0.5, 0};
    sph::Solver<2, double, sph::SymplecticEuler, Water> scene(s);
    const auto phase = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.5, 0.5}), dx), dx);
    scene.step();
    for (const double wrong : {0.0, -1.0, nan, 0.6}) {
        const double right = scene[phase].material().support_radius;
        scene[phase].material().support_radius = wrong;
        REQUIRE_THROWS_WITH(scene.step(), imbibe_test::contains("support_radius = " + sph::text(wrong)));
        scene[phase].material().support_radius = right;
        scene.step();
    }
}

template <int>
struct Case {
    struct Cream : sph::Fluid<> {};
};
TEST_CASE("Types inside templates and functions have names of their own", "[hosts]") {
    const auto inside = [] {
        struct Milk {};
        return sph::detail::type_name<Milk>();
    };
    CHECK(sph::detail::type_name<Case<1>::Cream>() == "Cream");
    CHECK(sph::detail::type_name<Case<1>>() == "Case");
    CHECK(sph::detail::type_name<Sides<Water>>() == "Sides");
    CHECK(inside() == "Milk");
}

/// Those of a pool of water over a floor.
std::vector<std::string> warnings_of(double sound, double gravity, double time_step, bool floor) {
    auto s = settings();
    s.gravity = {0, -gravity};
    s.time_step = time_step;
    Pool scene(s);
    scene.add(Water{{.density = 1000, .sound_speed = sound}}, block(0, 0, 0.5, 0.5), dx);
    if (floor)
        scene.add(Tank{{.density = 1000}}, block(0, -0.15, 0.5, 0.15), dx);
    scene.prepare();
    return scene.warnings();
}
void check_warning(const std::vector<std::string>& warnings, const std::string& words) {
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], imbibe_test::contains(words));
}
TEST_CASE("What is doubtful about a scene is said before its first step", "[hosts]") {
    CHECK(warnings_of(20, 9.81, 0, true).empty());
    check_warning(warnings_of(20, 9.81, 0, false), "Tank has no particles");
    check_warning(warnings_of(5, 9.81, 0, true), "compresses it by 17.");
    check_warning(warnings_of(20, 9.81, 0.1, true), "fixed time step of 0.1 s");
    SECTION("two fluids that do not reach as far over each other as over themselves") {
        struct Interface : sph::Coupling<Water, Oil, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
        const auto layers = [](double support) {
            sph::Solver<2, double, sph::SymplecticEuler, Water, Oil, Interface> scene(settings());
            scene.add(water, block(0, 0, 0.3, 0.3), dx);
            scene.add(Oil{{.density = 900, .sound_speed = 10, .support_radius = support}}, block(0, 0.3, 0.3, 0.3), dx);
            scene.prepare();
            return scene.warnings();
        };
        check_warning(layers(3 * dx), "Water and Oil have support radii of 0.13 and 0.15 m");
        CHECK(layers(2.6 * dx).empty());
    }
    SECTION("coordinates of which float has not enough digits") {
        const auto at = []<class Real>(Real, double x, const std::array<double, 2>& origin, bool as_wide = false) {
            auto s = settings();
            s.origin = origin;
            sph::Solver<2, Real, sph::SymplecticEuler, Water> scene(s);
            scene.add(water, block(x, 0, 0.5, 0.5), dx);
            if (as_wide)
                scene.add(water, block(0, 0, 0.5, 0.5), dx);
            scene.prepare();
            return scene.warnings();
        };
        check_warning(at(0.F, 600, {}), "Settings::origin = (600.2");
        check_warning(at(0.F, 600, {}), "forces are wrong by about 0.24");
        CHECK(at(0.F, 600, {}, true).empty()); // no other origin would help
        CHECK(at(0., 600, {}).empty());
        CHECK(at(0.F, 600, {590, 0}).empty());
        CHECK(at(0.F, 400, {}).empty());
    }
    SECTION("a wall that the water does not see") {
        const auto beside = [](double gap) {
            sph::Solver<2, double, sph::SymplecticEuler, Water, Tank> scene(settings());
            scene.add(water, block(0, 0, 0.5, 0.5), dx);
            scene.add(Tank{{.density = 1000}}, block(0, -0.15 - gap, 0.5, 0.15), dx);
            scene.prepare();
            return scene.warnings();
        };
        check_warning(beside(0), "struct Sides : Coupling<Water, Tank");
        CHECK(beside(1).empty());
    }
    SECTION("a wall that pushes and that the density of the water does not count") {
        struct Unseen
            : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>> {};
        struct Seen : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                                    sph::Into<Water, sph::VolumeContinuity<K>>> {};
        struct Repels : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>,
                                      sph::VolumePressure<K>, sph::KernelRepulsion<>> {};
        const auto beside = []<class Sides>(std::type_identity<Sides>, double gap) {
            sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides> scene(settings());
            scene.add(water, block(0, 0, 0.5, 0.5), dx);
            scene.add(Tank{{.density = 1000}}, block(0, -0.15 - gap, 0.5, 0.15), dx);
            scene.prepare();
            return scene.warnings();
        };
        check_warning(beside(std::type_identity<Unseen>{}, 0),
                      "Unseen pushes Water by pressure, but the density of Water "
                      "does not count Tank");
        CHECK(beside(std::type_identity<Unseen>{}, 1).empty());
        CHECK(beside(std::type_identity<Seen>{}, 0).empty());
        CHECK(beside(std::type_identity<Repels>{}, 0).empty());
    }
}

TEST_CASE("A fluid's sums over a wall reach as far as those over itself, whatever the wall's support", "[hosts]") {
    const auto pushed_by_a_wall_of = [](double support) {
        Pool scene(settings());
        const auto pool = scene.add(water, block(0, 0, 0.5, 0.5), dx);
        scene[pool][sph::density] *= 1.01; // a hundredth of rho c^2 on both sides of every particle in the first row
        scene.add(Tank{{.density = 1000, .support_radius = support}}, block(-0.15, -0.15, 0.8, 0.15), dx);
        scene.step(1e-4);
        return Eigen::ArrayXd(scene[pool][sph::velocity].rowwise().norm());
    };
    const auto same = pushed_by_a_wall_of(2.6 * dx), wider = pushed_by_a_wall_of(4 * dx),
               narrower = pushed_by_a_wall_of(2 * dx);
    const auto sorted = [](auto v) {
        std::sort(v.begin(), v.end());
        return v;
    };
    REQUIRE(same.maxCoeff() > 1e-3);
    CHECK((sorted(wider) - sorted(same)).abs().maxCoeff() < 1e-12);
    CHECK((sorted(narrower) - sorted(same)).abs().maxCoeff() < 1e-12);
}

TEST_CASE("Two couplings that ask for one part of a wall give it the same coefficients", "[hosts]") {
    sph::Solver<2, double, sph::SymplecticEuler, Water, Oil, Tank, Sides<Water>, Sides<Oil>> scene(settings());
    scene.add(water, block(0, 0, 0.3, 0.3), dx);
    scene.add(Oil{{.density = 900, .sound_speed = 10}}, block(0, 0.3, 0.3, 0.3), dx);
    scene.add(Tank{{.density = 1000}}, block(0, -0.15, 0.3, 0.15), dx);
    scene.coupling<Sides<Oil>>().set(sph::PressureExtrapolationParameters{.suction = false});
    REQUIRE_THROWS_WITH(scene.prepare(), imbibe_test::contains("PressureExtrapolationParameters"));
    scene.coupling<Sides<Water>>().set(sph::PressureExtrapolationParameters{.suction = false});
    scene.prepare();
}

TEST_CASE("What is added is checked across periodic sides and against what is there", "[hosts]") {
    auto s = settings(10, 0.5);
    s.periodic_length = {1, 0};
    using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;
    Scene scene(s);
    const double just_inside = 49 * (1.0 / 49); // 1.1e-16 below 1: the place of 0
    REQUIRE_THROWS_WITH(scene.add(water, {{0, 0.5}, {just_inside, 0.5}}, dx), imbibe_test::contains("coincide"));
    scene.add(water, {{0, 0.5}, {0.5, 0.5}}, dx);
    Water faster = water;
    faster.sound_speed = 20;
    REQUIRE_THROWS_WITH(scene.add(faster, {{0.7, 0.5}}, dx), imbibe_test::contains("sound speed 10 m/s before"));
    Scene narrow(s); // 0.7 m fit into the period, with their skin they do not
    REQUIRE_THROWS_WITH(narrow.add(Water{{.density = 1000, .sound_speed = 10, .support_radius = 0.7}}, {{0, 0}}, dx),
                        imbibe_test::contains("1.05 m, is longer than a period of 1 m"));
}

TEST_CASE("A few particles are added beside many unless they are too near to one of them, also across a side",
          "[hosts]") {
    auto s = settings();
    s.periodic_length = {1, 0};
    using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;
    const auto there = block(0, 0, 1, 0.5);
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> direction(0, 2 * std::numbers::pi);
    int refused = 0;
    for (std::size_t k = 0; k < there.size(); k += 7)
        for (const double distance : {0.9e-3, 1.1e-3}) {
            Scene scene(s);
            auto body = there;
            for (auto& x : body)
                x[0] -= 0.5 * dx; // a column of them is at the side
            scene.add(water, body, dx);
            const double angle = direction(generator);
            auto place = body[k];
            place += distance * dx * Scene::Point(std::cos(angle), std::sin(angle));
            CAPTURE(k, distance, angle);
            try {
                scene.add(water, {place}, dx);
                CHECK(distance > 1e-3);
                CHECK(scene.particles() == static_cast<long long>(body.size()) + 1);
            } catch (const sph::Error& error) {
                CHECK(distance < 1e-3);
                // The count is of all that are looked at: the particles, and those at one side as seen from the other.
                const auto images =
                    std::count_if(body.begin(), body.end(), [](const auto& x) { return x[0] < 1e-3 * dx; });
                const auto all = static_cast<long long>(body.size()) + 1 + images;
                CHECK_THAT(error.what(), imbibe_test::contains(sph::text(" of ", all, " coincide")) ||
                                             imbibe_test::contains(sph::text(" of ", all + 1, " coincide")));
                CHECK(scene.particles() == static_cast<long long>(body.size()));
                ++refused;
            }
        }
    CHECK(refused > 5);

    // Particles that a program has put into one place are not the fault of those added elsewhere.
    Scene scene(s);
    const auto handle = scene.add(water, there, dx);
    scene[handle][sph::position].row(1) = scene[handle][sph::position].row(0);
    CHECK_NOTHROW(scene.add(water, {{0.5, 0.9}}, dx));
    CHECK_THROWS_WITH(scene.add(water, {{0.5, 0.9}}, dx), imbibe_test::contains("coincide"));
}

} // namespace hosts_test
