// The limits on a time step: every active term and coupling offers its own, and they are listed with their reasons.
#pragma once

#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/rules.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// A limit on the time step: how long, why, and in which phase or coupling.
struct TimeStepLimit {
    double seconds; ///< the longest stable step, s
    /// What it comes from, and the phase or coupling.
    std::string reason, where;
};

namespace detail {

/// Limits on the time step, shortest first.
class SortedLimits {
public:
    /// All that were added, without the CFL number.
    std::vector<TimeStepLimit> sorted() && { return std::move(limits_); }

protected:
    [[gnu::noinline]] void add(double seconds, const char* reason, std::string where) {
        auto behind = limits_.begin();
        while (behind != limits_.end() && behind->seconds <= seconds)
            ++behind;
        limits_.insert(behind, {seconds, reason, std::move(where)});
    }

private:
    std::vector<TimeStepLimit> limits_;
};

struct Acceleration; ///< stands for the limit on how far an acceleration throws a particle, which is of no term

/// All limits are chosen.
struct AllLimits {
    /// Is that of `Term`, in a phase or coupling?
    template <class Where, class Term>
    static constexpr bool chosen = true;
};

/// Collects the limits that the terms of phases and couplings offer by `time_step_limit`, for the present speeds.
/// @tparam Which says which of them: see AllLimits
template <class Engine, class Which = AllLimits>
class TimeStepLimits : public SortedLimits {
public:
    explicit TimeStepLimits(const Engine& engine) : engine_(engine) {}

    /// Those of a phase: its terms, and its greatest acceleration.
    template <class P>
    void add_phase() {
        add_terms_of_phase<P>(typename P::terms{});
    }
    /// Those of a coupling, unless its phases are out of each other's reach.
    template <class C>
    void add_coupling() {
        add_terms_of_coupling<C>(typename C::terms{});
    }
    /// How long a particle of phase P takes for its spacing, at its present speed or by its present acceleration; and
    /// what its terms allow of steps that are as long as that (`advection_limit`).
    template <class P>
    void add_advection() {
        if (engine_.template state<P>().size() == 0)
            return;
        const TimeStepInput in = input_of<P>();
        const double speed = std::max(in.max_speed, P::moves ? std::sqrt(in.spacing * in.max_acceleration) : 0.0);
        if (speed > 0)
            add(in.spacing / speed, "advection", name_of<P>());
        add_advection_of_terms<P>(in, typename P::terms{});
    }

private:
    const Engine& engine_;

    // Worked out once, as limits are asked for in every step; and never destroyed, so that a host's own destructors may
    // still ask at the program's end.
    template <class Where>
    static const std::string& name_of() {
        using All = std::conditional_t<IsCoupling<Where>, typename Engine::Couplings, typename Engine::Phases>;
        static const std::string& name = *new std::string(name_among<Where>(All{}));
        return name;
    }
    template <class P>
    const auto& material() const {
        return engine_.template state<P>().material;
    }
    template <class P>
    TimeStepInput input_of() const {
        const auto motion = engine_.template motion_now<P>();
        return {.support_radius = material<P>().support_radius,
                .spacing = material<P>().spacing,
                .max_speed = motion.speed,
                .max_acceleration = motion.acceleration,
                .dimension = Engine::dimension,
                .fastest = motion.fastest};
    }
    template <class P, class... Term>
    void add_terms_of_phase(TypeList<Term...>) {
        if (engine_.template state<P>().size() == 0)
            return;
        const TimeStepInput in = input_of<P>();
        (add_term_of_phase<Term, P>(in), ...);
        if (P::moves && Which::template chosen<P, Acceleration> && in.max_acceleration > 0)
            add(std::sqrt(in.spacing / in.max_acceleration), "acceleration", name_of<P>());
    }
    template <class P, class... Term>
    void add_advection_of_terms(const TimeStepInput& in, TypeList<Term...>) {
        [[maybe_unused]] const auto one = [&]<class T>(std::type_identity<T>) {
            if constexpr (requires { typename T::Parameters; } && Which::template chosen<P, T>)
                if constexpr (const auto& all = material<P>(); requires {
                                  T::advection_limit(all, in, all.coefficients.template get<typename T::Parameters>());
                              })
                    add(T::advection_limit(all, in, all.coefficients.template get<typename T::Parameters>()),
                        T::advection_limit_name, name_of<P>());
        };
        (one(std::type_identity<Term>{}), ...);
    }
    template <class Term, class P>
    void add_term_of_phase(const TimeStepInput& in) {
        if constexpr (Which::template chosen<P, Term>)
            add_term<Term, P>(material<P>(), with_extremes<Term, P>(in), material<P>());
    }
    template <class Term, class C, class A, class B>
    void add_term_of_coupling(const TimeStepInput& in) {
        if constexpr (Which::template chosen<C, Term>)
            add_term<Term, C>(engine_.template coupling<C>(), in, material<A>(), material<B>());
    }
    template <class C, class... Term>
    void add_terms_of_coupling(TypeList<Term...>) {
        using A = typename C::First;
        using B = typename C::Second;
        if (engine_.template state<A>().size() == 0 || engine_.template state<B>().size() == 0 ||
            engine_.template are_apart<A, B>())
            return;
        [[maybe_unused]] TimeStepInput in = input_of<A>();
        const TimeStepInput other = input_of<B>();
        in.support_radius = engine_.template support<A, B>();
        in.other_spacing = other.spacing;
        in.other_max_speed = other.max_speed;
        in.nearest = engine_.template nearest_of<C>();
        (add_term_of_coupling<typename Listed<Term>::Term, C, A, B>(in), ...);
    }
    template <class Term, class P>
    TimeStepInput with_extremes(TimeStepInput in) const {
        if constexpr (requires { typename Term::limit_by_greatest; }) {
            const auto s = engine_.template state<P>();
            in.greatest = static_cast<double>(s.view(typename Term::limit_by_greatest{}).maxCoeff());
        }
        if constexpr (requires { typename Term::limit_by_least_trace; }) {
            const auto tensors = engine_.template state<P>().view(typename Term::limit_by_least_trace{});
            const auto diagonal = [&](int d) {
                return tensors.col(SymmetricTensor<double, Engine::dimension>::index(d, d));
            };
            if constexpr (Engine::dimension == 2)
                in.least_trace = static_cast<double>((diagonal(0) + diagonal(1)).minCoeff());
            else
                in.least_trace = static_cast<double>((diagonal(0) + diagonal(1) + diagonal(2)).minCoeff());
        }
        return in;
    }
    // Can a limit be asked for with these materials?
    template <class Term, class... M>
    static constexpr bool has_limit() {
        if constexpr (requires(const M&... m, const TimeStepInput& in) { Term::time_step_limit(m..., in); })
            return true;
        else if constexpr (requires { typename Term::Parameters; })
            return requires(const M&... m, const TimeStepInput& in, const typename Term::Parameters& parameters) {
                Term::time_step_limit(m..., in, parameters);
            };
        else
            return false;
    }
    // Has the term a limit and its name, or neither? One of phases only, or of couplings, has none in the others.
    template <class Term, class Where, class M, class... Other>
    static constexpr bool check_limit() {
        constexpr bool callable = has_limit<Term, M, Other...>() || has_limit<Term, M>() || has_limit<Term, M, M>();
        constexpr bool named = requires { Term::limit_name; };
        constexpr bool there = callable || requires { &Term::time_step_limit; };
        if constexpr (there != named || callable != named)
            return break_rule<rules::LimitNotUsable<
                Term, write_time_step_limit_of_the_material_and_TimeStepInput_with_a_limit_name>>();
        else
            return check_force<Term, Where, M, Other...>();
    }
    // Does something that the term moves read where it is, and the term not say what steps that bears?
    template <class Term, class Where, class... Materials>
    static constexpr bool check_force() {
        constexpr bool is_force = []<class... Part>(TypeList<Part...>) {
            return (contains<Position, typename ReadsOf<Part>::type> || ...) &&
                   (contains<Rate<Velocity>, typename AddsOf<Part>::type> || ...);
        }(PartList<Term>{});
        if constexpr (is_force && (Materials::moves || ...) && !has_limit<Term, Materials...>())
            return break_rule<rules::ForceOfPositionsWithoutLimit<
                Term, Where, write_a_time_step_limit_with_a_limit_name_or_derive_it_from_NotStiff>>();
        else
            return true;
    }
    // A term may need no coefficients for its limit, or have no limit.
    template <class Term, class Where, class Owner, class... Materials>
    void add_term(const Owner& owner, const TimeStepInput& in, const Materials&... materials) {
        double seconds = -1;
        if constexpr (!suits<Where, Term> && !IsCoupling<Where>) {
            return; // an error of its own
        } else if constexpr (requires { Term::time_step_limit(materials..., in); }) {
            seconds = Term::time_step_limit(materials..., in);
        } else if constexpr (requires { typename Term::Parameters; }) {
            const auto& parameters = owner.coefficients.template get<typename Term::Parameters>();
            if constexpr (requires { Term::time_step_limit(materials..., in, parameters); })
                seconds = Term::time_step_limit(materials..., in, parameters);
        }
        if constexpr (!check_limit<Term, Where, Materials...>())
            return;
        else if constexpr (requires { Term::limit_name; })
            if (seconds >= 0 && seconds < std::numeric_limits<double>::infinity())
                add(seconds, Term::limit_name, name_of<Where>());
    }
};

} // namespace detail
} // namespace imbibe
