// The artificial stress: Eqs. (17) and (18) as printed and in principal axes, and which of them turns with the solid.
#include "hand.hpp"

#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/kernels/poly6.hpp>
#include <imbibe/kernels/spiky.hpp>
#include <imbibe/solid/artificial_stress.hpp>

#include <Eigen/Geometry>

namespace artificial_stress_test {

using namespace hand;

namespace {

template <int dim>
using Particles = std::vector<Particle<dim, Number<double>, Sponge>>;

template <int dim>
Matrix<dim> sigma(const Particle<dim, Number<double>, Sponge>& p) {
    return plain(p[deviatoric_stress]) - plain(p[pressure]) * Matrix<dim>::Identity();
}

template <int dim>
Matrix<dim> rotation(double angle) {
    Matrix<dim> Q;
    if constexpr (dim == 2)
        Q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    else
        Q = Eigen::AngleAxisd(angle, ColumnVector<3>(1, -2, 0.5).normalized()).toRotationMatrix();
    return Q;
}

template <int dim>
Vector<Number<double>, dim> vector(const ColumnVector<dim>& v) {
    return from_eigen<Number<double>, dim>(v);
}

template <int dim>
SymmetricTensor<Number<double>, dim> symmetric(const Matrix<dim>& m) {
    SymmetricTensor<Number<double>, dim> s{};
    for (int i = 0; i < dim; ++i)
        for (int j = i; j < dim; ++j)
            s(i, j) = m(i, j);
    return s;
}

/// The whole solid turned: positions and stresses.
template <int dim>
Particles<dim> turned(Particles<dim> all, const Matrix<dim>& Q) {
    for (auto& p : all) {
        p.set(position, vector<dim>(Q * plain(p[position])));
        p.set(deviatoric_stress, symmetric<dim>(Q * plain(p[deviatoric_stress]) * Q.transpose()));
    }
    return all;
}

template <class Term, int dim>
ColumnVector<dim> acceleration_of_first(Particles<dim> all) {
    prepare(typename Term::Prepare{}, artificial_stress_over_density2, all);
    return plain(sum_over_neighbours(typename Term::Push{}, all));
}

// Eq. (17) component by component, Eq. (18) with the spiky kernel, the last part of Eq. (15).
template <int dim>
ColumnVector<dim> printed_form(const Particles<dim>& all, double epsilon, int n) {
    const auto R = [&](const auto& p) -> Matrix<dim> {
        const double rho = plain(p[density]);
        Matrix<dim> r;
        for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
                r(i, j) = sigma<dim>(p)(i, j) > 0 ? -epsilon * sigma<dim>(p)(i, j) / (rho * rho) : 0;
        return r;
    };
    return sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double r) -> ColumnVector<dim> {
        const double f = std::pow(spiky<dim>(r) / spiky<dim>(5e-4), n);
        return plain(b[mass]) * (R(all.front()) + R(b)) * f * spiky_gradient<dim>(x);
    });
}

// The tensile part of a stress without its principal axes: sigma (1 + sign(sigma))/2, with the sign of a matrix from
// Newton's iteration X -> (X + X^-1)/2.
template <int dim>
Matrix<dim> tension_by_sign(const Matrix<dim>& stress) {
    Matrix<dim> sign = stress / stress.norm();
    for (int k = 0; k < 60; ++k)
        sign = (0.5 * (sign + sign.inverse())).eval();
    return 0.5 * stress * (Matrix<dim>::Identity() + sign);
}

template <int dim>
ColumnVector<dim> principal_form(const Particles<dim>& all, double epsilon, int n) {
    const auto R = [&](const auto& p) -> Matrix<dim> {
        return -epsilon * tension_by_sign<dim>(sigma<dim>(p)) / std::pow(plain(p[density]), 2);
    };
    return sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double r) -> ColumnVector<dim> {
        const double f = std::pow(poly6<dim>(r) / poly6<dim>(5e-4), n);
        return plain(b[mass]) * (R(all.front()) + R(b)) * f * spiky_gradient<dim>(x);
    });
}

template <int dim>
void check_both_forms() {
    Dice dice(80 + dim);
    const auto all = dice.cluster<dim>(sponge());
    using Printed = ArtificialStress<Spiky, ComponentWise>;
    using Principal = ArtificialStress<Spiky, PrincipalAxes, Poly6, 3>;
    CHECK(relative_error(acceleration_of_first<Printed, dim>(all), printed_form<dim>(all, 0.3, 4)) < 1e-11);
    CHECK(relative_error(acceleration_of_first<Principal, dim>(all), principal_form<dim>(all, 0.3, 3)) < 1e-10);
}

template <int dim>
void check_objectivity() {
    Dice dice(90 + dim);
    const auto all = dice.cluster<dim>(sponge());
    double greatest_error_of_printed = 0;
    for (const double angle : {0.3, 0.8, 1.4, 2.5}) {
        const Matrix<dim> Q = rotation<dim>(angle);
        const auto error = [&]<class Term>(Term) {
            const ColumnVector<dim> before = acceleration_of_first<Term, dim>(all);
            const ColumnVector<dim> after = acceleration_of_first<Term, dim>(turned<dim>(all, Q));
            return relative_error(after, (Q * before).eval());
        };
        CHECK(error(ArtificialStress<Spiky>{}) < 1e-10);
        greatest_error_of_printed =
            std::max(greatest_error_of_printed, error(ArtificialStress<Spiky, ComponentWise>{}));
    }
    CHECK(greatest_error_of_printed > 0.05);
}

} // namespace

TEST_CASE("ArtificialStress is the last part of Eq. (15), printed and in principal axes") {
    check_both_forms<2>();
    check_both_forms<3>();
}

TEST_CASE("ArtificialStress in principal axes turns with the solid, the printed form does not") {
    check_objectivity<2>();
    check_objectivity<3>();
}

TEST_CASE("principal tension of stresses with equal eigenvalues, and of none") {
    using S = SymmetricTensor<Number<double>, 3>;
    const S uniform = symmetric<3>(2e4 * Matrix<3>::Identity());
    CHECK(relative_error(plain(PrincipalAxes::tension(uniform)), plain(uniform)) < 1e-14);
    CHECK(plain(PrincipalAxes::tension(symmetric<3>(-2e4 * Matrix<3>::Identity()))).norm() == 0);
    CHECK(plain(PrincipalAxes::tension(S::zero())).norm() == 0);
    const Matrix<3> Q = rotation<3>(0.7);
    const Matrix<3> two_equal = Q * ColumnVector<3>(3e4, 3e4, -1e4).asDiagonal() * Q.transpose();
    const Matrix<3> expected = Q * ColumnVector<3>(3e4, 3e4, 0).asDiagonal() * Q.transpose();
    CHECK(relative_error(plain(PrincipalAxes::tension(symmetric<3>(two_equal))), expected) < 1e-8);
    const Matrix<3> nearly = Q * ColumnVector<3>(3e4, 3e4 + 1e-3, -1e4).asDiagonal() * Q.transpose();
    CHECK(relative_error(plain(PrincipalAxes::tension(symmetric<3>(nearly))), expected) < 1e-6);
    // pure shear: half tension along one diagonal
    Matrix<2> shear;
    shear << 0, 1e4, 1e4, 0;
    CHECK(relative_error(plain(PrincipalAxes::tension(symmetric<2>(shear))), (5e3 * Matrix<2>::Constant(1)).eval()) <
          1e-14);
}

TEST_CASE("ArtificialStress: compression has none, tension repels, and Spiky's factor is a 12th power") {
    Particles<3> all(2, Particle<3, Number<double>, Sponge>(sponge()));
    const auto acceleration_at = [&]<class Term>(Term, double distance, double p) {
        for (auto& particle : all)
            particle.set(mass, 1e-7)
                .set(density, 950)
                .set(pressure, p)
                .set(deviatoric_stress, SymmetricTensor<Number<double>, 3>::zero());
        all[0].set(position, {0, 0, 0});
        all[1].set(position, {distance, 0, 0});
        return acceleration_of_first<Term, 3>(all)[0];
    };
    using S = ArtificialStress<Spiky>;
    CHECK(acceleration_at(S{}, 4e-4, 1e4) == 0);
    CHECK(acceleration_at(S{}, 4e-4, -1e4) < 0); // the neighbour is on the right
    // what the comment of the term says of its factors: at two thirds of the spacing and at contact
    const auto factor = [](auto kernel, double d) {
        const Pair<3, Number<double>> ab({d, 0, 0}, d, SupportRadius(H), {});
        return plain(power<4>(ab.relative_value(kernel, 5e-4)));
    };
    CHECK(factor(Spiky{}, 1e-3 / 3) == Approx(31.57).epsilon(1e-3));
    CHECK(factor(Spiky{}, 0) == Approx(4096));
    CHECK(factor(Poly6{}, 1e-3 / 3) == Approx(7.7).epsilon(1e-2));
    CHECK(factor(Poly6{}, 0) == Approx(31.57).epsilon(1e-3));
    CHECK(factor(CubicSpline{}, 1e-3 / 3) == Approx(24.4).epsilon(1e-2));
    CHECK(factor(CubicSpline{}, 0) == Approx(256));
}

} // namespace artificial_stress_test
