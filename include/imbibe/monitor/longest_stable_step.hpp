// The longest stable step of a scene in its present state, found by disturbing it: for forces and bodies without a
// known limit.
#pragma once

#include <imbibe/geometry/sampling.hpp>
#include <imbibe/solver/solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace imbibe {

/// Numbers of `longest_stable_step`.
struct StableStepSettings {
    /// Relative tolerance of the step.
    double tolerance = 0.03;
    /// Number of steps for which a disturbance is followed, for each step length tried.
    int steps = 100;
    /// A step is too long if a disturbance grows in each step by more than this factor beyond its growth in the same
    /// time with short steps. That growth does not depend on the step: a heavy fluid sinks into a light one, particles
    /// in tension draw together.
    double growth = 1.05;
    /// Size of the disturbances, in spacings: small, so that everything is linear, but large compared with the rounding
    /// of coordinates. 0: 1e-6 in double, 1e-3 in float.
    double size = 0;

    /// Throws Error for a number out of range.
    void check() const {
        require(tolerance > 0 && tolerance <= 0.5, "StableStepSettings::tolerance = ", tolerance,
                "; it must be above 0 and at most 0.5");
        require(steps >= 20, "StableStepSettings::steps = ", steps, "; it must be at least 20");
        require(growth > 1 && growth <= 2, "StableStepSettings::growth = ", growth,
                "; it must be above 1 and at most 2");
        require(size >= 0 && size <= 0.1, "StableStepSettings::size = ", size,
                " spacings; it must be at most 0.1, or 0 for 1e-6 (in float 1e-3)");
    }
};

namespace detail {

/// Three copies of a scene: one stays unchanged, one takes an undisturbed step and one a disturbed step. The difference
/// after the step is the next disturbance: power iteration with the step's own derivative.
template <class Scene>
class DisturbedScene {
public:
    DisturbedScene(const Scene& scene, double size) : start_(scene), size_(size) {
        start_.prepare();
        for (const Phase& s : start_.engine().phases)
            if (s.size() > 0)
                spacing_ = std::min(spacing_, s.numbers().spacing);
    }

    /// The shortest known limit, or the longest step that the settings allow, s.
    double first_step() const {
        const auto limits = start_.time_step_limits();
        return limits.empty() ? start_.settings().max_time_step : limits.front().seconds;
    }
    /// The logarithm of the growth factor of a disturbance in a step of `dt`, s: the mean over the later half of
    /// `steps` steps, less the growth of displacements by a constant velocity in that time. Infinite if it cannot be
    /// determined.
    double growth(double dt, int steps) {
        constexpr double beyond_doubt = 50, infinity = std::numeric_limits<double>::infinity();
        undisturbed_ = start_;
        try {
            undisturbed_.step(dt);
            shake(dt);
            double grown = 0;
            for (int k = 0; k < steps; ++k) {
                disturbed_ = start_;
                disturb();
                disturbed_.step(dt);
                const double by = std::log(compare(dt)); // -infinity if the disturbance vanishes
                if (!(by < beyond_doubt))
                    return infinity;
                if (by < -beyond_doubt)
                    return by;
                if (k >= steps / 2)
                    grown += by;
            }
            return (grown - std::log(2.0)) / (steps - steps / 2);
        } catch (const Error&) {
            return infinity;
        }
    }

private:
    using Phase = typename Scene::Engine::Phase;

    Scene start_, undisturbed_ = start_, disturbed_ = start_;
    double size_; // in spacings
    double spacing_ = std::numeric_limits<double>::infinity();
    // By phase: the disturbance of each of its numbers, column after column, in the order of `start_`.
    std::array<std::vector<double>, Scene::Phases::size> disturbance_;

    // All velocities at random.
    void shake(double dt) {
        for (std::size_t k = 0; k < disturbance_.size(); ++k) {
            const Phase& s = start_.engine().phases[k];
            const auto n = static_cast<std::size_t>(s.size());
            disturbance_[k].assign(n * static_cast<std::size_t>(s.row->components), 0.0);
            for (std::size_t d = 0; s.row->moves && d < Scene::dimension; ++d)
                for (std::size_t i = 0; i < n; ++i)
                    disturbance_[k][(static_cast<std::size_t>(s.row->velocity) + d) * n + i] =
                        size_ * spacing_ / dt * (2 * random_number(1, i, d) - 1);
        }
    }
    void disturb() {
        const auto disturb_phase = [&]<class P>(std::type_identity<P>) {
            Phase& s = disturbed_[PhaseHandle<P>{}].state.store;
            const double* by = disturbance_[Scene::Scene::template phase_index<P>].data();
            for (int k = 0; k < s.row->components; ++k)
                for (int i = 0; i < s.size(); ++i, ++by)
                    s.column(k)[i] = static_cast<typename Scene::Real>(static_cast<double>(s.column(k)[i]) + *by);
            s.note_all_written();
            s.pad();
        };
        [&]<class... P>(TypeList<P...>) { (disturb_phase(std::type_identity<P>{}), ...); }(typename Scene::Phases{});
    }
    // The difference of the two scenes becomes the disturbance, rescaled to its former size; returns its growth factor.
    double compare(double dt) {
        double greatest = 0;
        for (std::size_t k = 0; k < disturbance_.size(); ++k)
            if (start_.engine().phases[k].size() > 0)
                greatest = std::max(greatest, subtract(k, dt));
        const double grown = greatest / (size_ * spacing_);
        for (auto& numbers : disturbance_)
            for (double& number : numbers)
                number /= grown;
        return grown;
    }
    // The greatest difference of a particle's position, or of its velocity times dt, in a phase, m.
    double subtract(std::size_t phase, double dt) {
        const Phase &start = start_.engine().phases[phase], &a = undisturbed_.engine().phases[phase],
                    &b = disturbed_.engine().phases[phase];
        const std::vector<int> place_in_a = places_by_id(a), place_in_b = places_by_id(b);
        double* to = disturbance_[phase].data();
        double greatest = 0;
        for (int k = 0; k < start.row->components; ++k) {
            const int axis = k - start.row->position;
            const bool is_place = axis >= 0 && axis < Scene::dimension;
            const double period = is_place ? start_.settings().periodic_length[static_cast<std::size_t>(axis)] : 0.0;
            double unit = is_place ? 1 : 0; // converts it to a displacement
            if (const int d = k - start.row->velocity; start.row->moves && d >= 0 && d < Scene::dimension)
                unit = dt;
            for (const std::uint32_t id : start.ids) {
                double by =
                    static_cast<double>(b.column(k)[place_in_b[id]]) - static_cast<double>(a.column(k)[place_in_a[id]]);
                if (period > 0) // one of the two has come in on the other side
                    by -= period * std::round(by / period);
                greatest = std::max(greatest, unit * std::abs(by));
                *to++ = by;
            }
        }
        return greatest;
    }
    // places_by_id(s)[id]: the index of the particle with that number.
    static std::vector<int> places_by_id(const Phase& s) {
        std::vector<int> place(*std::max_element(s.ids.begin(), s.ids.end()) + std::size_t{1});
        for (std::size_t i = 0; i < s.ids.size(); ++i)
            place[s.ids[i]] = static_cast<int>(i);
        return place;
    }
};

} // namespace detail

/// The longest stable step, s, of a scene in its present state: `longest_stable_step(scene)`. With longer steps small
/// disturbances grow. It uses no limit of any term; it includes the positions of the particles, the sum of all terms
/// and the integrator. Use it for a program's own forces without a limit, for bodies with thin parts, and to check how
/// far `scene.time_step_limits().front()` is from the true limit.
///
/// Copies of the scene take steps of the same length from the same state, with and without a disturbance of all
/// particles, and the difference is the next disturbance: power iteration with the derivative of the whole step, a
/// hundred times, which is enough for the shortest waves. Starting from the shortest limit, the length is halved until
/// disturbances hardly grow, which gives the growth rate that does not depend on the step; then doubled until they grow
/// faster than that, and bisected. It takes as long as about a thousand steps, and the memory of four scenes; `scene`
/// itself does not change.
///
/// The result holds for this state: where particles come closer later, forces are stiffer; and an instability of a
/// single close pair may pass in a flow. It sees only small disturbances, so no impact, and in a scene at rest no
/// dissipation that begins with speed. Compared with bisected steps it is right to a tenth, and up to 1.9 times too
/// short where a force depends on whether a pair approaches, and with corrected gradients at free surfaces
/// (docs/stability_tables.md, "Limits").
///
/// Source: power iteration, von Mises and Pollaczek-Geiringer (1929); here with differences for a derivative.
///
/// @param scene the scene, @param settings its numbers
/// @return the step, s; 64 times the shortest limit (or Settings::max_time_step if none is known) if that is stable
/// @throws Error where disturbances grow in every step however short, for settings out of range, and what
/// `scene.prepare()` throws
template <class Scene>
double longest_stable_step(const Scene& scene, const StableStepSettings& settings = {}) {
    settings.check();
    const double standard = std::is_same_v<typename Scene::Real, float> ? 1e-3 : 1e-6;
    detail::DisturbedScene<Scene> copies(scene, settings.size > 0 ? settings.size : standard);
    const double allowed = std::log(settings.growth), first = copies.first_step();

    double borne = first, growth = copies.growth(borne, settings.steps);
    while (growth > allowed) {
        borne /= 2;
        require(borne > first / 8192, "longest_stable_step: disturbances grow by more than a factor of ",
                settings.growth, " in every step, though it be only ", 2 * borne,
                " s long. That is not by the length of the steps; look at the forces, or at the state it is in");
        growth = copies.growth(borne, settings.steps);
    }
    const double rate = std::max(growth, 0.0) / borne; // 1/s, whatever the step
    const auto bears = [&](double dt) { return copies.growth(dt, settings.steps) < allowed + 1.2 * rate * dt; };
    double too_long = 2 * borne;
    while (bears(too_long)) {
        borne = too_long;
        if (borne >= 64 * first)
            return borne;
        too_long *= 2;
    }
    while (too_long > borne * (1 + settings.tolerance)) {
        const double between = std::sqrt(borne * too_long);
        (bears(between) ? borne : too_long) = between;
    }
    return borne;
}

} // namespace imbibe
