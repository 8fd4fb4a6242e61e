// The same scene in another frame is the same scene: moved, boosted, turned, mirrored, relabelled; far away in float;
// and with a particle that is alone, far from the rest. Rows 15, 16 and 23 of the gauntlet.
#include <catch_shim.hpp>

#include <cases/stability/frames.hpp>

namespace {

using namespace stability;
using Eigen::MatrixXd, Eigen::RowVector2d;
using Fluid = SoundCoupling::Fluid;

} // namespace

TEMPLATE_TEST_CASE("An impact is the same in every frame", "[stability]", SoundCoupling, PaperCoupling) { // row 23
    const auto seen = [](const Frame& frame) { return meet<double, TestType>(frame); };
    const MatrixXd home = seen({});
    REQUIRE(home.allFinite());
    REQUIRE(home.col(3).maxCoeff() - home.col(3).minCoeff() > 0.1); // something happens
    for (const NamedFrame& it : frames()) {
        CAPTURE(it.name);
        CHECK(difference(seen(it.frame), home) < it.tolerance * round_off);
    }
}

TEMPLATE_TEST_CASE("In float, an impact far away is the impact at home", "[stability]", SoundCoupling,
                   PaperCoupling) { // row 15
    const auto seen = [](const Frame& frame) { return meet<float, TestType>(frame); };
    const MatrixXd home = seen({});
    REQUIRE(home.allFinite());
    const double with_origin =
        difference(seen({.offset = {far_away, -far_away}, .origin = {far_away, -far_away}}), home);
    const double without = difference(seen({.offset = {far_away, -far_away}}), home);
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
