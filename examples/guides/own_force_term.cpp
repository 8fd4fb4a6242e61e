// A force of one's own that needs a field of its own: warm water rises, and cools. The field is stored, integrated,
// written to snapshots and kept in checkpoints because a term names it; nothing else says so.
#include <imbibe/imbibe.hpp>
#include <imbibe/output/checkpoint.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>

namespace sph = imbibe;

/// How much warmer than its surroundings, K.
struct Warmth : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "warmth", unit = "K";
    static constexpr std::string_view rate_name = "warmth_rate", rate_unit = "K/s";
};
inline constexpr Warmth warmth{};
inline constexpr sph::Rate<Warmth> warmth_rate{};

struct BuoyancyParameters {
    double expansion = 0.1;    ///< of the volume, 1/K
    double cooling_time = 0.5; ///< s
};

/// dv/dt = -expansion warmth g, and d(warmth)/dt = -warmth/cooling_time.
struct Buoyancy {
    using Parameters = BuoyancyParameters;
    struct Cool {
        using reads = sph::Fields<warmth>;
        using adds = sph::Fields<warmth_rate>;
        BuoyancyParameters parameters{};
        constexpr auto operator()(const auto& a) const { return -a[warmth] / parameters.cooling_time; }
    };
    struct Rise {
        using reads = sph::Fields<warmth>;
        using adds = sph::Fields<sph::acceleration>;
        BuoyancyParameters parameters{};
        constexpr auto operator()(const auto& a) const { return -parameters.expansion * a[warmth] * a.gravity(); }
    };
    using parts = sph::Parts<Cool, Rise>;
};

struct Plume : sph::Fluid<Buoyancy> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Plume>;

Scene make() {
    Scene scene({.gravity = {0, -10}, .support_radius = 0.1, .time_step = 1e-4});
    const auto plume = scene.add(Plume{{.density = 1000, .sound_speed = 1}}, {{0, 0}, {1, 0}}, 0.05);
    scene[plume][warmth](1) = 20; // the other one stays as cold as what is around it, and falls
    return scene;
}

int main() {
    const sph::PhaseHandle<Plume> plume;
    Scene scene = make(), other = make();
    scene.run_until(0.5);
    sph::write_checkpoint(scene, "own_force_term.checkpoint");
    scene.run_until(1, sph::every(0.5, sph::Snapshots("out-own-force-term")));
    sph::read_checkpoint(other, "own_force_term.checkpoint");
    other.run_until(1);

    // v = g (t - expansion warmth_0 T (1 - exp(-t/T)))
    const double T = 0.5, expected = -10 * (1 - 0.1 * 20 * T * (1 - std::exp(-1 / T)));
    const double cold = scene[plume][sph::velocity](0, 1), warm = scene[plume][sph::velocity](1, 1);
    std::ifstream file("out-own-force-term/plume_000000.vtp", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const bool written = text.find("\"warmth") != std::string::npos;
    const bool same = other[plume][warmth](1) == scene[plume][warmth](1) && other[plume][sph::velocity](1, 1) == warm;
    std::printf("after 1 s cold %.4f m/s, warm %.4f m/s, expected %.4f m/s; in the snapshots: %s; restart: %s\n", cold,
                warm, expected, written ? "yes" : "no", same ? "same bits" : "differs");
    return std::abs(cold + 10) < 1e-9 && std::abs(warm - expected) < 1e-2 && written && same ? 0 : 1;
}
