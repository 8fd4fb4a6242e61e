// An equation of state with a background pressure.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/state/linear_state.hpp>

#include <string_view>
#include <type_traits>

namespace imbibe {

struct DensityFloor; // fluid/density_floor.hpp, a folder above this one

/// Coefficients of UnderPressure.
struct UnderPressureParameters {
    /// p_b, Pa
    double background = 0;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(background, where, "UnderPressureParameters::background", "Pa");
    }
};

/// p = p_b + p of `State`, in Pa: at its reference density the fluid has the pressure p_b. For fluids that fill their
/// container. Particles of a fluid in tension form clumps; p_b prevents tension, whether from a flow (p_b of rho v^2)
/// or from an interface (1.5 sigma/spacing for InterfaceForce, three times the stress in it).
///
/// All fluids of a scene have the same p_b.
///
/// Not for a free surface: the fluid would spread. Not beside DensityFloor (an error), which lets no pressure fall
/// below p_b. Use it with CorrectedGradients: with VolumePressure particles under p_b resist shear.
///
/// Source: Morris, Fox and Zhu (1997); Hu and Adams (2006).
template <class State = LinearState>
struct UnderPressure {
    using Parameters = UnderPressureParameters;
    struct Add {
        using reads = typename State::reads;
        using sets = Fields<pressure>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return State{}(a) + parameters.background; }
    };
    using parts = Parts<Add>;

    /// The density at a pressure p above p_b, Pa: that of State, kg/m^3. So start_hydrostatic gives the surface p_b.
    static double density_at(const auto& material, double p) { return State::density_at(material, p); }
    /// Throws Error where DensityFloor stands beside it. @param owner the fluid, @param where its name in the message
    static void check(const auto& owner, std::string_view where) {
        using Terms = typename std::remove_cvref_t<decltype(owner)>::terms;
        const double background = owner.coefficients.template get<Parameters>().background;
        require(background == 0 || !detail::contains<DensityFloor, Terms>, where,
                ": UnderPressureParameters::background = ", background,
                " Pa beside DensityFloor, which lets no pressure fall below it; leave that out (of a method: "
                "Instead<DensityFloor>), or take 0 Pa");
    }

    using reductions = typename State::reductions;

    static constexpr const char* limit_name = State::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return State::time_step_limit(material, in);
    }
};

} // namespace imbibe
