// Integrators: their order, what they conserve; sub-cycling and dual stepping against plain stepping.
#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

#include <cmath>
#include <vector>

namespace integrators_test {

/// The energy that the pressure's work makes of motion, per mass: nobody reads it.
struct Heat : imbibe::Field<imbibe::Rank::scalar> {
    static constexpr std::string_view name = "heat", unit = "J/kg", rate_name = "heat_rate", rate_unit = "W/kg";
};

namespace {

namespace sph = imbibe;
using sph::density, sph::position, sph::velocity, sph::mass;
using C2 = sph::WendlandC2;
using Eigen::MatrixXd;

struct Rubber : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::StVenantKirchhoff,
                           sph::TotalLagrangianForce<>, sph::Clamped, sph::TimeAveragedMotion> {};
struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::VolumePressure<C2>> {};
struct Contact : sph::Coupling<Water, Rubber, sph::Into<Rubber, sph::PressureExtrapolation<C2>>,
                               sph::VolumePressure<C2>, sph::Into<Water, sph::VolumeContinuity<C2>>> {};

inline constexpr sph::Rate<Heat> heat_rate{};
struct Work {
    using reads = sph::Fields<mass, density, sph::pressure, velocity>;
    using adds = sph::Fields<heat_rate>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return b[mass] * a[sph::pressure] / sph::sq(a[density]) * dot(a[velocity] - b[velocity], ab.offset) *
               ab.gradient(C2{});
    }
};
struct WarmWater : sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::VolumePressure<C2>, Work> {};

constexpr double spacing = 0.1;

/// What is integrated, in the order in which the particles were added: positions, velocities, densities if there are.
template <bool with_density, class View>
MatrixXd in_order(const View& phase) {
    MatrixXd all(phase.size(), with_density ? 5 : 4);
    for (int i = 0; i < phase.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(phase.ids()[static_cast<std::size_t>(i)]);
        all.block(k, 0, 1, 2) = phase[position].row(i).template cast<double>();
        all.block(k, 2, 1, 2) = phase[velocity].row(i).template cast<double>();
        if constexpr (with_density)
            all(k, 4) = static_cast<double>(phase[density](i, 0)) * 1e-3;
    }
    return all;
}

/// A block of rubber that is let go while it is being stretched.
template <class Integrator>
MatrixXd rubber_after(double time, int steps) {
    sph::Solver<2, double, Integrator, Rubber> scene({.support_radius = 2.6 * spacing});
    const double E = 1e6, nu = 0.3;
    const auto rubber = scene.add(Rubber{{.density = 1000,
                                          .sound_speed = sph::sound_speed_of(E, nu, 1000),
                                          .shear_modulus = sph::shear_modulus_of(E, nu)}},
                                  sph::fill(sph::Box<2>{{0, 0}, {0.6, 0.4}}, spacing), spacing);
    auto view = scene[rubber];
    for (int i = 0; i < view.size(); ++i)
        view[velocity].row(i) << 4 * (view[position](i, 0) - 0.3), view[position](i, 0) * 2;
    for (int k = 0; k < steps; ++k)
        scene.step(time / steps);
    return in_order<false>(scene[rubber]);
}

/// A standing wave of sound in a periodic square of water.
template <class Integrator, class Fluid = Water>
MatrixXd water_after(double time, int steps) {
    sph::Solver<2, double, Integrator, Fluid> scene(
        {.support_radius = 2.6 * spacing, .periodic_lower = {0, 0}, .periodic_length = {1, 1}});
    const auto water = scene.add(Fluid{{.density = 1000, .sound_speed = 10}},
                                 sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, spacing), spacing);
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        view[velocity].row(i) << 0.1 * std::sin(2 * std::numbers::pi * view[position](i, 0)), 0;
        view[density](i, 0) *=
            1 + 0.01 * std::sin(2 * std::numbers::pi * (view[position](i, 0) + view[position](i, 1)));
    }
    for (int k = 0; k < steps; ++k)
        scene.step(time / steps);
    return in_order<true>(scene[water]);
}

/// The order seen between `steps` and twice as many, against `exact`.
template <class Run>
double order_of(const Run& run, int steps, const MatrixXd& exact) {
    const double coarse = (run(steps) - exact).norm(), fine = (run(2 * steps) - exact).norm();
    INFO("errors " << coarse << " and " << fine << " of " << exact.norm());
    REQUIRE(coarse < 0.05 * exact.norm());
    return std::log2(coarse / fine);
}

} // namespace

TEST_CASE("Integrators have the order they should, in a solid", "[integrators]") {
    const double time = 0.012;
    const MatrixXd exact = rubber_after<sph::MidpointRungeKutta>(time, 4000);
    const auto order = [&]<class Integrator>(Integrator) {
        return order_of([&](int steps) { return rubber_after<Integrator>(time, steps); }, 60, exact);
    };
    CHECK(order(sph::SymplecticEuler{}) == Approx(1).margin(0.15));
    CHECK(order(sph::StaggeredLeapfrog{}) == Approx(1).margin(0.15));
    CHECK(order(sph::Leapfrog{}) == Approx(2).margin(0.15));
    CHECK(order(sph::PositionVerlet{}) == Approx(2).margin(0.15));
    CHECK(order(sph::MidpointRungeKutta{}) == Approx(2).margin(0.15));
    CHECK(order(sph::PredictorCorrector{}) == Approx(2).margin(0.15));
}

TEST_CASE("Integrators have the order they should, in a fluid", "[integrators]") {
    const double time = 0.02;
    const MatrixXd exact = water_after<sph::MidpointRungeKutta>(time, 2000);
    const auto order = [&]<class Integrator>(Integrator) {
        return order_of([&](int steps) { return water_after<Integrator>(time, steps); }, 40, exact);
    };
    CHECK(order(sph::SymplecticEuler{}) == Approx(1).margin(0.15));
    CHECK(order(sph::MidpointRungeKutta{}) == Approx(2).margin(0.15));
    CHECK(order(sph::PredictorCorrector{}) == Approx(2).margin(0.15));
    CHECK(order(sph::StaggeredLeapfrog{}) == Approx(1).margin(0.15)); // its velocities are those of half a step later
}

namespace {

struct Spray : sph::Fluid<sph::Tait<7>, sph::Continuity<sph::Spiky>, sph::SymmetricPressure<sph::Spiky>> {};
struct Encounter {
    double speed, density; ///< after two particles have met, over before: of their relative speed, of their density
};
/// Two particles of water that meet at 2 m/s, a third of their support off the line, in steps of 10 us as in the paper.
template <class Integrator>
Encounter meeting() {
    const double support = 1e-3, before = 2;
    sph::Solver<3, double, Integrator, Spray> scene({.support_radius = support, .time_step = 1e-5});
    const auto both =
        scene.add(Spray{{.density = 1000, .sound_speed = 30}},
                  {sph::Point<3>{-0.6 * support, 0, 0}, sph::Point<3>{0.6 * support, 0.3 * support, 0}}, 0.8e-3);
    const auto view = scene[both];
    view[velocity].row(0) << before / 2, 0, 0;
    view[velocity].row(1) << -before / 2, 0, 0;
    scene.run_until(2e-3);
    REQUIRE((view[position].row(0) - view[position].row(1)).norm() > support); // they have parted
    return {(view[velocity].row(0) - view[velocity].row(1)).norm() / before, view[density](0) / 1000};
}

} // namespace

// What made the paper's block of water fall apart: the density that particles keep after each encounter.
TEST_CASE("A state that nobody reads, advanced by what the pressure does, changes nothing else", "[integrators]") {
    const auto check = [](auto integrator) {
        using I = decltype(integrator);
        const MatrixXd alone = water_after<I>(0.3, 100), with_heat = water_after<I, WarmWater>(0.3, 100);
        CHECK((with_heat - alone).norm() <= 1e-13 * alone.norm());
    };
    check(sph::SymplecticEuler{});
    check(sph::Leapfrog{});
    check(sph::PositionVerlet{});
    check(sph::StaggeredLeapfrog{});
    check(sph::MidpointRungeKutta{});
}

TEST_CASE("Particles that meet and part are as fast and as dense as before, where rates are taken halfway",
          "[integrators]") {
    const Encounter centred = meeting<sph::StaggeredLeapfrog>(), one_sided = meeting<sph::SymplecticEuler>();
    CHECK(centred.speed == Approx(1).margin(1e-3));
    CHECK(centred.density == Approx(1).margin(1e-3));
    CHECK(one_sided.speed > 1.02);
    CHECK(one_sided.density > 1.002);
}

namespace {

/// A drop of water thrown against a block of rubber, out of reach of anything else.
template <class Integrator>
struct Throw {
    sph::Solver<2, double, Integrator, Water, Rubber, Contact> scene;
    sph::PhaseHandle<Water> water;
    sph::PhaseHandle<Rubber> rubber;

    explicit Throw(double young_modulus = 1e5)
        : scene({.gravity = {0, -9.8}, .support_radius = 2.6 * spacing, .cfl = 0.25}) {
        rubber = scene.add(Rubber{{.density = 900,
                                   .sound_speed = sph::sound_speed_of(young_modulus, 0.3, 900),
                                   .shear_modulus = sph::shear_modulus_of(young_modulus, 0.3)}},
                           sph::fill(sph::Box<2>{{0, 0}, {1, 0.4}}, spacing), spacing);
        water = scene.add(Water{{.density = 1000, .sound_speed = 20}},
                          sph::fill(sph::Box<2>{{0.3, 0.42}, {0.7, 0.82}}, spacing), spacing);
        scene[water][velocity].col(1).setConstant(-1);
    }
    Eigen::RowVector2d momentum() const {
        const auto w = scene[water];
        const auto r = scene[rubber];
        return w[mass].col(0).transpose() * w[velocity] + r[mass].col(0).transpose() * r[velocity];
    }
    double total_mass() const { return scene[water][mass].sum() + scene[rubber][mass].sum(); }
};

} // namespace

TEST_CASE("Sub-cycling with one substep is symplectic Euler", "[integrators]") {
    Throw<sph::SymplecticEuler> plain;
    Throw<sph::Subcycled<Rubber>> cycled;
    const double dt = 0.2 * plain.scene.next_step().seconds;
    for (int k = 0; k < 200; ++k) {
        plain.scene.step(dt);
        cycled.scene.step(dt);
        REQUIRE(cycled.scene.substeps() == 1);
    }
    CHECK((in_order<true>(plain.scene[plain.water]) - in_order<true>(cycled.scene[cycled.water])).norm() < 1e-9);
    CHECK((in_order<false>(plain.scene[plain.rubber]) - in_order<false>(cycled.scene[cycled.rubber])).norm() < 1e-9);
    CHECK(in_order<false>(plain.scene[plain.rubber]).rightCols(2).norm() > 0.1); // it was hit
}

TEST_CASE("Sub-cycling conserves momentum, takes long steps, and comes to the same end", "[integrators]") {
    const double stiff = 2e7; // sound in rubber: nine times that in water
    Throw<sph::SymplecticEuler> plain(stiff);
    Throw<sph::Subcycled<Rubber>> cycled(stiff);
    const Eigen::RowVector2d before = cycled.momentum();
    CHECK(cycled.scene.next_step().seconds > 4 * plain.scene.next_step().seconds);
    CHECK(cycled.scene.time_step_limits().size() + cycled.scene.substep_limits().size() ==
          plain.scene.time_step_limits().size());
    const double end = 0.1;
    plain.scene.run_until(end);
    cycled.scene.step();
    CHECK(cycled.scene.substeps() >= 4);
    cycled.scene.run_until(end);
    CHECK(cycled.scene.steps() * 4 < plain.scene.steps());
    const Eigen::RowVector2d weight(0, -9.8 * cycled.total_mass() * end);
    CHECK((cycled.momentum() - before - weight).norm() < 1e-10 * before.norm());
    // the flight of the two: the place of the mean of the rubber, which the impact has set in motion
    const Eigen::RowVector2d mean_plain = plain.scene[plain.rubber][velocity].colwise().mean(),
                             mean_cycled = cycled.scene[cycled.rubber][velocity].colwise().mean();
    CHECK((mean_plain - mean_cycled).norm() < 0.01 * mean_plain.norm());
}

TEST_CASE("A step that is cut off does not spoil the mean velocity of the fast phase, in float either",
          "[integrators]") {
    sph::Solver<2, float, sph::Subcycled<Rubber>, Rubber> scene({.support_radius = 2.6 * spacing});
    const auto rubber = scene.add(Rubber{{.density = 1000, .sound_speed = 10, .shear_modulus = 3e4}},
                                  sph::fill(sph::Box<2>{{5, 5}, {5.6, 5.4}}, spacing), spacing);
    scene[rubber][velocity].rowwise() = Eigen::RowVector2f(1, -2);
    for (const double dt : {5e-4, 1e-6, 1e-9}) {
        scene.step(dt);
        const auto mean = scene[rubber][sph::mean_velocity];
        CHECK((mean.rowwise() - Eigen::RowVector2f(1, -2)).cwiseAbs().maxCoeff() < 1e-5f);
    }
}

namespace {

struct Syrup : sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::DensityDiffusion<C2>,
                          sph::VolumePressure<C2>, sph::MorrisViscosity<C2>, sph::ParticleShifting<C2>> {};
using Dual = sph::DualStepping<sph::MorrisViscosity<C2>, sph::ParticleShifting<C2>>;
template <class Integrator>
using Square = sph::Solver<2, double, Integrator, Syrup>;

/// Syrup in a periodic square that is sheared at 1 m/s, u = sin(2 pi y), and swells a little at the start.
template <class Integrator>
Square<Integrator> sheared() {
    constexpr double dx = 0.05;
    Square<Integrator> scene({.support_radius = 3 * dx,
                              .cfl = 0.4,
                              .periodic_lower = {0, 0},
                              .periodic_length = {1, 1},
                              .search_skin = 0.2}); // no pair is missed during a long step
    const auto syrup = scene.add(Syrup{{.density = 1000, .sound_speed = 20, .viscosity = 10}},
                                 sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, dx), dx);
    auto view = scene[syrup];
    for (int i = 0; i < view.size(); ++i) {
        view[velocity].row(i) << std::sin(2 * std::numbers::pi * view[position](i, 1)), 0;
        view[density](i, 0) *= 1 + 1e-4 * std::sin(2 * std::numbers::pi * view[position](i, 0));
    }
    return scene;
}
template <class Integrator>
MatrixXd syrup_after(double time, int steps) {
    auto scene = sheared<Integrator>();
    for (int k = 0; k < steps; ++k)
        scene.step(time / steps);
    return in_order<true>(scene.template get<Syrup>());
}

} // namespace

TEST_CASE("Dual stepping is of first order", "[integrators]") {
    const double time = 0.02;
    const MatrixXd exact = syrup_after<sph::SymplecticEuler>(time, 3000);
    CHECK(order_of([&](int steps) { return syrup_after<Dual>(time, steps); }, 40, exact) == Approx(1).margin(0.2));
}

TEST_CASE("Dual stepping evaluates the slow terms once in a long step", "[integrators]") {
    using Whole = Square<Dual>::Scene;
    using Slow = Whole::TermsOf<Dual::Slow>;
    using Fast = Whole::AllButTermsOf<Dual::Slow>;
    STATIC_REQUIRE(Slow::plan.sweeps(0) == 2); // viscosity with the sums of shifting, then the nearness of the surface
    STATIC_REQUIRE(Fast::plan.sweeps(0) == 2); // rates of the density, then pressure
    STATIC_REQUIRE(sph::Costs<Square<Dual>>::sweeps<Syrup> == 4);
    STATIC_REQUIRE(sph::Costs<Square<sph::SymplecticEuler>>::sweeps<Syrup> == 3);
    // what both ask for is there in each of them
    STATIC_REQUIRE(Slow::Rows::size + Fast::Rows::size >= Whole::StepRows::size);

    auto plain = sheared<sph::SymplecticEuler>();
    auto dual = sheared<Dual>();
    plain.step();
    dual.step(); // there is an acceleration now
    CHECK(dual.next_step().seconds > 4 * plain.next_step().seconds);
    const auto named = [](const auto& limits, const char* reason) {
        for (const auto& limit : limits)
            if (limit.reason == reason)
                return true;
        return false;
    };
    CHECK(named(dual.time_step_limits(), "advection"));
    CHECK(named(dual.time_step_limits(), "viscous diffusion"));
    CHECK_FALSE(named(dual.time_step_limits(), "sound"));
    CHECK(named(dual.substep_limits(), "sound"));
    CHECK(named(dual.substep_limits(), "acceleration"));
    CHECK_FALSE(named(dual.substep_limits(), "viscous diffusion"));
    CHECK(named(dual.time_step_limits(), "particle shifting"));
    CHECK(dual.time_step_limits().size() + dual.substep_limits().size() == plain.time_step_limits().size() + 2);
}

TEST_CASE("Dual stepping conserves momentum and slows a sheared flow down as it should", "[integrators]") {
    const double end = 0.5;
    auto plain = sheared<sph::SymplecticEuler>();
    auto dual = sheared<Dual>();
    long long substeps = 0;
    const auto fourier = [](const auto& phase) { // of sin(2 pi y), m/s
        double sum = 0;
        for (int i = 0; i < phase.size(); ++i)
            sum += 2 * phase[velocity](i, 0) * std::sin(2 * std::numbers::pi * phase[position](i, 1));
        return sum / phase.size();
    };
    plain.run_until(end);
    dual.run_until(end, [&](const auto& scene) { substeps += scene.substeps(); });
    CHECK(dual.steps() * 4 < plain.steps());
    CHECK(substeps > 4 * dual.steps());
    const auto syrup = dual.get<Syrup>();
    CHECK((syrup[velocity].colwise().sum() / syrup.size()).norm() < 1e-12);
    const double exact = std::exp(-0.01 * 4 * std::numbers::pi * std::numbers::pi * end);
    CHECK(fourier(plain.get<Syrup>()) == Approx(exact).epsilon(0.02));
    CHECK(fourier(syrup) == Approx(fourier(plain.get<Syrup>())).epsilon(0.01));
}

namespace {

/// A drop that turns and stretches, after `time` in steps of a fixed length.
struct Drop
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::VolumePressure<C2>, sph::MonaghanViscosity<C2>> {};
MatrixXd drop_after(double time, double speed, int interval, bool removing = false, double skin = 0) {
    sph::Solver<2, double, sph::SymplecticEuler, Drop> scene(
        {.support_radius = 2.6 * spacing, .time_step = 1e-3, .search_interval = interval, .search_skin = skin});
    const auto drop = scene.add(Drop{{.density = 1000, .sound_speed = 20}},
                                sph::fill(sph::Box<2>{{-1, -1}, {1, 1}}, spacing), spacing);
    auto view = scene[drop];
    for (int i = 0; i < view.size(); ++i)
        view[velocity].row(i) << -speed * (view[position](i, 0) + view[position](i, 1)), speed * view[position](i, 1);
    scene.run_until(time, [&](auto& s) {
        if (removing && s.steps() == 10)
            s.remove_if(drop, [](const auto& x) { return x[1] > 0.5; });
    });
    return in_order<true>(scene[drop]);
}

} // namespace

TEST_CASE("Neighbours that serve several steps", "[integrators]") {
    // slow: 0.3 mm a step at most, of the 13 mm that may be travelled
    const MatrixXd every = drop_after(0.2, 0.2, 1), fourth = drop_after(0.2, 0.2, 4);
    const MatrixXd change = every - drop_after(0.001, 0.2, 1); // what has happened
    CHECK((every - fourth).norm() > 0);                        // the order of the sums is another
    CHECK((every - fourth).norm() < 1e-3 * change.norm());
    // fast: every particle may have travelled too far after one step, so all steps search
    CHECK(drop_after(0.02, 10, 1) == drop_after(0.02, 10, 1000));
    // with a skin no pair is missed, and what differs is the rounding of sums in another order
    const MatrixXd skinned = drop_after(0.2, 2, 1000, false, 0.2), plain = drop_after(0.2, 2, 1);
    CHECK((skinned - plain).norm() > 0);
    CHECK((skinned - plain).norm() < 1e-13 * plain.norm());
    CHECK((drop_after(0.2, 2, 4) - plain).norm() > 1e-10 * plain.norm()); // without it some are
    // particles that are removed leave no trace in the lists
    CHECK((drop_after(0.02, 0.2, 1, true) - drop_after(0.02, 0.2, 1000, true)).norm() < 1e-6);
}

} // namespace integrators_test
