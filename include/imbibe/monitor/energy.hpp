// Sums over the particles of a phase: energy, momentum, mass. In double, in a fixed order.
#pragma once

#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solver/solver.hpp>

namespace imbibe {

// Advice, printed as a template argument.
struct list_a_law_with_stored_energy_such_as_CompressibleNeoHookean;

namespace rules {
/// Rule: the elastic energy is that of a phase with a law that says what a deformation stores.
template <class Phase, class Advice>
struct NoStoredEnergy {
    static_assert(sizeof(Phase) == 0, "imbibe: elastic_energy: no term of this phase has a stored_energy");
};
} // namespace rules

namespace detail {
/// sum over the particles of f(i), in double and in the order of storage.
template <class View, class F>
double particle_sum(const View& phase, const F& f) {
    double total = 0;
    for (int i = 0; i < phase.size(); ++i)
        total += f(i);
    return total;
}

/// Does the term say what a deformation of the solid stores? Only one that suits it is asked.
template <int dim, class Solid, class Term>
concept HasStoredEnergy = suits<Solid, Term> && requires(const Solid& solid, const Tensor<double, dim>& F) {
    Term::stored_energy(solid, F);
};
/// Does a term of a solid say what a deformation stores?
template <int dim, class Solid, class Terms>
inline constexpr bool has_stored_energy = false;
template <int dim, class Solid, class... Terms>
inline constexpr bool has_stored_energy<dim, Solid, TypeList<Terms...>> = (HasStoredEnergy<dim, Solid, Terms> || ...);

/// What the terms of a solid say that the deformation F stores, J/m^3 of the stress-free solid.
template <int dim, class Solid, class... Terms>
double stored_energy(const Solid& solid, const Tensor<double, dim>& F, TypeList<Terms...>) {
    double sum = 0;
    const auto add = [&]<class Term>(std::type_identity<Term>) {
        if constexpr (HasStoredEnergy<dim, Solid, Term>)
            sum += Term::stored_energy(solid, F);
    };
    (add(std::type_identity<Terms>{}), ...);
    return sum;
}

/// sum_a V_a psi(F_a), J, with the stress-free volumes. A particle whose deformation was not computed yet, which is 0,
/// counts for nothing.
template <int dim, class View, class Density>
double sum_over_deformations(const View& phase, const Density& psi) {
    const auto m = phase[mass];
    const auto F = phase[deformation_gradient];
    return particle_sum(phase, [&](int i) {
        if (F.row(i).isZero(0))
            return 0.0;
        Tensor<double, dim> f;
        for (int k = 0; k < f.size; ++k)
            f[k] = static_cast<double>(F(i, k));
        return static_cast<double>(m(i)) / phase.material().density * psi(f);
    });
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

/// sum_a V_a psi(F_a), J: what a total-Lagrangian solid stores, with the energy density psi of its law
/// (StVenantKirchhoff::stored_energy, CompressibleNeoHookean::stored_energy, IsochoricNeoHookean::stored_energy);
/// nothing for particles that are not deformed yet, before their first step. Without hourglass control. Does not
/// compile for a phase whose terms have none, as those of VolumetricDeviatoric, whose energy is not that of single
/// particles.
template <int dim, class View>
double elastic_energy(const View& phase) {
    using Solid = std::remove_cvref_t<decltype(phase.material())>;
    if constexpr (!detail::has_stored_energy<dim, Solid, typename Solid::terms>)
        detail::break_rule<
            rules::NoStoredEnergy<Solid, list_a_law_with_stored_energy_such_as_CompressibleNeoHookean>>();
    return detail::sum_over_deformations<dim>(phase, [&](const Tensor<double, dim>& F) {
        return detail::stored_energy<dim>(phase.material(), F, typename Solid::terms{});
    });
}

/// What a phase stores, J, as far as that is known: a total-Lagrangian solid its `elastic_energy`, by
/// IsochoricNeoHookean's law where its own says none, as those of VolumetricDeviatoric and PairwiseShearForce; any
/// other phase with a density its `compression_energy`, and with a stress rate its `shear_energy`. Without hourglass
/// control and what repulsions store; by `compression_energy` also where the equation of state is not linear.
template <class View>
double stored_energy(const View& phase) {
    using State = std::remove_cvref_t<decltype(phase.state)>;
    using Phase = std::remove_cvref_t<decltype(phase.material())>;
    constexpr int dim = std::remove_cvref_t<decltype(phase[position])>::ColsAtCompileTime;
    if constexpr (State::template stores<DeformationGradientField>) {
        if constexpr (detail::has_stored_energy<dim, Phase, typename Phase::terms>)
            return elastic_energy<dim>(phase);
        else if constexpr (!detail::suits<Phase, IsochoricNeoHookean>)
            return 0; // of a phase whose terms are an error of its own
        else
            return detail::sum_over_deformations<dim>(phase, [&](const Tensor<double, dim>& F) {
                return IsochoricNeoHookean::stored_energy<dim>(phase.material(), F);
            });
    } else {
        double energy = 0;
        if constexpr (State::template stores<Density>)
            energy += compression_energy(phase);
        if constexpr (State::template stores<DeviatoricStress> && requires { phase.material().shear_modulus; })
            energy += shear_energy<dim>(phase);
        return energy;
    }
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
