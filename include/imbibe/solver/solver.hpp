// The solver: a scene of phases and couplings, put together at compile time and run.
#pragma once

#include <imbibe/solver/engine.hpp>
#include <imbibe/solver/limit_rows.hpp>
#include <imbibe/solver/population.hpp>
#include <imbibe/solver/scene_checks.hpp>
#include <imbibe/solver/scene_watch.hpp>
#include <imbibe/solver/settings.hpp>
#include <imbibe/solver/time_step_limits.hpp>
#include <imbibe/solver/warnings.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// Names a phase of a scene: what `add` returns and `scene[...]` takes.
template <class P>
struct PhaseHandle {};

/// A scene.
/// @tparam dim 2 or 3
/// @tparam Real_ float or double
/// @tparam Integrator_ how a step is made of rates; see time/
/// @tparam Items the phases and the couplings between them, in any order
template <int dim, class Real_, class Integrator_, class... Items>
class IMBIBE_PER_BUILD Solver {
public:
    // It says by itself what is wrong, once.
    static_assert(detail::check_scene<dim, Real_, Integrator_, Items...>() || true);

    /// 2 or 3.
    static constexpr int dimension = dim == 2 ? 2 : 3; // of any other, one error is enough
    /// What the compiler worked out: fields, rows, plans.
    using Scene = typename detail::SceneOf<dimension, Real_, Integrator_, Items...>::type;

    // Behind an error about them, numbers and integrators that make no second one.
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
    using Point = Eigen::Matrix<double, dim, 1>;

    /// @throws Error for a setting that is not finite or out of range
    explicit Solver(const Settings<dim>& with)
        : settings_(with), given_{with.cfl, with.time_step, with.max_time_step}, warnings_(with.on_warning) {
        with.check();
        for (std::size_t d = 0; d < dim; ++d)
            engine_.gravity[static_cast<int>(d)] = with.gravity[d];
        engine_.search_interval = std::min(with.search_interval, 1 << 30); // it is added to
        engine_.search_skin = with.search_interval > 1 || subcycles ? with.search_skin : 0;
        engine_.threads = with.threads > 0 ? with.threads : available_threads();
        search::Periodic<dim> sides;
        for (std::size_t d = 0; d < dim; ++d) {
            sides.lower[d] = with.periodic_lower[d] - with.origin[d];
            sides.length[d] = with.periodic_length[d];
        }
        engine_.set_periodic(sides);
    }

    // ---- building the scene ----

    /// Adds particles of a phase at the given points; each has mass density * spacing^dim.
    ///
    /// May be called again for the same phase: the material given first is that of the phase (change it by
    /// `scene[phase].material()`), so all numbers of the material, its coefficients and the spacing must be the same.
    ///
    /// Particles of a total-Lagrangian phase are neighbours for good of those that they are added within a support
    /// radius of: two calls, or two bodies in one, so near to each other make one body. A body that is added to a run
    /// comes where none of the phase was put (its positions may be shifted afterwards, all by the same).
    /// @return what names the phase in `scene[...]`
    /// @throws Error for a material or spacing out of range, a coordinate that is not finite, a point nearer than
    /// 1e-3 spacings to another or to a particle of the phase, and in a total-Lagrangian phase a point within the
    /// support radius of where a particle was added that has left by more than a tenth of the distance; the scene is
    /// then as it was
    template <class P>
    PhaseHandle<P> add(const P& material, const std::vector<Point>& points, double spacing);
    /// Holds the particles of a phase whose position fulfils `held`: they stop and stay. The phase must list the term
    /// `Clamped`. Returns how many they are.
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
    /// Removes the particles of a phase whose position fulfils `gone`. Returns how many they were.
    template <class P, class Gone>
    int remove_if(PhaseHandle<P>, const Gone& gone) {
        if constexpr (State<P>::keeps_reference)
            detail::break_rule<rules::RemovedFromReference<P, remove_particles_of_other_phases_only>>();
        const auto s = find_phase<P>(engine_);
        std::vector<char> keep(static_cast<std::size_t>(s.size()), 1);
        int removed = 0;
        for (int i = 0; i < s.size(); ++i)
            if (gone(position_of(s, i))) {
                keep[static_cast<std::size_t>(i)] = 0;
                ++removed;
            }
        if (removed > 0)
            s.store.compress(keep);
        return removed;
    }
    /// The coefficients of a coupling, to read or to change: `scene.coupling<Contact>().set(...)`.
    template <class C>
    C& coupling() {
        may_have_changed_ = true;
        return *find_coupling<C>(engine_);
    }
    /// The same, to read.
    template <class C>
    const C& coupling() const {
        return *find_coupling<C>(engine_);
    }

    // ---- looking at it ----

    /// One phase of the scene. The views of its fields are valid until the next step: particles are re-sorted.
    template <class P, class S>
    struct PhaseView {
        /// The columns of its particles.
        S state;
        /// Looks at the particles of `where`.
        explicit PhaseView(const S& where) : state(where) {}
        /// Looks where another view looks.
        PhaseView(const PhaseView&) = default;
        /// Looks where `other` looks: `view = scene[water]`. Copies no numbers; a view of a field copies them.
        PhaseView& operator=(const PhaseView& other) {
            const S where = other.state; // taken first: `other` may be this view
            return *std::construct_at(this, where);
        }
        /// A field of all particles, n rows and one column per component, no copy: `scene[water][velocity]`.
        template <class F>
        auto operator[](F f) const {
            return state.view(f);
        }
        /// How many particles the phase has.
        int size() const { return state.size(); }
        /// ids()[i] is the number particle i had when it was added.
        const std::vector<std::uint32_t>& ids() const { return state.ids; }
        /// Its material and coefficients, to read or to change.
        auto& material() const { return state.material; }
    };
    /// A phase of the scene: `scene[water][velocity]` is a view of the velocities of its particles.
    template <class P>
    PhaseView<P, State<P>> operator[](PhaseHandle<P>) {
        may_have_changed_ = true;
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

    /// The time that has passed, s.
    double time() const { return time_; }
    /// How many steps were taken.
    long long steps() const { return steps_; }
    /// How many threads it runs on.
    int threads() const { return engine_.threads; }
    /// The settings it was made with.
    const Settings<dim>& settings() const { return settings_; }
    /// The step that was taken last, and what limited it.
    const TimeStepLimit& last_step() const { return last_step_; }
    /// How many particles all phases have together.
    long long particles() const {
        long long n = 0;
        for (const auto& s : engine_.phases)
            n += s.size();
        return n;
    }
    /// What deserves a look but is no error, found while particles were added, before the first step and during the
    /// run. Settings::on_warning was called with each.
    const std::vector<std::string>& warnings() const { return warnings_.sentences(); }
    /// Adds one: a sentence of the program's own, or of a part of the library, once.
    void warn(const std::string& sentence) { warnings_.note(sentence); }
    /// The phases, and the bodies of one phase, that have met though nothing acts between them: two phases that no
    /// coupling names, two bodies of a total-Lagrangian phase without a term between them. They are looked for at every
    /// tenth step, where speeds allow them to have met; each is a warning, and a Guard ends the run.
    const std::vector<Meeting>& meetings() const { return watch_.met(); }
    /// The scene as it is now, whatever terms it has; for parts of the library.
    detail::OutlineOfScene outline() const { return detail::outline_of(engine_, settings_.origin); }
    /// For parts of the library that need more than views.
    const Engine& engine() const { return engine_; }

    // ---- running it ----

    /// Changes gravity from now on, m/s^2: for a tank that is shaken or tilted, in the frame of the tank. A checkpoint
    /// does not hold it, and a Guard does not look at energies while it changes (GuardSettings::energy).
    /// @throws Error for a component that is not finite; gravity is then as it was
    void set_gravity(const std::array<double, static_cast<std::size_t>(dim)>& gravity) {
        Settings<dim> changed = settings_;
        changed.gravity = gravity;
        changed.check();
        settings_ = changed;
        for (std::size_t d = 0; d < dim; ++d)
            engine_.gravity[static_cast<int>(d)] = gravity[d];
    }
    /// All limits on the next step, without the CFL number, shortest first.
    std::vector<TimeStepLimit> time_step_limits() const;
    /// Is a step made of shorter ones of one phase (time/subcycled.hpp) or of some terms (time/dual_stepping.hpp)?
    static constexpr bool subcycles = requires { Integrator::template in_substeps<void, void>; };
    /// The limits on these shorter steps, without the CFL number, shortest first.
    std::vector<TimeStepLimit> substep_limits() const requires subcycles {
        return detail::limits_of(engine_, LimitRows::rows, true);
    }
    /// How many of them the last step was made of.
    int substeps() const requires subcycles { return substeps_; }
    /// The step that would be taken next, and what limits it: of speeds as they were after the last step or `prepare`.
    TimeStepLimit next_step() const {
        if (settings_.time_step > 0)
            return {settings_.time_step, "fixed", "settings"};
        const auto limits = time_step_limits();
        if (!limits.empty() && limits.front().seconds == 0)
            throw Error(text("the limit on the time step by ", limits.front().reason, " (", limits.front().where,
                             ") is 0 s: a speed, an acceleration or a coefficient is infinite"));
        TimeStepLimit least{settings_.max_time_step, "max_time_step", "settings"};
        if (!limits.empty() && settings_.cfl * limits.front().seconds < least.seconds) {
            least = limits.front();
            least.seconds *= settings_.cfl;
        }
        return least;
    }
    /// From now on all steps are `share` (above 0, at most 1) of what they would have been: the CFL number, a fixed
    /// step and the longest step are multiplied by it. Checkpoints keep it.
    void shorten_steps(double share) {
        require(share > 0 && share <= 1, "shorten_steps(", share, "); the share must be above 0 and at most 1");
        scale_steps(shortened_ * share);
    }
    /// The product of all shares by which steps were shortened.
    double shortened() const { return shortened_; }
    /// One step of the length the limits allow. Returns the length, s.
    double step() {
        prepare();
        const TimeStepLimit chosen = next_step();
        take(chosen);
        return chosen.seconds;
    }
    /// One step of the given length, s.
    void step(double seconds) {
        require(std::isfinite(seconds) && seconds > 0, "a time step of ", seconds, " s; it must be above 0 s");
        prepare();
        take({seconds, "given", "caller"});
    }
    /// Steps until `end`, s, and calls every observer with the scene before the first step and after each one. The last
    /// step ends there; it is up to a millionth longer than the limits allow where else such a rest would be left.
    /// @throws Error for an end that is no number, and what observers throw
    template <class... Observers>
    void run_until(double end, Observers&&... observers) {
        require(!std::isnan(end), "run_until(", end, "): the end of the run must be a number of seconds");
        prepare();
        (observers(*this), ...);
        while (time_ < end * (1 - 1e-12)) {
            prepare(); // observers may add particles and change numbers
            TimeStepLimit chosen = next_step();
            const double left = end - time_;
            if (left < chosen.seconds * (1 - 1e-6))
                chosen = {left, "end of run", "caller"};
            else if (left < chosen.seconds * (1 + 1e-6))
                chosen.seconds = left;
            take(chosen);
            (observers(*this), ...);
        }
    }
    /// Is the next step one that finds neighbours anew? Then a run that is continued from here, which must find them,
    /// goes on as this one does, to the last bit.
    bool search_is_due() const { return engine_.search_is_due(); }
    /// Throws Error, with `words` before it, if a coordinate of any particle is not a finite number.
    void require_finite(const std::string& words) const {
        for (const auto& s : engine_.phases)
            if (s.size() > 0)
                require(search::bounds_of(s.points(), engine_.threads).not_finite < 0, words,
                        "a coordinate of a particle of phase ", s.name, " is not a finite number");
    }
    /// For checkpoints (output/checkpoint.hpp): hands everything that makes up the state of the scene to `archive`,
    /// which writes it or reads it back, in the order of this function. Particles are sorted, so views end here.
    template <class Archive>
    void archive(Archive& archive) {
        // Both sort, and search at the next step: so this run and one that is continued from here stay the same. What
        // is written is sorted: a second time, or where one was written at the step before, it is the same bytes.
        if constexpr (Archive::reading) {
            check_phases(Phases{});
            check_couplings(Couplings{});
        } else {
            engine_.search_neighbours();
        }
        double shortened = shortened_;
        archive(shortened);
        if constexpr (Archive::reading)
            require(shortened > 0 && shortened <= 1, "steps shortened to ", shortened,
                    " of their length; it must be above 0 and at most 1");
        engine_.archive_particles(archive);
        archive(time_);
        archive(steps_);
        archive(last_step_.seconds);
        archive(last_step_.reason);
        archive(last_step_.where);
        if constexpr (Archive::reading) {
            scale_steps(shortened);
            engine_.find_reference_neighbours();
            prepared_ = true;
            engine_.search_neighbours();
            watch_.start_anew(engine_, settings_.origin, time_, warnings_);
        }
        engine_.forget_neighbours();
        engine_.archive_motion(archive);
    }
    /// Sorts the particles, which ends views, finds the neighbours that stay, evaluates what is computed once. The
    /// first step does it by itself, and once more where somebody had a view to write since.
    /// @throws Error for a scene without particles or coefficients out of range
    void prepare();

private:
    Settings<dim> settings_;
    struct {
        double cfl, time_step, max_time_step;
    } given_; // before they were shortened
    Engine engine_;
    double time_ = 0;
    long long steps_ = 0;
    bool prepared_ = false;
    bool may_have_changed_ = true; // materials and coefficients, since they were checked: somebody had a view to write
    int substeps_ = 1;
    double shortened_ = 1; // the part of shorten_steps in settings_
    TimeStepLimit last_step_{0, "none yet", "start"};
    detail::Warnings warnings_;
    detail::SceneWatch watch_;

    void take(const TimeStepLimit& chosen);
    // From what was given, so that a restarted run rounds as the run did.
    void scale_steps(double shortened) {
        settings_.cfl = given_.cfl * shortened;
        settings_.time_step = given_.time_step * shortened;
        settings_.max_time_step = given_.max_time_step * shortened;
        shortened_ = shortened;
    }
    TimeStepLimit shortest(const std::vector<TimeStepLimit>& limits) const {
        return limits.empty() ? TimeStepLimit{settings_.max_time_step, "max_time_step", "settings"} : limits.front();
    }
    std::string describe_shortest() const {
        const auto limits = time_step_limits();
        return limits.empty()
                   ? "none"
                   : text(limits.front().seconds, " s (", limits.front().reason, ", ", limits.front().where, ")");
    }

    // Does the integrator name phases and terms of the scene?
    template <class Given>
    static constexpr bool check_integrator() {
        if constexpr (requires { typename Given::Fast; })
            return in_the_scene<typename Given::Fast, Phases, list_the_phase_in_the_solver>();
        else if constexpr (requires { requires Given::Slow::size == 0; })
            return detail::break_rule<rules::NothingIsSlow<Given, name_terms_such_as_MorrisViscosity>>();
        else if constexpr (requires { typename Given::Slow; })
            return detail::RowsOfTerms<Scene, typename Given::Slow>::check();
        else
            return true;
    }
    template <class What, class All, class Advice>
    static constexpr bool in_the_scene() {
        if constexpr (!detail::contains<What, All>)
            return detail::break_rule<rules::NotInTheScene<What, Advice>>();
        else
            return true;
    }
    static constexpr bool steps_are_defined = check_integrator<Integrator>();

    template <class P>
    static auto find_phase(auto& engine) {
        if constexpr (in_the_scene<P, Phases, list_the_phase_in_the_solver>())
            return engine.template state<P>();
        else
            return detail::nothing<State<P>>();
    }
    template <class C>
    static auto find_coupling(auto& engine) {
        if constexpr (detail::contains<C, typename Scene::All> && !detail::CouplesPhases<C>)
            return &detail::nothing<C>(); // an error of its own
        else if constexpr (in_the_scene<C, Couplings, list_the_coupling_in_the_solver>())
            return &engine.template coupling<C>();
        else
            return &detail::nothing<C>();
    }
    // Materials and coefficients, where a program may have changed them.
    void check_numbers() {
        if (!may_have_changed_)
            return;
        check_phases(Phases{});
        check_couplings(Couplings{});
        may_have_changed_ = false;
    }
    // A term may say what its coefficients, or the material it is used with, must fulfil.
    template <class... P>
    void check_phases(TypeList<P...>) const {
        (check_phase<P>(engine_.template state<P>()), ...);
    }
    template <class P>
    void check_phase(const auto& s) const {
        if (s.size() > 0) {
            s.material.check(detail::type_name<P>());
            detail::require_support(engine_, s.material.support_radius, detail::type_name<P>());
            detail::check_terms<P>(s.material, typename P::terms{});
        }
    }
    template <class... C>
    void check_couplings([[maybe_unused]] TypeList<C...> all) const {
        (detail::check_terms<C>(coupling<C>(), typename C::terms{}), ...);
        (check_shared_with<C>(all), ...);
    }
    template <class C, class... D>
    void check_shared_with(TypeList<D...>) const {
        (detail::check_shared_parts(coupling<C>(), coupling<D>(), typename C::terms{}), ...);
    }

    // A particle's place in the coordinates of the world.
    template <class S>
    Point position_of(const S& s, int i) const {
        Point x;
        for (int d = 0; d < dim; ++d)
            x[d] = static_cast<double>(s.column(S::template offset<Position> + d)[i]) +
                   settings_.origin[static_cast<std::size_t>(d)];
        return x;
    }

    using LimitRows = detail::LimitRows<dimension, Scene, Integrator>;
};

// Functions of some length, out of the class: a program may leave them to a library (`extern template`).

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
    prepared_ = false;
    may_have_changed_ = true;
    return {};
}

template <int dim, class Real_, class Integrator_, class... Items>
std::vector<TimeStepLimit> Solver<dim, Real_, Integrator_, Items...>::time_step_limits() const {
    return detail::limits_of(engine_, LimitRows::rows, false);
}

template <int dim, class Real_, class Integrator_, class... Items>
void Solver<dim, Real_, Integrator_, Items...>::prepare() {
    const bool changed = may_have_changed_;
    check_numbers();
    if (prepared_ && steps_ > 0) {
        if (changed)
            engine_.notice_greater_speeds();
        return;
    }
    const bool anew = !prepared_ || changed;
    if (anew) {
        require(particles() > 0, "the scene has no particles; add some before the first step");
        engine_.find_reference_neighbours();
    }
    engine_.search_neighbours();
    if (anew &&
        steps_ == 0) // what is added to a run has been looked at by then, or motion has brought the two together
        detail::note_doubts_of_scene(warnings_, engine_, settings_.origin, outline());
    if (!prepared_)
        watch_.look_at_added(engine_, settings_.origin, time_, warnings_);
    if (anew) {
        engine_.template run<typename Scene::Once>(0);
    }
    if constexpr (steps_are_defined && requires { Integrator::start(engine_); })
        Integrator::start(engine_);
    engine_.measure_motion();
    prepared_ = true;
    if (settings_.time_step > 0 && steps_ == 0)
        if (const auto limits = time_step_limits();
            !limits.empty() && limits.front().seconds < settings_.time_step * (1 - 1e-9))
            warnings_.note(text("the fixed time step of ", settings_.time_step,
                                " s is longer than the longest stable one, ", limits.front().seconds, " s by ",
                                limits.front().reason, " (", limits.front().where,
                                "); with time_step = 0 steps adapt to the limits"));
}

template <int dim, class Real_, class Integrator_, class... Items>
void Solver<dim, Real_, Integrator_, Items...>::take(const TimeStepLimit& chosen) {
    last_step_ = chosen;
    try {
        if constexpr (!steps_are_defined) {
            return; // an error of its own
        } else if constexpr (subcycles) {
            const TimeStepLimit limit = shortest(substep_limits());
            const double within = settings_.cfl * limit.seconds;
            const double count = std::ceil(chosen.seconds / within * (1 - 1e-9));
            require(count < 1e6, "a step of ", chosen.seconds, " s asks for ", count, " steps of ", within, " s (",
                    limit.reason, ", ", limit.where, "); at most a million are taken");
            substeps_ = std::max(1, static_cast<int>(count));
            Integrator::step(engine_, chosen.seconds, substeps_);
        } else {
            Integrator::step(engine_, chosen.seconds);
        }
    } catch (const Error& error) {
        throw Error(text(error.what(), "; step ", steps_, ", time ", time_, " s, time step ", chosen.seconds,
                         " s limited by ", chosen.reason, " (", chosen.where, "). The shortest limit is ",
                         describe_shortest(), "; a step well below it is the first remedy to try"));
    }
    time_ += chosen.seconds;
    ++steps_;
    watch_.look_after_step(engine_, settings_.origin, time_, chosen.seconds, warnings_);
}

} // namespace imbibe
