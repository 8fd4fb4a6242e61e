// Brings an elastic body to rest: statics with a dynamic scheme.
#pragma once

#include <imbibe/core/fields.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace imbibe {

/// Critical damping of a phase at its dominant frequency, found anew after each step from Rayleigh's quotient, r^2 =
/// -sum v.da/(dt sum v.v), 1/s^2: v becomes v (1 - r dt)/(1 + r dt). A body comes to rest under a constant load in a
/// few periods of its slowest motion.
///
/// Call it after each step, with Settings::cfl at most 0.5: with longer steps the damping of the fastest motions is
/// unstable.
/// <!-- tests/monitor/test_dynamic_relaxation.cpp -->
/// ```
/// DynamicRelaxation relaxation;
/// scene.run_until(end, [&](auto& s) { relaxation(s[body], s.time()); });
/// ```
///
/// Not for real motion: only the static result is right. Not beside a liquid.
///
/// Source: Underwood (1983), adaptive dynamic relaxation; here with the velocities in the quotient.
class DynamicRelaxation {
public:
    /// Damps `body`. @param body a view of the phase, `scene[phase]` @param time of the scene, s
    template <class View>
    void operator()(const View& body, double time) {
        const auto speeds = body[velocity];
        const Eigen::MatrixXd v = speeds.template cast<double>(), now = body[acceleration].template cast<double>();
        const double dt = time - time_, motion = v.squaredNorm();
        time_ = time;
        if (dt > 0 && motion > 0 && ids_ == body.ids()) // not if particles were re-sorted
            rate_ = std::sqrt(std::max(-v.cwiseProduct(now - before_).sum() / (dt * motion), 0.0));
        if (dt > 0)
            body[velocity] = (v * std::max((1 - rate_ * dt) / (1 + rate_ * dt), 0.0))
                                 .template cast<typename std::decay_t<decltype(speeds)>::Scalar>();
        before_ = now;
        ids_ = body.ids();
    }
    /// r of the last step, 1/s; 1/r is about the decay time of the remaining motion.
    [[nodiscard]] double rate() const { return rate_; }

private:
    Eigen::MatrixXd before_;
    std::vector<std::uint32_t> ids_;
    double time_ = 0, rate_ = 0;
};

} // namespace imbibe
