// Every kernel keeps the contract of kernels/kernel.hpp: unit integral, consistent derivatives, compact support.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <type_traits>

#include <imbibe/core/term.hpp>

#include <catch_shim.hpp>

#include "kernel_list.hpp"

using namespace imbibe;
using imbibe_test::for_each_case;

namespace {

template <class C>
using KernelOf = typename C::Kernel;

// The whole support, from 1e-3 on (the viscosity kernels are too steep for finite differences below) and staying
// off the knots of the splines by more than the step of a finite difference.
std::vector<double> sample_points() {
    std::vector<double> points;
    for (int k = 0; k < 200; ++k)
        points.push_back(1e-3 + (k + 0.37) * (0.998 / 200));
    return points;
}

// Eighth-order central difference: its error is far below the tolerance for the steps used.
template <class F>
double slope(F f, double x, double step) {
    return (4.0 / 5.0 * (f(x + step) - f(x - step)) - 1.0 / 5.0 * (f(x + 2 * step) - f(x - 2 * step)) +
            4.0 / 105.0 * (f(x + 3 * step) - f(x - 3 * step)) - 1.0 / 280.0 * (f(x + 4 * step) - f(x - 4 * step))) /
           step;
}

// A step that keeps all eight points well inside one smooth piece: the pieces end at multiples of 1/6.
double step_at(double q) {
    const double piece = std::floor(q * 6.0) / 6.0;
    const double room = std::min(q - piece, piece + 1.0 / 6.0 - q);
    return std::min(room / 20.0, 1e-2 * q);
}

} // namespace

TEST_CASE("a kernel integrates to one in every dimension it is normalised for") {
    for_each_case([](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        C::for_each_dimension([]<int dim>() {
            INFO(K::name << " in " << dim << "D");
            const double H = 1.7;
            const double whole = imbibe_test::integral_over_support([&](double q) {
                const double r = q * H;
                return imbibe_test::unit_surface<dim> * std::pow(r, dim - 1) * kernel_value<K, dim>(r, H) * H;
            });
            CHECK(whole == Approx(1.0).epsilon(1e-11).margin(0));
        });
    });
}

TEST_CASE("the slope integrates to minus dim: the gradient of a linear field is exact in the continuum") {
    for_each_case([](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        C::for_each_dimension([]<int dim>() {
            INFO(K::name << " in " << dim << "D");
            const double H = 0.3;
            const double moment = imbibe_test::integral_over_support([&](double q) {
                const double r = q * H;
                return imbibe_test::unit_surface<dim> * std::pow(r, dim) * kernel_derivative<K, dim>(r, H) * H;
            });
            // Where the viscosity kernels are flattened (q < 1e-6) the derivative is not that of the flat value: the
            // difference is the margin.
            CHECK(moment == Approx(-double(dim)).epsilon(1e-10).margin(0));
        });
    });
}

TEST_CASE("the derivative is that of the value") {
    for_each_case([](auto which) {
        using K = KernelOf<decltype(which)>;
        for (double q : sample_points()) {
            INFO(K::name << " at q = " << q);
            const double step = step_at(q);
            // What rounding the values and their arguments does to the difference.
            const double round_off = 2e-16 * (K::value(q) - K::derivative(q)) / step;
            CHECK(K::derivative(q) ==
                  Approx(slope([](double x) { return K::value(x); }, q, step)).epsilon(1e-9).margin(8 * round_off));
        }
    });
}

TEST_CASE("physical units: the derivative helper is the slope of the value helper") {
    for_each_case([](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        C::for_each_dimension([]<int dim>() {
            const double H = 1e-3;
            for (double q : {0.1, 0.4, 0.55, 0.8}) {
                INFO(K::name << " in " << dim << "D at q = " << q);
                const auto value = [&](double r) { return kernel_value<K, dim>(r, H); };
                CHECK(kernel_derivative<K, dim>(q * H, H) == Approx(slope(value, q * H, 1e-3 * H)).epsilon(1e-8));
                CHECK(kernel_value<K, dim>(q * H, H) ==
                      Approx(K::template normalisation<dim>() * std::pow(H, -dim) * K::value(q)).epsilon(1e-14));
            }
        });
    });
}

TEST_CASE("the second derivative is the slope of the derivative, and a pair gives it in physical units") {
    for_each_case([](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        static_assert(HasSecondDerivative<K>);
        for (double q : sample_points()) {
            INFO(K::name << " at q = " << q);
            const double step = step_at(q);
            const double round_off = 2e-16 * std::abs(K::derivative(q)) / step;
            CHECK(K::second_derivative(q) == Approx(slope([](double x) { return K::derivative(x); }, q, step))
                                                 .epsilon(1e-9)
                                                 .margin(1e-9 * std::abs(K::derivative(q)) + 8 * round_off));
        }
        CHECK(K::second_derivative(1.0) == 0.0);
        CHECK(K::second_derivative(1.5) == 0.0);
        C::for_each_dimension([]<int dim>() {
            if constexpr (dim > 1) {
                const double H = 0.02, r = 0.3 * H;
                const Pair<dim, double> pair(Vector<double, dim>{r}, r, SupportRadius(H), {});
                CHECK(pair.second_derivative(K{}) ==
                      Approx(slope([&](double x) { return kernel_derivative<K, dim>(x, H); }, r, 1e-3 * H))
                          .epsilon(1e-8));
            }
        });
    });
}

TEST_CASE("derivative_over_q times q is the derivative, and it is finite at the centre") {
    int kernels = 0;
    for_each_case([&](auto which) {
        using K = KernelOf<decltype(which)>;
        if constexpr (HasDerivativeOverQ<K>) {
            ++kernels;
            for (double q : sample_points()) {
                INFO(K::name << " at q = " << q);
                CHECK(q * K::derivative_over_q(q) == Approx(K::derivative(q)).epsilon(1e-15).margin(0));
            }
            INFO(K::name);
            // The limit of derivative/q is the curvature at the centre.
            const double second = 2.0 * (K::value(1e-4) - K::value(0.0)) / 1e-8;
            CHECK(K::derivative_over_q(0.0) == Approx(second).epsilon(1e-2));
            CHECK(K::derivative_over_q(1.0) == 0.0);
            CHECK(K::derivative_over_q(1.5) == 0.0);
        }
    });
    CHECK(kernels == 4);
}

TEST_CASE("the Laplacian is the radial Laplacian of the value in the kernel's dimension") {
    int kernels = 0;
    for_each_case([&](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        if constexpr (HasLaplacian<K>) {
            C::for_each_dimension([&]<int dim>() {
                ++kernels;
                const double H = 0.02;
                for (double q : sample_points()) {
                    if (q < 0.02)
                        continue; // w'' and w'/q cancel there down to round-off
                    INFO(K::name << " at q = " << q);
                    const double step = step_at(q);
                    const double second = slope([](double x) { return K::derivative(x); }, q, step);
                    const double laplacian = second + (dim - 1) * K::derivative(q) / q;
                    CHECK(K::laplacian(q) == Approx(laplacian).margin(1e-9 * std::abs(second)).epsilon(1e-9));
                    CHECK(kernel_laplacian<K, dim>(q * H, H) ==
                          Approx(K::template normalisation<dim>() * std::pow(H, -dim - 2) * laplacian)
                              .margin(1e-9 * std::abs(second) * 3 * std::pow(H, -dim - 2))
                              .epsilon(1e-9));
                    CHECK(K::laplacian(q) > 0.0);
                }
                CHECK(K::laplacian(1.0) == 0.0);
                CHECK(K::laplacian(2.0) == 0.0);
            });
        }
    });
    CHECK(kernels == 2);
    // The normalised forms of the literature.
    CHECK(kernel_laplacian<ViscosityKernel, 3>(0.25, 1.0) == Approx(45 / std::numbers::pi * 0.75).epsilon(1e-15));
    CHECK(kernel_laplacian<ViscosityKernel2D, 2>(0.25, 1.0) == Approx(40 / std::numbers::pi * 0.75).epsilon(1e-15));
}

template <class Real>
static void compact_and_signed() {
    for_each_case([](auto which) {
        using K = KernelOf<decltype(which)>;
        INFO(K::name << (sizeof(Real) == 4 ? " in float" : " in double"));
        const Real epsilon = std::numeric_limits<Real>::epsilon();
        for (Real q : {Real(1), Real(1) + epsilon, Real(1.001), Real(1.5), Real(7), Real(1e6)}) {
            INFO("q = " << q);
            CHECK(K::value(q) == Real(0));
            CHECK(K::derivative(q) == Real(0));
        }
        int negative_values = 0, positive_slopes = 0, not_finite = 0;
        const auto look = [&](Real q) {
            negative_values += K::value(q) < Real(0);
            positive_slopes += K::derivative(q) > Real(0);
            not_finite += !std::isfinite(K::value(q)) || !std::isfinite(K::derivative(q));
        };
        for (int k = 0; k <= 20000; ++k)
            look(Real(k) / Real(20000));
        for (int k = 0; k < 60; ++k) { // close to the centre and to the rim
            look(std::ldexp(Real(1), -k));
            look(Real(1) - std::ldexp(Real(1), -k));
        }
        CHECK(negative_values == 0);
        CHECK(positive_slopes == 0);
        CHECK(not_finite == 0);
        CHECK(K::value(Real(0)) > Real(0));
    });
}

TEST_CASE("a kernel is zero from the rim on, never negative, never rising, always finite (double)") {
    compact_and_signed<double>();
}
TEST_CASE("a kernel is zero from the rim on, never negative, never rising, always finite (float)") {
    compact_and_signed<float>();
}

TEST_CASE("the equations of the paper, (13), (14) and (20), in its own form") {
    const double h = 1e-3;
    const double pi = std::numbers::pi;
    for (double d : {0.1e-3, 0.37e-3, 0.5e-3, 0.93e-3}) {
        CHECK(kernel_value<Spiky, 3>(d, h) == Approx(15 / (pi * std::pow(h, 6)) * std::pow(h - d, 3)).epsilon(1e-12));
        CHECK(
            kernel_value<ViscosityKernel, 3>(d, h) ==
            Approx(15 / (2 * pi * std::pow(h, 3)) * (-d * d * d / (2 * h * h * h) + d * d / (h * h) + h / (2 * d) - 1))
                .epsilon(1e-10));
        CHECK(kernel_value<Poly6, 3>(d, h) ==
              Approx(315 / (64 * pi * std::pow(h, 9)) * std::pow(h * h - d * d, 3)).epsilon(1e-12));
    }
}

TEST_CASE("the splines are those of the literature, whose h is half or a third of the support") {
    const double h = 0.5;
    const double pi = std::numbers::pi;
    for (double x : {0.2, 0.9, 1.4, 1.9}) {
        const double cubic = x < 1 ? 1 - 1.5 * x * x + 0.75 * x * x * x : 0.25 * std::pow(2 - x, 3);
        CHECK(kernel_value<CubicSpline, 2>(x * h, 2 * h) == Approx(10 / (7 * pi * h * h) * cubic).epsilon(1e-13));
        CHECK(kernel_value<CubicSpline, 3>(x * h, 2 * h) == Approx(1 / (pi * h * h * h) * cubic).epsilon(1e-13));
    }
    // Morris, Fox and Zhu (1997): 7/(478 pi h^2) * 66 at the centre.
    CHECK(kernel_value<QuinticSpline, 2>(0.0, 3 * h) == Approx(7 * 66 / (478 * pi * h * h)).epsilon(1e-14));
    CHECK(kernel_value<QuinticSpline, 3>(0.0, 3 * h) == Approx(66 / (120 * pi * h * h * h)).epsilon(1e-14));
}

TEST_CASE("the slope at the centre: spiky keeps it, the bells lose it") {
    CHECK(Spiky::derivative(0.0) == -3.0);
    CHECK(Poly6::derivative(0.0) == 0.0);
    CHECK(CubicSpline::derivative(0.0) == 0.0);
    CHECK(QuinticSpline::derivative(0.0) == 0.0);
    CHECK(WendlandC2::derivative(0.0) == 0.0);
    CHECK(WendlandC4::derivative(0.0) == 0.0);
    CHECK(WendlandC6::derivative(0.0) == 0.0);
    // No digits are lost on the way there.
    CHECK(CubicSpline::derivative(1e-12) == Approx(-6e-12).epsilon(1e-11).margin(0));
    CHECK(QuinticSpline::derivative(1e-12) == Approx(-1080e-12).epsilon(1e-11).margin(0));
}

TEST_CASE("the viscosity kernels stay at their floor near the centre") {
    CHECK(ViscosityKernel::value(0.0) == ViscosityKernel::value(1e-6));
    CHECK(ViscosityKernel::value(0.0) == Approx(0.5e6).epsilon(1e-5));
    CHECK(ViscosityKernel2D::value(0.0) == Approx(6 * std::log(10.0) - 5.0 / 6).epsilon(1e-11));
    CHECK(ViscosityKernel::laplacian(0.0) == 6.0);
}

TEST_CASE("float agrees with double") {
    for_each_case([](auto which) {
        using K = KernelOf<decltype(which)>;
        for (double q : sample_points()) {
            INFO(K::name << " at q = " << q);
            const float p = static_cast<float>(q);
            const double exact = static_cast<double>(p);
            CHECK(double(K::derivative(p)) == Approx(K::derivative(exact)).epsilon(2e-6).margin(0));
            // The logarithm's round-off is that of numbers near 1 also where the kernel is small.
            const double margin = std::is_same_v<K, ViscosityKernel2D> ? 2e-7 : 0.0;
            CHECK(double(K::value(p)) == Approx(K::value(exact)).epsilon(2e-6).margin(margin));
        }
    });
}

// Constant evaluation: the kernels can be tabulated, asserted on and dry-run at compile time.
namespace {

constexpr bool close(double a, double b, double tolerance) {
    return a - b < tolerance && b - a < tolerance;
}

template <class K>
constexpr bool usable_in_constants() {
    return K::value(0.25) > K::value(0.5) && K::value(1.0) == 0.0 && K::derivative(0.5) < 0.0 &&
           K::derivative(1.0) == 0.0 && K::value(0.5f) > 0.0f && K::value(Number<double>(0.5)).lanes == K::value(0.5);
}
static_assert(HasCubicSlope<WendlandC2> && !HasCubicSlope<WendlandC4> && !HasCubicSlope<CubicSpline>);
static_assert(usable_in_constants<Spiky>());
static_assert(usable_in_constants<Poly6>());
static_assert(usable_in_constants<CubicSpline>());
static_assert(usable_in_constants<QuinticSpline>());
static_assert(usable_in_constants<WendlandC2>());
static_assert(usable_in_constants<WendlandC4>());
static_assert(usable_in_constants<WendlandC6>());
static_assert(usable_in_constants<ViscosityKernel>());
static_assert(usable_in_constants<ViscosityKernel2D>());
static_assert(close(ViscosityKernel2D::value(0.5), 0.375 - 1.0 / 12 + std::numbers::ln2 - 5.0 / 6, 1e-15));
static_assert(close(ViscosityKernel2D::value(1e-5), 5 * std::numbers::ln10 - 5.0 / 6, 1e-9));
static_assert(kernel_value<WendlandC2, 3>(0.0, 2.0) == 21 / (2 * std::numbers::pi) / 8);
static_assert(kernel_derivative<Spiky, 3>(2.0f, 2.0f) == 0.0f);
static_assert(std::is_empty_v<Spiky> && std::is_empty_v<ViscosityKernel>);

struct NotAKernel {
    static constexpr const char* name = "no derivative";
    template <int dim>
    static constexpr double normalisation() {
        return 1;
    }
    template <class T>
    static constexpr T value(T q) {
        return q;
    }
};
static_assert(!Kernel<NotAKernel>);
static_assert(!Kernel<double>);
static_assert(!HasDerivativeOverQ<Spiky> && HasDerivativeOverQ<WendlandC2>);
static_assert(!HasLaplacian<Poly6> && HasLaplacian<ViscosityKernel>);

// However a pair loop shares out the constants of a kernel, what comes out is the kernel.
template <class Real>
void pairs_see_the_kernel(double rounding) {
    for_each_case([&](auto which) {
        using C = decltype(which);
        using K = KernelOf<C>;
        C::for_each_dimension([&]<int dim>() {
            using T = Number<Real>;
            for (const double H : {0.7e-3, 0.02, 30.0}) {
                const auto pair_at = [](double q, double support, double radius) {
                    auto offset = Vector<T, dim>::zero();
                    offset[0] = T(q * support);
                    return Pair<dim, T>(offset, offset[0], SupportRadius(radius), Vector<double, dim>::zero());
                };
                for (double q : sample_points()) {
                    INFO(K::name << " in " << dim << "D at q = " << q << " of H = " << H << " m");
                    const auto ab = pair_at(q, H, H);
                    const double r = static_cast<double>(ab.distance[0]);
                    // Of float's numbers, what is lost where 1 - q is small as well.
                    const double lost = 20 * rounding / (1 - q);
                    // This one's value is a logarithm near q - 1 less a polynomial near it.
                    const double difference = std::is_same_v<K, ViscosityKernel2D>
                                                  ? 2 * rounding * (1 - q) * K::template normalisation<dim>() / (H * H)
                                                  : 0;
                    const double value = kernel_value<K, dim>(r, H), slope = kernel_derivative<K, dim>(r, H);
                    CHECK(double(ab.value(K{})[0]) == Approx(value).epsilon(lost).margin(difference));
                    CHECK(double(ab.gradient(K{})[0]) * r == Approx(slope).epsilon(lost).margin(0));
                    // A pair with a shorter support is that of the shorter support.
                    const auto narrow = pair_at(q, H, 3 * H).within(H);
                    CHECK(narrow.value(K{})[0] == ab.value(K{})[0]);
                    CHECK(narrow.gradient(K{})[0] == ab.gradient(K{})[0]);
                    CHECK(ab.within(2 * H).gradient(K{})[0] == ab.gradient(K{})[0]);
                }
                INFO(K::name << " in " << dim << "D beyond the rim of H = " << H << " m");
                for (double q : {1.00001, 1.5}) {
                    CHECK(pair_at(q, H, H).value(K{})[0] == Real(0));
                    CHECK(pair_at(q, H, H).gradient(K{})[0] == Real(0));
                }
            }
        });
    });
}

} // namespace

TEST_CASE("a pair sees the kernel's value and slope at its distance, and of a shorter support those of that") {
    pairs_see_the_kernel<double>(2.3e-16);
    pairs_see_the_kernel<float>(1.2e-7);
}

TEST_CASE("the cube root is the same when compiling") {
    static constexpr std::array numbers{0.0, 1e-300, 1.7e-9, 0.2, 1.0, 8.0, 27.0, 3.3e14, 1e300};
    constexpr auto roots = [] {
        std::array<double, numbers.size()> found{};
        for (std::size_t k = 0; k < numbers.size(); ++k)
            found[k] = cube_root(numbers[k]);
        return found;
    }();
    for (std::size_t k = 0; k < numbers.size(); ++k)
        CHECK(roots[k] == Approx(std::cbrt(numbers[k])).epsilon(4e-16).margin(0));
}
