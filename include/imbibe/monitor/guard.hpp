// Watches a run and ends it with a cause where it has gone wrong, before its numbers are worth nothing.
#pragma once

#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/guard_settings.hpp>
#include <imbibe/monitor/narrowest_passage.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace imbibe {

namespace rules {
/// Rule: a guard is of its scene's dimension.
template <class Given, class Needed>
struct GuardOfAnotherDimension {
    static_assert(sizeof(Given) == 0, "imbibe: a Guard is of its scene's dimension: replace the first by the second");
};
} // namespace rules

/// An observer for `run_until` that throws Diverged where the scene is out of its bounds. Without one nothing of this
/// is computed.
template <int dim>
class Guard {
public:
    /// With the bounds that GuardSettings begins with.
    Guard() = default;
    /// With other bounds: `Guard<2>({.upper = {1, 1}})`.
    /// @throws Error for a bound out of range
    template <class Bounds = GuardSettings<dim>> // a template, so that `Guard<2>({})` does not mean two things
    requires std::same_as<Bounds, GuardSettings<dim>>
    explicit Guard(const Bounds& with) : settings_(with) { with.check(); }

    /// The observer: a glance after every step, a look at all particles after every `interval` steps, at the pores too
    /// after every `pore_interval`.
    /// @throws Diverged
    template <class Scene>
    void operator()(const Scene& scene);
    /// Looks at everything now, for example before a checkpoint is written, so that it is a good one.
    /// @throws Diverged
    template <class Scene>
    void look(const Scene& scene);

    /// Forgets the energies it has seen, as after a return to an earlier state.
    void start_anew() { start_.reset(); }

private:
    // True, or a compile error that names the broken rule.
    template <class Scene>
    static constexpr bool check_dimension() {
        if constexpr (Scene::dimension != dim)
            return detail::break_rule<rules::GuardOfAnotherDimension<Guard, Guard<Scene::dimension>>>();
        else
            return true;
    }
    template <class Scene>
    void look_at_particles(const Scene& scene) {
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto&) {
            look_at<P>(scene, scene[PhaseHandle<P>{}], name_of<P>(scene));
        });
        scene.engine().for_each_link([&](auto between, const auto& link) { look_for_walls(scene, between, link); });
        look_at_energy(scene);
        glance(scene);
        if (!scene.meetings().empty()) {
            const Meeting& met = scene.meetings().front();
            throw Diverged(text(met.sentence, "; step ", scene.steps()), Cause::met, met.first, met.position, met.time,
                           scene.steps());
        }
    }

    GuardSettings<dim> settings_;
    struct Balance {
        double energy, kinetic, potential;                         // kinetic and potential; J
        long long particles, ever, steps;                          // how many there are, and were ever added
        std::array<double, static_cast<std::size_t>(dim)> gravity; // m/s^2
        double stored = 0;                                         // of what can be released, J; at the first look
    };
    std::optional<Balance> start_; ///< at the first look
    double kinetic_most_ = 0;
    double excess_ = 0; ///< energy that has come from nowhere (below 0: that was lost) since the first look, J

    template <class Scene>
    void glance(const Scene& scene) const {
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
            if constexpr (P::moves) {
                const double most = settings_.speed * s.material.sound_speed;
                const double fastest = scene.engine().template motion<P>().speed;
                if (s.size() > 0 && most > 0 && fastest > most) {
                    const auto phase = scene[PhaseHandle<P>{}];
                    const auto v = phase[velocity];
                    require_finite(scene, phase, name_of<P>(scene), v, "velocity");
                    const auto frame = to_eigen(scene.engine().frame).transpose().eval();
                    int i = 0;
                    for (int k = 1; k < s.size(); ++k)
                        if ((v.row(k).template cast<double>() - frame).squaredNorm() >
                            (v.row(i).template cast<double>() - frame).squaredNorm())
                            i = k;
                    stop(scene, Cause::too_fast, name_of<P>(scene), phase, i,
                         text("moves at ", fastest, " m/s, ", fastest / s.material.sound_speed,
                              " times its sound speed"));
                }
            }
        });
    }

    template <class P, class Scene>
    static std::string name_of(const Scene&) {
        return detail::name_among<P>(typename Scene::Phases{});
    }

    template <class P, class Scene, class View>
    void look_at(const Scene& scene, const View& phase, const std::string& name) const {
        if (phase.size() == 0)
            return;
        using State = std::remove_cvref_t<decltype(phase.state)>;
        const auto x = phase[position];
        require_finite_states(scene, phase, name, typename Scene::template FieldsOf<P>{});
        for (int d = 0; d < dim && P::moves; ++d) { // walls may reach out of the domain that they enclose
            const auto k = static_cast<std::size_t>(d);
            if (scene.settings().periodic_length[k] > 0)
                continue;
            const double origin = scene.settings().origin[k];
            const Extremes at = extremes(column(x, d));
            if (at.least + origin < settings_.lower[k] || at.most + origin > settings_.upper[k])
                stop(scene, Cause::left_domain, name, phase,
                     at.least + origin < settings_.lower[k] ? at.of_least : at.of_most,
                     text("is outside the domain, which goes from ", settings_.lower[k], " to ", settings_.upper[k],
                          " m in that direction",
                          scene.steps() > 0
                              ? ": unless it was thrown out, look for a leak: a wall with fewer layers than "
                                "the support radius has spacings, or a phase without a coupling to it"
                              : ", before the first step: put the particles into it, or make it wider"));
        }
        if constexpr (State::template stores<Density>) {
            const double rest = phase.material().density;
            const Extremes rho = extremes(column(phase[density], 0));
            const bool thin = rho.least / rest < settings_.least_density;
            if (thin || rho.most / rest > settings_.greatest_density) {
                const double found = thin ? rho.least : rho.most;
                stop(scene, Cause::wrong_density, name, phase, thin ? rho.of_least : rho.of_most,
                     text("has a density of ", found, " kg/m^3, ", found / rest, " of that at rest"));
            }
        }
    }
    // All that is given or integrated, a program's own fields among them: what nothing else reads would not show.
    template <class Scene, class View, class... F>
    void require_finite_states(const Scene& scene, const View& phase, const std::string& name,
                               TypeList<F...> fields) const {
        const auto look = [&]<class One>(One field) {
            if constexpr (One::given || detail::contains<Rate<One>, decltype(fields)>)
                require_finite(scene, phase, name, phase[field], One::name);
        };
        (look(F{}), ...);
    }
    template <class Scene, class View, class Field>
    void require_finite(const Scene& scene, const View& phase, const std::string& name, const Field& field,
                        std::string_view what) const {
        for (int k = 0; k < field.cols(); ++k)
            if (const int i = first_not_finite(column(field, k)); i < field.rows())
                stop(scene, Cause::not_finite, name, phase, i, text("has a ", what, " that is not finite"));
    }

    // Fields are looked at column by column as plain numbers: every shape of field would be a dozen types of Eigen, and
    // those take a compiler's memory.
    template <class Field>
    static std::span<const typename Field::Scalar> column(const Field& field, int k) {
        return {field.data() + k * field.outerStride(), static_cast<std::size_t>(field.rows())};
    }
    template <class Number>
    static int first_not_finite(std::span<const Number> all) {
        const auto found = std::find_if_not(all.begin(), all.end(), [](Number x) { return std::isfinite(x); });
        return static_cast<int>(found - all.begin());
    }
    struct Extremes {
        double least, most;
        int of_least, of_most;
    };
    template <class Number>
    static Extremes extremes(std::span<const Number> all) {
        const auto [least, most] = std::minmax_element(all.begin(), all.end());
        return {static_cast<double>(*least), static_cast<double>(*most), static_cast<int>(least - all.begin()),
                static_cast<int>(most - all.begin())};
    }
    template <class Number>
    static double farthest_from_zero(std::span<const Number> all) {
        const Extremes found = extremes(all);
        return std::max(-found.least, found.most);
    }

    // Is a particle that moves among those of a wall? The lists of neighbours are those of the last search.
    template <class Scene, class Between>
    void look_for_walls(const Scene& scene, Between, const detail::Link& link) const {
        using A = typename Between::A;
        using B = typename Between::B;
        if constexpr (A::moves && !B::moves && !Between::reference) {
            const auto &mover = scene.engine().phase(link.row.a), &wall = scene.engine().phase(link.row.b);
            const double spacing = wall.numbers().spacing;
            if (mover.disturbed || wall.disturbed || link.runs.is_empty() || link.support < 2 * spacing)
                return;
            const auto pairs = scene.engine().pairs_of(link);
            for (int i = 0; i < mover.size(); ++i) {
                if (pairs.is_alone(i))
                    continue;
                const double filled = pairs.filled_around(i, link.support, spacing);
                if (filled > settings_.inside_wall)
                    stop(
                        scene, Cause::inside_wall, name_of<A>(scene), scene[PhaseHandle<A>{}], i,
                        text("is inside ", name_of<B>(scene), ", whose particles fill ", filled, " of its surroundings",
                             scene.steps() > 0
                                 ? ": does its density follow the wall, by a continuity term in their coupling? A wall "
                                   "that is moved needs its velocity with its places. A KernelRepulsion over 0.8 "
                                   "spacings keeps the two apart, a higher sound speed lets less water in"
                                 : ", before the first step: the two phases overlap as they were added; fill one only "
                                   "where the other is not"));
            }
        }
    }

    template <class Scene>
    void look_at_pores(const Scene& scene) const {
        scene.engine().for_each_link([&]<class Between>(Between, const detail::Link&) {
            using A = typename Between::A;
            using B = typename Between::B;
            if constexpr (detail::is_fluid<A> && !detail::is_fluid<B> && !Between::reference &&
                          std::is_void_v<typename Between::Reach>)
                look_at_pores_of(scene, PhaseHandle<B>{}, scene[PhaseHandle<A>{}].material().spacing,
                                 name_of<A>(scene));
        });
    }
    template <class Scene, class P>
    void look_at_pores_of(const Scene& scene, PhaseHandle<P> handle, double particle, const std::string& fluid) const {
        const auto body = scene[handle];
        if (body.size() == 0 || !(particle > 0))
            return;
        const auto& set = scene.settings();
        // Particles of a lattice fit exactly or, by rounding, not quite.
        const double spacing = body.material().spacing, widest = (1 - 1e-3) * settings_.least_pore * particle;
        const double reach = detail::reach_of_passages(spacing, widest);
        for (const double period : set.periodic_length)
            require(period == 0 || period >= reach, "Guard: pores of least_pore = ", settings_.least_pore,
                    " particles of ", fluid, " cannot be looked for across a period of ", period,
                    " m; it must be at least ", reach, " m. Make it longer, or least_pore less or 0 (not looked at)");
        const auto found = narrowest_passage<dim, typename Scene::Real>(body[position], spacing, widest,
                                                                        scene.engine().periodic, set.threads);
        if (!found)
            return;
        std::vector<double> where;
        for (int d = 0; d < dim; ++d)
            where.push_back(found->middle[d] + set.origin[static_cast<std::size_t>(d)]);
        throw Diverged(text("a pore of phase ", name_of<P>(scene), " at (", listed(where), ") m is ", found->width,
                            " m wide, ", found->width / particle, " particles of ", fluid,
                            ", where least_pore asks for ", settings_.least_pore, "; ", moment(scene), fluid,
                            " needs a spacing of at most ", found->width / settings_.least_pore,
                            " m to pass, or the body wider pores"),
                       Cause::narrow_pore, name_of<P>(scene), where, scene.time(), scene.steps());
    }

    // Internal forces turn kinetic and potential energy into heat or tension and back, but cannot raise their sum above
    // what it was at the start by more than what was stored then.
    template <class Scene>
    void look_at_energy(const Scene& scene) {
        if (!std::isfinite(settings_.energy) || falls_through_a_period(scene))
            return;
        Balance now{0, 0, 0, scene.particles(), 0, scene.steps(), scene.settings().gravity};
        bool driven = start_ && now.gravity != start_->gravity; // shaken or tilted
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
            const auto phase = scene[PhaseHandle<P>{}];
            now.ever += s.store.ever_added();
            if constexpr (P::moves) {
                now.kinetic += kinetic_energy(phase);
                now.potential += potential_energy(phase, scene.settings().gravity);
                if constexpr (std::remove_cvref_t<decltype(s)>::template stores<Mobility>)
                    for (int i = 0; i < s.size() && !driven; ++i) // what is held and moves, the program moves
                        driven = phase[mobility](i) == 0 && !phase[velocity].row(i).isZero(0);
            } else if constexpr (std::remove_cvref_t<decltype(s)>::template stores<Velocity>) {
                for (int d = 0; d < dim && s.size() > 0 && !driven; ++d)
                    driven = farthest_from_zero(column(phase[velocity], d)) > 0;
            }
        });
        now.energy = now.kinetic + now.potential;
        if (!start_ || driven)
            excess_ = 0;
        const bool same = start_ && now.particles == start_->particles && now.ever == start_->ever;
        if (!same || driven) { // what comes and goes brings and takes energy along
            now.stored = !start_ || driven ? stored_in(scene) : start_->stored;
            start_ = now;
            start_->energy -= excess_;
            kinetic_most_ = now.kinetic;
            return;
        }
        kinetic_most_ = std::max(kinetic_most_, now.kinetic);
        excess_ = now.energy - start_->energy;
        const double turned_over =
            std::max(kinetic_most_, std::abs(now.potential - start_->potential)) + lift(scene, 0.01);
        const double allowed = settings_.energy * turned_over;
        if (excess_ <= allowed)
            return;
        const double released = std::max(start_->stored - stored_in(scene), 0.0);
        if (excess_ > allowed + released + round_off(scene))
            throw Diverged(text("energy has grown by ", excess_ - released,
                                " J without work, in a scene that has turned over ", turned_over, " J; ", moment(scene),
                                reason(scene),
                                ". Where the program itself drives the scene, as by velocities that it sets, "
                                "GuardSettings::energy is to be infinite"),
                           Cause::energy, "", {}, scene.time(), scene.steps());
    }
    template <class Scene>
    static double stored_in(const Scene& scene) {
        double stored = 0;
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto&) {
            if constexpr (P::moves)
                stored += stored_energy(scene[PhaseHandle<P>{}]);
        });
        return stored;
    }

    template <class Scene>
    static bool falls_through_a_period(const Scene& scene) {
        const auto& set = scene.settings();
        for (std::size_t d = 0; d < dim; ++d)
            if (set.gravity[d] != 0 && set.periodic_length[d] > 0)
                return true;
        return false;
    }

    // What it takes to lift everything by a share of its spacing, J: a scene that starts at rest settles by that much.
    template <class Scene>
    static double lift(const Scene& scene, double share) {
        double squared = 0, energy = 0;
        for (const double g : scene.settings().gravity)
            squared += g * g;
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
            if constexpr (P::moves)
                energy += share * s.material.spacing * std::sqrt(squared) * s.material.density *
                          std::pow(s.material.spacing, dim) * s.size();
        });
        return energy;
    }

    // What rounding may have put into the potential energy since the first look, J. A position is off by at most half
    // its last bit in every step, and all of them the same way where a step moves them by less than that; and particles
    // that were sorted are added up in another order.
    template <class Scene>
    double round_off(const Scene& scene) const {
        const double half_bit = 0.5 * static_cast<double>(std::numeric_limits<typename Scene::Real>::epsilon());
        const auto steps = static_cast<double>(scene.steps() - start_->steps);
        double energy = 0;
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
            if constexpr (P::moves) {
                const auto phase = scene[PhaseHandle<P>{}];
                const double share = half_bit * steps + s.size() * std::numeric_limits<double>::epsilon();
                for (int d = 0; d < dim && s.size() > 0; ++d)
                    energy += share * static_cast<double>(phase[mass].sum()) *
                              std::abs(scene.settings().gravity[static_cast<std::size_t>(d)]) *
                              farthest_from_zero(column(phase[position], d));
            }
        });
        return energy;
    }

    template <class Scene, class View>
    [[noreturn]] void stop(const Scene& scene, Cause cause, const std::string& name, const View& phase, int i,
                           const std::string& what) const {
        std::vector<double> where;
        for (int d = 0; d < dim; ++d)
            where.push_back(static_cast<double>(phase[position](i, d)) +
                            scene.settings().origin[static_cast<std::size_t>(d)]);
        // Before the first step what is found there says why.
        const bool is_said = scene.steps() == 0 && (cause == Cause::left_domain || cause == Cause::inside_wall);
        throw Diverged(text("particle ", phase.ids()[static_cast<std::size_t>(i)], " of phase ", name, " at (",
                            listed(where), ") m ", what, is_said ? "" : "; " + moment(scene) + reason(scene)),
                       cause, name, where, scene.time(), scene.steps());
    }
    static std::string listed(const std::vector<double>& numbers) {
        std::string all;
        for (const double x : numbers)
            all += text(all.empty() ? "" : ", ", x);
        return all;
    }
    template <class Scene>
    static std::string moment(const Scene& scene) {
        return text("step ", scene.steps(), ", time ", scene.time(), " s. ");
    }
    // The likely reason: a step near or beyond a limit, or something else.
    template <class Scene>
    static std::string reason(const Scene& scene) {
        const auto limits = scene.time_step_limits();
        const auto& last = scene.last_step();
        if (limits.empty() || !(last.seconds > 0))
            return "Look at how the scene starts: overlapping particles, velocities out of range";
        const auto& least = limits.front();
        const double share = last.seconds / least.seconds;
        if (share > 1)
            return text("The last step of ", last.seconds, " s was ", share, " times the limit of ", least.seconds,
                        " s (", least.reason, ", ", least.where, "): take shorter steps");
        return text("The last step of ", last.seconds, " s was within the shortest limit, ", least.seconds, " s (",
                    least.reason, ", ", least.where, "): look for a sound speed too low for the speeds that occur, ",
                    "forces that the limits do not know, or a start with overlaps; a lower cfl tells these apart");
    }
};

// Out of the class: a program may leave them to a library (`extern template`).

template <int dim>
template <class Scene>
void Guard<dim>::operator()(const Scene& scene) {
    if constexpr (check_dimension<Scene>()) {
        const bool at_pores = settings_.least_pore > 0 && scene.steps() % settings_.pore_interval == 0;
        if (at_pores || scene.steps() % settings_.interval == 0)
            look_at_particles(scene);
        else
            glance(scene);
        if (at_pores)
            look_at_pores(scene);
    }
}
template <int dim>
template <class Scene>
void Guard<dim>::look(const Scene& scene) {
    if constexpr (check_dimension<Scene>()) {
        look_at_particles(scene);
        if (settings_.least_pore > 0)
            look_at_pores(scene);
    }
}

/// A guard is of the dimension of its bounds.
template <int dim>
Guard(const GuardSettings<dim>&) -> Guard<dim>;

} // namespace imbibe
