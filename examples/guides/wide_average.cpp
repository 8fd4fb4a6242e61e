// A sum of one's own that reaches further than the other terms: the velocity averaged over five spacings, as models of
// turbulence need it. It has its own neighbours and its own number of the lattice; the other terms do not pay for it.
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

/// The velocity of the particles around, m/s.
struct MeanVelocity : sph::Field<sph::Rank::vector> {
    static constexpr std::string_view name = "mean_velocity", unit = "m/s";
    static constexpr bool shown = true; // in snapshots
};
inline constexpr MeanVelocity mean_velocity{};

struct AverageParameters {
    double spacings = 5; ///< how far it reaches
};

/// sum_b V_b v_b W_ab/S over 5 spacings, where S is what sum_b V_b W_ab is on the lattice.
struct Average {
    using Parameters = AverageParameters;
    static double support_radius(const auto& material, const AverageParameters& p) {
        return p.spacings * material.spacing;
    }

    struct Prepared {
        double on_lattice = 1;
    };
    template <int dim>
    static Prepared prepare(const auto&, const sph::Lattice<dim>& lattice) {
        const double others = lattice.sum([](const auto& ab) { return ab.value(K{}); });
        return {lattice.volume() * (sph::kernel_value<K, dim>(0.0, lattice.support_radius) + others)};
    }
    Prepared prepared{}; // filled in

    using reads = sph::Fields<sph::mass, sph::density, sph::velocity>;
    using adds = sph::Fields<mean_velocity>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return (ab.value(K{}) * b[sph::mass] / (b[sph::density] * prepared.on_lattice)) * b[sph::velocity];
    }
};

struct Water : sph::Fluid<sph::Tait<7>, sph::WeaklyCompressible<K>, Average> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    const double dx = 0.02;
    Scene scene({.support_radius = 2.6 * dx, .periodic_length = {1, 1}});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    const auto wave = [](double y, int number) { return std::sin(2 * std::numbers::pi * number * y); };
    for (int i = 0; i < scene[water].size(); ++i) {
        const double y = scene[water][sph::position](i, 1);
        scene[water][sph::velocity](i, 0) = 0.1 * wave(y, 1) + 0.1 * wave(y, 12);
    }
    scene.step(1e-9);

    // Over five spacings a wave over 4 of them is averaged away, and one over 50 is not.
    double slow = 0, quick = 0;
    for (int i = 0; i < scene[water].size(); ++i) {
        const double y = scene[water][sph::position](i, 1), v = scene[water][mean_velocity](i, 0);
        slow += 2 * v * wave(y, 1) / scene[water].size();
        quick += 2 * v * wave(y, 12) / scene[water].size();
    }
    std::printf("of 0.1 m/s the average keeps %.4f m/s of the long wave and %.4f m/s of the short one\n%s", slow, quick,
                sph::describe(scene).c_str());
    return slow > 0.095 && slow < 0.1 && std::abs(quick) < 0.02 ? 0 : 1;
}
