// One step of a scene with everything in it against loops over all pairs; and what such a scene must conserve.
#include "mix.hpp"

#include <catch_shim.hpp>
#include <scene_bits.hpp>

namespace sums_test {

namespace {

using namespace solver_test;

// The greatest difference between a field and what it should be, relative to the greatest value it should have.
template <class M, class Scene, class Handle, class Field, class Expected>
double difference(const M& mix, const Scene& scene, Handle handle, int phase, Field field, const Expected& expected) {
    const auto view = scene[handle];
    std::vector<const typename M::Particle*> by_id;
    for (const auto& p : mix.all)
        if (p.phase == phase)
            by_id.push_back(&p);
    double worst = 0, greatest = 0;
    REQUIRE(static_cast<std::size_t>(view.size()) == by_id.size());
    for (int i = 0; i < view.size(); ++i) {
        const auto& p = *by_id[view.ids()[static_cast<std::size_t>(i)]];
        const auto right = expected(p);
        const auto is = view[field].row(i).transpose().template cast<double>().eval();
        worst = std::max(worst, (is - right).cwiseAbs().maxCoeff());
        greatest = std::max(greatest, right.cwiseAbs().maxCoeff());
        REQUIRE(is.allFinite());
    }
    return worst / greatest;
}

using One = Eigen::Matrix<double, 1, 1>;

template <int dim_, class Real_>
struct Case {
    static constexpr int dim = dim_;
    using Real = Real_;
};

template <int dim, class Real>
void check_sums(int m, int sides, double supports, double tolerance) {
    Mix<dim, Real> mix(m, sides, supports);
    auto scene = mix.make(sides > 0);
    const sph::PhaseHandle<Water<dim>> water;
    const sph::PhaseHandle<Oil> oil;
    const sph::PhaseHandle<Rubber> rubber;
    const double dt = 1e-3;
    scene.step(dt);
    mix.step(dt);
    const auto rate = [](const auto& p) { return One(p.rate); };
    const auto rho = [](const auto& p) { return One(p.rho); };
    const auto a = [](const auto& p) { return p.a; };
    const auto v = [](const auto& p) { return p.v; };
    const auto x = [](const auto& p) { return p.x; };
    CHECK(difference(mix, scene, water, 0, sph::density_rate, rate) < tolerance);
    CHECK(difference(mix, scene, oil, 1, sph::density_rate, rate) < tolerance);
    CHECK(difference(mix, scene, water, 0, sph::density, rho) < tolerance);
    CHECK(difference(mix, scene, rubber, 2, sph::density, rho) < tolerance);
    CHECK(difference(mix, scene, water, 0, sph::smoothed_velocity, [](const auto& p) { return p.smooth; }) < tolerance);
    CHECK(difference(mix, scene, water, 0, sph::acceleration, a) < tolerance);
    CHECK(difference(mix, scene, oil, 1, sph::acceleration, a) < tolerance);
    CHECK(difference(mix, scene, rubber, 2, sph::acceleration, a) < tolerance);
    CHECK(difference(mix, scene, water, 0, sph::velocity, v) < tolerance);
    CHECK(difference(mix, scene, oil, 1, sph::velocity, v) < tolerance);
    CHECK(difference(mix, scene, rubber, 2, sph::velocity, v) < tolerance);
    CHECK(difference(mix, scene, water, 0, sph::position, x) < tolerance);
    CHECK(difference(mix, scene, oil, 1, sph::position, x) < tolerance);
    CHECK(difference(mix, scene, rubber, 2, sph::position, x) < tolerance);
}

} // namespace

// In float the greatest error is that of the pressure, made of density differences of 2 % of 1000 +- 6e-5.
TEMPLATE_TEST_CASE("Sums over neighbours are sums over all pairs", "[scene]", (Case<2, double>), (Case<3, double>),
                   (Case<3, float>)) {
    const double tolerance = sizeof(typename TestType::Real) == 4 ? 1e-4 : 1e-11;
    for (int sides : {0, 1, TestType::dim}) {
        CAPTURE(sides);
        check_sums<TestType::dim, typename TestType::Real>(TestType::dim == 2 ? 16 : 8, sides, 2.1, tolerance);
    }
}

TEST_CASE("Sums where every particle meets its own images", "[scene]") {
    check_sums<2, double>(5, 2, 4.1, 1e-11); // supports of 0.82 and 0.98 in a period of 1
}

namespace {

// Momentum, kg m/s.
template <int dim, class Scene>
Eigen::Matrix<double, dim, 1> momentum(const Scene& scene) {
    Eigen::Matrix<double, dim, 1> sum = Eigen::Matrix<double, dim, 1>::Zero();
    const auto add = [&](const auto& view) {
        sum +=
            (view[sph::velocity].transpose().template cast<double>() * view[sph::mass].template cast<double>()).eval();
    };
    add(scene.template get<Water<dim>>());
    add(scene.template get<Oil>());
    add(scene.template get<Rubber>());
    return sum;
}

} // namespace

TEST_CASE("The same bits with 1, 2 and 4 threads, and a second time", "[scene]") {
    std::vector<std::vector<unsigned char>> runs;
    for (int threads : {1, 2, 4, 1}) {
        Mix<3, double> mix(14, 1, 2.1, threads);
        auto scene = mix.make();
        CHECK(scene.threads() == threads);
        for (int k = 0; k < 50; ++k)
            scene.step(2e-4);
        runs.push_back(imbibe_test::bits_of(scene));
    }
    CHECK(runs[0].size() > 14 * 14 * 14 * 10 * sizeof(double));
    CHECK(runs[0] == runs[1]);
    CHECK(runs[0] == runs[2]);
    CHECK(runs[0] == runs[3]);
}

TEMPLATE_TEST_CASE("Momentum changes by the external impulse", "[scene]", (Case<2, double>), (Case<3, float>)) {
    constexpr int dim = TestType::dim;
    const double round_off = sizeof(typename TestType::Real) == 4 ? 1e-6 : 1e-14;
    for (int sides : {0, dim}) {
        CAPTURE(sides);
        Mix<dim, typename TestType::Real> mix(dim == 2 ? 16 : 8, sides, 2.1);
        auto scene = mix.make(sides > 0);
        double mass = 0;
        for (const auto& p : mix.all)
            mass += p.m;
        for (int k = 0; k < 20; ++k) {
            const auto before = momentum<dim>(scene);
            double flow = 0; // the sum of |m v|, and of all |m a| dt: what is rounded
            scene.step(5e-4);
            scene.engine().for_each_phase([&](auto, const auto& s) {
                flow += (s.view(sph::mass).template cast<double>().transpose() *
                         (s.view(sph::velocity).cwiseAbs() +
                          typename TestType::Real(5e-4) * s.view(sph::acceleration).cwiseAbs())
                             .template cast<double>())
                            .sum();
            });
            Eigen::Matrix<double, dim, 1> impulse = Eigen::Matrix<double, dim, 1>::Zero();
            impulse[dim - 1] = mass * 5e-4 * Mix<dim, double>::gravity;
            CHECK((momentum<dim>(scene) - before - impulse).norm() < round_off * flow);
        }
    }
}

TEST_CASE("Held particles stay where they are and carry the force away", "[scene]") {
    Mix<2, double> mix(16, 0, 2.1);
    auto scene = mix.make();
    const sph::PhaseHandle<Rubber> rubber;
    scene[rubber][sph::velocity].setZero();
    const int held = scene.hold(rubber, [](const auto& x) { return x[0] < 0; });
    CHECK(held > 10);
    CHECK(held < scene[rubber].size());
    CHECK((scene[rubber][sph::mobility].array() == 0).count() == held);
    std::vector<Eigen::Vector2d> start(static_cast<std::size_t>(scene[rubber].size()));
    for (int i = 0; i < scene[rubber].size(); ++i)
        start[scene[rubber].ids()[static_cast<std::size_t>(i)]] = scene[rubber][sph::position].row(i);
    double mass = 0;
    for (const auto& p : mix.all)
        mass += p.m;
    for (int k = 0; k < 10; ++k) {
        const auto before = momentum<2>(scene);
        scene.step(5e-4);
        Eigen::Vector2d impulse{0, mass * 5e-4 * mix.gravity};
        const auto view = scene[rubber];
        int moved = 0;
        for (int i = 0; i < view.size(); ++i) {
            const Eigen::Vector2d from = start[view.ids()[static_cast<std::size_t>(i)]];
            const Eigen::Vector2d to = view[sph::position].row(i);
            if (view[sph::mobility](i) == 0) {
                REQUIRE(to == from); // to the last bit
                REQUIRE(view[sph::velocity].row(i).norm() == 0);
                impulse -= 5e-4 * view[sph::mass](i) * view[sph::acceleration].row(i);
            } else {
                moved += to != from;
            }
        }
        CHECK(moved == view.size() - held);
        CHECK((momentum<2>(scene) - before - impulse).norm() < 1e-13 * mass);
    }
}

TEST_CASE("Particles are removed, the others stay as they were", "[scene]") {
    Mix<2, double> mix(16, 0, 2.1);
    auto scene = mix.make();
    const sph::PhaseHandle<Oil> oil;
    scene.step(1e-4);
    const auto before = scene[oil];
    std::vector<double> x(static_cast<std::size_t>(before.size()) + 1, -9), rho = x;
    int beyond = 0;
    for (int i = 0; i < before.size(); ++i) {
        x[before.ids()[static_cast<std::size_t>(i)]] = before[sph::position](i, 0);
        rho[before.ids()[static_cast<std::size_t>(i)]] = before[sph::density](i);
        beyond += before[sph::position](i, 0) > 0.1;
    }
    const int size = before.size();
    CHECK(scene.remove_if(oil, [](const auto&) { return false; }) == 0);
    CHECK(scene.remove_if(oil, [](const auto& at) { return at[0] > 0.1; }) == beyond);
    CHECK(beyond > 5);
    CHECK(scene[oil].size() == size - beyond);
    CHECK(scene[oil].ids().size() == static_cast<std::size_t>(size - beyond));
    for (int i = 0; i < scene[oil].size(); ++i) {
        const auto id = scene[oil].ids()[static_cast<std::size_t>(i)];
        CHECK(scene[oil][sph::position](i, 0) == x[id]);
        CHECK(scene[oil][sph::density](i) == rho[id]);
        CHECK(x[id] <= 0.1);
    }
    for (int k = 0; k < 20; ++k)
        scene.step(1e-4);
    CHECK(scene[oil][sph::position].allFinite());
    CHECK(scene[oil][sph::density].minCoeff() > 700);
    // All of them: the phase is empty, the others go on.
    CHECK(scene.remove_if(oil, [](const auto&) { return true; }) == size - beyond);
    CHECK(scene[oil].size() == 0);
    scene.step(1e-4);
    scene.step();
    CHECK(scene.template get<Water<2>>()[sph::acceleration].allFinite());
    // New ones get new numbers.
    scene.add(mix.oil, {Eigen::Vector2d(0, 0)}, 1.1 * mix.spacing);
    REQUIRE(scene[oil].size() == 1);
    CHECK(scene[oil].ids()[0] == static_cast<std::uint32_t>(size));
    scene.step(1e-4);
    CHECK(scene[oil][sph::acceleration].allFinite());
}

} // namespace sums_test
