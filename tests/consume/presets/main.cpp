// A program that takes the scene of a preset from the library imbibe::presets instead of compiling it: its water, out
// of reach of sponge and walls, falls as everything does.
#include <imbibe/presets/sponge.hpp>

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
    return std::abs(speed + numbers.gravity * end) < 1e-5 * numbers.gravity * end ? 0 : 1;
}
