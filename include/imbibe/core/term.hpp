// What a term is made of, and how the library finds out what it reads and writes.
//
// A term is one physical or numerical effect: an empty struct that is either one part itself or lists its parts in
// `using parts = Parts<...>`. A part is
//   - a particle function  (a) -> values, with `reads`, and `sets` and/or `adds`, or
//   - a pair function      (a, b, ab) -> what neighbour b contributes to a, with `reads` and `adds`. It must vanish at
//     the support radius and beyond, as everything multiplied by a kernel does: neighbours are searched somewhat
//     further, and packs are padded with arbitrary particles.
// It is constexpr and calls sqrt, exp, pow, min and max by these names alone, because its numbers may be packs. Besides
// its fields a particle has `material`, `gravity()`, `time`, the time at the begin of the step, s, and `time_step`, s:
// the length by which states are advanced with the rates being computed. `time_step` is 0 for parts that are computed
// once, and with integrators that do not advance states by these rates alone (MidpointRungeKutta, PredictorCorrector).
//
// Optional members of a part: `Parameters parameters;` (filled from the phase), `using neighbourhood = Reference;`,
// `static constexpr bool once = true;` (evaluated before the first step and when particles are added, for all
// particles, not in every step: it reads only what does not change, such as masses and reference positions), and, of a
// particle function, `static constexpr bool in_packs = true;`: like a pair function it has no `if` on its numbers, so
// it is called for as many particles at once as the machine computes.
//
// Optional members of a term:
//   - `struct Parameters`, and `using stores = Fields<...>;` for fields without a part;
//   - `using effect`: an effect of which a phase may have one term only, see below;
//   - `using beside_in_couplings`: a term that every coupling must have into the phase if it has one of that effect;
//     `using never_in_couplings`: a term that no coupling may have;
//   - `using corrected_kernel`: the kernel of a gradient, or of its correction; it must be the same throughout a phase;
//   - `using reacts_to = TypeList<...>`: terms of the same coupling that it needs there;
//   - where it may be listed, each `static constexpr bool ... = true;`: `within_phases` (not in couplings), `one_sided`
//     (in couplings, as Into the wall or the solid), `between_fluids` (in phases, and in couplings of two fluids),
//     `between_fluid_and_other` (in couplings of a fluid and what is none), `of_solids` (it asks for the elastic moduli
//     of `Solid`), `needs_viscosity` (it asks for the viscosity of its phase, or of one of the two of a coupling);
//   - `static double support_radius(const auto& material)`, in couplings with both materials, followed by the
//     Parameters if it needs them: how far its pair functions reach, m, if not as far as the phases do. Their
//     neighbours are listed apart, so the other terms do not pay for them;
//   - `struct Prepared` and `template <int dim> static Prepared prepare(const auto& material, const Lattice<dim>&)`, in
//     couplings with both materials, followed by the Parameters if it needs them: numbers that follow from spacing,
//     support radius and dimension (lattice.hpp). They are computed before the first step and when a program may have
//     changed coefficients, and fill the member `Prepared prepared;` of its parts;
//   - `using reductions = Parts<...>`: sums, maxima and minima of its fields, see Sum, Max and Min;
//   - `static constexpr bool changes_volume = true`: its rate of the density ties the density to the positions, so it
//     is not removed from the volume of a fluid that fills a periodic box (closed_fluid.hpp);
//   - `static constexpr bool overlapping = true`, in couplings: the two phases may overlap, as a skeleton and the fluid
//     in its pores do;
//   - `using pressure_kernel`: the kernel of a pressure force whose lattice resists shear (Lattice::shear_stiffness);
//   - `static constexpr double greatest_poisson_ratio` of a law of stress: above it a scene warns;
//   - `static double time_step_limit(const auto& material, const TimeStepInput&)`, in couplings with both materials,
//     followed by the Parameters if it needs them, with `static constexpr const char* limit_name`. A force that reads
//     positions must have one, 2/sqrt(k) for a stiffness k per mass, or derive from `NotStiff`: the solver's own limit
//     on accelerations, sqrt(spacing/|a|), sees how far a particle is thrown in a step, not how stiff the force is. A
//     term that is stiff in the distance of two particles, or in a field computed from positions, should have one too.
#pragma once

#include <imbibe/core/field.hpp>
#include <imbibe/core/fields.hpp>
#include <imbibe/core/rule.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <tuple>

namespace imbibe {

/// Effects of which a phase, or each side of a coupling, may have one term only: two forms of the same equation would
/// count it twice. A term says `using effect = effects::pressure_force;`.
namespace effects {
struct continuity_equation; ///< the rate of the density by the motion
struct pressure_force;      ///< that of the pressure, or of all of a solid's stress, over present neighbours or others
struct viscous_force;       ///< that of the physical viscosity
struct density_diffusion;   ///< what smooths the density over the neighbours
struct velocity_gradient;   ///< the gradient that rates of stress are made of
struct stress_rate;         ///< the rate of the deviatoric stress
} // namespace effects

// Advice, printed as a template argument.
struct give_it_value_of_q;
struct give_it_derivative_of_q;
struct give_it_laplacian_of_q_or_take_one_such_as_ViscosityKernel;
struct give_it_second_derivative_of_q;

namespace rules {
/// Rule: where a term takes a kernel it is given one.
template <class Given>
struct NotAKernel {
    static_assert(sizeof(Given) == 0, "imbibe: a term is given this where it takes a kernel, such as WendlandC2");
};
/// Rule: a kernel has the functions that terms ask it for.
template <class Kernel, class Advice>
struct KernelLacksAFunction {
    static_assert(sizeof(Kernel) == 0, "imbibe: a term asks this kernel for a function that it does not have, or that "
                                       "cannot be called with one number");
};
/// Rule: a kernel that has a cubic_slope c has a derivative of the form w'(q)/q = -c (1 - q)^3.
template <class Kernel>
struct CubicSlopeOfAnotherForm {
    static_assert(sizeof(Kernel) == 0, "imbibe: a kernel's cubic_slope must be above 0, and its derivative_over_q(q) "
                                       "equal to -cubic_slope (1 - q)^3");
};
} // namespace rules

/// See lattice.hpp.
template <int dim>
struct Lattice;

/// The parts of a term.
template <class... P>
using Parts = TypeList<P...>;

/// A part among the `reductions` of a term, whose function (a) -> number is summed over the particles of a phase:
/// `using reduces = Sum<StoredEnergy>;`. It lists the fields it `reads`. It is evaluated only when a time step limit, a
/// guard or a program asks for it (`reduced`), never as part of a step. Its numbers are plain doubles, and it may
/// branch. In a coupling it is ignored.
/// @tparam Quantity_ what it is: a field, or a struct with `name` and `unit`
template <class Quantity_>
struct Sum {
    using Quantity = Quantity_;          ///< what is summed up
    static constexpr double of_none = 0; ///< of no particles
    /// Of two sets of particles.
    static constexpr double both(double one, double other) { return one + other; }
};
/// The greatest; see Sum.
template <class Quantity_>
struct Max {
    using Quantity = Quantity_; ///< whose greatest value is taken
    /// Of no particles.
    static constexpr double of_none = -std::numeric_limits<double>::infinity();
    /// Of two sets of particles.
    static constexpr double both(double one, double other) { return std::max(one, other); }
};
/// The least; see Sum.
template <class Quantity_>
struct Min {
    using Quantity = Quantity_; ///< whose least value is taken
    /// Of no particles.
    static constexpr double of_none = std::numeric_limits<double>::infinity();
    /// Of two sets of particles.
    static constexpr double both(double one, double other) { return std::min(one, other); }
};

/// The energy that a term stores and gives back, J (J/m in 2D): what a Guard counts.
struct StoredEnergy {
    static constexpr std::string_view name = "stored energy", unit = "J";
};

/// Neighbours by where the particles are now (the default) ...
struct Current {};
/// ... or by where they were when the solid was stress-free (total Lagrangian).
struct Reference {};

/// A contribution along the line of centres: scalar * (x_a - x_b). All terms of a sweep are summed as scalars and
/// multiplied by the offset once, which is faster and conserves angular momentum by construction.
template <class T>
struct Central {
    T factor; ///< what the offset is multiplied by
};

/// The value of a particle or pair function with several results, in the order of `sets`, then `adds`.
template <class... T>
IMBIBE_INLINE constexpr std::tuple<T...> values(const T&... v) {
    return {v...};
}

/// A support radius and the powers of it that kernels are made of.
struct SupportRadius {
    double radius;            ///< H, m
    double inverse;           ///< 1/H, 1/m
    double inverse_cube_root; ///< H^(-1/3), m^(-1/3)

    /// Of H > 0, m.
    constexpr explicit SupportRadius(double H) : radius(H), inverse(1 / H), inverse_cube_root(cube_root(1 / H)) {}
};

/// The geometry of a pair as seen by particle a: everything that depends on positions alone.
template <int dim, class T>
struct Pair {
    Vector<T, dim> offset;           ///< x_a - x_b, m (or X_a - X_b for the reference neighbourhood)
    T distance;                      ///< |x_a - x_b|, m
    T support_radius;                ///< H, m
    T inverse_support;               ///< 1/H, 1/m
    T inverse_support_cube_root;     ///< H^(-1/3), m^(-1/3)
    Vector<double, dim> gravity_now; ///< the scene's gravity, m/s^2

    Pair() = default;
    /// A pair at `offset_ab`; its `distance` is |offset_ab|.
    constexpr Pair(const Vector<T, dim>& offset_ab, T distance_ab, const SupportRadius& support,
                   const Vector<double, dim>& gravity)
        : offset(offset_ab), distance(distance_ab), gravity_now(gravity) {
        set(support);
    }
    /// Gives it this support radius.
    IMBIBE_INLINE constexpr void set(const SupportRadius& support) {
        support_radius = T(support.radius);
        inverse_support = T(support.inverse);
        inverse_support_cube_root = T(support.inverse_cube_root);
    }
    /// The same pair, if its support radius were not above `reach`, m.
    IMBIBE_INLINE constexpr Pair within(double reach) const {
        const SupportRadius narrow(std::max(reach, 1e-30));
        Pair pair = *this;
        pair.support_radius = min(support_radius, T(narrow.radius));
        pair.inverse_support = max(inverse_support, T(narrow.inverse));
        pair.inverse_support_cube_root = max(inverse_support_cube_root, T(narrow.inverse_cube_root));
        return pair;
    }

    /// 1 / max(|x_a - x_b|, 1e-6 H): finite also for the particle itself.
    IMBIBE_INLINE constexpr T inverse_distance() const { return T(1) / max(distance, T(1e-6) * support_radius); }
    /// The square of that, with one quotient and no root.
    IMBIBE_INLINE constexpr T inverse_squared_distance() const {
        return T(1) / max(squared_norm(offset), sq(T(1e-6) * support_radius));
    }

    /// W_ab of a kernel with this pair's support radius, 1/m^dim.
    template <class Kernel>
    IMBIBE_INLINE constexpr T value(Kernel) const {
        if constexpr (!is_kernel<Kernel>)
            return not_a_kernel<Kernel>();
        else if constexpr (requires(T x) { Kernel::value(x, x); })
            return Kernel::value(q(), scale<dim>(factor<Kernel>));
        else if constexpr (requires(T x) { Kernel::value(x); })
            return scale<dim>(factor<Kernel>) * Kernel::value(q());
        else
            return lacks_a_function<Kernel, give_it_value_of_q>();
    }
    /// The factor F_ab with grad_a W_ab = F_ab (x_a - x_b), 1/m^(dim+2): negative where W falls with distance.
    template <class Kernel>
    IMBIBE_INLINE constexpr T gradient(Kernel) const {
        if constexpr (!is_kernel<Kernel>)
            return not_a_kernel<Kernel>();
        else if constexpr (requires { Kernel::cubic_slope; }) {
            // -c (1 - r/H)^3 = (k r/H - k)^3 with k^3 = c: so c takes no multiplication in the pair loop.
            if constexpr (!(Kernel::cubic_slope > 0 && Kernel::derivative_over_q(0.0) == -Kernel::cubic_slope))
                detail::break_rule<rules::CubicSlopeOfAnotherForm<Kernel>>();
            constexpr double root = cube_root(Kernel::cubic_slope * factor<Kernel>);
            const T k = T(root) * inverse_support * power<dim - 1>(inverse_support_cube_root);
            return power<3>(negative_part(distance * (k * inverse_support) - k));
        } else if constexpr (requires(T x) { Kernel::derivative_over_q(x, x); })
            return Kernel::derivative_over_q(q(), scale<dim + 2>(factor<Kernel>));
        else if constexpr (requires(T x) { Kernel::derivative_over_q(x); })
            return scale<dim + 2>(factor<Kernel>) * Kernel::derivative_over_q(q());
        else if constexpr (requires(T x) { Kernel::derivative(x, x); })
            return Kernel::derivative(q(), scale<dim + 1>(factor<Kernel>)) * inverse_distance();
        else if constexpr (requires(T x) { Kernel::derivative(x); })
            return scale<dim + 1>(factor<Kernel>) * Kernel::derivative(q()) * inverse_distance();
        else
            return lacks_a_function<Kernel, give_it_derivative_of_q>();
    }
    /// The Laplacian of W_ab, 1/m^(dim+2).
    template <class Kernel>
    IMBIBE_INLINE constexpr T laplacian(Kernel) const {
        if constexpr (!is_kernel<Kernel>)
            return not_a_kernel<Kernel>();
        else if constexpr (requires(T x) { Kernel::laplacian(x, x); })
            return Kernel::laplacian(q(), scale<dim + 2>(factor<Kernel>));
        else if constexpr (requires(T x) { Kernel::laplacian(x); })
            return scale<dim + 2>(factor<Kernel>) * Kernel::laplacian(q());
        else
            return lacks_a_function<Kernel, give_it_laplacian_of_q_or_take_one_such_as_ViscosityKernel>();
    }
    /// The second derivative of W_ab along the line of centres, d2W/dr2, 1/m^(dim+2).
    template <class Kernel>
    IMBIBE_INLINE constexpr T second_derivative(Kernel) const {
        if constexpr (!is_kernel<Kernel>)
            return not_a_kernel<Kernel>();
        else if constexpr (requires(T x) { Kernel::second_derivative(x); })
            return scale<dim + 2>(factor<Kernel>) * Kernel::second_derivative(q());
        else
            return lacks_a_function<Kernel, give_it_second_derivative_of_q>();
    }
    /// W_ab / W(length): how much closer than `length` the pair is, in terms of the kernel. `length` < H.
    template <class Kernel>
    IMBIBE_INLINE constexpr T relative_value(Kernel, double length) const {
        if constexpr (!is_kernel<Kernel>)
            return not_a_kernel<Kernel>();
        else if constexpr (requires(T x) { Kernel::value(x); })
            return Kernel::value(q()) / Kernel::value(T(length) * inverse_support);
        else
            return lacks_a_function<Kernel, give_it_value_of_q>();
    }
    /// The distance in supports, q = |x_a - x_b| / H.
    IMBIBE_INLINE constexpr T q() const { return distance * inverse_support; }
    /// Gravity as numbers of this pair, m/s^2.
    IMBIBE_INLINE constexpr Vector<T, dim> gravity() const {
        Vector<T, dim> g{};
        for (int i = 0; i < dim; ++i)
            g[i] = T(gravity_now[i]);
        return g;
    }

private:
    template <class Kernel>
    static constexpr bool is_kernel = requires { Kernel::template normalisation<dim>(); };
    template <class Kernel>
    static constexpr double factor = Kernel::template normalisation<dim>();
    template <class Kernel>
    static constexpr T not_a_kernel() {
        detail::break_rule<rules::NotAKernel<Kernel>>();
        return T{};
    }
    template <class Kernel, class Advice>
    static constexpr T lacks_a_function() {
        detail::break_rule<rules::KernelLacksAFunction<Kernel, Advice>>();
        return T{};
    }
    template <int n>
    IMBIBE_INLINE constexpr T scale(double normalisation) const {
        return T(normalisation) * power<n>(inverse_support);
    }
};

/// The contribution factor * (x_a - x_b) along the line of centres.
template <int dim, class T>
IMBIBE_INLINE constexpr Central<T> along(const Pair<dim, T>&, const std::type_identity_t<T>& factor) {
    return {factor};
}

/// What a term may use to limit the time step.
///
/// Speeds are relative to the surroundings: in the frame of the walls (their mean velocity); at rest if particles are
/// held; without either, in the frame of the mean velocity of all particles. Two particles approach with at most the
/// sum of their phases' `max_speed`.
struct IMBIBE_PER_BUILD TimeStepInput {
    double support_radius;   ///< H of the phase, m
    double spacing;          ///< initial particle spacing of the phase, m
    double max_speed;        ///< greatest speed in the phase now, m/s, in the frame said above
    double max_acceleration; ///< greatest acceleration in the phase in the last step, m/s^2
    int dimension;           ///< 2 or 3
    /// The spacing of the other phase and its greatest speed, for terms of a coupling.
    double other_spacing = 0, other_max_speed = 0;
    /// The distance of the two phases' nearest particles at the begin of the last step, m: for terms of a coupling that
    /// ask for it with `static constexpr bool limit_by_nearest = true`. Infinite for others, and if no pair is in
    /// reach.
    double nearest = std::numeric_limits<double>::infinity();
    /// Result of the term's own reduction by Max, for terms of a phase.
    double greatest = 0;
    /// Result of its reduction by Min.
    double least = 0;
    /// The greatest velocity in the phase, m/s, without change of frame: for a term that needs the velocity itself.
    double fastest = 0;
};

/// The base of a term whose force depends on positions but is not stiff in them, such as that of a rotating frame or of
/// a wave maker: it does not limit the step.
struct NotStiff {
    static constexpr const char* limit_name = "not stiff";
    static double time_step_limit(const auto&, const TimeStepInput&) { return std::numeric_limits<double>::infinity(); }
    static double time_step_limit(const auto&, const auto&, const TimeStepInput&) {
        return std::numeric_limits<double>::infinity();
    }
};

namespace detail {

/// Is this phase a fluid, and not a solid or a wall? A term of a coupling may ask which side it is on.
template <class Phase>
inline constexpr bool is_fluid = Phase::moves&& requires(const Phase& phase) {
    phase.viscosity;
};

template <class Term>
concept HasParts = requires { typename Term::parts; };
template <class Term>
concept HasStores = requires { typename Term::stores; };
/// A term with the materials M of a phase or of both phases of a coupling, and its parameters if it needs them: its
/// support radius, and the numbers that it prepares.
template <class Term, class... M>
concept SaysSupport = requires(const M&... material) {
    { Term::support_radius(material...) } -> std::convertible_to<double>;
};
template <class Term, class... M>
concept SaysSupportByParameters = requires(const M&... material, const typename Term::Parameters& parameters) {
    { Term::support_radius(material..., parameters) } -> std::convertible_to<double>;
};
template <class Term, int dim, class... M>
concept PreparesByLattice = requires(const M&... material, const Lattice<dim>& lattice) {
    { Term::prepare(material..., lattice) } -> std::same_as<typename Term::Prepared>;
};
template <class Term, int dim, class... M>
concept PreparesByParameters =
    requires(const M&... material, const Lattice<dim>& lattice, const typename Term::Parameters& parameters) {
        { Term::prepare(material..., lattice, parameters) } -> std::same_as<typename Term::Prepared>;
    };
/// Has it numbers to prepare?
template <class Term>
concept Prepares = requires { typename Term::Prepared; };

/// A term with the coefficients of Owner, a phase; or a coupling, of two.
template <class Term, class Owner>
struct TermOf {
    static constexpr bool says_support = SaysSupport<Term, Owner> || SaysSupportByParameters<Term, Owner>;
    template <int dim>
    static constexpr bool prepares = PreparesByLattice<Term, dim, Owner> || PreparesByParameters<Term, dim, Owner>;
};
template <class Term, class Owner>
    requires requires { typename Owner::First; typename Owner::Second; }
struct TermOf<Term, Owner> {
    using A = typename Owner::First;
    using B = typename Owner::Second;
    static constexpr bool says_support = SaysSupport<Term, A, B> || SaysSupportByParameters<Term, A, B>;
    template <int dim>
    static constexpr bool prepares = PreparesByLattice<Term, dim, A, B> || PreparesByParameters<Term, dim, A, B>;
};
/// How far it reaches, m. @param material the phase, or both phases of a coupling
template <class Term, class Owner, class... M>
double support_of_term(const Owner& owner, const M&... material) {
    if constexpr (SaysSupport<Term, M...>)
        return Term::support_radius(material...);
    else
        return Term::support_radius(material..., owner.coefficients.template get<typename Term::Parameters>());
}
/// Has it a function of that name that cannot be called with these arguments?
template <class Term, class Owner>
inline constexpr bool support_of_another_form = !TermOf<Term, Owner>::says_support && requires {
    &Term::support_radius;
};

/// Has it what a term must have: parts, fields that it stores, or the fields of a part?
template <class T>
concept IsTerm = HasParts<T> || HasStores<T> || requires { typename T::reads; } || requires { typename T::adds; } ||
                 requires { typename T::sets; };

template <class Term>
struct PartsOf {
    using type = std::conditional_t<IsTerm<Term>, TypeList<Term>, TypeList<>>;
};
// A type that is no list is an error of its own; it counts here as a list's only element.
template <class Given>
struct ListOfParts {
    using type = std::conditional_t<IsTerm<Given>, TypeList<Given>, TypeList<>>;
};
template <class... P>
struct ListOfParts<TypeList<P...>> {
    using type = TypeList<P...>;
};
template <HasParts Term>
struct PartsOf<Term> {
    using type = typename ListOfParts<typename Term::parts>::type;
};
template <class Term>
    requires(!HasParts<Term> && HasStores<Term>)
struct PartsOf<Term> {
    using type = TypeList<>;
};
template <class Term>
using PartList = typename PartsOf<Term>::type;
template <class Term>
inline constexpr bool lists_its_parts = true;
template <HasParts Term>
inline constexpr bool lists_its_parts<Term> = std::is_same_v<typename Term::parts, PartList<Term>>;

template <class Part>
struct ReadsOf {
    using type = TypeList<>;
};
template <class Part>
    requires requires { typename Part::reads; }
struct ReadsOf<Part> {
    using type = typename Part::reads;
};
template <class Part>
struct AddsOf {
    using type = TypeList<>;
};
template <class Part>
    requires requires { typename Part::adds; }
struct AddsOf<Part> {
    using type = typename Part::adds;
};
template <class Part>
struct SetsOf {
    using type = TypeList<>;
};
template <class Part>
    requires requires { typename Part::sets; }
struct SetsOf<Part> {
    using type = typename Part::sets;
};
template <class Term>
struct ReductionsOf {
    using type = TypeList<>;
};
template <class Term>
    requires requires { typename Term::reductions; }
struct ReductionsOf<Term> {
    using type = typename Term::reductions;
};
template <class Term>
struct StoresOf {
    using type = TypeList<>;
};
template <HasStores Term>
struct StoresOf<Term> {
    using type = typename Term::stores;
};

template <class Part>
inline constexpr bool is_in_packs = false;
template <class Part>
    requires requires { Part::in_packs; }
inline constexpr bool is_in_packs<Part> = Part::in_packs;
template <class Part>
inline constexpr bool is_once = false;
template <class Part>
    requires requires { Part::once; }
inline constexpr bool is_once<Part> = Part::once;

template <class Part>
inline constexpr bool uses_reference = false;
template <class Part>
    requires requires { typename Part::neighbourhood; }
inline constexpr bool uses_reference<Part> = std::is_same_v<typename Part::neighbourhood, Reference>;

/// Results of term functions as a tuple, whether there is one or several.
template <class R>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;

template <class R>
inline constexpr bool is_central = false;
template <class T>
inline constexpr bool is_central<Central<T>> = true;

} // namespace detail
} // namespace imbibe
