// The loops over the particles of a phase and over their neighbours. The pair loop gathers: each particle sums over its
// own runs in a fixed order and only its own sums are written, so threads never race and never change a bit.
#pragma once

#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/seen.hpp>

namespace imbibe::detail {

/// A vector of the scene, such as gravity, in the number type of a part.
template <class T, int dim>
IMBIBE_INLINE Vector<T, dim> in_numbers(const Vector<double, dim>& v) {
    Vector<T, dim> result;
    for (int k = 0; k < dim; ++k)
        result[k] = T(v[k]);
    return result;
}

/// The addresses of each component of a phase's fields. They are kept in memory, not computed from a stride: a compiler
/// that knows the stride computes an address for every column of every pack.
template <int dim, class List, class Real>
using Columns = std::array<const Real*, static_cast<std::size_t>(component_count<dim, List>)>;

/// A pack of consecutive neighbours as a part sees them. The dry run has checked that a part reads only declared
/// fields.
template <class P, class List, int dim, class Real, int width>
struct NeighbourView {
    using Material = P;
    using Scalar = Pack<Real, width>;
    static constexpr int dimension = dim;
    const Columns<dim, List, Real>& columns;
    std::size_t first; ///< the number of the first
    const P& material;
    const Vector<double, dim>& gravity_now;
    const Vector<Real, dim>& image; ///< displacement of the periodic image through which they are seen, m

    template <class F>
    IMBIBE_INLINE auto operator[](F) const {
        constexpr std::size_t column = component_offset<dim, F, List>;
        Value<F, dim, Scalar> v;
        for (int k = 0; k < components(F::rank, dim); ++k)
            component(v, k) = Scalar::load(columns[column + static_cast<std::size_t>(k)] + first);
        if constexpr (std::is_same_v<F, Position> || std::is_same_v<F, ReferencePosition>)
            for (int k = 0; k < dim; ++k)
                component(v, k) += Scalar(image[k]);
        return v;
    }
    IMBIBE_INLINE Vector<Scalar, dim> gravity() const { return in_numbers<Scalar>(gravity_now); }
};

/// Fields of the computed particle, each number in all lanes of a pack: a sweep loads them once for all its neighbours.
/// Or those of as many consecutive particles as a pack has lanes.
template <class List, int dim, class T>
struct OwnValues {
    T values[static_cast<std::size_t>(component_count<dim, List> > 0 ? component_count<dim, List> : 1)];

    /// @param first the particle's number in the first column of its phase
    template <class Stored, class Real>
    IMBIBE_INLINE void load(const Real* first, std::size_t stride) {
        load_fields<Stored>(first, stride, List{}, [](const Real* number) { return T(*number); });
    }
    /// The same for consecutive particles from there on.
    template <class Stored, class Real>
    IMBIBE_INLINE void load_consecutive(const Real* first, std::size_t stride) {
        load_fields<Stored>(first, stride, List{}, [](const Real* number) { return T::load(number); });
    }
    template <class F>
    IMBIBE_INLINE auto get() const {
        Value<F, dim, T> v;
        for (int k = 0; k < components(F::rank, dim); ++k)
            component(v, k) = values[component_offset<dim, F, List> + k];
        return v;
    }

private:
    template <class Stored, class Real, class... F>
    IMBIBE_INLINE void load_fields([[maybe_unused]] const Real* first, [[maybe_unused]] std::size_t stride,
                                   TypeList<F...>, [[maybe_unused]] const auto& loaded) {
        [[maybe_unused]] const auto one = [&]<class G>(std::type_identity<G>) {
            for (int k = 0; k < components(G::rank, dim); ++k)
                values[component_offset<dim, G, List> + k] =
                    loaded(first + static_cast<std::size_t>(component_offset<dim, G, Stored> + k) * stride);
        };
        (one(std::type_identity<F>{}), ...);
    }
};

/// That particle as a part sees it.
template <class P, class List, int dim, class T>
struct OwnView {
    using Material = P;
    using Scalar = T;
    static constexpr int dimension = dim;
    const OwnValues<List, dim, T>& own;
    const P& material;
    const Vector<double, dim>& gravity_now;
    double time_step; ///< time by which states are advanced in this step, s; 0 for what is computed once
    double time;      ///< of the scene at the begin of the step, s

    template <class F>
    IMBIBE_INLINE auto operator[](F) const {
        return own.template get<F>();
    }
    IMBIBE_INLINE Vector<T, dim> gravity() const { return in_numbers<T>(gravity_now); }
};

/// The fields of their own particle that the nodes of a sweep read.
template <int dim, class List>
struct OwnFieldsOf;
template <int dim, class... N>
struct OwnFieldsOf<dim, TypeList<N...>> {
    using type = Unique<Concat<ReadsOnA<dim, N>...>>;
};

/// The sums of a sweep, field by field, with the contributions along the line of centres not yet multiplied by the
/// offset.
template <class List, int dim, class T>
struct Sums {
    T total[static_cast<std::size_t>(component_count<dim, List>)];
    T central[static_cast<std::size_t>(List::size)];

    template <class F, class V>
    IMBIBE_INLINE void add(const V& value) {
        constexpr int first = component_offset<dim, F, List>;
        for (int k = 0; k < components(F::rank, dim); ++k)
            total[first + k] += component(value, k);
    }
    template <class F>
    IMBIBE_INLINE void add(const Central<T>& value) {
        static_assert(F::rank == Rank::vector, "imbibe: along(ab, ...) adds to a vector field");
        central[index_of<F, List>] += value.factor;
    }
};

template <int dim, class T, class List, class Node_, class R, std::size_t... k>
IMBIBE_INLINE void add_all(Sums<List, dim, T>& sums, const R& result, std::index_sequence<k...>) {
    if constexpr (is_tuple<R>)
        (sums.template add<At<static_cast<int>(k), typename Node_::Adds>>(std::get<k>(result)), ...);
    else
        (sums.template add<At<static_cast<int>(k), typename Node_::Adds>>(result), ...);
}

/// A part with its coefficients and prepared numbers, filled in from the phase or coupling that owns it.
template <class N, class Owner>
IMBIBE_INLINE auto make_part(const Owner& owner) {
    typename N::Part part{};
    if constexpr (requires { part.parameters; })
        part.parameters = owner.coefficients.template get<std::remove_cvref_t<decltype(part.parameters)>>();
    if constexpr (requires { part.prepared; })
        part.prepared = std::get<std::remove_cvref_t<decltype(part.prepared)>>(owner.coefficients.prepared);
    return part;
}

/// The neighbours of a sweep: the phase, the kind of positions, and the reach; see Node.
template <class B_, bool reference_, class Reach_>
struct Source {
    using B = B_;
    using Reach = Reach_;
    static constexpr bool reference = reference_;
};

template <class S>
struct NodesFrom {
    template <class N>
    struct Keep : std::is_same<Source<typename N::B, N::reference, typename N::Reach>, S> {};
};

template <class List>
struct SourcesOf;
template <class... N>
struct SourcesOf<TypeList<N...>> {
    using type = Unique<TypeList<Source<typename N::B, N::reference, typename N::Reach>...>>;
};
template <class List>
struct AddsOfNodes;
template <class... N>
struct AddsOfNodes<TypeList<N...>> {
    using type = Unique<Concat<typename N::Adds...>>;
};

/// Lower bounds of the squared distances of a run, by its number of neighbours: 0 for these, and beyond the support,
/// where every kernel is zero, for the lanes behind them. One instruction, where a comparison of lanes takes five.
template <class Real, int width>
class IMBIBE_PER_BUILD LeastDistances {
public:
    LeastDistances() = default;
    explicit LeastDistances(double support) {
        for (std::size_t k = lanes; k < 2 * lanes; ++k)
            squared_[k] = static_cast<Real>(1.0001 * support * support);
    }
    IMBIBE_INLINE Pack<Real, width> squared(std::size_t count) const {
        return Pack<Real, width>::load(squared_ + (lanes - count));
    }

private:
    static constexpr auto lanes = static_cast<std::size_t>(width);
    alignas(sizeof(Real) * 2 * lanes) Real squared_[2 * lanes]{}; ///< zeros, then the number
};

/// The data of one source for a sweep, with the fields of List.
template <int dim, class List, class Real, int width>
struct SourceData {
    Columns<dim, List, Real> columns;
    const search::RunList* runs;
    const search::RunList* stencils; ///< of reference neighbours; null for present ones
    double support;
    std::array<Vector<Real, dim>, static_cast<std::size_t>(search::image_count<dim>)> images;
    LeastDistances<Real, width> least_distances;

    /// Has any of particles [from, to) of one pack a run?
    bool any_near(int from, int to) const { return (*runs)[from].begin() != (*runs)[to - 1].end(); }
    /// Of the pack of particles pack * width, pack * width + 1, ...
    search::RunList::Range stencil_of(int pack) const {
        return stencils != nullptr ? (*stencils)[pack] : search::RunList::Range{nullptr, nullptr};
    }
};

/// The contribution of a single node for one run of neighbours.
template <class N, class ListB, class Own, int dim, class Real, int width, class Part, class Adds>
IMBIBE_INLINE void add_run(const Part& part, Sums<Adds, dim, Pack<Real, width>>& sums, const Own& a,
                           const SourceData<dim, ListB, Real, width>& source, const typename N::B& material_b,
                           const Pair<dim, Pack<Real, width>>& ab, std::size_t first, const Vector<Real, dim>& image) {
    const NeighbourView<typename N::B, ListB, dim, Real, width> b{source.columns, first, material_b, ab.gravity_now,
                                                                  image};
    add_all<dim, Pack<Real, width>, Adds, N>(sums, part(a, b, ab),
                                             std::make_index_sequence<static_cast<std::size_t>(N::Adds::size)>{});
}

/// A node's result for a pair: a value for each field it adds to.
template <class N, class R>
struct Gives {
    /// Is its result for F along the line of centres?
    template <class F>
    static constexpr bool along_centres() {
        if constexpr (is_tuple<R>)
            return []<class... V, class... G>(std::type_identity<std::tuple<V...>>, TypeList<G...>) {
                return ((std::is_same_v<F, G> && is_central<V>) || ...);
            }(std::type_identity<R>{}, typename N::Adds{});
        else
            return std::is_same_v<F, At<0, typename N::Adds>> && is_central<R>;
    }
};

template <class... Given, int dim, class T, class... F>
IMBIBE_INLINE void multiply_out(Sums<TypeList<F...>, dim, T>& sums, const Vector<T, dim>& offset) {
    using List = TypeList<F...>;
    const auto one = [&]<class G>(std::type_identity<G>) {
        if constexpr ((Given::template along_centres<G>() || ...))
            for (int k = 0; k < dim; ++k)
                sums.total[component_offset<dim, G, List> + k] += sums.central[index_of<G, List>] * offset[k];
    };
    (one(std::type_identity<F>{}), ...);
}

/// Adds the contributions of the neighbours of particle i from one source to `sums`, run by run and node by node.
/// @tparam S the source, with the fields ListB, @tparam A the particle's phase, with the fields ListA
template <class S, class ListB, class A, class ListA, class... N, class Adds, class Own, int dim, class Real, int width,
          class PartTuple, std::size_t... k>
IMBIBE_INLINE void gather(TypeList<N...>, std::index_sequence<k...>, Sums<Adds, dim, Pack<Real, width>>& sums,
                          const PhaseStore<dim, Real>& state, [[maybe_unused]] const Seen<dim, Real>& seen,
                          const Own& a, const SourceData<dim, ListB, Real, width>& source, const SupportRadius& support,
                          const typename S::B& material_b, int i, const search::RunList::Range& own_runs,
                          const PartTuple& parts) {
    using T = Pack<Real, width>;
    using B [[maybe_unused]] = NeighbourView<typename S::B, ListB, dim, Real, width>;
    using Place = std::conditional_t<S::reference, ReferencePosition, Position>;
    constexpr int place_a = component_offset<dim, Place, ListA>, place_b = component_offset<dim, Place, ListB>;
    Pair<dim, T> ab;
    ab.set(support);
    ab.gravity_now = a.gravity_now;
    // A particle is its own neighbour. With this assumption the compiler computes loop invariants once, before the loop
    // over particles; otherwise it does so for each particle, after checking whether there is any neighbour.
    if constexpr (std::is_same_v<A, typename S::B> && !S::reference)
        IMBIBE_ASSUME(!own_runs.is_empty());
    else if (own_runs.is_empty())
        return;
    own_runs.for_each_image([&](const search::Run* run, const search::Run* end, int through) IMBIBE_INLINE_LAMBDA {
        // Such a phase is not wrapped, but its runs were found as if it were.
        constexpr bool seen_elsewhere = contains<ReferencePosition, ListA> && !S::reference;
        std::conditional_t<seen_elsewhere, Vector<Real, dim>, const Vector<Real, dim>&> image =
            source.images[static_cast<std::size_t>(through)];
        Vector<T, dim> place; // of the particle, as seen through the image
        for (int d = 0; d < dim; ++d) {
            const Real x = state.column(place_a + d)[i];
            if constexpr (seen_elsewhere) {
                const Real at = seen.place(d, i, x);
                place[d] = T(at - image[d]);
                image[d] += x - at; // so that positions differ by the offset
            } else {
                place[d] = T(x - image[d]);
            }
        }
        do {
            const std::size_t first = run->first();
            for (int d = 0; d < dim; ++d)
                ab.offset[d] = place[d] - T::load(source.columns[static_cast<std::size_t>(place_b + d)] + first);
            T distance2 = squared_norm(ab.offset);
            if constexpr (width > 1)
                distance2 = max(distance2, source.least_distances.squared(run->count()));
            ab.distance = sqrt(distance2);
            for (T& c : sums.central)
                c = T(0);
            (add_run<N, ListB>(std::get<k>(parts), sums, a, source, material_b, ab, first, image), ...);
            multiply_out<Gives<N, decltype(std::get<k>(parts)(a, std::declval<const B&>(), ab))>...>(sums, ab.offset);
        } while (++run != end);
    });
}

/// The same for as many particles from i on as a pack has lanes, each in one, by their stencil: `a` has the fields of
/// all of them. Nothing for present neighbours.
template <class S, class ListB, class ListA, class... N, class Adds, class Own, int dim, class Real, int width,
          class PartTuple, std::size_t... k>
IMBIBE_INLINE void gather_pack(TypeList<N...>, std::index_sequence<k...>, Sums<Adds, dim, Pack<Real, width>>& sums,
                               const PhaseStore<dim, Real>& state, const Own& a,
                               const SourceData<dim, ListB, Real, width>& source, const SupportRadius& support,
                               const typename S::B& material_b, int i, const PartTuple& parts) {
    if constexpr (S::reference) {
        using T = Pack<Real, width>;
        using B [[maybe_unused]] = NeighbourView<typename S::B, ListB, dim, Real, width>;
        constexpr int place_a = component_offset<dim, ReferencePosition, ListA>,
                      place_b = component_offset<dim, ReferencePosition, ListB>;
        Pair<dim, T> ab;
        ab.set(support);
        ab.gravity_now = a.gravity_now;
        const auto add_runs = [&](const search::Run* run, const search::Run* end, int through) IMBIBE_INLINE_LAMBDA {
            const Vector<Real, dim>& image = source.images[static_cast<std::size_t>(through)];
            Vector<T, dim> place; // of the particles, as seen through the image
            for (int d = 0; d < dim; ++d)
                place[d] = T::load(state.column(place_a + d) + i) - T(image[d]);
            do {
                const std::size_t first = run->first();
                for (int d = 0; d < dim; ++d)
                    ab.offset[d] = place[d] - T::load(source.columns[static_cast<std::size_t>(place_b + d)] + first);
                ab.distance = sqrt(squared_norm(ab.offset));
                for (T& c : sums.central)
                    c = T(0);
                (add_run<N, ListB>(std::get<k>(parts), sums, a, source, material_b, ab, first, image), ...);
                multiply_out<Gives<N, decltype(std::get<k>(parts)(a, std::declval<const B&>(), ab))>...>(sums,
                                                                                                         ab.offset);
            } while (++run != end);
        };
        source.stencil_of(i / width).for_each_image(add_runs);
    }
}

} // namespace imbibe::detail
