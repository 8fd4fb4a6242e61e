// The loops of the benchmarks' hypoelastic solid written by hand, as hand_fluid.hpp has those of the fluid: same packs,
// same runs, same formulas, but no terms, no fields and no schedule.
#pragma once

#include <imbibe/core/phase.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/search/runs.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solver/sweep.hpp>
#include <imbibe/state/linear_state.hpp>

#include <array>
#include <vector>

namespace imbibe::bench {

/// The hypoelastic solid that is measured.
struct Hypoelastic : Solid<LinearState, Continuity<WendlandC2>, VelocityGradient<WendlandC2>, JaumannStress,
                           StressForce<WendlandC2>, MonaghanViscosity<WendlandC2>> {};

/// The numbers of a solid that is measured.
template <class Phase>
Phase rubber() {
    return Phase{{.density = 1000, .sound_speed = 30, .shear_modulus = 3e5}};
}

/// Its loops by hand: a sweep for the velocity gradient and the rate of density, the particles one by one, and a sweep
/// for the forces.
template <class Real>
class HandSolid {
public:
    static constexpr int width = native_width<Real>;

    std::array<std::vector<Real>, 3> acceleration;

    /// Reads the particles and the runs of `engine` where they are; they must stay there.
    template <class Engine>
    explicit HandSolid(const Engine& engine) {
        const auto& s = engine.template state<Hypoelastic>();
        const auto& link = engine.template link<Hypoelastic, Hypoelastic, false>();
        const auto& viscosity = s.material.coefficients.template get<MonaghanViscosityParameters>();
        n = s.size();
        runs = &link.runs;
        support = link.support;
        rest_density = s.material.density;
        sound_speed = s.material.sound_speed;
        shear_modulus = s.material.shear_modulus;
        alpha = viscosity.alpha;
        beta = viscosity.beta;
        const auto room = static_cast<std::size_t>(n) + 64;
        for (std::size_t d = 0; d < 3; ++d) {
            x[d] = s.field(position) + d * s.stride();
            v[d] = s.field(velocity) + d * s.stride();
            gravity[d] = static_cast<Real>(engine.gravity[static_cast<int>(d)]);
            acceleration[d].resize(room);
        }
        mass_ = s.field(imbibe::mass);
        density.assign(s.field(imbibe::density), s.field(imbibe::density) + room);
        density_rate.resize(room);
        for (std::size_t c = 0; c < 9; ++c)
            gradient[c].resize(room);
        for (std::size_t c = 0; c < 6; ++c) {
            stress[c].assign(s.field(deviatoric_stress) + c * s.stride(),
                             s.field(deviatoric_stress) + c * s.stride() + room);
            stress_over_density2_[c].resize(room);
        }
    }

    /// What the library does in a step of length dt, the search and the motion left out.
    void two_sweeps(Real dt) {
        sweep_gradient();
        particles(dt);
        sweep_force();
    }

private:
    int n = 0;
    std::array<const Real*, 3> x{}, v{};
    const Real* mass_ = nullptr;
    std::array<Real, 3> gravity{};
    const search::RunList* runs = nullptr;
    double support = 0, rest_density = 0, sound_speed = 0, shear_modulus = 0, alpha = 0, beta = 0;
    std::vector<Real> density, density_rate;
    std::array<std::vector<Real>, 9> gradient;
    std::array<std::vector<Real>, 6> stress, stress_over_density2_; // xx xy xz yy yz zz

    using T = Pack<Real, width>;
    /// grad W = slope (1 - r/H)^3 x_ab; the constant comes in when the sums are complete.
    Real slope() const { return static_cast<Real>(-20 * WendlandC2::normalisation<3>() / power<5>(support)); }

    void sweep_gradient() {
        const Real scale = slope();
        const T inverse(1 / support);
        const detail::LeastDistances<Real, width> least(support);
        for (int i = 0; i < n; ++i) {
            const T x0(x[0][i]), x1(x[1][i]), x2(x[2][i]), v0(v[0][i]), v1(v[1][i]), v2(v[2][i]);
            T rate(0), g[9];
            for (T& component : g)
                component = T(0);
            for (const search::Run run : (*runs)[i]) {
                const std::size_t j = run.first();
                const T d0 = x0 - T::load(x[0] + j), d1 = x1 - T::load(x[1] + j), d2 = x2 - T::load(x[2] + j);
                T r2 = d0 * d0 + d1 * d1 + d2 * d2;
                r2 = max(r2, least.squared(run.count()));
                const T rest = positive_part(T(1) - sqrt(r2) * inverse);
                const T weight = T::load(mass_ + j) * (rest * rest * rest);
                const T u0 = v0 - T::load(v[0] + j), u1 = v1 - T::load(v[1] + j), u2 = v2 - T::load(v[2] + j);
                rate += weight * (u0 * d0 + u1 * d1 + u2 * d2);
                const T volume = weight / T::load(density.data() + j);
                const T w0 = volume * u0, w1 = volume * u1, w2 = volume * u2;
                g[0] += w0 * d0, g[1] += w0 * d1, g[2] += w0 * d2;
                g[3] += w1 * d0, g[4] += w1 * d1, g[5] += w1 * d2;
                g[6] += w2 * d0, g[7] += w2 * d1, g[8] += w2 * d2;
            }
            const auto own = static_cast<std::size_t>(i);
            density_rate[own] = scale * sum(rate);
            for (std::size_t c = 0; c < 9; ++c)
                gradient[c][own] = -scale * sum(g[c]);
        }
    }

    void particles(Real dt) {
        const Real two_mu = static_cast<Real>(2 * shear_modulus), rho_0 = static_cast<Real>(rest_density),
                   stiffness = static_cast<Real>(sound_speed * sound_speed);
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            density[i] += dt * density_rate[i];
            const Real exx = gradient[0][i], eyy = gradient[4][i], ezz = gradient[8][i];
            const Real exy = (gradient[1][i] + gradient[3][i]) / 2, exz = (gradient[2][i] + gradient[6][i]) / 2,
                       eyz = (gradient[5][i] + gradient[7][i]) / 2;
            // The rotation Omega = (grad v - grad v^T)/2 has the components a (xy), b (xz) and c (yz).
            const Real a = (gradient[1][i] - gradient[3][i]) / 2, b = (gradient[2][i] - gradient[6][i]) / 2,
                       c = (gradient[5][i] - gradient[7][i]) / 2;
            const Real sxx = stress[0][i], sxy = stress[1][i], sxz = stress[2][i], syy = stress[3][i],
                       syz = stress[4][i], szz = stress[5][i];
            const Real third = (exx + eyy + ezz) / 3;
            const Real rate[6] = {two_mu * (exx - third) + 2 * (a * sxy + b * sxz),
                                  two_mu * exy + a * (syy - sxx) + b * syz + c * sxz,
                                  two_mu * exz + b * (szz - sxx) + a * syz - c * sxy,
                                  two_mu * (eyy - third) + 2 * (c * syz - a * sxy),
                                  two_mu * eyz + c * (szz - syy) - a * sxz - b * sxy,
                                  two_mu * (ezz - third) - 2 * (b * sxz + c * syz)};
            for (std::size_t k = 0; k < 6; ++k)
                stress[k][i] += dt * rate[k];
            const Real pressure = stiffness * (density[i] - rho_0), per = 1 / (density[i] * density[i]);
            for (std::size_t k = 0; k < 6; ++k)
                stress_over_density2_[k][i] =
                    (stress[k][i] - (k == 0 || k == 3 || k == 5 ? pressure : Real(0))) * per;
        }
    }

    void sweep_force() {
        const Real scale = slope();
        const double H = support;
        const T inverse(1 / H), epsilon(0.01 * H * H);
        const detail::LeastDistances<Real, width> least(H);
        const T linear(2 * alpha * sound_speed * H), quadratic(2 * beta * H * H);
        for (int i = 0; i < n; ++i) {
            const T x0(x[0][i]), x1(x[1][i]), x2(x[2][i]), v0(v[0][i]), v1(v[1][i]), v2(v[2][i]);
            const auto own = static_cast<std::size_t>(i);
            const T own_density(density[own]);
            T own_stress[6];
            for (std::size_t c = 0; c < 6; ++c)
                own_stress[c] = T(stress_over_density2_[c][own]);
            T a0(0), a1(0), a2(0);
            for (const search::Run run : (*runs)[i]) {
                const std::size_t j = run.first();
                const T d0 = x0 - T::load(x[0] + j), d1 = x1 - T::load(x[1] + j), d2 = x2 - T::load(x[2] + j);
                T r2 = d0 * d0 + d1 * d1 + d2 * d2;
                r2 = max(r2, least.squared(run.count()));
                const T rest = positive_part(T(1) - sqrt(r2) * inverse);
                const T weight = T::load(mass_ + j) * (rest * rest * rest);
                const T approach =
                    (v0 - T::load(v[0] + j)) * d0 + (v1 - T::load(v[1] + j)) * d1 + (v2 - T::load(v[2] + j)) * d2;
                const T meeting = negative_part(approach), away = r2 + epsilon;
                const T Pi = meeting * (quadratic * meeting - linear * away) /
                             (away * away * (own_density + T::load(density.data() + j)));
                const auto s = [&](std::size_t c) {
                    return own_stress[c] + T::load(stress_over_density2_[c].data() + j);
                };
                const T xy = s(1), xz = s(2), yz = s(4);
                a0 += weight * ((s(0) - Pi) * d0 + xy * d1 + xz * d2);
                a1 += weight * (xy * d0 + (s(3) - Pi) * d1 + yz * d2);
                a2 += weight * (xz * d0 + yz * d1 + (s(5) - Pi) * d2);
            }
            acceleration[0][own] = gravity[0] + scale * sum(a0);
            acceleration[1][own] = gravity[1] + scale * sum(a1);
            acceleration[2][own] = gravity[2] + scale * sum(a2);
        }
    }
};

} // namespace imbibe::bench
