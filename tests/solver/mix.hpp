// A scene with everything in it: two fluids, a solid with reference neighbours, and couplings between them. With the
// same sums written out a second time, as plain loops over all pairs.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/displacement.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace solver_test {

namespace sph = imbibe;
using C2 = sph::WendlandC2;

/// Springs between neighbours of the stress-free solid: dv_a/dt = -k sum_b m_b (u_a - u_b) W_ab. Not stiff in the steps
/// that it is given.
struct Springs : sph::NotStiff {
    static constexpr double k = 2;
    struct Pull {
        using neighbourhood = sph::Reference;
        using reads = sph::Fields<sph::mass, sph::displacement>;
        using adds = sph::Fields<sph::acceleration>;
        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (-k * b[sph::mass] * ab.value(C2{})) * (a[sph::displacement] - b[sph::displacement]);
        }
    };
    using parts = sph::Parts<sph::Displacement, Pull>;
};
/// Friction between neighbours of now, also within the solid: dv_a/dt = k sum_b m_b (v_b - v_a) W_ab.
struct Friction {
    static constexpr double k = 0.02;
    using reads = sph::Fields<sph::mass, sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return (k * b[sph::mass] * ab.value(C2{})) * (b[sph::velocity] - a[sph::velocity]);
    }
};

template <int dim>
using Viscous = std::conditional_t<dim == 2, sph::ViscosityKernel2D, sph::ViscosityKernel>;

template <int dim>
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<C2>, sph::SymmetricPressure<C2>,
                          sph::LaminarViscosity<Viscous<dim>>, sph::Xsph<C2>, sph::XsphTransport> {};
struct Oil : sph::Fluid<sph::LinearState, sph::Continuity<C2>, sph::SymmetricPressure<C2>, sph::MonaghanViscosity<C2>> {
};
struct Rubber : sph::Solid<Springs, Friction, sph::Clamped> {};
template <int dim>
struct Surface : sph::Coupling<Water<dim>, Oil, sph::VolumeContinuity<C2>, sph::SymmetricPressure<C2>,
                               sph::LaminarViscosity<Viscous<dim>>> {};
template <int dim>
struct Contact : sph::Coupling<Rubber, Water<dim>, sph::KernelRepulsion<C2>, Friction> {};

/// The scene, and its particles as they were added.
template <int dim, class Real>
struct Mix {
    using Scene = sph::Solver<dim, Real, sph::SymplecticEuler, Water<dim>, Oil, Rubber, Surface<dim>, Contact<dim>>;
    using Point = Eigen::Matrix<double, dim, 1>;
    static constexpr double stiffness = 5e3, gravity = -3;

    struct Particle {
        int phase, index;       ///< 0 water, 1 oil, 2 rubber; number within the phase
        Point X, x, v;          ///< as the scene's precision holds them
        double rho, m, support; ///< support of the phase
        double rate = 0, p = 0; ///< density rate; pressure
        Point a = Point::Zero(), mean = Point::Zero(), smooth = Point::Zero();
    };
    std::vector<Particle> all;
    std::array<std::vector<Point>, 3> points;
    sph::Settings<dim> settings;
    double spacing;
    Water<dim> water;
    Oil oil;
    Rubber rubber;

    /// m^dim particles in a unit box with `sides` periodic sides, at random which is of which phase.
    Mix(int m, int sides, double supports, int threads = 1) : spacing(1.0 / m) {
        settings.gravity[static_cast<std::size_t>(dim - 1)] = gravity;
        settings.support_radius = supports * spacing;
        settings.threads = threads;
        for (int d = 0; d < sides; ++d) {
            settings.periodic_lower[static_cast<std::size_t>(d)] = -0.5;
            settings.periodic_length[static_cast<std::size_t>(d)] = 1;
        }
        water.density = 1000, water.sound_speed = 10, water.viscosity = 2;
        oil.density = 800, oil.sound_speed = 8, oil.viscosity = 5, oil.support_radius = 1.2 * settings.support_radius;
        oil.set(sph::MonaghanViscosityParameters{.alpha = 0.5, .beta = 1});
        rubber.density = 950, rubber.sound_speed = 10, rubber.shear_modulus = 1e4;
        std::mt19937 generator(17);
        std::uniform_real_distribution<double> jitter(-0.3, 0.3);
        for (int i = 0; i < (dim == 2 ? m * m : m * m * m); ++i) {
            const int at[] = {i % m, i / m % m, i / m / m};
            Point x;
            for (int d = 0; d < dim; ++d)
                x[d] = static_cast<Real>(-0.5 + spacing * (at[d] + 0.5 + jitter(generator)));
            points[generator() % 3].push_back(x);
        }
    }
    /// The scene with random velocities, densities and displacements; `all` says the same.
    Scene make(bool shifted = false) {
        Scene scene(settings);
        scene.template coupling<Contact<dim>>().set(sph::KernelRepulsionParameters{.stiffness = stiffness});
        const auto handle_0 = scene.add(water, points[0], spacing);
        const auto handle_1 = scene.add(oil, points[1], 1.1 * spacing);
        const auto handle_2 = scene.add(rubber, points[2], 0.9 * spacing);
        std::mt19937 generator(18);
        std::uniform_real_distribution<double> uniform(-1, 1);
        const auto fill = [&](auto handle, int phase) {
            auto view = scene[handle];
            for (int i = 0; i < view.size(); ++i) {
                Particle p{};
                p.phase = phase, p.index = i, p.support = view.material().support_radius;
                for (int d = 0; d < dim; ++d) {
                    p.X[d] = static_cast<double>(view[sph::position](i, d));
                    if (phase == 2) { // strained, and in the periodic case some periods away
                        view[sph::position](i, d) += static_cast<Real>(0.05 * spacing * uniform(generator));
                        if (shifted && d == 0)
                            view[sph::position](i, d) += Real(3);
                    }
                    p.x[d] = static_cast<double>(view[sph::position](i, d));
                    view[sph::velocity](i, d) = static_cast<Real>(uniform(generator));
                    p.v[d] = static_cast<double>(view[sph::velocity](i, d));
                }
                view[sph::density](i) *= static_cast<Real>(1 + 0.02 * uniform(generator));
                p.rho = static_cast<double>(view[sph::density](i));
                p.m = static_cast<double>(view[sph::mass](i));
                all.push_back(p);
            }
        };
        all.clear();
        fill(handle_0, 0);
        fill(handle_1, 1);
        fill(handle_2, 2);
        return scene;
    }

    /// Calls f(a, b, offset, distance, H) for all pairs within H, periodic images included, a itself too.
    template <class F>
    void for_each_pair(bool reference, const F& f) {
        std::array<int, 3> reach{};
        for (std::size_t d = 0; d < dim; ++d)
            reach[d] = settings.periodic_length[d] > 0 ? 5 : 0;
        for (Particle& a : all)
            for (Particle& b : all) {
                const double H = std::max(a.support, b.support);
                Point gap = reference ? Point(a.X - b.X) : Point(a.x - b.x);
                for (int d = 0; d < dim; ++d) // to the nearest image, then to those around it
                    if (reach[static_cast<std::size_t>(d)] > 0)
                        gap[d] -= std::round(gap[d]);
                for (int x = reach[0] > 0 ? -1 : 0; x <= (reach[0] > 0 ? 1 : 0); ++x)
                    for (int y = reach[1] > 0 ? -1 : 0; y <= (reach[1] > 0 ? 1 : 0); ++y)
                        for (int z = reach[2] > 0 ? -1 : 0; z <= (reach[2] > 0 ? 1 : 0); ++z) {
                            const int step[] = {x, y, z};
                            Point offset = gap;
                            for (int d = 0; d < dim; ++d)
                                offset[d] += step[d];
                            if (offset.norm() < H)
                                f(a, b, offset, offset.norm(), H);
                        }
            }
    }
    static double W(double r, double H) { return sph::kernel_value<C2, dim>(r, H); }
    // grad_a W = F (x_a - x_b)
    static double F(double r, double H) { return r > 0 ? sph::kernel_derivative<C2, dim>(r, H) / r : 0; }

    /// One step of the scheme, straight from the equations.
    void step(double dt) {
        for_each_pair(false, [&](Particle& a, const Particle& b, const Point& offset, double r, double H) {
            const double closing = (a.v - b.v).dot(offset) * F(r, H);
            if (a.phase == b.phase && a.phase < 2)
                a.rate += b.m * closing;
            else if (a.phase < 2 && b.phase < 2)
                a.rate += a.rho * b.m / b.rho * closing;
        });
        for (Particle& a : all) {
            if (a.phase < 2)
                a.rho += dt * a.rate;
            a.p = a.phase == 0   ? 1000 * 100.0 / 7 * (std::pow(a.rho / 1000, 7) - 1)
                  : a.phase == 1 ? 64 * (a.rho - 800)
                                 : 0;
            a.a[dim - 1] = gravity;
        }
        for_each_pair(false, [&](Particle& a, const Particle& b, const Point& offset, double r, double H) {
            const Point gradient = F(r, H) * offset;
            if (a.phase < 2 && b.phase < 2) {
                a.a -= b.m * (a.p / sph::sq(a.rho) + b.p / sph::sq(b.rho)) * gradient;
                const double eta = a.phase == b.phase ? 2.0 : 2 * 2.0 * 5.0 / 7.0;
                if (a.phase == 0 || b.phase == 0)
                    a.a += eta * b.m / (a.rho * b.rho) * sph::kernel_laplacian<Viscous<dim>, dim>(r, H) * (b.v - a.v);
            }
            if (a.phase == 0 && b.phase == 0)
                a.mean += 2 * b.m / (a.rho + b.rho) * W(r, H) * (b.v - a.v);
            if (a.phase == 1 && b.phase == 1) {
                const double mu = H * (a.v - b.v).dot(offset) / (r * r + 0.01 * H * H);
                if (mu < 0)
                    a.a -= b.m * (-0.5 * 8 * mu + 1.0 * mu * mu) * 2 / (a.rho + b.rho) * gradient;
            }
            if (a.phase + b.phase == 2 && a.phase != b.phase)
                a.a -= stiffness / a.m * (a.m / a.rho) * (b.m / b.rho) * gradient;
            if ((a.phase == 2 && b.phase != 1) || (b.phase == 2 && a.phase != 1))
                a.a += Friction::k * b.m * W(r, H) * (b.v - a.v);
        });
        for_each_pair(true, [&](Particle& a, const Particle& b, const Point&, double r, double H) {
            if (a.phase == 2 && b.phase == 2)
                a.a -= Springs::k * b.m * W(r, H) * ((a.x - a.X) - (b.x - b.X));
        });
        for (Particle& a : all) {
            a.smooth = a.v + 0.5 * a.mean;
            const Point correction = a.phase == 0 ? Point(a.smooth - a.v) : Point(Point::Zero());
            a.v += dt * a.a;
            a.x += dt * (a.v + correction);
        }
    }
};

} // namespace solver_test
