// Neighbour runs against all pairs, on ordinary and on unkind sets of points.
#include "brute_force.hpp"

#include <catch_shim.hpp>

#include <cmath>
#include <limits>

namespace neighbours_test {

namespace {

using namespace search_test;

template <int width_, int dim_, class Real_>
struct Case {
    static constexpr int width = width_, dim = dim_;
    using Real = Real_;
};
template <class Real>
constexpr int native = imbibe::native_width<Real>;

template <class C>
using CloudOf = Cloud<C::dim, typename C::Real>;
template <class C>
using ComparisonOf = Comparison<C::width, C::dim, typename C::Real>;
template <class C>
CloudOf<C> random_points(int n, double lower, double upper, unsigned seed) {
    return random_cloud<C::dim, typename C::Real>(n, lower, upper, seed);
}

// Particles are their own sources.
template <class C>
ComparisonOf<C> compare(CloudOf<C> cloud, double support, const Periodic<C::dim>& periodic = {}, int threads = 1) {
    ComparisonOf<C> c{support, periodic, threads};
    c.run(cloud, cloud);
    CHECK(c.wrong == 0);
    CHECK(c.twice == 0);
    CHECK(c.unsorted == 0);
    return c;
}
template <class C>
ComparisonOf<C> compare(CloudOf<C> targets, CloudOf<C> sources, double support, const Periodic<C::dim>& periodic = {}) {
    ComparisonOf<C> c{support, periodic};
    c.run(targets, sources);
    CHECK(c.wrong == 0);
    CHECK(c.twice == 0);
    CHECK(c.unsorted == 0);
    return c;
}

// Sides 0 .. sides-1 are periodic, from `lower` on.
template <int dim>
Periodic<dim> box(int sides, double lower, double length) {
    Periodic<dim> p;
    for (int d = 0; d < sides; ++d) {
        p.lower[static_cast<std::size_t>(d)] = lower;
        p.length[static_cast<std::size_t>(d)] = length;
    }
    return p;
}

} // namespace

#define EVERY_CASE                                                                                                     \
    (Case<1, 2, double>), (Case<1, 3, float>), (Case<native<double>, 3, double>), (Case<native<float>, 3, float>),     \
        (Case<native<float>, 2, float>), (Case<native<double>, 2, double>)

TEMPLATE_TEST_CASE("Neighbours of random points are those of all pairs", "[search]", EVERY_CASE) {
    const int n = TestType::dim == 2 ? 500 : 800;
    for (unsigned seed = 1; seed <= 3; ++seed)
        for (double support : {0.05, 0.2, 0.7, 3.0}) {
            CAPTURE(seed, support);
            const auto c = compare<TestType>(random_points<TestType>(n, -0.4, 0.6, seed), support);
            CHECK(c.pairs >= n); // each is its own neighbour
            CHECK((support < 1 || c.pairs == static_cast<long long>(n) * n));
        }
}

TEMPLATE_TEST_CASE("Neighbours on a lattice", "[search]", EVERY_CASE) {
    // Supports between the lattice's distances, and one exactly on it (those pairs are left open).
    for (double support : {0.9, 1.2, 1.5, 2.0, 2.6})
        for (double origin : {0.0, -3.0, 0.37}) {
            CAPTURE(support, origin);
            compare<TestType>(lattice<TestType::dim, typename TestType::Real>(8, 1.0, origin), support);
        }
    // An inner point has 4 (6) neighbours within 1.2 spacings, and itself; all 8^dim together, counted by links.
    const auto c = compare<TestType>(lattice<TestType::dim, typename TestType::Real>(8, 1.0, 0), 1.2);
    CHECK(c.pairs == (TestType::dim == 2 ? 64 + 4 * 7 * 8 : 512 + 6 * 7 * 64));
}

TEMPLATE_TEST_CASE("Neighbours of coincident points", "[search]", EVERY_CASE) {
    auto cloud = random_points<TestType>(40, 0, 1, 7);
    const int n = cloud.n;
    for (int i = 0; i < n; ++i)
        for (int copy = 0; copy < 5; ++copy) {
            std::array<double, static_cast<std::size_t>(TestType::dim)> x;
            for (std::size_t d = 0; d < static_cast<std::size_t>(TestType::dim); ++d)
                x[d] = cloud.at(i, static_cast<int>(d));
            cloud.add(x);
        }
    compare<TestType>(cloud, 0.2);
    CloudOf<TestType> point;
    for (int k = 0; k < 70; ++k)
        point.add({});
    CHECK(compare<TestType>(point, 1.0).pairs == 70 * 70);
}

TEMPLATE_TEST_CASE("Neighbours when all points are in one cell", "[search]", EVERY_CASE) {
    CHECK(compare<TestType>(random_points<TestType>(150, 0.1, 0.1001, 3), 1.0).pairs == 150 * 150);
    CHECK(compare<TestType>(random_points<TestType>(150, -1e-4, 1e-4, 4), 1.0).pairs == 150 * 150);
}

TEMPLATE_TEST_CASE("One point, two points, and no targets at all", "[search]", EVERY_CASE) {
    CHECK(compare<TestType>(random_points<TestType>(1, 0, 1, 3), 0.1).pairs == 1);
    CHECK(compare<TestType>(random_points<TestType>(2, 0, 1, 3), 4).pairs == 4);
    CHECK(compare<TestType>(CloudOf<TestType>{}, random_points<TestType>(9, 0, 1, 3), 1).pairs == 0);
}

TEMPLATE_TEST_CASE("Two clusters a kilometre apart with a support of a millimetre", "[search]", (Case<1, 3, double>),
                   (Case<native<double>, 3, double>), (Case<native<double>, 2, double>),
                   (Case<native<float>, 3, float>)) {
    // In float a coordinate of 1000 m has steps of 0.06 mm: the far cluster is coarse, but its pairs are the same ones.
    auto cloud = random_points<TestType>(200, 0, 4e-3, 1);
    const auto far_away = random_points<TestType>(200, 1000, 1000 + 4e-3, 2);
    for (int i = 0; i < far_away.n; ++i) {
        std::array<double, static_cast<std::size_t>(TestType::dim)> x;
        for (std::size_t d = 0; d < static_cast<std::size_t>(TestType::dim); ++d)
            x[d] = far_away.at(i, static_cast<int>(d));
        cloud.add(x);
    }
    const auto c = compare<TestType>(cloud, 1e-3);
    CHECK(c.pairs > 2 * 200);
    // Memory stays bounded: a uniform grid would have 1e18 cells.
    Grid<TestType::dim> grid;
    auto points = cloud.points();
    grid.fit(imbibe::search::bounds_of(points, 1), 1e-3, {}, cloud.n);
    CHECK(grid.cells() <= 8u * 400u + 4096u);
}

namespace {

// The most points in eight cells one after the other, of which a row around a particle has two to three.
template <int dim, class Real>
std::uint32_t most_in_a_support(const Grid<dim>& grid, Cloud<dim, Real>& cloud) {
    CellTable table;
    table.sort(grid, cloud.points(), 1);
    std::uint32_t most = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c)
        most = std::max(most, table.start(std::min(c + 8, grid.cells())) - table.start(c));
    return most;
}

template <int dim, class Real>
Grid<dim> fitted(Cloud<dim, Real>& cloud, double support, const Periodic<dim>& periodic = {}) {
    Grid<dim> grid;
    grid.fit(imbibe::search::bounds_of(cloud.points(), 1), support, periodic, cloud.n);
    return grid;
}

// A body, of which some points have flown away: over every rim and corner, alone, two together, and some only just.
template <class C>
CloudOf<C> with_drops(CloudOf<C> cloud, double support, double far_away, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int drop = 0; drop < 60; ++drop) {
        std::array<double, static_cast<std::size_t>(C::dim)> x;
        const double way = drop % 3 == 2 ? 40 * support : far_away;
        for (auto& c : x)
            c = std::round(1.4 * uniform(generator)) * way + uniform(generator) * support;
        cloud.add(x);
        for (auto& c : x)
            c += 0.6 * support * uniform(generator);
        if (drop % 2 == 0)
            cloud.add(x);
    }
    return cloud;
}

} // namespace

TEMPLATE_TEST_CASE("Drops that have flown far away", "[search]", EVERY_CASE) {
    constexpr int dim = TestType::dim;
    const double support = 0.11;
    for (double far_away : {3e1, 1e3, 4.4e4, 1e6, 1e12, 1e25})
        for (double side : {0.0, -0.5, 77.0}) {
            CAPTURE(far_away, side);
            auto cloud = with_drops<TestType>(random_points<TestType>(300, side, side + 1, 71), support, far_away, 72);
            const auto c = compare<TestType>(cloud, support);
            CHECK(c.pairs > cloud.n);
            compare<TestType>(random_points<TestType>(100, side, side + 1, 73), cloud, support);
            compare<TestType>(cloud, random_points<TestType>(100, side - 1, side + 2, 74), support);
            for (std::size_t d = 0; d < dim; ++d)
                for (double length : {1.3, 500.0}) { // in which drops come back, the others stay away
                    auto some =
                        with_drops<TestType>(random_points<TestType>(60, side, side + 1, 75), support, far_away, 76);
                    Periodic<dim> periodic;
                    periodic.lower[d] = side;
                    periodic.length[d] = length;
                    for (auto& x : some.x[d])
                        x = imbibe::search::into_period(x, static_cast<typename TestType::Real>(side),
                                                        static_cast<typename TestType::Real>(length));
                    compare<TestType>(some, support, periodic);
                }
            const auto grid = fitted(cloud, support);
            CHECK(grid.cells() <= 8u * static_cast<std::size_t>(cloud.n) + 4096u);
            for (int d = 0; d < dim; ++d)
                CHECK(grid.width(d) == (d == 0 ? support / 8 : support));
        }
}

TEMPLATE_TEST_CASE("What is far away costs the others little", "[search]", (Case<native<double>, 3, double>),
                   (Case<native<double>, 2, double>)) {
    constexpr int dim = TestType::dim;
    const int m = dim == 2 ? 120 : 24;
    auto body = lattice<dim, double>(m, 1.0, 0);
    const auto usual = most_in_a_support(fitted(body, 2.6), body);
    for (double far_away : {1e3, 1e6, -1e9, 1e20}) {
        CAPTURE(far_away);
        auto drop = body;
        std::array<double, dim> at;
        at.fill(far_away);
        drop.add(at);
        CHECK(most_in_a_support(fitted(drop, 2.6), drop) <= usual + 7); // where the cells begin is another matter
        if (std::abs(far_away) < 1e8) {
            auto two = body;
            for (int i = 0; i < body.n; ++i) {
                for (std::size_t d = 0; d < dim; ++d)
                    at[d] = body.at(i, static_cast<int>(d)) + far_away;
                two.add(at);
            }
            CHECK(most_in_a_support(fitted(two, 2.6), two) <= 2 * usual + 14);
        }
    }
}

TEST_CASE("The others stay sorted while a drop flies on", "[search]") {
    auto body = lattice<3, double>(20, 1.0, 300.5);
    auto drop = body;
    drop.add({});
    std::vector<std::uint32_t> order;
    for (double way = 1e4; way < 1.9e4; way += 700) {
        CAPTURE(way);
        for (auto& column : drop.x)
            column[static_cast<std::size_t>(body.n)] = way;
        CellTable table;
        REQUIRE_FALSE(table.sort(fitted(drop, 2.6), drop.points(), 1));
        auto others = table.order();
        std::erase(others, static_cast<std::uint32_t>(body.n));
        CHECK((order.empty() || others == order));
        order = others;
    }
}

TEST_CASE("Neighbours where coordinates have hardly any digits left", "[search]") {
    // From 2^51 on they are half a metre from each other: exact, but their places in cells would not be.
    for (int sign : {1, -1}) {
        Cloud<2, double> cloud = random_cloud<2, double>(100, 0, 4, 81);
        for (int x = 0; x < 12; ++x)
            for (int y = 0; y < 12; ++y)
                cloud.add({sign * (3e15 + 0.5 * x), sign * (2.5e15 + 0.5 * y)});
        for (double support : {0.51, 0.93})
            CHECK(compare<Case<native<double>, 2, double>>(cloud, support).pairs > 12 * 12 * 4);
    }
}

TEMPLATE_TEST_CASE("Neighbours far from the origin", "[search]", (Case<native<double>, 3, double>),
                   (Case<native<double>, 2, double>), (Case<native<float>, 3, float>), (Case<1, 2, float>)) {
    const double far_away = sizeof(typename TestType::Real) == 4 ? 1e3 : 1e8;
    for (double side : {far_away, -far_away}) {
        CAPTURE(side);
        const auto c = compare<TestType>(random_points<TestType>(400, side, side + 1, 5), 0.2);
        CHECK(c.pairs > 400);
        compare<TestType>(lattice<TestType::dim, typename TestType::Real>(7, 0.25, side), 0.6);
    }
}

TEMPLATE_TEST_CASE("Neighbours across periodic sides", "[search]", EVERY_CASE) {
    for (int sides = 1; sides <= TestType::dim; ++sides)
        for (double periods : {1.0, 1.3, 2.0, 2.5, 3.0, 6.2})
            for (double lower : {0.0, -0.37, 5.1}) {
                CAPTURE(sides, periods, lower);
                const double support = 0.25, length = periods * support;
                const auto c = compare<TestType>(random_points<TestType>(80, lower, lower + length, 11), support,
                                                 box<TestType::dim>(sides, lower, length));
                CHECK(c.pairs > 80);
            }
}

TEMPLATE_TEST_CASE("A periodic lattice has the same neighbours everywhere", "[search]", EVERY_CASE) {
    // On both sides' very edge too: the first layer is at the lower end, and its image at the upper one.
    for (int m : {3, 5, 8}) {
        CAPTURE(m);
        const auto c = compare<TestType>(lattice<TestType::dim, typename TestType::Real>(m, 0.1, 0.3), 0.15,
                                         box<TestType::dim>(TestType::dim, 0.3, 0.1 * m));
        const long long n = TestType::dim == 2 ? m * m : m * m * m;
        CHECK(c.pairs == n * (TestType::dim == 2 ? 9 : 19));
    }
}

TEMPLATE_TEST_CASE("Targets that are not the sources", "[search]", EVERY_CASE) {
    compare<TestType>(random_points<TestType>(150, 0, 1, 21), random_points<TestType>(300, 0.2, 0.8, 22), 0.15);
    compare<TestType>(random_points<TestType>(300, 0, 1, 23), random_points<TestType>(3, 0.4, 0.5, 24), 0.3);
    compare<TestType>(random_points<TestType>(50, 0, 0.1, 25), random_points<TestType>(50, 3, 3.1, 26), 0.3);
    for (double periods : {1.0, 2.0, 2.5, 5.0}) {
        CAPTURE(periods);
        compare<TestType>(random_points<TestType>(100, 0, periods * 0.2, 27),
                          random_points<TestType>(100, 0, periods * 0.2, 28), 0.2,
                          box<TestType::dim>(TestType::dim, 0, periods * 0.2));
    }
}

TEMPLATE_TEST_CASE("Long rows of targets that have a source here and there, or none", "[search]", EVERY_CASE) {
    using Real = typename TestType::Real;
    constexpr int dim = TestType::dim;
    const double support = 0.1, length = 3;
    const auto at = [](double x, double across) {
        std::array<double, dim> point{};
        point.fill(across);
        point[0] = x;
        return point;
    };
    CloudOf<TestType> targets;
    for (double across : {0.0, 0.05, 0.3})
        for (int i = 0; i < 600; ++i)
            targets.add(at(i * length / 600, across));
    for (int sides : {0, 1}) // the ends see each other, or do not
        for (const auto& places : {std::vector<double>{0.001}, {1.5}, {2.999}, {0.4, 0.55, 0.7, 2.2, 2.31}}) {
            CAPTURE(sides, places.front());
            Cloud<dim, Real> sources;
            for (double x : places)
                sources.add(at(x, 0.02));
            const auto c = compare<TestType>(targets, sources, support, box<dim>(sides, 0, length));
            CHECK(c.pairs > 0);
        }
}

TEMPLATE_TEST_CASE("Targets outside the periodic box", "[search]", EVERY_CASE) {
    // Particles of a total-Lagrangian solid are not wrapped: they may stand a little beyond the side, or far.
    for (double beyond : {0.01, 0.19, 0.3, 5.0})
        for (double periods : {1.0, 2.0, 2.5, 5.0}) {
            CAPTURE(beyond, periods);
            const double length = periods * 0.2;
            compare<TestType>(random_points<TestType>(60, -beyond, length + beyond, 31),
                              random_points<TestType>(60, 0, length, 32), 0.2,
                              box<TestType::dim>(TestType::dim, 0, length));
        }
}

TEMPLATE_TEST_CASE("Threads do not change the runs", "[search]", (Case<native<double>, 3, double>)) {
    auto cloud = random_points<TestType>(3000, 0, 1, 41);
    auto points = cloud.points();
    Grid<3> grid;
    grid.fit(imbibe::search::bounds_of(points, 1), 0.1, {}, cloud.n);
    std::vector<std::vector<Run>> all;
    for (int threads : {1, 2, 4}) {
        CellTable table;
        auto sorted = cloud;
        if (!table.sort(grid, sorted.points(), threads))
            sorted.reorder(table.order());
        RunList list;
        imbibe::search::find_runs<TestType::width>(list, sorted.points(), sorted.points(), grid, table, 0.1, threads);
        std::vector<Run> runs;
        for (int i = 0; i < list.size(); ++i)
            runs.insert(runs.end(), list[i].begin(), list[i].end());
        all.push_back(runs);
    }
    CHECK(all[0].size() > 3000);
    CHECK(all[0] == all[1]);
    CHECK(all[0] == all[2]);
}

TEST_CASE("A run and the mark of an image fit into four bytes", "[search]") {
    STATIC_REQUIRE(sizeof(Run) == 4);
    for (const std::uint32_t first : {0u, 1u, 12'345'678u, Run::most_particles - 1})
        for (std::uint32_t count = 1; count <= Run::most_neighbours; ++count) {
            const Run run(first, count);
            CHECK(run.first() == first);
            CHECK(run.count() == count);
            CHECK_FALSE(run.is_mark());
        }
    for (int image = 0; image < imbibe::search::image_count<3>; ++image) {
        CHECK(Run::mark_of(image).is_mark());
        CHECK(Run::mark_of(image).image() == image);
    }
    // More particles than that are refused before anything is made of them.
    const imbibe::search::Points<2, float> none{}, many{{}, static_cast<int>(Run::most_particles) + 1};
    RunList list;
    CHECK_THROWS_WITH(imbibe::search::find_runs<1>(list, none, many, Grid<2>{}, CellTable{}, 0.1, 1),
                      imbibe_test::contains("268435430 particles; it must have at most 268435429"));
}

TEST_CASE("Many particles share a longer block, and have the runs that each would have alone", "[search]") {
    constexpr int width = native<float>;
    auto cloud = random_cloud<2, float>(80'000, 0, 1, 42);
    Grid<2> grid;
    grid.fit(imbibe::search::bounds_of(cloud.points(), 1), 0.01, {}, cloud.n);
    CellTable table;
    REQUIRE_FALSE(table.sort(grid, cloud.points(), 1));
    cloud.reorder(table.order());
    const auto points = cloud.points();
    const auto runs_of = [](const RunList& list, int i) { return std::vector<Run>(list[i].begin(), list[i].end()); };
    RunList many;
    imbibe::search::find_runs<width>(many, points, points, grid, table, 0.01, 2);
    CHECK(many.block_size() > RunList::smallest_block);
    CHECK_FALSE(many.is_empty());
    RunList few; // one list for all slices: its memory is used again, after a long list and with other blocks
    imbibe::search::find_runs<width>(few, points, points, grid, table, 0.01, 1);
    for (int begin = 0; begin < cloud.n; begin += 1000) {
        auto slice = points;
        slice.n = 300;
        for (auto& x : slice.x)
            x += begin;
        // The same points under another name: no source is a target, so nobody is taken for granted.
        imbibe::search::find_runs<width>(few, slice, points, grid, table, 0.01, 1);
        REQUIRE(few.block_size() == RunList::smallest_block);
        RunList::Walk walk(many, begin / RunList::smallest_block * RunList::smallest_block);
        for (int i = begin / RunList::smallest_block * RunList::smallest_block; i < begin; ++i)
            walk.next();
        for (int i = 0; i < slice.n; ++i) {
            REQUIRE(runs_of(few, i) == runs_of(many, begin + i));
            if (begin / many.block_size() == (begin + i) / many.block_size()) {
                const auto range = walk.next();
                REQUIRE(range.begin() == many[begin + i].begin());
                REQUIRE(range.end() == many[begin + i].end());
            }
        }
    }
}

TEST_CASE("Columns of numbers begin where packs do", "[search]") {
    const auto place = [](const auto& column) { return reinterpret_cast<std::uintptr_t>(column.data()); };
    const imbibe::AlignedVector<float> few(3, 1.0f), many(5'000'000, 2.0f);
    CHECK(place(few) % 64 == 0);
    CHECK(place(many) % 64 == 0);
    CHECK(std::count(many.begin(), many.end(), 2.0f) == 5'000'000);
}

TEST_CASE("What is sorted stays sorted, and equal cells keep their order", "[search]") {
    auto cloud = random_cloud<3, double>(500, 0, 1, 51);
    auto points = cloud.points();
    Grid<3> grid;
    const auto bounds = imbibe::search::bounds_of(points, 1);
    grid.fit(bounds, 0.2, {}, cloud.n);
    CellTable table;
    REQUIRE_FALSE(table.sort(grid, points, 1));
    const auto order = table.order();
    std::vector<std::uint32_t> cells(500);
    grid.find_cells(points, 0, cloud.n, cells.data());
    for (std::size_t k = 1; k < order.size(); ++k) {
        const auto before = cells[order[k - 1]], here = cells[order[k]];
        REQUIRE(before <= here);
        if (before == here)
            REQUIRE(order[k - 1] < order[k]);
    }
    cloud.reorder(order);
    CHECK(table.sort(grid, cloud.points(), 1));
    // The same set with another point moved out: the grid grows, and the order of the others must not change.
    auto wider = bounds;
    wider.upper = {1.9, 1.9, 1.9};
    Grid<3> grown;
    grown.fit(wider, 0.2, {}, cloud.n);
    if (grown.cells() <= 8u * 500u + 4096u && grown.width(0) == grid.width(0))
        CHECK(table.sort(grown, cloud.points(), 1));
    // Every cell's stretch holds exactly its points.
    table.sort(grid, cloud.points(), 1);
    CHECK(table.start(0) == 0);
    CHECK(table.start(grid.cells()) == 500);
    grid.find_cells(cloud.points(), 0, cloud.n, cells.data());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        REQUIRE(table.start(cells[i]) <= i);
        REQUIRE(i < table.start(cells[i] + 1));
    }
}

TEMPLATE_TEST_CASE("Points are numbered by the cells they are in, and outside by those at the rim", "[search]", float,
                   double) {
    auto cloud = random_cloud<3, TestType>(1003, -2, 2, 52);
    Grid<3> grid;
    imbibe::search::Bounds<3> middle; // of the cloud: most of it is outside
    middle.lower = {-1, -1.1, -0.9};
    middle.upper = {1, 0.8, 1.2};
    grid.fit(middle, 0.3, {}, cloud.n);
    std::vector<std::uint32_t> cells(1003);
    grid.find_cells(cloud.points(), 0, cloud.n, cells.data());
    for (int i = 0; i < cloud.n; ++i) {
        int expected = 0;
        for (int d = 2; d >= 0; --d)
            expected = expected * grid.n(d) +
                       std::clamp(grid.cell(d, double(cloud.points().x[std::size_t(d)][i])), 0, grid.n(d) - 1);
        REQUIRE(cells[std::size_t(i)] == std::uint32_t(expected));
    }
}

TEMPLATE_TEST_CASE("The bounds of points, and the first that is not finite or beyond all bounds", "[search]", float,
                   double) {
    for (const int n : {1, 5, 8, 37}) {
        auto cloud = random_cloud<2, TestType>(n, -1, 1, 53u + static_cast<unsigned>(n));
        for (int bad = -1; bad < n; ++bad)
            for (const auto value : {std::numeric_limits<TestType>::quiet_NaN(), TestType(-2e30)}) {
                auto x = cloud.x[1];
                auto points = cloud.points();
                if (bad >= 0)
                    x[std::size_t(bad)] = value;
                points.x[1] = x.data();
                const auto bounds = imbibe::search::bounds_of(points, 1);
                CHECK(bounds.not_finite == bad);
                const auto [low, high] = std::minmax_element(cloud.x[0].begin(), cloud.x[0].begin() + n);
                CHECK(bounds.lower[0] == double(*low));
                CHECK(bounds.upper[0] == double(*high));
            }
    }
}

TEST_CASE("Coordinates come back into their period", "[search]") {
    using imbibe::search::into_period;
    CHECK(into_period(0.25, 0.0, 1.0) == 0.25);
    CHECK(into_period(1.0, 0.0, 1.0) == 0.0);
    CHECK(into_period(-0.25, 0.0, 1.0) == 0.75);
    CHECK(into_period(-7.25, -1.0, 2.0) == 0.75);
    CHECK(into_period(1e6f + 0.5f, 0.f, 1.f) == 0.5f);
    // A hair below the lower end: adding the period would round to its upper end, which is outside.
    for (double hair : {-1e-17, -1e-300}) {
        const double x = into_period(hair, 0.0, 1.0);
        CHECK(x >= 0);
        CHECK(x < 1);
    }
    const float y = into_period(0.1f - 1e-9f, 0.1f, 0.7f);
    CHECK(y >= 0.1f);
    CHECK(y < 0.1f + 0.7f);
    // What is no place does not become one.
    for (double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        CHECK(!std::isfinite(into_period(none, 0.0, 1.0)));
}

TEST_CASE("A coordinate that is not finite is found", "[search]") {
    auto cloud = random_cloud<2, double>(300, 0, 1, 61);
    CHECK(imbibe::search::bounds_of(cloud.points(), 1).not_finite == -1);
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e31})
        for (std::size_t at : {std::size_t{0}, std::size_t{137}, std::size_t{299}}) {
            auto broken = cloud;
            broken.x[1][at] = bad;
            CHECK(imbibe::search::bounds_of(broken.points(), 2).not_finite == static_cast<int>(at));
        }
}

} // namespace neighbours_test
