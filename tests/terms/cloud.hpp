// Whole bodies for the tests of terms: jittered lattices of particles, with every pair of them summed.
#pragma once

#include "hand.hpp"

#include <imbibe/core/dry_run.hpp>

namespace cloud {

using namespace hand;

template <int dim, class Material>
using Cloud = std::vector<Particle<dim, Number<double>, Material>>;

/// A vector of the library from plain numbers.
template <int dim>
Vector<Number<double>, dim> vec(const ColumnVector<dim>& x) {
    return from_eigen<Number<double>, dim>(x);
}
template <int dim>
Tensor<Number<double>, dim> tensor(const Matrix<dim>& m) {
    Tensor<Number<double>, dim> t{};
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            t(i, j) = m(i, j);
    return t;
}

/// n^dim particles at `spacing` of the material, each moved by up to `jitter` spacings; lower corner at `origin`.
/// Position, reference position, mass, density, velocity (zero) and the supported share (1) are set.
template <int dim, class Material>
Cloud<dim, Material> block(const Material& material, int n, double jitter, unsigned seed = 1,
                           const ColumnVector<dim>& origin = ColumnVector<dim>::Zero()) {
    Dice dice(seed);
    Cloud<dim, Material> all;
    for (int k = 0; k < (dim == 2 ? n * n : n * n * n); ++k) {
        ColumnVector<dim> x = origin;
        for (int d = 0, rest = k; d < dim; ++d, rest /= n)
            x[d] += material.spacing * (rest % n + dice(-jitter, jitter));
        Particle<dim, Number<double>, Material> p(material);
        p.set(position, vec<dim>(x)).set(reference_position, vec<dim>(x));
        p.set(mass, material.density * std::pow(material.spacing, dim)).set(density, material.density);
        p.set(velocity, Vector<Number<double>, dim>::zero()).set(supported_share, 1.0);
        all.push_back(p);
    }
    return all;
}

/// The pair a, b where they are now, or (for parts that say so) where they were when the solid was stress-free.
template <class Part, int dim, class A, class B>
Pair<dim, Number<double>> geometry(const Particle<dim, Number<double>, A>& a, const Particle<dim, Number<double>, B>& b,
                                   const ColumnVector<dim>& g = ColumnVector<dim>::Zero()) {
    const auto offset =
        detail::uses_reference<Part> ? a[reference_position] - b[reference_position] : a[position] - b[position];
    return {offset, norm(offset), SupportRadius(a.material.support_radius), from_eigen<double, dim>(g)};
}

/// The sum of a pair part over all sources, themselves among them, for one target.
template <class Part, int dim, class A, class B>
auto sum(const Part& part, const Particle<dim, Number<double>, A>& a, const Cloud<dim, B>& sources,
         const ColumnVector<dim>& g = ColumnVector<dim>::Zero()) {
    auto contribution_of = [&](const auto& b) {
        const auto ab = geometry<Part, dim>(a, b, g);
        return contribution(ab, part(a, b, ab));
    };
    auto total = contribution_of(sources.front());
    for (std::size_t k = 1; k < sources.size(); ++k)
        total = total + contribution_of(sources[k]);
    return total;
}

/// Sums a pair part for every target and keeps the result in a field.
template <class Part, class F, class Targets, class Sources, class... G>
void gather(const Part& part, F field, Targets& targets, const Sources& sources, const G&... g) {
    for (auto& a : targets)
        a.set(field, sum(part, a, sources, g...));
}

/// What a pair gives to a's momentum or, for scalars, mass times rate.
template <class Part, class A, class B>
auto given(const Part& part, const A& a, const B& b) {
    constexpr int dim = A::dimension;
    const auto ab = geometry<Part, dim>(a, b);
    return plain(a[mass] * contribution(ab, part(a, b, ab)));
}

/// |m_a f_ab + m_b f_ba| of the worst pair, in terms of the greatest |m_a f_ab|: a force that is small because its
/// parts cancel carries their round-off.
template <class Part, class First, class Second>
double worst_imbalance(const Part& part, const First& first, const Second& second) {
    double worst = 0, greatest = 0;
    for (const auto& a : first)
        for (const auto& b : second) {
            const auto there = given(part, a, b), back = given(part, b, a);
            worst = std::max(worst, (there + back).norm());
            greatest = std::max(greatest, there.norm());
        }
    return worst / greatest;
}

/// How far a force is from minus the slope of `energy(body)`, which is given a body with one particle moved: the worst
/// of three particles, as a share of the force.
template <class Push, int dim, class Material, class Energy>
double worst_departure_from_slope(const Push& push, const Cloud<dim, Material>& body, const Energy& energy) {
    constexpr double small = 1e-8;
    double worst = 0;
    for (const std::size_t k : {std::size_t{0}, body.size() / 2, body.size() - 1})
        for (int d = 0; d < dim; ++d) {
            const auto energy_at = [&](double step) {
                auto moved = body;
                ColumnVector<dim> x = plain(body[k][position]);
                x[d] += step;
                moved[k].set(position, vec<dim>(x));
                return energy(std::move(moved));
            };
            const double by_hand = -(energy_at(small) - energy_at(-small)) / (2 * small);
            const auto force = plain(body[k][mass] * sum(push, body[k], body));
            worst = std::max(worst, std::abs(force[d] - by_hand) / force.norm());
        }
    return worst;
}

/// The reads of a part, as text: those on a, a bar, those on b.
template <class Part, int dim, class A, class B, class... F>
std::string sides_of(TypeList<F...>) {
    constexpr auto seen = detail::reads_on<Part, dim, A, B>;
    static_assert(detail::check_all_read<Part, seen>(TypeList<F...>{}));
    std::string on_a, on_b;
    ((seen.a[detail::index_of<F, TypeList<F...>>] ? on_a.append(F::name).append(" ") : on_a), ...);
    ((seen.b[detail::index_of<F, TypeList<F...>>] ? on_b.append(" ").append(F::name) : on_b), ...);
    return on_a + "|" + on_b;
}
template <class Part, int dim, class A, class B = A>
std::string sides() {
    return sides_of<Part, dim, A, B>(typename detail::ReadsOf<Part>::type{});
}

} // namespace cloud
