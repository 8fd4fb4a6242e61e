// SummationDensity, SummationFloor and SummationRelaxation: rho_0 on a lattice, more where it is compressed, nothing
// taken at a surface, and how fast a density comes back to its sum.
#include "cloud.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/summation_relaxation.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace summation_density_test {

using namespace cloud;

namespace {

using K = WendlandC2;

Water water_here() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}

template <int dim>
void sum_up(Cloud<dim, Water>& fluid) {
    gather(SummationNeighbours<K>{}, kernel_sum, fluid, fluid);
    prepare(LatticeSum<K>{}, lattice_kernel_sum, fluid);
}

template <int dim>
void check_summation() {
    auto fluid = block<dim>(water_here(), 7, 0);
    sum_up<dim>(fluid);
    const auto& centre = fluid[fluid.size() / 2];
    CHECK(plain(SummationDensity<K>::Set{}(centre)) == Approx(1000).epsilon(1e-13));
    CHECK(plain(SummationDensity<K>::Set{}(fluid.front())) < 600);
    // two per cent closer together: 1/0.98^dim as dense, to the accuracy of the sum
    for (auto& p : fluid)
        p.set(position, 0.98 * p[position]);
    sum_up<dim>(fluid);
    CHECK(plain(SummationDensity<K>::Set{}(fluid[fluid.size() / 2])) ==
          Approx(1000 / std::pow(0.98, dim)).epsilon(0.005));
    const SummationFloor<K>::Raise raise{};
    for (auto& p : fluid) {
        const double lack = std::max(plain(SummationDensity<K>::Set{}(p)) - 1000, 0.0);
        CHECK(plain(raise(p)) == Approx(0.1 * 30 / 1e-3 * lack).epsilon(1e-9).margin(1e-6));
    }
    CHECK(plain(raise(fluid.front())) == 0);
    CHECK(plain(raise(fluid[fluid.size() / 2])) > 0);
}

} // namespace

TEST_CASE("the density by summation is that of the lattice, and follows a compression") {
    check_summation<2>();
    check_summation<3>();
}
TEST_CASE("what counts in the sum is the volume of a neighbour, by its own density at rest") {
    const auto a = block<3>(water_here(), 1, 0).front();
    Water light = water_here();
    light.density = 400;
    const auto at = [](const Water& of) { return block<3>(of, 1, 0, 1, ColumnVector<3>::Unit(0) * 1e-3); };
    const double expected = 1e-9 * 21 / (2 * pi * 27e-9) * std::pow(2.0 / 3, 4) * (1 + 4.0 / 3); // V W
    CHECK(plain(sum(SummationNeighbours<K>{}, a, at(water_here()))) == Approx(expected));
    CHECK(plain(sum(SummationNeighbours<K>{}, a, at(light))) == Approx(expected));
}
TEST_CASE("SummationFloor: its limit and its check") {
    const TimeStepInput in{3e-3, 1e-3, 1, 1, 3};
    CHECK(SummationFloor<K>::time_step_limit(water_here(), in, {.rate = 0.5}) == Approx(2e-3 / 15));
    CHECK_THROWS_AS(SummationFloorParameters{.rate = -1}.check("Water"), Error);
}

struct Resting : Fluid<LinearState, VolumeContinuity<K>, VolumePressure<K>, SummationRelaxation<K>> {};

TEST_CASE("SummationRelaxation leads the density to the sum over places, exponentially") {
    const double spacing = 1e-3, time = 0.05;
    Solver<2, double, SymplecticEuler, Resting> scene(
        {.support_radius = 3e-3, .time_step = 1e-4, .periodic_length = {16e-3, 16e-3}});
    Resting water{{.density = 1000, .sound_speed = 1}};
    water.set(SummationRelaxationParameters{.time = time});
    const auto phase = scene.add(water, fill(Box<2>{{0, 0}, {16e-3, 16e-3}}, spacing), spacing);
    scene[phase][density].setConstant(1050); // everywhere: no pressure gradient, nothing moves
    scene.run_until(2 * time);
    const auto left = scene[phase][density].array() - 1000; // a lattice: its sum is rho_0
    CHECK(left.maxCoeff() == Approx(50 * std::exp(-2.0)).epsilon(0.003));
    CHECK(left.minCoeff() == Approx(left.maxCoeff()).epsilon(1e-9));
    CHECK(scene[phase][velocity].cwiseAbs().maxCoeff() < 1e-9);
}
TEST_CASE("SummationRelaxation: its limit and its check") {
    const TimeStepInput in{3e-3, 1e-3, 1, 1, 3};
    CHECK(SummationRelaxation<K>::time_step_limit(water_here(), in, {.time = 0.5}) == 1);
    CHECK_THROWS_AS(SummationRelaxationParameters{}.check("Water"), Error); // it must be given
    CHECK_THROWS_AS(SummationRelaxationParameters{.time = 0}.check("Water"), Error);
}

} // namespace summation_density_test
