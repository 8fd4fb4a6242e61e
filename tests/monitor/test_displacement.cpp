// How far particles have moved, of a phase and of a part of it.
#include "scenes.hpp"

#include <catch_shim.hpp>

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/monitor/displacement.hpp>

namespace displacement_test {

namespace sph = imbibe;
using monitor_test::Dust;
using Scene = monitor_test::DustScene<2>;
using Block = monitor_test::Block<sph::StVenantKirchhoff>;

TEST_CASE("A probe measures from where particles were, whole phases and parts", "[displacement]") {
    Scene scene({.support_radius = 0.2, .time_step = 0.1});
    const auto dust =
        scene.add(Dust{{.density = 1, .sound_speed = 1}}, sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, 0.1), 0.1);
    for (int i = 0; i < 100; ++i) // the upper half to the right, the lower half up and twice as fast
        scene[dust][sph::velocity].row(i) << (scene[dust][sph::position](i, 1) > 0.5 ? 1 : 0),
            (scene[dust][sph::position](i, 1) > 0.5 ? 0 : 2);
    const sph::DisplacementProbe<2> probe(scene[dust]);
    scene.run_until(0.3); // particles are sorted on the way
    CHECK(probe.mean(scene[dust]) == Approx(0.45));
    CHECK(probe.greatest(scene[dust]) == Approx(0.6));
    CHECK(probe.mean_vector(scene[dust])[0] == Approx(0.15));
    CHECK(probe.mean_vector(scene[dust])[1] == Approx(0.3));
    const auto upper = probe.mean_vector(scene[dust], [](const auto& x) { return x[1] > 0.5; });
    CHECK(upper[0] == Approx(0.3));
    CHECK(std::abs(upper[1]) < 1e-12);
    REQUIRE_THROWS_WITH(probe.mean_vector(scene[dust], [](const auto& x) { return x[1] > 5; }),
                        imbibe_test::contains("no particle started"));
    scene.remove_if(dust, [](const auto& x) { return x[0] < 0.1; });
    REQUIRE_THROWS_WITH(probe.mean(scene[dust]), imbibe_test::contains("measured from 100 particles"));
    REQUIRE_THROWS_WITH(sph::DisplacementProbe<2>(scene[dust]), imbibe_test::contains("particles were removed"));

    Scene other({.support_radius = 0.2, .time_step = 0.1});
    const Dust grains{{.density = 1, .sound_speed = 1}};
    other.add(grains, {{0, 0}, {1, 0}, {2, 0}}, 0.1);
    const sph::DisplacementProbe<2> of_three(other[dust]);
    other.remove_if(dust, [](const auto& x) { return x[0] == 1; });
    other.add(grains, {{3, 0}}, 0.1);
    REQUIRE_THROWS_WITH(of_three.mean(other[dust]), imbibe_test::contains("particle 3 was not there"));
}

TEST_CASE("A probe that knows the period measures across a periodic side", "[displacement]") {
    Scene scene({.support_radius = 0.2, .time_step = 0.01, .periodic_length = {1, 0}});
    const auto dust =
        scene.add(Dust{{.density = 1, .sound_speed = 1}}, sph::fill(sph::Box<2>{{0.7, 0}, {1, 2}}, 0.1), 0.1);
    scene[dust][sph::velocity].col(0).setConstant(1);
    scene[dust][sph::velocity].col(1).setConstant(-6);
    const sph::DisplacementProbe<2> probe(scene[dust], scene.settings());
    scene.run_until(0.2);
    REQUIRE(scene[dust][sph::position].col(0).minCoeff() < 0.2); // some have come back on the other side
    CHECK(probe.greatest(scene[dust]) == Approx(std::hypot(0.2, 1.2)));
    CHECK(probe.mean_vector(scene[dust])[0] == Approx(0.2));
    CHECK(probe.mean_vector(scene[dust])[1] == Approx(-1.2));
}

TEST_CASE("A probe takes the places of a total-Lagrangian solid as they are", "[displacement]") {
    monitor_test::BlockScene<2, sph::StVenantKirchhoff> scene(
        {.support_radius = 0.25, .time_step = 0.01, .periodic_length = {1, 0}});
    const auto block = scene.add(Block{{.density = 1, .sound_speed = 1, .shear_modulus = 0.1}},
                                 sph::fill(sph::Box<2>{{0.7, 0}, {1, 0.3}}, 0.1), 0.1);
    scene[block][sph::velocity].col(0).setConstant(1);
    const sph::DisplacementProbe<2> probe(scene[block], scene.settings());
    scene.run_until(0.7); // more than half a period
    CHECK(probe.mean_vector(scene[block])[0] == Approx(0.7));
}

} // namespace displacement_test
