// CurrentCorrection and AntuonoDiffusion: linear fields are exact at every particle and left alone, single drops are
// not divided by zero, and what one particle gains the other loses.
#include "cloud.hpp"

#include <imbibe/fluid/gradient_correction.hpp>

namespace gradient_correction_test {

using namespace cloud;

namespace {

using K = WendlandC2;
using Correction = CurrentCorrection<K>;
using Diffusion = AntuonoDiffusion<K>;

Water water_here() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}

template <int dim>
ColumnVector<dim> slope() {
    ColumnVector<dim> s = ColumnVector<dim>::Constant(300);
    s[0] = -2000;
    return s;
}

template <int dim, class Field_>
void correct(Cloud<dim, Water>& fluid, Field_ rho) {
    for (auto& p : fluid)
        p.set(density, rho(plain(p[position]))).set(volume, 1e-9);
    for (auto& p : fluid)
        p.set(volume, p[mass] / p[density]);
    gather(CorrectionNeighbours<K>::Sum{}, moment_matrix, fluid, fluid);
    prepare(Correction::Invert{}, gradient_correction, fluid);
    gather(Diffusion::Sum{}, raw_density_gradient, fluid, fluid);
    prepare(Diffusion::Correct{}, density_gradient, fluid);
}

template <int dim>
void check_linear() {
    auto fluid = block<dim>(water_here(), dim == 2 ? 7 : 5, 0.15);
    correct<dim>(fluid, [](const ColumnVector<dim>& x) { return 1000 + slope<dim>().dot(x); });
    double worst = 0, raw = 0, rate = 0, plain_rate = 0;
    for (const auto& a : fluid) {
        worst = std::max(worst, (plain(a[density_gradient]) - slope<dim>()).norm() / slope<dim>().norm());
        raw = std::max(raw, (plain(a[raw_density_gradient]) - slope<dim>()).norm() / slope<dim>().norm());
        rate = std::max(rate, std::abs(plain(sum(Diffusion::Smooth{}, a, fluid))));
        plain_rate = std::max(plain_rate, std::abs(plain(sum(DensityDiffusion<K>::Smooth{}, a, fluid))));
    }
    CHECK(raw > 0.3);
    CHECK(worst < 1e-11);
    CHECK(plain_rate > 1);
    CHECK(rate < 1e-9 * plain_rate);
}

template <int dim>
void check_balance() {
    auto fluid = block<dim>(water_here(), 4, 0.2, 3);
    Dice dice(4);
    correct<dim>(fluid, [&](const ColumnVector<dim>&) { return dice(990, 1010); });
    double total = 0, size = 0;
    for (const auto& a : fluid) {
        const double gain = plain(a[volume]) * plain(sum(Diffusion::Smooth{}, a, fluid));
        total += gain;
        size += std::abs(gain);
    }
    CHECK(std::abs(total) < 1e-13 * size);
    // by hand, one pair
    const auto &a = fluid[0], &b = fluid[1];
    const ColumnVector<dim> x = plain(b[position]) - plain(a[position]);
    const double r = x.norm(), q = r / 3e-3;
    const double slope_of_W =
        -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(3e-3, dim + 1) * q * std::pow(1 - q, 3);
    const double gradient = 0.5 * (plain(a[density_gradient]) + plain(b[density_gradient])).dot(x);
    const double expected = 2 * 0.1 * 1.5e-3 * 30 * plain(b[volume]) *
                            (plain(b[density]) - plain(a[density]) - gradient) * (x.dot(-slope_of_W * x / r)) / (r * r);
    CHECK(plain(Diffusion::Smooth{}(a, b, geometry<Diffusion::Smooth, dim>(a, b))) == Approx(expected).epsilon(1e-10));
    const Diffusion::Smooth stronger{{.delta = 0.3}};
    CHECK(plain(stronger(a, b, geometry<Diffusion::Smooth, dim>(a, b))) == Approx(3 * expected).epsilon(1e-10));
}

template <int dim>
void check_alone() {
    auto drop = block<dim>(water_here(), 1, 0); // one particle, and two
    auto pair = block<dim>(water_here(), 1, 0);
    pair.push_back(block<dim>(water_here(), 1, 0, 1, ColumnVector<dim>::Unit(0) * 1e-3).front());
    for (auto* fluid : {&drop, &pair}) {
        correct<dim>(*fluid, [](const ColumnVector<dim>& x) { return 1000 + slope<dim>().dot(x); });
        for (const auto& a : *fluid) {
            CHECK((plain(a[gradient_correction]) - Matrix<dim>::Identity()).norm() < 1e-12);
            CHECK(std::isfinite(plain(sum(Diffusion::Smooth{}, a, *fluid))));
        }
    }
    CHECK(plain(sum(Diffusion::Smooth{}, drop.front(), drop)) == 0);
}

} // namespace

TEST_CASE("corrected gradients are exact for linear densities, which AntuonoDiffusion leaves alone") {
    check_linear<2>();
    check_linear<3>();
}
TEST_CASE("AntuonoDiffusion is its equation and conserves the sum of V rho") {
    check_balance<2>();
    check_balance<3>();
}
TEST_CASE("a drop of one or two particles is not corrected") {
    check_alone<2>();
    check_alone<3>();
}
TEST_CASE("between its two bounds a correction goes over to the identity in a straight line") {
    // For M = m 1 in the plane 1/|M^-1| is m/sqrt(2).
    for (const auto& [least, trust] : {std::pair{0.02, 0.0}, {0.04, 0.0}, {0.05, 0.25}, {0.07, 0.75}, {0.08, 1.0}}) {
        const double m = least * std::sqrt(2.0);
        const auto M = Number<double>(m) * symmetric_identity<Number<double>, 2>();
        const auto L = plain(imbibe::detail::inverse_or_identity(M, 0.08, 0.04));
        CAPTURE(least);
        CHECK(L(0, 0) == Approx(trust / m + 1 - trust).epsilon(1e-10));
        CHECK(L(1, 1) == Approx(trust / m + 1 - trust).epsilon(1e-10));
        CHECK(L(0, 1) == 0);
    }
}
TEST_CASE("CurrentCorrection and AntuonoDiffusion check their coefficients") {
    CHECK_THROWS_AS((CurrentCorrectionParameters{.full_above = 1e-3, .none_below = 2e-3}.check("Water")), Error);
    CHECK_THROWS_AS(AntuonoDiffusionParameters{.delta = -1}.check("Water"), Error);
}

} // namespace gradient_correction_test
