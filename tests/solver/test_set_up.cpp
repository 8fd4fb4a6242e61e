// A set-up that cannot be right is said: phases that nothing keeps apart, particles over particles, lattices that do
// not fit, parts that are too thin, spacings too wide, materials and checkpoints that differ. And what is right is not.
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/geometry/transform.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/hourglass_control.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>

#include <catch_shim.hpp>

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace set_up_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
constexpr double dx = 0.01;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Block : sph::Wall<> {};
struct Jelly : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped> {};
struct Contact : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>> {};
struct Load : sph::Coupling<Water, Jelly, sph::Into<Jelly, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Water, sph::VolumeContinuity<K>>,
                            sph::Into<Jelly, sph::ReactionForce<sph::VolumePressure<K>>>> {};
struct Apart : sph::Coupling<Water, Block> {}; // nothing acts, and that is meant

/// Nothing acts between Block and any other, nor between Jelly and Tank.
using Loose = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Block, Jelly, Contact, Load>;
using Meant = sph::Solver<2, double, sph::SymplecticEuler, Water, Block, Apart>;

const Water water{{.density = 1000, .sound_speed = 28}};
const Jelly jelly{{.density = 1000,
                   .sound_speed = sph::sound_speed_of(1e5, 0.3, 1000),
                   .shear_modulus = sph::shear_modulus_of(1e5, 0.3),
                   .support_radius = 1.5 * dx}};
const Tank tank{{.density = 1000}};
const Block block{{.density = 1000}};

sph::Settings<2> settings(double gravity = 0) {
    return {.gravity = {0, -gravity}, .support_radius = 2.6 * dx, .threads = 1, .on_warning = {}};
}
std::vector<sph::Point<2>> box(double x, double y, double width, double height, double spacing = dx) {
    return sph::fill(sph::Box<2>({x, y}, {x + width, y + height}), spacing);
}
template <class Scene>
std::string said(const Scene& scene) {
    std::string all;
    for (const auto& sentence : scene.warnings())
        if (!sph::text(sentence).ends_with("was scene.add forgotten?"))
            all += sentence + "\n";
    return all;
}
template <class Handle>
void push(Loose& scene, const Handle& body, double x, double y) {
    scene[body][sph::velocity].col(0).setConstant(x);
    scene[body][sph::velocity].col(1).setConstant(y);
}

TEST_CASE("Water that comes within reach of a wall it is not coupled to is said once, and ends a guarded run",
          "[set-up]") {
    const auto start = [] {
        Loose scene(settings(9.81));
        scene.add(water, box(0, 0, 0.1, 0.2), dx);
        scene.add(tank, sph::tank(sph::Box<2>({0, 0}, {0.4, 0.3}), dx, 3, sph::Sides::y_high), dx);
        scene.add(block, box(0.13, 0, 0.05, 0.1), dx);
        scene.prepare();
        return scene;
    };
    Loose scene = start();
    CHECK(said(scene).empty()); // Block is 3 cm away, and Tank touches it from the start
    CHECK(scene.meetings().empty());
    scene.run_until(0.1);
    REQUIRE(scene.meetings().size() == 1);
    const sph::Meeting& met = scene.meetings()[0];
    CHECK(met.first == "Water");
    CHECK(met.second == "Block");
    CHECK(met.time < 0.06);
    CHECK(met.distance < 0.026);
    CHECK(met.position[0] == Approx(0.135 - 0.026).margin(0.01));
    CHECK_THAT(said(scene), imbibe_test::contains("Block is within reach of Water (0.026 m) at (0.1") &&
                                imbibe_test::contains("as in struct Sides : Coupling<Water, Block, ...>"));
    CHECK(scene.warnings().size() == 2); // Jelly has no particles

    Loose guarded = start();
    try {
        guarded.run_until(0.1, sph::Guard<2>());
        FAIL("the run did not end");
    } catch (const sph::Diverged& error) {
        CHECK(error.cause == sph::Cause::met);
        CHECK(error.time < 0.06);
        CHECK_THAT(error.what(), imbibe_test::contains("Block is within reach of Water"));
    }
    CHECK_THAT(sph::describe(scene), imbibe_test::contains("Nothing acts between: Water and Block; Tank and Block; "
                                                           "Tank and Jelly; Block and Jelly\n"));
}

TEST_CASE("A coupling without terms says that nothing is to act", "[set-up]") {
    Meant scene(settings());
    const auto drop = scene.add(water, box(0, 0, 0.05, 0.05), dx);
    scene.add(block, box(0.1, 0, 0.05, 0.05), dx);
    scene[drop][sph::velocity].col(0).setConstant(1);
    scene.run_until(0.08, sph::Guard<2>());
    CHECK(scene[drop][sph::position].col(0).minCoeff() > 0.07); // it went in
    CHECK(said(scene).empty());
    CHECK(sph::describe(scene).find("Nothing acts") == std::string::npos);
}

TEST_CASE("A solid that nothing keeps out of a wall is said when the two touch", "[set-up]") {
    Loose scene(settings());
    const auto body = scene.add(jelly, box(0.5, 0.5, 0.05, 0.05), dx);
    scene.add(block, box(0.5, 0.4, 0.05, 0.05), dx);
    push(scene, body, 0, -1);
    scene.run_until(0.03); // 2 cm apart now
    CHECK(scene.meetings().empty());
    scene.run_until(0.07);
    REQUIRE(scene.meetings().size() == 1);
    CHECK(scene.meetings()[0].time == Approx(0.05).margin(0.005));
    CHECK_THAT(said(scene), imbibe_test::contains("Block and Jelly touch at (0.5") &&
                                imbibe_test::contains("Coupling<Block, Jelly, KernelRepulsion<>>"));
}

TEST_CASE("A rigid box that sinks into the floor is said", "[set-up]") {
    Loose scene(settings());
    scene.add(tank, box(0, -0.03, 0.2, 0.03), dx);
    const auto heavy = scene.add(block, box(0.05, 0.04, 0.05, 0.05), dx);
    scene.add(water, box(1, 1, 0.02, 0.02), dx); // far away; something has to move
    const auto sink = [&](Loose& all) { all[heavy][sph::position].col(1).array() -= all.last_step().seconds; };
    scene.run_until(0.03, sink);
    CHECK(scene.meetings().empty());
    scene.run_until(0.06, sink);
    REQUIRE(scene.meetings().size() == 1);
    CHECK_THAT(said(scene), imbibe_test::contains("Tank and Block touch"));
}

TEST_CASE("Two bodies of one total-Lagrangian phase that touch are said", "[set-up]") {
    Loose scene(settings());
    auto points = box(0, 0, 0.05, 0.05);
    for (const auto& x : box(0.1, 0, 0.05, 0.05))
        points.push_back(x);
    const auto bodies = scene.add(jelly, points, dx);
    for (int i = 0; i < scene[bodies].size(); ++i)
        scene[bodies][sph::velocity](i, 0) = scene[bodies][sph::position](i, 0) < 0.07 ? 1 : -1;
    scene.run_until(0.015);
    CHECK(said(scene).empty());
    scene.run_until(0.03);
    REQUIRE(scene.meetings().size() == 1);
    CHECK(scene.meetings()[0].first == scene.meetings()[0].second);
    CHECK_THAT(said(scene), imbibe_test::contains("two bodies of Jelly touch at (0.0"));
}

TEST_CASE("A held solid that bends beside the wall it grows out of is no meeting", "[set-up]") {
    Loose scene(settings(2));
    scene.add(tank, box(-0.03, -0.03, 0.03, 0.1), dx);
    const auto arm = scene.add(jelly, box(0, 0, 0.15, 0.04), dx);
    scene.hold(arm, [](const auto& x) { return x[0] < 2 * dx; });
    scene.run_until(0.2, sph::Guard<2>());
    CHECK(scene[arm][sph::position].col(1).minCoeff() < -0.002); // it has bent
    CHECK(scene.meetings().empty());
    CHECK(said(scene).empty());
}

TEST_CASE("Particles over particles of their phase are said, with place and number", "[set-up]") {
    SECTION("two fills that overlap") {
        Loose scene(settings());
        auto points = box(0, 0, 0.3, 0.2);
        for (const auto& x : box(0.205, 0.005, 0.395, 0.195))
            points.push_back(x);
        scene.add(water, points, dx);
        scene.prepare();
        CHECK_THAT(said(scene), imbibe_test::contains("Water: 368 of 1341 particles lie where others of Water are: "
                                                      "around that at (0.2") &&
                                    imbibe_test::contains("m particles fill 2.0") &&
                                    imbibe_test::contains("fill(a - b, spacing)"));
    }
    SECTION("walls") {
        Loose scene(settings());
        scene.add(tank, box(0, 0, 0.2, 0.03), dx);
        scene.add(tank, box(0.184, 0.001, 0.03, 0.2), dx);
        scene.prepare();
        CHECK_THAT(said(scene), imbibe_test::contains("Tank: 7 of 120 particles lie where others of Tank are"));
    }
    SECTION("water fed into water, said once") {
        Loose scene(settings());
        scene.add(water, box(0, 0, 0.2, 0.1), dx);
        scene.prepare();
        CHECK(said(scene).empty());
        for (int k = 1; k <= 5; ++k) {
            scene.step();
            scene.add(water, box(0.05 + 1e-3 * k, 0.022 + 1e-3 * k, 0.05, 0.05), dx);
        }
        scene.step();
        CHECK_THAT(said(scene), imbibe_test::contains("Water: 25 of 25 particles lie"));
        CHECK(std::count(scene.warnings().begin(), scene.warnings().end(), scene.warnings().back()) == 1);
        CHECK(scene.warnings().size() == 4); // three phases are empty
    }
    SECTION("not where a lattice is shaken, nor where water is fed beside water") {
        Loose scene(settings());
        scene.add(water, sph::jitter<2>(box(0, 0, 0.4, 0.4), 0.3 * dx, 7), dx);
        scene.prepare();
        scene.step(1e-9);
        scene.add(water, box(0.4, 0, 0.1, 0.4), dx);
        scene.step(1e-9);
        CHECK(said(scene).empty());
    }
}

TEST_CASE("Coupled phases on lattices that differ are said", "[set-up]") {
    const sph::Box<2> cell({0, 0}, {0.4, 0.4});
    const sph::Sphere<2> disc({0.2, 0.2}, 0.075);
    const auto warnings = [&](const std::vector<sph::Point<2>>& wall) {
        Loose scene(settings());
        scene.add(water, sph::fill(cell - disc, dx), dx);
        scene.add(tank, wall, dx);
        scene.prepare();
        return said(scene);
    };
    CHECK_THAT(warnings(sph::fill(cell & disc, dx)), imbibe_test::contains("Water and Tank touch") &&
                                                         imbibe_test::contains("differ by (0.5, 0.5) spacings") &&
                                                         imbibe_test::contains("fill(shape, spacing, anchor)"));
    CHECK_THAT(warnings(sph::fill(cell & disc, dx, cell.lower())), !imbibe_test::contains("lattices"));
    // Phases that do not touch lie as they like.
    Loose scene(settings());
    scene.add(water, box(0, 0, 0.2, 0.2), dx);
    scene.add(tank, box(0.225, 0.003, 0.1, 0.2), dx);
    scene.prepare();
    CHECK(said(scene).empty());
}

TEST_CASE("Solids and walls of too few layers are said", "[set-up]") {
    const auto solid = [](double thickness) {
        Loose scene(settings());
        scene.add(jelly, box(0, 0, 0.3, thickness), dx);
        scene.prepare();
        return said(scene);
    };
    CHECK_THAT(solid(dx), imbibe_test::contains("Jelly: 30 of 30 particles lie in parts that are one particle thick") &&
                              imbibe_test::contains("a spacing of 0.0025 m for what is 0.01 m thick"));
    CHECK(solid(2 * dx).empty());
    const auto plate = [](int layers, double spacing, double support, bool as_solid) {
        auto with = settings();
        with.support_radius = support * dx;
        Loose scene(with);
        scene.add(water, box(0, 0, 0.2, 0.2), dx);
        const auto points = box(0.2, 0, layers * spacing, 0.2, spacing);
        if (as_solid)
            scene.add(jelly, points, spacing);
        else
            scene.add(tank, points, spacing);
        scene.prepare();
        return said(scene);
    };
    CHECK_THAT(plate(1, dx, 2.6, false),
               imbibe_test::contains("Tank: 20 of 20 particles lie in parts of fewer than 2 layers") &&
                   imbibe_test::contains("Water reaches 0.026 m, 2.6 spacings of Tank"));
    CHECK(plate(2, dx, 2.6, false).empty());
    CHECK(plate(1, dx, 2, false).empty());
    CHECK_THAT(plate(2, 0.5 * dx, 2.6, false), imbibe_test::contains("fewer than 3 layers"));
    CHECK(plate(3, 0.5 * dx, 2.6, false).empty());
    CHECK_THAT(plate(1, dx, 2.6, true), imbibe_test::contains("Jelly: 20 of 20 particles lie in parts of fewer than"));
    CHECK(plate(2, dx, 2.6, true).empty());
    // Thick bodies with tips and edges.
    Loose scene(settings());
    scene.add(jelly, sph::fitted(sph::Sphere<2>({0, 0}, 0.1), dx), dx);
    scene.add(tank, sph::tank(sph::Box<2>({-0.2, -0.2}, {0.2, 0.2}), dx, 3), dx);
    scene.add(water, sph::fill(sph::Box<2>({-0.2, -0.2}, {0.2, -0.12}), dx), dx);
    scene.prepare();
    CHECK(said(scene).empty());
}

TEST_CASE("A surface that runs in steps across the lattice is said", "[set-up]") {
    const sph::Box<2> beam({0, 0}, {40 * dx, 6 * dx});
    const auto solid = [](const std::vector<sph::Point<2>>& points) {
        Loose scene(settings());
        scene.add(jelly, points, dx);
        scene.prepare();
        return said(scene);
    };
    CHECK(solid(sph::fill(beam, dx)).empty());
    for (const double degrees : {3.0, 10.0, 30.0}) {
        const auto turned = sph::rotated(beam, degrees * std::numbers::pi / 180);
        CAPTURE(degrees);
        CHECK_THAT(solid(sph::fill(turned, dx)), imbibe_test::contains("Jelly: its surface runs in steps") &&
                                                     imbibe_test::contains("fitted(shape, spacing)"));
        CHECK(solid(sph::fitted(turned, dx)).empty());
    }
    const sph::Sphere<2> disc({0, 0}, 10 * dx);
    CHECK_THAT(solid(sph::fill(disc, dx)), imbibe_test::contains("in steps"));
    CHECK(solid(sph::fitted(disc, dx)).empty());

    // Of a wall, where a fluid is.
    const auto slide = [&](const std::vector<sph::Point<2>>& wall, double water_at) {
        Loose scene(settings());
        scene.add(tank, wall, dx);
        auto points = sph::fill(sph::Box<2>({0.05, water_at}, {0.35, water_at + 0.05}), dx);
        for (auto& x : points) // turned with the wall
            x = sph::rotated(beam, -0.2).image(x);
        scene.add(water, points, dx);
        scene.prepare();
        return said(scene);
    };
    const sph::Box<2> floor({0, -4 * dx}, {40 * dx, 0});
    CHECK_THAT(slide(sph::fill(sph::rotated(floor, -0.2), dx), 0),
               imbibe_test::contains("Tank: its surface runs in steps") && imbibe_test::contains("walls_of"));
    CHECK(slide(sph::fill(sph::rotated(floor, -0.2), dx), 0.2).empty());
    CHECK(slide(sph::fitted(sph::rotated(floor, -0.2), dx), 0).empty());
}

TEST_CASE("A spacing too wide for the reach of a coupling is said", "[set-up]") {
    const auto floor = [](double coarser) {
        const double wide = coarser * dx;
        Loose scene(settings());
        scene.add(water, box(0, 0, 0.24, 0.1), dx);
        Jelly soft = jelly;
        soft.support_radius = 1.5 * wide;
        scene.add(soft, box(0, -0.24, 0.24, 0.24, wide), wide);
        scene.prepare();
        return said(scene);
    };
    CHECK_THAT(floor(4), imbibe_test::contains("Water and Jelly see each other over 0.026 m, 0.65 spacings of Jelly") &&
                             imbibe_test::contains("a spacing of at most 0.02 m"));
    CHECK(floor(2).empty());
}

TEST_CASE("Ponds at different heights do not press on each other", "[set-up]") {
    const auto ponds = [](double gap, double deep) {
        auto with = settings(9.81);
        Loose scene(with);
        Water soft = water;
        soft.sound_speed = 14; // for 1 m: a twentieth
        scene.add(soft, box(0, 0, 0.1, 0.4), dx);
        scene.add(soft, box(0.1 + gap, 100, 0.1, deep), dx);
        scene.prepare();
        return said(scene);
    };
    CHECK(ponds(1, 0.9).empty());
    CHECK_THAT(ponds(1, 1.2), imbibe_test::contains("its weight alone compresses it by 5.9"));
}

TEST_CASE("A second add with other coefficients is refused", "[set-up]") {
    Loose scene(settings());
    Water thick = water;
    scene.add(thick, box(0, 0, 0.1, 0.1), dx);
    thick.set(sph::MonaghanViscosityParameters{.alpha = 0.25});
    CHECK_THROWS_WITH(scene.add(thick, box(0.1, 0, 0.1, 0.1), dx),
                      imbibe_test::contains("Water: particles were added with MonaghanViscosityParameters 1, 0 before "
                                            "and 0.25, 0 now; use a second phase"));
    CHECK(scene.particles() == 100);
}

TEST_CASE("What a checkpoint has other than the scene that reads it is said", "[set-up]") {
    const auto folder = std::filesystem::temp_directory_path() / "imbibe_set_up_test";
    std::filesystem::create_directories(folder);
    const auto build = [](double width, double sound, double shift = 0) {
        Loose scene(settings(9.81));
        Water one = water;
        one.sound_speed = sound;
        scene.add(one, box(0, 0, 0.1, 0.1), dx);
        scene.add(tank, sph::tank(sph::Box<2>({0, 0}, {width, 0.2}), dx, 3), dx);
        scene.add(jelly, box(0.15 + shift, 0.1, 0.03, 0.05), dx);
        scene.step();
        return scene;
    };
    const auto fresh = [&](double width, double sound, bool other_jelly = false) {
        Loose scene(settings(9.81));
        Water one = water;
        one.sound_speed = sound;
        scene.add(one, box(0, 0, 0.1, 0.1), dx);
        scene.add(tank, sph::tank(sph::Box<2>({0, 0}, {width, 0.2}), dx, 3), dx);
        scene.add(jelly, other_jelly ? box(0.15, 0.1, 0.05, 0.03) : box(0.15, 0.1, 0.03, 0.05), dx);
        sph::read_checkpoint(scene, folder / "checkpoint");
        return said(scene);
    };
    Loose scene = build(0.3, 28);
    sph::write_checkpoint(scene, folder / "checkpoint");
    CHECK(fresh(0.3, 28).empty());
    CHECK_THAT(fresh(0.3, 30.5), imbibe_test::contains("Water: sound speed = 28 m/s there, 30.5 m/s here"));
    CHECK_THAT(fresh(0.4, 28), imbibe_test::contains("Tank has 336 particles there and 396 in this scene") &&
                                   imbibe_test::contains("goes on with the checkpoint's"));
    CHECK_THAT(fresh(0.3, 28, true), imbibe_test::contains("Jelly has another shape there than in this scene"));
    // A run that goes back has moved its own.
    scene.step();
    sph::read_checkpoint(scene, folder / "checkpoint");
    CHECK(said(scene).empty());
    std::filesystem::remove_all(folder);
}

TEST_CASE("Warnings are told as they come, once, to whom the settings name", "[set-up]") {
    std::vector<std::string> told;
    auto with = settings();
    with.support_radius = 1.2 * dx;
    with.on_warning = [&](const std::string& sentence) { told.push_back(sentence); };
    sph::Solver<2, double, sph::SymplecticEuler, Water, Block, Apart> scene(with);
    scene.add(water, box(0, 0, 0.1, 0.1), dx);
    CHECK(told.size() == 1); // the support
    scene.add(block, box(0, 1, 0.1, 0.1), dx);
    scene.prepare();
    scene.step();
    scene.warn("the pump is off");
    scene.warn("the pump is off");
    CHECK(told.size() == 3);
    CHECK(told == scene.warnings());
    CHECK(told.back() == "the pump is off");
    REQUIRE(sph::Settings<2>{}.on_warning);
}

} // namespace set_up_test
