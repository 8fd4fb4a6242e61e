// Particles that follow a surface, walls round a shape, and the distances to surfaces that both are made with.
#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/half_space.hpp>
#include <imbibe/geometry/pores.hpp>
#include <imbibe/geometry/sphere.hpp>

#include <limits>
#include <numbers>

namespace fitted_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {

/// A shape that knows nothing but which points it has, as a user's own may.
template <AnyShape S>
struct Plain {
    S shape;
    bool contains(const Point<shape_dimension<S>>& x) const { return shape.contains(x); }
    Box<shape_dimension<S>> bounds() const { return shape.bounds(); }
};

/// Places one behind the other, for the search.
template <int dim>
Eigen::Matrix<double, Eigen::Dynamic, dim> rows_of(const std::vector<Point<dim>>& points) {
    Eigen::Matrix<double, Eigen::Dynamic, dim> rows(static_cast<Eigen::Index>(points.size()), dim);
    for (std::size_t i = 0; i < points.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

/// How particles lie in a shape; lengths in spacings.
struct Layout {
    double mean_depth = 0, roughness = 0, least_depth = 1e9; ///< of the outermost layer
    double inner_sum = 0;                                    ///< mean of sum_b V_b W, 2.6 spacings deep and more
    double nearest = 1e9;                                    ///< distance of any two
};

template <AnyShape S>
Layout layout_of(const std::vector<Point<shape_dimension<S>>>& points, const S& shape, double spacing) {
    constexpr int dim = shape_dimension<S>;
    const double H = 2.6 * spacing;
    search::NeighbourSearch<dim, double> search(H);
    search.add(rows_of<dim>(points));
    search.update();
    Layout layout;
    double squares = 0;
    int outer = 0, inner = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double sum = WendlandC2::value(0.0);
        search.for_each(0, static_cast<int>(i), [&](int, const auto&, double distance) {
            sum += WendlandC2::value(distance / H);
            layout.nearest = std::min(layout.nearest, distance / spacing);
        });
        const double depth = -shape.distance(points[i]) / spacing;
        layout.least_depth = std::min(layout.least_depth, depth);
        if (depth < 0.9)
            layout.mean_depth += depth, squares += depth * depth, ++outer;
        if (depth > 2.6)
            layout.inner_sum += sum * std::pow(spacing / H, dim) * WendlandC2::normalisation<dim>(), ++inner;
    }
    layout.mean_depth /= outer;
    layout.roughness = std::sqrt(std::max(squares / outer - layout.mean_depth * layout.mean_depth, 0.0));
    layout.inner_sum /= std::max(inner, 1);
    return layout;
}

/// Of a lattice, by 2.6 spacings.
template <int dim>
constexpr double lattice_sum = dim == 2 ? 1.0105 : 1.0095;

template <int dim>
void check_round_body(double across) {
    const double spacing = 1 / across;
    const Sphere<dim> ball{Point<dim>::Constant(0.013), 0.5};
    CAPTURE(dim, across);
    const auto points = fitted(ball, spacing);
    CHECK(points.size() == static_cast<std::size_t>(std::llround(ball.volume() / std::pow(spacing, dim))));
    const Layout layout = layout_of(points, ball, spacing), stairs = layout_of(fill(ball, spacing), ball, spacing);
    CAPTURE(layout.mean_depth, layout.roughness, layout.least_depth, layout.inner_sum, layout.nearest);
    CHECK(layout.mean_depth == Approx(0.515).margin(0.03));
    CHECK(layout.least_depth > 0.49);
    CHECK(layout.roughness < 0.1);
    CHECK(stairs.roughness > 0.2);
    CHECK(layout.inner_sum == Approx(lattice_sum<dim>).epsilon(0.01));
    CHECK(layout.nearest > 0.7);
}

} // namespace

TEST_CASE("Fitted: the particles of a box along the lattice are those of fill") {
    const Box<3> box{{0.1, 0.2, -0.3}, {0.9, 0.8, 0.1}};
    auto points = fitted(box, 0.1);
    const auto lattice = fill(box, 0.1);
    REQUIRE(points.size() == lattice.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        CHECK((points[i] - lattice[i]).norm() < 1e-9);
}

TEST_CASE("Fitted: a round body has its volume, and its outer layer lies half a spacing deep") {
    check_round_body<2>(20);
    check_round_body<2>(40);
    check_round_body<3>(20);
}

TEST_CASE("Fitted: a turned, moved or enlarged shape is filled in its own frame") {
    const Box<2> box{{0, 0}, {1, 0.3}};
    const auto flat = fitted(box, 0.05), turned = fitted(rotated(box, 0.5), 0.05),
               scaled_up = fitted(scaled(box, 3), 0.15);
    REQUIRE(flat.size() == 120);
    REQUIRE(turned.size() == flat.size());
    REQUIRE(scaled_up.size() == flat.size());
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const Point<2> x = flat[i];
        CHECK((turned[i] -
               Point<2>(std::cos(0.5) * x[0] - std::sin(0.5) * x[1], std::sin(0.5) * x[0] + std::cos(0.5) * x[1]))
                  .norm() < 1e-12);
        CHECK((scaled_up[i] - 3 * x).norm() < 1e-12);
    }
}

TEST_CASE("Fitted: a face that runs across the lattice is followed, in a shape of which nothing else is known") {
    const auto shape = rotated(Box<2>{{0, 0}, {1, 0.3}}, 0.5);
    const auto points = fitted(Plain<Transformed<Box<2>>>{shape}, 0.05);
    CHECK(points.size() == 120);
    const Layout layout = layout_of(points, shape, 0.05), stairs = layout_of(fill(shape, 0.05), shape, 0.05);
    CAPTURE(layout.mean_depth, layout.least_depth, layout.nearest);
    CHECK(layout.mean_depth == Approx(0.52).margin(0.04));
    CHECK(layout.least_depth > 0.4); // at a corner, which the grid cuts off
    CHECK(layout.roughness < 0.1);
    CHECK(stairs.roughness > 0.2);
    CHECK(layout.nearest > 0.7);
}

TEST_CASE("Fitted: walls lie outside, in layers, and fit to the particles inside") {
    const Sphere<2> pool{{0, 0}, 0.5};
    const double spacing = 0.05;
    const auto water = fitted(pool, spacing), walls = walls_of(pool, spacing, 3);
    const double shell = std::numbers::pi * (0.65 * 0.65 - 0.25) / (spacing * spacing);
    CHECK(static_cast<double>(walls.size()) == Approx(shell).epsilon(0.05));
    for (const auto& x : walls) {
        CHECK(pool.distance(x) > 0.49 * spacing);
        CHECK(pool.distance(x) < 3 * spacing);
    }
    auto both = water;
    both.insert(both.end(), walls.begin(), walls.end());
    CHECK(layout_of(both, pool, spacing).nearest > 0.7);
    CHECK(layout_of(both, pool, spacing).inner_sum == Approx(lattice_sum<2>).epsilon(0.01));

    // Of a box they are those of a tank, but for the corners, which are round.
    const Box<2> box{{0, 0}, {1, 0.5}};
    for (const auto& x : walls_of(box, spacing, 2)) {
        CHECK(box.distance(x) ==
              Approx(box.distance(x) < spacing ? 0.5 * spacing : 1.5 * spacing).margin(0.7 * spacing));
        const Point<2> cell = x / spacing - Point<2>::Constant(0.5);
        CHECK((cell - cell.array().round().matrix()).norm() < 1e-9);
    }
}

TEST_CASE("Fitted: shapes that touch are packed together, and nothing is lost between them") {
    const double spacing = 0.05;
    const Box<2> tank_box{{-1, -1}, {1, 1}};
    const Sphere<2> ball{{0.02, 0.01}, 0.4};
    const auto [body, water, walls] = fitted_together(spacing, Point<2>(-1, -1), 2, ball, tank_box - ball);
    CHECK(body.size() == static_cast<std::size_t>(std::llround(ball.volume() / (spacing * spacing))));
    CHECK(body.size() + water.size() == 1600);
    CHECK(walls.size() >= 4u * 2u * 40u);
    for (const auto& x : body)
        CHECK(ball.distance(x) < -0.49 * spacing);
    for (const auto& x : water) {
        CHECK(ball.distance(x) > 0.49 * spacing);
        CHECK(tank_box.distance(x) < -0.49 * spacing);
    }
    auto all = body;
    all.insert(all.end(), water.begin(), water.end());
    CHECK(layout_of(all, tank_box, spacing).nearest > 0.7);
}

TEST_CASE("Fitted: the particles are the same for any number of threads") {
    const auto shape = Box<3>{{0, 0, 0}, {1, 1, 1}} - Cylinder{{0.5, 0.5, -0.5}, {0, 0, 1}, 0.3, 2};
    const auto one = fitted(shape, 0.1, {.steps = 20, .threads = 1}),
               three = fitted(shape, 0.1, {.steps = 20, .threads = 3});
    REQUIRE(one.size() == three.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        CHECK(one[i] == three[i]);
}

TEST_CASE("Level set: the distance that is found with contains() alone is the shape's own") {
    const auto check = [](const auto& shape, double tolerance) {
        constexpr int dim = shape_dimension<std::remove_cvref_t<decltype(shape)>>;
        const double cell = 0.025;
        const Point<dim> anchor = Point<dim>::Constant(0.003);
        const LevelSet<dim> exact(shape, cell, anchor, 0.2),
            found(Plain<std::remove_cvref_t<decltype(shape)>>{shape}, cell, anchor, 0.2);
        CHECK(found.volume() == Approx(shape.volume()).epsilon(0.003));
        double greatest = 0;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            const Point<dim> x = even_point(Box<dim>{Point<dim>::Constant(-0.7), Point<dim>::Constant(0.9)}, i);
            const double want = std::clamp(shape.distance(x), -0.2, 0.2);
            if (std::abs(want) < 0.2 - 2 * cell)
                greatest = std::max(greatest, std::abs(found(x) - want));
            CHECK(exact(x) == Approx(want).margin(0.5 * cell));
            CHECK((shape.distance(x) <= 0) == shape.contains(x));
        }
        CHECK(greatest < tolerance);
    };
    check(Sphere<2>{{0.1, 0.05}, 0.5}, 0.002);
    check(Sphere<3>{{0.1, 0.05, 0}, 0.5}, 0.003);
    check(Box<2>{{-0.2, -0.4}, {0.5, 0.6}}, 0.35 * 0.025); // the corners are cut off
    check(Cylinder{{-0.2, -0.1, -0.2}, {1, 0.5, 0.7}, 0.3, 0.8}, 0.5 * 0.025);
}

TEST_CASE("Level set: deep inside and far outside it says no more than the band") {
    const LevelSet<2> ball(Sphere<2>{{0, 0}, 1}, 0.05, Point<2>(0, 0), 0.3);
    CHECK(ball(Point<2>(0, 0)) == Approx(-0.3));
    CHECK(ball(Point<2>(5, 0)) == 0.3);
    CHECK(ball(Point<2>(0.9, 0)) == Approx(-0.1).margin(0.002));
    Point<2> normal;
    (void)ball(Point<2>(0, 1.1), normal);
    CHECK((normal - Point<2>(0, 1)).norm() < 0.025);
}

TEST_CASE("Fitted: what cannot be filled is refused with the numbers") {
    const Sphere<2> ball{{0, 0}, 0.5};
    CHECK_THROWS_WITH(fitted(ball, 0), contains("spacing = 0 m"));
    CHECK_THROWS_WITH(fitted(ball, 2.0), contains("volume of 0.785398 m^2") && contains("smaller spacing"));
    CHECK_THROWS_WITH(fitted(HalfSpace<2>{{0, 0}, {1, 1}}, 0.1), contains("no bounds"));
    CHECK_THROWS_WITH(fitted(ball, 0.1, {.steps = -1}), contains("steps = -1"));
    CHECK_THROWS_WITH(fitted(ball, 0.1, {.threads = 5000}), contains("threads = 5000"));
    CHECK_THROWS_WITH(walls_of(ball, 0.1, 0), contains("layers = 0"));
    CHECK_THROWS_WITH(fitted(ball, std::numeric_limits<double>::quiet_NaN()), contains("spacing = nan"));
}

} // namespace fitted_test
