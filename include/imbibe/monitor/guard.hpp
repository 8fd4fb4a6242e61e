// Watches a run and ends it with a cause when it has gone wrong.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/monitor/guard_settings.hpp>
#include <imbibe/solver/scene_run.hpp>

#include <array>
#include <concepts>
#include <optional>
#include <string>

namespace imbibe {

namespace rules {
/// Rule: a guard has its scene's dimension.
template <class Given, class Needed>
struct GuardOfAnotherDimension {
    static_assert(sizeof(Given) == 0, "imbibe: a Guard is of its scene's dimension: replace the first by the second");
};
} // namespace rules

/// An observer for `run_until` that throws Diverged when the scene leaves its bounds. Without a guard nothing of this
/// is computed.
template <int dim>
class Guard {
public:
    /// With the default bounds of GuardSettings.
    Guard() = default;
    /// With other bounds: `Guard<2>({.upper = {1, 1}})`.
    /// @throws Error for a bound out of range
    template <class Bounds = GuardSettings<dim>> // a template, so that `Guard<2>({})` does not mean two things
    requires std::same_as<Bounds, GuardSettings<dim>>
    explicit Guard(const Bounds& with) : settings_(with) { with.check(); }

    /// The observer: a quick check after every step, a check of all particles every `interval` steps, and of the pores
    /// every `pore_interval` steps.
    /// @throws Diverged
    template <class Scene>
    void operator()(const Scene& scene) {
        if constexpr (check_dimension<Scene>())
            look_after_step<typename Scene::Real>(scene);
    }
    /// Checks everything now, for example so that only a good checkpoint is written.
    /// @throws Diverged
    template <class Scene>
    void look(const Scene& scene) {
        if constexpr (check_dimension<Scene>())
            look_at_all<typename Scene::Real>(scene);
    }
    /// Forgets the energies recorded so far, as after a return to an earlier state.
    void start_anew() { start_.reset(); }

    /// @cond the same for any scene with these numbers
    template <class Real>
    void look_after_step(const SceneRun<dim, Real>& scene);
    template <class Real>
    void look_at_all(const SceneRun<dim, Real>& scene);
    /// @endcond

private:
    // True, or a compile error that names the broken rule.
    template <class Scene>
    static constexpr bool check_dimension() {
        if constexpr (Scene::dimension != dim)
            return detail::break_rule<rules::GuardOfAnotherDimension<Guard, Guard<Scene::dimension>>>();
        else
            return true;
    }
    template <class Real>
    using Run = SceneRun<dim, Real>;
    template <class Real>
    using Phase = detail::PhaseStore<dim, Real>;

    GuardSettings<dim> settings_;
    struct Balance {
        double energy, kinetic, potential;                         // kinetic and potential; J
        long long particles, ever, steps;                          // present number, and number ever added
        std::array<double, static_cast<std::size_t>(dim)> gravity; // m/s^2
        double stored = 0;                                         // energy that can be released, J; at the first look
    };
    std::optional<Balance> start_; ///< at the first look
    double kinetic_most_ = 0;
    double excess_ = 0; ///< energy created since the first look (below 0: lost), J

    template <class Real>
    void look_at_particles(const Run<Real>& scene);
    template <class Real>
    void glance(const Run<Real>& scene) const;
    template <class Real>
    void look_at(const Run<Real>& scene, const Phase<Real>& phase) const;
    template <class Real>
    void look_for_walls(const Run<Real>& scene, const detail::Link& link) const;
    template <class Real>
    void look_at_pores(const Run<Real>& scene) const;
    template <class Real>
    void look_at_pores_of(const Run<Real>& scene, const Phase<Real>& body, const Phase<Real>& fluid) const;
    template <class Real>
    void look_at_energy(const Run<Real>& scene);
    template <class Real>
    double round_off(const Run<Real>& scene) const;
    template <class Real>
    void require_finite(const Run<Real>& scene, const Phase<Real>& phase, const detail::FieldRow& field) const;
    template <class Real>
    [[noreturn]] void stop(const Run<Real>& scene, Cause cause, const Phase<Real>& phase, int i,
                           const std::string& what) const;
};

/// The guard takes the dimension of its bounds.
template <int dim>
Guard(const GuardSettings<dim>&) -> Guard<dim>;

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/monitor/guard_code.hpp>
#endif
