// Total-Lagrangian bodies are not wrapped when they cross a periodic side; what is around them must not notice.
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <type_traits>
#include <vector>

namespace bodies_across_sides_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<> {};
struct Body : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                         sph::TotalLagrangianForce<K>> {};

/// How much of the other phase is near, kg.
struct Company : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "company", unit = "kg";
};
inline constexpr Company company{};
/// By how much the difference of two positions is not the offset of the pair, weighed with the kernel in 2D, 1.
struct Misfit : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "misfit", unit = "1";
};
inline constexpr Misfit misfit{};

struct Near {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<company>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const { return b[sph::mass] * ab.value(K{}); }
};
struct Compare {
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<misfit>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return squared_norm(a[sph::position] - b[sph::position] - ab.offset) * ab.value(K{});
    }
};
struct Look : sph::Coupling<Water, Body, Near> {};
struct LookTwice : sph::Coupling<Water, Body, Near, Compare> {};

/// Water and a body in it drift through a periodic box as one: what each sees of the other stays what it was.
template <class Integrator, class Coupling>
void check_drift(int interval, double skin) {
    constexpr double dx = 0.05;
    sph::Solver<2, double, Integrator, Water, Body, Coupling> scene({.support_radius = 2.6 * dx,
                                                                     .periodic_length = {1, 1},
                                                                     .search_interval = interval,
                                                                     .search_skin = skin,
                                                                     .threads = 1});
    const sph::Box<2> all({0, 0}, {1, 1}), inner({0.7, 0.3}, {0.95, 0.7});
    std::vector<sph::Point<2>> around, inside;
    for (const auto& x : sph::fill(all, dx))
        (inner.contains(x) ? inside : around).push_back(x);
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 10}}, around, dx);
    const auto body = scene.add(Body{{.density = 1000, .sound_speed = 10, .shear_modulus = 3e4}}, inside, dx);
    scene[water][sph::velocity].rowwise() = Eigen::RowVector2d(1, -0.5);
    scene[body][sph::velocity].rowwise() = Eigen::RowVector2d(1, -0.5);
    double seen_first = 0;
    for (int k = 0; k < 700; ++k) { // the body leaves on the right, then below
        scene.step(1e-3);
        const double of_water = scene[body][company].sum(), of_body = scene[water][company].sum();
        if (k == 0)
            seen_first = of_water;
        REQUIRE(of_water == Approx(seen_first).epsilon(1e-9));
        REQUIRE(of_body == Approx(seen_first).epsilon(1e-9));
        if constexpr (std::is_same_v<Coupling, LookTwice>) {
            REQUIRE(scene[body][misfit].sum() < 1e-20);
            REQUIRE(scene[water][misfit].sum() < 1e-20);
        }
    }
    CHECK(seen_first > 0);
    CHECK(scene[body][sph::position].col(0).minCoeff() > 1.3); // it was not wrapped
}

TEST_CASE("A body that leaves a periodic box keeps its neighbours, whatever the integrator", "[bodies]") {
    check_drift<sph::SymplecticEuler, Look>(1, 0);
    check_drift<sph::SymplecticEuler, Look>(100, 0.1);
    check_drift<sph::StaggeredLeapfrog, Look>(1, 0);
    check_drift<sph::StaggeredLeapfrog, Look>(100, 0.1);
    check_drift<sph::MidpointRungeKutta, Look>(1, 0);
    check_drift<sph::PredictorCorrector, Look>(1, 0);
}

TEST_CASE("Positions that a term reads fit the offsets, on either side of a body that left the box", "[bodies]") {
    check_drift<sph::SymplecticEuler, LookTwice>(1, 0);
    check_drift<sph::SymplecticEuler, LookTwice>(100, 0.1);
}

} // namespace bodies_across_sides_test
