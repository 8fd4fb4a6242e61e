// A program that takes the scenes of two presets from the library imbibe::presets instead of compiling them: water that
// is out of reach of sponge and walls falls as everything does.
#include <imbibe/presets/sound_sponge.hpp>
#include <imbibe/solver/describe.hpp>

#include <cmath>
#include <cstdio>

int main() {
    using Preset = imbibe::presets::SoundSponge;
    const imbibe::presets::SpongeCase numbers{.water_spacing = 1.75e-3,
                                              .solid_spacing = 1e-3,
                                              .gap = 10e-3,
                                              .strip = true,
                                              .pool = 7e-3,
                                              .wall_gap = 5.25e-3,
                                              .threads = 1};
    auto scene = Preset::make<float>(numbers);
    const double end = 2e-3;
    scene.run_until(end);
    const double speed = scene.get<Preset::Water>()[imbibe::velocity].col(2).cast<double>().mean();
    std::printf("%s\nafter %g s the water falls with %g m/s, g t = %g m/s\n", imbibe::describe(scene).c_str(), end,
                -speed, numbers.gravity * end);

    using Plane = imbibe::presets::SoundWater;
    Plane::Scene<2, double> drop({.gravity = {0, -9.81}, .support_radius = 0.026});
    Plane::Water water{{.density = 1000, .sound_speed = 10}};
    Plane::set_coefficients(water);
    const auto pool = drop.add(water, {{0, 1}}, 0.01);
    drop.run_until(end);
    const double of_the_drop = drop[pool][imbibe::velocity](0, 1);
    return std::abs(speed + numbers.gravity * end) < 1e-5 * numbers.gravity * end &&
                   std::abs(of_the_drop + 9.81 * end) < 1e-9
               ? 0
               : 1;
}
