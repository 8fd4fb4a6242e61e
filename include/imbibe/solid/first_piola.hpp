// The stress of a hyperelastic solid, and what its laws have in common.
#pragma once

#include <imbibe/core/term.hpp>

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

// The time sound takes across a particle. The greatest speed is in it because a speed near that of sound means
// strains near one, at which the laws stiffen.
double elastic_wave_limit(const auto& material, const TimeStepInput& in) {
    return in.spacing / (material.longitudinal_wave_speed() + in.max_speed);
}

} // namespace detail
} // namespace imbibe
