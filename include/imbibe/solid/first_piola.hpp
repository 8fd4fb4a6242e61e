// The stress of a hyperelastic solid, and what its laws have in common.
#pragma once

#include <imbibe/core/term.hpp>

#include <algorithm>
#include <cmath>

namespace imbibe {

/// First Piola-Kirchhoff stress P, Pa: force in space per area of the stress-free solid. What a hyperelastic law sets.
struct FirstPiolaStress : Field<Rank::tensor> {
    static constexpr std::string_view name = "first_piola_stress", unit = "Pa";
};
inline constexpr FirstPiolaStress first_piola_stress{};

namespace detail {

// Lame's first constant, Pa: lambda = K - 2G/3, in space and in plane strain.
constexpr double lame_lambda(const auto& material) {
    return material.bulk_modulus() - 2 * material.shear_modulus / 3;
}

// The time a longitudinal wave takes across a particle, or less: corrected gradients are steep at free corners, the
// more so the shorter the support r = H/spacing, and where the bulk modulus exceeds the shear modulus a corner swings
// in all directions at once. The factors lie below the exact limits, 2 over the highest frequency, of free cubes and
// squares, and with `few_layers` also of those only three or four particles thick, whose corners interact; not for
// particles at random positions (tests/terms/test_total_lagrangian.cpp). The limit includes the greatest speed because
// a speed near that of sound means strains near one, at which the laws stiffen. A body that is held at such strains and
// hardly moves is stiffer than this assumes, except with `stiffening`, the square of the fastest wave's speed there
// over that of the stress-free solid (finite_strain_limit.hpp).
// `thinness` is how much more gradients are corrected in the thickest part of the body than inside a large one. The
// numbers are fitted; `few_layers` is fitted with the true r, for bodies that are not thin, and only shortens the limit
// of thin ones.
double elastic_wave_limit(const auto& material, const TimeStepInput& in, double thinness = 1, double stiffening = 1) {
    const double lambda = lame_lambda(material), r = in.support_radius / in.spacing;
    const double bulky = std::max(lambda / (lambda + 2 * material.shear_modulus), 0.0); // nu/(1 - nu)
    const double most = (in.dimension == 3 ? std::min(r / 1.85, 1.0) : 1.0) / std::pow(thinness, 0.25);
    const double factor = std::sqrt(r / thinness / (in.dimension == 3 ? 1.2 + 1.5 * bulky : 0.9 + 1.1 * bulky));
    const double few_layers = std::min(std::clamp(1 - 0.35 * (2 - r), 0.9, 1.0), 1 - 0.11 * std::max(bulky - 0.5, 0.0));
    const double wave_speed = material.longitudinal_wave_speed() * std::sqrt(stiffening);
    return few_layers * std::min(factor, most) * in.spacing / (wave_speed + in.max_speed);
}

// The greatest sum of magnitudes in a row: an upper bound of the eigenvalues of a symmetric matrix (Gershgorin), which
// a diagonal matrix reaches.
template <class T, int n>
IMBIBE_INLINE constexpr T greatest_row_sum(const Tensor<T, n>& symmetric) {
    T greatest(0);
    for (int i = 0; i < n; ++i) {
        T sum(0);
        for (int j = 0; j < n; ++j)
            sum += max(symmetric(i, j), -symmetric(i, j));
        greatest = max(greatest, sum);
    }
    return greatest;
}

} // namespace detail
} // namespace imbibe
