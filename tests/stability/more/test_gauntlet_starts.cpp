// Particles that start too near each other, and the distance of two phases' nearest particles, on which a limit
// depends. Row 11 of the gauntlet.
#include "margins.hpp"
#include <cases/stability/starts.hpp>

using namespace gauntlet;

TEST_CASE("Particles that coincide are refused, those that nearly do come apart slowly", "[stability]") { // row 11
    auto scene = stability::fluid_scene<stability::WeaklyCompressible, double>(0, 30);
    const double close = 0.9e-3 * stability::dx;
    CHECK_THROWS_WITH((stability::add_water<stability::WeaklyCompressible>(scene, {{0, 0}, {close, 0}}, 30)),
                      imbibe_test::contains("Water") && imbibe_test::contains("coincide"));
    check_preset(stability::columns_in_pairs<stability::WeaklyCompressible>, 0.01);
    check_margin(stability::columns_in_pairs<stability::Riemann>, 0.01);
    check_preset(stability::water_in_solid<stability::SoundCoupling>, 2.5);
}

TEST_CASE("The distance of the nearest pair of two phases is what a limit is given", "[stability]") {
    using C = stability::SoundCoupling;
    using stability::dx;
    auto scene = stability::coupled_scene<C, double>(30);
    const auto block =
        stability::add_body<C>(scene, imbibe::fill(imbibe::Box<2>{{0, -4 * dx}, {8 * dx, 0}}, dx), 1e6, 0.3, 950);
    const auto water =
        stability::add_water<C::Fluid>(scene, imbibe::fill(imbibe::Box<2>{{2.2 * dx, 0}, {6.2 * dx, 4 * dx}}, dx), 30);
    scene[water][imbibe::velocity].col(1).setConstant(-1);
    for (int k = 0; k < 20; ++k) {
        const Eigen::MatrixXd a = scene[water][imbibe::position], b = scene[block][imbibe::position];
        double nearest = 1;
        for (Eigen::Index i = 0; i < a.rows(); ++i)
            nearest = std::min(nearest, (b.rowwise() - a.row(i)).rowwise().norm().minCoeff());
        scene.step();
        CHECK(scene.engine().nearest_of<C::Contact>() == Approx(nearest).epsilon(1e-12));
    }
    scene[water][imbibe::position].col(1).array() += 20 * dx;
    scene.step();
    CHECK(std::isinf(scene.engine().nearest_of<C::Contact>()));
}
