// Runs a part's function once at compile time on a recording particle: which fields does it really read, and on
// which side of the pair? What it returns is thrown away; the record becomes the part's row in the schedule.
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
} // namespace rules

namespace detail {

template <class Material>
inline constexpr Material default_material{};

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
    const Material& material = default_material<Material>;
    double time_step = 0.01;

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
    std::is_invocable_v<Part, RecordingParticle<Part, dim, MaterialA>, RecordingParticle<Part, dim, MaterialB>,
                        Pair<dim, Number<double>>>;

/// Which of a part's declared reads it makes on a, and which on b.
template <int n>
struct SidedReads {
    bool a[static_cast<std::size_t>(n + 1)] = {}, b[static_cast<std::size_t>(n + 1)] = {};
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
inline constexpr auto reads_on = dry_run<Part, dim, MaterialA, MaterialB>();

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

} // namespace detail
} // namespace imbibe
