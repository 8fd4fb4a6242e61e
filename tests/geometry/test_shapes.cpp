// Shapes on their own: what they contain, their bounds, and what their constructors refuse.
#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/half_space.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/transform.hpp>

#include <limits>
#include <numbers>

namespace shapes_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

// A shape that a user might write: it needs nothing from the library but Point and Box.
struct Diamond {
    bool contains(const Point<2>& p) const { return std::abs(p[0]) + std::abs(p[1]) <= 1; }
    Box<2> bounds() const { return Box<2>{{-1, -1}, {1, 1}}; }
};

static_assert(Shape<Box<2>, 2> && Shape<Box<3>, 3> && !Shape<Box<2>, 3>);
static_assert(Shape<Sphere<2>, 2> && Shape<Cylinder, 3> && Shape<HalfSpace<3>, 3> && Shape<Diamond, 2>);
static_assert(AnyShape<Diamond> && shape_dimension<Diamond> == 2);
static_assert(!AnyShape<int> && !AnyShape<Point<3>> && !AnyShape<std::vector<int>>);
template <class A, class B>
constexpr bool joinable = requires(const A& a, const B& b) {
    a | b;
};
static_assert(joinable<Box<2>, Diamond> && !joinable<Box<2>, Box<3>>);
} // namespace

TEST_CASE("A box contains its inside and its faces") {
    const Box<3> box{{0, 0, 0}, {1, 2, 3}};
    CHECK(box.contains({0.5, 1, 1.5}));
    CHECK(box.contains({0, 0, 0}));
    CHECK(box.contains({1, 2, 3}));
    CHECK_FALSE(box.contains({1.0001, 1, 1}));
    CHECK_FALSE(box.contains({0.5, -0.0001, 1}));
    CHECK_FALSE(box.contains({not_a_number, 1, 1}));
    CHECK(box.volume() == Approx(6));
    CHECK(box.centre() == Point<3>(0.5, 1, 1.5));
    CHECK(box.bounds().upper() == box.upper());
    CHECK_FALSE(Box<2>::everywhere().bounded());
    CHECK(Box<2>::everywhere().contains({1e300, -1e300}));
}

TEST_CASE("A box refuses corners that make no box") {
    CHECK_THROWS_WITH((Box<2>{{0, 0}, {1, 0}}), contains("side y") && contains("must be > 0 m"));
    CHECK_THROWS_WITH((Box<3>{{1, 0, 0}, {0, 1, 1}}), contains("side x") && contains("-1 m long"));
    CHECK_THROWS_WITH((Box<2>{{not_a_number, 0}, {1, 1}}), contains("lower corner") && contains("finite"));
    CHECK_THROWS_WITH((Box<2>{{0, 0}, {1, infinity}}), contains("upper corner") && contains("finite"));
    CHECK_THROWS_AS((Box<2>{{0, 0}, {0, 0}}), Error);
}

TEST_CASE("Balls and discs") {
    const Sphere<3> ball{{1, 0, 0}, 2};
    CHECK(ball.contains({2.9, 0, 0}));
    CHECK_FALSE(ball.contains({3.1, 0, 0}));
    CHECK(ball.bounds().lower() == Point<3>(-1, -2, -2));
    CHECK(ball.volume() == Approx(32 * pi / 3));
    CHECK(volume_fraction(ball, ball.bounds()) == Approx(pi / 6).margin(0.002));
    const Sphere<2> disc{{0, 0}, 1};
    CHECK(disc.volume() == Approx(pi));
    CHECK(volume_fraction(disc, disc.bounds()) == Approx(pi / 4).margin(0.002));
    CHECK_THROWS_WITH((Sphere<2>{{0, 0}, 0.0}), contains("radius = 0 m") && contains("> 0 m"));
    CHECK_THROWS_WITH((Sphere<2>{{0, 0}, -1.0}), contains("radius = -1 m"));
    CHECK_THROWS_WITH((Sphere<3>{{0, 0, 0}, not_a_number}), contains("radius = nan m"));
    CHECK_THROWS_WITH((Sphere<3>{{0, infinity, 0}, 1}), contains("centre"));
}

TEST_CASE("A slanted cylinder") {
    const Point<3> start{1, 2, 3};
    const Point<3> axis{1, 1, 0};
    const Cylinder cylinder{start, axis, 0.5, 2};
    const Point<3> end = start + 2 * axis.normalized();
    CHECK(cylinder.contains(start));
    CHECK(cylinder.contains(0.5 * (start + end)));
    CHECK(cylinder.contains(start + axis.normalized() + Point<3>(0, 0, 0.49)));
    CHECK_FALSE(cylinder.contains(start + axis.normalized() + Point<3>(0, 0, 0.51)));
    CHECK_FALSE(cylinder.contains(start - 0.01 * axis));
    CHECK_FALSE(cylinder.contains(end + 0.01 * axis));
    // Bounds are tight: r sqrt(1 - 1/2) beyond the ends along x and y, r along z.
    CHECK(cylinder.bounds().lower().isApprox(Point<3>(1 - 0.5 * std::sqrt(0.5), 2 - 0.5 * std::sqrt(0.5), 2.5)));
    CHECK(cylinder.bounds().upper().isApprox(end + Point<3>(0.5 * std::sqrt(0.5), 0.5 * std::sqrt(0.5), 0.5)));
    const Box<3> bounds = cylinder.bounds();
    CHECK(volume_fraction(cylinder, bounds) * bounds.volume() == Approx(cylinder.volume()).epsilon(0.005));
    CHECK_THROWS_WITH((Cylinder{{0, 0, 0}, {0, 0, 0}, 1, 1}), contains("axis"));
    CHECK_THROWS_WITH((Cylinder{{0, 0, 0}, {0, 0, 1}, -1, 1}), contains("radius = -1 m"));
    CHECK_THROWS_WITH((Cylinder{{0, 0, 0}, {0, 0, 1}, 1, 0}), contains("length = 0 m"));
}

TEST_CASE("A half space has bounds only for a normal along an axis") {
    const HalfSpace<3> under{{0, 0, 2}, {0, 0, 5}};
    CHECK(under.contains({7, -8, 2}));
    CHECK_FALSE(under.contains({7, -8, 2.001}));
    CHECK(under.bounds().upper()[2] == 2);
    CHECK(under.bounds().lower()[2] == -infinity);
    CHECK((HalfSpace<3>{{0, 0, 2}, {0, 0, -1}}.bounds().lower()[2]) == 2);
    const HalfSpace<2> slanted{{0, 0}, {1, 1}};
    CHECK(slanted.contains({-1, 0.5}));
    CHECK_FALSE(slanted.contains({1, -0.5}));
    CHECK(slanted.bounds().upper()[0] == infinity);
    for (const double length : {1e-200, 1e200}) { // whose squares are no numbers
        CHECK((HalfSpace<2>{{0, 0}, {0, length}}.normal()) == Point<2>(0, 1));
        CHECK(Cylinder({0, 0, 0}, {0, 0, length}, 1, 1).axis() == Point<3>(0, 0, 1));
    }
    CHECK_THROWS_WITH((HalfSpace<2>{{0, 0}, {0, 0}}), contains("normal") && contains("must not be zero"));
    CHECK_THROWS_WITH((HalfSpace<2>{{not_a_number, 0}, {0, 1}}), contains("point"));
}

TEST_CASE("Union, difference and intersection") {
    const Box<2> left{{0, 0}, {2, 2}};
    const Box<2> right{{1, 1}, {3, 3}};
    const auto both = left | right;
    const auto only_left = left - right;
    const auto overlap = left & right;
    for (const double x : {0.5, 1.5, 2.5})
        for (const double y : {0.5, 1.5, 2.5}) {
            const Point<2> p{x, y};
            CHECK(both.contains(p) == (left.contains(p) || right.contains(p)));
            CHECK(only_left.contains(p) == (left.contains(p) && !right.contains(p)));
            CHECK(overlap.contains(p) == (x == 1.5 && y == 1.5));
        }
    CHECK(both.bounds().upper() == Point<2>(3, 3));
    CHECK(only_left.bounds().upper() == Point<2>(2, 2));
    CHECK(overlap.bounds().lower() == Point<2>(1, 1));
    CHECK(overlap.bounds().upper() == Point<2>(2, 2));
    CHECK_THROWS_WITH((left & Box<2>{{5, 5}, {6, 6}}), contains("no volume in common"));
    // A half space cuts the bounds too, so that a lattice starts at the cut.
    CHECK((left & HalfSpace<2>{{0.5, 0}, {-1, 0}}).bounds().lower() == Point<2>(0.5, 0));
    // Unlike types nest, and the user's own shape takes part.
    const auto nested = ((left | Sphere<2>{{4, 4}, 1}) - Diamond{}) & Box<2>{{-1, -1}, {4, 4}};
    static_assert(Shape<decltype(nested), 2>);
    CHECK(nested.contains({1.5, 1.5}));
    CHECK_FALSE(nested.contains({0.2, 0.2}));
}

TEST_CASE("Moved, turned and enlarged shapes") {
    const Box<2> box{{0, 0}, {2, 1}};
    const auto moved = translated(box, {10, 20});
    CHECK(moved.contains({11, 20.5}));
    CHECK_FALSE(moved.contains({1, 0.5}));
    CHECK(moved.bounds().lower() == Point<2>(10, 20));
    CHECK(moved.bounds().upper() == Point<2>(12, 21));

    const auto turned = rotated(box, pi / 2); // x to y, y to -x
    CHECK(turned.contains({-0.5, 1.9}));
    CHECK_FALSE(turned.contains({0.5, 0.5}));
    CHECK(turned.bounds().lower().isApprox(Point<2>(-1, 0), 1e-12));
    CHECK(turned.bounds().upper().isApprox(Point<2>(Point<2>(0, 2) + 1e-16 * Point<2>::Ones()), 1e-12));

    const auto about = rotated(box, pi, Point<2>{2, 1});
    CHECK(about.contains({3, 1.5}));
    CHECK_FALSE(about.contains({1, 0.5}));

    const auto twice = scaled(box, 2, {2, 1});
    CHECK(twice.bounds().lower() == Point<2>(-2, -1));
    CHECK(twice.bounds().upper() == Point<2>(2, 1));
    CHECK(twice.contains({-1.9, 0.9}));

    const auto solid = rotated(Box<3>{{0, 0, 0}, {1, 2, 3}}, 2 * pi / 3, {1, 1, 1}); // x to y to z to x
    CHECK(solid.contains({2.9, 0.9, 1.9}));
    CHECK_FALSE(solid.contains({0.9, 1.9, 2.9}));
    CHECK(solid.bounds().upper().isApprox(Point<3>(3, 1, 2)));
    const auto slanted = rotated(Box<3>{{0, 0, 0}, {1, 1, 1}}, 0.7, {1, 2, 3}, {4, 5, 6});
    CHECK(volume_fraction(slanted, slanted.bounds()) * slanted.bounds().volume() == Approx(1).epsilon(0.01));

    CHECK_FALSE(rotated(HalfSpace<2>{{0, 0}, {0, 1}}, 0.3).bounds().bounded());
    CHECK_THROWS_WITH(rotated(box, not_a_number), contains("angle") && contains("radians"));
    CHECK_THROWS_WITH(rotated(Box<3>({0, 0, 0}, {1, 1, 1}), 1, {0, 0, 0}), contains("axis"));
    CHECK_THROWS_WITH(scaled(box, 0), contains("factor = 0"));
    CHECK_THROWS_WITH(scaled(box, -2), contains("factor = -2"));
    CHECK_THROWS_WITH(translated(box, {not_a_number, 0}), contains("shift"));
}

} // namespace shapes_test
