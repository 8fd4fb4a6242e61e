// The code of progress.hpp: prints the line.
#pragma once

#include <imbibe/monitor/progress.hpp>

namespace imbibe {

IMBIBE_CODE void Progress::note(const Moment& scene) {
    const auto now = Clock::now();
    const bool done = scene.time >= end_ * (1 - 1e-12);
    work_ += static_cast<double>(scene.particles);
    if (first_) { // the first call comes before the first step
        first_ = false;
        work_ = 0;
        begin_ = scene.time;
    }
    if (!cut_off(scene.last_step))
        whole_step_ = scene.last_step;
    if (!done && seconds(shown_, now) < (live_ ? 0.5 : 20))
        return;
    shown_ = now;
    std::printf("%s%s%s", live_ ? "\r" : "", line_of(scene).c_str(), live_ && !done ? "   " : "\n");
    std::fflush(stdout);
}

IMBIBE_CODE std::string Progress::line_of(const Moment& scene) const {
    const TimeStepLimit& step = cut_off(scene.last_step) && whole_step_.seconds > 0 ? whole_step_ : scene.last_step;
    const double wall = wall_seconds(), share = end_ > begin_ ? (scene.time - begin_) / (end_ - begin_) : 1;
    const int decimals = std::isnormal(end_) ? std::clamp(3 - static_cast<int>(std::log10(end_)), 4, 12) : 4;
    char numbers[120], pace[60];
    std::snprintf(numbers, sizeof numbers, "%5.1f %%  t %.*f s  step %lld  dt %.2e s (", 100 * share, decimals,
                  scene.time, scene.steps, step.seconds);
    std::snprintf(pace, sizeof pace, ")  %.2f M particle-steps/s  left ", work_ / wall * 1e-6);
    return numbers + step.reason + ", " + step.where + pace +
           (share > 0 ? clock_text(wall * (1 - share) / share) : "?");
}

} // namespace imbibe
