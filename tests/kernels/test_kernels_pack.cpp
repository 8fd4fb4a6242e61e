// The same kernel source on a whole register of numbers gives what it gives on one.
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch_shim.hpp>

#include "kernel_list.hpp"

using namespace imbibe;
using imbibe_test::for_each_case;

namespace {

/// The most that f on packs of `width` numbers differs from f on single ones, for q from 0 to past the rim, in units
/// of the rounding of the larger of the result and `scale`. Not zero: where the compiler fuses a multiplication with
/// an addition, it may do so in one of the two and not in the other.
template <class Real, int width, class F>
Real difference(F f, Real scale) {
    Real most = 0;
    for (int first = 0; first < 480; first += width) {
        Real q[width];
        for (int k = 0; k < width; ++k)
            q[k] = Real(first + k) / Real(400);
        const Pack<Real, width> together = f(Pack<Real, width>::load(q));
        for (int k = 0; k < width; ++k) {
            const Real alone = f(q[k]);
            const Real rounding = std::numeric_limits<Real>::epsilon() * std::max(std::abs(alone), scale);
            const Real here = std::abs(together[k] - alone) / rounding;
            most = here <= most ? most : here; // so written, a NaN is kept
            if (q[k] >= Real(1) && together[k] != Real(0))
                return std::numeric_limits<Real>::infinity();
        }
    }
    return most;
}

template <class Real, int width>
void packs_like_numbers() {
    for_each_case([](auto which) {
        using C = decltype(which);
        using K = typename C::Kernel;
        INFO(K::name << ", " << width << " lanes of " << sizeof(Real) << " bytes");
        const Real value_scale = std::min(K::value(Real(0)), Real(66)); // the viscosity kernels peak elsewhere
        const Real slope_scale = -K::derivative(Real(0.3));
        const Real few = 8;
        CHECK(difference<Real, width>([](auto q) { return K::value(q); }, value_scale) <= few);
        CHECK(difference<Real, width>([](auto q) { return K::derivative(q); }, slope_scale) <= few);
        if constexpr (HasDerivativeOverQ<K>)
            CHECK(difference<Real, width>([](auto q) { return K::derivative_over_q(q); }, slope_scale) <= few);
        if constexpr (HasLaplacian<K>)
            CHECK(difference<Real, width>([](auto q) { return K::laplacian(q); }, Real(6)) <= few);
        C::for_each_dimension([&]<int dim>() {
            const Real factor = Real(K::template normalisation<dim>());
            const auto value = [](auto r) { return kernel_value<K, dim>(r, 1); };
            const auto slope = [](auto r) { return kernel_derivative<K, dim>(r, 1); };
            CHECK(difference<Real, width>(value, factor * value_scale) <= few);
            CHECK(difference<Real, width>(slope, factor * slope_scale) <= few);
        });
    });
}

} // namespace

TEST_CASE("kernels on packs of double are those on one double") {
    packs_like_numbers<double, native_width<double>>();
    packs_like_numbers<double, 1>();
}
TEST_CASE("kernels on packs of float are those on one float") {
    packs_like_numbers<float, native_width<float>>();
    packs_like_numbers<float, 1>();
}
