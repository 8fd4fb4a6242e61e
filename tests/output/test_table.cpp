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
    table.row(std::vector<double>{0.5, std::numeric_limits<double>::infinity(), -5e-324});
    const auto last = content(path).substr(content(path).find("12\n") + 3);
    CHECK(last == "0.5,inf,-5e-324\n");
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
        const output_test::FullDisk full(before.size() + 3); // with room for half a row
        REQUIRE_THROWS_WITH(table.row({4, 5, 6}), contains("the disk refused a row"));
    }
    CHECK(content(path) == before);
    table.row({7, 8, 9}); // somebody made room
    CHECK(content(path) == before + "7,8,9\n");
}

TEST_CASE("a table is continued after a restart", "[output]") {
    const auto path = fresh("table_resume") / "run.csv";
    {
        Table table(path, columns);
        table.row({1, 2, 3});
        table.row({4, 5, 6});
    }
    std::ofstream(path, std::ios::app) << "7,8"; // killed in the middle of a row
    REQUIRE_THROWS_WITH(Table::resume(path.string() + "x", columns, 0), contains("there is no such file"));
    REQUIRE_THROWS_WITH(Table::resume(path, columns, 3), contains("after 3 rows: it has 2"));
    REQUIRE_THROWS_WITH(Table::require_resumable(path, columns, 3), contains("continue after at most so many"));
    const auto whole = content(path);
    CHECK_NOTHROW(Table::require_resumable(path, columns, 1));
    CHECK(content(path) == whole);
    REQUIRE_THROWS_WITH(Table::resume(path, {{"time", "ms"}}, 1), contains("where this run writes 'time [ms]'"));
    auto table = Table::resume(path, columns, 1);
    table.row({4, 5, 7});
    CHECK(content(path) == "time [s],drained mass [kg],steps\n1,2,3\n4,5,7\n");
}

TEST_CASE("a table over time tells one story, wherever time goes back to", "[output]") {
    const auto path = fresh("table_story") / "run.csv";
    const std::string head = "time [s],drained mass [kg],steps\n";
    {
        Table table(path, columns);
        for (const double time : {0., 1., 2., 3.})
            table.row({time, 1, 2});
        table.row({2, 5, 6});
        CHECK(content(path) == head + "0,1,2\n1,1,2\n2,5,6\n");
        table.row({1.5, 7, 8});
        table.row({2.5, 9, 9});
    }
    std::ofstream(path, std::ios::app) << "3,8"; // killed in the middle of a row
    const std::string before = head + "0,1,2\n1,1,2\n1.5,7,8\n2.5,9,9\n3,8";
    {
        Table restarted(path, columns);
        CHECK(content(path) == before); // until a row says at which time the run goes on
        restarted.row({1.5, 7, 7});
        restarted.row({2.0, "", 3.0});
        CHECK(content(path) == head + "0,1,2\n1,1,2\n1.5,7,7\n2,,3\n");
    }
    const auto now = content(path);
    Table other(path, {{"time", "s"}, {"mass", "kg"}});
    REQUIRE_THROWS_WITH(other.row({4, 1}), contains("drained mass [kg]") && contains("another name"));
    std::ofstream(path, std::ios::app) << "words,1,2\n";
    Table unreadable(path, columns);
    REQUIRE_THROWS_WITH(unreadable.row({4, 1, 2}), contains("'words,1,2' does not begin with a time"));
    REQUIRE_THROWS_WITH(unreadable.row({std::nan(""), 1, 2}), contains("finite number"));
    REQUIRE_THROWS_WITH(unreadable.row({"now", 1.0, 2.0}), contains("finite number"));
    CHECK(content(path) == now + "words,1,2\n");
    std::ofstream(path) << now << "3,1\n";
    Table short_row(path, columns);
    REQUIRE_THROWS_WITH(short_row.row({4, 1, 2}), contains("its row '3,1' has 2 cells for 3 columns"));
    REQUIRE_THROWS_WITH(Table::resume(path, columns, 5), contains("its row '3,1' has 2 cells for 3 columns"));
    std::ofstream(path) << now << "3,\"a, b\",2\n";
    Table with_words(path, columns);
    REQUIRE_NOTHROW(with_words.row({4, 1, 2}));
    CHECK(content(path) == now + "3,\"a, b\",2\n4,1,2\n");
    Table anew(path, columns);
    anew.row({0, 4, 4});
    CHECK(content(path) == head + "0,4,4\n");
}

TEST_CASE("a table over anything else keeps every row and starts anew", "[output]") {
    const auto path = fresh("table_other") / "run.csv";
    for (int run = 0; run < 2; ++run) {
        Table table(path, {{"spacing", "m"}, {"time", "s"}});
        CHECK(content(path) == "spacing [m],time [s]\n");
        table.row({2, 1});
        table.row({1, 8});
        CHECK(content(path) == "spacing [m],time [s]\n2,1\n1,8\n");
    }
}

} // namespace table_test
