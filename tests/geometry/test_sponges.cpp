// Sponges: perforated slabs, the paper's slab, triply periodic surfaces, random foam, and how wide they are open.
#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/distinct.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/foam.hpp>
#include <imbibe/geometry/passage.hpp>
#include <imbibe/geometry/pore_report.hpp>
#include <imbibe/geometry/pores.hpp>
#include <imbibe/geometry/triply_periodic.hpp>
#include <imbibe/presets/paper_slab.hpp>

#include <limits>
#include <numbers>

namespace sponges_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

static_assert(PorousShape<PerforatedSlab<2>> && PorousShape<PerforatedSlab<3>> && PorousShape<TriplyPeriodic>);
static_assert(PorousShape<RandomFoam<2>> && PorousShape<RandomFoam<3>> && !PorousShape<Box<3>>);

/// Open part of the sponge's box as particles see it.
template <class S>
double filled_porosity(const S& sponge, double spacing) {
    const double cell = std::pow(spacing, shape_dimension<S>);
    return 1 - static_cast<double>(fill(sponge, spacing).size()) * cell / sponge.bounds().volume();
}
} // namespace

TEST_CASE("Porosity of perforated slabs is what filling finds") {
    const Box<3> slab{{0, 0, 0}, {10, 8, 2}};
    for (const PoreShape shape : {PoreShape::circular, PoreShape::square, PoreShape::hexagonal})
        for (const int axis : {0, 1, 2}) {
            Pores<3> pores{.count = {2, 3}, .pitch = 2.5, .radius = 0.8, .shape = shape, .axis = axis};
            Box<3> box = slab;
            if (axis == 0)
                box = Box<3>{{0, 0, 0}, {2, 10, 8}};
            if (axis == 1)
                box = Box<3>{{0, 0, 0}, {10, 2, 8}};
            const PerforatedSlab<3> sponge{box, pores};
            const double area = shape == PoreShape::circular ? pi : shape == PoreShape::square ? 4 : 2 * std::sqrt(3.0);
            CAPTURE(static_cast<int>(shape), axis);
            CHECK(sponge.porosity() == Approx(6 * area * 0.64 / 80));
            CHECK(filled_porosity(sponge, 0.05) == Approx(sponge.porosity()).margin(0.002));
        }
}

TEST_CASE("Pores stand where they should") {
    const PerforatedSlab<3> sponge{Box<3>{{0, 0, 0}, {10, 10, 1}},
                                   {.count = {3, 1}, .pitch = 3, .radius = 1, .offset = {0.5, -1, 0}}};
    for (const double x : {2.5, 5.5, 8.5}) {
        CHECK_FALSE(sponge.contains({x, 4, 0.5}));
        CHECK_FALSE(sponge.contains({x + 0.99, 4, 0}));
        CHECK(sponge.contains({x, 5.01, 0.5}));
        CHECK(sponge.contains({x + 1.5, 4, 0.5}));
    }
    CHECK(sponge.contains({3.5, 4, 0.5})); // the wall of a pore is solid
    CHECK(sponge.contains({5.5, 1, 0.5})); // one row only
    CHECK_FALSE(sponge.contains({5, 5, 1.01}));
    // The corners of a hexagon lie along the first cross axis.
    const PerforatedSlab<3> hexagon{Box<3>{{-5, -5, 0}, {5, 5, 1}},
                                    {.count = {1, 1}, .pitch = 9, .radius = 1, .shape = PoreShape::hexagonal}};
    CHECK_FALSE(hexagon.contains({1.15, 0, 0.5}));
    CHECK(hexagon.contains({1.16, 0, 0.5}));
    CHECK_FALSE(hexagon.contains({0, 0.99, 0.5}));
    CHECK(hexagon.contains({0, 1.01, 0.5}));
    // Slots in two dimensions.
    const PerforatedSlab<2> comb{Box<2>{{0, 0}, {10, 1}}, {.count = {4}, .pitch = 2, .radius = 0.5}};
    CHECK(comb.porosity() == Approx(0.4));
    CHECK_FALSE(comb.contains({2, 0.5}));
    CHECK(comb.contains({3, 0.5}));
    CHECK(filled_porosity(comb, 0.1) == Approx(0.4));
}

TEST_CASE("Perforated slabs refuse pores that do not fit") {
    const Box<3> slab{{0, 0, 0}, {10, 10, 1}};
    const Pores<3> good{.count = {3, 3}, .pitch = 3, .radius = 1};
    CHECK_NOTHROW((PerforatedSlab<3>{slab, good}));
    auto bad = good;
    SECTION("count") {
        bad.count = {3, 0};
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("count = 0"));
    }
    SECTION("pitch") {
        bad.pitch = -3;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("pitch = -3 m"));
        bad.pitch = 2;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("run into each other"));
        bad.pitch = 4.5;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("over the edge"));
    }
    SECTION("radius") {
        bad.radius = 0;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("radius = 0 m"));
        bad.radius = not_a_number;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("radius = nan m"));
    }
    SECTION("axis and offset") {
        bad.axis = 3;
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("axis = 3"));
        bad = good;
        bad.offset = {1.5, 0, 0};
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("over the edge") && contains("along x"));
        bad.offset = {0, not_a_number, 0};
        CHECK_THROWS_WITH((PerforatedSlab<3>{slab, bad}), contains("offset"));
    }
}

TEST_CASE("The paper's slab has the paper's numbers of particles") {
    struct Row {
        double radius;
        std::size_t here, paper;
    };
    for (const Row& row :
         {Row{0.5e-3, 43650, 43696}, Row{1e-3, 41400, 41533}, Row{1.5e-3, 38250, 37978}, Row{2e-3, 33300, 33160}}) {
        for (const Point<3>& lower : {Point<3>{0, 0, 0}, Point<3>{-17.5e-3, -17.5e-3, 30e-3}, Point<3>{1, 2, 3}}) {
            const auto points = presets::paper_slab_particles({.pore_radius = row.radius, .lower = lower});
            CHECK(points.size() == row.here);
            const double size = static_cast<double>(points.size());
            CHECK(size == Approx(static_cast<double>(row.paper)).epsilon(0.0075));
            require_distinct(points, 0.5e-3);
        }
        // Symmetric about the middle of x; a strip of one row is a fifth.
        double mean = 0;
        for (const auto& point : presets::paper_slab_particles({.pore_radius = row.radius}))
            mean += (point[0] - 17.5e-3) / static_cast<double>(row.here);
        CHECK(std::abs(mean) < 1e-12);
        CHECK(presets::paper_slab_particles({.pore_radius = row.radius, .rows = 1}).size() * 5 == row.here);
    }
    const auto points = presets::paper_slab_particles();
    CHECK(points.front().isApprox(Point<3>(0.25e-3, 0.25e-3, 0)));
    CHECK(points.back().isApprox(Point<3>(34.75e-3, 34.75e-3, 4e-3)));
    CHECK_THROWS_WITH(presets::paper_slab({.rows = 0}), contains("rows = 0"));
    CHECK_THROWS_WITH(presets::paper_slab({.pore_radius = 4e-3}), contains("run into each other"));
    CHECK_THROWS_WITH(presets::paper_slab({.spacing = 0}), contains("spacing = 0 m"));
}

TEST_CASE("The widest ball that passes a straight pore is the pore's width") {
    const Box<3> slab{{0, 0, 0}, {4, 4, 2}};
    const PerforatedSlab<3> round{slab, {.count = {1, 1}, .pitch = 3, .radius = 1}};
    CHECK(widest_passage(round, 2, 0.05) == Approx(2).margin(0.06));
    CHECK(widest_passage(round, 0, 0.05) == 0); // no way through sideways
    CHECK(widest_passage(slab, 2, 0.1) == 0);
    const PerforatedSlab<2> slot{Box<2>{{0, 0}, {6, 1}}, {.count = {2}, .pitch = 3, .radius = 0.5}};
    CHECK(widest_passage(slot, 1, 0.02) == Approx(1).margin(0.03));
    // Two chambers joined by a neck: the neck counts.
    const auto neck =
        Box<2>{{0, 0}, {9, 5}} - (Box<2>{{-1, 1}, {3, 4}} | Box<2>{{3, 2}, {6, 2.8}} | Box<2>{{6, 1}, {10, 4}});
    CHECK(widest_passage(neck, 0, 0.05) == Approx(0.8).margin(0.06));
    CHECK_THROWS_WITH(widest_passage(slab, 3, 0.1), contains("axis = 3"));
    CHECK_THROWS_WITH(widest_passage(slab, 0, 0.0), contains("cell = 0 m"));
    CHECK_THROWS_WITH(widest_passage(slab, 0, 1e-4), contains("at most 1e8"));
    CHECK_THROWS_WITH(widest_passage(Box<2>::everywhere(), 0, 0.1), contains("bounds"));
}

TEST_CASE("Distances of the passage search are exact") {
    // Against comparing every cell with every solid cell, on a random 2D picture of cells that are wider than high.
    const double width = 1.25, height = 0.75;
    std::vector<double> line, values, starts;
    std::vector<std::size_t> roots;
    constexpr std::size_t n = 23;
    std::vector<double> picture(n * n);
    for (std::size_t i = 0; i < n * n; ++i)
        picture[i] = random_number(3, i) < 0.03 ? 0.0 : 1e15;
    auto result = picture;
    for (const std::size_t stride : {std::size_t{1}, n})
        for (std::size_t k = 0; k < n; ++k) {
            line.resize(n);
            const std::size_t start = stride == 1 ? k * n : k;
            for (std::size_t i = 0; i < n; ++i)
                line[i] = result[start + i * stride];
            detail::spread_distance(line, stride == 1 ? width : height, values, starts, roots);
            for (std::size_t i = 0; i < n; ++i)
                result[start + i * stride] = line[i];
        }
    for (std::size_t i = 0; i < n * n; ++i) {
        double least = 1e15;
        for (std::size_t j = 0; j < n * n; ++j)
            if (picture[j] == 0) {
                const double x = width * (static_cast<double>(i % n) - static_cast<double>(j % n));
                const double y = height * (static_cast<double>(i / n) - static_cast<double>(j / n));
                least = std::min(least, x * x + y * y);
            }
        REQUIRE(result[i] == Approx(least).epsilon(1e-14));
    }
}

TEST_CASE("A passage is as wide as it is in a box that is no whole number of cells, too") {
    // A slot of 2.1 m between plates of 1.05 m: cells of 1 m are really 0.84 m high.
    const auto slot = Box<2>{{0, 0}, {20, 4.2}} - Box<2>{{-1, 1.05}, {21, 3.15}};
    const double width = widest_passage(slot, 0, 1.0);
    CHECK(width > 2.1 - 1.5 * 0.84);
    CHECK(width < 2.1 + 2 * 0.84);
    CHECK(widest_passage(slot, 0, 1e-2) == Approx(2.1).margin(0.02));
    // Thinner than a millionth of a cell: still one cell thick.
    CHECK_THROWS_WITH(widest_passage(Box<2>{{0, 0}, {1, 1e-12}}, 0, 1e-9), contains("at most 1e8"));
}

TEST_CASE("Triply periodic sponges have the solid fraction asked for") {
    const Box<3> whole{{1, 2, 3}, {3, 4, 5}};
    const Box<3> odd{{0, 0, 0}, {2.3, 1.7, 3.1}}; // no whole number of cells
    for (const PeriodicSurface surface : {PeriodicSurface::gyroid, PeriodicSurface::schwarz_p})
        for (const SolidForm form : {SolidForm::network, SolidForm::sheet})
            for (const double fraction : {0.25, 0.4, 0.5})
                for (const Box<3>& box : {whole, odd}) {
                    const TriplyPeriodic sponge{
                        box, {.surface = surface, .cell = 1, .solid_fraction = fraction, .form = form}};
                    CAPTURE(static_cast<int>(surface), static_cast<int>(form), fraction);
                    CHECK(1 - sponge.porosity() == Approx(fraction).margin(0.003));
                    CHECK(1 - filled_porosity(sponge, 0.0311) == Approx(fraction).margin(0.01));
                }
    CHECK(gyroid(whole, 1, 0.5).level() == Approx(0).margin(0.01));
    CHECK(schwarz_p(whole, 1, 0.5).level() == Approx(0).margin(0.01));
}

TEST_CASE("The neck of Schwarz' P surface is as wide as its formula says") {
    const Box<3> box{{0, 0, 0}, {4, 4, 4}};
    for (const double fraction : {0.3, 0.5, 0.7}) {
        const auto sponge = schwarz_p(box, 2, fraction);
        // In the plane X = pi the pore is cos Y + cos Z > 1 + t: nearest along the axes or along the diagonal.
        const double t = sponge.level();
        const double radius = std::min(std::acos(t), std::sqrt(2.0) * std::acos((1 + t) / 2)) * 2 / (2 * pi);
        CHECK(sponge.pore_width() == Approx(2 * radius).margin(2.0 / 32));
    }
    // Pore and solid of the gyroid change places with f to -f, so equal fractions leave a pore that shrinks with more
    // solid and scales with the cell.
    const double half = gyroid(box, 2, 0.5).pore_width();
    CHECK(half > 0);
    CHECK(gyroid(box, 2, 0.7).pore_width() < half);
    CHECK(gyroid(box, 2, 0.3).pore_width() > half);
    CHECK(gyroid(box, 1, 0.5).pore_width() == Approx(half / 2));
}

TEST_CASE("Triply periodic sponges refuse what cannot be made") {
    const Box<3> box{{0, 0, 0}, {2, 2, 2}};
    CHECK_THROWS_WITH(schwarz_p(box, 1, 0.85), contains("solid_fraction = 0.85") && contains("pores close"));
    CHECK_THROWS_WITH(schwarz_p(box, 1, 0.15), contains("falls to pieces"));
    CHECK_THROWS_WITH(gyroid(box, 1, 0.0), contains("solid_fraction = 0"));
    CHECK_THROWS_WITH(gyroid(box, 1, 1.0), contains("solid_fraction = 1"));
    CHECK_THROWS_WITH(gyroid(box, 1, not_a_number), contains("solid_fraction = nan"));
    CHECK_THROWS_WITH(gyroid(box, 0, 0.5), contains("cell = 0 m"));
    CHECK_THROWS_WITH(gyroid(box, 3, 0.5), contains("longer than the shortest side"));
    CHECK_NOTHROW(gyroid(box, 1, 0.1));
    CHECK_NOTHROW(gyroid(box, 1, 0.9));
}

TEST_CASE("Random foam reaches its porosity") {
    for (const double porosity : {0.3, 0.6, 0.8, 0.95})
        for (const std::uint64_t seed : {1u, 2u}) {
            const RandomFoam<3> foam{Box<3>{{0, 0, 0}, {1, 1, 0.8}},
                                     {.pore_radius = 0.12, .porosity = porosity, .radius_spread = 0.3, .seed = seed}};
            CAPTURE(porosity, seed, foam.pores().size());
            CHECK(foam.porosity() == Approx(porosity).margin(0.01));
            CHECK(filled_porosity(foam, 0.02) == Approx(porosity).margin(0.01));
            for (const auto& ball : foam.pores()) { // all radii shrunk by one factor, and by little
                CHECK(ball.radius() <= 0.12 * 1.3);
                CHECK(ball.radius() > 0.12 * 0.7 * 0.9);
            }
        }
    const RandomFoam<2> flat{Box<2>{{0, 0}, {1, 1}}, {.pore_radius = 0.05, .porosity = 0.5}};
    CHECK(flat.porosity() == Approx(0.5).margin(0.01));
    CHECK(filled_porosity(flat, 0.005) == Approx(0.5).margin(0.01));
}

TEST_CASE("Foam is the same for the same seed, and its index of balls misses none") {
    const Box<3> box{{-1, 5, 2}, {0, 6, 3}};
    const Foam options{.pore_radius = 0.15, .porosity = 0.7, .radius_spread = 0.5, .seed = 9};
    const RandomFoam<3> foam{box, options};
    CHECK(fill(foam, 0.05) == fill(RandomFoam<3>{box, options}, 0.05));
    auto other = options;
    other.seed = 10;
    CHECK(fill(foam, 0.05) != fill(RandomFoam<3>{box, other}, 0.05));
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const Point<3> point = even_point(box, i);
        bool open = false;
        for (const auto& ball : foam.pores())
            open = open || (point - ball.centre()).norm() < ball.radius();
        REQUIRE(foam.in_pore(point) == open);
        REQUIRE(foam.contains(point) != open);
    }
    CHECK_FALSE(foam.contains({2, 5.5, 2.5}));
}

TEST_CASE("Windows of a foam lie on both balls") {
    const RandomFoam<3> foam{Box<3>{{0, 0, 0}, {1, 1, 1}}, {.pore_radius = 0.15, .porosity = 0.6}};
    const auto windows = foam.windows();
    REQUIRE(windows.size() > 5);
    for (const double width : windows) {
        CHECK(width > 0);
        CHECK(width <= 0.3);
    }
    CHECK(foam.smallest_window() == *std::min_element(windows.begin(), windows.end()));
    // What passes is never wider than a pore, and a foam of 60 % is open.
    CHECK(foam.pore_width() > 0);
    CHECK(foam.pore_width() < 0.3 + 0.02);
    // Few pores do not lead through.
    CHECK((RandomFoam<3>{Box<3>{{0, 0, 0}, {1, 1, 1}}, {.pore_radius = 0.1, .porosity = 0.06}}.pore_width()) == 0);
}

TEST_CASE("Foam refuses bad input") {
    const Box<3> box{{0, 0, 0}, {1, 1, 1}};
    CHECK_THROWS_WITH((RandomFoam<3>{box, {}}), contains("pore_radius = 0 m"));
    CHECK_THROWS_WITH((RandomFoam<3>{box, {.pore_radius = 0.6}}), contains("must fit into the box"));
    CHECK_THROWS_WITH((RandomFoam<3>{box, {.pore_radius = 0.1, .porosity = 0.99}}), contains("porosity = 0.99"));
    CHECK_THROWS_WITH((RandomFoam<3>{box, {.pore_radius = 0.1, .porosity = not_a_number}}), contains("porosity = nan"));
    CHECK_THROWS_WITH((RandomFoam<3>{box, {.pore_radius = 0.1, .radius_spread = 1}}), contains("radius_spread = 1"));
    CHECK_THROWS_WITH((RandomFoam<3>{box, {.pore_radius = 0.001}}), contains("at most 20000"));
}

TEST_CASE("Pores too narrow for particles are reported in a sentence") {
    const auto at = [](double radius, double spacing) {
        return pore_report(presets::paper_slab({.pore_radius = radius}), spacing);
    };
    const auto closed = at(0.5e-3, 0.8e-3);
    CHECK(closed.grade == PoreGrade::closed);
    CHECK(closed.particles == Approx(1.25));
    CHECK_THAT(closed.sentence, contains("1.25 particles") && contains("numerically closed") && contains("0.0005 m"));
    CHECK(at(0.8e-3, 0.8e-3).grade == PoreGrade::narrow); // exactly two
    CHECK(at(2e-3, 0.8e-3).grade == PoreGrade::narrow);
    CHECK_THAT(at(2e-3, 0.8e-3).sentence, contains("open but narrow"));
    CHECK(at(2e-3, 0.5e-3).grade == PoreGrade::open);
    CHECK_THAT(at(2e-3, 0.5e-3).sentence, contains("open and resolved"));
    CHECK(at(1e-3, 0.5e-3).porosity == Approx(25 * pi / 1225));
    CHECK_THROWS_WITH(at(1e-3, 0), contains("spacing = 0 m"));
    const RandomFoam<3> tight{Box<3>{{0, 0, 0}, {1, 1, 1}}, {.pore_radius = 0.1, .porosity = 0.06}};
    CHECK_THAT(pore_report(tight, 0.01).sentence, contains("no passage"));
}

} // namespace sponges_test
