// VTK files: what this test writes, read_vtk.py reads back with VTK itself, and compares with the tables written
// beside.
#include "folder.hpp"
#include "full_disk.hpp"

#include <catch_shim.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/output/vtk_series.hpp>
#include <limits>
#include <random>

namespace vtk_test {

using namespace imbibe;
using imbibe_test::contains;
using output_test::content;
using output_test::fresh;

namespace {

/// Particles in columns, as the solver keeps them: more room than particles, so that the stride is not the count.
template <class Real, int dim>
struct Particles {
    std::size_t count, stride;
    std::vector<Real> position, velocity, stress, gradient, pressure;
    std::vector<std::int64_t> id;
    std::vector<std::int32_t> kind;

    explicit Particles(std::size_t n) : count(n), stride(n + 5), id(n), kind(n) {
        std::mt19937 random(7);
        std::normal_distribution<double> number(0, 1);
        for (auto [column, size] :
             {std::pair{&position, dim}, std::pair{&velocity, dim}, std::pair{&stress, dim * (dim + 1) / 2},
              std::pair{&gradient, dim * dim}, std::pair{&pressure, 1}}) {
            column->resize(stride * static_cast<std::size_t>(size));
            for (auto& x : *column)
                x = static_cast<Real>(number(random));
        }
        for (std::size_t i = 0; i < n; ++i) {
            id[i] = (std::int64_t{1} << 40) + static_cast<std::int64_t>(n - i);
            kind[i] = -static_cast<std::int32_t>(i);
        }
    }

    VtkFile file() const {
        VtkFile f(count, VtkArray::vector("position", "m", dim, position.data(), stride));
        f.add(VtkArray::vector("velocity", "m/s", dim, velocity.data(), stride))
            .add(VtkArray::of("stress", "Pa", Rank::symmetric_tensor, dim, stress.data(), stride))
            .add(VtkArray::of("velocity gradient", "1/s", Rank::tensor, dim, gradient.data(), stride))
            .add(VtkArray::scalar("pressure <&> \"p\"", "N/m^2", pressure.data()))
            .add(VtkArray::scalar("id", "", id.data()))
            .add(VtkArray::scalar("kind", "", kind.data()))
            .constant("spacing", 8e-4);
        return f;
    }

    /// The same numbers as text, written without the file's own layout: what read_vtk.py must find.
    void expect(const std::filesystem::path& path) const {
        std::vector<Column> columns;
        for (const char* name : {"x",   "y",   "z",   "u",   "v",   "w",   "sxx", "syy", "szz", "sxy", "syz", "sxz",
                                 "gxx", "gxy", "gxz", "gyx", "gyy", "gyz", "gzx", "gzy", "gzz", "p",   "id",  "kind"})
            columns.push_back({name});
        Table table(path, columns);
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = [&](const auto& data, int column) {
                return static_cast<double>(data[static_cast<std::size_t>(column) * stride + i]);
            };
            std::vector<double> row;
            for (const auto* data : {&position, &velocity})
                for (int k = 0; k < 3; ++k)
                    row.push_back(k < dim ? at(*data, k) : 0.);
            for (const auto& [a, b] : {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}})
                row.push_back(b < dim ? at(stress, SymmetricTensor<Real, dim>::index(a, b)) : 0.);
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                    row.push_back(a < dim && b < dim ? at(gradient, a * dim + b) : 0.);
            row.push_back(at(pressure, 0));
            row.push_back(static_cast<double>(id[i]));
            row.push_back(static_cast<double>(kind[i]));
            table.row(row);
        }
    }
};

} // namespace

TEST_CASE("particles are written for VTK to read back", "[output]") {
    const auto folder = fresh("vtk");
    const auto leave = [&](const char* name, const auto& particles, VtkPrecision precision) {
        const auto path = folder / (std::string(name) + ".vtp");
        particles.file().time(1. / 3).write(path, precision);
        particles.expect(folder / (std::string(name) + ".csv"));
        REQUIRE(std::filesystem::file_size(path) > 0);
    };
    leave("solid_double", Particles<double, 3>(10'000), VtkPrecision::as_given);
    leave("solid_single", Particles<double, 3>(4096), VtkPrecision::single);
    leave("solid_float", Particles<float, 3>(4097), VtkPrecision::as_given);
    leave("flat_double", Particles<double, 2>(1000), VtkPrecision::as_given);
    leave("flat_float", Particles<float, 2>(1), VtkPrecision::as_given);
    leave("empty", Particles<double, 3>(0), VtkPrecision::as_given);
}

TEST_CASE("single precision halves a file", "[output]") {
    const auto folder = fresh("vtk_size");
    const std::size_t n = 10'000;
    const std::vector<double> x(3 * n);
    const VtkFile file(n, VtkArray::vector("position", "m", 3, x.data(), n));
    file.write(folder / "double.vtp");
    file.write(folder / "single.vtp", VtkPrecision::single);
    const auto saved =
        std::filesystem::file_size(folder / "double.vtp") - std::filesystem::file_size(folder / "single.vtp");
    CHECK(saved / n == 12);
}

TEST_CASE("a series lists its files by time", "[output]") {
    const auto folder = fresh("series");
    const Particles<double, 3> particles(100);
    {
        VtkSeries series(folder, "water");
        for (int k = 0; k < 12; ++k) {
            series.write(k * 0.005, particles.file());
            REQUIRE(series.size() == static_cast<std::size_t>(k + 1));
        }
        CHECK(content(series.list()).find("timestep=\"0.055\" part=\"0\" name=\"water\" file=\"water_000011.vtp\"") !=
              std::string::npos);
        REQUIRE_THROWS_WITH(series.write(std::nan(""), particles.file()), contains("finite number"));
    }
    VtkSeries again(folder, "water"); // as after a restart
    REQUIRE_THROWS_WITH(again.resume(13), contains("lists 12"));
    again.resume(11);
    again.write(1. / 3, particles.file());
    CHECK(again.size() == 12);
    CHECK(content(again.list()).find("0.055") == std::string::npos);
}

namespace {
/// The times that a list names, and the files, which must be there and be of those times.
std::vector<double> told_by(const std::filesystem::path& list) {
    std::vector<double> times;
    const auto words = content(list);
    for (auto at = words.find("timestep=\""); at != std::string::npos; at = words.find("timestep=\"", at + 1)) {
        const auto begin = at + 10, file = words.find("file=\"", at) + 6;
        const auto time = words.substr(begin, words.find('"', begin) - begin);
        const auto name = words.substr(file, words.find('"', file) - file);
        CAPTURE(name, time);
        CHECK(content(list.parent_path() / name).find(">" + time + "</DataArray>") != std::string::npos);
        times.push_back(std::stod(time));
    }
    return times;
}
using Times = std::vector<double>;
} // namespace

TEST_CASE("a series tells one story, wherever time goes back to", "[output]") {
    const auto folder = fresh("series_story");
    const Particles<double, 3> particles(10);
    {
        VtkSeries series(folder, "water");
        for (const double time : {0., 0.1, 0.2, 0.3})
            series.write(time, particles.file());
        series.write(0.2 * (1 + 1e-12), particles.file()); // the same time, but for rounding
        CHECK(told_by(series.list()) == Times{0, 0.1, 0.2 * (1 + 1e-12)});
        series.write(0.15, particles.file());
        series.write(0.25, particles.file());
        CHECK(told_by(series.list()) == Times{0, 0.1, 0.15, 0.25});
    }
    {
        VtkSeries restarted(folder, "water");
        CHECK(restarted.size() == 0);
        restarted.write(0.15, particles.file());
        CHECK(restarted.size() == 3);
        restarted.write(0.3, particles.file());
        CHECK(told_by(restarted.list()) == Times{0, 0.1, 0.15, 0.3});
    }
    {
        VtkSeries later(folder, "water");
        later.write(1, particles.file());
        CHECK(told_by(later.list()) == Times{0, 0.1, 0.15, 0.3, 1});
    }
    {
        VtkSeries another(folder, "sponge"); // there is nothing to be continued
        another.write(0.5, particles.file());
        CHECK(told_by(another.list()) == Times{0.5});
    }
    {
        VtkSeries anew(folder, "water");
        anew.resume(0);
        anew.write(0.6, particles.file());
        CHECK(told_by(anew.list()) == Times{0.6});
    }
    VtkSeries from_the_start(folder, "water");
    from_the_start.write(0, particles.file());
    CHECK(told_by(from_the_start.list()) == Times{0});
}

TEST_CASE("a series never lists a file that is of a later time, whenever it is killed", "[output]") {
    const auto folder = fresh("series_killed");
    const Particles<double, 3> first(10), second(20);
    {
        VtkSeries series(folder, "water");
        for (const double time : {0., 0.1, 0.2, 0.3})
            series.write(time, first.file());
    }
    const auto kill_before_the_list_is_written = [&](VtkSeries& series, double time) {
        const auto in_the_way = folder / "water.pvd.tmp";
        std::filesystem::create_directory(in_the_way);
        REQUIRE_THROWS_AS(series.write(time, second.file()), Error);
        std::filesystem::remove(in_the_way);
        return told_by(series.list());
    };
    VtkSeries restarted(folder, "water"), anew(folder, "water"), resumed(folder, "water");
    CHECK(kill_before_the_list_is_written(restarted, 0.2) == Times{0, 0.1, 0.2, 0.3});
    CHECK(kill_before_the_list_is_written(anew, 0) == Times{0, 0.1, 0.2, 0.3});
    resumed.resume(1);
    CHECK(kill_before_the_list_is_written(resumed, 0.4) == Times{0, 0.1, 0.2, 0.3});
    {
        const output_test::FullDisk full(1500); // the list fits, the particles do not
        REQUIRE_THROWS_WITH(restarted.write(0.2, second.file()), contains("refused"));
    }
    CHECK(told_by(restarted.list()) == Times{0, 0.1});
    restarted.write(0.2, second.file());
    CHECK(told_by(restarted.list()) == Times{0, 0.1, 0.2});
}

TEST_CASE("a list that is not that of a series is not continued", "[output]") {
    const auto folder = fresh("series_foreign");
    const Particles<double, 3> particles(10);
    VtkSeries(folder, "water").write(0, particles.file());
    const auto list = folder / "water.pvd";
    const auto good = content(list);
    std::ofstream(list) << "<DataSet timestep=\"0\" part=\"0\" file=\"other.vtp\"/>\n";
    VtkSeries series(folder, "water");
    REQUIRE_THROWS_WITH(series.write(1, particles.file()), contains("water.pvd") && contains("water_000000.vtp"));
    std::ofstream(list) << good;
    std::filesystem::remove(folder / "water_000000.vtp");
    REQUIRE_THROWS_WITH(series.write(1, particles.file()), contains("water_000000.vtp") && contains("not there"));
    CHECK(content(list) == good);
}

TEST_CASE("a full disk in the middle of a series leaves what was there", "[output]") {
    const auto folder = fresh("series_full");
    const Particles<double, 3> few(10), many(10'000);
    VtkSeries series(folder, "water");
    series.write(0, few.file());
    const auto list = content(series.list()), first = content(folder / "water_000000.vtp");
    {
        const output_test::FullDisk full(100'000);
        REQUIRE_THROWS_WITH(series.write(1, many.file()), contains("water_000001.vtp") && contains("refused"));
    }
    CHECK(content(series.list()) == list);
    CHECK(content(folder / "water_000000.vtp") == first);
    CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2);
    series.write(1, few.file());
    CHECK(series.size() == 2);
}

TEST_CASE("what cannot be written is refused with a reason", "[output]") {
    const std::vector<double> x(30);
    const auto position = VtkArray::vector("position", "m", 3, x.data(), 10);
    REQUIRE_THROWS_WITH(VtkFile(10, VtkArray::scalar("position", "m", x.data())), contains("position has 1 comp"));
    REQUIRE_THROWS_WITH(VtkFile(11, position), contains("stride of 10 is less than the 11 particles"));
    const std::vector<std::int32_t> whole(30);
    REQUIRE_THROWS_WITH(VtkFile(10, VtkArray::vector("position", "m", 3, whole.data(), 10)), contains("whole numbers"));
    VtkFile file(10, position);
    file.add(VtkArray::scalar("pressure", "Pa", x.data()));
    REQUIRE_THROWS_WITH(file.add(VtkArray::scalar("pressure", "Pa", x.data())), contains("two arrays called pressure"));
    REQUIRE_THROWS_WITH(file.add(VtkArray::scalar("", "Pa", x.data())), contains("no name"));
    REQUIRE_THROWS_WITH(file.add(VtkArray{"odd", "", x.data(), 10, {0, 1}}), contains("odd has 2 components"));
    REQUIRE_THROWS_WITH(file.add(VtkArray::scalar<double>("none", "", nullptr)), contains("none has no data"));
    REQUIRE_THROWS_WITH(VtkArray::vector("velocity", "m/s", 4, x.data(), 10), contains("dim = 4"));
    REQUIRE_THROWS_WITH(file.write(output_test::folder / "no such folder" / "x.vtp"), contains("cannot write"));
    REQUIRE_THROWS_WITH(VtkSeries(fresh("series_bad"), "a/b"), contains("phase name 'a/b'"));
}

} // namespace vtk_test
