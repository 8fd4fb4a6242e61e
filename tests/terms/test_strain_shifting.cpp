// InnerCorrection and StrainShifting: full inside, nothing at a free surface, and by hand.
#include "cloud.hpp"

#include <imbibe/fluid/strain_shifting.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace strain_shifting_test {

using namespace cloud;
using K = WendlandC2;
constexpr double dx = 1e-3, H = 3 * dx;

Water water_here() {
    Water w = water();
    w.spacing = dx;
    w.support_radius = H;
    return w;
}

template <int dim>
InnerCorrection<K>::Invert prepared() {
    return {InnerCorrection<K>::prepare(water_here(), Lattice<dim>{dx, H}, InnerCorrectionParameters{})};
}

/// A block with moments, corrections and indicators.
template <int dim>
Cloud<dim, Water> corrected_block(int n, double jitter) {
    auto fluid = block<dim>(water_here(), n, jitter);
    for (auto& p : fluid)
        p.set(volume, p[mass] / p[density]);
    gather(CorrectionNeighbours<K>::Sum{}, moment_matrix, fluid, fluid);
    for (auto& p : fluid) {
        const auto [L, indicator] = prepared<dim>()(p);
        p.set(gradient_correction, L).set(surface_indicator, indicator);
    }
    return fluid;
}

template <int dim>
void check_correction() {
    const int n = 9, middle = dim == 2 ? 4 + 9 * 4 : 4 + 9 * (4 + 9 * 4);
    const auto fluid = corrected_block<dim>(n, 0.05);
    const auto& inside = fluid[static_cast<std::size_t>(middle)];
    const Matrix<dim> product = plain(inside[gradient_correction]) * plain(inside[moment_matrix]);
    CHECK((product - Matrix<dim>::Identity()).norm() < 1e-12);
    CHECK(plain(inside[surface_indicator]) == 0);
    const auto& corner = fluid.front();
    CHECK((plain(corner[gradient_correction]) - Matrix<dim>::Identity()).norm() == 0);
    CHECK(plain(corner[surface_indicator]) == 1);
    // somewhere between the surface and the inside it is in part
    int in_part = 0;
    for (const auto& p : fluid)
        in_part += plain(p[surface_indicator]) > 0 && plain(p[surface_indicator]) < 1;
    CHECK(in_part > 0);
}

TEST_CASE("InnerCorrection is the inverse inside and the identity at a free surface") {
    check_correction<2>();
    check_correction<3>();
    // The thresholds are shares of 1/|M^-1| of the lattice, 0.707 in the plane and 0.577 in space where M is the
    // identity.
    const InnerCorrectionParameters usual;
    CHECK(prepared<2>().prepared.full_above == Approx(usual.full_above * std::sqrt(0.5)).epsilon(0.01));
    CHECK(prepared<3>().prepared.none_below == Approx(usual.none_below * std::sqrt(1.0 / 3)).epsilon(0.01));
    CHECK_THROWS_WITH((InnerCorrectionParameters{.full_above = 0.5, .none_below = 0.6}.check("Water")),
                      imbibe_test::contains("full_above = 0.5; it must be above none_below, 0.6"));
}

template <int dim>
void check_shift() {
    auto fluid = corrected_block<dim>(7, 0.2);
    Dice dice(7);
    for (auto& p : fluid)
        p.set(velocity, dice.vector<dim>(1));
    auto& a = fluid[fluid.size() / 2];
    // the sums, by hand
    Matrix<dim> E = Matrix<dim>::Zero();
    ColumnVector<dim> g = ColumnVector<dim>::Zero();
    for (const auto& b : fluid) {
        const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
        const double r = x.norm(), q = r / H;
        if (r == 0 || q >= 1)
            continue;
        const ColumnVector<dim> slope =
            -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(H, dim + 1) * q * std::pow(1 - q, 3) / r * x;
        const ColumnVector<dim> v = plain(b[velocity]) - plain(a[velocity]);
        E += plain(b[volume]) * 0.5 * (v * slope.transpose() + slope * v.transpose());
        g += plain(b[volume]) * slope;
    }
    a.set(raw_strain_rate, sum(CorrectedContinuity<K>::Sum{}, a, fluid));
    a.set(concentration_gradient, sum(ConcentrationNeighbours<K>::Sum{}, a, fluid));
    CHECK((plain(a[raw_strain_rate]) - E).norm() < 1e-12 * E.norm());
    CHECK((plain(a[concentration_gradient]) - g).norm() < 1e-12 * g.norm());
    const auto shift = [](auto particle, double indicator, double time_step) {
        particle.set(surface_indicator, indicator);
        particle.time_step = time_step;
        return plain(StrainShifting<K>::Shift{}(particle));
    };
    const double gamma = std::sqrt(2 * E.squaredNorm());
    CHECK((shift(a, 0, 0) + 0.5 * gamma * H * H * g).norm() < 1e-12 * gamma * H * H * g.norm());
    CHECK((shift(a, 0.25, 0) + 0.75 * 0.5 * gamma * H * H * g).norm() < 1e-12 * gamma * H * H * g.norm());
    CHECK(shift(a, 1, 0).norm() == 0);
    const double dt = 1; // long: the bound of a step counts
    CHECK((shift(a, 0, dt) + 0.035 * H * H * H / (dx * dt) * g).norm() < 1e-12 * H * H * g.norm());
}

TEST_CASE("StrainShifting by hand") {
    check_shift<2>();
    check_shift<3>();
    CHECK_THROWS_WITH((StrainShiftingParameters{.most_in_a_step = 0}.check("Water")),
                      imbibe_test::contains("most_in_a_step = 0; it must be finite and above 0"));
    CHECK_THROWS_WITH((StrainShiftingParameters{.strength = -1}.check("Water")),
                      imbibe_test::contains("strength = -1"));
}

} // namespace strain_shifting_test
