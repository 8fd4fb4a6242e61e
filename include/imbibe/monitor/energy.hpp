// Sums over the particles of a phase: energy, momentum, mass. In double, in a fixed order.
#pragma once

#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solver/solver.hpp>

namespace imbibe {

namespace detail {
/// sum over the particles of f(i), in double and in the order of storage.
template <class View, class F>
double particle_sum(const View& phase, const F& f) {
    double total = 0;
    for (int i = 0; i < phase.size(); ++i)
        total += f(i);
    return total;
}
} // namespace detail

/// sum_a m_a |v_a|^2 / 2, J.
template <class View>
double kinetic_energy(const View& phase) {
    const auto m = phase[mass];
    const auto v = phase[velocity];
    return detail::particle_sum(
        phase, [&](int i) { return 0.5 * static_cast<double>(m(i)) * v.row(i).template cast<double>().squaredNorm(); });
}

/// - sum_a m_a g.x_a, J, with the origin as zero.
template <class View, std::size_t dim>
double potential_energy(const View& phase, const std::array<double, dim>& gravity) {
    const auto m = phase[mass];
    const auto x = phase[position];
    return detail::particle_sum(phase, [&](int i) {
        double height = 0;
        for (std::size_t d = 0; d < dim; ++d)
            height -= gravity[d] * static_cast<double>(x(i, static_cast<Eigen::Index>(d)));
        return static_cast<double>(m(i)) * height;
    });
}

/// sum_a m_a c^2 (rho_a - rho_0)^2 / (2 rho_0^2), J: what the linear equation of state stores.
template <class View>
double compression_energy(const View& phase) {
    const auto m = phase[mass];
    const auto rho = phase[density];
    const double rest = phase.material().density, c = phase.material().sound_speed;
    return detail::particle_sum(phase, [&](int i) {
        return 0.5 * static_cast<double>(m(i)) * sq(c * (static_cast<double>(rho(i)) / rest - 1));
    });
}

/// sum_a (m_a/rho_a) S_a:S_a / (4 G), J, with the deviatoric stress S: what a solid with a stress rate (JaumannStress)
/// stores by its shear; by its volume it stores `compression_energy`. For small strains. In two dimensions, plane
/// strain, with S_zz = -(S_xx + S_yy).
template <int dim, class View>
double shear_energy(const View& phase) {
    const auto m = phase[mass];
    const auto rho = phase[density];
    const auto S = phase[deviatoric_stress];
    const double G = phase.material().shear_modulus;
    return detail::particle_sum(phase, [&](int i) {
        double squares = 0, trace = 0;
        for (int row = 0, k = 0; row < dim; ++row)
            for (int column = row; column < dim; ++column, ++k) {
                const double s = static_cast<double>(S(i, k));
                squares += (row == column ? 1 : 2) * sq(s);
                trace += row == column ? s : 0;
            }
        return static_cast<double>(m(i)) / static_cast<double>(rho(i)) * (dim == 2 ? squares + sq(trace) : squares) /
               (4 * G);
    });
}

/// sum_a V_a (lambda tr(E)^2 / 2 + mu E:E), J, with the Green strain E = (F^T F - 1)/2: the elastic energy of a
/// total-Lagrangian St. Venant-Kirchhoff solid.
template <int dim, class View>
double elastic_energy(const View& phase) {
    const auto m = phase[mass];
    const auto F = phase[deformation_gradient];
    const auto& material = phase.material();
    const double mu = material.shear_modulus, lambda = material.bulk_modulus() - 2 * mu / 3;
    return detail::particle_sum(phase, [&](int i) {
        Eigen::Matrix<double, dim, dim> f;
        for (int r = 0; r < dim; ++r)
            for (int c = 0; c < dim; ++c)
                f(r, c) = F(i, r * dim + c);
        const Eigen::Matrix<double, dim, dim> E =
            0.5 * (f.transpose() * f - Eigen::Matrix<double, dim, dim>::Identity());
        return m(i) / material.density * (0.5 * lambda * sq(E.trace()) + mu * E.squaredNorm());
    });
}

/// sum_a m_a v_a, kg m/s.
template <class View>
auto momentum(const View& phase) {
    const auto m = phase[mass];
    const auto v = phase[velocity];
    Eigen::Matrix<double, std::remove_cvref_t<decltype(v)>::ColsAtCompileTime, 1> total;
    total.setZero();
    for (int i = 0; i < phase.size(); ++i)
        total += static_cast<double>(m(i)) * v.row(i).transpose().template cast<double>();
    return total;
}

} // namespace imbibe
