// Any bytes for what a restarted run reads beside its checkpoint, a table and the list of a series for ParaView: they
// are continued or refused with an Error, and nothing else happens. For clang's libFuzzer with the address and
// undefined-behaviour sanitizers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz && build-fuzz/tests/fuzz_output -max_total_time=60
//
// Both ways of continuing are entered: after a number of rows and snapshots, from the first byte, and by the time of
// what comes next. Half of the inputs get the right first line of a table before them.
#include <imbibe/output/table.hpp>
#include <imbibe/output/vtk_series.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

namespace sph = imbibe;

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// Continued, the table has as many rows as were asked for; refused, it is what it was.
void continue_table(const std::filesystem::path& path, const std::string& bytes, std::size_t rows) {
    write_file(path, bytes);
    bool continued = false;
    try {
        sph::Table::resume(path, {{"time", "s"}, {"limit"}}, rows).row({0.5, "elastic wave"});
        continued = true;
    } catch (const sph::Error&) {
    }
    std::ifstream in(path, std::ios::binary);
    const std::string now{std::istreambuf_iterator<char>(in), {}};
    const auto lines = static_cast<std::size_t>(std::count(now.begin(), now.end(), '\n'));
    if (continued ? lines != rows + 2 : now != bytes)
        std::abort();
}

// By the time of its next row, the table has the rows before that and this one; refused, it is what it was.
void continue_table_by_time(const std::filesystem::path& path, const std::string& bytes) {
    write_file(path, bytes);
    bool continued = false;
    try {
        sph::Table table(path, {{"time", "s"}, {"limit"}});
        table.row({0.5, "elastic wave"});
        continued = true;
    } catch (const sph::Error&) {
    }
    std::ifstream in(path, std::ios::binary);
    const std::string now{std::istreambuf_iterator<char>(in), {}};
    if (continued ? !now.ends_with("\n0.5,elastic wave\n") : now != bytes)
        std::abort();
}

void continue_series_by_time(const std::filesystem::path& folder, const std::string& bytes) {
    write_file(folder / "water.pvd", bytes);
    sph::VtkSeries series(folder, "water", sph::VtkPrecision::single);
    try {
        const double origin[] = {0, 0};
        series.write(0.5, sph::VtkFile(1, sph::VtkArray::vector("position", "m", 2, origin, 1)));
    } catch (const sph::Error&) {
        return;
    }
    if (series.size() == 0)
        std::abort();
}

void continue_series(const std::filesystem::path& folder, const std::string& bytes, std::size_t snapshots) {
    write_file(folder / "water.pvd", bytes);
    sph::VtkSeries series(folder, "water", sph::VtkPrecision::single);
    try {
        series.resume(snapshots);
    } catch (const sph::Error&) {
        snapshots = 0;
    }
    if (series.size() != snapshots)
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto folder = [] {
        const auto path = std::filesystem::temp_directory_path() / ("imbibe_fuzz_output_" + std::to_string(::getpid()));
        std::filesystem::create_directories(path);
        return path;
    }();
    if (size == 0)
        return 0;
    const std::size_t left = data[0] / 2 % 8;
    std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    continue_series(folder, bytes, left);
    if (data[0] >= 224) // seldom: it writes two files, which takes long
        continue_series_by_time(folder, bytes);
    if (data[0] % 2 == 1)
        bytes = "time [s],limit\n" + bytes;
    continue_table(folder / "run.csv", bytes, left);
    continue_table_by_time(folder / "run.csv", bytes);
    return 0;
}
