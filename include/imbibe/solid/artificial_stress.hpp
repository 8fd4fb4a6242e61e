// The artificial stress that keeps the particles of a stretched solid from clumping.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>

#include <type_traits>

namespace imbibe {

/// Coefficients of ArtificialStress.
struct ArtificialStressParameters {
    /// How much of the tension is taken away between particles at their initial spacing. The paper leaves it open.
    double epsilon = 0.3;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(epsilon, where, "ArtificialStressParameters::epsilon", "");
    }
};

/// R/rho^2, Pa m^6/kg^2: what ArtificialStress prepares once per particle.
struct ArtificialStressOverDensity2 : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "artificial_stress_over_density2", unit = "Pa m^6/kg^2";
};
inline constexpr ArtificialStressOverDensity2 artificial_stress_over_density2{};

/// The tensile part of a stress, in the axes of the scene: every component by itself, negative ones as zero.
/// It depends on how the solid lies in these axes.
struct ComponentWise {
    /// That part of a stress, Pa.
    template <class T, int dim>
    IMBIBE_INLINE static constexpr SymmetricTensor<T, dim> tension(SymmetricTensor<T, dim> stress) {
        for (int k = 0; k < SymmetricTensor<T, dim>::size; ++k)
            stress[k] = positive_part(stress[k]);
        return stress;
    }
};

namespace detail {

/// sum_k max(lambda_k, 0) n_k n_k^T with the eigenvalues lambda_k of a symmetric tensor and their directions n_k.
SymmetricTensor<double, 2> positive_eigenpart(const SymmetricTensor<double, 2>& t);
SymmetricTensor<double, 3> positive_eigenpart(const SymmetricTensor<double, 3>& t);

template <class T, int dim>
SymmetricTensor<T, dim> principal_tension(const SymmetricTensor<T, dim>& stress) {
    SymmetricTensor<double, dim> one{};
    for (int k = 0; k < one.size; ++k)
        one[k] = static_cast<double>(stress[k][0]);
    one = positive_eigenpart(one);
    SymmetricTensor<T, dim> result{};
    for (int k = 0; k < one.size; ++k)
        result[k] = T(one[k]);
    return result;
}

} // namespace detail

/// The tensile part of a stress in its principal axes: sum_k max(lambda_k, 0) n_k n_k^T with the principal stresses
/// lambda_k and their directions n_k. It turns with the solid. Computed in double whatever the number type.
struct PrincipalAxes {
    /// That part of a stress, Pa.
    template <class T, int dim>
    static constexpr SymmetricTensor<T, dim> tension(const SymmetricTensor<T, dim>& stress) {
        if (std::is_constant_evaluated()) // only to see what a term reads: the value does not matter
            return ComponentWise::tension(stress);
        return detail::principal_tension(stress);
    }
};

/// dv_a/dt = sum_b m_b (R_a/rho_a^2 + R_b/rho_b^2) f_ab^n grad_a W_ab, in m/s^2, with R = -epsilon times the tensile
/// part of the Cauchy stress sigma = S - p 1, and f_ab = w(|x_a - x_b|)/w(spacing) for the kernel `FactorKernel`.
///
/// A repulsion that grows as two particles of a stretched solid come closer than their initial spacing: the cure of
/// the tensile instability of StressForce.
///
/// `Axes` is where tension is looked for: in PrincipalAxes (the default, after Gray, Monaghan and Swift; objective), or
/// ComponentWise in the scene's axes, as the paper prints Eq. (17), where the result depends on the orientation of the
/// axes.
///
/// Choose `FactorKernel` with care: with Spiky and n = 4 the factor is the 12th power of the distance to the rim. With
/// a spacing of half the support it is 32 at two thirds of the spacing and 4096 at contact, and a stretched sponge
/// blows apart. A broad bell is gentler: Poly6 gives 8 and 32, CubicSpline 24 and 256. The spacing must be smaller than
/// the support radius.
///
/// Not for fluids and not for total-Lagrangian solids, which have no tensile instability. Without strong tension
/// epsilon = 0 is more accurate.
///
/// Source: Monaghan (2000); Gray, Monaghan and Swift (2001); the paper, Eqs. (15), (17) and (18).
template <class Kernel, class Axes = PrincipalAxes, class FactorKernel = Kernel, int n = 4>
struct ArtificialStress {
    using Parameters = ArtificialStressParameters;

    struct Prepare {
        using reads = Fields<density, pressure, deviatoric_stress>;
        using sets = Fields<artificial_stress_over_density2>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto unit = symmetric_identity<typename A::Scalar, A::dimension>();
            const auto sigma = a[deviatoric_stress] - a[pressure] * unit;
            if (parameters.epsilon == 0) // finding principal axes takes longer than all the rest here
                return 0.0 * sigma;
            return -parameters.epsilon / sq(a[density]) * Axes::tension(sigma);
        }
    };
    struct Push {
        using reads = Fields<mass, artificial_stress_over_density2>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            if (parameters.epsilon == 0) // one branch for the whole sweep, and nothing of it is read
                return 0 * ab.offset;
            const double spacing = 0.5 * (a.material.spacing + b.material.spacing);
            const auto f = ab.relative_value(FactorKernel{}, spacing);
            return (b[mass] * power<n>(f) * ab.gradient(Kernel{})) *
                   ((a[artificial_stress_over_density2] + b[artificial_stress_over_density2]) * ab.offset);
        }
    };
    using parts = Parts<Prepare, Push>;

    /// Throws Error if the spacing is not below the support radius, so that the factor has no reference value.
    static void check(const auto& material, std::string_view where) {
        require(material.spacing < material.support_radius, where, ": the artificial stress compares with the kernel at "
                "the particle spacing, ", material.spacing, " m; that must be below the support radius, ",
                material.support_radius, " m");
    }
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solid/artificial_stress_code.hpp>
#endif
