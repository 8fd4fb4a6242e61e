// Checkpoints: a run that is stopped and goes on is the run that was not stopped, bit by bit; and no file that is cut
// off, damaged or of another scene is taken for a good one.
#include "folder.hpp"
#include "full_disk.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

namespace checkpoint_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

// Water on an elastic block, with a periodic side: moving and reference neighbours, images, a coupling.
struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MonaghanViscosity<K>> {};
struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::HourglassControl<K>, sph::Clamped> {};
struct Contact : sph::Coupling<Water, Block, sph::Into<Block, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>> {};
template <class Real, class Integrator = sph::SymplecticEuler>
using Scene = sph::Solver<2, Real, Integrator, Water, Block, Contact>;
struct LooseContact
    : sph::Coupling<Water, Block, sph::Into<Block, sph::PressureExtrapolation<K>>,
                    sph::VolumePressure<K, sph::Tension::none>, sph::Into<Water, sph::VolumeContinuity<K>>> {};

template <int>
struct Numbered : sph::Fluid<> {};

template <class Real, class Integrator = sph::SymplecticEuler>
Scene<Real, Integrator> make(double density = 1000, int search_interval = 1, double time_step = 0) {
    const double dx = 0.05;
    Scene<Real, Integrator> scene({.gravity = {0, -9.81},
                                   .support_radius = 2.6 * dx,
                                   .time_step = time_step,
                                   .periodic_length = {1, 0},
                                   .search_interval = search_interval,
                                   .threads = 2});
    scene.add(Water{{.density = density, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0.22}, {1, 0.72}), dx), dx);
    Block block;
    block.density = 1200;
    block.sound_speed = sph::sound_speed_of(1e5, 0.3, 1200);
    block.shear_modulus = sph::shear_modulus_of(1e5, 0.3);
    const auto solid = scene.add(block, sph::fill(sph::Box<2>({0, 0}, {1, 0.2}), dx), dx);
    scene.hold(solid, [](const auto& x) { return x[1] < 0.05; });
    return scene;
}

/// Every number of every particle, in the order of storage, as bytes.
template <class S>
std::string bits(const S& scene) {
    std::string all;
    scene.engine().for_each_phase([&](auto, const auto& s) {
        all.append(reinterpret_cast<const char*>(s.ids.data()), s.ids.size() * sizeof(s.ids[0]));
        for (int k = 0; k < s.component_total; ++k)
            all.append(reinterpret_cast<const char*>(s.column(k)),
                       static_cast<std::size_t>(s.size()) * sizeof(*s.column(k)));
    });
    return all;
}

template <class S>
void run(S& scene, int steps) {
    for (int k = 0; k < steps; ++k) {
        scene.step();
        if (k % 40 == 39) // particles that leave must be missing afterwards, too
            scene.remove_if(sph::PhaseHandle<Water>{}, [](const auto& x) { return x[1] > 0.66 && x[0] > 0.5; });
    }
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace

TEMPLATE_TEST_CASE("A restarted run is the uninterrupted one, bit by bit", "[checkpoint]", float, double) {
    const auto path = output_test::fresh("checkpoint") / "run";
    auto whole = make<TestType>();
    run(whole, 80);
    sph::write_checkpoint(whole, path, {{"rows", 17}, {"drained", 0.125}});
    const auto whole_at_checkpoint = whole.particles();
    run(whole, 80);

    auto second = make<TestType>();
    const auto notes = sph::read_checkpoint(second, path);
    CHECK(notes == sph::CheckpointNotes{{"drained", 0.125}, {"rows", 17}});
    CHECK(second.steps() == 80);
    CHECK(second.particles() == whole_at_checkpoint);
    run(second, 80);
    CHECK(second.time() == whole.time());
    CHECK(second.steps() == whole.steps());
    CHECK((bits(second) == bits(whole)));
    CHECK(second.last_step().seconds == whole.last_step().seconds);
    REQUIRE(whole.particles() < make<TestType>().particles()); // some had left
}

TEMPLATE_TEST_CASE("A restarted run is the uninterrupted one with other integrators, too", "[checkpoint]",
                   sph::StaggeredLeapfrog, sph::Leapfrog, sph::PositionVerlet) {
    const auto path = output_test::fresh("checkpoint_integrators") / "run";
    auto whole = make<float, TestType>();
    run(whole, 80);
    sph::write_checkpoint(whole, path);
    run(whole, 80);
    auto second = make<float, TestType>();
    sph::read_checkpoint(second, path);
    run(second, 80);
    CHECK((bits(second) == bits(whole)));
}

TEST_CASE("Where neighbours serve several steps, a timed checkpoint waits for the next search", "[checkpoint]") {
    const auto path = output_test::fresh("checkpoint_interval") / "run";
    auto whole = make<float>(1000, 3), watched = make<float>(1000, 3);
    const auto steps = [](auto& scene, int count) {
        for (int k = 0; k < count; ++k)
            scene.step();
    };
    steps(whole, 90);
    sph::Checkpoints always(path, 0);
    int written = 0;
    for (int k = 0; k < 50; ++k) {
        steps(watched, 1);
        written += always(watched, [] { return sph::CheckpointNotes{}; });
    }
    CHECK(written > 10);
    CHECK(written < 30);
    auto second = make<float>(1000, 3);
    sph::read_checkpoint(second, path);
    steps(second, static_cast<int>(90 - second.steps()));
    steps(watched, 40);
    CHECK((bits(watched) == bits(whole)));
    CHECK((bits(second) == bits(whole)));
}

TEST_CASE("A checkpoint of a scene before its first step", "[checkpoint]") {
    const auto path = output_test::fresh("checkpoint_start") / "run";
    auto scene = make<double>(), other = make<double>();
    sph::write_checkpoint(scene, path);
    sph::read_checkpoint(other, path);
    run(scene, 20);
    run(other, 20);
    CHECK((bits(scene) == bits(other)));
}

TEST_CASE("The checkpoint before is kept, and a full disk leaves both", "[checkpoint]") {
    const auto path = output_test::fresh("checkpoint_previous") / "run";
    auto scene = make<float>();
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    const auto first = output_test::content(path);
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    const auto second = output_test::content(path);
    CHECK((first != second));
    CHECK((output_test::content(path.string() + ".previous") == first));
    run(scene, 10);
    {
        const output_test::FullDisk full(20000);
        REQUIRE_THROWS_WITH(sph::write_checkpoint(scene, path), imbibe_test::contains("the disk refused it"));
    }
    CHECK((output_test::content(path) == second));
    CHECK((output_test::content(path.string() + ".previous") == first));
    auto earlier = make<float>();
    sph::read_checkpoint(earlier, path.string() + ".previous");
    CHECK(earlier.steps() == 10);
    CHECK_FALSE(std::filesystem::exists(path.string() + ".previous.link"));
}

TEST_CASE("Where the checkpoint before cannot be kept no new one is written", "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_not_kept"), path = folder / "run";
    auto scene = make<float>();
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    const auto first = output_test::content(path);
    std::filesystem::create_directories(folder / "run.previous" / "in the way");
    run(scene, 10);
    REQUIRE_THROWS_WITH(sph::write_checkpoint(scene, path), imbibe_test::contains("cannot keep the checkpoint"));
    CHECK((output_test::content(path) == first));
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
        ++files;
    CHECK(files == 2); // none that is half done
    std::filesystem::remove_all(folder / "run.previous");
    sph::write_checkpoint(scene, path);
    CHECK((output_test::content(folder / "run.previous") == first));
}

TEST_CASE("What a killed program left beside a checkpoint is no way into it", "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_left_over"), path = folder / "run",
               before = folder / "run.previous";
    auto scene = make<float>();
    sph::write_checkpoint(scene, path);
    const auto first = output_test::content(path);
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    sph::return_to_previous_checkpoint(path);
    for (const char* left : {"run.tmp", "run.link", "run.previous.link"})
        std::filesystem::create_hard_link(before, folder / left);
    sph::return_to_previous_checkpoint(path);
    run(scene, 10);
    {
        const output_test::FullDisk full(20000);
        REQUIRE_THROWS_WITH(sph::write_checkpoint(scene, path), imbibe_test::contains("the disk refused it"));
    }
    CHECK((output_test::content(path) == first));
    CHECK((output_test::content(before) == first));
    for (int i = 0; i < 2; ++i) {
        const auto last = output_test::content(path);
        sph::write_checkpoint(scene, path);
        CHECK((output_test::content(before) == last));
        run(scene, 10);
    }
    CHECK(std::filesystem::hard_link_count(path) == 1);
}

TEST_CASE("A run that goes on from the checkpoint before leaves the later one behind", "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_return"), path = folder / "run",
               before = folder / "run.previous";
    auto scene = make<float>();
    sph::return_to_previous_checkpoint(path); // nothing there
    CHECK_FALSE(std::filesystem::exists(path));
    sph::write_checkpoint(scene, path);
    const auto first = output_test::content(path);
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    sph::return_to_previous_checkpoint(path);
    CHECK((output_test::content(path) == first));
    CHECK((output_test::content(before) == first));
    sph::return_to_previous_checkpoint(path); // both are one already
    run(scene, 10);
    sph::write_checkpoint(scene, path);
    CHECK((output_test::content(path) != first));
    CHECK((output_test::content(before) == first));
    std::filesystem::rename(path, folder / "elsewhere");
    std::filesystem::create_symlink(folder / "elsewhere", path);
    sph::return_to_previous_checkpoint(path);
    CHECK(std::filesystem::is_symlink(path));
    CHECK((output_test::content(folder / "elsewhere") == first));
}

TEST_CASE("Damaged checkpoints are refused with the reason, and the scene stays", "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_bad");
    const auto path = folder / "run", bad = folder / "bad";
    auto scene = make<float>();
    run(scene, 15);
    sph::write_checkpoint(scene, path);
    const auto good = output_test::content(path);
    const auto before = bits(scene);

    REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, folder / "nothing"), imbibe_test::contains("no such file"));
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{10}, std::size_t{25}, good.size() / 2, good.size() - 1}) {
        write_file(bad, good.substr(0, size));
        CAPTURE(size);
        REQUIRE_THROWS_AS(sph::read_checkpoint(scene, bad), sph::Error);
    }
    for (const std::size_t at : {std::size_t{30}, std::size_t{200}, good.size() / 3, good.size() - 3}) {
        auto damaged = good;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        write_file(bad, damaged);
        CAPTURE(at);
        REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, bad), imbibe_test::contains("checksum"));
    }
    write_file(bad, "something else altogether, and long enough");
    REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, bad), imbibe_test::contains("does not begin"));
    // One of an earlier version, whole.
    auto earlier = good.substr(0, good.size() - 8);
    const auto title = earlier.find("imbibe checkpoint ");
    REQUIRE(title == 0);
    earlier[std::string_view("imbibe checkpoint ").size()] = '2';
    const auto sum_of_earlier = sph::detail::checksum(earlier);
    earlier.append(reinterpret_cast<const char*>(&sum_of_earlier), sizeof sum_of_earlier);
    write_file(bad, earlier);
    REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, bad),
                        imbibe_test::contains("as a checkpoint of this version does"));
    // A file that says it is longer than it is, with a checksum that fits.
    auto short_one = good.substr(0, good.size() - 8 - 1000);
    const auto sum = sph::detail::checksum(short_one);
    short_one.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    write_file(bad, short_one);
    REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, bad), imbibe_test::contains("shorter than it says"));
    // One with a particle of a number that none was given, with a checksum that fits.
    auto renumbered = good.substr(0, good.size() - 8);
    const auto& ids = scene.get<Water>().ids();
    const auto at_ids = renumbered.find(std::string(reinterpret_cast<const char*>(ids.data()), 4 * ids.size()));
    REQUIRE(at_ids != std::string::npos);
    renumbered.replace(at_ids, 4, std::string(4, char(127)));
    const auto sum_of_renumbered = sph::detail::checksum(renumbered);
    renumbered.append(reinterpret_cast<const char*>(&sum_of_renumbered), sizeof sum_of_renumbered);
    write_file(bad, renumbered);
    REQUIRE_THROWS_WITH(sph::read_checkpoint(scene, bad), imbibe_test::contains("were ever added"));
    REQUIRE_THROWS_AS(sph::read_checkpoint(scene, folder), sph::Error); // a folder
    CHECK((bits(scene) == before));

    auto in_double = make<double>();
    REQUIRE_THROWS_WITH(sph::read_checkpoint(in_double, path),
                        imbibe_test::contains("32 bits") && imbibe_test::contains("64 bits"));
    // A scene that has gone wrong is not saved over one that had not.
    auto lost = make<float>();
    lost.step();
    lost.get<Water>()[sph::position](3, 0) = std::numeric_limits<float>::quiet_NaN();
    REQUIRE_THROWS_WITH(sph::write_checkpoint(lost, path), imbibe_test::contains("not a finite number"));
    CHECK((output_test::content(path) == good));
    auto leaping = make<float, sph::Leapfrog>();
    REQUIRE_THROWS_WITH(sph::read_checkpoint(leaping, path),
                        imbibe_test::contains("SymplecticEuler") && imbibe_test::contains("Leapfrog"));
    sph::Solver<2, float, sph::SymplecticEuler, Water, Block, LooseContact> loose(scene.settings());
    loose.add(Water{{.density = 1000, .sound_speed = 20}}, {{0.5, 0.5}}, 0.05);
    Block block = static_cast<const Block&>(scene.get<Block>().material());
    loose.add(block, {{0.5, 0.1}}, 0.05);
    REQUIRE_THROWS_WITH(sph::read_checkpoint(loose, path), imbibe_test::contains("of another scene"));
    auto heavier = make<float>(1100);
    REQUIRE_THROWS_WITH(sph::read_checkpoint(heavier, path), imbibe_test::contains("density 1100"));
}

TEST_CASE("Checkpoints by wall time", "[checkpoint]") {
    const auto path = output_test::fresh("checkpoint_timed") / "run";
    auto scene = make<float>();
    sph::Checkpoints never(path, 1e6), always(path, 0);
    scene.run_until(0.002, never);
    CHECK_FALSE(std::filesystem::exists(path));
    CHECK(always(scene, [&] { return sph::CheckpointNotes{{"steps", double(scene.steps())}}; }));
    auto other = make<float>();
    CHECK(sph::read_checkpoint(other, path).at("steps") == double(scene.steps()));
    REQUIRE_THROWS_WITH(sph::Checkpoints(path, -1), imbibe_test::contains("-1"));
}

TEST_CASE("Checkpoints by simulated time", "[checkpoint]") {
    const auto path = output_test::fresh("checkpoint_simulated") / "run";
    auto scene = make<float>();
    sph::Checkpoints checkpoints(path, 1e6, 0.01);
    std::vector<double> written;
    scene.run_until(0.035, [&](auto& s) {
        if (checkpoints(s, [] { return sph::CheckpointNotes{}; }))
            written.push_back(s.time());
    });
    REQUIRE(written.size() == 3);
    for (int k = 0; k < 3; ++k) {
        CHECK(written[static_cast<std::size_t>(k)] >= 0.01 * (k + 1) * (1 - 1e-6));
        CHECK(written[static_cast<std::size_t>(k)] < 0.01 * (k + 1) + 2 * scene.last_step().seconds);
    }
    scene.run_until(0.05, sph::every(0.01, [&](auto& s) { sph::write_checkpoint(s, path); }));
    auto other = make<float>();
    sph::read_checkpoint(other, path);
    CHECK(other.time() > 0.0499);
    REQUIRE_THROWS_WITH(sph::Checkpoints(path, 1, -0.5), imbibe_test::contains("-0.5 s"));

    const std::size_t before = written.size(); // a scene that went back, with the same observer
    auto back = make<float>();
    back.run_until(0.012, [&](auto& s) {
        if (checkpoints(s, [] { return sph::CheckpointNotes{}; }))
            written.push_back(s.time());
    });
    REQUIRE(written.size() == before + 1);
    CHECK(written.back() >= 0.01 * (1 - 1e-6));
}

TEST_CASE("A checkpoint with a name as long as a name may be is read, and one that cannot be there is refused",
          "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_names");
    auto scene = make<float>();
    const auto longest = folder / std::string(241, 'x');
    sph::write_checkpoint(scene, longest);
    sph::write_checkpoint(scene, longest);
    CHECK_NOTHROW(sph::read_checkpoint(scene, longest));
    CHECK_NOTHROW(sph::read_checkpoint(scene, longest.string() + ".previous"));
    const auto too_long = folder / std::string(242, 'x');
    CHECK_THROWS_WITH(sph::write_checkpoint(scene, too_long),
                      imbibe_test::contains("242 bytes; it may have at most 241"));
    CHECK_THROWS_WITH(sph::Checkpoints(too_long, 1), imbibe_test::contains("Give it a shorter name"));
    CHECK_THROWS_WITH(sph::read_checkpoint(scene, folder / std::string(300, 'x')),
                      imbibe_test::contains("there is no such file"));
}

TEST_CASE("A checkpoint behind a link is written where it is, and the one before is kept", "[checkpoint]") {
    const auto folder = output_test::fresh("checkpoint_link");
    std::filesystem::create_directories(folder / "other_disk");
    auto scene = make<float>();
    sph::write_checkpoint(scene, folder / "other_disk/run");
    std::filesystem::create_symlink("other_disk/run", folder / "run");
    const auto first = output_test::content(folder / "run");
    scene.step();
    sph::write_checkpoint(scene, folder / "run");
    CHECK(std::filesystem::is_symlink(folder / "run"));
    CHECK(output_test::content(folder / "other_disk/run") != first);
    CHECK(output_test::content(folder / "run.previous") == first);
}

TEST_CASE("Of two long lines that differ only the difference is shown", "[checkpoint]") {
    using sph::detail::first_difference;
    using Both = std::pair<std::string, std::string>;
    CHECK(first_difference("a\nb 1\n", "a\nb 2\n") == Both{"b 1", "b 2"});
    CHECK(first_difference("a\n", "a\nb\n") == Both{"nothing", "b"});
    CHECK(first_difference("a\n", "a\n") == Both{});
    const std::string name(150, 'x'), words = "of that and of this and of yet another thing ";
    for (const std::string& before :
         {"integrator " + name, "terms of Water: " + name, "terms of Water: " + words + words})
        for (const std::string& after : {std::string(), words + words + words}) {
            const auto [one, other] = first_difference(before + "WendlandC2" + after, before + "WendlandC4" + after);
            CAPTURE(one, other);
            CHECK(one.find("WendlandC2") != std::string::npos);
            CHECK(other.find("WendlandC4") != std::string::npos);
            CHECK(one.size() < 160);
        }
}

TEST_CASE("Shortened steps stay short after a restart", "[checkpoint]") {
    const auto path = output_test::fresh("shortened") / "run";
    auto whole = make<float>();
    run(whole, 20);
    whole.shorten_steps(0.3); // shares whose products are rounded
    whole.shorten_steps(0.7);
    sph::write_checkpoint(whole, path);
    run(whole, 20);

    auto second = make<float>();
    sph::read_checkpoint(second, path);
    CHECK(second.shortened() == whole.shortened());
    CHECK(second.settings().cfl == whole.settings().cfl);
    CHECK(whole.settings().cfl == Approx(0.21 * make<float>().settings().cfl).epsilon(1e-14));
    run(second, 20);
    CHECK((bits(second) == bits(whole)));

    second.shorten_steps(0.25);
    sph::read_checkpoint(second, path); // as long as they were then, not 0.21 of what they are
    CHECK(second.settings().cfl == whole.settings().cfl);
}

TEST_CASE("A run that goes wrong goes back and on with shorter steps", "[checkpoint]") {
    const auto path = output_test::fresh("recover") / "run";
    auto scene = make<float>();
    scene.run_until(0.01);
    const double limit = scene.time_step_limits().front().seconds;
    auto fixed = make<float>(1000, 1, 3 * limit);
    sph::Guard<2> guard({.interval = 1});
    std::vector<double> returned_to;
    sph::run_and_recover(fixed, 0.3, guard, path, 0.02, 4, [&](const sph::Error& error) {
        CHECK_THAT(error.what(), imbibe_test::contains("times the limit"));
        returned_to.push_back(fixed.time());
    });
    CHECK(fixed.time() == Approx(0.3));
    CHECK(returned_to.size() >= 1);
    CHECK(returned_to.size() <= 3);
    CHECK(fixed.settings().time_step == Approx(3 * limit * std::pow(0.5, returned_to.size())));

    auto hopeless = make<float>(1000, 1, 20 * limit);
    sph::Guard<2> again({.interval = 1});
    const std::string kept = ". The particles as they were: " + path.string() + ".broken";
    bool told = false; // where the particles are, each time and at last
    const auto tell = [&](const sph::Error& error) { told = std::string(error.what()).ends_with(kept); };
    CHECK_THROWS_WITH(sph::run_and_recover(hopeless, 0.3, again, path, 1e6, 1, tell), imbibe_test::contains(kept));
    CHECK(told);
    auto good = make<float>(1000, 1, 20 * limit); // both are on the disk: the last good state and what went wrong
    sph::read_checkpoint(good, path);
    CHECK(good.time() < hopeless.time());
    CHECK(std::filesystem::exists(path.string() + ".broken/water.pvd"));

    auto bad = make<float>(); // as it is already: no shorter step mends that
    sph::Guard<2> strict({.upper = {1e-3, 1e-3}});
    bool tried = false;
    CHECK_THROWS_AS(sph::run_and_recover(bad, 0.3, strict, path, 1e6, 4, [&](const sph::Error&) { tried = true; }),
                    sph::Diverged);
    CHECK_FALSE(tried);

    auto watched = make<float>(); // nor what an observer complains of, nor a disk that is full
    sph::Guard<2> calm;
    const auto complain = [](auto&) { throw sph::Error("my probe is broken"); };
    const auto count = [&](const sph::Error&) { tried = true; };
    CHECK_THROWS_WITH(sph::run_and_recover(watched, 0.3, calm, path, 1e6, 4, count, complain), "my probe is broken");
    {
        const output_test::FullDisk full(1 << 20); // enough to begin with, not for the notes of a table
        sph::Table table(output_test::fresh("recover_full") / "run.csv", {{"time", "s"}, {"words"}});
        const auto fill_the_disk = [&](auto& s) { table.row({s.time(), std::string(300000, 'x')}); };
        CHECK_THROWS_WITH(sph::run_and_recover(watched, 0.3, calm, path, 1e6, 4, count, fill_the_disk),
                          imbibe_test::contains("the disk refused a row"));
    }
    CHECK_FALSE(tried);
    CHECK(watched.settings().cfl == make<float>().settings().cfl);
}

namespace {

/// The times that the list of a series names.
std::vector<double> listed_times(const std::filesystem::path& list) {
    std::vector<double> times;
    const auto words = output_test::content(list);
    for (auto at = words.find("timestep=\""); at != std::string::npos; at = words.find("timestep=\"", at + 1))
        times.push_back(std::stod(words.substr(at + 10)));
    return times;
}

} // namespace

TEST_CASE("A restarted run goes on with the snapshots and the table of the run before", "[checkpoint]") {
    const auto folder = output_test::fresh("restarted_series");
    const auto table_row = [](sph::Table& table) {
        return [&table](const auto& s) { table.row({s.time(), s.steps()}); };
    };
    const std::vector<sph::Column> columns{{"time", "s"}, {"steps"}};
    auto first = make<float>(1000, 1, 1e-3);
    {
        sph::Table table(folder / "run.csv", columns);
        first.run_until(0.02, sph::every(0.005, sph::Snapshots(folder)), sph::every(0.005, table_row(table)),
                        sph::Checkpoints(folder / "run", 1e6, 0.01));
    }
    auto second = make<float>(1000, 1, 1e-3); // another program, from the checkpoint at 0.02 s
    sph::read_checkpoint(second, folder / "run.previous");
    REQUIRE(second.time() == Approx(0.01));
    sph::Table table(folder / "run.csv", columns);
    second.run_until(0.03, sph::every(0.005, sph::Snapshots(folder)), sph::every(0.005, table_row(table)));
    const auto times = listed_times(folder / "water.pvd");
    REQUIRE(times.size() == 7);
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(times[k] == Approx(0.005 * static_cast<double>(k)).epsilon(1e-6));
    CHECK(listed_times(folder / "block.pvd") == times);
    const auto rows = output_test::content(folder / "run.csv");
    CHECK(std::count(rows.begin(), rows.end(), '\n') == 8);
    CHECK(rows.find("\n0,0\n") != std::string::npos);

    auto third = make<float>(1000, 1, 1e-3); // and from the start
    third.run_until(0.005, sph::every(0.005, sph::Snapshots(folder)));
    CHECK(listed_times(folder / "water.pvd").size() == 2);
}

TEST_CASE("Phases whose names differ in template arguments only have snapshots and lines of their own",
          "[checkpoint]") {
    const auto folder = output_test::fresh("alike");
    sph::Solver<2, double, sph::SymplecticEuler, Numbered<0>, Numbered<1>> scene({.support_radius = 0.1});
    scene.add(Numbered<0>{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 0.05);
    scene.add(Numbered<1>{{.density = 1, .sound_speed = 1}}, {{1, 0}, {1, 1}}, 0.05);
    scene.run_until(1e-3, sph::Snapshots(folder));
    CHECK(std::filesystem::exists(folder / "numbered_1.pvd"));
    CHECK(std::filesystem::exists(folder / "numbered_2.pvd"));
    struct water : sph::Fluid<> {};
    sph::Solver<2, double, sph::SymplecticEuler, Water, water> two({.support_radius = 0.1});
    two.add(Water{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 0.05);
    two.add(water{{.density = 1, .sound_speed = 1}}, {{1, 0}, {1, 1}}, 0.05);
    two.run_until(1e-3, sph::Snapshots(folder)); // a file system may not tell large letters from small ones
    CHECK(std::filesystem::exists(folder / "water_1.pvd"));
    CHECK(std::filesystem::exists(folder / "water_2.pvd"));
    sph::write_checkpoint(scene, folder / "checkpoint");
    sph::Solver<2, double, sph::SymplecticEuler, Numbered<1>, Numbered<0>> other({.support_radius = 0.1});
    other.add(Numbered<1>{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 0.05);
    other.add(Numbered<0>{{.density = 2, .sound_speed = 1}}, {{1, 0}, {1, 1}}, 0.05);
    CHECK_THROWS_WITH(sph::read_checkpoint(other, folder / "checkpoint"), imbibe_test::contains("Numbered_2"));
}

TEST_CASE("Snapshots are of one story where a run goes back, and where two runs follow each other", "[checkpoint]") {
    const auto folder = output_test::fresh("recovered_series");
    auto scene = make<float>(1000, 1, 1e-3);
    sph::Snapshots each(folder / "each"), some(folder / "some");
    sph::Table table(folder / "run.csv", {{"time", "s"}, {"step", "s"}});
    bool once = true;
    const auto trouble = [&](auto& s) {
        if (once && s.steps() == 13) {
            once = false;
            throw sph::Diverged("trouble, once", sph::Cause::energy, "", {}, s.time(), s.steps());
        }
    };
    sph::Guard<2> guard;
    int returned = 0;
    sph::run_and_recover(
        scene, 0.02, guard, folder / "run", 1e6, 3, [&](const sph::Error&) { ++returned; }, each,
        sph::every(5e-3, std::ref(some)),
        sph::every(1e-3,
                   [&](auto& s) {
                       table.row({s.time(), s.last_step().seconds});
                   }),
        trouble);
    CHECK(returned == 1);
    CHECK(each.size() == 41); // 0.02 s in steps of half a millisecond, from the start again
    CHECK(some.size() == 5);
    CHECK(listed_times(folder / "each/water.pvd").size() == 41);
    const auto rows = output_test::content(folder / "run.csv");
    CHECK(std::count(rows.begin(), rows.end(), '\n') == 22);
    CHECK(rows.find(",0.001\n") == std::string::npos); // none of the steps that were given up

    scene.run_until(0.021, each);
    scene.run_until(0.022, each);
    CHECK(each.size() == 45);
    const auto times = listed_times(folder / "each/water.pvd");
    CHECK(std::is_sorted(times.begin(), times.end(), std::less_equal<>{})); // each once

    // What went wrong is kept by itself, whatever was there before.
    sph::keep_offending_state(scene, folder / "each");
    CHECK(listed_times(folder / "each/water.pvd") == std::vector<double>{scene.time()});
}

} // namespace checkpoint_test
