// Bodies from images: the surface between voxels, what is beyond the sides, islands, widths of pores, and the report.
#include <catch_shim.hpp>

#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/image_report.hpp>
#include <imbibe/geometry/particle_image.hpp>
#include <imbibe/geometry/sphere.hpp>

#include <limits>

namespace image_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {

/// An image of n voxels a side: 255 where `solid(centre)` holds in voxels, else 0.
template <class Solid>
GreyImage image_of(int n, const Solid& solid) {
    GreyImage image;
    image.size = {n, n, n};
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                image.values.push_back(solid(Point<3>(x + 0.5, y + 0.5, z + 0.5)) ? 255.0f : 0.0f);
    return image;
}
/// Grey values that fall linearly through 100 at the distance `radius` from the middle, as a scanner's would.
GreyImage grey_ball(int n, double radius) {
    GreyImage image;
    image.size = {n, n, n};
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double away = (Point<3>(x + 0.5, y + 0.5, z + 0.5) - Point<3>::Constant(0.5 * n)).norm() - radius;
                image.values.push_back(static_cast<float>(std::clamp(100 - 50 * away, 0.0, 200.0)));
            }
    return image;
}
/// Voxels of a tenth of a millimetre.
Voxels voxels(SolidIs solid = SolidIs::above, double threshold = 100) {
    return {.sides = {1e-4, 1e-4, 1e-4}, .threshold = threshold, .solid = solid};
}
bool says(const ImageReport& report, const std::string& words) {
    return std::any_of(report.sentences.begin(), report.sentences.end(),
                       [&](const auto& sentence) { return sentence.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("Image: the surface lies between voxels where the grey value says") {
    const ImageBody ball(grey_ball(24, 8), voxels());
    CHECK(ball.bounds().size().isApprox(Point<3>::Constant(24e-4)));
    const Sphere<3> exact{Point<3>::Constant(12e-4), 8e-4};
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const Point<3> x = even_point(ball.bounds(), i);
        if (std::abs(exact.distance(x)) > 0.2e-4) // a fifth of a voxel
            CHECK(ball.contains(x) == exact.contains(x));
    }
    const auto points = fitted(ball, 1e-4);
    CHECK(static_cast<double>(points.size()) == Approx(exact.volume() / 1e-12).epsilon(0.02));
    // The other side is solid.
    const ImageBody hole(grey_ball(24, 8), voxels(SolidIs::below));
    CHECK_FALSE(hole.contains(Point<3>::Constant(12e-4)));
    CHECK(hole.porosity() == Approx(1 - ball.porosity()));
}

TEST_CASE("Image: beyond its sides is nothing, solid, or the image again") {
    const GreyImage image = image_of(8, [](const Point<3>& x) { return x[0] < 2; });
    Voxels how = voxels();
    how.bounds = Box<3>{Point<3>::Constant(-8e-4), Point<3>::Constant(16e-4)};
    const Point<3> left{-1e-4, 1e-4, 1e-4}, far_left{-5e-4, 1e-4, 1e-4}, right{15.5e-4, 1e-4, 1e-4};
    const ImageBody open(image, how);
    CHECK_FALSE(open.contains(left));
    how.beyond = Beyond::solid;
    const ImageBody solid(image, how);
    CHECK(solid.contains(left));
    CHECK(solid.contains(far_left));
    CHECK_FALSE(solid.contains({4e-4, 4e-4, 4e-4}));
    how.beyond = Beyond::mirrored;
    const ImageBody mirrored(image, how);
    CHECK(mirrored.contains(left));
    CHECK_FALSE(mirrored.contains(far_left));
    CHECK(mirrored.contains(right));
    CHECK_FALSE(mirrored.contains({17e-4, 1e-4, 1e-4})); // beyond the bounds
    how.beyond = Beyond::repeated;
    const ImageBody repeated(image, how);
    CHECK_FALSE(repeated.contains({-1e-4, 1e-4, 1e-4}));
    CHECK(repeated.contains({-7e-4, 1e-4, 1e-4}));
    CHECK(repeated.contains({9e-4, 1e-4, 1e-4}));
    // Between the last voxel and the first of the next the value is linear, too.
    CHECK(repeated.contains({-0.01e-4, 1e-4, 1e-4}) == repeated.contains({7.99e-4, 1e-4, 1e-4}));
    CHECK(repeated.contains({0.05e-4, 1e-4, 1e-4}));
    CHECK_FALSE(repeated.contains({7.6e-4, 1e-4, 1e-4}));
}

TEST_CASE("Image: of particles it has their volume and their surface, also across the cell's sides") {
    const Box<3> cell({0, 0, 0}, {24, 24, 20});
    const Sphere<3> middle({0, 12, 10}, 7); // half of it on either side of x = 0
    std::vector<Point<3>> points = fitted(middle, 1);
    const auto body = body_of_particles(points, cell, 1);
    CHECK(1 - body.porosity() == Approx(static_cast<double>(points.size()) / cell.volume()).epsilon(1e-3));
    int wrong = 0, asked = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const Point<3> x = even_point(cell, i);
        const Point<3> nearest = x[0] > 12 ? Point<3>(x[0] - 24, x[1], x[2]) : x;
        if (std::abs(middle.distance(nearest)) < 0.3)
            continue;
        ++asked;
        wrong += body.contains(x) != middle.contains(nearest) ? 1 : 0;
    }
    CHECK(asked > 3000);
    CHECK(wrong == 0);
    CHECK_THROWS_WITH(body_of_particles({}, cell, 1), contains("0 particles"));
    CHECK_THROWS_WITH(body_of_particles(points, cell, 10), contains("at least 4"));
    points[0][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(body_of_particles(points, cell, 1), contains("must be finite"));
}

TEST_CASE("Image: a part of it keeps its values, and a part that is not there is refused") {
    const GreyImage image = image_of(8, [](const Point<3>& x) { return x[0] < 2; });
    const GreyImage part = crop(image, {1, 2, 3}, {4, 8, 5});
    CHECK(part.size == std::array<int, 3>{3, 6, 2});
    CHECK(part.at(0, 0, 0) == 255);
    CHECK(part.at(1, 0, 0) == 0);
    CHECK_THROWS_WITH(crop(image, {0, 0, 0}, {9, 8, 8}), contains("from voxel 0 to 9 along x"));
    CHECK_THROWS_WITH(crop(image, {4, 4, 4}, {4, 8, 8}), contains("first must be below"));
}

TEST_CASE("Image: islands are found and left out") {
    const auto plate_and_two = [](const Point<3>& x) {
        return x[2] < 3 || (x - Point<3>(6.5, 6.5, 9.5)).norm() < 0.6 || (x - Point<3>(2.5, 2.5, 9.5)).norm() < 1.2;
    };
    const ImageBody body(image_of(12, plate_and_two), voxels());
    const Pieces pieces = pieces_of(body);
    REQUIRE(pieces.number.size() == 3);
    CHECK(pieces.number[static_cast<std::size_t>(pieces.largest)] == 432);
    CHECK(pieces_of(body, false).number.size() == 1);
    CHECK_FALSE(pieces.lead_through(body.image(), 2));
    CHECK(pieces.lead_through(body.image(), 0));
    const ImageBody mended = without_islands(body);
    CHECK(pieces_of(mended).number == std::vector<long long>{432});
    CHECK_FALSE(mended.contains({2.5e-4, 2.5e-4, 9.5e-4}));

    const ImageReport report = image_report(body, 1e-4);
    CHECK(report.pieces == 3);
    CHECK(report.islands == Approx(8.0 / 440)); // one voxel and one with its six neighbours
    CHECK_FALSE(report.sound);
    CHECK(says(report, "in 3 pieces"));
    CHECK(says(report, "without_islands()"));
    CHECK(report.pores_lead_through == std::array<bool, 3>{true, true, false});
    CHECK(says(report, "Pores lead through along x, y, none along z"));
    CHECK(says(report, "does not reach from side to side along z"));
    CHECK(image_report(mended, 1e-4).islands == 0);
}

TEST_CASE("Image: the widths of slots are found, and so is what is too narrow for the particles") {
    // Slots of 4 and 12 voxels between plates of 4.
    const ImageBody slots(
        image_of(28, [](const Point<3>& x) { return x[0] < 4 || (x[0] > 8 && x[0] < 12) || x[0] > 24; }), voxels());
    const auto widths = pore_widths(slots);
    CHECK(widths[0] == Approx(4e-4).margin(1.2e-4));
    CHECK(widths[2] == Approx(12e-4).margin(1.2e-4));
    const ImageReport report = image_report(slots, 2e-4);
    CHECK(report.porosity == Approx(16.0 / 28));
    CHECK(says(report, "of the pore space are narrower"));
    CHECK(says(image_report(slots, 0.5e-4), "finer than what was seen"));
    CHECK(says(image_report(slots, 3e-4), "too few"));
}

TEST_CASE("Image: a porosity that hangs on the threshold is said") {
    const ImageReport soft = image_report(ImageBody(grey_ball(16, 5), voxels()), 1e-4);
    CHECK(soft.porosity_lower < soft.porosity);
    CHECK(soft.porosity_higher > soft.porosity);
    CHECK(says(soft, "hang on the threshold"));
    const ImageReport sharp =
        image_report(ImageBody(image_of(16, [](const Point<3>& x) { return x[0] < 8; }), voxels()), 1e-4);
    CHECK(sharp.porosity_lower == sharp.porosity_higher);
    CHECK_FALSE(says(sharp, "hang on the threshold"));
}

TEST_CASE("Image: what cannot be a body is refused") {
    const GreyImage image = image_of(4, [](const Point<3>& x) { return x[0] < 2; });
    CHECK_THROWS_WITH(ImageBody(GreyImage{}, voxels()), contains("0 voxels long"));
    CHECK_THROWS_WITH(ImageBody(image, voxels(SolidIs::above, 300)),
                      contains("threshold = 300") && contains("0 and 255"));
    Voxels wrong = voxels();
    wrong.sides[1] = 0;
    CHECK_THROWS_WITH(ImageBody(image, wrong), contains("side of a voxel = 0 m"));
    GreyImage flat = image;
    flat.sides = {1, 1, 3};
    CHECK_THROWS_WITH(ImageBody(flat, voxels()), contains("1 x 1 x 3") && contains("ratio"));
    GreyImage broken = image;
    broken.values[7] = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH(ImageBody(broken, voxels()), contains("voxel 7"));
    broken.values.pop_back();
    CHECK_THROWS_WITH(ImageBody(broken, voxels()), contains("has 63 values"));
    CHECK_THROWS_WITH(image_report(ImageBody(image, voxels()), -1), contains("spacing = -1 m"));
}

} // namespace image_test
