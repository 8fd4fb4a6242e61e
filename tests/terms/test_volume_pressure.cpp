// VolumePressure, DensityDiffusion and DensityFloor: balance of forces and of energy, still water, what is smoothed.
#include "cloud.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/volume_pressure.hpp>

namespace volume_pressure_test {

using namespace cloud;

namespace {

Water heavy() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 2.6e-3, .spacing = 1e-3};
}
Water light() {
    return {.density = 2, .sound_speed = 60, .viscosity = 1e-5, .support_radius = 2.6e-3, .spacing = 8e-4};
}

// Two fluids, five hundred times apart in density, with random pressures, densities and velocities.
template <int dim>
auto two_fluids() {
    ColumnVector<dim> above = ColumnVector<dim>::Zero();
    above[dim - 1] = 3.9e-3;
    auto water = block<dim>(heavy(), 4, 0.2, 1), air = block<dim>(light(), 4, 0.2, 2, above);
    Dice dice(3);
    for (auto* fluid : {&water, &air})
        for (auto& p : *fluid) {
            p.set(density, p.material.density * dice(0.95, 1.05)).set(pressure, dice(-1e3, 3e3));
            p.set(velocity, dice.vector<dim>(1));
        }
    for (auto* fluid : {&water, &air})
        prepare(Volume{}, volume, *fluid);
    return std::pair{water, air};
}

template <int dim>
void check_balance() {
    const auto [water, air] = two_fluids<dim>();
    const VolumePressure<>::Push push;
    CHECK(worst_imbalance(push, water, air) < 1e-14);
    // equal masses: to the last bit
    for (const auto& a : water)
        for (const auto& b : water)
            REQUIRE((given(push, a, b) + given(push, b, a)).norm() == 0);
}

template <int dim>
void check_virtual_work() {
    const auto fluids = two_fluids<dim>();
    const auto &water = fluids.first, &air = fluids.second;
    double kinetic = 0, internal = 0, scale = 0;
    const auto account = [&](const auto& fluid) {
        for (const auto& a : fluid) {
            const auto force = sum(VolumePressure<>::Push{}, a, water) + sum(VolumePressure<>::Push{}, a, air);
            const double rate = plain(sum(VolumeContinuity<WendlandC2>::Sweep{}, a, water)) +
                                plain(sum(VolumeContinuity<WendlandC2>::Sweep{}, a, air));
            const double power = plain(a[mass]) * plain(force).dot(plain(a[velocity]));
            kinetic += power;
            internal += plain(a[volume]) * plain(a[pressure]) / plain(a[density]) * rate;
            scale += std::abs(power);
        }
    };
    account(water);
    account(air);
    CHECK(std::abs(kinetic) > 1e-3 * scale);
    CHECK(std::abs(kinetic + internal) < 1e-13 * scale);
}

template <int dim>
void check_diffusion() {
    auto water = block<dim>(heavy(), dim == 2 ? 8 : 6, 0.2, 5);
    const ColumnVector<dim> g =
        dim == 2 ? ColumnVector<dim>(Eigen::Vector2d(1, -9.81).head(dim)) : ColumnVector<dim>::Constant(-5);
    const double c2 = 900;
    const typename DensityDiffusion<>::Smooth smooth;
    // Water that stands, or half of whose weight is borne, has the gradient of density that goes with it; of the whole
    // gradient in water that falls freely, everything is smoothed.
    const auto greatest_rate = [&](double borne, double supported) {
        for (auto& p : water)
            p.set(density, 1000 * (1 + borne * g.dot(plain(p[position])) / c2)).set(supported_share, supported);
        prepare(Volume{}, volume, water);
        double greatest = 0;
        for (const auto& a : water)
            greatest = std::max(greatest, std::abs(plain(sum(smooth, a, water, g))));
        return greatest;
    };
    const double uncorrected = greatest_rate(1, 0);
    CHECK(uncorrected > 0.1); // kg/m^3/s: the surface would swell
    CHECK(greatest_rate(1, 1) < 1e-9 * uncorrected);
    CHECK(greatest_rate(0.5, 0.5) < 1e-9 * uncorrected);
    CHECK(greatest_rate(0, 0) < 1e-9 * uncorrected);

    Dice dice(6);
    for (auto& p : water)
        p.set(density, 1000 * dice(0.99, 1.01));
    prepare(Volume{}, volume, water);
    double drift = 0, variance_rate = 0, scale = 0;
    for (const auto& a : water) {
        const double rate = plain(a[volume]) * plain(sum(smooth, a, water));
        drift += rate;
        scale += std::abs(rate);
        variance_rate += rate * plain(a[density]);
    }
    CHECK(std::abs(drift) < 1e-13 * scale);
    CHECK(variance_rate < -1e-4 * scale * 1000); // differences die out
}

// On a lattice the sum is delta h c times the Laplacian: 2 dim for |x|^2.
template <int dim>
void check_diffusion_coefficient() {
    Water fine = heavy();
    fine.support_radius = 4e-3;
    auto water = block<dim>(fine, 9, 0);
    for (auto& p : water) {
        const ColumnVector<dim> x = plain(p[position]) - ColumnVector<dim>::Constant(4e-3);
        p.set(density, 1000 + 1e6 * x.squaredNorm()).set(volume, std::pow(1e-3, dim));
    }
    const auto& centre = water[water.size() / 2];
    REQUIRE(plain(centre[density]) == Approx(1000).epsilon(1e-12));
    const double expected = 0.1 * 2e-3 * 30 * 2 * dim * 1e6;
    CHECK(plain(sum(DensityDiffusion<>::Smooth{}, centre, water)) == Approx(expected).epsilon(0.02));
}

// The fastest decay rate of the lattice, over all waves, against the limit's claim that it is 2 over it.
template <int dim>
double fastest_rate_times_limit(double ratio) {
    Water w = heavy();
    w.support_radius = ratio * w.spacing;
    const TimeStepInput in{w.support_radius, w.spacing, 1, 1, dim};
    const double dt = DensityDiffusion<>::time_step_limit(w, in, {.delta = 0.3});
    const int reach = static_cast<int>(ratio) + 1, n = 2 * reach + 1;
    auto all = block<dim>(w, n, 0);
    const auto& a = all[all.size() / 2];
    double fastest = 0;
    const int waves = 8;
    for (int k = 0; k < (dim == 2 ? waves * waves : waves * waves * waves); ++k) {
        ColumnVector<dim> wave;
        for (int d = 0, rest = k; d < dim; ++d, rest /= waves)
            wave[d] = pi * (rest % waves + 1) / waves / w.spacing;
        for (auto& p : all) {
            p.set(volume, std::pow(w.spacing, dim));
            p.set(density, std::cos(wave.dot(plain(p[position]) - plain(a[position]))));
        }
        const double rate = -plain(sum(DensityDiffusion<>::Smooth{{.delta = 0.3}}, a, all));
        fastest = std::max(fastest, rate / plain(a[density]));
    }
    return fastest * dt;
}

} // namespace

TEST_CASE("VolumePressure: equal and opposite across a density jump, to the last bit for equal masses") {
    check_balance<2>();
    check_balance<3>();
}

TEST_CASE("VolumePressure does the work that VolumeContinuity counts") {
    check_virtual_work<2>();
    check_virtual_work<3>();
}

TEST_CASE("VolumePressure pushes apart where the pressure is positive") {
    auto water = block<2>(heavy(), 2, 0);
    for (auto& p : water)
        p.set(pressure, 100.0);
    prepare(Volume{}, volume, water);
    const auto force = plain(sum(VolumePressure<>::Push{}, water.front(), water));
    CHECK(force[0] < 0);
    CHECK(force[1] < 0);
}

TEST_CASE("VolumePressure without tension pushes as it does with it, and never pulls") {
    const auto fluids = two_fluids<3>();
    const auto &water = fluids.first, &air = fluids.second;
    const VolumePressure<WendlandC2, Tension::none>::Push push;
    CHECK(worst_imbalance(push, water, air) < 1e-14);
    int pushed = 0, pulled = 0;
    for (const auto& a : water)
        for (const auto& b : air) {
            const auto without = given(push, a, b), with = given(VolumePressure<>::Push{}, a, b);
            if (plain(a[pressure]) + plain(b[pressure]) < 0) {
                REQUIRE(without.norm() == 0);
                pulled += with.norm() > 0;
            } else {
                REQUIRE((without - with).norm() == 0);
                pushed += with.norm() > 0;
            }
        }
    CHECK(pushed > 10);
    CHECK(pulled > 10);
}

TEST_CASE("DensityDiffusion leaves still water alone, smooths the rest and loses nothing") {
    check_diffusion<2>();
    check_diffusion<3>();
}

TEST_CASE("DensityDiffusion is delta h c times the Laplacian") {
    check_diffusion_coefficient<2>();
    check_diffusion_coefficient<3>();
}

TEST_CASE("the limit of DensityDiffusion is stable and not timid") {
    for (const double ratio : {2.0, 2.6, 3.0}) {
        CHECK(fastest_rate_times_limit<2>(ratio) < 2);
        CHECK(fastest_rate_times_limit<2>(ratio) > 0.7);
        CHECK(fastest_rate_times_limit<3>(ratio) < 2);
        CHECK(fastest_rate_times_limit<3>(ratio) > 0.7);
    }
}

TEST_CASE("what is light beside a stiff fluid limits the step, on either side of a coupling, and a wall does not") {
    const TimeStepInput in{2.6e-3, 1e-3, 0.5, 0, 3, 8e-4, 0.25};
    // K = 1000 * 30^2 Pa on what weighs 2 kg/m^3; K of the gas, 2 * 60^2 Pa, on water is next to nothing
    const double between_fluids = 0.6 * 2.6e-3 / (std::sqrt(0.18 * 1000 * 30 * 30 / 2) + 0.5);
    CHECK(VolumePressure<>::time_step_limit(heavy(), light(), in) == Approx(between_fluids).epsilon(1e-12));
    CHECK(VolumePressure<>::time_step_limit(light(), heavy(), in) == Approx(between_fluids).epsilon(1e-12));
    const Sponge body = sponge();
    const double at_body = 0.6 * 2.6e-3 / (std::sqrt(2 * 0.18 * 1000 * 30 * 30 / body.density) + 0.5);
    CHECK(VolumePressure<>::time_step_limit(heavy(), body, in) == Approx(at_body).epsilon(1e-12));
    CHECK(VolumePressure<>::time_step_limit(body, heavy(), in) == Approx(at_body).epsilon(1e-12));
    const TimeStepInput other_is_faster{2.6e-3, 1e-3, 0.25, 0, 3, 8e-4, 0.5};
    CHECK(VolumePressure<>::time_step_limit(heavy(), body, other_is_faster) == Approx(at_body).epsilon(1e-12));
    CHECK(std::isinf(VolumePressure<>::time_step_limit(heavy(), Wall<>{.density = 1000}, in)));
    CHECK(acoustic_time_step(heavy(), in) < at_body); // a heavy body is none of its business
}

TEST_CASE("DensityFloor lifts what is below and leaves what is above") {
    auto water = block<3>(heavy(), 1, 0);
    auto& p = water.front();
    const DensityFloor bare, slow{{.rate = 0.5}};
    p.set(density, 1001.0);
    CHECK(plain(bare(p)) == 0);
    p.set(density, 990.0);
    CHECK(plain(bare(p)) == Approx(10 * 30 / 1e-3));
    CHECK(plain(slow(p)) == Approx(5 * 30 / 1e-3));
    const DensityFloor slack{{.slack = 0.004}};
    CHECK(plain(slack(p)) == Approx(6 * 30 / 1e-3));
    p.set(density, 997.0);
    CHECK(plain(slack(p)) == 0);
    CHECK_THROWS_AS((DensityFloorParameters{.slack = 1}.check("Water")), Error);
    CHECK_THROWS_AS((DensityFloorParameters{.slack = -0.1}.check("Water")), Error);
    const TimeStepInput in{2.6e-3, 1e-3, 1, 1, 3};
    CHECK(DensityFloor::time_step_limit(heavy(), in, {}) == Approx(2e-3 / 30));
}

} // namespace volume_pressure_test
