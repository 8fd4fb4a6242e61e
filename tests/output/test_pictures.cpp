// How examples call the Python tools: paths with any characters, and one clear line where a picture cannot be drawn.
#include "../../examples/support/pictures.hpp"

#include "folder.hpp"

#include <catch_shim.hpp>
#include <imbibe/output/table.hpp>
#include <sstream>

namespace pictures_test {

using imbibe::example::draw;
using imbibe_test::contains;
using output_test::fresh;

TEST_CASE("an example draws its curves", "[output]") {
    const auto folder = fresh("it's a \"folder\" $HOME; with `all`");
    {
        imbibe::Table table(folder / "run.csv", {{"time", "s"}, {"displacement", "m"}});
        for (int i = 0; i < 20; ++i)
            table.row({i * 0.01, i * i * 1e-5});
    }
    std::ostringstream log;
    const auto picture = folder / "curves.png";
    const bool drawn = draw("plot_curves.py", {(folder / "run.csv").string(), "-o", picture.string()}, log);
    INFO(log.str());
    REQUIRE(drawn);
    CHECK(output_test::content(picture).substr(1, 3) == "PNG");
    CHECK(log.str().empty());
}

TEST_CASE("an example says why it could not draw", "[output]") {
    std::ostringstream log;
    CHECK_FALSE(draw("no_such_tool.py", {}, log));
    CHECK(log.str().find("no_such_tool.py is not there") != std::string::npos);
    log.str("");
    CHECK_FALSE(draw("plot_curves.py", {"/no such file.csv", "-o", "/no such folder/x.png"}, log));
    CHECK(log.str().find("this command failed") != std::string::npos);
}

} // namespace pictures_test
