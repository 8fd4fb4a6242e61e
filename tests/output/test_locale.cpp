// A host program may write numbers as its users do, with a comma for the point and points between thousands. What the
// library writes and reads stays as it is.
#include "folder.hpp"

#include <imbibe/accuracy/study.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <locale>

namespace locale_test {

namespace {

namespace sph = imbibe;
using output_test::content;
using output_test::fresh;

struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// Makes the program's locale one of commas, as long as it lives.
class ForeignLocale {
public:
    ForeignLocale() : before_(std::locale::global(std::locale(std::locale::classic(), new Commas))) {}
    ForeignLocale(const ForeignLocale&) = delete;
    ForeignLocale& operator=(const ForeignLocale&) = delete;
    ~ForeignLocale() { std::locale::global(before_); }

private:
    std::locale before_;
};

struct Drops : sph::Fluid<sph::Tait<7>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Drops>;

Scene make() {
    Scene scene({.gravity = {0, -9.81}, .support_radius = 0.025, .time_step = 1.5e-3});
    scene.add(Drops{{.density = 1000.5, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0}, {0.4, 0.3}), 0.01), 0.01);
    return scene;
}

} // namespace

TEST_CASE("Texts and studies have points for points, whatever the locale", "[output]") {
    const ForeignLocale commas;
    std::ostringstream foreign;
    foreign << 1234.5;
    REQUIRE(foreign.str() == "1.234,5"); // so the locale is one that would do harm
    CHECK(sph::text(1234.5, " ", 1000000) == "1234.5 1000000");
    CHECK(sph::accuracy::Choices::number_in("1.5") == 1.5);
    CHECK_FALSE(sph::accuracy::Choices::number_in("1,5").has_value());
    CHECK_FALSE(sph::accuracy::Choices::number_in(" 1").has_value());

    sph::accuracy::Row row;
    row.error = 0.25;
    const auto path = fresh("locale_study") / "study.csv";
    sph::accuracy::write({row}, path);
    CHECK(content(path).find("\n0.25,") != std::string::npos);
}

TEST_CASE("A checkpoint is read back under another locale than it was written under", "[output]") {
    const auto folder = fresh("locale_checkpoint");
    auto before = make();
    before.step();
    sph::write_checkpoint(before, folder / "plain");
    const ForeignLocale commas;
    sph::write_checkpoint(before, folder / "foreign");
    CHECK(content(folder / "plain") == content(folder / "foreign"));
    auto after = make();
    sph::read_checkpoint(after, folder / "plain");
    CHECK(after.time() == before.time());
}

TEST_CASE("Tables and series of snapshots go on under another locale", "[output]") {
    const auto folder = fresh("locale_series");
    const auto write = [&] {
        auto scene = make();
        sph::Snapshots snapshots(folder / "snapshots");
        sph::Table table(folder / "run.csv", {{"time", "s"}, {"height", "m"}});
        for (const double seconds : {0.0, 1.5e-3, 3e-3}) {
            scene.run_until(seconds);
            snapshots(scene);
            table.row({scene.time(), 1234.5});
        }
    };
    const auto all = [&] {
        return content(folder / "run.csv") + content(folder / "snapshots" / "drops.pvd") +
               content(folder / "snapshots" / "drops_000001.vtp");
    };
    write();
    const auto plain = all();
    const ForeignLocale commas;
    write();
    CHECK(all() == plain);
    CHECK(plain.find("0.0015,1234.5\n") != std::string::npos);
    CHECK(plain.find("<DataSet timestep=\"0.0015\"") != std::string::npos);
}

} // namespace locale_test
