// The resolution of the sponge scene by a word: the spacing and the support of its water, and the resulting accuracy.
#pragma once

#include <imbibe/presets/sponge_case.hpp>

#include <array>
#include <string_view>

namespace imbibe::presets {

/// A choice among the runs of docs/accuracy.md.
struct SpongeAccuracy {
    std::string_view name; ///< the word
    double water_spacing; ///< m
    double support_ratio; ///< H of the water in spacings
    double difference;    ///< of the sponge's mean displacement until 0.15 s from that of the finest run, as a share
};

/// `SoundSponge`, coarse to fine; `standard` has the paper's spacing. With a support of 2 spacings the same difference
/// costs less, but water under tension opens (docs/stability.md), so all three have 2.6.
inline constexpr std::array<SpongeAccuracy, 3> sponge_accuracies{
    {{"draft", 1.0e-3, 2.6, 0.18}, {"standard", 0.8e-3, 2.6, 0.14}, {"reference", 0.6e-3, 2.6, 0.10}}};

/// Sets the resolution of a case by a word, and returns its numbers. On a strip, which is periodic, the spacing is the
/// nearest that divides the period. Throws Error for a word that is not in sponge_accuracies.
inline const SpongeAccuracy& set_accuracy(SpongeCase& c, std::string_view name) {
    for (const SpongeAccuracy& known : sponge_accuracies)
        if (known.name == name) {
            const double rows = c.width() / known.water_spacing;
            c.water_spacing = c.strip ? c.width() / std::round(rows) : known.water_spacing;
            c.support_ratio = known.support_ratio;
            return known;
        }
    throw Error(text("there is no accuracy '", name, "'; there are draft, standard and reference"));
}

} // namespace imbibe::presets
