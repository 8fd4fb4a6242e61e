// The code of guard.hpp: looks at columns of particles, at lists of neighbours and at energies.
#pragma once

#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/narrowest_passage.hpp>
#include <imbibe/monitor/phase_energy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace imbibe {

namespace detail {

/// The least and the greatest of some numbers, and their places.
struct Extremes {
    double least, most;
    int of_least, of_most;
};
template <class Number>
Extremes extremes_of(std::span<const Number> all) {
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return {static_cast<double>(*least), static_cast<double>(*most), static_cast<int>(least - all.begin()),
            static_cast<int>(most - all.begin())};
}
template <class Number>
double farthest_from_zero(std::span<const Number> all) {
    const Extremes found = extremes_of(all);
    return std::max(-found.least, found.most);
}
/// A column of a phase without the padding behind its particles.
template <int dim, class Real>
std::span<const Real> numbers_in(const PhaseStore<dim, Real>& phase, int column) {
    return {phase.column(column), static_cast<std::size_t>(phase.size())};
}
IMBIBE_CODE std::string listed(const std::vector<double>& numbers) {
    std::string all;
    for (const double x : numbers)
        all += text(all.empty() ? "" : ", ", x);
    return all;
}
IMBIBE_CODE std::string moment_in_words(long long steps, double time) {
    return text("step ", steps, ", time ", time, " s. ");
}
/// The likely reason: a step near or beyond a limit, or something else.
IMBIBE_CODE std::string likely_reason(const std::vector<TimeStepLimit>& limits, const TimeStepLimit& last) {
    if (limits.empty() || !(last.seconds > 0))
        return "Look at how the scene starts: overlapping particles, velocities out of range";
    const auto& least = limits.front();
    const double share = last.seconds / least.seconds;
    if (share > 1)
        return text("The last step of ", last.seconds, " s was ", share, " times the limit of ", least.seconds, " s (",
                    least.reason, ", ", least.where, "): take shorter steps");
    return text("The last step of ", last.seconds, " s was within the shortest limit, ", least.seconds, " s (",
                least.reason, ", ", least.where, "): look for a sound speed too low for the speeds that occur, ",
                "forces that the limits do not know, or a start with overlaps; a lower cfl tells these apart");
}
/// The energy stored by the terms of all moving phases, J.
template <int dim, class Real>
double stored_in(const SceneStore<dim, Real>& scene) {
    double stored = 0;
    for (const Reduction<dim, Real>& row : scene.reductions)
        if (row.quantity == StoredEnergy::name && scene.phase(row.phase).row->moves)
            stored += reduced(scene.phase(row.phase), row, scene.threads);
    return stored;
}
/// The energy that lifts everything by a share of its spacing, J: a scene that starts at rest settles by that much.
template <int dim, class Real>
double lift(const SceneStore<dim, Real>& scene, double share) {
    double energy = 0;
    for (const auto& s : scene.phases)
        if (s.row->moves) {
            const PhaseNumbers numbers = s.numbers();
            energy += share * numbers.spacing * std::sqrt(squared_norm(scene.gravity)) * numbers.density *
                      std::pow(numbers.spacing, dim) * s.size();
        }
    return energy;
}
/// Does the program move particles of the phase, those of a wall or those that are held?
template <int dim, class Real>
bool is_driven(const PhaseStore<dim, Real>& s) {
    const PhaseRow& row = *s.row;
    if (s.size() == 0 || row.velocity < 0 || (row.moves && row.mobility < 0))
        return false;
    for (int d = 0; d < dim; ++d) {
        const auto v = numbers_in(s, row.velocity + d);
        for (std::size_t i = 0; i < v.size(); ++i)
            if (v[i] != 0 && (!row.moves || s.column(row.mobility)[i] == 0))
                return true;
    }
    return false;
}

} // namespace detail

template <int dim>
template <class Real>
void Guard<dim>::look_after_step(const SceneRun<dim, Real>& scene) {
    const bool at_pores = settings_.least_pore > 0 && scene.steps() % settings_.pore_interval == 0;
    if (at_pores || scene.steps() % settings_.interval == 0)
        look_at_particles(scene);
    else
        glance(scene);
    if (at_pores)
        look_at_pores(scene);
}

template <int dim>
template <class Real>
void Guard<dim>::look_at_all(const SceneRun<dim, Real>& scene) {
    look_at_particles(scene);
    if (settings_.least_pore > 0)
        look_at_pores(scene);
}

template <int dim>
template <class Real>
void Guard<dim>::look_at_particles(const Run<Real>& scene) {
    for (const Phase<Real>& phase : scene.scene_engine().phases)
        look_at(scene, phase);
    for (const detail::Link& link : scene.scene_engine().links)
        look_for_walls(scene, link);
    look_at_energy(scene);
    glance(scene);
    if (!scene.meetings().empty()) {
        const Meeting& met = scene.meetings().front();
        throw Diverged(text(met.sentence, "; step ", scene.steps()), Cause::met, met.first, met.position, met.time,
                       scene.steps());
    }
}

template <int dim>
template <class Real>
void Guard<dim>::glance(const Run<Real>& scene) const {
    for (const Phase<Real>& s : scene.scene_engine().phases) {
        const double sound = s.numbers().sound_speed, most = settings_.speed * sound, fastest = s.motion.speed;
        if (!s.row->moves || s.size() == 0)
            continue;
        const bool too_fast = most > 0 && fastest > most;
        const auto& mean = s.motion.mean; // not a number if a velocity is none, which no comparison notices
        if (!too_fast && std::isfinite(mean[0] + mean[1] + mean[2]))
            continue;
        require_finite(scene, s, s.row->field_at(s.row->velocity));
        if (!too_fast)
            continue;
        int found = 0;
        double greatest = -1;
        for (int i = 0; i < s.size(); ++i) {
            double squared = 0;
            for (int d = 0; d < dim; ++d)
                squared += sq(static_cast<double>(s.column(s.row->velocity + d)[i]) - scene.scene_engine().frame[d]);
            if (squared > greatest) {
                greatest = squared;
                found = i;
            }
        }
        stop(scene, Cause::too_fast, s, found,
             text("moves at ", fastest, " m/s, ", fastest / sound, " times its sound speed"));
    }
}

template <int dim>
template <class Real>
void Guard<dim>::look_at(const Run<Real>& scene, const Phase<Real>& phase) const {
    if (phase.size() == 0)
        return;
    // All given or integrated fields, a program's own among them: an error in a field that nothing else reads would not
    // show.
    for (const detail::FieldRow& field : phase.row->fields)
        if (field.is_state)
            require_finite(scene, phase, field);
    for (int d = 0; d < dim && phase.row->moves; ++d) { // walls may reach out of the domain that they enclose
        const auto k = static_cast<std::size_t>(d);
        if (scene.settings().periodic_length[k] > 0)
            continue;
        const double origin = scene.settings().origin[k];
        const auto at = detail::extremes_of(detail::numbers_in(phase, phase.row->position + d));
        if (at.least + origin < settings_.lower[k] || at.most + origin > settings_.upper[k])
            stop(scene, Cause::left_domain, phase, at.least + origin < settings_.lower[k] ? at.of_least : at.of_most,
                 text("is outside the domain, which goes from ", settings_.lower[k], " to ", settings_.upper[k],
                      " m in that direction",
                      scene.steps() > 0 ? ": unless it was thrown out, look for a leak: a wall with fewer layers than "
                                          "the support radius has spacings, or a phase without a coupling to it"
                                        : ", before the first step: put the particles into it, or make it wider"));
    }
    if (phase.row->density >= 0) {
        const double rest = phase.numbers().density;
        std::vector<double> densities(static_cast<std::size_t>(phase.size()));
        for (int i = 0; i < phase.size(); ++i)
            densities[static_cast<std::size_t>(i)] = phase.own_density(i);
        const auto rho = detail::extremes_of(std::span<const double>(densities));
        const bool thin = rho.least / rest < settings_.least_density;
        if (thin || rho.most / rest > settings_.greatest_density) {
            const double found = thin ? rho.least : rho.most;
            stop(scene, Cause::wrong_density, phase, thin ? rho.of_least : rho.of_most,
                 text("has a density of ", found, " kg/m^3, ", found / rest, " of that at rest"));
        }
    }
}

// Is a moving particle inside a wall? The neighbour lists are those of the last search.
template <int dim>
template <class Real>
void Guard<dim>::look_for_walls(const Run<Real>& scene, const detail::Link& link) const {
    const auto& engine = scene.scene_engine();
    const auto &mover = engine.phase(link.row.a), &wall = engine.phase(link.row.b);
    if (!mover.row->moves || wall.row->moves || link.row.reference)
        return;
    const double spacing = wall.numbers().spacing;
    if (mover.disturbed || wall.disturbed || link.runs.is_empty() || link.support < 2 * spacing)
        return;
    const auto pairs = engine.pairs_of(link);
    for (int i = 0; i < mover.size(); ++i) {
        if (pairs.is_alone(i))
            continue;
        const double filled = pairs.filled_around(i, link.support, spacing);
        if (filled > settings_.inside_wall)
            stop(scene, Cause::inside_wall, mover, i,
                 text("is inside ", wall.name, ", whose particles fill ", filled, " of its surroundings",
                      scene.steps() > 0
                          ? ": does its density follow the wall, by a continuity term in their coupling? A wall "
                            "that is moved needs its velocity with its places. A KernelRepulsion over 0.8 "
                            "spacings keeps the two apart, a higher sound speed lets less water in"
                          : ", before the first step: the two phases overlap as they were added; fill one only "
                            "where the other is not"));
    }
}

template <int dim>
template <class Real>
void Guard<dim>::look_at_pores(const Run<Real>& scene) const {
    const auto& engine = scene.scene_engine();
    for (const detail::Link& link : engine.links) {
        const detail::LinkRow& row = link.row;
        if (engine.phase(row.a).row->fluid && !engine.phase(row.b).row->fluid && !row.reference &&
            row.support_of_term == nullptr)
            look_at_pores_of(scene, engine.phase(row.b), engine.phase(row.a));
    }
}

template <int dim>
template <class Real>
void Guard<dim>::look_at_pores_of(const Run<Real>& scene, const Phase<Real>& body, const Phase<Real>& fluid) const {
    const double particle = fluid.numbers().spacing;
    if (body.size() == 0 || !(particle > 0))
        return;
    const auto& set = scene.settings();
    // Particles of a lattice fit exactly or, by rounding, almost.
    const double spacing = body.numbers().spacing, widest = (1 - 1e-3) * settings_.least_pore * particle;
    const double reach = detail::reach_of_passages(spacing, widest);
    for (const double period : set.periodic_length)
        require(period == 0 || period >= reach, "Guard: pores of least_pore = ", settings_.least_pore, " particles of ",
                fluid.name, " cannot be looked for across a period of ", period, " m; it must be at least ", reach,
                " m. Make it longer, or least_pore less or 0 (not looked at)");
    using Places = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, dim>, 0, Eigen::OuterStride<>>;
    const Places places(body.column(body.row->position), body.size(), dim,
                        Eigen::OuterStride<>(static_cast<Eigen::Index>(body.stride())));
    const auto found =
        narrowest_passage<dim, Real>(places, spacing, widest, scene.scene_engine().periodic, set.threads);
    if (!found)
        return;
    std::vector<double> where;
    for (int d = 0; d < dim; ++d)
        where.push_back(found->middle[d] + set.origin[static_cast<std::size_t>(d)]);
    throw Diverged(text("a pore of phase ", body.name, " at (", detail::listed(where), ") m is ", found->width,
                        " m wide, ", found->width / particle, " particles of ", fluid.name,
                        ", where least_pore asks for ", settings_.least_pore, "; ",
                        detail::moment_in_words(scene.steps(), scene.time()), fluid.name,
                        " needs a spacing of at most ", found->width / settings_.least_pore,
                        " m to pass, or the body wider pores"),
                   Cause::narrow_pore, body.name, where, scene.time(), scene.steps());
}

// Internal forces convert kinetic and potential energy to heat or stored energy and back, but cannot raise their sum
// above its initial value by more than the energy stored then.
template <int dim>
template <class Real>
void Guard<dim>::look_at_energy(const Run<Real>& scene) {
    const auto& set = scene.settings();
    const auto& engine = scene.scene_engine();
    if (!std::isfinite(settings_.energy))
        return;
    for (std::size_t d = 0; d < dim; ++d)
        if (set.gravity[d] != 0 && set.periodic_length[d] > 0) // a fall through the period never ends
            return;
    Balance now{0, 0, 0, scene.particles(), 0, scene.steps(), set.gravity};
    bool driven = start_ && now.gravity != start_->gravity; // shaken or tilted
    for (const Phase<Real>& s : engine.phases) {
        now.ever += s.ever_added();
        driven = driven || detail::is_driven(s);
        if (s.row->moves) {
            now.kinetic += detail::kinetic_energy_of(s, engine.threads);
            now.potential += detail::potential_energy_of(s, set.gravity, engine.threads);
        }
    }
    now.energy = now.kinetic + now.potential;
    if (!start_ || driven)
        excess_ = 0;
    const bool same = start_ && now.particles == start_->particles && now.ever == start_->ever;
    if (!same || driven) { // particles that come and go bring and take energy
        now.stored = !start_ || driven ? detail::stored_in(engine) : start_->stored;
        start_ = now;
        start_->energy -= excess_;
        kinetic_most_ = now.kinetic;
        return;
    }
    kinetic_most_ = std::max(kinetic_most_, now.kinetic);
    excess_ = now.energy - start_->energy;
    const double turned_over =
        std::max(kinetic_most_, std::abs(now.potential - start_->potential)) + detail::lift(engine, 0.01);
    const double allowed = settings_.energy * turned_over;
    if (excess_ <= allowed)
        return;
    const double released = std::max(start_->stored - detail::stored_in(engine), 0.0);
    if (excess_ > allowed + released + round_off(scene))
        throw Diverged(text("energy has grown by ", excess_ - released,
                            " J without work, in a scene that has turned over ", turned_over, " J; ",
                            detail::moment_in_words(scene.steps(), scene.time()),
                            detail::likely_reason(scene.time_step_limits(), scene.last_step()),
                            ". Where the program itself drives the scene, as by velocities that it sets, "
                            "GuardSettings::energy is to be infinite"),
                       Cause::energy, "", {}, scene.time(), scene.steps());
}

// An upper bound of the potential energy from rounding since the first look, J. In every step a position is off by at
// most half its last bit, in the same direction for all if a step moves them by less than that; and sorted particles
// are added up in another order.
template <int dim>
template <class Real>
double Guard<dim>::round_off(const Run<Real>& scene) const {
    const double half_bit = 0.5 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    const auto steps = static_cast<double>(scene.steps() - start_->steps);
    double energy = 0;
    for (const Phase<Real>& s : scene.scene_engine().phases) {
        if (!s.row->moves || s.size() == 0)
            continue;
        const double share = half_bit * steps + s.size() * std::numeric_limits<double>::epsilon();
        double total = 0;
        for (const Real m : detail::numbers_in(s, s.row->mass))
            total += static_cast<double>(m);
        for (int d = 0; d < dim; ++d)
            energy += share * total * std::abs(scene.settings().gravity[static_cast<std::size_t>(d)]) *
                      detail::farthest_from_zero(detail::numbers_in(s, s.row->position + d));
    }
    return energy;
}

template <int dim>
template <class Real>
void Guard<dim>::require_finite(const Run<Real>& scene, const Phase<Real>& phase, const detail::FieldRow& field) const {
    for (int k = field.first; k < field.first + field.components; ++k) {
        const auto all = detail::numbers_in(phase, k);
        const auto found = std::find_if_not(all.begin(), all.end(), [](Real x) { return std::isfinite(x); });
        if (found != all.end())
            stop(scene, Cause::not_finite, phase, static_cast<int>(found - all.begin()),
                 text("has a ", field.name, " that is not finite"));
    }
}

template <int dim>
template <class Real>
void Guard<dim>::stop(const Run<Real>& scene, Cause cause, const Phase<Real>& phase, int i,
                      const std::string& what) const {
    std::vector<double> where;
    for (int d = 0; d < dim; ++d)
        where.push_back(static_cast<double>(phase.column(phase.row->position + d)[i]) +
                        scene.settings().origin[static_cast<std::size_t>(d)]);
    // Before the first step the message of the finding gives the reason already.
    const bool is_said = scene.steps() == 0 && (cause == Cause::left_domain || cause == Cause::inside_wall);
    const std::string reason = is_said ? ""
                                       : "; " + detail::moment_in_words(scene.steps(), scene.time()) +
                                             detail::likely_reason(scene.time_step_limits(), scene.last_step());
    throw Diverged(text("particle ", phase.ids[static_cast<std::size_t>(i)], " of phase ", phase.name, " at (",
                        detail::listed(where), ") m ", what, reason),
                   cause, phase.name, where, scene.time(), scene.steps());
}

} // namespace imbibe
