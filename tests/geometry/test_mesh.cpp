// Bodies inside meshes of triangles: sound ones, damaged ones, and what the report says of them.
#include "small_meshes.hpp"

#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/mesh_report.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/thickness.hpp>

#include <limits>

namespace mesh_test {

using namespace imbibe;
using imbibe_test::contains;
using small_meshes::operator+;
using small_meshes::turned;

namespace {

const Point<3> low{-0.5, -0.4, -0.3}, high{0.5, 0.6, 0.7};

/// How many of some points the mesh and the shape disagree about.
template <class S>
int wrong(const TriangleMesh& mesh, const S& shape) {
    int number = 0;
    const Box<3> round{Point<3>::Constant(-1.1), Point<3>::Constant(1.1)};
    for (std::uint64_t i = 0; i < 4000; ++i)
        number += mesh.contains(even_point(round, i)) != shape.contains(even_point(round, i));
    return number;
}

/// The triangles that `chosen(random number from 0 to 1)` picks, changed by `change`.
template <class Chosen, class Change>
Triangles with(Triangles mesh, const Chosen& chosen, const Change& change) {
    std::vector<std::array<int, 3>> result;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!chosen(random_number(7, t)) || change(mesh.triangles[t]))
            result.push_back(mesh.triangles[t]);
    mesh.triangles = result;
    return mesh;
}
Triangles missing(const Triangles& mesh, double share) {
    return with(
        mesh, [&](double x) { return x < share; }, [](auto&) { return false; });
}
Triangles flipped(const Triangles& mesh, double share) {
    return with(
        mesh, [&](double x) { return x < share; }, [](auto& t) { return std::swap(t[1], t[2]), true; });
}

bool says(const MeshReport& report, const std::string& words) {
    return std::any_of(report.sentences.begin(), report.sentences.end(),
                       [&](const auto& sentence) { return sentence.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("Mesh: a box of triangles is that box") {
    const Box<3> box{low, high};
    const TriangleMesh mesh(small_meshes::box(low, high, 5));
    CHECK(mesh.facets().size() == 300);
    CHECK(mesh.damage().parts == 1);
    CHECK(mesh.damage().open_edges + mesh.damage().odd_edges + mesh.damage().flipped + mesh.damage().copies == 0);
    CHECK(mesh.volume() == Approx(1));
    CHECK((mesh.bounds().lower() - low).norm() < 1e-12);
    CHECK(wrong(mesh, box) == 0);
    for (std::uint64_t i = 0; i < 500; ++i) {
        const Point<3> x = even_point(Box<3>{Point<3>::Constant(-1), Point<3>::Constant(1)}, i);
        CHECK(mesh.distance(x) == Approx(box.distance(x)).margin(1e-12));
        CHECK(mesh.winding_number(x) == Approx(box.contains(x) ? 1 : 0).margin(0.03)); // the moments of far branches
    }
}

TEST_CASE("Mesh: it combines with other shapes and is filled and fitted as they are") {
    const TriangleMesh mesh(small_meshes::box(low, high));
    CHECK(fill(mesh, 0.1).size() == 1000);
    const auto points = fitted(mesh, 0.1), lattice = fill(Box<3>{low, high}, 0.1);
    REQUIRE(points.size() == 1000);
    for (std::size_t i = 0; i < points.size(); ++i)
        CHECK((points[i] - lattice[i]).norm() < 1e-5);
    CHECK(fill(Box<3>{Point<3>::Constant(-1), Point<3>::Constant(1)} - mesh, 0.1).size() == 7000);
    CHECK(fitted(scaled(mesh, 1e-3), 1e-4).size() == 1000);
    CHECK(scaled(mesh, 2).volume() == Approx(8));
    CHECK(rotated(mesh, 0.3, {0, 0, 1}).distance({0, 0, 10}) == Approx(mesh.distance({0, 0, 10})));
}

TEST_CASE("Mesh: damage is mended, and no point is on the wrong side") {
    const TriangleMesh sound(small_meshes::ball({0, 0, 0}, 1, 4));
    const Triangles ball = small_meshes::ball({0, 0, 0}, 1, 4);
    CHECK(sound.volume() == Approx(4.18879).epsilon(0.01));
    CHECK(sound.facets().size() == 2048);

    const TriangleMesh inside_out(turned(ball));
    CHECK(inside_out.damage().inside_out == 1);
    CHECK(wrong(inside_out, sound) == 0);

    for (const double share : {0.01, 0.05, 0.2}) {
        CAPTURE(share);
        const TriangleMesh some(flipped(ball, share));
        CHECK(static_cast<double>(some.damage().flipped) == Approx(share * 2048).epsilon(0.2));
        CHECK(some.damage().open_edges == 0);
        CHECK(wrong(some, sound) == 0);
    }
    for (const auto& [share, allowed] : {std::pair{0.005, 0}, std::pair{0.02, 0}, std::pair{0.05, 2}}) {
        CAPTURE(share);
        const TriangleMesh some(missing(ball, share));
        CHECK(some.damage().open_edges > 0);
        CHECK(wrong(some, sound) <= allowed);
        CHECK(some.volume() == Approx(sound.volume()).epsilon(0.002));
    }
    const TriangleMesh twice(ball + ball), twice_turned(ball + turned(ball));
    CHECK(twice.damage().copies == 2048);
    CHECK(twice_turned.damage().copies == 2048);
    CHECK(wrong(twice, sound) == 0);
    CHECK(wrong(twice_turned, sound) == 0);

    Triangles soup = ball;
    for (std::size_t i = 0; i < soup.corners.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            soup.corners[i][axis] += 1e-4 * (random_number(1, i, static_cast<std::uint64_t>(axis)) - 0.5);
    CHECK(wrong(TriangleMesh(soup), sound) == 0);

    Triangles with_slivers = ball;
    small_meshes::add(with_slivers, {0, 0, 1}, {0, 0, 1}, {1, 0, 0});
    small_meshes::add(with_slivers, {0, 0, 1}, {0, 0, 0.5}, {0, 0, 0});
    CHECK(TriangleMesh(with_slivers).damage().degenerate == 2);
}

TEST_CASE("Mesh: blocks beside a gap are not settled by what is far from the gap") {
    Triangles open = small_meshes::box(low, high, 4);
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 8); // a quarter of a side is gone
    const TriangleMesh mesh(open);
    CHECK(mesh.damage().open_edges > 0);
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const Point<3> x = even_point(Box<3>{low, high}, i);
        CHECK(mesh.contains(x) == (mesh.winding_number(x) > 0.5));
    }
}

TEST_CASE("Mesh: a cavity stays hollow, and a mesh far from the origin keeps its volume") {
    const Triangles hollow = small_meshes::ball({0, 0, 0}, 1, 3) + turned(small_meshes::ball({0, 0, 0}, 0.5, 3));
    const TriangleMesh mesh(hollow);
    CHECK(mesh.damage().parts == 2);
    CHECK_FALSE(mesh.contains({0, 0, 0}));
    CHECK(mesh.contains({0.75, 0, 0}));
    CHECK(mesh.distance({0.25, 0, 0}) == Approx(0.25).margin(0.01));

    // Inside out as a whole it is mended as a whole; one of two bodies beside each other by itself.
    const TriangleMesh turned_round(turned(hollow));
    CHECK(turned_round.damage().inside_out == 2);
    CHECK(wrong(turned_round, mesh) == 0);
    const TriangleMesh one_turned(small_meshes::ball({-0.5, 0, 0}, 0.4, 2) +
                                  turned(small_meshes::ball({0.5, 0, 0}, 0.3, 2)));
    CHECK(one_turned.damage().inside_out == 1);
    CHECK(one_turned.contains({-0.5, 0, 0}));
    CHECK(one_turned.contains({0.5, 0, 0}));

    Triangles far = hollow;
    for (auto& corner : far.corners)
        corner += Point<3>(30e3, -20e3, 10e3);
    CHECK(TriangleMesh(far).volume() == Approx(mesh.volume()).epsilon(1e-9));
    CHECK(TriangleMesh(far).contains(Point<3>(30e3, -20e3, 10e3) + Point<3>(0.75, 0, 0)));
}

TEST_CASE("Mesh: bodies that overlap or touch are one") {
    const Box<3> left{low, high}, right{low + Point<3>(0.4, 0.1, 0.1), high + Point<3>(0.4, 0.1, 0.1)};
    const TriangleMesh both(small_meshes::box(left.lower(), left.upper(), 3) +
                            small_meshes::box(right.lower(), right.upper(), 3));
    CHECK(both.damage().parts == 2);
    CHECK(wrong(both, left | right) == 0);
    CHECK(both.volume() == Approx(2 - 0.6 * 0.9 * 0.9).epsilon(0.005));
    // The middle of what they share lies deep in the body, on a face of neither.
    CHECK(both.distance({0.2, 0.15, 0.25}) < -0.3);

    const TriangleMesh touching(small_meshes::box(low, high, 3) +
                                small_meshes::box(low + Point<3>(1, 0, 0), high + Point<3>(1, 0, 0), 3));
    CHECK(touching.damage().inner == 18);
    CHECK(touching.damage().copies == 0);
    CHECK(touching.damage().open_edges == 0);
    CHECK(touching.volume() == Approx(2));
    CHECK(touching.distance({0.5, 0.1, 0.2}) == Approx(-0.5));
}

TEST_CASE("Mesh: what is no mesh is refused with the place") {
    CHECK_THROWS_WITH(TriangleMesh(Triangles{}), contains("no triangles"));
    Triangles bad = small_meshes::box(low, high);
    bad.corners[5][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(TriangleMesh(bad), contains("corner 5"));
    bad = small_meshes::box(low, high);
    bad.triangles[3][0] = 99;
    CHECK_THROWS_WITH(TriangleMesh(bad), contains("triangle 3") && contains("corner 99") && contains("0 to 35"));
    Triangles flat;
    small_meshes::add(flat, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    CHECK_THROWS_WITH(TriangleMesh(flat), contains("area"));
}

TEST_CASE("Mesh report: a sound part is measured in metres, spacings and particles") {
    const MeshReport report = mesh_report(TriangleMesh(small_meshes::box(low, high, 2)), 0.05);
    CHECK(report.sound);
    CHECK(report.volume == Approx(1));
    CHECK(report.volume_error == Approx(0).margin(1e-12));
    CHECK(report.thin < 0.02); // its edges
    CHECK(says(report, "20 spacings of 0.05 m"));
    CHECK(says(report, "8000 particles"));
}

TEST_CASE("Mesh report: a leaking scan, a part in millimetres and one inside out are named") {
    const Triangles box = small_meshes::box(low, high, 4);
    const MeshReport leaking = mesh_report(TriangleMesh(missing(box, 0.02)), 0.05);
    CHECK_FALSE(leaking.sound);
    CHECK(says(leaking, "leaks"));

    Triangles in_millimetres = box;
    for (auto& corner : in_millimetres.corners)
        corner *= 1000;
    const MeshReport large = mesh_report(TriangleMesh(in_millimetres), 0.05);
    CHECK_FALSE(large.sound);
    CHECK(says(large, "right unit"));
    CHECK(says(large, "20000 spacings"));
    CHECK(says(mesh_report(TriangleMesh(box), 40.0), "right unit"));

    CHECK(says(mesh_report(TriangleMesh(turned(box)), 0.05), "inside out"));
    CHECK(says(mesh_report(TriangleMesh(flipped(box, 0.1)), 0.05), "faced the other way"));
    CHECK(says(mesh_report(TriangleMesh(box + box), 0.05), "there twice"));
    CHECK_THROWS_WITH(mesh_report(TriangleMesh(box), 0), contains("spacing = 0 m"));
}

TEST_CASE("Thickness: what is thinner than a width is found, and a plate that is thicker is not") {
    const Box<3> plate{{0, 0, 0}, {20, 20, 2}};
    CHECK(thin_share(plate, 2.5) == Approx(1));
    CHECK(thin_share(plate, 1.5) < 0.05);
    CHECK(thin_share(Sphere<2>{{0, 0}, 1}, 1.8) < 0.01);
    CHECK(thin_share(Sphere<2>{{0, 0}, 1}, 2.5) == Approx(1));
    // A ball with a thin plate through it: the plate is that part of the area.
    const auto both = Sphere<2>{{0, 0}, 1} | Box<2>{{-4, -0.1}, {4, 0.1}};
    CHECK(thin_share(both, 0.5) == Approx(1.2 / (3.1416 + 1.2)).margin(0.03));
    CHECK_THROWS_WITH(thin_share(plate, -1), contains("width = -1 m"));
}

} // namespace mesh_test
