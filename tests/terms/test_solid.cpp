// The terms of the solid against the equations written out: velocity gradient, Jaumann rate, stress, XSPH.
#include "hand.hpp"

#include <imbibe/kernels/poly6.hpp>
#include <imbibe/kernels/spiky.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>

namespace solid_test {

using namespace hand;

namespace {

constexpr double tight = 1e-11;

template <int dim>
using Solid_ = Particle<dim, Number<double>, Sponge>;

template <int dim>
SymmetricTensor<Number<double>, dim> symmetric(const Matrix<dim>& m) {
    SymmetricTensor<Number<double>, dim> s{};
    for (int i = 0; i < dim; ++i)
        for (int j = i; j < dim; ++j)
            s(i, j) = m(i, j);
    return s;
}
template <int dim>
Tensor<Number<double>, dim> tensor(const Matrix<dim>& m) {
    Tensor<Number<double>, dim> t{};
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            t(i, j) = m(i, j);
    return t;
}

template <int dim>
void check_velocity_gradient() {
    Dice dice(40 + dim);
    auto all = dice.cluster<dim>(sponge());
    const auto& a = all.front();
    const Matrix<dim> by_hand = sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double) -> Matrix<dim> {
        const ColumnVector<dim> gradient = spiky_gradient<dim>(x);
        Matrix<dim> m;
        for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
                m(i, j) =
                    -plain(b[mass]) / plain(b[density]) * (plain(a[velocity])[i] - plain(b[velocity])[i]) * gradient[j];
        return m;
    });
    CHECK(relative_error(plain(sum_over_neighbours(VelocityGradient<Spiky>{}, all)), by_hand) < tight);

    // of the smoothed velocity, where asked for; and nothing at all for a uniform one
    for (auto& p : all)
        p.set(smoothed_velocity, p[velocity]).set(velocity, Vector<Number<double>, dim>::filled(0.7));
    using Smoothed = VelocityGradient<Spiky, smoothed_velocity>;
    CHECK(relative_error(plain(sum_over_neighbours(Smoothed{}, all)), by_hand) < tight);
    CHECK(plain(sum_over_neighbours(VelocityGradient<Spiky>{}, all)).norm() == 0);
}

// Eqs. (5) to (7) index by index, with the trace mended.
template <int dim>
Matrix<dim> jaumann_by_hand(const Matrix<dim>& L, const Matrix<dim>& S, double G) {
    Matrix<dim> rate;
    double trace = 0;
    for (int k = 0; k < dim; ++k)
        trace += L(k, k);
    const auto spin = [&](int i, int j) { return 0.5 * (L(i, j) - L(j, i)); };
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
            rate(i, j) = 2 * G * (0.5 * (L(i, j) + L(j, i)) - (i == j ? trace / 3 : 0));
            for (int k = 0; k < dim; ++k)
                rate(i, j) += S(i, k) * spin(j, k) + spin(i, k) * S(k, j);
        }
    return rate;
}

template <int dim>
Matrix<dim> jaumann(const Matrix<dim>& L, const Matrix<dim>& S) {
    Solid_<dim> a(sponge());
    a.set(velocity_gradient, tensor<dim>(L)).set(deviatoric_stress, symmetric<dim>(S));
    return plain(JaumannStress{}(a));
}

template <int dim>
Matrix<dim> random_matrix(Dice& dice, double size) {
    Matrix<dim> m;
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            m(i, j) = dice(-size, size);
    return m;
}

template <int dim>
void check_jaumann() {
    Dice dice(50 + dim);
    for (int k = 0; k < 20; ++k) {
        const Matrix<dim> L = random_matrix<dim>(dice, 100), T = random_matrix<dim>(dice, 1e5), S = T + T.transpose();
        CHECK(relative_error(jaumann<dim>(L, S), jaumann_by_hand<dim>(L, S, 1e6)) < tight);
    }
}

// Explicit steps through a shear of 2; in simple shear S_xy = G sin(shear), S_xx = -S_yy = G (1 - cos(shear)).
template <int dim>
void check_simple_shear() {
    constexpr int steps = 20000;
    constexpr double dt = 2.0 / steps, G = 1e6;
    Matrix<dim> L = Matrix<dim>::Zero(), S = Matrix<dim>::Zero();
    L(0, 1) = 1;
    for (int k = 1; k <= steps; ++k) {
        const Matrix<dim> half = S + 0.5 * dt * jaumann<dim>(L, S); // midpoint rule
        S += dt * jaumann<dim>(L, half);
        if (k % 4000 == 0) {
            const double shear = k * dt;
            CHECK(std::abs(S(0, 1) - G * std::sin(shear)) < 1e-7 * G);
            CHECK(std::abs(S(0, 0) - G * (1 - std::cos(shear))) < 1e-7 * G);
            CHECK(std::abs(S(1, 1) + S(0, 0)) < 1e-7 * G);
        }
    }
}

template <int dim>
void check_stress_force() {
    Dice dice(60 + dim);
    auto all = dice.cluster<dim>(sponge());
    prepare(typename StressForce<Spiky>::Prepare{}, stress_over_density2, all);
    const auto& a = all.front();
    const auto sigma = [](const auto& p) -> Matrix<dim> {
        return plain(p[deviatoric_stress]) - plain(p[pressure]) * Matrix<dim>::Identity();
    };
    const ColumnVector<dim> by_hand =
        sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double) -> ColumnVector<dim> {
            const double rho_a = plain(a[density]), rho_b = plain(b[density]);
            return plain(b[mass]) * (sigma(a) / (rho_a * rho_a) + sigma(b) / (rho_b * rho_b)) * spiky_gradient<dim>(x);
        });
    CHECK(relative_error(plain(sum_over_neighbours(typename StressForce<Spiky>::Push{}, all)), by_hand) < tight);
}

template <int dim>
void check_xsph() {
    Dice dice(70 + dim);
    auto all = dice.cluster<dim>(sponge());
    auto& a = all.front();
    const ColumnVector<dim> sum =
        sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>&, double r) -> ColumnVector<dim> {
            return plain(b[mass]) / (0.5 * (plain(a[density]) + plain(b[density]))) *
                   (plain(b[velocity]) - plain(a[velocity])) * poly6<dim>(r);
        });
    a.set(relative_mean_velocity, sum_over_neighbours(Xsph<Poly6>::Sum{}, all));
    CHECK(relative_error(plain(a[relative_mean_velocity]), sum) < tight);

    Xsph<Poly6>::Smooth smooth;
    const ColumnVector<dim> v = plain(a[velocity]);
    CHECK(relative_error(plain(smooth(a)), (v + 0.5 * sum).eval()) < tight); // Eq. (19)
    smooth.parameters.strength = 0.2;
    CHECK(relative_error(plain(smooth(a)), (v + 0.2 * sum).eval()) < tight);

    // moved with velocity + transport_correction, a particle moves with the smoothed velocity
    a.set(smoothed_velocity, smooth(a));
    CHECK(relative_error((v + plain(XsphTransport{}(a))).eval(), plain(a[smoothed_velocity])) < tight);
}

} // namespace

TEST_CASE("VelocityGradient is Eq. (21)") {
    check_velocity_gradient<2>();
    check_velocity_gradient<3>();
}

TEST_CASE("VelocityGradient of a linear velocity has the right sign and place of every component") {
    // Neighbours at +-d on the axes: the sum is then the linear field times one common positive factor.
    Matrix<3> L;
    L << 1, 2, 3, -4, 5, -6, 7, 8, -9;
    std::vector<Solid_<3>> all(7, Solid_<3>(sponge()));
    for (int k = 0; k < 7; ++k) {
        ColumnVector<3> x = ColumnVector<3>::Zero();
        if (k > 0)
            x[(k - 1) / 2] = k % 2 ? 5e-4 : -5e-4;
        const ColumnVector<3> v = L * x;
        all[static_cast<std::size_t>(k)]
            .set(position, {x[0], x[1], x[2]})
            .set(velocity, {v[0], v[1], v[2]})
            .set(mass, 1e-7)
            .set(density, 950);
    }
    const Matrix<3> sum = plain(sum_over_neighbours(VelocityGradient<Spiky>{}, all));
    const double factor = sum(0, 0) / L(0, 0);
    CHECK(factor > 0);
    CHECK(relative_error(sum, (factor * L).eval()) < 1e-12);
}

TEST_CASE("JaumannStress is Eqs. (5) to (7) with the mended trace") {
    check_jaumann<2>();
    check_jaumann<3>();
}

TEST_CASE("JaumannStress: simple shear gives the sine of the shear") {
    check_simple_shear<2>();
    check_simple_shear<3>();
}

TEST_CASE("JaumannStress: a rigid rotation turns the stress and makes none") {
    Matrix<3> L = Matrix<3>::Zero(), S = Matrix<3>::Zero();
    L(0, 1) = -1;
    L(1, 0) = 1;
    CHECK(jaumann<3>(L, S).norm() == 0);
    S.diagonal() << 2e5, -5e4, -1.5e5;
    Matrix<3> turned = S;
    constexpr int steps = 20000;
    constexpr double dt = 1.0 / steps;
    for (int k = 0; k < steps; ++k)
        turned += dt * jaumann<3>(L, turned + 0.5 * dt * jaumann<3>(L, turned));
    Matrix<3> Q = Matrix<3>::Identity();
    Q.topLeftCorner<2, 2>() << std::cos(1.0), -std::sin(1.0), std::sin(1.0), std::cos(1.0);
    CHECK(relative_error(turned, (Q * S * Q.transpose()).eval()) < 1e-7);
}

TEST_CASE("JaumannStress: the rate has no trace in 3D, and 2D is plane strain") {
    Dice dice(5);
    const Matrix<2> L = random_matrix<2>(dice, 100);
    Matrix<3> L3 = Matrix<3>::Zero();
    L3.topLeftCorner<2, 2>() = L;
    const Matrix<3> rate = jaumann<3>(L3, Matrix<3>::Zero());
    CHECK(std::abs(rate.trace()) < 1e-12 * rate.norm());
    CHECK(std::abs(rate(2, 2)) > 0);
    const Matrix<2> in_plane = rate.topLeftCorner<2, 2>();
    CHECK(relative_error(jaumann<2>(L, Matrix<2>::Zero()), in_plane) < 1e-13);
}

TEST_CASE("StressForce is the stress part of Eq. (15)") {
    check_stress_force<2>();
    check_stress_force<3>();
}

TEST_CASE("StressForce: tension pulls, pressure pushes") {
    Solid_<3> a(sponge()), b(sponge());
    a.set(position, {0, 0, 0}).set(mass, 1e-7).set(density, 950).set(pressure, 0);
    b.set(position, {4e-4, 0, 0}).set(mass, 1e-7).set(density, 950).set(pressure, 0);
    SymmetricTensor<Number<double>, 3> stretch = SymmetricTensor<Number<double>, 3>::zero();
    stretch(0, 0) = 1e4;
    const auto pull = [&] {
        std::vector<Solid_<3>> both{a, b};
        prepare(StressForce<Spiky>::Prepare{}, stress_over_density2, both);
        return plain(StressForce<Spiky>::Push{}(both[0], both[1], pair_of(a, b)))[0];
    };
    a.set(deviatoric_stress, stretch);
    b.set(deviatoric_stress, stretch);
    CHECK(pull() > 0); // b is on the right
    a.set(pressure, 2e4);
    b.set(pressure, 2e4);
    CHECK(pull() < 0);
}

TEST_CASE("Xsph is Eq. (19), XsphTransport moves with it") {
    check_xsph<2>();
    check_xsph<3>();
}

} // namespace solid_test
