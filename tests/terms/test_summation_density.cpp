// SummationDensity and SummationFloor: rho_0 on a lattice, more where it is compressed, nothing taken at a surface.
#include "cloud.hpp"

#include <imbibe/fluid/summation_density.hpp>

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
TEST_CASE("SummationFloor: its limit and its check") {
    const TimeStepInput in{3e-3, 1e-3, 1, 1, 3};
    CHECK(SummationFloor<K>::time_step_limit(water_here(), in, {.rate = 0.5}) == Approx(2e-3 / 15));
    CHECK_THROWS_AS(SummationFloorParameters{.rate = -1}.check("Water"), Error);
}

} // namespace summation_density_test
