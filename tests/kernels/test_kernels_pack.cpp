// The same kernel source on a whole register of numbers gives what it gives on one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
        const Real curvature_scale = std::abs(K::second_derivative(Real(0.3)));
        CHECK(difference<Real, width>([](auto q) { return K::second_derivative(q); }, curvature_scale) <= few);
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

namespace {

/// pow and exp of packs against those of <cmath>, lane by lane, to the last bit, and where they are special.
template <class Real, int width>
void powers_are_those_of_cmath() {
    using P = Pack<Real, width>;
    INFO(width << " lanes of " << sizeof(Real) << " bytes");
    const Real inf = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
    const Real least = std::numeric_limits<Real>::denorm_min();
    const auto same = [](Real a, Real b) {
        return std::isnan(b) ? std::isnan(a) : a == b && std::signbit(a) == std::signbit(b);
    };
    std::vector<Real> numbers{0, Real(-0.0), 1, -1, 2, -2, 3, -3, Real(0.5), Real(-0.5), inf, -inf, nan, least, 1000};
    for (int k = 1; k < 50; ++k)
        numbers.push_back(Real(0.07) * Real(k));
    const std::size_t n = numbers.size();
    for (std::size_t first = 0; first < n; ++first)
        for (std::size_t shift = 0; shift < n; ++shift) { // each number with each
            Real base[width], exponent[width];
            for (std::size_t k = 0; k < width; ++k) {
                base[k] = numbers[(first + k) % n];
                exponent[k] = numbers[(first + k + shift) % n];
            }
            const P of_packs = pow(P::load(base), P::load(exponent));
            const P of_number = pow(P::load(base), exponent[0]), by_pack = pow(base[0], P::load(exponent));
            bool good = true;
            for (int k = 0; k < width; ++k) {
                good = good && same(of_packs[k], std::pow(base[k], exponent[k]));
                good = good && same(of_number[k], std::pow(base[k], exponent[0]));
                good = good && same(by_pack[k], std::pow(base[0], exponent[k]));
                good = good && same(exp(P::load(base))[k], std::exp(base[k]));
            }
            CAPTURE(base[0], exponent[0]);
            REQUIRE(good);
        }
    CHECK(pow(P(-2), 3)[width - 1] == -8); // an integer is an exponent as well
    CHECK(pow(P(4), P(-1.5))[width - 1] == Real(0.125));
    CHECK(pow(2, P(3))[width - 1] == 8);
    CHECK(std::isnan(pow(P(-2), 0.5)[0]));
    CHECK(pow(P(0), -1)[0] == inf);
    CHECK(pow(P(nan), 0)[0] == 1);
}

/// As a law of one's own has it, for packs and for plain numbers.
template <class T>
T inverse_square_of_cube_root(T J) {
    return pow(J, T(-2.0 / 3));
}

} // namespace

TEST_CASE("powers and exponentials of packs are those of <cmath>") {
    powers_are_those_of_cmath<double, native_width<double>>();
    powers_are_those_of_cmath<double, 1>();
    powers_are_those_of_cmath<float, native_width<float>>();
    powers_are_those_of_cmath<float, 1>();
    CHECK(inverse_square_of_cube_root(8.0) == Approx(0.25).epsilon(1e-15));
    CHECK(inverse_square_of_cube_root(8.0f) == Approx(0.25f));
    CHECK(inverse_square_of_cube_root(Pack<double, native_width<double>>(8))[0] == Approx(0.25).epsilon(1e-15));
    CHECK(imbibe::exp(1.0) == std::exp(1.0));
}
