// What a scene does with few particles, with fields and terms of the user's own, and with bad input.
#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/finite_strain_limit.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <Eigen/Geometry>

#include <catch_shim.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

namespace scene_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

// A fluid with central forces only.
struct Drop : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MonaghanViscosity<K>> {};
using DropScene = sph::Solver<3, double, sph::SymplecticEuler, Drop>;
using Points3 = std::vector<DropScene::Point>;

const Drop drop{{.density = 1000, .sound_speed = 10}};

inline Points3 ball(double spacing, double radius) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    Points3 points;
    const int m = static_cast<int>(radius / spacing);
    for (int z = -m; z <= m; ++z)
        for (int y = -m; y <= m; ++y)
            for (int x = -m; x <= m; ++x)
                if (x * x + y * y + z * z <= m * m)
                    points.push_back(spacing * DropScene::Point(x + jitter(generator), y + jitter(generator),
                                                                z + jitter(generator)));
    return points;
}

// A term with fields of its own: heat flows to where it is colder, dT_a/dt = 2 kappa sum_b V_b (T_a - T_b) F_ab.
struct Temperature : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
    static constexpr std::string_view rate_name = "temperature_rate", rate_unit = "K/s";
};
inline constexpr Temperature temperature{};
inline constexpr sph::Rate<Temperature> temperature_rate{};
constexpr double kappa = 1e-2; // m^2/s

struct Conduction {
    using reads = sph::Fields<sph::mass, temperature>;
    using adds = sph::Fields<temperature_rate>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return 2 * kappa * (b[sph::mass] / b.material.density) * (a[temperature] - b[temperature]) * ab.gradient(K{});
    }
};
struct Bar : sph::Fluid<Conduction> {};
using BarScene = sph::Solver<2, double, sph::SymplecticEuler, Bar>;

// Drops on stones that do not move.
struct Shore : sph::Wall<> {};
struct Landfall : sph::Coupling<Drop, Shore, sph::KernelRepulsion<>> {};
using ShoreScene = sph::Solver<3, double, sph::SymplecticEuler, Drop, Shore, Landfall>;

// Particles that only fly.
struct Stone : sph::Fluid<> {};
using StoneScene = sph::Solver<2, float, sph::SymplecticEuler, Stone>;

// Terms that know when the step begins: of particles alone, and of pairs.
struct Began : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "began", unit = "s";
};
inline constexpr Began began{};
struct Clock {
    using sets = sph::Fields<began>;
    constexpr auto operator()(const auto& a) const { return a.time + 0 * a.gravity()[0]; }
};
struct PairClock {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<temperature_rate>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return a.time * b[sph::mass] * ab.value(K{});
    }
};
struct Timed : sph::Fluid<Clock, PairClock> {};

template <class Scene, class P>
constexpr bool stores(auto field) {
    return sph::detail::contains<std::remove_cvref_t<decltype(field)>, typename Scene::template FieldsOf<P>>;
}

TEST_CASE("What is off is not stored", "[scene]") {
    static_assert(std::is_same_v<StoneScene::FieldsOf<Stone>,
                                 sph::Fields<sph::position, sph::velocity, sph::acceleration, sph::mass>>);
    CHECK(StoneScene::State<Stone>::component_total == 2 + 2 + 2 + 1);
    static_assert(stores<BarScene, Bar>(temperature) && stores<BarScene, Bar>(temperature_rate));
    static_assert(!stores<BarScene, Bar>(sph::density) && !stores<BarScene, Bar>(sph::pressure));
    CHECK(BarScene::State<Bar>::component_total == 2 + 2 + 2 + 1 + 2);
    // Drop: density and its rate, pressure, p/rho^2; no smoothed velocity, no stress, no mobility.
    CHECK(DropScene::State<Drop>::component_total == 3 + 3 + 3 + 1 + 4);
    CHECK(DropScene::FieldsOf<Drop>::size == 8);
    // Nor is it paid for: a step of stones has no loop over pairs, and no neighbour lists.
    CHECK(StoneScene::Scene::plan.size == 0);
    CHECK(DropScene::Scene::plan.sweeps(0) == 2);
    StoneScene stones({.support_radius = 0.1});
    std::vector<StoneScene::Point> row(1000);
    for (int k = 0; k < 1000; ++k)
        row[static_cast<std::size_t>(k)] = {0.05 * k, 0};
    stones.add(Stone{{.density = 1, .sound_speed = 1}}, row, 0.05);
    stones.step(1e-3);
    CHECK(stones.engine().list_bytes() == 0);
    CHECK(stones.engine().particle_bytes() < 1200 * (7 * sizeof(float) + sizeof(std::uint32_t)));
}

TEST_CASE("A term knows the time at which its step begins", "[scene]") {
    sph::Solver<2, double, sph::SymplecticEuler, Timed> scene({.support_radius = 1});
    const auto timed = scene.add(Timed{{.density = 4, .sound_speed = 1}}, {{0, 0}}, 0.5);
    scene.step(0.25);
    CHECK(scene[timed][began](0) == 0);
    scene.step(0.5);
    CHECK(scene[timed][began](0) == 0.25);
    scene.step(0.125);
    CHECK(scene[timed][began](0) == 0.75);
    CHECK(scene[timed][temperature](0) == // its own neighbour, of mass 1
          Approx((0.25 * 0.5 + 0.75 * 0.125) * sph::kernel_value<K, 2>(0.0, 1)).epsilon(1e-14));
}

TEST_CASE("Free flight is exact", "[scene]") {
    // All numbers are short in binary: there is no rounding, and the positions are those of the difference equation.
    StoneScene scene({.gravity = {0, -8}, .support_radius = 1});
    const auto stone = scene.add(Stone{{.density = 1, .sound_speed = 1}}, {{0, 0}, {-1, 0}, {5, 1}}, 0.5);
    scene[stone][sph::velocity].row(1) << 2, 4;
    const float dt = 0x1p-6f;
    for (int k = 0; k < 64; ++k)
        scene.step(dt);
    CHECK(scene.time() == 1);
    CHECK(scene.steps() == 64);
    // v = v_0 + g t and x = x_0 + v_0 t + g t (t + dt)/2
    const float fall = -8 * (1 + dt) / 2;
    const auto view = scene[stone];
    REQUIRE(view.ids() == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(view[sph::velocity](0, 1) == -8);
    CHECK(view[sph::position](0, 0) == 0);
    CHECK(view[sph::position](0, 1) == fall);
    CHECK(view[sph::position](1, 0) == 1);
    CHECK(view[sph::position](1, 1) == 4 + fall);
    CHECK(view[sph::position](2, 0) == 5);
    CHECK(view[sph::position](2, 1) == 1 + fall);
    CHECK(view[sph::mass](0) == 0.25f);
}

TEST_CASE("One particle, and two", "[scene]") {
    DropScene scene({.gravity = {0, 0, -8}, .support_radius = 0.25});
    const auto one = scene.add(drop, {{1, 2, 3}}, 0.125);
    for (int k = 0; k < 8; ++k)
        scene.step(0x1p-10);
    CHECK(scene[one][sph::velocity](0, 2) == -8 * 8 * 0x1p-10);
    CHECK(scene[one][sph::density](0) == 1000);
    CHECK(scene[one][sph::pressure](0) == 0);
    CHECK(scene[one][sph::acceleration].row(0).norm() == 8);

    DropScene pair({.support_radius = 0.25});
    const auto two = pair.add(drop, {{0, 0, 0}, {0.125, 0, 0}}, 0.125);
    pair[two][sph::density].setConstant(1010);
    pair.step(1e-5);
    const auto a = pair[two][sph::acceleration];
    CHECK(a(0, 0) < 0);                // pushed apart,
    CHECK(a(0, 0) == -a(1, 0));        // to the last bit,
    CHECK(a.rightCols(2).norm() == 0); // along the line of centres
}

TEST_CASE("In float, a scene far away is the scene at home when its origin goes along", "[scene]") {
    using Scene = sph::Solver<3, float, sph::SymplecticEuler, Drop>;
    const double far = 1e4; // in diameters of the drop
    const auto shape = [](double away, std::array<double, 3> origin, double lower) {
        Scene scene({.gravity = {0, 0, -9.81},
                     .support_radius = 0.21,
                     .periodic_lower = {lower, 0, 0},
                     .periodic_length = {1, 0, 0},
                     .origin = origin,
                     .threads = 1});
        auto points = ball(0.1, 0.45);
        for (auto& x : points)
            x += DropScene::Point(away, -away, 3 * away);
        const auto handle = scene.add(drop, points, 0.1);
        CHECK(scene.remove_if(handle, [&](const auto& x) { return x[0] > away + 0.33; }) > 0); // in world coordinates
        auto view = scene[handle];
        for (int i = 0; i < view.size(); ++i)
            view[sph::density](i) = 1000 * (1 + 0.01f * std::sin(float(view.ids()[std::size_t(i)])));
        for (int k = 0; k < 20; ++k)
            scene.step(1e-3);
        return std::pair(Eigen::MatrixXf(view[sph::acceleration]), view.ids());
    };
    const auto [home, home_ids] = shape(0, {}, -0.5);
    const auto [away, away_ids] = shape(far, {far, -far, 3 * far}, far - 0.5);
    REQUIRE(home_ids == away_ids);
    CHECK((home - away).cwiseAbs().maxCoeff() < 1e-3 * home.cwiseAbs().maxCoeff());
    REQUIRE_THROWS_WITH(Scene({.support_radius = 0.21, .origin = {0, std::nan(""), 0}}),
                        imbibe_test::contains("origin"));
}

TEST_CASE("A scene without particles says so", "[scene]") {
    DropScene scene({.support_radius = 0.25});
    REQUIRE_THROWS_WITH(scene.step(), imbibe_test::contains("no particles"));
    scene.add(drop, {}, 0.1);
    REQUIRE_THROWS_WITH(scene.run_until(1), imbibe_test::contains("no particles"));
}

TEST_CASE("Coincident particles give finite forces", "[scene]") {
    DropScene scene({.support_radius = 0.25});
    const auto same = scene.add(drop, ball(0.125, 0.28), 0.125);
    for (int d = 0; d < 3; ++d)
        scene[same][sph::position].col(d).setConstant(0.3); // as added they would be refused
    scene[same][sph::density].setConstant(1010);
    scene.step(1e-5);
    CHECK(scene[same][sph::acceleration].allFinite());
    CHECK(scene[same][sph::acceleration].norm() == 0);
}

TEST_CASE("Central forces keep the angular momentum, and masses stay what they are", "[scene]") {
    DropScene scene({.support_radius = 0.21});
    const auto points = ball(0.1, 0.45);
    const auto handle = scene.add(drop, points, 0.1);
    auto view = scene[handle];
    std::mt19937 generator(8);
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (int i = 0; i < view.size(); ++i) {
        const Eigen::Vector3d x = view[sph::position].row(i), spin(0.3, -0.5, 1);
        view[sph::velocity].row(i) =
            (spin.cross(x) + Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator))).transpose();
        view[sph::density](i) *= 1 + 0.05 * uniform(generator);
    }
    const Eigen::VectorXd masses = view[sph::mass];
    const auto angular_momentum = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int i = 0; i < view.size(); ++i) {
            const Eigen::Vector3d x = view[sph::position].row(i), v = view[sph::velocity].row(i);
            sum += view[sph::mass](i) * x.cross(v);
        }
        return sum;
    };
    const Eigen::Vector3d start = angular_momentum();
    REQUIRE(start.norm() > 1);
    for (int k = 0; k < 50; ++k)
        scene.step(1e-3);
    CHECK((angular_momentum() - start).norm() < 1e-13 * start.norm() * 50);
    CHECK(Eigen::VectorXd(view[sph::mass]) == masses); // bit by bit; all alike
    CHECK(view[sph::velocity].norm() > 0.1);
}

TEST_CASE("Ids follow the particles through sorting", "[scene]") {
    DropScene scene({.support_radius = 0.1});
    Points3 points = ball(0.1, 0.45);
    std::shuffle(points.begin(), points.end(), std::mt19937(9));
    const auto handle = scene.add(drop, points, 0.1);
    scene.prepare();
    const auto view = scene[handle];
    int moved = 0;
    std::vector<char> seen(points.size(), 0);
    for (int i = 0; i < view.size(); ++i) {
        const auto id = view.ids()[static_cast<std::size_t>(i)];
        REQUIRE(id < points.size());
        REQUIRE_FALSE(seen[id]);
        seen[id] = 1;
        moved += static_cast<int>(id) != i;
        REQUIRE(Eigen::Vector3d(view[sph::position].row(i)) == points[id]);
    }
    CHECK(moved > 50);
}

TEST_CASE("Views look at the particles themselves", "[scene]") {
    DropScene scene({.support_radius = 0.21});
    const auto handle = scene.add(drop, ball(0.1, 0.35), 0.1);
    const auto& state = scene.engine().state<Drop>();
    auto v = scene[handle][sph::velocity];
    CHECK(static_cast<const double*>(v.data()) == state.field(sph::velocity));
    CHECK(v.cols() == 3);
    CHECK(v.rows() == scene[handle].size());
    CHECK(&v(2, 1) == state.field(sph::velocity) + static_cast<std::ptrdiff_t>(state.stride()) + 2);
    v.col(2).setConstant(-3);
    const DropScene& looking = scene;
    CHECK(looking[handle][sph::velocity].col(2).minCoeff() == -3);
    CHECK(looking.get<Drop>()[sph::velocity].col(2).maxCoeff() == -3);
    CHECK(looking[handle][sph::velocity].data() == v.data());
    CHECK(reinterpret_cast<std::uintptr_t>(scene[handle][sph::position].data()) % 64 == 0);
}

TEST_CASE("A view of a phase is assigned, a view of a field copies numbers", "[scene]") {
    DropScene scene({.support_radius = 0.21}), other({.support_radius = 0.21});
    const auto handle = scene.add(drop, ball(0.1, 0.35), 0.1);
    const auto other_handle = other.add(drop, ball(0.1, 0.25), 0.1);
    auto view = scene[handle];
    scene.step(1e-3);
    view = scene[handle];
    CHECK(view[sph::velocity].data() == scene[handle][sph::velocity].data());
    const auto& same = view;
    view = same;
    CHECK(&view.state.store == &scene.engine().state<Drop>().store);
    view = other[other_handle];
    CHECK(&view.state.store == &other.engine().state<Drop>().store);
    CHECK(view.size() == static_cast<int>(ball(0.1, 0.25).size()));
    CHECK(&view.material() == &other[other_handle].material());
    const DropScene& looking = scene;
    auto seen = looking[handle];
    seen = looking.get<Drop>();
    CHECK(seen.size() == scene[handle].size());

    auto velocities = scene[handle][sph::velocity];
    const auto* const memory = velocities.data();
    velocities.setConstant(2);
    auto places = scene[handle][sph::position];
    velocities = places;
    CHECK(velocities.data() == memory);
    CHECK(memory != places.data());
    CHECK(scene[handle][sph::velocity].isApprox(scene[handle][sph::position], 0));
}

TEST_CASE("A term with a field of its own: heat spreads as it should", "[scene]") {
    // A periodic bar with a cosine of temperature: its amplitude falls as exp(-kappa k^2 t).
    const int m = 40;
    const double spacing = 1.0 / m;
    BarScene scene({.support_radius = 2.6 * spacing, .periodic_length = {1, 0.25}});
    std::vector<BarScene::Point> points;
    for (int y = 0; y < m / 4; ++y)
        for (int x = 0; x < m; ++x)
            points.push_back({(x + 0.5) * spacing, (y + 0.5) * spacing});
    const auto bar = scene.add(Bar{{.density = 1, .sound_speed = 1}}, points, spacing);
    auto view = scene[bar];
    const auto wave = [](double x) { return std::cos(2 * std::numbers::pi * x); };
    for (int i = 0; i < view.size(); ++i)
        view[temperature](i) = 300 + 10 * wave(view[sph::position](i, 0));
    const double heat = view[temperature].sum();
    const double dt = 1e-3;
    scene.step(dt);
    // The first step is T + dt dT/dt with the old temperatures.
    for (int i = 0; i < view.size(); ++i) {
        const double before = 300 + 10 * wave(view[sph::position](i, 0));
        REQUIRE(view[temperature](i) == Approx(before + dt * view[temperature_rate](i)).epsilon(1e-14));
    }
    while (scene.time() < 0.999)
        scene.step(dt);
    double amplitude = 0;
    for (int i = 0; i < view.size(); ++i)
        amplitude += 2 * view[temperature](i) * wave(view[sph::position](i, 0)) / view.size();
    CHECK(amplitude ==
          Approx(10 * std::exp(-kappa * 4 * std::numbers::pi * std::numbers::pi * scene.time())).epsilon(0.02));
    CHECK(view[temperature].sum() == Approx(heat).epsilon(1e-13));
    CHECK(view[sph::velocity].norm() == 0);
}

TEST_CASE("Steps: fixed, limited, and up to an end", "[scene]") {
    DropScene scene({.support_radius = 0.21, .cfl = 0.5, .time_step = 0});
    scene.add(drop, ball(0.1, 0.35), 0.1);
    scene.prepare();
    const auto limits = scene.time_step_limits(); // those of sound and of viscosity
    REQUIRE(limits.size() >= 2);
    CHECK(limits[0].seconds <= limits[1].seconds);
    const double first = scene.step();
    CHECK(first == Approx(0.5 * limits[0].seconds).epsilon(1e-14));
    CHECK(first < 0.5 * 0.6 * 0.21 / 10); // not beyond sound
    CHECK(scene.last_step().where == "Drop");
    int seen = 0;
    double before = -1;
    scene.run_until(0.0301, [&](const DropScene& s) {
        ++seen;
        CHECK(s.time() > before);
        before = s.time();
    });
    CHECK(scene.time() == Approx(0.0301).epsilon(1e-12));
    CHECK(seen == scene.steps()); // before the first of this run (one step had been made) and after each

    DropScene fixed({.support_radius = 0.21, .time_step = 1e-3});
    fixed.add(drop, ball(0.1, 0.35), 0.1);
    fixed.run_until(0.01);
    CHECK(fixed.steps() == 10);
    CHECK(fixed.last_step().seconds == Approx(1e-3));
    for (double bad : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()})
        REQUIRE_THROWS_AS(fixed.step(bad), sph::Error);
}

TEST_CASE("Bad settings", "[scene]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (double H : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_WITH(DropScene({.support_radius = H}), imbibe_test::contains("support_radius"));
    REQUIRE_THROWS_WITH(DropScene({.gravity = {0, nan, 0}, .support_radius = 1}), imbibe_test::contains("gravity"));
    for (double cfl : {0.0, -0.1, 3.0, nan})
        REQUIRE_THROWS_WITH(DropScene({.support_radius = 1, .cfl = cfl}), imbibe_test::contains("cfl"));
    for (double step : {-1e-3, nan})
        REQUIRE_THROWS_WITH(DropScene({.support_radius = 1, .time_step = step}), imbibe_test::contains("time_step"));
    for (double step : {0.0, nan})
        REQUIRE_THROWS_WITH(DropScene({.support_radius = 1, .max_time_step = step}),
                            imbibe_test::contains("max_time_step"));
    for (double length : {0.9, -1.0, nan})
        REQUIRE_THROWS_WITH(DropScene({.support_radius = 1, .periodic_length = {0, length, 0}}),
                            imbibe_test::contains("periodic length"));
    REQUIRE_THROWS_WITH(DropScene({.support_radius = 1, .periodic_lower = {nan, 0, 0}}),
                        imbibe_test::contains("periodic_lower"));
}

TEST_CASE("Bad materials and points leave the scene as it was", "[scene]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    DropScene scene({.support_radius = 0.25, .periodic_length = {1, 0, 0}});
    const Points3 points{{0, 0, 0}, {0.125, 0, 0}};
    for (double bad : {0.0, -1000.0, nan}) {
        REQUIRE_THROWS_WITH(scene.add(Drop{{.density = bad, .sound_speed = 1}}, points, 0.125),
                            imbibe_test::contains("Drop: density"));
        REQUIRE_THROWS_WITH(scene.add(Drop{{.density = 1, .sound_speed = bad}}, points, 0.125),
                            imbibe_test::contains("Drop: sound_speed"));
        REQUIRE_THROWS_WITH(scene.add(drop, points, bad), imbibe_test::contains("Drop: spacing"));
    }
    REQUIRE_THROWS_WITH(scene.add(Drop{{.sound_speed = 1}}, points, 0.125), imbibe_test::contains("not given"));
    for (double bad : {-1.0, nan})
        REQUIRE_THROWS_WITH(scene.add(Drop{{.density = 1, .sound_speed = 1, .viscosity = bad}}, points, 0.125),
                            imbibe_test::contains("Drop: viscosity"));
    for (double bad : {-1.0, nan, 1.5}) // 1.5 is longer than the period
        REQUIRE_THROWS_WITH(scene.add(Drop{{.density = 1, .sound_speed = 1, .support_radius = bad}}, points, 0.125),
                            imbibe_test::contains("Drop: support_radius"));
    for (double bad : {nan, std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_WITH(scene.add(drop, {{0, 0, 0}, {0, bad, 0}}, 0.125),
                            imbibe_test::contains("coordinate 1 of point 1"));
    CHECK(scene.particles() == 0);
    const auto handle = scene.add(drop, points, 0.125);
    REQUIRE_THROWS_WITH(scene.add(drop, points, 0.1), imbibe_test::contains("spacing"));
    REQUIRE_THROWS_AS(scene.add(drop, {{0, 0, nan}}, 0.125), sph::Error);
    // Two ends of a period are one place.
    REQUIRE_THROWS_WITH(scene.add(drop, {{0, 2, 0}, {1, 2, 0}}, 0.125), imbibe_test::contains("coincide"));
    Drop light = drop;
    light.density = 500;
    REQUIRE_THROWS_WITH(scene.add(light, {{0, 1, 0}}, 0.125), imbibe_test::contains("500 kg/m^3 now"));
    REQUIRE_THROWS_WITH(scene.add(drop, {{0, 1, 0}, {0, 1, 0}}, 0.125),
                        imbibe_test::contains("Drop, which repeats every 1 m along x") &&
                            imbibe_test::contains("coincide") && imbibe_test::contains("the spacing of 0.125 m"));
    REQUIRE_THROWS_WITH(scene.add(drop, {{0.125, 0, 1e-6}}, 0.125), imbibe_test::contains("coincide"));
    CHECK(scene[handle].size() == 2);
    scene.step();
    CHECK(scene[handle][sph::position].allFinite());
}

TEST_CASE("Coefficients out of range are refused before the first step", "[scene]") {
    struct Thick
        : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MonaghanViscosity<K>> {};
    Thick thick{{.density = 1000, .sound_speed = 10}};
    thick.set(sph::MonaghanViscosityParameters{.alpha = -0.1});
    sph::Solver<3, double, sph::SymplecticEuler, Thick> scene({.support_radius = 0.25});
    const auto handle = scene.add(thick, ball(0.125, 0.28), 0.125);
    REQUIRE_THROWS_WITH(scene.step(), imbibe_test::contains("Thick: MonaghanViscosityParameters::alpha = -0.1;"));
    CHECK(scene.steps() == 0);
    scene[handle].material().set(sph::MonaghanViscosityParameters{.alpha = 0.1});
    CHECK_NOTHROW(scene.step());
    REQUIRE_THROWS_WITH(sph::XsphParameters{.strength = 1.1}.check("Thick"),
                        imbibe_test::contains("strength = 1.1") && imbibe_test::contains("from 0 to 1"));
}

TEST_CASE("Points outside the periodic box come into it", "[scene]") {
    DropScene scene({.support_radius = 0.25, .periodic_lower = {-0.5, 0, 0}, .periodic_length = {1, 0, 0}});
    const auto handle = scene.add(drop, {{2.75, 7, 0}, {-0.75, 7, 0.1}}, 0.125);
    CHECK(scene[handle][sph::position](0, 0) == -0.25);
    CHECK(scene[handle][sph::position](1, 0) == 0.25);
    CHECK(scene[handle][sph::position](0, 1) == 7);
}

TEST_CASE("Phases that start overlapped, or close to each other, are warned of", "[scene]") {
    const auto start = [](double gap) {
        ShoreScene scene({.support_radius = 0.25, .origin = {10, 0, 0}});
        scene.add(drop, {{10, 2, 3}, {10.5, 2, 3}}, 0.1);
        scene.add(Shore{{.density = 1000}}, {{10.5, 2 + gap, 3}}, 0.1);
        scene.prepare();
        return scene;
    };
    for (const double gap : {0.0, 1e-4, 0.029}) {
        const auto scene = start(gap);
        REQUIRE(scene.warnings().size() == 1); // the same pair, seen from either phase
        CHECK_THAT(scene.warnings()[0], imbibe_test::contains("Drop and Shore overlap") &&
                                            imbibe_test::contains("(10.5, 2, 3) m") &&
                                            imbibe_test::contains("remove_if"));
    }
    CHECK_THAT(start(0.029).warnings()[0], imbibe_test::contains("0.29 of their mean spacing"));
    CHECK(start(0.031).warnings().empty());
    // Nearer than the square of a float can tell from 0.
    sph::Solver<3, float, sph::SymplecticEuler, Drop, Shore, Landfall> fine({.support_radius = 2.6e-4});
    fine.add(drop, {{5.4e-20, 0, 0}}, 1e-4);
    fine.add(Shore{{.density = 1000}}, {{0, 0, 0}, {1e-4, 0, 0}}, 1e-4);
    fine.prepare();
    CHECK_THAT(fine.warnings().at(0), imbibe_test::contains("Drop and Shore overlap"));
    // What is added to a run is not looked at again.
    auto close = start(0.029);
    close.step(1e-6);
    close.add(drop, {{20, 2, 3}}, 0.1);
    close.step(1e-6);
    CHECK(close.warnings().size() == 1);
}

TEST_CASE("A run that goes wrong says where", "[scene]") {
    DropScene scene({.support_radius = 0.21});
    const auto handle = scene.add(drop, ball(0.1, 0.35), 0.1);
    scene.step();
    scene[handle][sph::velocity](17, 1) = std::numeric_limits<double>::quiet_NaN();
    const auto id = scene[handle].ids()[17];
    std::string message;
    try {
        for (int k = 0; k < 3; ++k)
            scene.step();
    } catch (const sph::Error& error) {
        message = error.what();
    }
    CAPTURE(message, id);
    CHECK(message.find("Drop") != std::string::npos);
    CHECK(message.find("finite") != std::string::npos);
    CHECK(message.find("step ") != std::string::npos);
}

TEST_CASE("Odd but legal numbers are warned of", "[scene]") {
    SECTION("too few neighbours") {
        DropScene scene({.support_radius = 0.12});
        scene.add(drop, ball(0.1, 0.35), 0.1);
        REQUIRE(scene.warnings().size() == 1);
        CHECK(scene.warnings()[0].find("1.2 spacings") != std::string::npos);
        CHECK(scene.warnings()[0].find(" 6 ") != std::string::npos);
        scene.add(drop, ball(0.1, 0.15), 0.1);
        CHECK(scene.warnings().size() == 1); // said once
    }
    SECTION("a support radius in another unit than the spacing") {
        DropScene scene({.support_radius = 52});
        scene.add(drop, ball(0.1, 0.35), 0.1);
        REQUIRE(scene.warnings().size() == 1);
        CHECK_THAT(scene.warnings()[0],
                   imbibe_test::contains("520 spacings") && imbibe_test::contains("Are both in metres?"));
    }
    SECTION("another spacing than that of the points, which makes another mass") {
        for (const double wrong : {0.05, 0.25}) {
            DropScene scene({.support_radius = 2.6 * std::max(wrong, 0.1)});
            scene.add(drop, ball(0.1, 0.35), wrong);
            scene.prepare();
            REQUIRE(scene.warnings().size() == 1);
            CHECK_THAT(scene.warnings()[0], imbibe_test::contains(sph::text("a spacing of ", wrong, " m")) &&
                                                imbibe_test::contains("density * spacing^dim"));
        }
    }
    SECTION("two fluids that do not see each other") {
        struct Oil : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
        sph::Solver<3, double, sph::SymplecticEuler, Drop, Oil> scene({.support_radius = 0.25});
        scene.add(drop, {{0, 0, 0}}, 0.1);
        scene.add(Oil{{.density = 900, .sound_speed = 10}}, {{0, 0, 0.1}}, 0.1);
        scene.prepare();
        REQUIRE(scene.warnings().size() == 1); // once for both
        CHECK_THAT(scene.warnings()[0], imbibe_test::contains("Oil is within reach of Drop") &&
                                            imbibe_test::contains("Coupling<Drop, Oil, ...>"));
    }
    SECTION("enough") {
        DropScene scene({.support_radius = 0.131});
        scene.add(drop, ball(0.1, 0.35), 0.1);
        CHECK(scene.warnings().empty());
    }
    SECTION("a solid that is practically a liquid") {
        struct Jelly : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
        Jelly jelly;
        jelly.density = 950, jelly.sound_speed = 31.6, jelly.shear_modulus = 2e-6;
        CHECK_NOTHROW(jelly.check("Jelly"));
        const auto sentence = jelly.warning("Jelly");
        CHECK(sentence.find("2e-06 Pa") != std::string::npos);
        CHECK(sentence.find("Poisson's ratio 0.5") != std::string::npos);
        jelly.shear_modulus = 1e5;
        CHECK(jelly.warning("Jelly").empty());
        for (const double E : {1e6, 3e6, 2.1e11}) { // cork: nu = 0, rounded
            jelly.shear_modulus = sph::shear_modulus_of(E, 0);
            jelly.sound_speed = sph::sound_speed_of(E, 0, jelly.density);
            CHECK(jelly.warning("Jelly").empty());
            jelly.shear_modulus = sph::shear_modulus_of(E, -0.01);
            jelly.sound_speed = sph::sound_speed_of(E, -0.01, jelly.density);
            CHECK(jelly.warning("Jelly").find("auxetic") != std::string::npos);
        }
        jelly.sound_speed = 31.6, jelly.shear_modulus = 1e5;
        CHECK(jelly.poisson_ratio() == Approx((3 * 950 * 31.6 * 31.6 - 2e5) / (6 * 950 * 31.6 * 31.6 + 2e5)));
        using Scene = sph::Solver<3, double, sph::SymplecticEuler, Jelly>;
        jelly.shear_modulus = 2e-6;
        Scene scene({.support_radius = 0.25});
        scene.add(jelly, {{0, 0, 0}}, 0.1);
        REQUIRE(scene.warnings().size() == 1);
        CHECK(scene.warnings()[0] == sentence);
    }
    SECTION("a solid that is less compressible than its law bears") {
        struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>,
                                   sph::FiniteStrainLimit<sph::CompressibleNeoHookean>, sph::TotalLagrangianForce<K>> {
        };
        struct Averaged : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>,
                                     sph::VolumetricDeviatoric<>, sph::TotalLagrangianForce<K>> {};
        const auto warnings = [&]<class P>(std::type_identity<P>, double nu) {
            sph::Solver<3, double, sph::SymplecticEuler, P> scene({.support_radius = 0.25});
            scene.add(P{{.density = 950,
                         .sound_speed = sph::sound_speed_of(1e6, nu, 950),
                         .shear_modulus = sph::shear_modulus_of(1e6, nu)}},
                      {{0, 0, 0}}, 0.1);
            return scene.warnings();
        };
        CHECK(warnings(std::type_identity<Rubber>{}, 0.49).empty());
        CHECK(warnings(std::type_identity<Averaged>{}, 0.499).empty());
        const auto said = warnings(std::type_identity<Rubber>{}, 0.499);
        REQUIRE(said.size() == 1);
        CHECK_THAT(said[0], imbibe_test::contains("Rubber: Poisson's ratio 0.499 with "));
        CHECK_THAT(said[0], imbibe_test::contains("above 0.495; take VolumetricDeviatoric"));
    }
}

TEST_CASE("What is added to a phase is of its material", "[scene]") {
    DropScene scene({.support_radius = 0.26});
    scene.add(drop, {{0, 0, 0}}, 0.1);
    Drop other = drop;
    other.viscosity = 2;
    CHECK_THROWS_WITH(scene.add(other, {{1, 0, 0}}, 0.1), imbibe_test::contains("viscosity 0 Pa s before and 2 Pa s"));
    other = drop;
    other.support_radius = 0.3;
    CHECK_THROWS_WITH(scene.add(other, {{1, 0, 0}}, 0.1), imbibe_test::contains("support radius 0.26 m before"));
    CHECK(scene.particles() == 1);
    CHECK_NOTHROW(scene.add(drop, {{1, 0, 0}}, 0.1));
}

TEST_CASE("Spacings whose volumes a float cannot multiply are refused", "[scene]") {
    using Small = sph::Solver<3, float, sph::SymplecticEuler, Drop>;
    Small scene({.support_radius = 1});
    CHECK_THROWS_WITH(scene.add(drop, {{0, 0, 0}}, 3e-7), imbibe_test::contains("in float it must be between"));
    CHECK_THROWS_WITH(scene.add(drop, {{0, 0, 0}}, 1e5), imbibe_test::contains("in float it must be between"));
    CHECK_NOTHROW(scene.add(drop, {{0, 0, 0}}, 1e-6));
}

TEST_CASE("Numbers that a program changes between steps are looked at again", "[scene]") {
    DropScene scene({.support_radius = 0.26});
    const auto handle = scene.add(drop, ball(0.1, 0.2), 0.1);
    scene.step();
    scene[handle].material().set(sph::MonaghanViscosityParameters{.alpha = -1});
    CHECK_THROWS_WITH(scene.step(), imbibe_test::contains("alpha = -1"));
    scene[handle].material().set(sph::MonaghanViscosityParameters{});
    scene[handle].material().density = -5;
    CHECK_THROWS_WITH(scene.run_until(1), imbibe_test::contains("density = -5 kg/m^3"));
    scene[handle].material().density = 1000;
    CHECK_NOTHROW(scene.step());
}

TEST_CASE("Shortened steps are shorter whatever limits them", "[scene]") {
    DropScene scene({.support_radius = 0.26, .max_time_step = 1e-6});
    scene.add(drop, ball(0.1, 0.2), 0.1);
    scene.prepare();
    REQUIRE(scene.next_step().reason == "max_time_step");
    scene.shorten_steps(0.5);
    CHECK(scene.next_step().seconds == 0.5e-6);
    for (int threads : {-3, 1025, 100000})
        CHECK_THROWS_WITH(DropScene({.support_radius = 0.26, .threads = threads}),
                          imbibe_test::contains("threads = " + std::to_string(threads)));
}

} // namespace scene_test
