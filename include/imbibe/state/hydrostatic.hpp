// A liquid that starts with its hydrostatic pressure.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/fields.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/core/rule.hpp>

#include <algorithm>
#include <cmath>

namespace imbibe {

// Advice, printed as a template argument.
struct add_an_equation_of_state_with_density_at_such_as_Tait;

namespace rules {
/// Rule: a phase that starts with hydrostatic pressure has a term that gives its density at a pressure.
template <class Phase, class Advice>
struct NoDensityAtAPressure {
    static_assert(sizeof(Phase) == 0,
                  "imbibe: start_hydrostatic: no term of this phase says its density at a pressure");
};
} // namespace rules

namespace detail {

// The density at which a material has a pressure, kg/m^3, by its equation of state.
template <class Material, class... Terms>
double density_at(const Material& material, double p, TypeList<Terms...>) {
    if constexpr (!(requires { Terms::density_at(material, p); } || ...))
        break_rule<rules::NoDensityAtAPressure<Material, add_an_equation_of_state_with_density_at_such_as_Tait>>();
    double found = 0;
    const auto ask = [&]<class Term>(std::type_identity<Term>) {
        if constexpr (requires { Term::density_at(material, p); })
            found = Term::density_at(material, p);
    };
    (ask(std::type_identity<Terms>{}), ...);
    return found;
}

// The pressure at a depth under a surface with a given pressure, dp/d(depth) = rho(p) g, Pa. @param g of gravity, m/s^2
template <class Material>
double hydrostatic_pressure(const Material& material, double g, double depth, double at_the_surface) {
    constexpr int steps = 8; // Runge-Kutta steps; one would do for water, but not for a gas
    const double h = depth / steps;
    const auto slope = [&](double p) { return g * density_at(material, p, typename Material::terms{}); };
    double pressure = at_the_surface;
    for (int k = 0; k < steps; ++k) {
        const double a = slope(pressure), b = slope(pressure + 0.5 * h * a), c = slope(pressure + 0.5 * h * b),
                     d = slope(pressure + h * c);
        pressure += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return pressure;
}

} // namespace detail

/// Gives the particles of a liquid the pressure of what stands above them: the density rho at which its equation of
/// state has the pressure p of dp/d(depth) = rho g, and the mass that goes with it, rho V with the volume V that the
/// particle had. To be called once, after the particles were added and before the first step:
/// <!-- examples/guides/moving_wall.cpp -->
/// ```
/// sph::start_hydrostatic(scene, water, depth);
/// ```
/// Without it a liquid starts with no pressure at all, falls into its own springs, and the pressure swings between
/// nothing and twice its mean for seconds of run time. What is above the surface has the pressure of the surface.
///
/// The mass changes with the density because the volume m/rho must stay that of the lattice: denser particles of the
/// same mass would be too small, and the liquid would still fall a little. So the mass grows, by a share of
/// g depth/(2 c^2): a quarter of a per cent where c^2 = 200 g depth.
///
/// A user's equation of state takes part if it has `static double density_at(const auto& material, double p)`, kg/m^3,
/// at the pressure p in Pa.
///
/// Not for a column that is released at once (a dam break), whose pressure is another one. Not where the liquid does
/// not rest, layer by layer, on a wall or on a denser liquid. Of two liquids, one above the other, the lower one has a
/// pressure at its surface: the weight of the upper one, rho g times its height.
///
/// @param scene the scene
/// @param phase the liquid: what Solver::add returned
/// @param surface how high the surface stands, m, measured upwards (against Settings::gravity) from the origin of the
/// coordinates: with gravity along -y simply its y
/// @param at_the_surface the pressure there, Pa, above that of UnderPressure
/// @throws Error for a scene without gravity or with a period along it, a liquid without particles, and a surface that
/// is not a finite number, below all of them, or so high above them that the lowest would have more than 3 times its
/// density; a pressure there that is negative or not finite
///
/// Source: hydrostatics; that mass and density go together: the case still-water of docs/validation.md.
template <class Scene, class Phase>
void start_hydrostatic(Scene& scene, Phase phase, double surface, double at_the_surface = 0) {
    using Real = typename Scene::Real;
    constexpr int dim = Scene::dimension;
    const auto& settings = scene.settings();
    double g = 0, offset = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        g = std::hypot(g, settings.gravity[d]);
        offset -= settings.gravity[d] * settings.origin[d];
        require(settings.gravity[d] == 0 || settings.periodic_length[d] == 0,
                "start_hydrostatic: gravity has the component ", settings.gravity[d],
                " m/s^2 along a periodic side, where nothing has a depth; set it to 0, or the "
                "period in that direction");
    }
    require(g > 0, "start_hydrostatic: the scene has no gravity, so no depth has a pressure; give Settings::gravity");
    offset /= g;

    const auto view = scene[phase];
    const auto& material = view.material();
    const auto x = view[position];
    auto rho = view[density];
    auto m = view[mass];
    const auto height = [&](int i) {
        double up = 0;
        for (int d = 0; d < dim; ++d)
            up -= settings.gravity[static_cast<std::size_t>(d)] * static_cast<double>(x(i, d));
        return up / g + offset;
    };
    require(view.size() > 0, "start_hydrostatic: the phase has no particles; add them before");
    double lowest = height(0), highest = lowest;
    for (int i = 1; i < view.size(); ++i) {
        lowest = std::min(lowest, height(i));
        highest = std::max(highest, height(i));
    }
    require(std::isfinite(surface) && surface > lowest, "start_hydrostatic: surface = ", surface,
            " m; it must be a finite number above the lowest particle, ", lowest,
            " m, usually half a spacing above the highest, ", highest, " m");
    require_not_negative(at_the_surface, "start_hydrostatic", "at_the_surface", "Pa");
    const auto density_under = [&](double depth) {
        const double p = detail::hydrostatic_pressure(material, g, std::max(depth, 0.0), at_the_surface);
        return detail::density_at(material, p, typename std::remove_cvref_t<decltype(material)>::terms{});
    };
    const double densest = density_under(surface - lowest) / material.density;
    require(densest <= 3, "start_hydrostatic: under a surface at ", surface, " m the lowest particle, at ", lowest,
            " m, would have ", densest, " times the density at rest; at most 3 are taken for meant. Is the surface in ",
            "metres (the highest particle is at ", highest, " m), and the sound speed, ", material.sound_speed,
            " m/s, high enough?");
    for (int i = 0; i < view.size(); ++i) {
        const double after = density_under(surface - height(i));
        m(i) = static_cast<Real>(static_cast<double>(m(i)) * after / static_cast<double>(rho(i)));
        rho(i) = static_cast<Real>(after);
    }
}

} // namespace imbibe
