// PairwiseShearForce against its equation, and against what it is for: it resists motions that the deformation gradient
// does not see.
#include "cloud.hpp"

#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

#include <Eigen/Dense>

namespace pairwise_shear_test {

using namespace cloud;

namespace {

using Term = PairwiseShearForce<>;

constexpr double G = 2.7e4, K = 950 * 1e4, reach = 2.6e-3;
Sponge rubber() {
    return {.density = 950, .sound_speed = 100, .shear_modulus = G, .support_radius = reach, .spacing = 1e-3};
}
template <int dim>
using Body = Cloud<dim, Sponge>;

template <int dim>
Body<dim> lattice(int n, double jitter) {
    auto body = block<dim>(rubber(), n, jitter, 1);
    gather(ReferenceCorrection<>::Moments{}, moment_matrix, body, body);
    prepare(ReferenceCorrection<>::Share{}, stress_share, body);
    prepare(ReferenceCorrection<>::Invert{}, gradient_correction, body);
    return body;
}
template <int dim>
void ready(Body<dim>& body, const Term::Parameters& parameters = {}) {
    prepare(Displacement{}, displacement, body);
    gather(DeformationGradient<>::Sum{}, raw_displacement_gradient, body, body);
    prepare(DeformationGradient<>::Correct{}, deformation_gradient, body);
    for (auto& p : body) {
        const auto [scale, stress] = Term::Prepare{parameters}(p);
        p.set(shear_scale, scale).set(isotropic_piola_stress, stress);
    }
}
template <int dim, class F>
void move(Body<dim>& body, const F& displacement_at) {
    for (auto& p : body)
        p.set(position, vec<dim>(plain(p[reference_position]) + displacement_at(plain(p[reference_position]))));
    ready(body);
}

template <int dim>
void check_equation() {
    auto body = lattice<dim>(3, 0.2);
    Dice dice(4);
    for (auto& p : body)
        p.set(position, p[reference_position] + dice.vector<dim>(1e-4));
    const Term::Parameters parameters{.factor = 1.3};
    ready(body, parameters);
    const Term::Push push{parameters};
    const auto T = [&](const auto& p) -> Matrix<dim> {
        const Matrix<dim> F = plain(p[deformation_gradient]);
        const double J = F.determinant(), I1 = (F * F.transpose()).trace() + (dim == 2 ? 1 : 0);
        return (K / 2 * (J * J - 1) - 1.3 * G * std::pow(J, -2.0 / 3) * I1 / 3) * F.inverse().transpose();
    };
    const auto scale = [](const auto& p) { return std::pow(plain(p[deformation_gradient]).determinant(), -2.0 / 3); };
    double worst = 0;
    for (const auto& a : body)
        for (const auto& b : body) {
            const ColumnVector<dim> X = plain(a[reference_position]) - plain(b[reference_position]),
                                    x = plain(a[position]) - plain(b[position]);
            const double q = X.norm() / reach, norm = dim == 2 ? 7 / pi : 21 / (2 * pi);
            const double slope = q < 1 ? -20 * norm * std::pow(1 - q, 3) / std::pow(reach, dim + 2) : 0;
            const ColumnVector<dim> expected = plain(a[mass]) * plain(b[mass]) / (950.0 * 950.0) * slope *
                                               ((T(a) + T(b)) * X + 1.3 * G * (scale(a) + scale(b)) * x);
            const double size = std::pow(plain(a[mass]) / 950, 2) * norm / std::pow(reach, dim + 1) * K;
            worst = std::max(worst, (given(push, a, b) - expected).norm() / size);
        }
    CHECK(worst < 1e-12);
    CHECK(worst_imbalance(push, body, body) == 0);
}

template <int dim>
void check_rest_and_rotation() {
    auto body = lattice<dim>(4, 0.2);
    const double scale = G / (950 * reach);
    move(body, [](const ColumnVector<dim>&) -> ColumnVector<dim> { return ColumnVector<dim>::Constant(7e-3); });
    for (const auto& p : body)
        CHECK(plain(sum(Term::Push{}, p, body)).norm() < 1e-9 * scale);
    Matrix<dim> R;
    if constexpr (dim == 2)
        R = Eigen::Rotation2Dd(2.1).toRotationMatrix();
    else
        R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    move(body, [&](const ColumnVector<dim>& X) -> ColumnVector<dim> { return R * X - X; });
    for (const auto& p : body)
        CHECK(plain(sum(Term::Push{}, p, body)).norm() < 1e-9 * scale);
}

// u_x = c y^2 is pure shear: the force per mass is 2 c times factor G/rho.
template <int dim>
void check_shear() {
    auto body = lattice<dim>(9, 0);
    move(body, [](const ColumnVector<dim>& X) -> ColumnVector<dim> {
        ColumnVector<dim> u = ColumnVector<dim>::Zero();
        u[0] = 1e-3 * X[1] * X[1] / 4e-3;
        return u;
    });
    const ColumnVector<dim> force = plain(sum(Term::Push{}, body[body.size() / 2], body));
    const double expected = 1.07 * G / 950 * 2 * 0.25;
    CAPTURE(force[0] / expected);
    CHECK(force[0] == Approx(expected).epsilon(0.05)); // the Laplacian of a lattice
}

// Displacements that alternate: the gradient sees next to nothing of them, this force all.
template <int dim>
void check_alternating() {
    auto body = lattice<dim>(9, 0);
    const auto sign = [](const ColumnVector<dim>& X) {
        int k = 0;
        for (int d = 0; d < dim; ++d)
            k += static_cast<int>(std::lround(X[d] / 1e-3));
        return k % 2 ? -1.0 : 1.0;
    };
    move(body, [&](const ColumnVector<dim>& X) -> ColumnVector<dim> {
        ColumnVector<dim> u = ColumnVector<dim>::Zero();
        u[0] = 1e-6 * sign(X);
        return u;
    });
    prepare(CompressibleNeoHookean{}, first_piola_stress, body);
    prepare(TotalLagrangianForce<>::Prepare{}, corrected_piola_stress, body);
    const auto& centre = body[body.size() / 2];
    const double s = sign(plain(centre[reference_position]));
    const double pairs = s * plain(sum(Term::Push{}, centre, body))[0];
    const double gradients = s * plain(sum(TotalLagrangianForce<>::Push{}, centre, body))[0];
    const double stiffness = -pairs / (1e-6 * G / (950 * 1e-6)); // in G/(rho spacing^2)
    CAPTURE(stiffness, gradients / pairs);
    CHECK(stiffness > 1);
    CHECK(std::abs(gradients) < 1e-6 * std::abs(pairs));
}

} // namespace

TEST_CASE("PairwiseShearForce is its equation, equal and opposite to the last bit") {
    check_equation<2>();
    check_equation<3>();
}
TEST_CASE("PairwiseShearForce: none at rest, none from a rotation") {
    check_rest_and_rotation<2>();
    check_rest_and_rotation<3>();
}
TEST_CASE("PairwiseShearForce: a shear gives the Laplacian of the displacement") {
    check_shear<2>();
    check_shear<3>();
}
TEST_CASE("PairwiseShearForce resists displacements that alternate from particle to particle") {
    check_alternating<2>();
    check_alternating<3>();
}

} // namespace pairwise_shear_test
