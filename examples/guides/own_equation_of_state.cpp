// An equation of state of one's own, with coefficients and a limit on the time step: van der Waals' gas, in which sound
// has the speed that thermodynamics asks for.
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct VanDerWaalsParameters {
    double rt = 8e4; ///< gas constant times temperature, J/kg
    double a = 50;   ///< attraction, Pa m^6/kg^2
    double b = 5e-4; ///< volume of the molecules, m^3/kg

    constexpr double pressure(double rho) const { return rho * rt / (1 - b * rho) - a * rho * rho; }
    double sound_speed(double rho) const { return std::sqrt(rt / sph::sq(1 - b * rho) - 2 * a * rho); }
    /// Refuses what has no speed of sound. @param where the phase, for the message
    void check(std::string_view where) const {
        sph::require(rt > 0 && a >= 0 && b >= 0, where, ": a van der Waals gas needs rt > 0, a >= 0 and b >= 0");
    }
};

/// p = rho rt/(1 - b rho) - a rho^2, less the pressure at rest, Pa.
struct VanDerWaals {
    using Parameters = VanDerWaalsParameters;
    using reads = sph::Fields<sph::density>;
    using sets = sph::Fields<sph::pressure>;
    Parameters parameters{};

    constexpr auto operator()(const auto& a) const {
        const auto rho = a[sph::density];
        return rho * parameters.rt / (1 - parameters.b * rho) - parameters.a * sph::sq(rho) -
               parameters.pressure(a.material.density);
    }
    static constexpr const char* limit_name = "sound in the gas";
    static double time_step_limit(const auto& material, const sph::TimeStepInput& in, const Parameters& gas) {
        return in.spacing / (gas.sound_speed(material.density) + in.max_speed);
    }
};

struct Gas : sph::Fluid<VanDerWaals, sph::Continuity<K>, sph::VolumePressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Gas>;

int main() {
    const VanDerWaalsParameters coefficients{.a = 100};
    const double dx = 1.0 / 80, rho = 100, c = coefficients.sound_speed(rho), period = 1 / c;
    Scene scene({.support_radius = 3 * dx, .cfl = 0.1, .periodic_length = {1, 0.125}});
    Gas gas{{.density = rho, .sound_speed = c}};
    gas.set(coefficients);
    const auto box = scene.add(gas, sph::fill(sph::Box<2>({0, 0}, {1, 0.125}), dx), dx);
    auto view = scene[box];
    const auto wave = [&](int i) { return std::cos(2 * std::numbers::pi * view[sph::position](i, 0)); };
    for (int i = 0; i < view.size(); ++i)
        view[sph::density](i) += 0.1 * wave(i);
    const auto height = [&] {
        double sum = 0;
        for (int i = 0; i < view.size(); ++i)
            sum += 2 * (view[sph::density](i) - rho) * wave(i) / view.size();
        return sum;
    };
    scene.run_until(period / 4);
    const double quarter = height();
    scene.run_until(period / 2);
    std::printf(
        "limited by %s, c = %.1f m/s; wave of 0.1 kg/m^3, after a quarter of a period %.4f, after half of it %.4f\n",
        scene.time_step_limits().front().reason.c_str(), c, quarter, height());
    return std::abs(quarter) < 0.002 && std::abs(height() + 0.1) < 0.002 ? 0 : 1;
}
