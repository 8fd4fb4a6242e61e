// The heat equation on a solid: temperature flows between particles that were neighbours when the solid was free of
// stress. A cosine of temperature in a bar decays as it must, and no heat is lost.
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
using K = sph::WendlandC2;

/// Temperature, K.
struct Temperature : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
    static constexpr std::string_view rate_name = "temperature_rate", rate_unit = "K/s";
};
inline constexpr Temperature temperature{};
inline constexpr sph::Rate<Temperature> temperature_rate{};

/// The heat in all particles, J, for a capacity of 1 J/(kg K).
struct TotalHeat {
    static constexpr std::string_view name = "heat", unit = "J";
};

struct HeatParameters {
    double diffusivity = 1e-2; ///< kappa, m^2/s
};

/// dT_a/dt = 2 kappa sum_b V_b (T_a - T_b) F_ab with grad_a W_ab = F_ab (x_a - x_b). Source: Brookshaw (1985).
struct Heat {
    using Parameters = HeatParameters;
    using neighbourhood = sph::Reference; // those of the stress-free solid, found once
    using reads = sph::Fields<sph::mass, temperature>;
    using adds = sph::Fields<temperature_rate>;
    Parameters parameters{};

    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return (2 * parameters.diffusivity / b.material.density) * b[sph::mass] * (a[temperature] - b[temperature]) *
               ab.gradient(K{});
    }
    struct HeatOfParticle { // asked for by the program below, never in a step
        using reads = sph::Fields<sph::mass, temperature>;
        using reduces = sph::Sum<TotalHeat>;
        double operator()(const auto& a) const { return a[sph::mass] * a[temperature]; }
    };
    using reductions = sph::Parts<HeatOfParticle>;
    static constexpr const char* limit_name = "heat";
    static double time_step_limit(const auto&, const sph::TimeStepInput& in, const Parameters& heat) {
        return 0.5 * sph::sq(in.spacing) / heat.diffusivity;
    }
};

struct Bar : sph::Solid<Heat, sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                        sph::TotalLagrangianForce<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Bar>;

int main() {
    const double dx = 1.0 / 40, kappa = 0.1, end = 0.2;
    Scene scene({.support_radius = 3 * dx, .periodic_length = {1, 0.25}});
    Bar material{{.density = 1000, .sound_speed = 1, .shear_modulus = 300}};
    material.set(HeatParameters{.diffusivity = kappa});
    const auto bar = scene.add(material, sph::fill(sph::Box<2>({0, 0}, {1, 0.25}), dx), dx);
    auto view = scene[bar];
    const auto wave = [&](int i) { return std::cos(2 * std::numbers::pi * view[sph::position](i, 0)); };
    for (int i = 0; i < view.size(); ++i)
        view[temperature](i) = 300 + 10 * wave(i);
    const auto heat = [&] { return sph::reduced<sph::Sum<TotalHeat>>(scene[bar]); };
    const double before = heat();

    scene.run_until(end);
    double height = 0;
    for (int i = 0; i < view.size(); ++i)
        height += 2 * view[temperature](i) * wave(i) / view.size();
    const double expected = 10 * std::exp(-kappa * sph::sq(2 * std::numbers::pi) * end);
    std::printf("after %lld steps, limited by %s: %.4f K, expected %.4f K; heat gained %.1e of all\n", scene.steps(),
                scene.time_step_limits().front().reason.c_str(), height, expected, heat() / before - 1);
    return std::abs(height / expected - 1) < 0.02 && std::abs(heat() / before - 1) < 1e-12 ? 0 : 1;
}
