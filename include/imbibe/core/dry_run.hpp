// Runs a part's function at compile time on a recording particle: which fields does it read, and on which side of the
// pair? The record becomes the part's row in the schedule. The function must return one value for each field that the
// part adds to or sets. A pair function is run once more for a pair beyond the support radius, where it must return
// zero.
#pragma once

#include <imbibe/core/rule.hpp>
#include <imbibe/core/term.hpp>

namespace imbibe {

namespace rules {
/// Rule: a term may read only what it declares in `reads`.
template <class Field, class Term>
struct ReadsWhatItDoesNotDeclare {
    static_assert(sizeof(Field) == 0, "imbibe: this term reads a field that is missing from its `reads`: add it there");
};
/// Rule: a term must not declare a field in `reads` that it never looks at (it would be loaded for nothing).
template <class Field, class Term>
struct DeclaresWhatItDoesNotRead {
    static_assert(sizeof(Field) == 0,
                  "imbibe: this term lists a field in `reads` that it never reads: remove it there");
};
/// Rule: a term's function is one of a particle, or of a particle, its neighbour and their pair.
template <class Part>
struct NotCallable {
    static_assert(sizeof(Part) == 0,
                  "imbibe: this term has no function `operator()(a) const` or `operator()(a, b, ab) const` that "
                  "can be called. An error in the function itself comes first: mend that");
};
/// Rule: a term's function can be run by the compiler.
template <class Part>
struct NotConstexpr {
    static_assert(
        sizeof(Part) == 0,
        "imbibe: this term's function cannot be run at compile time: declare it constexpr; with parameters at "
        "their defaults it must not divide by zero. An error in the function itself comes first: mend that");
};
/// Rule: a term returns one value for each field that it sets or adds to, in their order.
template <class Part>
struct ReturnsAnotherNumber {
    static_assert(sizeof(Part) == 0, "imbibe: this term returns more or fewer values than the fields it sets or adds "
                                     "to: for several fields a std::tuple");
};
/// Rule: the value that a term returns for a field has the field's rank.
template <class Field, class Part>
struct ReturnsAnotherRank {
    static_assert(sizeof(Field) == 0, "imbibe: what this term returns for this field is of another rank, such as a "
                                      "number for a vector");
};
/// Rule: what a neighbour contributes vanishes at the support radius and beyond.
template <class Part>
struct ReachesBeyondTheSupport {
    static_assert(sizeof(Part) == 0, "imbibe: this term counts neighbours beyond the support radius, which are not all "
                                     "there: multiply by a kernel, its gradient, or what else vanishes there");
};
} // namespace rules

namespace detail {

// A material whose members are ordinary numbers.
template <class Material>
constexpr Material sample_material() {
    Material m{};
    m.density = 1000;
    m.sound_speed = 10;
    if constexpr (requires { m.viscosity; })
        m.viscosity = 1e-3;
    if constexpr (requires { m.shear_modulus; })
        m.shear_modulus = 1e4;
    m.support_radius = 1;
    m.spacing = 0.5;
    return m;
}
template <class Material>
inline constexpr Material ordinary_material = sample_material<Material>();

// Values that keep every formula finite: tensors are near the identity, vectors have different components.
template <class V>
constexpr V sample_value() {
    if constexpr (!Algebraic<V>) {
        return V(1.25);
    } else {
        V v{};
        for (int k = 0; k < V::size; ++k)
            v.c[k] = typename V::Scalar(0.5 / (k + 1));
        if constexpr (V::size != dimension_of<V>)
            for (int i = 0; i < dimension_of<V>; ++i)
                v(i, i) = typename V::Scalar(1.5 + i);
        return v;
    }
}

template <class Part, int dim, class Material_>
struct RecordingParticle {
    using Material = Material_;
    using Reads = typename ReadsOf<Part>::type;
    using Scalar = Number<double>;
    static constexpr int dimension = dim;
    bool* seen;
    const Material& material = ordinary_material<Material>;
    double time_step = 0.01, time = 0.1;

    template <class F>
    constexpr auto operator[](F) const {
        if constexpr (!contains<F, Reads>)
            break_rule<rules::ReadsWhatItDoesNotDeclare<F, Part>>();
        else
            seen[index_of<F, Reads>] = true;
        return sample_value<Value<F, dim, Scalar>>();
    }
    constexpr Vector<Scalar, dim> gravity() const { return sample_value<Vector<Scalar, dim>>(); }
};

template <class Part, int dim, class MaterialA, class MaterialB>
inline constexpr bool is_pair_part =
    std::is_invocable_v<const Part&, RecordingParticle<Part, dim, MaterialA>, RecordingParticle<Part, dim, MaterialB>,
                        Pair<dim, Number<double>>>;
template <class Part, int dim, class Material>
inline constexpr bool is_particle_part = std::is_invocable_v<const Part&, RecordingParticle<Part, dim, Material>>;

/// Which of a part's declared reads it makes on a, and which on b.
template <int n>
struct SidedReads {
    bool a[static_cast<std::size_t>(n + 1)] = {}, b[static_cast<std::size_t>(n + 1)] = {};

    /// All of them: reported for a part that breaks a rule, so that it breaks no other.
    static constexpr SidedReads all() {
        SidedReads reads;
        for (bool& read : reads.a)
            read = true;
        return reads;
    }
};

template <class Part, int dim, class MaterialA, class MaterialB>
constexpr auto dry_run() {
    using A = RecordingParticle<Part, dim, MaterialA>;
    using B = RecordingParticle<Part, dim, MaterialB>;
    SidedReads<A::Reads::size> seen;
    const Part part{};
    const A a{seen.a};
    if constexpr (is_pair_part<Part, dim, MaterialA, MaterialB>) {
        using T = Number<double>;
        Pair<dim, T> ab{Vector<T, dim>::filled(T(0.25)), T(0.5), SupportRadius(1), Vector<double, dim>::filled(1.0)};
        (void)part(a, B{seen.b}, ab);
    } else {
        (void)part(a);
    }
    return seen;
}
template <class Part, int dim, class MaterialA, class MaterialB>
concept RunsAtCompileTime = requires {
    typename std::bool_constant<(dry_run<Part, dim, MaterialA, MaterialB>(), true)>;
};

// Has the part a function that takes such arguments, though it cannot be called? Then its body has an error, which the
// compiler has reported already. The check overloads it with an equally good function that takes anything: the call is
// ambiguous, so nothing is called. It uses types of its own, because clang++ does not look again at a call that has
// failed.
template <class T>
struct Again : T {};
struct TakesAnything {
    template <class A, class = void>
    void operator()(const A&) const;
    template <class A, class B, class P, class = void>
    void operator()(const A&, const B&, const P&) const;
};
template <class Part>
struct OrAnything : Part, TakesAnything {
    using Part::operator();
    using TakesAnything::operator();
};
struct HasTheName {
    void operator()() const;
};
template <class Part>
struct WithTheName : Part, HasTheName {};
template <class Part, class... T>
constexpr bool takes() {
    if constexpr (!std::is_class_v<Part> || std::is_final_v<Part>)
        return false;
    else if constexpr (requires { &WithTheName<Part>::operator(); })
        return false; // else the name would be ambiguous: the part has no function at all
    else
        return !std::is_invocable_v<const OrAnything<Part>&, Again<T>...>;
}

template <class Part, int dim, class MaterialA, class MaterialB>
constexpr auto record_reads() {
    using A = RecordingParticle<Part, dim, MaterialA>;
    using B = RecordingParticle<Part, dim, MaterialB>;
    if constexpr (!is_pair_part<Part, dim, MaterialA, MaterialB> && !is_particle_part<Part, dim, MaterialA>) {
        if constexpr (!takes<Part, A>() && !takes<Part, A, B, Pair<dim, Number<double>>>())
            break_rule<rules::NotCallable<Part>>();
        return SidedReads<ReadsOf<Part>::type::size>::all();
    } else if constexpr (!RunsAtCompileTime<Part, dim, MaterialA, MaterialB>) {
        break_rule<rules::NotConstexpr<Part>>();
        return SidedReads<ReadsOf<Part>::type::size>::all();
    } else {
        return dry_run<Part, dim, MaterialA, MaterialB>();
    }
}

template <class Part, int dim, class MaterialA, class MaterialB>
inline constexpr auto reads_on = record_reads<Part, dim, MaterialA, MaterialB>();

// The rule is named only where it is broken: naming it is the error.
template <class Part, bool is_read, class F>
constexpr bool check_read() {
    if constexpr (!is_read)
        return break_rule<rules::DeclaresWhatItDoesNotRead<F, Part>>();
    else
        return true;
}

template <class Part, auto seen, class... F>
constexpr bool check_all_read(TypeList<F...>) {
    using List = TypeList<F...>;
    return (check_read < Part, seen.a[index_of<F, List>] || seen.b[index_of<F, List>], F > () && ...);
}

// May a part return V for field F? `Central` is for pairs only.
template <class F, int dim, class V>
inline constexpr bool is_value_of = [] {
    if constexpr (Algebraic<V>)
        return F::rank != Rank::scalar && V::size == components(F::rank, dim) && dimension_of<V> == dim;
    else
        return is_central<V> ? F::rank == Rank::vector : F::rank == Rank::scalar;
}();
template <class Part, int dim, class F, class V>
constexpr bool check_value() {
    if constexpr (!is_value_of<F, dim, std::remove_cvref_t<V>>)
        return break_rule<rules::ReturnsAnotherRank<F, Part>>();
    else
        return true;
}
template <class Part, int dim, class R, class... F>
constexpr bool check_values(std::type_identity<R>, TypeList<F...>) {
    if constexpr (sizeof...(F) != 1)
        return break_rule<rules::ReturnsAnotherNumber<Part>>();
    else
        return (check_value<Part, dim, F, R>() && ...);
}
template <class Part, int dim, class... V, class... F>
constexpr bool check_values(std::type_identity<std::tuple<V...>>, TypeList<F...>) {
    if constexpr (sizeof...(F) != sizeof...(V))
        return break_rule<rules::ReturnsAnotherNumber<Part>>();
    else
        return (check_value<Part, dim, F, V>() && ...);
}
// Are all components of the value zero?
template <class V>
constexpr bool is_zero(const V& value) {
    if constexpr (Algebraic<V>) {
        for (int k = 0; k < V::size; ++k)
            if (!(value.c[k][0] == 0))
                return false;
        return true;
    } else if constexpr (is_central<V>) {
        return is_zero(value.factor);
    } else if constexpr (requires { value[0]; }) {
        return value[0] == 0;
    } else {
        return value == 0;
    }
}
template <class... V>
constexpr bool is_zero(const std::tuple<V...>& values) {
    return std::apply([](const V&... value) { return (is_zero(value) && ...); }, values);
}
// What a pair contributes at a distance of twice the support radius.
template <class Part, int dim, class MaterialA, class MaterialB>
constexpr bool vanishes_beyond() {
    using A = RecordingParticle<Part, dim, MaterialA>;
    using B = RecordingParticle<Part, dim, MaterialB>;
    using T = Number<double>;
    SidedReads<A::Reads::size> seen;
    Vector<T, dim> offset{};
    offset[0] = T(2);
    const Pair<dim, T> ab{offset, T(2), SupportRadius(1), Vector<double, dim>::filled(1.0)};
    return is_zero(Part{}(A{seen.a}, B{seen.b}, ab));
}
// Is that contribution not zero? False where the compiler cannot run the function on such a pair.
template <class Part, int dim, class MaterialA, class MaterialB>
inline constexpr bool counts_beyond = false;
template <class Part, int dim, class MaterialA, class MaterialB>
    requires requires { typename std::bool_constant<vanishes_beyond<Part, dim, MaterialA, MaterialB>()>; }
inline constexpr bool counts_beyond<Part, dim, MaterialA, MaterialB> =
    !vanishes_beyond<Part, dim, MaterialA, MaterialB>();
template <class Part, int dim, class MaterialA, class MaterialB>
constexpr bool check_reach() {
    if constexpr (counts_beyond<Part, dim, MaterialA, MaterialB>)
        return break_rule<rules::ReachesBeyondTheSupport<Part>>();
    else
        return true;
}

// What a part returns, for the fields that it sets or adds to.
template <class Part, int dim, class MaterialA, class MaterialB>
constexpr bool check_returned() {
    using A = RecordingParticle<Part, dim, MaterialA>;
    using B = RecordingParticle<Part, dim, MaterialB>;
    using Given = Concat<typename SetsOf<Part>::type, typename AddsOf<Part>::type>;
    if constexpr (!is_pair_part<Part, dim, MaterialA, MaterialB> && !is_particle_part<Part, dim, MaterialA>) {
        return false; // reported by another rule
    } else if constexpr (!RunsAtCompileTime<Part, dim, MaterialA, MaterialB>) {
        return false; // reported by another rule
    } else if constexpr (is_pair_part<Part, dim, MaterialA, MaterialB>) {
        using R = std::invoke_result_t<const Part&, A, B, Pair<dim, Number<double>>>;
        if constexpr (SetsOf<Part>::type::size > 0)
            return true; // reported by another rule
        else if constexpr (check_values<Part, dim>(std::type_identity<R>{}, Given{}))
            return check_reach<Part, dim, MaterialA, MaterialB>();
        else
            return false;
    } else {
        return check_values<Part, dim>(std::type_identity<std::invoke_result_t<const Part&, A>>{}, Given{});
    }
}

} // namespace detail
} // namespace imbibe
