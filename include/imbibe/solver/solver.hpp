// The solver: a scene of phases and couplings, put together at compile time and run.
#pragma once

#include <imbibe/solver/engine.hpp>
#include <imbibe/solver/limit_rows.hpp>
#include <imbibe/solver/phase_view.hpp>
#include <imbibe/solver/population.hpp>
#include <imbibe/solver/prepare_terms.hpp>
#include <imbibe/solver/scene_checks.hpp>
#include <imbibe/solver/scene_run.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// A scene.
/// @tparam dim 2 or 3
/// @tparam Real_ float or double
/// @tparam Integrator_ how a step is made of rates; see time/
/// @tparam Items the phases and the couplings between them, in any order
template <int dim, class Real_, class Integrator_, class... Items>
class IMBIBE_PER_BUILD Solver
    : public SceneRun<dim == 2 ? 2 : 3, std::conditional_t<detail::is_real<Real_>, Real_, double>> {
    using Base = SceneRun<dim == 2 ? 2 : 3, std::conditional_t<detail::is_real<Real_>, Real_, double>>;

public:
    // Reports what is wrong by itself, once.
    static_assert(detail::check_scene<dim, Real_, Integrator_, Items...>() || true);

    /// 2 or 3.
    static constexpr int dimension = dim == 2 ? 2 : 3; // any other value is an error already
    /// What the compiler worked out: fields, rows, plans.
    using Scene = typename detail::SceneOf<dimension, Real_, Integrator_, Items...>::type;

    // After an error about them, numbers and integrators that cause no second one.
    /// The type of all stored numbers.
    using Real = std::conditional_t<detail::is_real<Real_>, Real_, double>;
    /// How a step is made of rates.
    using Integrator = std::conditional_t<detail::IsIntegrator<Integrator_>, Integrator_, detail::NoSteps>;
    /// How many numbers the processor computes at once.
    static constexpr int width = native_width<Real>;
    /// The phases of the scene.
    using Phases = typename Scene::Phases;
    /// The couplings of the scene.
    using Couplings = typename Scene::Couplings;
    /// The fields of a phase.
    template <class P>
    using FieldsOf = typename Scene::template FieldsOf<P>;
    /// Holds the particles and runs the loops; for integrators and for parts of the library.
    using Engine = detail::Engine<dimension, Real, Scene>;
    /// The columns of a phase.
    template <class P>
    using State = typename Engine::template State<P>;
    /// A place, m.
    using Point = Eigen::Matrix<double, dimension, 1>;

    /// @throws Error for a setting that is not finite or out of range
    explicit Solver(const Settings<dimension>& with) : Base(with, subcycles) { this->set_up(engine_); }

    // ---- building the scene ----

    /// Adds particles of a phase at the given points; each has mass density * spacing^dim.
    ///
    /// May be called again for the same phase: the material given first is that of the phase (change it by
    /// `scene[phase].material()`), so all numbers of the material, its coefficients and the spacing must be the same.
    ///
    /// Particles of a total-Lagrangian phase are permanent neighbours of those that are added within a support radius:
    /// two bodies that near to each other become one, whether added in one call or two. A body that is added to a run
    /// must be placed where no particle of the phase was ever added (all its positions may be shifted afterwards by the
    /// same vector).
    /// @return the handle of the phase in `scene[...]`
    /// @throws Error for a material or spacing out of range, a coordinate that is not finite, a point nearer than
    /// 1e-3 spacings to another or to a particle of the phase, and in a total-Lagrangian phase a point within the
    /// support radius of where a particle was added that has left by more than a tenth of the distance; the scene is
    /// then as it was
    template <class P>
    PhaseHandle<P> add(const P& material, const std::vector<Point>& points, double spacing);
    /// Holds the particles of a phase whose position fulfils `held`: they stop and stay. The phase must list the term
    /// `Clamped`. Returns their number.
    template <class P, class Held>
    int hold(PhaseHandle<P>, const Held& held) {
        int number = 0;
        if constexpr (detail::contains<Mobility, FieldsOf<P>>) {
            const auto s = find_phase<P>(engine_);
            for (int i = 0; i < s.size(); ++i)
                if (held(position_of(s, i))) {
                    s.field(mobility)[i] = Real(0);
                    for (int d = 0; d < dim; ++d)
                        s.column(State<P>::template offset<Velocity> + d)[i] = Real(0);
                    ++number;
                }
            if (number == 0)
                warnings_.note(
                    text("hold: no particle of ", detail::type_name<P>(), " is where those are that are to be held"));
        } else {
            detail::break_rule<rules::HeldWithoutClamped<P, list_the_term_Clamped_in_the_phase>>();
        }
        return number;
    }
    /// Removes the particles of a phase that `gone` chooses, by position, gone(x), or by the view of the phase and the
    /// index in it, gone(view, i). Returns their number. Views become invalid.
    template <class P, class Gone>
    int remove_if(PhaseHandle<P> handle, const Gone& gone) {
        if constexpr (State<P>::keeps_reference)
            detail::break_rule<rules::RemovedFromReference<P, remove_particles_of_other_phases_only>>();
        std::vector<char> stays = chosen(handle, gone);
        for (char& one : stays)
            one = !one;
        const auto removed = std::count(stays.begin(), stays.end(), 0);
        if (removed > 0)
            find_phase<P>(engine_).store.compress(stays);
        return static_cast<int>(removed);
    }
    /// Hands particles of a phase over to another one, with all fields that both have by name, unit and rank, such as
    /// position, velocity, mass and user fields: water that freezes. Fields that only the other phase has start as for
    /// added particles. The ratio of the density to the reference density is kept, so the volume changes if the
    /// reference densities differ. Particles are chosen as by remove_if; views become invalid. A phase that starts
    /// without particles needs its material: `scene.add(Ice{{...}}, {}, spacing)`.
    /// @return the numbers of each of these particles, before and now
    /// @throws Error where the other phase has no material
    template <class P, class Q, class Which>
    std::vector<Handed> hand_over(PhaseHandle<P> from, PhaseHandle<Q>, const Which& which) {
        if constexpr (State<P>::keeps_reference)
            detail::break_rule<rules::RemovedFromReference<P, remove_particles_of_other_phases_only>>();
        if constexpr (State<Q>::keeps_reference)
            detail::break_rule<rules::HandedToReference<Q, take_a_solid_with_a_stress_rate>>();
        auto handed =
            detail::hand_over(find_phase<P>(engine_).store, find_phase<Q>(engine_).store, chosen(from, which));
        if (!handed.empty())
            this->added();
        return handed;
    }
    /// The coefficients of a coupling, to read or to change: `scene.coupling<Contact>().set(...)`.
    template <class C>
    C& coupling() {
        may_change();
        return *find_coupling<C>(engine_);
    }
    /// The same, to read.
    template <class C>
    const C& coupling() const {
        return *find_coupling<C>(engine_);
    }

    // ---- looking at it ----

    /// A phase of the scene: `scene[water][velocity]` is a view of the velocities of its particles.
    template <class P>
    PhaseView<P, State<P>> operator[](PhaseHandle<P>) {
        may_change();
        return PhaseView<P, State<P>>(find_phase<P>(engine_));
    }
    /// The same, to read.
    template <class P>
    auto operator[](PhaseHandle<P>) const {
        return PhaseView<P, typename Engine::template ConstState<P>>(find_phase<P>(engine_));
    }
    /// The same by the phase's type.
    template <class P>
    auto get() {
        return (*this)[PhaseHandle<P>{}];
    }
    /// The same, to read.
    template <class P>
    auto get() const {
        return (*this)[PhaseHandle<P>{}];
    }

    /// For parts of the library that need more than views.
    const Engine& engine() const { return engine_; }

    // ---- running it ----

    /// Is a step made of shorter ones of one phase (time/subcycled.hpp) or of some terms (time/dual_stepping.hpp)?
    static constexpr bool subcycles = requires { Integrator::template in_substeps<void, void>; };
    /// The limits on these shorter steps, without the CFL number, shortest first.
    std::vector<TimeStepLimit> substep_limits() const requires subcycles {
        return detail::limits_of(engine_, limit_rows(), true);
    }
    /// How many of them the last step was made of.
    int substeps() const requires subcycles { return this->substeps_; }
    /// Steps until `end`, s, and calls every observer with the scene before the first step and after each one. The last
    /// step ends there; it may exceed the limits by a millionth, to avoid a tiny extra step.
    /// @throws Error for an end that is no number, and what observers throw
    template <class... Observers>
    void run_until(double end, Observers&&... observers) {
        require(!std::isnan(end), "run_until(", end, "): the end of the run must be a number of seconds");
        this->prepare();
        (observers(*this), ...);
        while (time_ < end * (1 - 1e-12)) {
            this->prepare(); // observers may have added particles or changed numbers
            TimeStepLimit chosen = this->next_step();
            const double left = end - time_;
            if (left < chosen.seconds * (1 - 1e-6))
                chosen = {left, "end of run", "caller"};
            else if (left < chosen.seconds * (1 + 1e-6))
                chosen.seconds = left;
            this->take(chosen);
            (observers(*this), ...);
        }
    }

private:
    Engine engine_;

    using Base::may_change;
    using Base::settings_;
    using Base::time_;
    using Base::warnings_;
    using typename Base::BaseEngine;
    BaseEngine& base_engine() override { return engine_; }
    const BaseEngine& base_engine() const override { return engine_; }
    std::span<const detail::LimitRow> limit_rows() const override {
        return detail::LimitRows<dimension, Scene, Integrator>::rows;
    }
    void check_numbers() const override { detail::check_numbers_of(engine_); }
    void prepare_terms() override { detail::prepare_terms_of(engine_); }
    void evaluate_once() override { engine_.template run_for_grown<typename Scene::Once>(); }
    void start_steps() override {
        if constexpr (steps_are_defined && requires { Integrator::start(engine_); })
            Integrator::start(engine_);
    }
    void advance([[maybe_unused]] double seconds, [[maybe_unused]] int substeps) override {
        if constexpr (!steps_are_defined)
            return; // reported by another rule
        else if constexpr (subcycles)
            Integrator::step(engine_, seconds, substeps);
        else
            Integrator::step(engine_, seconds);
    }

    static constexpr bool steps_are_defined = detail::check_integrator<Scene, Integrator>();

    template <class P>
    static auto find_phase(auto& engine) {
        if constexpr (detail::in_the_scene<P, Phases, list_the_phase_in_the_solver>())
            return engine.template state<P>();
        else
            return detail::nothing<State<P>>();
    }
    template <class C>
    static auto find_coupling(auto& engine) {
        if constexpr (detail::contains<C, typename Scene::All> && !detail::CouplesPhases<C>)
            return &detail::nothing<C>(); // reported by another rule
        else if constexpr (detail::in_the_scene<C, Couplings, list_the_coupling_in_the_solver>())
            return &engine.template coupling<C>();
        else
            return &detail::nothing<C>();
    }
    // Chooses particles by position or by view and index.
    template <class P, class Which>
    std::vector<char> chosen(PhaseHandle<P> handle, const Which& which) {
        const auto s = find_phase<P>(engine_);
        const auto view = std::as_const(*this)[handle];
        std::vector<char> all(static_cast<std::size_t>(s.size()));
        for (int i = 0; i < s.size(); ++i)
            if constexpr (std::is_invocable_v<const Which&, decltype(view), int>)
                all[static_cast<std::size_t>(i)] = which(view, i);
            else
                all[static_cast<std::size_t>(i)] = which(position_of(s, i));
        return all;
    }
    // A particle's position in world coordinates.
    template <class S>
    Point position_of(const S& s, int i) const {
        Point x;
        for (int d = 0; d < dim; ++d)
            x[d] = static_cast<double>(s.column(S::template offset<Position> + d)[i]) +
                   settings_.origin[static_cast<std::size_t>(d)];
        return x;
    }
};

// Longer functions, outside the class: a program may leave them to a library (`extern template`).

template <int dim, class Real_, class Integrator_, class... Items>
template <class P>
PhaseHandle<P> Solver<dim, Real_, Integrator_, Items...>::add(const P& material, const std::vector<Point>& points,
                                                              double spacing) {
    const std::string name = detail::type_name<P>();
    material.check(name);
    require(std::isfinite(spacing) && spacing > 0, name, ": spacing = ", spacing, " m; it must be above 0 m");
    P complete = material;
    complete.spacing = spacing;
    if (complete.support_radius == 0)
        complete.support_radius = settings_.support_radius;
    detail::require_support(engine_, complete.support_radius, name);
    const auto s = find_phase<P>(engine_);
    if (s.size() > 0)
        detail::require_same_material(s.material, complete, name);
    const auto places = detail::places_of_new(engine_, Scene::template phase_index<P>, points, spacing,
                                              complete.support_radius, settings_.origin);
    if (s.size() == 0)
        s.material = complete;
    detail::note_doubts_of_material<dim>(warnings_, s.material, name, typename P::terms{});
    detail::add_particles(s.store, places, complete.density, spacing);
    this->added();
    return {};
}

} // namespace imbibe
