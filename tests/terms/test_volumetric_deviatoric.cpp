// VolumetricDeviatoric: the force is the derivative of its energy; rotations, dilation, momentum; what it makes of a
// volume that alternates from particle to particle.
#include "cloud.hpp"

#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>

#include <Eigen/Dense>

namespace volumetric_deviatoric_test {

using namespace cloud;

namespace {

using Law = VolumetricDeviatoric<>;

constexpr double G = 2.7e4, K = 950 * 1e4; // Poisson's ratio 0.4986
Sponge rubber() {
    return {.density = 950, .sound_speed = 100, .shear_modulus = G, .support_radius = 2.1e-3, .spacing = 1e-3};
}
template <int dim>
using Body = Cloud<dim, Sponge>;

template <int dim>
Body<dim> jittered(int n, double jitter = 0.2) {
    auto body = block<dim>(rubber(), n, jitter, 1);
    gather(ReferenceCorrection<>::Moments{}, moment_matrix, body, body);
    prepare(ReferenceCorrection<>::Share{}, stress_share, body);
    prepare(ReferenceCorrection<>::Invert{}, gradient_correction, body);
    gather(Law::Weigh{}, average_weight, body, body);
    return body;
}
template <int dim>
void average(Body<dim>& body) {
    gather(Law::Sum{}, volume_ratio_sum, body, body);
    prepare(Law::Pressure{}, shared_mean_stress, body);
    gather(Law::Share{}, averaged_mean_stress, body, body);
}
template <int dim>
void stress(Body<dim>& body) {
    prepare(Displacement{}, displacement, body);
    gather(DeformationGradient<>::Sum{}, raw_displacement_gradient, body, body);
    prepare(DeformationGradient<>::Correct{}, deformation_gradient, body);
    prepare(Law::Volume{}, volume_ratio, body);
    average(body);
    prepare(Law::Stress{}, first_piola_stress, body);
    prepare(TotalLagrangianForce<>::Prepare{}, corrected_piola_stress, body);
}
template <int dim>
void shake(Body<dim>& body, double size) {
    Dice dice(9);
    for (auto& p : body)
        p.set(position, p[reference_position] + dice.vector<dim>(size));
    stress(body);
}
template <int dim>
void move_affinely(Body<dim>& body, const Matrix<dim>& F) {
    for (auto& p : body)
        p.set(position, vec<dim>(ColumnVector<dim>::Constant(7e-3) + F * plain(p[reference_position])));
    stress(body);
}

/// The energy of the doc comment, from the positions, with averages by hand.
template <int dim>
double energy_of(const Body<dim>& body) {
    const double V = std::pow(1e-3, dim);
    double total = 0;
    for (const auto& a : body) {
        double weight = 0, mean = 0;
        for (const auto& b : body) {
            const double q = (plain(a[reference_position]) - plain(b[reference_position])).norm() / 2.1e-3;
            const double w = q < 1 ? std::pow(1 - q * q, 3) : 0;
            weight += w;
            mean += w * plain(b[deformation_gradient]).determinant();
        }
        mean /= weight;
        const Matrix<dim> F = plain(a[deformation_gradient]);
        const double I1 = (F.transpose() * F).trace() + (dim == 2 ? 1 : 0);
        total += V * (G / 2 * (std::pow(F.determinant(), -2.0 / 3) * I1 - 3) +
                      K / 2 * ((mean * mean - 1) / 2 - std::log(mean)));
    }
    return total;
}

template <int dim>
void check_energy() {
    auto body = jittered<dim>(dim == 2 ? 5 : 3);
    shake(body, 1e-4);
    const auto energy = [](Body<dim> moved) {
        stress(moved);
        return energy_of(moved);
    };
    CHECK(worst_departure_from_slope(TotalLagrangianForce<>::Push{}, body, energy) < 1e-5);
    // momentum to the last bit, angular momentum to round-off
    CHECK(worst_imbalance(TotalLagrangianForce<>::Push{}, body, body) == 0);
    Matrix<dim> moment = Matrix<dim>::Zero();
    double scale = 0;
    for (const auto& p : body) {
        const ColumnVector<dim> x = plain(p[position]), f = plain(sum(TotalLagrangianForce<>::Push{}, p, body));
        moment += x * f.transpose() - f * x.transpose();
        scale += x.norm() * f.norm();
    }
    CHECK(moment.norm() < 1e-12 * scale);
}

template <int dim>
void check_affine() {
    auto body = jittered<dim>(4);
    Matrix<dim> R;
    if constexpr (dim == 2)
        R = Eigen::Rotation2Dd(2.1).toRotationMatrix();
    else
        R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    move_affinely<dim>(body, R);
    for (const auto& p : body)
        CHECK(plain(p[first_piola_stress]).norm() < 1e-11 * K);
    // A uniform compression at every particle, and the force at none of them differs from that of a uniform stress.
    // The stress averaged back is uniform only inside: at a face a particle stands in for those that are missing.
    auto still = jittered<dim>(9, 0);
    const double stretch = 0.99, J = std::pow(stretch, dim);
    move_affinely<dim>(still, stretch * R);
    const auto& centre = still[still.size() / 2];
    const Matrix<dim> sigma = plain(centre[first_piola_stress]) * stretch * R.transpose() / J;
    const double mean = K / 2 * (J - 1 / J), I1 = dim * stretch * stretch + (dim == 2 ? 1 : 0);
    const double shear = G * std::pow(J, -5.0 / 3) * (stretch * stretch - I1 / 3); // of plane strain; none in 3D
    CHECK((sigma - (mean + shear) * Matrix<dim>::Identity()).norm() < 1e-10 * K);
}

// J = 1 +- 0.01 on a square lattice.
void check_checkerboard() {
    auto body = block<2>(rubber(), 11, 0);
    for (auto& p : body)
        p.material.support_radius = 2e-3;
    gather(Law::Weigh{}, average_weight, body, body);
    for (std::size_t k = 0; k < body.size(); ++k)
        body[k].set(volume_ratio, 1 + 0.01 * (k % 2 == 0 ? 1 : -1));
    average(body);
    const auto& centre = body[body.size() / 2];
    const double mean = plain(centre[volume_ratio_sum]) / plain(centre[average_weight]) - 1;
    const double left = mean / 0.01, left_in_stress = plain(centre[averaged_mean_stress]) / (K * 0.01);
    CAPTURE(left, left_in_stress);
    CHECK(std::abs(left) < 0.07);
    CHECK(std::abs(left_in_stress) < 0.005);
}

// The same J everywhere: the mean stress of a particle relative to what it should be.
void check_faces() {
    auto body = block<2>(rubber(), 11, 0);
    for (auto& p : body) {
        p.material.support_radius = 2e-3;
        p.set(volume_ratio, 1.01);
    }
    gather(Law::Weigh{}, average_weight, body, body);
    average(body);
    const double expected = K / 2 * (1.01 - 1 / 1.01);
    const auto at = [&](std::size_t k) { return plain(body[k][averaged_mean_stress]) / expected; };
    CHECK(at(5 + 5 * 11) == Approx(1).epsilon(1e-12));
    CHECK(at(0 + 5 * 11) == Approx(0.94).margin(0.005)); // at a face, behind it, at a corner
    CHECK(at(1 + 5 * 11) == Approx(1.056).margin(0.005));
    CHECK(at(0) == Approx(0.88).margin(0.005));
}

} // namespace

TEST_CASE("VolumetricDeviatoric: the force is minus the derivative of the energy, and balanced") {
    check_energy<2>();
    check_energy<3>();
}
TEST_CASE("VolumetricDeviatoric: no stress from a rotation, the right one from a dilation") {
    check_affine<2>();
    check_affine<3>();
}
TEST_CASE("VolumetricDeviatoric: an alternating volume leaves hardly a trace in the mean stress") {
    check_checkerboard();
}
TEST_CASE("VolumetricDeviatoric: the mean stress at faces and corners is as good as the comment says") {
    check_faces();
}
TEST_CASE("VolumetricDeviatoric reads what it should, where it should") {
    CHECK(sides<Law::Weigh, 3, Sponge>() == "| mass");
    CHECK(sides<Law::Sum, 3, Sponge>() == "| mass volume_ratio");
    CHECK(sides<Law::Share, 3, Sponge>() == "| mass shared_mean_stress");
    CHECK(sides<Law::Pressure, 3, Sponge>() == "volume_ratio_sum average_weight |");
    CHECK(sides<Law::Stress, 2, Sponge>() == "deformation_gradient averaged_mean_stress |");
}

} // namespace volumetric_deviatoric_test
