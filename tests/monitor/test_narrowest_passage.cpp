// Widths of slots and pores by their particles: as wide as the shapes they were filled from, and hollows are no pores.
#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

#include <limits>
#include <vector>

namespace passage_test {

namespace {

namespace sph = imbibe;
using imbibe_test::contains;
constexpr double dx = 0.01;

template <int dim>
using Columns = Eigen::Matrix<double, Eigen::Dynamic, dim>;

template <int dim>
Columns<dim> columns(const std::vector<sph::Point<dim>>& points) {
    Columns<dim> x(static_cast<Eigen::Index>(points.size()), dim);
    for (std::size_t i = 0; i < points.size(); ++i)
        x.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return x;
}
template <int dim>
sph::Box<dim> box(double from, double to, double bottom, double top) {
    sph::Point<dim> low = sph::Point<dim>::Zero(), high = sph::Point<dim>::Constant(0.12);
    low[0] = from, high[0] = to, low[1] = bottom, high[1] = top;
    return {low, high};
}

/// Two blocks with `gap` between them, one above the other.
template <int dim>
Columns<dim> slot(double gap) {
    auto points = sph::fill(box<dim>(0, 0.2, 0, 0.1), dx);
    for (const auto& x : sph::fill(box<dim>(0, 0.2, 0, 0.1), dx))
        points.push_back(x + (0.1 + gap) * sph::Point<dim>::Unit(1));
    return columns<dim>(points);
}

// Two blocks that fly towards each other, in water of 4 particles.
struct Water : sph::Fluid<sph::LinearState> {};
struct Blocks : sph::Solid<> {};
struct Contact : sph::Coupling<Water, Blocks, sph::KernelRepulsion<sph::WendlandC2>> {};
using Press = sph::Solver<2, double, sph::SymplecticEuler, Water, Blocks, Contact>;

} // namespace

TEST_CASE("A slot is as wide as it is", "[passage]") {
    for (const double gap : {0.7 * dx, dx, 2 * dx, 3.3 * dx}) {
        CAPTURE(gap);
        const auto in_plane = sph::narrowest_passage<2, double>(slot<2>(gap), dx, 4 * dx);
        REQUIRE(in_plane);
        CHECK(in_plane->width == Approx(gap).margin(1e-3 * dx));
        CHECK(in_plane->middle[1] == Approx(0.1 + gap / 2).margin(1e-3 * dx));
        CHECK(sph::narrowest_passage<3, double>(slot<3>(gap), dx, 4 * dx)->width == Approx(gap).margin(1e-3 * dx));
        CHECK_FALSE(sph::narrowest_passage<2, double>(slot<2>(gap), dx, 0.99 * gap));
    }
}

TEST_CASE("A slot across a periodic side is found", "[passage]") {
    const auto x = columns<2>(sph::fill(box<2>(0, 0.2, 0, 0.1), dx));
    CHECK_FALSE(sph::narrowest_passage<2, double>(x, dx, 3 * dx));
    const auto found = sph::narrowest_passage<2, double>(x, dx, 3 * dx, {.lower = {0, 0}, .length = {0, 0.12}});
    REQUIRE(found);
    CHECK(found->width == Approx(0.02));
}

TEST_CASE("Solids, corners of a tank and threads have no passages", "[passage]") {
    CHECK_FALSE(sph::narrowest_passage<2, double>(columns<2>(sph::fill(box<2>(0, 0.2, 0, 0.1), dx)), dx, 5 * dx));
    const auto tank = sph::tank(sph::Box<2>({0, 0}, {0.3, 0.3}), dx, 3);
    CHECK_FALSE(sph::narrowest_passage<2, double>(columns<2>(tank), dx, 10 * dx));
    const auto hollow = sph::tank(sph::Box<3>({0, 0, 0}, {0.12, 0.12, 0.12}), dx, 2);
    CHECK_FALSE(sph::narrowest_passage<3, double>(columns<3>(hollow), dx, 5 * dx));
    const auto ball = sph::Box<2>({-0.2, -0.2}, {0.2, 0.2}) - sph::Sphere<2>({0.001, 0.003}, 0.1);
    CHECK_FALSE(sph::narrowest_passage<2, double>(columns<2>(sph::fill(ball, dx)), dx, 10 * dx));
    CHECK_FALSE(
        sph::narrowest_passage<2, double>(columns<2>({{0, 0}, {dx, 0}, {2 * dx, 0}, {dx, 3 * dx}}), dx, 5 * dx));
    CHECK_FALSE(sph::narrowest_passage<2, double>(columns<2>({}), dx, 5 * dx));
}

TEST_CASE("Round pores are as wide as they are, but for half a spacing of their lattice on either side", "[passage]") {
    for (const double radius : {1.5 * dx, 2 * dx, 3 * dx, 4 * dx}) {
        const auto slab = sph::PerforatedSlab<3>(sph::Box<3>({0, 0, 0}, {0.3, 0.3, 0.1}),
                                                 {.count = {2, 2}, .pitch = 0.12, .radius = radius});
        const auto found = sph::narrowest_passage<3, double>(columns<3>(sph::fill(slab, dx)), dx, 12 * dx);
        CAPTURE(radius, found->width);
        REQUIRE(found);
        CHECK(found->width > slab.pore_width() - dx);
        CHECK(found->width < slab.pore_width() + dx);
    }
}

TEST_CASE("Passages narrower than nothing are refused", "[passage]") {
    REQUIRE_THROWS_WITH((sph::narrowest_passage<2, double>(slot<2>(dx), 0, 1)), contains("spacing = 0 m"));
    REQUIRE_THROWS_WITH((sph::narrowest_passage<2, double>(slot<2>(dx), dx, -1)), contains("widest = -1 m"));
}

TEST_CASE("A guard stops a run in which a pore closes", "[passage][guard]") {
    Press scene({.support_radius = 2.6 * dx, .time_step = 1e-3});
    const double particle = 0.8 * dx, gap = 4 * dx;
    scene.add(Water{{.density = 1000, .sound_speed = 100}}, sph::fill(box<2>(-0.5, -0.48, 0, 0.02), particle),
              particle);
    auto points = sph::fill(box<2>(0, 0.2, 0, 0.1), dx);
    const auto lower = static_cast<Eigen::Index>(points.size());
    for (const auto& x : sph::fill(box<2>(0, 0.2, 0, 0.1), dx))
        points.push_back(x + sph::Point<2>{0, 0.1 + gap});
    const auto blocks = scene.add(Blocks{{.density = 1000, .sound_speed = 100, .shear_modulus = 1e6}}, points, dx);
    auto view = scene[blocks];
    for (int i = 0; i < view.size(); ++i)
        view[sph::velocity](i, 1) = static_cast<Eigen::Index>(view.ids()[static_cast<std::size_t>(i)]) < lower ? 0 : -1;

    sph::Guard<2> all_the_same;
    REQUIRE_NOTHROW(all_the_same.look(scene));
    sph::Guard<2> guard({.least_pore = 2, .pore_interval = 4});
    REQUIRE_NOTHROW(guard.look(scene));
    try {
        scene.run_until(0.1, guard);
        FAIL("nothing was thrown");
    } catch (const sph::Diverged& error) {
        CHECK(error.cause == sph::Cause::narrow_pore);
        CHECK_THAT(error.what(), contains("Blocks") && contains("particles of") && contains("Water"));
        // 1 m/s, from 4 spacings to 1.6 takes 24 ms, and up to 4 steps more until it is looked for
        CHECK(error.time == Approx(0.026).margin(0.0025));
        REQUIRE(error.position.size() == 2);
        CHECK(error.position[1] > 0.1);
        CHECK(error.position[1] < 0.116);
    }
    REQUIRE_THROWS_WITH(sph::Guard<2>({.least_pore = -2}), contains("least_pore = -2"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.least_pore = std::numeric_limits<double>::infinity()}), contains("finite"));
    REQUIRE_THROWS_WITH(sph::Guard<2>({.pore_interval = 0}), contains("pore_interval = 0"));
}

TEST_CASE("A pore as wide as asked for is wide enough, far from the origin too", "[passage][guard]") {
    for (const double far : {0.0, 1e5})
        for (const double shift : {0.0, 0.1 * dx, 0.37 * dx, 1 / 3.0})
            for (const double particles : {2.0, 1.9}) {
                CAPTURE(far, shift, particles);
                // float positions of a hundred kilometres are right to 8 mm: those of the scene are counted from `far`
                sph::Solver<2, float, sph::SymplecticEuler, Water, Blocks, Contact> scene(
                    {.support_radius = 2.6 * dx,
                     .time_step = 1e-3,
                     .periodic_lower = {far, 0},
                     .periodic_length = {0.2, 0},
                     .origin = {far, 0}});
                const auto moved = [&](auto points) {
                    for (auto& x : points)
                        x += sph::Point<2>{far, shift};
                    return points;
                };
                scene.add(Water{{.density = 1000, .sound_speed = 100}}, moved(sph::fill(box<2>(0, 0.02, -0.2, -0.18), dx)),
                          dx);
                auto points = sph::fill(box<2>(0, 0.2, 0, 0.1), dx);
                for (const auto& x : sph::fill(box<2>(0, 0.2, 0, 0.1), dx))
                    points.push_back(x + sph::Point<2>{0, 0.1 + particles * dx});
                scene.add(Blocks{{.density = 1000, .sound_speed = 100, .shear_modulus = 1e6}}, moved(points), dx);
                sph::Guard<2> guard({.least_pore = 2});
                if (particles < 2)
                    CHECK_THROWS_WITH(guard.look(scene), contains("1.9 particles of") && contains("least_pore asks for 2"));
                else
                    CHECK_NOTHROW(guard.look(scene));
                CHECK_THROWS_WITH(sph::Guard<2>({.least_pore = 25}).look(scene),
                                  contains("least_pore = 25 particles of") && contains("a period of 0.2 m"));
            }
}

} // namespace passage_test
