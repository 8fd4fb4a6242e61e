// What a scene says of itself: the report at the start, the live line, the estimate of the wall time.
#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

#include <unistd.h>

namespace reports_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::Tait<7>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::SymmetricPressure<K>> {};
struct Calm : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Syrup : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {
};
struct CorrectedSyrup : sph::Fluid<sph::LinearState, sph::CorrectedGradients<K>, sph::MorrisViscosity<K>> {};
using Scene = sph::Solver<2, float, sph::SymplecticEuler, Water, Tank, Sides>;
struct Gate : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::TimeAveragedMotion> {};
struct AtGate : sph::Coupling<Calm, Gate, sph::Into<Gate, sph::PressureExtrapolation<K>>, sph::SymmetricPressure<K>,
                              sph::Into<Calm, sph::Continuity<K>>> {};

struct Shifted : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>,
                            sph::ParticleShifting<K>> {};

template <int>
struct Pier : sph::Wall<> {};
template <class Solid>
struct Beside : sph::Coupling<Water, Solid, sph::Into<Solid, sph::PressureExtrapolation<K>>, sph::SymmetricPressure<K>,
                              sph::MonaghanViscosity<K>> {};

Scene dam() {
    constexpr double dx = 0.02;
    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .threads = 1});
    scene.add(Water{{.density = 1000, .sound_speed = 45}}, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.4}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {0.5, 0.6}), dx, 3, sph::Sides::y_high), dx);
    return scene;
}

std::string text_of_time(const char* format, double seconds) {
    char digits[80];
    std::snprintf(digits, sizeof digits, format, seconds);
    return std::string("t ") + digits + " s";
}

bool says(const std::string& text, const std::string& what) {
    INFO(text);
    CAPTURE(what);
    CHECK(text.find(what) != std::string::npos);
    return text.find(what) != std::string::npos;
}

/// What is printed to a stream while `run` runs.
template <class Run>
std::string printed(const Run& run, std::FILE* stream = stdout) {
    std::fflush(stream);
    std::FILE* const file = std::tmpfile();
    const int number = ::fileno(stream), before = ::dup(number);
    ::dup2(::fileno(file), number);
    run();
    std::fflush(stream);
    ::dup2(before, number);
    ::close(before);
    std::fseek(file, 0, SEEK_END);
    std::string all(static_cast<std::size_t>(std::ftell(file)), ' ');
    std::rewind(file);
    all.resize(std::fread(all.data(), 1, all.size(), file));
    std::fclose(file);
    return all;
}

} // namespace

TEST_CASE("The report of a scene names effects, fields, bytes, sweeps, neighbours and limits", "[reports]") {
    Scene scene = dam();
    const std::string report = sph::describe(scene);
    says(report, "Scene in 2D, float");
    says(report, "1 thread, ");
    says(report, "support radius 52 mm");
    says(report, "Water: 200 particles, spacing 20 mm, ");
    says(report,
         "effects: Tait<7>, Continuity<WendlandC2>, SymmetricPressure<WendlandC2>, MonaghanViscosity<WendlandC2>");
    says(report, "material: density 1000 kg/m^3, sound speed ");
    says(report, "Into<");
    says(report, "PressureExtrapolation<"); // clang++ leaves out what is the default
    // Of the water 2 of position, velocity and acceleration each and 5 others; the wall at rest stores no velocity.
    says(report, "Water: 200 particles, spacing 20 mm, support radius 52 mm, 44 bytes each\n");
    says(report, "Tank: 273 particles, spacing 20 mm, support radius 52 mm, 32 bytes each\n");
    says(report, "    fields:  position, velocity, acceleration, mass, density, pressure, density_rate, "
                 "pressure_over_density2\n    sweeps:  2 a step\n");
    says(report, "    fields:  position, mass, extrapolation_weight, extrapolation_sum, pressure, "
                 "pressure_over_density2, density\n    sweeps:  1 a step\n");
    says(report, "\nSchedule: 3 rounds, 5 loops\n"); // density; the wall's pressure from it; forces
    says(report, "Water on average; 12 numbers of each are loaded in a step\n");
    says(report, "Neighbours: Tank has 1.19048 of Water on average; 4 numbers of each are loaded in a step\n");
    says(report, "Neighbours: Water has 1.625 of Tank on average; 4 numbers of each are loaded in a step\n");
    CHECK(Scene::Scene::plan.rounds == 3);
    CHECK(sph::Costs<Scene>::loads<Water, Water> == 12);
    says(report, " MB for neighbours");
    const auto limits = scene.time_step_limits();
    REQUIRE(limits.size() >= 2);
    for (const auto& limit : limits)
        says(report, sph::text(limit.seconds, " s (", limit.reason, ", ", limit.where, ")"));
    scene.step();
    const double greatest = scene.get<Water>()[sph::acceleration].rowwise().norm().maxCoeff();
    const auto after = scene.time_step_limits();
    const auto acceleration =
        std::find_if(after.begin(), after.end(), [](const auto& limit) { return limit.reason == "acceleration"; });
    REQUIRE(acceleration != after.end());
    CHECK(acceleration->seconds == Approx(std::sqrt(0.02 / greatest)).epsilon(1e-6)); // sqrt(spacing / |a|)
}

TEST_CASE("The report names nothing that is off", "[reports]") {
    sph::Solver<2, float, sph::SymplecticEuler, Calm> scene({.support_radius = 0.052, .threads = 1});
    scene.add(Calm{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>{{0, 0}, {0.2, 0.2}}, 0.02), 0.02);
    const std::string report = sph::describe(scene);
    says(report, "support radius 52 mm, 44 bytes each\n");
    says(report, "effects: LinearState, Continuity<WendlandC2>, SymmetricPressure<WendlandC2>\n    fields:  position, "
                 "velocity, acceleration, mass, density, pressure, density_rate, pressure_over_density2\n"
                 "    sweeps:  2 a step\nSchedule: 2 rounds, 3 loops\n");
    says(report, "of Calm on average; 9 numbers of each are loaded in a step\n");
    for (const char* off : {"iscosity", "viscous", "stress", "deformation", "reference", "acoustic", "normal", "Wall",
                            "Into<", "of Tank", "within it", "repulsion"}) {
        INFO(off << " in\n" << report);
        CHECK(report.find(off) == std::string::npos);
    }
#ifdef __OPTIMIZE__
    CHECK(report.find("Warning") == std::string::npos);
#else
    says(report, "Warning: compiled without optimisation");
#endif
    Scene viscous = dam();
    says(sph::describe(viscous), "iscosity"); // it is seen where it is on
}

TEST_CASE("The report says how the lattice of a fluid under pressure resists shear", "[reports]") {
    constexpr double dx = 0.02;
    sph::Solver<2, double, sph::SymplecticEuler, Syrup> scene({.support_radius = 2.2 * dx, .threads = 1});
    const auto syrup = scene.add(Syrup{{.density = 1000, .sound_speed = 10, .viscosity = 2}},
                                 sph::fill(sph::Box<2>{{0, 0}, {0.2, 0.2}}, dx), dx);
    CHECK(sph::describe(scene).find("lattice:") == std::string::npos); // without pressure
    scene[syrup][sph::density].setConstant(1001);                      // 100 Pa, of which it is 0.0396
    says(sph::describe(scene),
         "    lattice: under its greatest pressure, some 100 Pa, it gives way to slow shear with up to "
         "3.956");
    says(sph::describe(scene), " Pa, as much as its viscosity at 1.978");
    sph::Solver<2, double, sph::SymplecticEuler, CorrectedSyrup> corrected({.support_radius = 2.2 * dx, .threads = 1});
    corrected.add(CorrectedSyrup{{.density = 1000, .sound_speed = 10, .viscosity = 2}},
                  sph::fill(sph::Box<2>{{0, 0}, {0.2, 0.2}}, dx), dx);
    corrected.get<CorrectedSyrup>()[sph::density].setConstant(1001);
    CHECK(sph::describe(corrected).find("lattice:") == std::string::npos);
}

TEST_CASE("The report says what the first step will be", "[reports]") {
    Scene scene = dam();
    const std::string report = sph::describe(scene);
    const auto limits = scene.time_step_limits();
    says(report, sph::text("first step ", scene.next_step().seconds, " s, from ", limits.front().reason));
}

TEST_CASE("A solid alone, whose density is not stored, has a report too", "[reports]") {
    struct Rubber : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>> {};
    sph::Solver<2, double, sph::SymplecticEuler, Rubber> scene({.support_radius = 0.02, .threads = 1});
    scene.add(Rubber{{.density = 1000, .sound_speed = 30, .shear_modulus = 1e5}},
              sph::fill(sph::Box<2>({0, 0}, {0.1, 0.1}), 0.01), 0.01);
    const std::string report = sph::describe(scene);
    says(report, "Rubber: 100 particles");
    CHECK(report.find("density,") == std::string::npos);
}

TEST_CASE("The report says what would make the scene faster", "[reports]") {
    constexpr double dx = 0.02;
    sph::Settings<2> settings{.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .threads = 1};
    const auto report = [](auto scene) { return sph::describe(scene); };
    const auto with = [&](const sph::Settings<2>& how) {
        Scene scene(how);
        scene.add(Water{{.density = 1000, .sound_speed = 45}}, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.4}), dx), dx);
        return report(scene);
    };
    says(with(settings), "faster: search_interval = 100 and search_skin = 0.1");
    settings.search_interval = 100;
    settings.search_skin = 0.1;
    CHECK(with(settings).find("faster") == std::string::npos);

    const auto gate = [&]<class Integrator>(std::type_identity<Integrator>, double sound_speed) {
        sph::Solver<2, float, Integrator, Calm, Gate, AtGate> scene(settings);
        scene.add(Calm{{.density = 1000, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0}, {0.8, 0.4}), dx), dx);
        scene.add(Gate{{.density = 1000, .sound_speed = sound_speed, .shear_modulus = 300 * sph::sq(sound_speed)}},
                  sph::fill(sph::Box<2>({0.8, 0}, {0.88, 0.4}), dx), dx);
        return report(scene);
    };
    says(gate(std::type_identity<sph::SymplecticEuler>{}, 200), "faster: the integrator Subcycled<Gate>");
    CHECK(gate(std::type_identity<sph::SymplecticEuler>{}, 5).find("faster") == std::string::npos);
    CHECK(gate(std::type_identity<sph::Subcycled<Gate>>{}, 200).find("faster") == std::string::npos);

    using Dual = sph::DualStepping<sph::MorrisViscosity<K>, sph::ParticleShifting<K>>;
    const auto stream = [&]<class Integrator>(std::type_identity<Integrator>, double viscosity, double speed = 1) {
        sph::Solver<2, float, Integrator, Shifted> scene(
            {.support_radius = 3 * dx, .periodic_length = {0.4, 0.4}, .search_interval = 100, .search_skin = 0.1});
        scene.add(Shifted{{.density = 1000, .sound_speed = 10, .viscosity = viscosity}},
                  sph::fill(sph::Box<2>({0, 0}, {0.4, 0.4}), dx), dx);
        scene.template get<Shifted>()[sph::velocity].col(0).setConstant(static_cast<float>(speed));
        return report(scene);
    };
    says(stream(std::type_identity<sph::SymplecticEuler>{}, 0.1),
         "faster: the integrator DualStepping<MorrisViscosity");
    CHECK(stream(std::type_identity<sph::SymplecticEuler>{}, 1000).find("faster") ==
          std::string::npos); // it limits steps
    CHECK(stream(std::type_identity<sph::SymplecticEuler>{}, 0, 0).find("faster: the integrator") == std::string::npos);
    CHECK(stream(std::type_identity<Dual>{}, 0.1).find("faster") == std::string::npos);
}

TEST_CASE("The live line says how far, how fast, what limits the step, and how long still", "[reports]") {
    Scene scene = dam();
    sph::Progress progress(1.0, false);
    progress(scene); // before the first step
    while (scene.steps() < 30)
        scene.step();
    const std::string line = progress.line(scene);
    char expected[80];
    std::snprintf(expected, sizeof expected, "%5.1f %%  t %.4f s  step 30  dt %.2e s (", 100 * scene.time(),
                  scene.time(), scene.last_step().seconds);
    CHECK(line.rfind(expected, 0) == 0);
    says(sph::Progress(2e-6, false).line(scene), text_of_time("%.8f", scene.time()));
    says(line, "(" + scene.last_step().reason + ", " + scene.last_step().where + ")");
    says(line, " M particle-steps/s  left ");
    CHECK(std::isdigit(static_cast<unsigned char>(line.back())));
}

TEST_CASE("The live line shows the last step that the end of the run did not cut off", "[reports]") {
    Scene scene = dam();
    sph::Progress progress(0.01, false);
    double whole = 0;
    std::string reason;
    const auto watch = [&](const Scene& s) {
        if (s.last_step().reason != "end of run") {
            whole = s.last_step().seconds;
            reason = s.last_step().reason;
        }
    };
    const std::string said = printed([&] { scene.run_until(0.01, std::ref(progress), watch); });
    REQUIRE(scene.last_step().reason == "end of run");
    char expected[60];
    std::snprintf(expected, sizeof expected, "dt %.2e s (", whole);
    says(said, expected + reason + ", ");
    CHECK(said.find("end of run") == std::string::npos);
    sph::Progress other(0.01, false);
    printed([&] { scene.run_until(0.01 + 1e-9, std::ref(other)); }); // nothing but a step that is cut off
    says(other.line(scene), "(end of run, caller)");
    REQUIRE_THROWS_WITH(sph::Progress(-1, false), imbibe_test::contains("end = -1 s"));
    REQUIRE_THROWS_WITH(sph::Progress(std::nan(""), true), imbibe_test::contains("end = nan s"));
}

TEST_CASE("Couplings and phases of one name are told apart in the report and in the limits", "[reports]") {
    constexpr double dx = 0.02;
    sph::Solver<2, float, sph::SymplecticEuler, Water, Pier<0>, Pier<1>, Beside<Pier<0>>, Beside<Pier<1>>> scene(
        {.support_radius = 2.6 * dx, .threads = 1});
    Water water{{.density = 1000, .sound_speed = 45}};
    scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.2}), dx), dx);
    scene.add(Pier<0>{{.density = 1000}}, sph::fill(sph::Box<2>({-0.06, 0}, {0, 0.2}), dx), dx);
    scene.add(Pier<1>{{.density = 1000}}, sph::fill(sph::Box<2>({0.2, 0}, {0.26, 0.2}), dx), dx);
    const std::string report = sph::describe(scene);
    says(report, "  Pier_2: 30 particles");
    says(report, "  Pier_3: 30 particles");
    says(report, "  Beside_1 (Water, Pier_2): ");
    says(report, "  Beside_2 (Water, Pier_3): ");
    const auto limits = scene.time_step_limits();
    for (const char* name : {"Beside_1", "Beside_2"})
        CHECK(std::count_if(limits.begin(), limits.end(), [&](const auto& l) { return l.where == name; }) > 0);
}

TEST_CASE("A warning is printed to the standard error stream as it comes, and neither by Progress nor in the report",
          "[reports]") {
    sph::Solver<2, float, sph::SymplecticEuler, Calm> scene({.support_radius = 0.021, .threads = 1});
    const std::string told = printed(
        [&] {
            scene.add(Calm{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>{{0, 0}, {0.2, 0.2}}, 0.02),
                      0.02);
        },
        stderr);
    REQUIRE(scene.warnings().size() == 1);
    CHECK(told == "Warning: " + scene.warnings().front() + "\n");
    sph::Progress progress(0.01, false);
    const std::string said = printed([&] { scene.run_until(0.01, std::ref(progress)); });
    CHECK(said.find(scene.warnings().front()) == std::string::npos);
    says(said, "100.0 %");
    CHECK(sph::describe(scene).find(scene.warnings().front()) == std::string::npos);
}

TEST_CASE("An interval of every() that makes no sense is refused by that name", "[reports]") {
    const auto nothing = [](auto&) {};
    REQUIRE_THROWS_WITH(sph::every(0, nothing), imbibe_test::contains("every(interval, ...): interval = 0 s"));
    REQUIRE_THROWS_WITH(sph::every(std::nan(""), nothing), imbibe_test::contains("interval = nan s"));
}

TEST_CASE("An interval of every() that is far below a step is every step", "[reports]") {
    struct Clock {
        double now;
        double time() const { return now; }
        long long steps() const { return 0; }
        imbibe::TimeStepLimit last_step() const { return {0, "", ""}; }
    };
    for (const double interval : {1e-6, 1e-12, 1e-300}) {
        int calls = 0;
        auto observer = sph::every(interval, [&](const Clock&) { ++calls; });
        for (const double time : {0.0, 0.3, 0.6, 1e3}) {
            Clock clock{time};
            observer(clock);
        }
        CHECK(calls == 4);
    }
}

TEST_CASE("every() calls at the same steps where a run goes on and where time has gone back", "[reports]") {
    struct Clock {
        double now, step;
        double time() const { return now; }
        long long steps() const { return now > 0; }
        sph::TimeStepLimit last_step() const { return {step, "", ""}; }
    };
    std::vector<double> times;
    const auto note = [&](const auto& s) { times.push_back(s.time()); };
    auto observer = sph::every(0.5, note);
    const std::vector<Clock> run{{0, 0}, {0.3, 0.3}, {0.6, 0.3}, {0.9, 0.3}, {1.1, 0.2}};
    for (const Clock& clock : run)
        observer(clock);
    CHECK(times == std::vector<double>{0, 0.6, 1.1});
    SECTION("back to a step at which it was not called") {
        for (const Clock& clock : {Clock{0.9, 0.3}, Clock{1.1, 0.2}, Clock{1.1, 0.2}, Clock{1.2, 0.1}})
            observer(clock);
        CHECK(times == std::vector<double>{0, 0.6, 1.1, 1.1});
    }
    SECTION("back to one at which it was") {
        for (const Clock& clock : {Clock{0.6, 0.3}, Clock{0.9, 0.3}})
            observer(clock);
        CHECK(times == std::vector<double>{0, 0.6, 1.1, 0.6});
    }
    for (const Clock& at : run) { // told that all is done up to there
        auto told = sph::every(0.5, note);
        times.clear();
        told.resume(at.now);
        told(at);
        CHECK(times.empty());
    }
    for (std::size_t from = 1; from < run.size(); ++from) { // a restart after any step
        auto again = sph::every(0.5, note);
        times.clear();
        for (std::size_t k = from; k < run.size(); ++k)
            again(run[k]);
        CHECK(times == (from <= 2 ? std::vector<double>{0.6, 1.1} : std::vector<double>{1.1}));
    }
}

TEST_CASE("The estimate of the wall time steps a copy, and is nothing for nothing to do", "[reports]") {
    Scene scene = dam();
    CHECK(sph::estimate_wall_seconds(scene, 1) > 0);
    CHECK(sph::estimate_wall_seconds(scene, scene.time()) == 0);
    CHECK(scene.steps() == 0);
    scene.get<Water>()[sph::velocity](3, 0) = 1e35f; // the first step is the last that can be taken
    CHECK(sph::estimate_wall_seconds(scene, 1) == 0);
}

} // namespace reports_test
