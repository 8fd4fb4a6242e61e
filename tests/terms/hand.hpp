// A bench for terms: particles whose fields are set by name, pairs made of two of them, and the kernels of the paper
// written out once more in plain double, so that a term can be held against its equation without a solver.
#pragma once

#include <catch_shim.hpp>

#include <imbibe/core/phase.hpp>
#include <imbibe/core/term.hpp>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace hand {

using namespace imbibe;

using Water = Fluid<>;
using Sponge = Solid<>;

/// The two materials of the paper; the shear modulus is one that the text leaves room for.
inline Water water() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 3.5e-3, .support_radius = 1e-3, .spacing = 8e-4};
}
inline Sponge sponge() {
    return {.density = 950, .sound_speed = 31.6, .shear_modulus = 1e6, .support_radius = 1e-3, .spacing = 5e-4};
}
inline constexpr double H = 1e-3;

/// A particle on any number type: fields are set by name, and reading one that was never set throws.
template <int dim, class T = Number<double>, class Material_ = Water>
class Particle {
public:
    using Scalar = T;
    using Material = Material_;
    static constexpr int dimension = dim;
    Material material{};
    double time_step = 0, time = 0; // s

    explicit Particle(const Material& m = {}) : material(m) {}

    template <class F>
    Value<F, dim, T> operator[](F) const {
        const auto at = values_.find(F::name);
        if (at == values_.end())
            throw std::runtime_error("hand::Particle: read but never set: " + std::string(F::name));
        Value<F, dim, T> value{};
        for (int k = 0; k < components(F::rank, dim); ++k)
            component(value, k) = at->second[static_cast<std::size_t>(k)];
        return value;
    }
    template <class F>
    Particle& set(F, const Value<F, dim, T>& value) {
        for (int k = 0; k < components(F::rank, dim); ++k)
            values_[F::name][static_cast<std::size_t>(k)] = component(value, k);
        return *this;
    }
    Vector<T, dim> gravity() const { return Vector<T, dim>::zero(); }

    std::map<std::string_view, std::array<T, 9>> values_;
};

/// Lane k holds the number of the k-th particle (the last one where there are fewer particles than lanes).
template <class T, int dim, class Material>
Particle<dim, T, Material> lanes(const std::vector<Particle<dim, Number<double>, Material>>& particles) {
    using Real = typename T::Scalar;
    Particle<dim, T, Material> result(particles.front().material);
    result.time_step = particles.front().time_step;
    for (const auto& [name, first] : particles.front().values_)
        for (std::size_t k = 0; k < first.size(); ++k) {
            std::array<Real, static_cast<std::size_t>(T::size)> numbers{};
            for (std::size_t lane = 0; lane < numbers.size(); ++lane)
                numbers[lane] =
                    static_cast<Real>(particles[std::min(lane, particles.size() - 1)].values_.at(name)[k].lanes);
            result.values_[name][k] = T::load(numbers.data());
        }
    return result;
}

/// The same particle in every lane, or on another number type.
template <class T, int dim, class Material>
Particle<dim, T, Material> as(const Particle<dim, Number<double>, Material>& particle) {
    return lanes<T>(std::vector{particle});
}

/// The geometry of a pair from the positions of its particles.
template <int dim, class T, class A, class B>
Pair<dim, T> pair_of(const Particle<dim, T, A>& a, const Particle<dim, T, B>& b, double support = H) {
    const auto offset = a[position] - b[position];
    return {offset, norm(offset), SupportRadius(support), Vector<double, dim>::zero()};
}

template <int dim>
using ColumnVector = Eigen::Matrix<double, dim, 1>;
template <int dim>
using Matrix = Eigen::Matrix<double, dim, dim>;

/// Lane k of a number, a vector or a tensor in plain double.
template <class Real, int width>
double plain(const Pack<Real, width>& x, int lane = 0) {
    return static_cast<double>(x[lane]);
}
template <class T, int dim>
ColumnVector<dim> plain(const Vector<T, dim>& v, int lane = 0) {
    ColumnVector<dim> r;
    for (int i = 0; i < dim; ++i)
        r[i] = plain(v[i], lane);
    return r;
}
template <class Matrix_>
requires requires(Matrix_ m) {
    m(0, 0);
}
auto plain(const Matrix_& t, int lane = 0) {
    constexpr int dim = detail::dimension_of<Matrix_>;
    Matrix<dim> r;
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            r(i, j) = plain(t(i, j), lane);
    return r;
}

/// What a pair part gives, as it enters the sum: central contributions become vectors.
template <int dim, class T, class R>
auto contribution(const Pair<dim, T>& ab, const R& result) {
    if constexpr (requires { result.factor; })
        return result.factor * ab.offset;
    else
        return result;
}

/// Every component of a contribution in plain double, one after the other.
template <class R>
std::vector<double> numbers(const R& result, int lane = 0) {
    std::vector<double> all;
    if constexpr (detail::Algebraic<R>)
        for (int k = 0; k < R::size; ++k)
            all.push_back(plain(result.c[k], lane));
    else
        all.push_back(plain(result, lane));
    return all;
}

/// Random states of the size they have in the paper's scene.
class Dice {
public:
    explicit Dice(unsigned seed = 1) : engine_(seed) {}
    double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

    template <int dim>
    Vector<Number<double>, dim> vector(double size) {
        Vector<Number<double>, dim> v{};
        for (int i = 0; i < dim; ++i)
            v[i] = (*this)(-size, size);
        return v;
    }
    template <int dim, class Material>
    Particle<dim, Number<double>, Material> particle(const Material& material, Vector<Number<double>, dim> where) {
        Particle<dim, Number<double>, Material> p(material);
        const double rho = material.density * (*this)(0.95, 1.05);
        p.set(position, where).set(velocity, vector<dim>(1)).set(smoothed_velocity, vector<dim>(1));
        p.set(mass, material.density * std::pow(material.spacing, dim) * (*this)(0.9, 1.1));
        p.set(density, rho).set(pressure, (*this)(-2e4, 5e4));
        SymmetricTensor<Number<double>, dim> s{};
        for (auto& component : s.c)
            component = (*this)(-5e4, 5e4);
        p.set(deviatoric_stress, s);
        return p;
    }
    /// A particle at the origin and its neighbours: itself, `inside` others within the support, `outside` beyond it.
    template <int dim, class Material>
    std::vector<Particle<dim, Number<double>, Material>> cluster(const Material& material, int inside = 12,
                                                                 int outside = 3) {
        std::vector<Particle<dim, Number<double>, Material>> all;
        all.push_back(particle<dim>(material, Vector<Number<double>, dim>::zero()));
        while (static_cast<int>(all.size()) < 1 + inside + outside) {
            const auto where = vector<dim>(1.4 * H);
            const double r = plain(norm(where));
            const bool wanted = static_cast<int>(all.size()) <= inside ? r > 0.1 * H && r < 0.98 * H : r > H;
            if (wanted)
                all.push_back(particle<dim>(material, where));
        }
        return all;
    }

private:
    std::mt19937 engine_;
};

/// Runs a particle part on every particle and keeps what it sets.
template <class Part, class Field_, class Particles>
void prepare(const Part& part, Field_ field, Particles& particles) {
    for (auto& p : particles)
        p.set(field, part(p));
}

/// Sums a pair part over all neighbours of the first particle, itself among them.
template <class Part, class Particles>
auto sum_over_neighbours(const Part& part, const Particles& all) {
    const auto& a = all.front();
    auto total = contribution(pair_of(a, a), part(a, a, pair_of(a, a)));
    for (std::size_t k = 1; k < all.size(); ++k) {
        const auto ab = pair_of(a, all[k]);
        total += contribution(ab, part(a, all[k], ab));
    }
    return total;
}

/// The same sum by hand: f(b, x_ab, r) for every neighbour with 0 < r < H.
template <class Particles, class F>
auto sum_by_hand(const Particles& all, F f) {
    using Result = decltype(f(all[0], plain(all[0][position]), 1.0));
    Result total = f(all[1], plain(all[1][position]), 1.0) * 0.0;
    for (std::size_t k = 1; k < all.size(); ++k) {
        const auto x = (plain(all[0][position]) - plain(all[k][position])).eval();
        if (x.norm() < H)
            total += f(all[k], x, x.norm());
    }
    return total;
}

// The paper's kernels, Eqs. (13), (14), (20), in one line each; in 2D with the norm of the plane.
constexpr double pi = std::numbers::pi;
template <int dim>
double spiky_norm() {
    return dim == 3 ? 15 / (pi * std::pow(H, 6)) : 10 / (pi * std::pow(H, 5));
}
template <int dim>
double spiky(double r) {
    return spiky_norm<dim>() * std::pow(H - r, 3);
}
template <int dim>
ColumnVector<dim> spiky_gradient(const ColumnVector<dim>& x) {
    return -3 * spiky_norm<dim>() * std::pow(H - x.norm(), 2) / x.norm() * x;
}
template <int dim>
double viscosity_laplacian(double r) {
    return dim == 3 ? 45 / (pi * std::pow(H, 6)) * (H - r) : 40 / (pi * std::pow(H, 5)) * (H - r);
}
template <int dim>
double poly6(double r) {
    return (dim == 3 ? 315 / (64 * pi * std::pow(H, 9)) : 4 / (pi * std::pow(H, 8))) * std::pow(H * H - r * r, 3);
}

/// |a - b| relative to |b|.
template <class A, class B>
double relative_error(const A& a, const B& b) {
    if constexpr (requires { a.norm(); })
        return (a - b).norm() / b.norm();
    else
        return std::abs(a - b) / std::abs(b);
}

} // namespace hand
