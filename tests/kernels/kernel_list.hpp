// The kernels under test with the dimensions in which each is normalised, and the quadrature the tests share.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <imbibe/kernels/kernels.hpp>

namespace imbibe_test {

template <class K, int... dims>
struct Case {
    using Kernel = K;
    /// Calls f.template operator()<dim>() for every dimension of the kernel.
    template <class F>
    static void for_each_dimension(F f) {
        (f.template operator()<dims>(), ...);
    }
};

/// Calls f with every Case.
template <class F>
void for_each_case(F f) {
    f(Case<imbibe::Spiky, 1, 2, 3>{});
    f(Case<imbibe::Poly6, 1, 2, 3>{});
    f(Case<imbibe::CubicSpline, 1, 2, 3>{});
    f(Case<imbibe::QuinticSpline, 1, 2, 3>{});
    f(Case<imbibe::WendlandC2, 2, 3>{});
    f(Case<imbibe::WendlandC4, 2, 3>{});
    f(Case<imbibe::WendlandC6, 2, 3>{});
    f(Case<imbibe::ViscosityKernel2D, 2>{});
    f(Case<imbibe::ViscosityKernel, 3>{});
}

/// Integral of f over [0, 1] by a five-point Gauss rule on panels that end at the knots of the splines and shrink
/// towards 0, where the viscosity kernels are singular.
template <class F>
double integral_over_support(F f) {
    std::vector<double> edges{0.0};
    for (int k = -80; k <= 0; ++k)
        edges.push_back(std::pow(2.0, 0.5 * k) / 24);
    for (int k = 5; k <= 96; ++k)
        edges.push_back(k / 96.0);
    const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double root70 = 13.0 * std::sqrt(70.0);
    const std::array<double, 5> nodes{-outer, -inner, 0.0, inner, outer};
    const std::array<double, 5> weights{(322.0 - root70) / 900.0, (322.0 + root70) / 900.0, 128.0 / 225.0,
                                        (322.0 + root70) / 900.0, (322.0 - root70) / 900.0};
    double sum = 0.0;
    for (std::size_t k = 1; k < edges.size(); ++k) {
        const double half = 0.5 * (edges[k] - edges[k - 1]);
        const double middle = 0.5 * (edges[k] + edges[k - 1]);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            sum += half * weights[i] * f(middle + half * nodes[i]);
    }
    return sum;
}

/// The surface of the unit ball: 2, 2 pi, 4 pi.
template <int dim>
inline constexpr double unit_surface = dim == 1   ? 2.0
                                       : dim == 2 ? 2.0 * std::numbers::pi
                                                  : 4.0 * std::numbers::pi;

} // namespace imbibe_test
