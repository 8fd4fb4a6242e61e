// Filling shapes with lattice points, the walls of tanks, jitter, and the check for points in the same place.
#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/distinct.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/half_space.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/geometry/transform.hpp>

#include <limits>
#include <numbers>
#include <set>

namespace fill_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <int dim>
Box<dim> cube(double lower, double side) {
    return {Point<dim>::Constant(lower), Point<dim>::Constant(lower + side)};
}

template <int dim>
Point<dim> lowest(const std::vector<Point<dim>>& points) {
    Point<dim> result = points.front();
    for (const auto& point : points)
        result = result.cwiseMin(point).eval();
    return result;
}

template <int dim>
Point<dim> highest(const std::vector<Point<dim>>& points) {
    Point<dim> result = points.front();
    for (const auto& point : points)
        result = result.cwiseMax(point).eval();
    return result;
}
} // namespace

TEST_CASE("A metre at a decimetre is ten points a side, wherever it lies") {
    for (const double offset : {0.0, 0.1, 1.0 / 3.0, -0.7, 1e3, -1e3, 12345.678}) {
        CAPTURE(offset);
        const auto points = fill(cube<3>(offset, 1.0), 0.1);
        CHECK(points.size() == 1000);
        CHECK(lowest(points).isApprox(Point<3>::Constant(offset + 0.05), 1e-12));
        CHECK(highest(points).isApprox(Point<3>::Constant(offset + 0.95), 1e-12));
        CHECK(fill(cube<2>(offset, 1.0), 0.1).size() == 100);
    }
}

TEST_CASE("Many sides and spacings give the whole number asked for") {
    for (int n = 1; n <= 200; ++n)
        for (const double spacing : {0.1, 0.3, 0.7, 1e-3, 8e-4, 1.0 / 3.0}) {
            const Box<2> strip{{0.1, -0.3}, {0.1 + n * spacing, -0.3 + spacing}};
            REQUIRE(fill(strip, spacing).size() == static_cast<std::size_t>(n));
        }
}

TEST_CASE("The paper's water is 31 x 31 x 71 particles") {
    CHECK(fill(Box<3>{{0, 0, 0}, {24.8e-3, 24.8e-3, 56.8e-3}}, 8e-4).size() == 68231);
    CHECK(fill(Box<3>{{5.1e-3, 5.1e-3, 5e-3}, {5.1e-3 + 24.8e-3, 29.9e-3, 61.8e-3}}, 8e-4).size() == 68231);
}

TEST_CASE("The order is x fastest") {
    const auto points = fill(Box<2>{{0, 0}, {3, 2}}, 1.0);
    REQUIRE(points.size() == 6);
    CHECK(points[0] == Point<2>(0.5, 0.5));
    CHECK(points[1] == Point<2>(1.5, 0.5));
    CHECK(points[3] == Point<2>(0.5, 1.5));
}

TEST_CASE("A side that is no whole number of spacings keeps the cells whose centres are inside") {
    CHECK(fill(Box<2>{{0, 0}, {1.04, 1}}, 0.1).size() == 100);
    CHECK(fill(Box<2>{{0, 0}, {1.06, 1}}, 0.1).size() == 110);
    CHECK(fill(Box<2>{{0, 0}, {1.05, 1}}, 0.1).size() == 100); // the last centre lies on the upper face: not this box's
}

TEST_CASE("Shapes that share a face share no point and miss none") {
    // The common face x = 0.55 (or the slanted one) runs through cell centres of the common lattice.
    const Point<2> anchor{0, 0};
    const Box<2> whole{{0, 0}, {1, 1}};
    SECTION("upright") {
        const auto left = fill(Box<2>{{0, 0}, {0.55, 1}}, 0.1, anchor);
        const auto right = fill(Box<2>{{0.55, 0}, {1, 1}}, 0.1, anchor);
        CHECK(left.size() == 50);
        CHECK(right.size() == 50);
    }
    SECTION("slanted, any direction") {
        for (const Point<2>& normal : {Point<2>{1, 1}, Point<2>{1, -1}, Point<2>{2, 1}, Point<2>{-1, 3}}) {
            const HalfSpace<2> behind{{0.45, 0.55}, normal};
            const HalfSpace<2> before{{0.45, 0.55}, -normal};
            CHECK(fill(whole & behind, 0.1, anchor).size() + fill(whole & before, 0.1, anchor).size() == 100);
        }
    }
    SECTION("a difference is the rest of an intersection") {
        const Box<2> piece{{0.25, 0.25}, {0.75, 0.65}};
        const Sphere<2> disc{{0.45, 0.45}, 0.2}; // cell centres at (0.65, 0.45) and others lie on its rim
        CHECK(fill(whole - piece, 0.1).size() + fill(whole & piece, 0.1, anchor).size() == 100);
        CHECK(fill(whole - disc, 0.1).size() + fill(whole & disc, 0.1, anchor).size() == 100);
    }
}

TEST_CASE("Two bodies on one anchor share one lattice") {
    const Point<3> anchor{0.003, 0.001, -0.002};
    for (const auto& points : {fill(Sphere<3>{{0.1, 0.2, 0.3}, 0.05}, 0.01, anchor),
                               fill(Box<3>{{-0.1, 0, 0}, {0.05, 0.1, 0.1}}, 0.01, anchor)})
        for (const auto& point : points)
            for (int axis = 0; axis < 3; ++axis) {
                const double place = (point[axis] - anchor[axis]) / 0.01 - 0.5;
                REQUIRE(std::abs(place - std::round(place)) < 1e-9);
            }
}

TEST_CASE("Filled volume approaches the shape's volume") {
    const Sphere<3> ball{{0.3, 0.2, 0.1}, 1};
    CHECK(static_cast<double>(fill(ball, 0.04).size()) * std::pow(0.04, 3) == Approx(ball.volume()).epsilon(0.005));
    const auto turned = rotated(Box<2>{{0, 0}, {1, 1}}, std::numbers::pi / 6);
    CHECK(static_cast<double>(fill(turned, 0.01).size()) * 1e-4 == Approx(1).epsilon(0.01));
}

TEST_CASE("The particles of a box stand for its volume, and none lies on a face") {
    const Box<3> box{{0, 0, 0}, {35e-3, 35e-3, 4e-3}};
    const auto points = fill(box, 5e-4);
    CHECK(static_cast<double>(points.size()) * std::pow(5e-4, 3) == Approx(box.volume()).epsilon(1e-12));
    CHECK(lowest(points).isApprox(Point<3>::Constant(2.5e-4), 1e-12));
    CHECK(highest(points).isApprox(Point<3>(35e-3, 35e-3, 4e-3) - Point<3>::Constant(2.5e-4), 1e-12));
}

TEST_CASE("Filling refuses what cannot be filled") {
    const Box<3> box{{0, 0, 0}, {1, 1, 1}};
    CHECK_THROWS_WITH(fill(box, 0.0), contains("spacing = 0 m"));
    CHECK_THROWS_WITH(fill(box, -0.1), contains("spacing = -0.1 m"));
    CHECK_THROWS_WITH(fill(box, not_a_number), contains("spacing = nan m"));
    CHECK_THROWS_WITH(fill(box, 1e-7), contains("lattice points") && contains("same unit"));
    CHECK_THROWS_WITH(fill(box, 1e-300), contains("lattice points"));
    CHECK_THROWS_WITH(fill(box, 5.0), contains("no lattice point") && contains("smaller spacing"));
    CHECK_THROWS_WITH(fill(box, 0.1, Point<3>{not_a_number, 0, 0}), contains("anchor"));
    CHECK_THROWS_WITH(fill(HalfSpace<3>{{0, 0, 0}, {0, 0, 1}}, 0.1), contains("bounds"));
    CHECK_THROWS_WITH(fill(HalfSpace<3>{{0, 0, 0}, {1, 1, 1}}, 0.1), contains("bounds"));
    CHECK_THROWS_WITH(fill(box - Box<3>{{-1, -1, -1}, {2, 2, 2}}, 0.1), contains("no lattice point"));
    CHECK_THROWS_WITH(fill(Box<2>{{1e12, 0}, {1e12 + 100, 100}}, 10.0), contains("too fine"));
}

TEST_CASE("A tank in 2D, open at the top") {
    const auto wall = tank(Box<2>{{0, 0}, {1, 0.5}}, 0.1, 3, Sides::y_high);
    CHECK(wall.size() == 3 * (10 + 6) + 2 * 3 * 5); // floor with both corners, two sides up to the open top
    CHECK(lowest(wall).isApprox(Point<2>(-0.25, -0.25), 1e-12));
    CHECK(highest(wall).isApprox(Point<2>(1.25, 0.45), 1e-12));
    double nearest = 1;
    for (const auto& p : wall) {
        CHECK_FALSE(Box<2>({0, 0}, {1, 0.5}).contains(p));
        if (p[1] > 0)
            nearest = std::min(nearest, p[0] > 0.5 ? p[0] - 1 : -p[0]);
    }
    CHECK(nearest == Approx(0.05));
    require_distinct(wall, 0.1);
}

TEST_CASE("Tanks in 3D") {
    const Box<3> inner{{1e3, 0, 0}, {1e3 + 1, 0.6, 0.4}};
    SECTION("closed") {
        const auto wall = tank(inner, 0.1, 2);
        CHECK(wall.size() == 14 * 10 * 8 - 10 * 6 * 4);
        require_distinct(wall, 0.1);
        // With the water inside it makes one unbroken lattice.
        auto all = fill(inner, 0.1);
        all.insert(all.end(), wall.begin(), wall.end());
        CHECK(all.size() == 14 * 10 * 8);
        require_distinct(all, 0.1);
    }
    SECTION("periodic along y, open above: a channel") {
        const auto wall = tank(inner, 0.1, 2, Sides::y | Sides::z_high);
        CHECK(wall.size() == 14 * 6 * 6 - 10 * 6 * 4);
        CHECK(lowest(wall)[1] == Approx(0.05));
        CHECK(highest(wall)[1] == Approx(0.55));
        CHECK(highest(wall)[2] == Approx(0.35));
    }
    SECTION("a floor") {
        CHECK(tank(inner, 0.1, 3, Sides::x | Sides::y | Sides::z_high).size() == 10 * 6 * 3);
    }
}

TEST_CASE("A tank whose sides are no whole number of spacings keeps the first layer at half a spacing") {
    const auto wall = tank(Box<2>{{0, 0}, {1.03, 0.52}}, 0.1, 1);
    CHECK(wall.size() == 12 * 7 - 10 * 5);
    CHECK(lowest(wall).isApprox(Point<2>(-0.05, -0.05)));
    CHECK(highest(wall).isApprox(Point<2>(1.08, 0.57)));
}

TEST_CASE("Tanks refuse bad input") {
    const Box<2> inner{{0, 0}, {1, 1}};
    CHECK_THROWS_WITH(tank(inner, 0.0, 3), contains("spacing = 0 m"));
    CHECK_THROWS_WITH(tank(inner, 0.1, 0), contains("layers = 0"));
    CHECK_THROWS_WITH(tank(inner, 2.0, 3), contains("longer than side x"));
    CHECK_THROWS_WITH(tank(inner, 1e-9, 3), contains("lattice points"));
    CHECK_THROWS_WITH(tank(inner, 0.1, 3, Sides::z_high), contains("does not have"));
    CHECK_THROWS_WITH(tank(inner, 0.1, 3, Sides::x | Sides::y), contains("all sides are open"));
    CHECK_THROWS_WITH(tank(Box<2>::everywhere(), 0.1, 3), contains("bounded"));
}

TEST_CASE("Random numbers are even, unrelated and the same on every machine") {
    // Pinned: a change of these bits would change every user's jittered start.
    CHECK(random_number(1, 0) == 0x1.7906ac21d0e58p-2);
    CHECK(random_number(1, 1) == 0x1.e31ad9d27ad9ep-1);
    CHECK(random_number(42, 7, 2) == 0x1.b5c3e9c95175cp-2);
    static_assert(random_number(7, 3, 1) == random_number(7, 3, 1));
    double sum = 0, square = 0, product = 0;
    std::set<double> seen;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const auto index = static_cast<std::uint64_t>(i);
        const double x = random_number(42, index);
        REQUIRE(x >= 0);
        REQUIRE(x < 1);
        seen.insert(x);
        sum += x - 0.5;
        square += (x - 0.5) * (x - 0.5);
        product += (x - 0.5) * (random_number(42, index, 1) - 0.5) + (x - 0.5) * (random_number(43, index) - 0.5);
    }
    CHECK(seen.size() == n);
    CHECK(std::abs(sum / n) < 4 * std::sqrt(1 / 12.0 / n));
    CHECK(square / n == Approx(1 / 12.0).epsilon(0.02));
    CHECK(std::abs(product / n) < 4 * std::sqrt(2.0) / 12 / std::sqrt(1.0 * n));
}

TEST_CASE("Jitter moves every point a little, always in the same way") {
    const auto lattice = fill(Box<3>{{0, 0, 0}, {1, 1, 1}}, 0.1);
    const auto moved = jitter(lattice, 0.01, 5);
    REQUIRE(moved.size() == lattice.size());
    Point<3> mean = Point<3>::Zero();
    double largest = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Point<3> shift = moved[i] - lattice[i];
        CHECK(shift.norm() > 0);
        largest = std::max(largest, shift.cwiseAbs().maxCoeff());
        mean += shift / static_cast<double>(moved.size());
    }
    CHECK(largest <= 0.01 * (1 + 1e-12));
    CHECK(largest > 0.0099);
    CHECK(mean.norm() < 0.001);
    CHECK(jitter(lattice, 0.01, 5) == moved);
    CHECK(jitter(lattice, 0.01, 6) != moved);
    CHECK(jitter(lattice, 0.0, 5) == lattice);
    CHECK_THROWS_WITH(jitter(lattice, -0.01, 5), contains("amplitude = -0.01 m"));
    CHECK_THROWS_WITH(jitter(lattice, not_a_number, 5), contains("amplitude"));
}

TEST_CASE("Points in the same place are named") {
    auto points = fill(Box<3>{{0, 0, 0}, {1, 1, 1}}, 0.1);
    CHECK_NOTHROW(require_distinct(points, 0.1));
    CHECK_NOTHROW(require_distinct(std::vector<Point<2>>{}, 0.1));
    SECTION("exactly") {
        points[700] = points[12];
        CHECK_THROWS_WITH(require_distinct(points, 0.1),
                          contains("points 12 and 700") && contains("(0.25, 0.15, 0.05) m"));
    }
    SECTION("nearly, across the border of a hash cell, in every direction") {
        for (int code = 0; code < 27; ++code) {
            const Point<3> shift{code % 3 - 1.0, code / 3 % 3 - 1.0, code / 9 - 1.0};
            for (const Point<3>& at : {Point<3>{0, 0, 0}, Point<3>{1.6e-3, 1.6e-3, 1.6e-3}, Point<3>{-5, 7, 1e3}}) {
                points = {at, Point<3>{5, 5, 5}, at + 5e-5 * shift};
                CHECK_THROWS_WITH(require_distinct(points, 0.1), contains("points 0 and 2"));
            }
        }
    }
    SECTION("near but not too near") {
        points[700] = points[12] + Point<3>{1.01e-4, 0, 0};
        CHECK_NOTHROW(require_distinct(points, 0.1));
    }
    SECTION("not a number") {
        points[33][1] = not_a_number;
        CHECK_THROWS_WITH(require_distinct(points, 0.1), contains("point 33") && contains("nan"));
        points[33][1] = std::numeric_limits<double>::infinity();
        CHECK_THROWS_WITH(require_distinct(points, 0.1), contains("point 33") && contains("inf"));
    }
    SECTION("a spacing in another unit") {
        CHECK_NOTHROW(require_distinct(points, 1e-4));
        CHECK_THROWS_WITH(require_distinct(points, 1e3), contains("coincide"));
        CHECK_THROWS_WITH(require_distinct(points, 0.0), contains("spacing = 0 m"));
        points[0][0] = 1e200;
        CHECK_THROWS_WITH(require_distinct(points, 0.1), contains("point 0") && contains("too far"));
    }
    SECTION("agrees with comparing all pairs") {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            std::vector<Point<2>> cloud;
            for (std::uint64_t i = 0; i < 30; ++i) // least distance 1e-3, so some clouds have a pair, some do not
                cloud.push_back({0.03 * random_number(seed, i, 0), 0.03 * random_number(seed, i, 1)});
            double least = 1;
            for (std::size_t i = 0; i < cloud.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    least = std::min(least, (cloud[i] - cloud[j]).norm());
            if (least < 1e-3)
                CHECK_THROWS_AS(require_distinct(cloud, 1.0), Error);
            else
                CHECK_NOTHROW(require_distinct(cloud, 1.0));
        }
    }
}

} // namespace fill_test
