// The two compositions of the sponge on a strip with a pool, in float and double: the sound one's solid takes short
// steps of its own, and neighbours serve several steps.
#include "bits.hpp"

#include <imbibe/presets/sponge.hpp>

namespace imbibe_test {

void run_sponges(Record& record) {
    imbibe::presets::SpongeCase numbers;
    numbers.strip = true;
    numbers.pool = 7e-3;
    numbers.water_spacing = 0.875e-3;
    numbers.solid_spacing = 1e-3;
    numbers.support_radius = 2e-3;
    record.run_both("sound sponge", [&]<class Real>(Real, int threads) {
        auto with = numbers;
        with.threads = threads;
        return imbibe::presets::SoundSponge::make<Real>(with);
    });
    record.run_both("paper sponge", [&]<class Real>(Real, int threads) {
        auto with = numbers;
        with.threads = threads;
        return imbibe::presets::PaperSponge::make<Real>(with);
    });
}

} // namespace imbibe_test
