// A thousand turns of a spinning plate: does its stress stay what it is? Row 14 of the gauntlet; stress rates, which
// have no stress-free configuration to go by, are turned in tests/terms/test_hughes_winget.cpp and, in a scene,
// test_gauntlet_exact.cpp.
#include <catch_shim.hpp>

#include <cases/stability/solids.hpp>

#include <Eigen/LU>

namespace {

// S = F^-1 P of every particle, Pa, which does not turn with the plate.
template <class View>
std::vector<Eigen::Matrix2d> second_piola_stresses(const View& plate) {
    std::vector<Eigen::Matrix2d> all;
    for (int i = 0; i < plate.size(); ++i) {
        Eigen::Matrix2d F, P;
        for (int k = 0; k < 4; ++k) {
            F(k / 2, k % 2) = plate[imbibe::deformation_gradient](i, k);
            P(k / 2, k % 2) = plate[imbibe::first_piola_stress](i, k);
        }
        all.push_back(F.inverse() * P);
    }
    return all;
}

} // namespace

TEST_CASE("A plate keeps its stress through a thousand turns", "[stability]") {
    using stability::Hookean;
    constexpr double spacing = 1e-2, side = 0.12;
    stability::SolidScene<Hookean, 2, double> scene({.support_radius = Hookean::support * spacing, .threads = 1});
    const auto body = stability::body_of<Hookean>(0.3);
    const double omega = 0.1 * std::sqrt(body.shear_modulus / body.density) / (side / 2);
    const auto plate = scene.add(
        body, imbibe::fill(imbibe::Box<2>{{-side / 2, -side / 2}, {side / 2, side / 2}}, spacing), spacing);
    const auto view = scene[plate];
    stability::spin(view, omega);
    const double start = stability::angular_momentum(view), turn = 2 * std::numbers::pi / omega;
    scene.run_until(50 * turn); // what it swings at the start has come to rest
    const auto settled = second_piola_stresses(view);
    double greatest = 0, mean = 0;
    for (const auto& S : settled) {
        greatest = std::max(greatest, S.cwiseAbs().maxCoeff());
        mean += S.trace() / 2 / static_cast<double>(settled.size());
    }
    // the mean of the stresses times the area is that of x . omega^2 x over the mass (virial theorem)
    CHECK(mean == Approx(body.density * omega * omega * side * side / 12).epsilon(0.02));

    scene.run_until(1000 * turn);
    const auto now = second_piola_stresses(view);
    double worst = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        worst = std::max(worst, (now[i] - settled[i]).cwiseAbs().maxCoeff());
    INFO("greatest change of a stress " << worst << " of " << greatest << " Pa, " << scene.steps() << " steps");
    CHECK(worst < 0.01 * greatest);
    CHECK(stability::angular_momentum(view) == Approx(start).epsilon(1e-6));
}
