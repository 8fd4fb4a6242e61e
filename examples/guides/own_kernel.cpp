// A smoothing kernel of one's own: Lucy's, in which a standing sound wave keeps its period and its height.
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;

/// w(q) = (1 - q)^3 (1 + 3 q) with q = |x_a - x_b|/H. Source: Lucy (1977).
struct Lucy {
    static constexpr const char* name = "Lucy";
    /// 5/pi, 105/(16 pi) in 2, 3 dimensions: the integral of W over space is 1.
    template <int dim>
    static constexpr double normalisation() {
        return dim == 2 ? 5 / std::numbers::pi : 105 / (16 * std::numbers::pi);
    }
    template <class T> // T: a number, or as many as the processor computes at once
    static constexpr T value(T q) {
        return sph::power<3>(sph::positive_part(T(1) - q)) * (T(1) + T(3) * q);
    }
    template <class T>
    static constexpr T derivative(T q) {
        return q * derivative_over_q(q);
    }
    /// Optional. With it a gradient needs no division by the distance.
    template <class T>
    static constexpr T derivative_over_q(T q) {
        return T(-12) * sph::power<2>(sph::positive_part(T(1) - q));
    }
};
static_assert(sph::Kernel<Lucy> && sph::HasDerivativeOverQ<Lucy>);

struct Water : sph::Fluid<sph::LinearState, sph::Continuity<Lucy>, sph::VolumePressure<Lucy>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    // A periodic box, one wave long; the density is 0.1 % higher at its ends than on average.
    const double dx = 1.0 / 40, c = 10, period = 1 / c;
    Scene scene({.support_radius = 3 * dx, .cfl = 0.2, .periodic_length = {1, 0.25}});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = c}}, sph::fill(sph::Box<2>({0, 0}, {1, 0.25}), dx), dx);
    auto view = scene[water];
    const auto wave = [&](int i) { return std::cos(2 * std::numbers::pi * view[sph::position](i, 0)); };
    for (int i = 0; i < view.size(); ++i)
        view[sph::density](i) += wave(i);
    const auto height = [&] {
        double sum = 0;
        for (int i = 0; i < view.size(); ++i)
            sum += 2 * (view[sph::density](i) - 1000) * wave(i) / view.size();
        return sum;
    };

    const double start = height();
    scene.run_until(period / 2);
    const double half = height();
    scene.run_until(period);
    const double whole = height();
    std::printf("height of the wave %.4f kg/m^3, after half a period %.4f, after a whole one %.4f\n", start, half,
                whole);
    return std::abs(start - 1) < 1e-6 && std::abs(half + 1) < 0.02 && std::abs(whole - 1) < 0.02 ? 0 : 1;
}
