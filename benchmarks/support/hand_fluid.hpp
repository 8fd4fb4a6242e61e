// The loops of the benchmarks' fluid written by hand: what the library's generic loops are measured against. Same
// packs, same runs, same formulas, but no terms, no fields and no schedule: everything stands where it is needed once.
#pragma once

#include "fluid.hpp"

#include <imbibe/search/runs.hpp>
#include <imbibe/solver/sweep.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace imbibe::bench {

template <class Real>
class HandFluid {
public:
    static constexpr int width = native_width<Real>;
    /// Operations for one neighbour if all is done in one sweep, as they stand in `sweep`: additions, multiplications,
    /// maxima, quotients and roots count one each.
    static constexpr double operations_per_neighbour = 44;

    std::array<std::vector<Real>, 3> acceleration;
    std::vector<Real> density_rate, density;

    /// Reads the particles and the runs of `engine` where they are; they must stay there.
    template <class Phase, class Engine>
    HandFluid(std::type_identity<Phase>, const Engine& engine) {
        const auto& s = engine.template state<Phase>();
        const auto& parameters = s.material.coefficients.template get<MonaghanViscosityParameters>();
        const auto& link = engine.template link<Phase, Phase, false>();
        n = s.size();
        runs = &link.runs;
        support = link.support;
        rest_density = s.material.density;
        sound_speed = s.material.sound_speed;
        alpha = parameters.alpha;
        beta = parameters.beta;
        for (std::size_t d = 0; d < 3; ++d) {
            x[d] = s.field(position) + d * s.stride();
            v[d] = s.field(velocity) + d * s.stride();
            gravity[d] = static_cast<Real>(engine.gravity[static_cast<int>(d)]);
            acceleration[d].resize(static_cast<std::size_t>(n));
        }
        mass_ = s.field(imbibe::mass);
        density.assign(s.field(imbibe::density), s.field(imbibe::density) + n + 64);
        density_rate.resize(static_cast<std::size_t>(n));
        pressure_term.resize(static_cast<std::size_t>(n) + 64);
    }

    /// What the library does for `Water` in a step of length dt, the search and the motion left out.
    void two_sweeps(Real dt) {
        clear();
        sweep<true, false>();
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
            density[i] += dt * density_rate[i];
        equation_of_state();
        sweep<false, true>();
    }
    /// What it does for `WaterInOneSweep`.
    void one_sweep() {
        clear();
        equation_of_state();
        sweep<true, true>();
    }

private:
    int n = 0;
    std::array<const Real*, 3> x{}, v{};
    const Real* mass_ = nullptr;
    std::array<Real, 3> gravity{};
    const search::RunList* runs = nullptr;
    double support = 0, rest_density = 0, sound_speed = 0, alpha = 0, beta = 0;
    std::vector<Real> pressure_term; // p/rho^2

    void clear() {
        std::fill(density_rate.begin(), density_rate.end(), Real(0));
        for (std::size_t d = 0; d < 3; ++d)
            std::fill(acceleration[d].begin(), acceleration[d].end(), gravity[d]);
    }
    void equation_of_state() {
        const Real scale = static_cast<Real>(sound_speed * sound_speed / 7), rho_0 = static_cast<Real>(rest_density);
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            const Real rho = density[i], ratio = rho / rho_0;
            Real terms = 1;
            for (int k = 1; k < 7; ++k)
                terms = 1 + ratio * terms;
            pressure_term[i] = scale * (rho - rho_0) * terms / (rho * rho);
        }
        std::fill_n(pressure_term.begin() + n, 64, pressure_term[static_cast<std::size_t>(n) - 1]);
    }

    template <bool with_density, bool with_force>
    void sweep() {
        using T = Pack<Real, width>;
        const double H = support;
        // grad W = -20 normalisation/H^5 (1 - r/H)^3 x_ab; the constant comes in when the sums are complete.
        const Real slope = static_cast<Real>(-20 * WendlandC2::normalisation<3>() / power<5>(H));
        const T inverse(1 / H), epsilon(0.01 * H * H);
        const T linear(2 * alpha * sound_speed * H), quadratic(2 * beta * H * H);
        const detail::LeastDistances<Real, width> least(H);
        for (int i = 0; i < n; ++i) {
            const T x0(x[0][i]), x1(x[1][i]), x2(x[2][i]), v0(v[0][i]), v1(v[1][i]), v2(v[2][i]);
            const auto own = static_cast<std::size_t>(i);
            const T own_density(density[own]), own_pressure(pressure_term[own]);
            T rate(0), a0(0), a1(0), a2(0);
            for (const search::Run run : (*runs)[i]) {
                const std::size_t j = run.first();
                const T d0 = x0 - T::load(x[0] + j), d1 = x1 - T::load(x[1] + j), d2 = x2 - T::load(x[2] + j); // 3
                T r2 = d0 * d0 + d1 * d1 + d2 * d2;                                                            // 5
                r2 = max(r2, least.squared(run.count()));
                const T rest = positive_part(T(1) - sqrt(r2) * inverse);    // 4
                const T weight = T::load(mass_ + j) * (rest * rest * rest); // 3
                const T approach =
                    (v0 - T::load(v[0] + j)) * d0 + (v1 - T::load(v[1] + j)) * d1 + (v2 - T::load(v[2] + j)) * d2; // 8
                if constexpr (with_density)
                    rate += weight * approach; // 2
                if constexpr (with_force) {
                    const T meeting = negative_part(approach), away = r2 + epsilon;                            // 2
                    const T Pi = meeting * (quadratic * meeting - linear * away) /                             // 5
                                 (away * away * (own_density + T::load(density.data() + j)));                  // 3
                    const T push = weight * (own_pressure + T::load(pressure_term.data() + j) + Pi);           // 3
                    a0 += push * d0, a1 += push * d1, a2 += push * d2;                                         // 6
                }
            }
            if constexpr (with_density)
                density_rate[own] += slope * sum(rate);
            if constexpr (with_force) {
                acceleration[0][own] -= slope * sum(a0);
                acceleration[1][own] -= slope * sum(a1);
                acceleration[2][own] -= slope * sum(a2);
            }
        }
    }
};

} // namespace imbibe::bench
