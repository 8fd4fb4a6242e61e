// A running scene: its time, its steps and their limits, its warnings. It knows no type of the scene; the Solver, which
// derives from it, adds what depends on those.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/scene_engine.hpp>
#include <imbibe/solver/scene_watch.hpp>
#include <imbibe/solver/settings.hpp>
#include <imbibe/solver/time_step_limits.hpp>
#include <imbibe/solver/warnings.hpp>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace imbibe {

/// What all scenes in `dim` dimensions with numbers of type Real have in common while they run.
template <int dim, class Real>
class IMBIBE_PER_BUILD SceneRun {
public:
    /// The time simulated so far, s.
    double time() const { return time_; }
    /// How many steps were taken.
    long long steps() const { return steps_; }
    /// How many threads it runs on.
    int threads() const { return base_engine().threads; }
    /// The settings it was made with.
    const Settings<dim>& settings() const { return settings_; }
    /// The step that was taken last, and what limited it.
    const TimeStepLimit& last_step() const { return last_step_; }
    /// How many particles all phases have together.
    long long particles() const;
    /// Findings that deserve a look but are no errors, made while particles were added, before the first step and
    /// during the run. Settings::on_warning was called with each.
    const std::vector<std::string>& warnings() const { return warnings_.sentences(); }
    /// Adds a warning, from the program or from a part of the library; each sentence once.
    void warn(const std::string& sentence) { warnings_.note(sentence); }
    /// The phases, and the bodies of one phase, that have met although nothing acts between them: two phases that no
    /// coupling names, two bodies of a total-Lagrangian phase without a term between them. Checked at every tenth step
    /// if speeds allow them to have met; each is a warning, and a Guard ends the run.
    const std::vector<Meeting>& meetings() const { return watch_.met(); }
    /// Its particles, neighbours and tables, whatever terms it has; for parts of the library.
    const detail::SceneEngine<dim, Real>& scene_engine() const { return base_engine(); }
    /// The scene as it is now, whatever terms it has; for parts of the library.
    detail::OutlineOfScene outline() const { return detail::outline_of(base_engine(), settings_.origin); }

    /// Changes gravity from now on, m/s^2: for a tank that is shaken or tilted, in the frame of the tank. A checkpoint
    /// does not hold it, and a Guard does not check energies while it changes (GuardSettings::energy).
    /// @throws Error for a component that is not finite; gravity is then as it was
    void set_gravity(const std::array<double, static_cast<std::size_t>(dim)>& gravity);
    /// All limits on the next step, without the CFL number, shortest first.
    std::vector<TimeStepLimit> time_step_limits() const {
        return detail::limits_of(base_engine(), limit_rows(), false);
    }
    /// The next step and what limits it, from the speeds after the last step or `prepare`.
    TimeStepLimit next_step() const;
    /// From now on all steps are shortened by the factor `share` (above 0, at most 1): the CFL number, a fixed step and
    /// the longest step are multiplied by it. Checkpoints keep it.
    void shorten_steps(double share);
    /// The product of all shares by which steps were shortened.
    double shortened() const { return shortened_; }
    /// Sorts the particles (views become invalid), finds permanent neighbours and evaluates what is computed once:
    /// before the first step for all phases, later for phases to which particles were added and for those that sum over
    /// them. The first step calls it by itself, and again if a program has had a writable view in the meantime.
    /// @throws Error for a scene without particles or coefficients out of range
    void prepare();
    /// One step of the length the limits allow. Returns the length, s.
    double step();
    /// One step of the given length, s.
    void step(double seconds);
    /// Does the next step find neighbours anew? Then a run that is continued from here, which must find them, goes on
    /// as this one does, to the last bit.
    bool search_is_due() const { return base_engine().search_is_due(); }
    /// Throws Error, with `words` before it, if a coordinate of any particle is not a finite number.
    void require_finite(const std::string& words) const;

    /// For checkpoints (output/checkpoint.hpp): hands the complete state of the scene to `archive`, which writes it or
    /// reads it back, in the order of this function. Particles are sorted, so views become invalid.
    template <class Archive>
    void archive(Archive& archive) {
        auto& engine = base_engine();
        // Both sort, and search at the next step, so that this run and one that is continued from here stay the same.
        // The written state is sorted: writing it again, or after a checkpoint at the previous step, gives the same
        // bytes.
        if constexpr (Archive::reading)
            check_numbers();
        else
            engine.search_neighbours();
        double shortened = shortened_;
        archive(shortened);
        if constexpr (Archive::reading)
            require(shortened > 0 && shortened <= 1, "steps shortened to ", shortened,
                    " of their length; it must be above 0 and at most 1");
        engine.archive_particles(archive);
        archive(time_);
        archive(steps_);
        archive(last_step_.seconds);
        archive(last_step_.reason);
        archive(last_step_.where);
        if constexpr (Archive::reading) {
            scale_steps(shortened);
            for (auto& s : engine.phases)
                s.grown = true;
            engine.find_reference_neighbours();
            for (auto& s : engine.phases)
                s.grown = false;
            prepared_ = true;
            engine.search_neighbours();
            watch_.start_anew(engine, settings_.origin, time_, warnings_);
        }
        engine.forget_neighbours();
        engine.archive_motion(archive);
    }

protected:
    using BaseEngine = detail::SceneEngine<dim, Real>;

    /// @param with its numbers @param subcycles are steps made of shorter ones?
    SceneRun(const Settings<dim>& with, bool subcycles);
    SceneRun(const SceneRun&) = default;
    SceneRun(SceneRun&&) = default;
    SceneRun& operator=(const SceneRun&) = default;
    SceneRun& operator=(SceneRun&&) = default;
    virtual ~SceneRun() = default;

    // Parts that depend on the types of the scene.
    virtual BaseEngine& base_engine() = 0;
    virtual const BaseEngine& base_engine() const = 0;
    virtual std::span<const detail::LimitRow> limit_rows() const = 0;
    /// Throws Error for a material or a coefficient out of range.
    virtual void check_numbers() const = 0;
    /// Lets terms compute what follows from their coefficients and the spacing of the particles.
    virtual void prepare_terms() = 0;
    /// Evaluates what is computed once.
    virtual void evaluate_once() = 0;
    /// Before the first step, and after particles were added.
    virtual void start_steps() = 0;
    /// One step. @param seconds its length @param substeps how many shorter ones it is made of
    virtual void advance(double seconds, int substeps) = 0;

    void set_up(BaseEngine& engine) const;
    void take(const TimeStepLimit& chosen);
    /// A writable view was handed out, or particles were added.
    void may_change() { may_have_changed_ = true; }
    void added() {
        prepared_ = false;
        may_have_changed_ = true;
    }

    Settings<dim> settings_;
    detail::Warnings warnings_;
    double time_ = 0;
    int substeps_ = 1;

private:
    struct {
        double cfl, time_step, max_time_step;
    } given_; // as given, before shortening
    bool subcycles_;
    long long steps_ = 0;
    bool prepared_ = false;
    bool may_have_changed_ = true; // materials and coefficients, since they were checked
    double shortened_ = 1;         // the part of shorten_steps in settings_
    TimeStepLimit last_step_{0, "none yet", "start"};
    detail::SceneWatch watch_;

    // Computed from the numbers as given, so that a restarted run rounds the same way.
    void scale_steps(double shortened) {
        settings_.cfl = given_.cfl * shortened;
        settings_.time_step = given_.time_step * shortened;
        settings_.max_time_step = given_.max_time_step * shortened;
        shortened_ = shortened;
    }
    TimeStepLimit shortest(const std::vector<TimeStepLimit>& limits) const {
        return limits.empty() ? TimeStepLimit{settings_.max_time_step, "max_time_step", "settings"} : limits.front();
    }
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_run_code.hpp>
#endif
