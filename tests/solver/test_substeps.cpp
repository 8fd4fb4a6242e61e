// Steps that are made of shorter ones, of one phase or of some terms: what is summed by both kinds is whole, and the
// long ones are limited by what they are too long for.
#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

namespace substeps_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.05;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Steel : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::VelocityGradient<K>, sph::JaumannStress,
                          sph::StressForce<K>, sph::TimeAveragedMotion> {};
struct Meet : sph::Coupling<Water, Steel, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Oil : sph::Fluid<sph::LinearState, sph::SummationDensity<K>, sph::VolumePressure<K>, sph::TimeAveragedMotion> {};
struct MeetOil : sph::Coupling<Water, Oil, sph::Into<Oil, sph::SummationNeighbours<K>>,
                               sph::Into<Water, sph::VolumeContinuity<K>>, sph::VolumePressure<K>> {};
struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                           sph::TotalLagrangianForce<K>, sph::KernelRepulsion<sph::Spiky>, sph::TimeAveragedMotion> {};

/// Water falls on a solid whose density follows both: the greatest density of the solid, after a few steps, kg/m^3.
template <class Integrator>
double density_of_the_struck() {
    sph::Solver<2, double, Integrator, Water, Steel, Meet> scene(
        {.support_radius = 3 * dx, .periodic_length = {1, 0}, .threads = 1});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0.5}, {1, 1}), dx), dx);
    const auto solid = scene.add(Steel{{.density = 1000, .sound_speed = 20, .shear_modulus = 1e5}},
                                 sph::fill(sph::Box<2>({0, 0}, {1, 0.5}), dx), dx);
    scene[water][sph::velocity].col(1).setConstant(-0.1);
    for (int k = 0; k < 20; ++k)
        scene.step(1e-4);
    return scene[solid][sph::density].maxCoeff();
}

/// The least density of a fluid that is summed over both fluids of a full box, at rest on the lattice, kg/m^3.
template <class Integrator>
double density_beside_another() {
    sph::Solver<2, double, Integrator, Water, Oil, MeetOil> scene(
        {.support_radius = 3 * dx, .periodic_length = {1, 1}, .threads = 1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0.5}, {1, 1}), dx), dx);
    const auto oil =
        scene.add(Oil{{.density = 900, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0}, {1, 0.5}), dx), dx);
    scene.step(1e-4);
    return scene[oil][sph::density].minCoeff();
}

} // namespace

TEST_CASE("A subcycled phase keeps what couplings add to its rates and sums", "[substeps]") {
    const double whole = density_of_the_struck<sph::SymplecticEuler>();
    CHECK(whole > 1001); // so that there is something to be lost
    CHECK(density_of_the_struck<sph::Subcycled<Steel>>() == Approx(whole).margin(0.05));
    CHECK(density_beside_another<sph::Subcycled<Oil>>() == Approx(900).epsilon(1e-3));
}

TEST_CASE("A repulsion within a solid does not reach the neighbours in the body", "[substeps]") {
    const auto start_with = [](double stiffness, double range) {
        sph::Solver<2, double, sph::SymplecticEuler, Rubber> scene({.support_radius = 0.2, .threads = 1});
        Rubber rubber{{.density = 1000, .sound_speed = 10, .shear_modulus = 3e4}};
        rubber.set(sph::KernelRepulsionParameters{.stiffness = stiffness, .range = range});
        scene.add(rubber, sph::fill(sph::Box<2>({0, 0}, {1, 0.5}), 0.1), 0.1);
        scene.prepare();
    };
    CHECK_THROWS_WITH(start_with(1e3, 0),
                      imbibe_test::contains("Rubber: KernelRepulsionParameters::range = 0 spacings, "
                                            "the whole support, pushes the neighbours in a body"));
    CHECK_THROWS_WITH(start_with(1e3, 1.1), imbibe_test::contains("range = 1.1 spacings pushes"));
    CHECK_NOTHROW(start_with(1e3, 1));
    CHECK_NOTHROW(start_with(0, 0));
}

TEST_CASE("A subcycled solid that meets itself sees itself where it is", "[substeps]") {
    sph::Solver<2, double, sph::Subcycled<Rubber>, Rubber> scene({.support_radius = 0.2, .threads = 1});
    Rubber rubber{{.density = 1000, .sound_speed = 10, .shear_modulus = 3e4}};
    rubber.set(sph::KernelRepulsionParameters{.stiffness = 1e3, .range = 0.7});
    const auto block = scene.add(rubber, sph::fill(sph::Box<2>({0, 0}, {1, 0.5}), 0.1), 0.1);
    scene[block][sph::velocity].col(0).setConstant(1); // nothing but a translation
    for (int k = 0; k < 5; ++k)
        scene.step(0.02);
    CHECK(scene.substeps() > 3);
    CHECK((scene[block][sph::velocity].col(0).array() - 1).abs().maxCoeff() < 1e-10);
}

TEST_CASE("A subcycled phase that is moved by more than its velocity shows the others all of it", "[substeps]") {
    struct Drifting : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::Xsph<K>,
                                 sph::XsphTransport, sph::TimeAveragedMotion> {};
    sph::Solver<2, double, sph::Subcycled<Drifting>, Drifting> scene({.support_radius = 3 * dx, .threads = 1});
    const auto drop =
        scene.add(Drifting{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0}, {0.4, 0.4}), dx), dx);
    for (int i = 0; i < scene[drop].size(); ++i)
        scene[drop][sph::velocity](i, 0) = scene[drop][sph::position](i, 1); // a shear, which XSPH smooths
    scene.prepare();
    const auto by_id = [&](auto field) {
        Eigen::MatrixXd all(scene[drop].size(), 2);
        for (int i = 0; i < scene[drop].size(); ++i)
            all.row(scene[drop].ids()[static_cast<std::size_t>(i)]) = scene[drop][field].row(i);
        return all;
    };
    const Eigen::MatrixXd before = by_id(sph::position);
    scene.step(1e-3);
    const Eigen::MatrixXd way = by_id(sph::position) - before;
    CHECK((way - 1e-3 * by_id(sph::mean_velocity)).norm() < 1e-12 * way.norm());
    CHECK((way - 1e-3 * by_id(sph::velocity)).norm() > 1e-3 * way.norm()); // XSPH did something
}

TEST_CASE("A sum of which one half is evaluated in long steps is whole in the short ones", "[substeps]") {
    struct Summed
        : sph::Fluid<sph::LinearState, sph::SummationDensity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {};
    struct Floor : sph::Wall<> {};
    struct On : sph::Coupling<Summed, Floor, sph::Into<Summed, sph::SummationNeighbours<K>>,
                              sph::Into<Floor, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>> {};
    using Slow = sph::DualStepping<sph::MorrisViscosity<K>, sph::SummationNeighbours<K>>;
    sph::Solver<2, double, Slow, Summed, Floor, On> scene(
        {.support_radius = 3 * dx, .cfl = 0.4, .periodic_length = {1, 1}, .threads = 1});
    const auto water = scene.add(Summed{{.density = 1000, .sound_speed = 10, .viscosity = 1}},
                                 sph::fill(sph::Box<2>({0, 0.5}, {1, 1}), dx), dx);
    scene.add(Floor{{.density = 1000}}, sph::fill(sph::Box<2>({0, 0}, {1, 0.5}), dx), dx);
    scene.step(5e-3);
    REQUIRE(scene.substeps() > 1);
    CHECK(scene[water][sph::kernel_sum].minCoeff() ==
          Approx(scene[water][sph::kernel_sum].maxCoeff()).epsilon(1e-3)); // at the floor as inside
}

TEST_CASE("Two terms that ask for the same sum over neighbours get it once", "[substeps]") {
    struct Held : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::SummationFloor<K>,
                             sph::SummationRelaxation<K>, sph::VolumePressure<K>> {};
    sph::Solver<2, double, sph::SymplecticEuler, Held> scene(
        {.support_radius = 3 * dx, .periodic_length = {1, 1}, .threads = 1});
    Held held{{.density = 1000, .sound_speed = 10}};
    held.set(sph::SummationRelaxationParameters{.time = 0.1});
    const auto water = scene.add(held, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    scene.step(1e-3);
    CHECK(scene[water][sph::kernel_sum].maxCoeff() == Approx(1).epsilon(0.02));
}

TEST_CASE("Long steps are limited by walls that a program moves, as fast as it moves them now", "[substeps]") {
    struct Paddle : sph::Wall<> {};
    struct Slosh
        : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {};
    struct Pushed : sph::Coupling<Slosh, Paddle, sph::Into<Paddle, sph::PressureExtrapolation<K>>,
                                  sph::VolumePressure<K>, sph::Into<Slosh, sph::VolumeContinuity<K>>> {};
    sph::Solver<2, double, sph::DualStepping<sph::MorrisViscosity<K>>, Slosh, Paddle, Pushed> scene(
        {.support_radius = 3 * dx, .threads = 1});
    scene.add(Slosh{{.density = 1000, .sound_speed = 20, .viscosity = 1}},
              sph::fill(sph::Box<2>({0, 0}, {0.5, 0.5}), dx), dx);
    const auto paddle = scene.add(Paddle{{.density = 1000}}, sph::fill(sph::Box<2>({-3 * dx, 0}, {0, 0.5}), dx), dx);
    scene.step();
    scene[paddle][sph::velocity].col(0).setConstant(5);
    CHECK(scene.next_step().reason == "advection");
    CHECK(scene.next_step().where == "Paddle");
    CHECK(scene.next_step().seconds == Approx(scene.settings().cfl * dx / 5));
    scene[paddle][sph::velocity].setZero();
    CHECK(scene.next_step().where != "Paddle");
}

namespace {

struct Grains : sph::Fluid<sph::ParticleShifting<K>> {};

/// By how much more a lattice that is a little rough is shifted after twenty steps of the length `step`, s, than in the
/// first, with nothing but shifting, at 1 m/s.
template <int dim>
double roughened(double step, double support, const sph::ParticleShiftingParameters& shifting) {
    constexpr double length = (dim == 2 ? 16 : 10) * dx;
    sph::Settings<dim> settings{.support_radius = support * dx, .search_skin = 0.1, .threads = 1};
    settings.periodic_length.fill(length);
    sph::Solver<dim, double, sph::DualStepping<sph::ParticleShifting<K>>, Grains> scene(settings);
    Grains material{{.density = 1000, .sound_speed = 30}};
    material.set(shifting);
    const sph::Box<dim> box{sph::Point<dim>::Zero(), sph::Point<dim>::Constant(length)};
    const auto all = scene.add(material, sph::jitter<dim>(sph::fill(box, dx), 0.01 * dx, 3), dx);
    scene.step(step);
    const double first = scene[all][sph::transport_correction].norm();
    for (int k = 1; k < 20; ++k)
        scene.step(step);
    return scene[all][sph::transport_correction].norm() / first;
}

} // namespace

TEST_CASE("Shifting smooths places however long steps are, and with half as much again in a step it roughens them",
          "[substeps]") {
    const sph::ParticleShiftingParameters usual{.least_speed = 1}, more{.least_speed = 1, .most_in_a_step = 0.055};
    for (const double support : {2.6, 3.0, 4.0})
        for (const double step : {dx, 100 * dx, 1e4 * dx}) {
            CAPTURE(support, step / dx);
            CHECK(roughened<2>(step, support, usual) < 0.6);
            CHECK(roughened<2>(step, support, more) > 4);
        }
    CHECK(roughened<3>(100 * dx, 2.6, usual) < 0.6);
    CHECK(roughened<3>(100 * dx, 2.6, more) > 4);
}

TEST_CASE("Long steps are no longer than shifting takes to put particles in order", "[substeps]") {
    struct Shifted : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>,
                                sph::MorrisViscosity<K>, sph::ParticleShifting<K>> {};
    using Slow = sph::DualStepping<sph::MorrisViscosity<K>, sph::ParticleShifting<K>>;
    sph::Solver<2, double, Slow, Shifted> scene(
        {.support_radius = 3 * dx, .periodic_length = {1, 1}, .search_skin = 0.1, .threads = 1});
    Shifted water{{.density = 1000, .sound_speed = 100, .viscosity = 1e-3}};
    water.set(sph::ParticleShiftingParameters{.strength = 4, .least_speed = 1});
    const auto fluid = scene.add(water, sph::jitter<2>(sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), 0.05 * dx, 7), dx);
    CHECK(scene.next_step().reason == "particle shifting");
    CHECK(scene.next_step().seconds == Approx(scene.settings().cfl * 2.5 * 0.035 * 9 * dx / 4));
    double farthest = 0;
    for (int k = 0; k < 20; ++k) {
        scene.step();
        const double most = scene[fluid][sph::transport_correction].rowwise().norm().maxCoeff();
        farthest = std::max(farthest, most * scene.last_step().seconds);
    }
    CHECK(farthest < 0.05 * dx); // it was up to 2.5 spacings in a step

    // Where it is evaluated in the short steps the long ones need not know of it.
    sph::Solver<2, double, sph::DualStepping<sph::MorrisViscosity<K>>, Shifted> fast({.support_radius = 3 * dx});
    fast.add(water, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    CHECK(fast.next_step().reason != "particle shifting");
}

} // namespace substeps_test
