// CorrectedContinuity, CorrectedPressure and CorrectedViscosity: exact where they should be, in disorder and at free
// surfaces; equal and opposite forces, no torque, and as much work as compression counts.
#include "corrected_rate.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/wall/corrected_no_slip.hpp>

namespace corrected_gradients_test {

using namespace cloud;

namespace {

using K = WendlandC2;

Water water_here() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}

/// A block with its corrections, its volumes, and velocities and pressures as functions of the place.
template <int dim, class Velocity, class Pressure>
Cloud<dim, Water> corrected_block(int n, double jitter, Velocity v, Pressure p) {
    auto fluid = block<dim>(water_here(), n, jitter);
    for (auto& a : fluid) {
        const ColumnVector<dim> x = plain(a[position]);
        a.set(volume, a[mass] / a[density]).set(velocity, vec<dim>(v(x))).set(pressure, p(x));
    }
    gather(CorrectionNeighbours<K>::Sum{}, moment_matrix, fluid, fluid);
    prepare(CurrentCorrection<K>::Invert{}, gradient_correction, fluid);
    return fluid;
}

/// A velocity that is linear in space; its gradient, 1/s.
template <int dim>
Matrix<dim> shear() {
    Matrix<dim> gradient = Matrix<dim>::Constant(0.7);
    gradient(0, 0) = -2;
    gradient(1, 0) = 3;
    return gradient;
}

template <int dim>
void check_continuity() {
    const auto fluid = corrected_block<dim>(
        dim == 2 ? 7 : 5, 0.2, [](const ColumnVector<dim>& x) { return ColumnVector<dim>(shear<dim>() * x); },
        [](const ColumnVector<dim>&) { return 0; });
    const double expected = -1000 * shear<dim>().trace();
    double worst = 0, plain_worst = 0;
    for (const auto& a : fluid) {
        const auto error = [&](double rate) { return std::abs(rate / expected - 1); };
        worst = std::max(worst, error(corrected_rate<K>(a, fluid)));
        plain_worst = std::max(plain_worst, error(plain(sum(VolumeContinuity<K>::Sweep{}, a, fluid))));
    }
    CHECK(worst < 1e-11);
    CHECK(plain_worst > 0.3);
    // div v is that of the volumes around: a particle of twice the density gains twice as much
    auto dense = fluid.front();
    dense.set(density, 2000.0);
    CHECK(corrected_rate<K>(dense, fluid) == Approx(2 * expected).epsilon(1e-11));
}

// sum_a m_a a_a = 0, sum_a m_a x_a x a_a = 0, and sum_a m_a v_a.a_a = sum_a p_a V_a/rho_a (drho_a/dt) taken from it.
template <int dim>
void check_pressure() {
    Dice dice(3);
    const auto fluid = corrected_block<dim>(
        dim == 2 ? 6 : 4, 0.2, [&](const ColumnVector<dim>&) { return plain(dice.vector<dim>(2)); },
        [&](const ColumnVector<dim>&) { return dice(500, 1500); });
    ColumnVector<dim> force = ColumnVector<dim>::Zero();
    double torque = 0, work = 0, compression = 0, size = 0, arm = 0;
    for (const auto& a : fluid) {
        const ColumnVector<dim> x = plain(a[position]);
        const ColumnVector<dim> f = plain(a[mass]) * plain(sum(CorrectedPressure<K>::Push{}, a, fluid));
        force += f;
        torque += x[0] * f[1] - x[1] * f[0];
        size += f.norm();
        arm += x.norm() * f.norm();
        work += f.dot(plain(a[velocity]));
        compression += plain(a[pressure] * a[volume] / a[density]) * corrected_rate<K>(a, fluid);
    }
    CHECK(force.norm() < 1e-13 * size);
    CHECK(std::abs(torque) < 1e-13 * arm);
    CHECK(work == Approx(-compression).epsilon(1e-11));
    CHECK(std::abs(work) > 1e-3 * size);
    // by hand, one pair
    const auto &a = fluid[0], &b = fluid[1];
    const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
    const double r = x.norm(), q = r / 3e-3;
    const double slope = -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(3e-3, dim + 1) * q * std::pow(1 - q, 3);
    const Matrix<dim> stress =
        plain(a[pressure]) * plain(a[gradient_correction]) + plain(b[pressure]) * plain(b[gradient_correction]);
    const ColumnVector<dim> expected =
        -plain(a[volume]) * plain(b[volume]) / plain(a[mass]) * (stress * (slope / r * x));
    const ColumnVector<dim> found =
        plain(CorrectedPressure<K>::Push{}(a, b, geometry<CorrectedPressure<K>, dim>(a, b)));
    CHECK((found - expected).norm() < 1e-10 * expected.norm());
}

// On a lattice, inside: eta Laplacian(v)/rho of a velocity that is quadratic in space.
template <int dim>
void check_viscosity() {
    const auto fluid = corrected_block<dim>(
        9, 0,
        [](const ColumnVector<dim>& x) { return ColumnVector<dim>(ColumnVector<dim>::Unit(0) * (4e3 * x[1] * x[1])); },
        [](const ColumnVector<dim>&) { return 0; });
    const auto& middle = fluid[fluid.size() / 2];
    const double expected = 1e-3 * 8e3 / 1000;
    CHECK(plain(sum(CorrectedViscosity<K>{}, middle, fluid))[0] == Approx(expected).epsilon(1e-11));
    const double of_the_lattice = std::abs(plain(sum(MorrisViscosity<K>{}, middle, fluid))[0] / expected - 1);
    CHECK(of_the_lattice > 1e-4);
    CHECK(of_the_lattice < 0.1);
}

} // namespace

TEST_CASE("CorrectedContinuity is exact for linear velocities, at a surface too") {
    check_continuity<2>();
    check_continuity<3>();
}
TEST_CASE("CorrectedPressure conserves momentum, angular momentum and energy") {
    check_pressure<2>();
    check_pressure<3>();
}
TEST_CASE("CorrectedViscosity has no error of its lattice sum") {
    check_viscosity<2>();
    check_viscosity<3>();
}
TEST_CASE("the limits of corrected gradients are those without, where gradients are corrected by little") {
    TimeStepInput in{.support_radius = 3e-3, .spacing = 1e-3, .max_speed = 1, .max_acceleration = 0, .dimension = 2};
    const double sound = acoustic_time_step(water_here(), in),
                 viscous = MorrisViscosity<K>::time_step_limit(water_here(), in);
    for (const double greatest : {0.0, 1.0}) {
        in.greatest = greatest;
        CHECK(CorrectedPressure<K>::time_step_limit(water_here(), in) == sound);
        CHECK(CorrectedViscosity<K>::time_step_limit(water_here(), in) == viscous);
    }
    in.other_spacing = in.spacing; // in a coupling
    CHECK(CorrectedPressure<K>::time_step_limit(water_here(), water_here(), in) ==
          interface_time_step(water_here(), water_here(), in));
    in.greatest = 6;
    CHECK(CorrectedPressure<K>::time_step_limit(water_here(), in) == Approx(sound / 2));
    in.greatest = 32.0 / 3;
    CHECK(CorrectedViscosity<K>::time_step_limit(water_here(), in) == Approx(viscous / 2));
}

} // namespace corrected_gradients_test
