// Sub-cycling: one phase takes several short steps while the others take a long one.
#pragma once

#include <imbibe/core/rule.hpp>
#include <imbibe/core/term.hpp>

#include <algorithm>
#include <utility>

namespace imbibe {

/// The mean velocity of a particle over the last long step, m/s: its displacement between two evaluations of the other
/// phases, over the time between them.
struct MeanVelocity : Field<Rank::vector> {
    static constexpr std::string_view name = "mean_velocity", unit = "m/s";
};
inline constexpr MeanVelocity mean_velocity{};

/// Allows a phase to be the fast one of `Subcycled`. Not with another integrator, which leaves the mean at zero.
///
/// Source: Zhang, Rezavand and Hu (2021), the time-averaged velocity of the structure.
struct TimeAveragedMotion {
    using stores = Fields<mean_velocity>;
};

struct list_the_term_TimeAveragedMotion_in_the_phase;
namespace rules {
/// Rule: a phase that takes shorter steps than the scene lists the term that keeps the mean of its motion for the
/// others.
template <class Phase, class Advice>
struct SubcycledWithoutMean {
    static_assert(sizeof(Phase) == 0, "imbibe: the phase that Subcycled names does not average its motion");
};
} // namespace rules

/// SymplecticEuler for the scene, with steps that the limits of phase `Fast` do not shorten. Within each step, `Fast`
/// takes as many steps of its own as its limits need, under the forces of its couplings at the start and their
/// contributions to its other sums at the start. The other phases see its position and its mean velocity over the last
/// step, so that their densities follow the volume it has swept.
///
/// For a stiff structure beside soft phases: metal or rubber in water, where the solid's sound speed is several times
/// the fluid's. `Fast` must list TimeAveragedMotion. Not where `Fast` is so light that the fluid's force must follow
/// each of its steps (densities far below the fluid's). No gain where the limits are alike: the terms of `Fast` are
/// evaluated as often, its couplings and the rest less often.
///
/// A solid that is not total-Lagrangian keeps its neighbours during a long step.
///
/// Source: Zhang, Rezavand and Hu (2021), multi-resolution fluid-structure interaction, the time stepping. Their mean
/// accelerations are not needed by the couplings here.
template <class Fast_>
struct Subcycled {
    /// The phase that takes short steps.
    using Fast = Fast_;
    /// The passes of a step, for reports; the terms of the fast phase in each of its own steps.
    template <class Composition>
    using Passes =
        TypeList<typename Composition::template AllButOwnTerms<Fast>, typename Composition::template OwnTerms<Fast>>;
    /// Is the limit of `Term` of a phase or coupling one on the steps of the fast phase?
    template <class Where, class Term>
    static constexpr bool in_substeps = std::is_same_v<Where, Fast>;

    template <class Engine>
    static void start(Engine& engine) {
        if constexpr (Engine::template State<Fast>::template stores<MeanVelocity>) {
            using Composition = typename Engine::Composition;
            engine.template run<typename Composition::template OwnTerms<Fast>>(0);
            engine.template run<typename Composition::template AllButOwnTerms<Fast>>(0); // its contribution to sums
            engine.template run<typename Composition::template OwnTerms<Fast>>(0);
            auto fast = engine.template state<Fast>();
            std::copy_n(fast.field(velocity), Engine::dimension * fast.stride(), fast.field(mean_velocity));
        } else {
            detail::break_rule<rules::SubcycledWithoutMean<Fast, list_the_term_TimeAveragedMotion_in_the_phase>>();
        }
    }
    /// One step of the scene.
    /// @param engine holds the particles
    /// @param dt its length, s
    /// @param substeps how many steps `Fast` takes
    template <class Engine>
    static void step(Engine& engine, double dt, int substeps) {
        using Composition = typename Engine::Composition;
        using Own = typename Composition::template OwnTerms<Fast>;
        auto fast = engine.template state<Fast>();
        engine.find_neighbours();

        exchange(engine); // the other phases use the mean velocity
        engine.template run<typename Composition::template AllButOwnTerms<Fast>>(dt);
        exchange(engine);
        engine.template kick_if<IsOther>(dt);
        engine.template drift_if<IsOther>(dt);

        auto* const mean = fast.field(mean_velocity);
        std::fill_n(mean, Engine::dimension * fast.stride(), std::remove_pointer_t<decltype(mean)>(0));
        engine.template keep_sums<Own>(); // by couplings and gravity
        for (int k = 0; k < substeps; ++k) {
            if (k > 0) {
                engine.template refresh_places_among<Fast>();
                engine.template restore_sums<Own>();
            }
            engine.template run<Own>(dt / substeps);
            engine.template kick_if<IsFast>(dt / substeps);
            engine.template drift_if<IsFast>(dt / substeps);
            engine.template add_velocities<Fast>(mean, 1.0 / substeps);
        }
    }

private:
    template <class P>
    struct IsFast : std::is_same<P, Fast> {};
    template <class P>
    struct IsOther : std::bool_constant<!std::is_same_v<P, Fast>> {};

    template <class Engine>
    static void exchange(Engine& engine) {
        auto s = engine.template state<Fast>();
        auto *v = s.field(velocity), *mean = s.field(mean_velocity);
        std::swap_ranges(v, v + Engine::dimension * s.stride(), mean);
    }
};

} // namespace imbibe
