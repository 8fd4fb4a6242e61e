// Tables: what is read back is what was written, to the last bit, and a wrong row is refused.
#include "folder.hpp"
#include "full_disk.hpp"

#include <catch_shim.hpp>
#include <charconv>
#include <imbibe/output/table.hpp>
#include <limits>

namespace table_test {

using namespace imbibe;
using imbibe_test::contains;
using output_test::content;
using output_test::fresh;

namespace {
const std::vector<Column> columns = {{"time", "s"}, {"drained mass", "kg"}, {"steps"}};
}

TEST_CASE("a table has a header with units and a line a row", "[output]") {
    const auto path = fresh("table") / "run.csv";
    Table table(path, columns);
    CHECK(content(path) == "time [s],drained mass [kg],steps\n");
    table.row({0.1, 1. / 3, 12});
    CHECK(content(path) == "time [s],drained mass [kg],steps\n0.1,0.3333333333333333,12\n");
    table.row(std::vector<double>{-5e-324, std::numeric_limits<double>::infinity(), 1e300});
    const auto last = content(path).substr(content(path).find("12\n") + 3);
    CHECK(last == "-5e-324,inf,1e+300\n");
}

TEST_CASE("a table keeps every bit of a number", "[output]") {
    const auto path = fresh("table_bits") / "run.csv";
    std::vector<double> written;
    {
        Table table(path, {{"value", ""}});
        double value = 1e-30;
        for (int i = 0; i < 500; ++i, value *= -1.3127)
            written.push_back(value), table.row({value});
    }
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    for (const double value : written) {
        REQUIRE(std::getline(in, line));
        double found = 0;
        std::from_chars(line.data(), line.data() + line.size(), found);
        REQUIRE(found == value);
    }
}

TEST_CASE("a table refuses what does not fit", "[output]") {
    const auto folder = fresh("table_bad");
    Table table(folder / "run.csv", columns);
    REQUIRE_THROWS_WITH(table.row({1, 2}), contains("2 cells for 3 columns"));
    REQUIRE_THROWS_WITH(table.row({1, 2, 3, 4}), contains("4 cells for 3 columns"));
    CHECK(content(folder / "run.csv") == "time [s],drained mass [kg],steps\n");
    REQUIRE_THROWS_WITH(Table(folder / "none" / "run.csv", columns), contains("cannot write the table"));
    REQUIRE_THROWS_WITH(Table(folder / "x.csv", {}), contains("no columns"));
    REQUIRE_THROWS_WITH(Table(folder / "x.csv", {{"a", "m"}, {"a", "s"}}), contains("two columns are called a"));
    REQUIRE_THROWS_WITH(Table(folder / "x.csv", {{"a\n", "m"}}), contains("cannot head a column"));
    CHECK_FALSE(std::filesystem::exists(folder / "x.csv"));
}

TEST_CASE("a table takes words beside numbers", "[output]") {
    const auto path = fresh("table_words") / "run.csv";
    Table table(path, {{"time", "s"}, {"limit"}, {"steps"}});
    table.row({0.5, "", 3.0});
    table.row({0.625, "elastic wave, Sponge", 4.0});
    CHECK(content(path) == "time [s],limit,steps\n0.5,,3\n0.625,\"elastic wave, Sponge\",4\n");
    REQUIRE_THROWS_WITH(table.row({1.0, "two\nlines", 2.0}), contains("cannot stand in a row"));
    REQUIRE_THROWS_WITH(table.row({1.0, "too few"}), contains("2 cells for 3 columns"));
}

TEST_CASE("a table says so when the disk is full", "[output]") {
    const auto path = fresh("table_full") / "run.csv";
    Table table(path, columns);
    table.row({1, 2, 3});
    const auto before = content(path);
    {
        const output_test::FullDisk full(before.size());
        REQUIRE_THROWS_WITH(table.row({4, 5, 6}), contains("the disk refused a row"));
    }
    CHECK(content(path) == before);
}

TEST_CASE("a table is continued after a restart", "[output]") {
    const auto path = fresh("table_resume") / "run.csv";
    {
        Table table(path, columns);
        table.row({1, 2, 3});
        table.row({4, 5, 6});
    }
    std::ofstream(path, std::ios::app) << "7,8"; // killed in the middle of a row
    REQUIRE_THROWS_WITH(Table::resume(path, columns, 3), contains("after 3 rows: it has 2"));
    REQUIRE_THROWS_WITH(Table::resume(path, {{"time", "ms"}}, 1), contains("where this run writes 'time [ms]'"));
    auto table = Table::resume(path, columns, 1);
    table.row({4, 5, 7});
    CHECK(content(path) == "time [s],drained mass [kg],steps\n1,2,3\n4,5,7\n");
}

} // namespace table_test
