// Sums over the particles of a phase: energy, momentum, mass. In double, in a fixed order.
#pragma once

#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/monitor/phase_energy.hpp>
#include <imbibe/solid/shear_energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/compression_energy.hpp>

namespace imbibe {

// Advice, printed as a template argument.
struct list_a_law_with_stored_energy_such_as_CompressibleNeoHookean;

namespace rules {
/// Rule: the elastic energy needs a phase whose law has a stored energy.
template <class Phase, class Advice>
struct NoStoredEnergy {
    static_assert(sizeof(Phase) == 0, "imbibe: elastic_energy: no term of this phase has a stored_energy");
};
} // namespace rules

namespace detail {
/// Does the term have a stored energy? Only a term that suits the solid is asked.
template <int dim, class Solid, class Term>
concept HasStoredEnergy = suits<Solid, Term> && requires(const Solid& solid, const Tensor<double, dim>& F) {
    Term::stored_energy(solid, F);
};
/// Does a term of a solid have a stored energy?
template <int dim, class Solid, class Terms>
inline constexpr bool has_stored_energy = false;
template <int dim, class Solid, class... Terms>
inline constexpr bool has_stored_energy<dim, Solid, TypeList<Terms...>> = (HasStoredEnergy<dim, Solid, Terms> || ...);

} // namespace detail

/// sum_a m_a |v_a|^2 / 2, J.
template <class View>
double kinetic_energy(const View& phase) {
    return detail::kinetic_energy_of(phase.state.store, 1);
}

/// - sum_a m_a g.x_a, J, with the origin as zero.
template <class View, std::size_t dim>
double potential_energy(const View& phase, const std::array<double, dim>& gravity) {
    return detail::potential_energy_of(phase.state.store, gravity, 1);
}

/// The sum of CompressionEnergy, J.
template <class View>
double compression_energy(const View& phase) {
    return detail::reduced_by<CompressionEnergy>(phase);
}

/// The sum of ShearEnergy, J: of a solid with a stress rate (JaumannStress). Its volumetric energy is
/// `compression_energy`.
template <int dim, class View>
double shear_energy(const View& phase) {
    return detail::reduced_by<ShearEnergy>(phase);
}

/// The energy that the terms of a phase store, J, by their reductions Sum<StoredEnergy>: CompressionEnergy of equations
/// of state, ShearEnergy of stress rates, ElasticEnergy of laws of total-Lagrangian solids (VolumetricDeviatoric and
/// PairwiseShearForce: that of IsochoricNeoHookean). Hourglass control and repulsions are not included.
template <class View>
double stored_energy(const View& phase) {
    return reduced<Sum<StoredEnergy>>(phase);
}

/// The same for a total-Lagrangian solid, by the energy density of its law (StVenantKirchhoff::stored_energy,
/// CompressibleNeoHookean::stored_energy, IsochoricNeoHookean::stored_energy). Does not compile for a phase whose terms
/// have none, such as VolumetricDeviatoric, whose energy is not that of single particles.
template <int dim, class View>
double elastic_energy(const View& phase) {
    using Solid = std::remove_cvref_t<decltype(phase.material())>;
    if constexpr (!detail::has_stored_energy<dim, Solid, typename Solid::terms>)
        detail::break_rule<
            rules::NoStoredEnergy<Solid, list_a_law_with_stored_energy_such_as_CompressibleNeoHookean>>();
    return stored_energy(phase);
}

/// sum_a m_a h_a, J: the heat of a phase with HeatCapacity or Melting above that at its reference temperature, or the
/// heat that a wall with a SurfaceTemperature has taken up. The sum over all phases of a scene without HeatFromWalls
/// and EnthalpyAdvection is constant.
template <class View>
double thermal_energy(const View& phase) {
    return reduced<Sum<ThermalEnergy>>(phase);
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
