// Makes the outline of a scene, and looks at it while the scene runs: for particles that were added over others, and
// for phases and bodies that meet though nothing acts between them.
#pragma once

#include <imbibe/core/phase.hpp>
#include <imbibe/solver/meetings.hpp>
#include <imbibe/solver/scene_state.hpp>
#include <imbibe/solver/warnings.hpp>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// Is phase P total-Lagrangian, and is it not looked for neighbours as they lie now within it?
template <class Engine, class P>
constexpr bool knows_bodies =
    contains<Link<P, P, true>, typename Engine::Links> && !contains<Link<P, P, false>, typename Engine::Links>;

/// The outline of a scene, as it is now. @param origin of its coordinates, m
template <class Engine, class Origin>
OutlineOfScene outline_of(const Engine& engine, const Origin& origin) {
    constexpr auto dim = static_cast<std::size_t>(Engine::dimension);
    OutlineOfScene scene;
    scene.dim = Engine::dimension;
    scene.threads = engine.threads;
    for (std::size_t d = 0; d < dim; ++d) {
        scene.origin[d] = origin[d];
        scene.lower[d] = engine.periodic.lower[d];
        scene.period[d] = engine.periodic.length[d];
    }
    engine.for_each_phase([&]<class P, class State>(std::type_identity<P>, const State& s) {
        const auto columns_of = [&]<class F>(F, std::size_t count) {
            OutlineColumns columns;
            columns.n = s.size();
            for (std::size_t d = 0; d < count; ++d) {
                const auto* const column = s.column(State::template offset<F> + static_cast<int>(d));
                columns.x[d] = column;
                columns.in_float = sizeof(*column) == sizeof(float);
            }
            return columns;
        };
        Outline one;
        one.name = name_among<P>(typename Engine::Phases{});
        one.kind = is_fluid<P> ? Kind::fluid : P::moves ? Kind::solid : Kind::wall;
        one.spacing = s.material.spacing;
        one.support_radius = s.material.support_radius;
        one.now = columns_of(position, dim);
        one.at_rest = one.now;
        one.ids = s.ids.data();
        one.ever_added = s.ever_added();
        one.knows_bodies = knows_bodies<Engine, P>;
        if constexpr (State::keeps_reference)
            one.at_rest = columns_of(reference_position, dim);
        if constexpr (State::template stores<Mobility>)
            one.mobility = columns_of(mobility, 1);
        scene.phases.push_back(std::move(one));
    });
    return scene;
}

/// Each two phases of a scene once.
template <class Engine>
std::vector<PhasePair> pairs_of_phases(const Engine& engine) {
    std::vector<PhasePair> pairs;
    const auto add = [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
        constexpr int a = Engine::Composition::template phase_index<A>,
                      b = Engine::Composition::template phase_index<B>;
        if constexpr (a < b)
            pairs.push_back({a, b, engine.template support<A, B>(), are_coupled<A, B>(typename Engine::Couplings{})});
    };
    [&]<class... P>(TypeList<P...>) {
        const auto add_all = [&]<class A>(std::type_identity<A> one) { (add(one, std::type_identity<P>{}), ...); };
        (add_all(std::type_identity<P>{}), ...);
    }(typename Engine::Phases{});
    return pairs;
}

template <class Engine>
class SceneWatch {
public:
    const std::vector<Meeting>& met() const { return met_; }

    /// After particles were added to a scene, and a search.
    template <class Origin>
    void look_at_added(const Engine& engine, const Origin& origin, double time, Warnings& warnings) {
        const OutlineOfScene scene = outline_of(engine, origin);
        for (std::size_t k = 0; k < scene.phases.size(); ++k) {
            auto& [looked_at, found] = crowding_[k];
            const Outline& phase = scene.phases[k];
            if (!found && phase.ever_added > looked_at) {
                const std::string sentence = warning_of_crowding(phase, looked_at, scene);
                found = !sentence.empty(); // a source would say it at every step
                warnings.note(sentence);
            }
            looked_at = phase.ever_added;
        }
        if constexpr (anyone_may_meet) {
            meetings_.watch(scene, pairs_of_phases(engine));
            note_meetings(scene, time, warnings);
        }
    }
    /// After the particles of a scene were replaced by those of a checkpoint.
    template <class Origin>
    void start_anew(const Engine& engine, const Origin& origin, double time, Warnings& warnings) {
        meetings_ = {};
        met_.clear();
        engine.for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
            crowding_[static_cast<std::size_t>(Engine::Composition::template phase_index<P>)].first = s.ever_added();
        });
        look_at_added(engine, origin, time, warnings);
    }
    /// After a step of `seconds`.
    template <class Origin>
    void look_after_step(const Engine& engine, const Origin& origin, double time, double seconds, Warnings& warnings) {
        if constexpr (anyone_may_meet) {
            since_look_ += seconds;
            if (++steps_ % 10 != 0)
                return;
            meetings_.approach(3 * greatest_speed(engine) * since_look_); // two move, and were faster perhaps
            since_look_ = 0;
            if (meetings_.is_due())
                note_meetings(outline_of(engine, origin), time, warnings);
        }
    }

private:
    Meetings meetings_;
    std::vector<Meeting> met_;
    long long steps_ = 0;
    double since_look_ = 0; // s
    // By phase: how many of its particles, of all that were ever added, were looked for crowding, and was any found?
    std::array<std::pair<long long, bool>, static_cast<std::size_t>(Engine::Phases::size)> crowding_{};

    template <class A, class... B>
    static constexpr bool acts_with_all(TypeList<B...>) {
        return ((std::is_same_v<A, B> || are_coupled<A, B>(typename Engine::Couplings{})) && ...);
    }
    template <class... P>
    static constexpr bool any_may_meet(TypeList<P...> all) {
        return ((knows_bodies<Engine, P> || !acts_with_all<P>(all)) || ...);
    }
    static constexpr bool anyone_may_meet = any_may_meet(typename Engine::Phases{});

    void note_meetings(const OutlineOfScene& scene, double time, Warnings& warnings) {
        for (Meeting& meeting : meetings_.look(scene, time)) {
            warnings.note(meeting.sentence);
            met_.push_back(std::move(meeting));
        }
    }
    // Of all particles, m/s; infinite where a wall has no velocity, for a program may move it.
    static double greatest_speed(const Engine& engine) {
        double most = 0;
        engine.for_each_phase([&]<class P, class State>(std::type_identity<P>, const State& s) {
            if (s.size() > 0)
                most = std::max(most, State::template stores<Velocity> ? engine.template motion_now<P>().fastest
                                                                       : std::numeric_limits<double>::infinity());
        });
        return most;
    }
};

} // namespace imbibe::detail
