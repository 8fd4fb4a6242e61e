// Rows of the gauntlet with other compositions than the rest: pairing, a free fall that is exact, and stress rates that
// turn with the matter.
#include "margins.hpp"
#include <cases/stability/coupled.hpp>
#include <cases/stability/crowd.hpp>

#include <imbibe/solid/hughes_winget.hpp>
#include <imbibe/solid/jaumann_stress.hpp>

using namespace gauntlet;

namespace {

namespace sph = imbibe;
constexpr double turning_step = 1e-4; // s; a hundred of them make a turn
constexpr double tangent = 0.03142626604335115; // of pi/100; std::tan is not constexpr

/// The velocity gradient of that rotation, half-way in a step.
struct Turning {
    using sets = sph::Fields<sph::velocity_gradient>;
    constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        auto L = sph::Tensor<T, 2>::zero();
        L(0, 1) = T(-2 * tangent / turning_step);
        L(1, 0) = T(2 * tangent / turning_step);
        return L;
    }
};
struct Exact : sph::Solid<Turning, sph::HughesWingetStress<sph::HalfWay>> {};
struct Jaumann : sph::Solid<Turning, sph::JaumannStress> {};

/// By which share of itself the stress of a solid has changed after so many turns.
template <class Body>
double stress_error(int turns) {
    sph::Solver<2, double, sph::SymplecticEuler, Body> scene({.support_radius = 1e-3, .threads = 1});
    const auto body = scene.add(stability::elastic<Body>(1e5, 0.3, 950), {{0, 0}}, 5e-4);
    auto stress = scene[body][sph::deviatoric_stress];
    stress.row(0) << 2e5, 7e4, -5e4;
    const auto start = stress.row(0).eval();
    for (int k = 0; k < 100 * turns; ++k)
        scene.step(turning_step);
    return (scene[body][sph::deviatoric_stress].row(0) - start).norm() / start.norm();
}

} // namespace

TEST_CASE("A stress rate that turns exactly keeps the stress through a thousand turns", "[stability]") { // row 14
    CHECK(stress_error<Exact>(1000) < 1e-3); // measured: round-off
    CHECK(stress_error<Jaumann>(1) > 0.1);   // the usual rate, after a single one
}

TEST_CASE("Fifty neighbours pair up with a cubic spline, and not with a Wendland kernel", "[stability]") { // row 2
    check_margin(stability::crowded<imbibe::WendlandC2>);
    const Outcome spline = stability::crowded<imbibe::CubicSpline>(Plan{.cfl = 0.4});
    INFO(words(spline));
    CHECK(!spline.stable);
}

TEST_CASE("In free fall nothing moves against anything else", "[stability]") { // row 21
    const Outcome paper = stability::free_fall<stability::PaperCoupling>({.cfl = 0.4});
    INFO(words(paper));
    CHECK(paper.stable);
    CHECK(paper.signs[0].worst < 1e-12);
    CHECK(paper.signs[1].worst < 1e-12);
}
