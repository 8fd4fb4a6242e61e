// The same scene in another frame is the same scene: moved, boosted, turned, mirrored, relabelled; far away in float;
// and with a particle that is alone, far from the rest. Rows 15, 16 and 23 of the gauntlet.
#include <catch_shim.hpp>

#include "stability/coupled.hpp"

#include <algorithm>
#include <limits>

namespace {

using namespace stability;
using Eigen::Matrix2d, Eigen::MatrixXd, Eigen::RowVector2d;
using Fluid = SoundCoupling::Fluid;
constexpr int steps = 200;

/// A frame: x' = turn x + offset + boost t, particles added in another order.
struct Frame {
    Matrix2d turn = Matrix2d::Identity();
    RowVector2d offset = RowVector2d::Zero(), boost = RowVector2d::Zero();
    bool reversed = false;
    std::array<double, 2> origin{};
};

/// Drop and elastic block, not symmetric about anything, that meet with 1 m/s under gravity. Returns positions and
/// velocities, seen from the first frame.
template <class Real = double, class C = SoundCoupling>
MatrixXd meet(const Frame& frame) {
    using Of = typename C::Fluid;
    const RowVector2d down = RowVector2d(0.3 * g, -g) * frame.turn.transpose();
    CoupledScene<C, Real> scene({.gravity = {down[0], down[1]},
                                 .support_radius = Of::support * dx,
                                 .time_step = 4e-6,
                                 .origin = frame.origin,
                                 .threads = 1});
    C::set(scene.template coupling<typename C::Contact>(), stability::water_of<Of>(30));
    const auto placed = [&](double x, double y, double wide, double high) {
        std::vector<sph::Point<2>> points =
            sph::fill(sph::Box<2>{{x * dx, y * dx}, {(x + wide) * dx, (y + high) * dx}}, dx);
        for (auto& p : points)
            p = frame.turn * p + frame.offset.transpose();
        if (frame.reversed)
            std::reverse(points.begin(), points.end());
        return points;
    };
    const auto water = add_water<Of>(scene, placed(0.3, 1, 7, 6), 30);
    const auto block = add_body<C>(scene, placed(-2, -5, 9, 5), 1e6, 0.3, 950);
    const RowVector2d thrown = RowVector2d(0.4, -1) * frame.turn.transpose();
    auto w = scene[water];
    auto b = scene[block];
    for (int i = 0; i < w.size(); ++i)
        w[sph::velocity].row(i) = (thrown + frame.boost).template cast<Real>();
    for (int i = 0; i < b.size(); ++i)
        b[sph::velocity].row(i) = frame.boost.template cast<Real>();
    for (int k = 0; k < steps; ++k)
        scene.step();
    MatrixXd seen(w.size() + b.size(), 4);
    const auto put = [&](const auto& phase, int first) {
        const RowVector2d here =
            frame.offset + frame.boost * scene.time() - RowVector2d(frame.origin[0], frame.origin[1]);
        for (int i = 0; i < phase.size(); ++i) {
            int id = static_cast<int>(phase.ids()[static_cast<std::size_t>(i)]);
            if (frame.reversed)
                id = phase.size() - 1 - id;
            // turn^-1 = turn^T, and rows are transposed
            seen.block(first + id, 0, 1, 2) =
                (phase[sph::position].row(i).template cast<double>() - here) * frame.turn / dx;
            seen.block(first + id, 2, 1, 2) =
                (phase[sph::velocity].row(i).template cast<double>() - frame.boost) * frame.turn;
        }
    };
    put(w, 0);
    put(b, w.size());
    return seen; // positions in spacings, velocities in m/s, which is that of the impact
}
double difference(const MatrixXd& a, const MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff();
}
Matrix2d rows(double a, double b, double c, double d) {
    Matrix2d m;
    m << a, b, c, d;
    return m;
}

} // namespace

TEMPLATE_TEST_CASE("An impact is the same in every frame", "[stability]", SoundCoupling, PaperCoupling) { // row 23
    const auto seen = [](const Frame& frame) { return meet<double, TestType>(frame); };
    const MatrixXd home = seen({});
    REQUIRE(home.allFinite());
    REQUIRE(home.col(3).maxCoeff() - home.col(3).minCoeff() > 0.1); // something happens
    // Round-off times steps: an error of epsilon in an offset of a spacing is one of c dt/dx epsilon in the velocity of
    // sound a step, and 30 m/s are 30 of the units of `home`.
    const double round_off = std::numeric_limits<double>::epsilon() * steps * 30;
    const double far = 16 * dx; // the offset of coordinates that loses 4 bits
    CHECK(difference(seen({.turn = rows(0, -1, 1, 0)}), home) < round_off);
    CHECK(difference(seen({.turn = rows(-1, 0, 0, 1)}), home) < round_off);
    CHECK(difference(seen({.turn = rows(std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7))}), home) <
          10 * round_off);
    CHECK(difference(seen({.offset = {far, -far}}), home) < 16 * round_off);
    CHECK(difference(seen({.boost = {3, 2}}), home) < 16 * round_off);
    CHECK(difference(seen({.reversed = true}), home) < round_off);
}

TEMPLATE_TEST_CASE("In float, an impact far away is the impact at home", "[stability]", SoundCoupling,
                   PaperCoupling) { // row 15
    const auto seen = [](const Frame& frame) { return meet<float, TestType>(frame); };
    const double far = 1e4 * 12 * dx; // ten thousand times as far as the scene is high
    const MatrixXd home = seen({});
    REQUIRE(home.allFinite());
    const double with_origin = difference(seen({.offset = {far, -far}, .origin = {far, -far}}), home);
    const double without = difference(seen({.offset = {far, -far}}), home);
    CAPTURE(with_origin, without);
    CHECK(with_origin < 1e-3);
    CHECK(without > 1e-3); // what the origin is for
}

TEST_CASE("A particle far from all others changes nothing and flies freely", "[stability]") { // row 16
    const auto run = [](bool lonely) {
        auto scene = coupled_scene<SoundCoupling, double>(30);
        auto points = sph::fill(sph::Box<2>{{0, 0}, {5 * dx, 5 * dx}}, dx);
        if (lonely)
            points.push_back({1e6 * dx, 3e5 * dx});
        const auto water = add_water<Fluid>(scene, points, 30);
        auto view = scene[water];
        for (int i = 0; i < view.size(); ++i)
            if (view[sph::position](i, 0) < 10 * dx)
                view[sph::density](i) = 1020; // so that something happens
        for (int k = 0; k < 30; ++k)
            scene.step(5e-6);
        MatrixXd seen(26, 4);
        seen.setZero();
        for (int i = 0; i < view.size(); ++i) {
            const auto id = static_cast<Eigen::Index>(view.ids()[static_cast<std::size_t>(i)]);
            seen.block(id, 0, 1, 2) = view[sph::position].row(i) / dx;
            seen.block(id, 2, 1, 2) = view[sph::velocity].row(i);
        }
        return seen;
    };
    const MatrixXd alone = run(false), with = run(true);
    CHECK(difference(alone.topRows(25), with.topRows(25)) < 1e-12);
    CHECK(alone.topRows(25).rightCols(2).cwiseAbs().maxCoeff() > 0.1);
    CHECK(with(25, 0) == 1e6);
    CHECK(with(25, 2) == 0);
    CHECK(with(25, 3) == Approx(-g * 30 * 5e-6).epsilon(1e-12));
}

TEST_CASE("No particles are refused, and one of each phase flies freely", "[stability]") { // row 16
    auto scene = coupled_scene<SoundCoupling, double>(30);
    CHECK_THROWS_WITH(scene.step(1e-5), imbibe_test::contains("no particles"));
    const auto water = add_water<Fluid>(scene, std::vector<sph::Point<2>>{{0, 0}}, 30);
    const auto body = add_body<SoundCoupling>(scene, std::vector<sph::Point<2>>{{1, 2}}, 1e6, 0.3, 950);
    scene[water][sph::velocity].row(0) << 3, 1;
    constexpr int taken = 50;
    constexpr double dt = 1e-5;
    for (int k = 0; k < taken; ++k)
        scene.step(dt);
    const auto check = [](const auto& phase, const RowVector2d& start, const RowVector2d& thrown) {
        const RowVector2d down(0, -g);
        CHECK((phase[sph::velocity].row(0) - (thrown + taken * dt * down)).norm() < 1e-13);
        CHECK((phase[sph::position].row(0) - (start + taken * dt * (thrown + 0.5 * (taken + 1) * dt * down))).norm() <
              1e-13);
    };
    check(scene[water], {0, 0}, {3, 1});
    check(scene[body], {1, 2}, {0, 0});
}
