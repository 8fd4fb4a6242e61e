// The moments of a kernel's gradients over the existing neighbours, and the matrix that corrects the gradients with
// them.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/core/vector.hpp>

#include <algorithm>

namespace imbibe {

/// M_a = sum_b V_b (X_b - X_a) (x) grad_a W_ab, without unit: the identity deep inside, about half of it at a face.
struct MomentMatrix : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "moment_matrix", unit = "1";
};
inline constexpr MomentMatrix moment_matrix{};

/// L_a, the matrix that corrects the kernel gradients of particle a: L_a grad_a W_ab.
struct GradientCorrection : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "gradient_correction", unit = "1";
};
inline constexpr GradientCorrection gradient_correction{};

/// The greatest component of any L_a, which enters time step limits. A reduction of terms that correct gradients.
///
/// Not the greatest eigenvalue, which is up to the dimension times as much.
///
/// Source: own, fitted where it is used (CorrectedPressure).
struct GreatestCorrection {
    using reads = Fields<gradient_correction>;
    using reduces = Max<GradientCorrection>;

    double operator()(const auto& a) const {
        const auto L = a[gradient_correction];
        return *std::max_element(std::begin(L.c), std::end(L.c));
    }
};

namespace detail {

/// M^-1 where it is trusted, the identity where it is not, and a blend by the share `trust` in between.
template <class T, int dim>
struct GatedInverse {
    SymmetricTensor<T, dim> matrix;
    T trust; ///< from 0 to 1
};

// Trusts M^-1 if 1/|M^-1| is at least `full_above`, not if it is below `none_below`, with a linear ramp between.
template <class T, int dim>
IMBIBE_INLINE constexpr GatedInverse<T, dim> gated_inverse(const SymmetricTensor<T, dim>& moments, double full_above,
                                                           double none_below) {
    const auto M = full(moments);
    const auto cofactors = adjugate(M);
    T squares = T(0);
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            squares += sq(cofactors(i, j));
    const T size = max(sqrt(squares), T(1e-30)), det = determinant(M);
    const T trust = min(positive_part((det / size - none_below) / max(full_above - none_below, 1e-30)), T(1));
    const auto inverted = symmetric_part(cofactors / max(det, T(max(none_below, 1e-6)) * size));
    return {trust * inverted + (1 - trust) * symmetric_identity<T, dim>(), trust};
}

template <class T, int dim>
IMBIBE_INLINE constexpr SymmetricTensor<T, dim> inverse_or_identity(const SymmetricTensor<T, dim>& moments,
                                                                    double full_above, double none_below) {
    return gated_inverse(moments, full_above, none_below).matrix;
}

} // namespace detail

} // namespace imbibe
