// The pressure of a wall or a solid, extrapolated from the fluid in front of it.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// sum_f W_af, 1/m^3 (1/m^2 in 2D): how much fluid a wall particle sees.
struct ExtrapolationWeight : Field<Rank::scalar> {
    static constexpr std::string_view name = "extrapolation_weight", unit = "1/m^3";
};
inline constexpr ExtrapolationWeight extrapolation_weight{};

/// sum_f (p_f + rho_f g.(x_a - x_f)) W_af, Pa/m^3.
struct ExtrapolationSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "extrapolation_sum", unit = "Pa/m^3";
};
inline constexpr ExtrapolationSum extrapolation_sum{};

/// Coefficients of PressureExtrapolation.
struct PressureExtrapolationParameters {
    /// May the wall pull? If not, its pressure is clipped at zero, and the fluid can leave it. Only together with
    /// DensityFloor: clipping alone lets the fluid swell without limit.
    bool suction = true;

    /// Are the two the same?
    bool operator==(const PressureExtrapolationParameters&) const = default;
};

/// p_a = sum_f (p_f + rho_f g.(x_a - x_f)) W_af / sum_f W_af, in Pa, for a particle a of a wall or a solid and the
/// particles f of the fluid; 0 where there is no fluid.
///
/// Goes into the wall or the solid: `Coupling<Water, Wall, Into<Wall, PressureExtrapolation<>>, VolumePressure<>,
/// Into<Water, VolumeContinuity<WendlandC2>>>`. Exact for still water, above, below and beside it. With several fluids
/// one coupling each, with the same coefficients; their sums are added before the division.
///
/// Not for a solid with an equation of state: that sets `pressure` already. Not exact for a solid that accelerates as
/// fast as the water falls: of the source's g - a_wall only g is used, which is right for still walls and for solids
/// whose acceleration is small compared with gravity.
///
/// Source: Adami, Hu and Adams (2012), Eq. (27).
template <class Kernel = WendlandC2>
struct PressureExtrapolation {
    using Parameters = PressureExtrapolationParameters;
    static constexpr bool one_sided = true;

    struct Sum { // a: wall or solid, b: fluid
        using reads = Fields<pressure, density>;
        using adds = Fields<extrapolation_weight, extrapolation_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = ab.value(Kernel{});
            return values(weight, weight * (b[pressure] + b[density] * dot(ab.gravity(), ab.offset)));
        }
    };
    struct Divide {
        using reads = Fields<extrapolation_weight, extrapolation_sum>;
        using sets = Fields<pressure>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto mean = a[extrapolation_sum] / max(a[extrapolation_weight], 1e-30);
            return parameters.suction ? mean : positive_part(mean);
        }
    };
    using parts = Parts<Sum, Divide>;
};

} // namespace imbibe
