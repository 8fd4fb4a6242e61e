// The surface tension of one liquid: that of a plane film, pressure, energy and momentum of drops, and what is refused.
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/interface/liquid_pressure.hpp>
#include <imbibe/interface/settle_surface.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cohesion_test {

using namespace imbibe;
using K = WendlandC6;
using Preset = presets::WettingLiquid;

struct Water : Fluid<CohesiveFluid, MorrisViscosity<K>, LiquidPressure> {};
struct Inviscid : Fluid<CohesiveFluid> {};
constexpr double sigma = 2, strength = sigma / 0.0955; // kappa at a spacing of 1

/// Positions and p/rho^2 of all particles, at a spacing and a density of 1.
struct Places {
    explicit Places(const auto& view)
        : x(view[position].template cast<double>()), p(view[pressure_over_density2].template cast<double>()) {}
    Eigen::MatrixXd x;
    Eigen::VectorXd p;

    /// The force between two particles, N/m; positive where they repel each other.
    double force(Eigen::Index i, Eigen::Index j, double distance) const {
        const double narrow = distance < 5 ? kernel_derivative<K, 2>(distance, 5) : 0;
        return strength * kernel_derivative<K, 2>(distance, 6.25) - (p[i] + p[j]) * narrow;
    }
};

TEST_CASE("A plane film has the surface tension that was asked for", "[cohesion]") {
    constexpr double width = 24, thick = 28;
    Solver<2, double, SymplecticEuler, Water> scene(
        {.support_radius = 5, .max_time_step = 1, .periodic_length = {width, 0}, .threads = 1});
    Water water{{.density = 1, .sound_speed = 10, .viscosity = 0.3}};
    water.set(CohesionParameters{.surface_tension = sigma});
    scene.add(water, jitter<2>(fill(Box<2>({0, 0}, {width, thick}), 1), 0.1, 1), 1);
    settle_surface<Water>(scene);
    double mean = 0;
    constexpr int times = 20;
    for (int time = 0; time < times; ++time) {
        scene.run_until(scene.time() + 1);
        const Places places(scene.get<Water>());
        double across_less_along = 0;
        for (Eigen::Index i = 0; i < places.x.rows(); ++i)
            for (Eigen::Index j = 0; j < i; ++j) {
                Eigen::Vector2d x = (places.x.row(i) - places.x.row(j)).transpose();
                x[0] -= width * std::round(x[0] / width);
                const double r = x.norm();
                if (r < 6.25)
                    across_less_along += places.force(i, j, r) * (sq(x[1]) - sq(x[0])) / r;
            }
        mean += across_less_along / (2 * width) / times; // two surfaces
    }
    CHECK_THAT(mean, Catch::WithinRel(sigma, 0.02));
}

/// A disc of so many spacings.
auto disc(auto liquid, double radius, double tension, double cfl = 0.75) {
    using Liquid = decltype(liquid);
    Solver<2, double, SymplecticEuler, Liquid> scene(
        {.support_radius = 5, .cfl = cfl, .max_time_step = 1, .threads = 1});
    liquid.set(CohesionParameters{.surface_tension = tension});
    std::vector<Eigen::Vector2d> points;
    for (const auto& x : fill(Box<2>({-20, -20}, {20, 20}), 1))
        if (x.norm() < radius)
            points.push_back(x);
    scene.add(liquid, points, 1);
    return scene;
}

TEST_CASE("The pressure in a drop is sigma/R over that outside", "[cohesion]") {
    auto scene = disc(Water{{.density = 1, .sound_speed = 10, .viscosity = 0.3}}, 16, sigma);
    settle_surface<Water>(scene);
    double sum = 0;
    int count = 0;
    scene.run_until(scene.time() + 20, [&](const auto& s) {
        const auto view = s.template get<Water>();
        const Eigen::ArrayXd inside = (view[position].rowwise().norm().array() < 7).template cast<double>();
        sum += (inside * view[liquid_pressure].array()).sum();
        count += static_cast<int>(inside.sum());
    });
    const double R = std::sqrt(static_cast<double>(scene.get<Water>().size()) / std::numbers::pi);
    CHECK_THAT(sum / count, Catch::WithinRel(sigma / R, 0.05));
    CHECK(scene.get<Water>()[velocity].rowwise().norm().maxCoeff() < 0.05 * std::sqrt(sigma / R));
}

/// Motion, compression and cohesion, J/m.
double energy(const auto& scene) {
    const auto view = scene.template get<Inviscid>();
    const Places places(view);
    const auto& material = view.material();
    const double inner = 0.5 * strength, c2 = sq(material.sound_speed);
    double all = 0;
    for (int i = 0; i < view.size(); ++i) {
        const double density_i = view[density](i);
        // the integral of p/rho^2
        all += 0.5 * view[velocity].row(i).squaredNorm() + inner * power<3>(density_i) / 3;
        if (density_i > 1)
            all += c2 * (std::log(density_i) + 1 / density_i - 1);
        for (int j = 0; j < i; ++j) {
            const double r = (places.x.row(i) - places.x.row(j)).norm();
            if (r < 6.25)
                all -= strength * kernel_value<K, 2>(r, 6.25);
        }
    }
    return all;
}

TEST_CASE("Motion, compression and cohesion together keep their energy", "[cohesion]") {
    auto scene = disc(Inviscid{{.density = 1, .sound_speed = 10}}, 8, sigma, 0.05);
    scene.run_until(0.01);
    const double before = energy(scene);
    scene.run_until(10);
    const double moving = 0.5 * scene.get<Inviscid>()[velocity].squaredNorm();
    CAPTURE(before, moving);
    CHECK(moving > 5); // the lattice's surface has released energy
    CHECK_THAT(energy(scene) - before, Catch::WithinAbs(0, 0.01 * moving));
}

TEST_CASE("A drop bends a free block, and both together keep their momentum", "[cohesion]") {
    Preset::ElasticScene<2, double> scene({.support_radius = 5, .max_time_step = 1, .threads = 1});
    std::vector<Eigen::Vector2d> drop;
    for (const auto& x : fill(Box<2>({-8, 0}, {8, 8}), 1))
        if (x.norm() < 8)
            drop.push_back(x);
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = 0.3}}, drop, 1);
    scene.add(Preset::elastic(200, 0.3, 0.8, 1), fill(Box<2>({-12, -8}, {12, 0}), 1), 1);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.3}}, fill(Box<2>({-12, -60}, {12, -50}), 1), 1);
    Preset::set_coefficients(scene, {.surface_tension = sigma, .contact_angle = 1.5});
    // How much lower the block's top is in its middle than at its ends.
    const auto dent = [&] {
        const auto block = scene.get<Preset::Sponge>();
        double middle = 0, ends = 0;
        for (int i = 0; i < block.size(); ++i)
            if (block[reference_position](i, 1) > -1) {
                const double x = std::abs(block[reference_position](i, 0));
                (x < 2 ? middle : ends) += x < 2 || x > 10 ? block[position](i, 1) / 4 : 0;
            }
        return ends - middle;
    };
    double bent = 0;
    scene.run_until(10, [&](const auto&) { bent = std::max(bent, dent()); });
    CHECK(bent > 0.05);
    const auto water = scene.get<Preset::Water>();
    const auto block = scene.get<Preset::Sponge>();
    const auto momentum = [](const auto& view) {
        return (view[mass].asDiagonal() * view[velocity]).colwise().sum().eval();
    };
    const double size = water[velocity].norm() + block[velocity].norm();
    CAPTURE(momentum(water), momentum(block));
    CHECK(size > 0.1);
    CHECK((momentum(water) + momentum(block)).norm() < 1e-12 * size);
}

TEST_CASE("A wall gives no energy to an inviscid pool under a high pressure", "[cohesion]") {
    struct Pool : Fluid<CohesiveFluid> {};
    struct Vessel : Wall<> {};
    struct Sides : CouplingOf<Pool, Vessel> {};
    constexpr double gravity = 2, wide = 16, deep = 16; // rho g h of 32, 3 kappa/2 of a surface tension of 1
    Solver<2, double, SymplecticEuler, Pool, Vessel, Sides> scene({.gravity = {0, -gravity},
                                                                   .support_radius = 5,
                                                                   .max_time_step = 1,
                                                                   .periodic_length = {wide, 0},
                                                                   .threads = 1});
    Pool pool{{.density = 1, .sound_speed = 80}};
    pool.set(CohesionParameters{.surface_tension = 1});
    scene.add(pool, fill(Box<2>({0, 0}, {wide, deep}), 1), 1);
    scene.add(Vessel{{.density = 1}}, fill(Box<2>({0, -7}, {wide, 0}), 1), 1);
    settle_surface<Pool>(scene);
    // The lattice falls into another order, which frees some energy. From then on all of it stays.
    const auto moving_until = [&](double end) {
        double sum = 0;
        int times = 0;
        const double begin = scene.time();
        scene.run_until(end, [&](const auto& s) {
            if (s.time() > begin + 0.5 * (end - begin)) {
                sum += s.template get<Pool>()[velocity].squaredNorm();
                ++times;
            }
        });
        return sum / times;
    };
    const double before = moving_until(120), after = moving_until(200),
                 lowest = scene.get<Pool>()[position].col(1).minCoeff();
    CAPTURE(before, after, lowest);
    CHECK(after < 1.15 * before);
    CHECK(lowest > -0.5);
}

TEST_CASE("A surface tension that is changed during a run acts", "[cohesion]") {
    auto scene = disc(Water{{.density = 1, .sound_speed = 10, .viscosity = 0.3}}, 12, sigma);
    settle_surface<Water>(scene);
    scene.get<Water>().material().set(CohesionParameters{.surface_tension = 2 * sigma});
    scene.step();
    CHECK_THAT(scene.get<Water>()[cohesion_strength](0), Catch::WithinRel(2 * strength, 1e-12));
}

TEST_CASE("The pull of a wall follows from the contact angle", "[cohesion]") {
    const auto share = [](double degrees) {
        return Adhesion::prepare(Preset::Water{{.spacing = 1}}, Preset::Vessel{{.spacing = 1}}, Lattice<2>{1, 5},
                                 AdhesionParameters{.contact_angle = degrees * std::numbers::pi / 180})
            .share;
    };
    for (double degrees = 30; degrees < 150; degrees += 1) {
        CHECK(share(degrees) > share(degrees + 1));
        CHECK(share(degrees) < share(degrees + 1) + 0.02);
    }
    CHECK(share(150) > 0);
    CHECK_THROWS_WITH(Adhesion::prepare(Preset::Water{{.spacing = 1}}, Preset::Vessel{{.spacing = 1.5}},
                                        Lattice<2>{1, 5}, AdhesionParameters{}),
                      imbibe_test::contains("Adhesion: a wall or solid with a spacing of 1.5 m"));
}

TEST_CASE("What the constants of cohesion do not hold for is refused", "[cohesion]") {
    Solver<2, double, SymplecticEuler, Inviscid> scene({.support_radius = 3, .max_time_step = 1, .threads = 1});
    Inviscid water{{.density = 1, .sound_speed = 10}};
    water.set(CohesionParameters{.surface_tension = sigma});
    scene.add(water, fill(Box<2>({0, 0}, {8, 8}), 1), 1);
    CHECK_THROWS_WITH(scene.step(), imbibe_test::contains("a support radius of 3 spacings beside Cohesion"));
    struct Bare : Fluid<CohesivePressure, SummationDensity<K>, SymmetricPressure<K>> {};
    Solver<2, double, SymplecticEuler, Bare> bare({.support_radius = 5, .max_time_step = 1, .threads = 1});
    bare.add(Bare{{.density = 1, .sound_speed = 10}}, fill(Box<2>({0, 0}, {8, 8}), 1), 1);
    CHECK_THROWS_WITH(bare.step(), imbibe_test::contains("list the method CohesiveFluid"));
    struct Floor : Wall<> {};
    struct Half : Coupling<Inviscid, Floor, Adhesion> {};
    Solver<2, double, SymplecticEuler, Inviscid, Floor, Half> half(
        {.support_radius = 5, .max_time_step = 1, .threads = 1});
    half.add(water, fill(Box<2>({0, 0}, {8, 8}), 1), 1);
    half.add(Floor{{.density = 1}}, fill(Box<2>({0, -7}, {8, 0}), 1), 1);
    CHECK_THROWS_WITH(half.step(), imbibe_test::contains("CouplingOf a fluid with the method CohesiveFluid"));
    CHECK_THROWS_WITH(CohesionParameters{.surface_tension = -1}.check("Water"),
                      imbibe_test::contains("surface_tension = -1 N/m"));
    CHECK_THROWS_WITH(AdhesionParameters{.contact_angle = 60}.check("Sides"),
                      imbibe_test::contains("contact_angle = 60 rad"));
}

TEST_CASE("Without surface tension there is nothing to settle", "[cohesion]") {
    auto scene = disc(Inviscid{{.density = 1, .sound_speed = 10}}, 6, 0);
    CHECK(settle_surface<Inviscid>(scene) == 0);
    CHECK(scene.steps() == 0);
}

} // namespace cohesion_test
