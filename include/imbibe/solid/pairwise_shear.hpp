// An elastic solid without hourglass modes: its shear force is made of the displacements of each pair.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/first_piola.hpp>
#include <imbibe/solid/neo_hookean.hpp>

namespace imbibe {

/// s J^(-2/3), without unit, with the stress share s of ReferenceCorrection.
struct ShearScale : Field<Rank::scalar> {
    static constexpr std::string_view name = "shear_scale", unit = "1";
};
inline constexpr ShearScale shear_scale{};

/// s times the isotropic part of the Kirchhoff stress times F^-T, Pa: a particle's contribution to the force of
/// PairwiseShearForce.
struct IsotropicPiolaStress : Field<Rank::tensor> {
    static constexpr std::string_view name = "isotropic_piola_stress", unit = "Pa";
};
inline constexpr IsotropicPiolaStress isotropic_piola_stress{};

/// Coefficients of PairwiseShearForce.
struct PairwiseShearForceParameters {
    /// Factor on the shear modulus. The source has 1.07; with 1 the shear of a fine lattice is G.
    double factor = 1.07;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(factor, where, "PairwiseShearForceParameters::factor", "");
    }
};

/// dv_a/dt = sum_b m_b/(rho_0a rho_0b) [(T_a + T_b) grad_a W_ab + factor G (J_a^(-2/3) + J_b^(-2/3)) F_ab x_ab], in
/// m/s^2, both parts times the stress share s of each, with the kernel gradient grad_a W_ab = F_ab X_ab of the
/// stress-free solid, the present offset x_ab, and
///
///     T = [K/2 (J^2 - 1) - factor G J^(-2/3) I_1/3] F^-T,   J = det F, I_1 = tr F^T F (plus 1 in 2D: plane strain).
///
/// A neo-Hookean solid, law and force in one: it replaces IsochoricNeoHookean, whose stress it has with G times factor,
/// and TotalLagrangianForce. In a continuum the second part is the divergence of factor G J^(-2/3) F, the shear part of
/// P, written as the Laplacian of the motion. It uses the offsets of the pairs, so it resists every motion, and
/// HourglassControl is not needed. Undeformed, the two parts cancel pair by pair.
///
/// For solids that are hit, twisted or bent hard. In a column twisted by a revolution (nu 0.499) the displacements
/// deviate from the mean of their neighbours by 0.035 spacings, as a smooth twist does; with CompressibleNeoHookean and
/// HourglassControl by 0.18.
///
/// Not with a support below 2 spacings: the lattice sum of the Laplacian is not corrected, and with the factor 1.07 the
/// effective shear modulus for slow shear on a square (cubic) lattice is 0.70 G (0.71 G) with 1.5 spacings, 1.04 G
/// (1.05 G) with 2 and with 2.6.
///
/// Not without TotalLagrangianViscosity where the solid keeps moving: the swinging plate of the reference cases, six
/// particles thick, gains energy however short the steps are, and bursts in its first period; with the viscosity it
/// keeps swinging. Not where energy must be conserved to round-off: unlike TotalLagrangianForce it is not the
/// derivative of an energy (the gradients in the force are not corrected, those in F are). The shear part is central
/// and conserves angular momentum; the isotropic one conserves it only as well as the gradients allow. Not for stresses
/// at free surfaces: there, too, the gradients are not corrected.
///
/// Source: the "essentially non-hourglass" formulation of Wu, Zhang, Tang and Hu (2023), as it stands in their
/// program SPHinXsys; there J^(-2/d) and tr(F F^T)/d in d dimensions, here plane strain in 2D.
template <class Kernel = WendlandC2>
struct PairwiseShearForce {
    using effect = effects::pressure_force;
    static constexpr bool of_solids = true;
    using Parameters = PairwiseShearForceParameters;

    struct Prepare {
        using reads = Fields<deformation_gradient, stress_share>;
        using sets = Fields<shear_scale, isotropic_piola_stress>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            using T = typename A::Scalar;
            const auto F = a[deformation_gradient];
            const T J = max(determinant(F), T(1e-3));
            const T scale = pow(J, -2.0 / 3);
            const T I1 = trace(transpose(F) * F) + T(3 - A::dimension); // the third stretch of plane strain is one
            const T shear = T(parameters.factor * a.material.shear_modulus) * scale;
            const T isotropic = T(0.5 * a.material.bulk_modulus()) * (sq(J) - 1) - shear * I1 / 3;
            const T share = a[stress_share];
            return values(share * scale, (share * isotropic / J) * transpose(adjugate(F)));
        }
    };
    struct Push {
        using neighbourhood = Reference;
        using reads = Fields<mass, displacement, shear_scale, isotropic_piola_stress>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            using V = std::remove_cvref_t<decltype(ab.offset)>;
            const V now = ab.offset + (a[displacement] - b[displacement]);
            const double modulus = 0.5 * (a.material.shear_modulus + b.material.shear_modulus);
            const auto shear = parameters.factor * modulus * (a[shear_scale] + b[shear_scale]);
            const double per_mass = 1 / (a.material.density * b.material.density);
            return (per_mass * b[mass] * ab.gradient(Kernel{})) *
                   ((a[isotropic_piola_stress] + b[isotropic_piola_stress]) * ab.offset + shear * now);
        }
    };
    using parts = Parts<Displacement, Prepare, Push>;
    using reductions = Parts<ElasticEnergy<IsochoricNeoHookean>>; // nearly

    static constexpr const char* limit_name = "elastic wave";
    /// The limit of CompressibleNeoHookean, s, with the wave speed for a `factor` above that of the source.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double K = material.bulk_modulus(), shear = 4 * material.shear_modulus / 3;
        const double more = std::max(parameters.factor / Parameters{}.factor, 1.0);
        return detail::elastic_wave_limit(material, in) * std::sqrt((K + shear) / (K + more * shear));
    }
};

} // namespace imbibe
