// What terms reduce over the particles of a phase: sums, greatest and least values, by threads and in a fixed order.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/phase_store.hpp>
#include <imbibe/solver/sweep.hpp>

#include <span>
#include <type_traits>

namespace imbibe {

struct let_another_term_of_the_phase_set_it;
namespace rules {
/// Rule: a reduction reads fields that its phase stores.
template <class Field, class Part, class Phase, class Advice>
struct ReducesWhatIsNotStored {
    static_assert(sizeof(Field) == 0, "imbibe: a reduction reads a field that its phase does not store");
};
} // namespace rules

namespace detail {

/// A particle as a reduction sees it: its fields in double, and its material.
/// @tparam P its phase, @tparam List the fields of that
template <class Part, class P, class List, int dim, class Real>
struct ReducedParticle {
    using Material = P;
    using Scalar = double;
    static constexpr int dimension = dim;
    const PhaseStore<dim, Real>& phase;
    int i;
    const P& material;

    template <class F>
    auto operator[](F) const {
        Value<F, dim, double> value{};
        if constexpr (!contains<F, typename ReadsOf<Part>::type>)
            break_rule<rules::ReadsWhatItDoesNotDeclare<F, Part>>();
        else if constexpr (!contains<F, List>)
            break_rule<rules::ReducesWhatIsNotStored<F, Part, P, let_another_term_of_the_phase_set_it>>();
        else
            for (int k = 0; k < components(F::rank, dim); ++k)
                component(value, k) = static_cast<double>(phase.column(component_offset<dim, F, List> + k)[i]);
        return value;
    }
};

/// Node N, a reduction, of particles [begin, end). @tparam List the fields of its phase
template <class N, class List, int dim, class Real>
double reduce_block(const PhaseStore<dim, Real>& phase, int begin, int end) {
    using P = typename N::A;
    using Part = typename N::Part;
    const P& material = *std::any_cast<P>(&phase.material);
    const auto part = make_part<N>(material);
    double all = Part::reduces::of_none;
    for (int i = begin; i < end; ++i)
        all = Part::reduces::both(all, part(ReducedParticle<Part, P, List, dim, Real>{phase, i, material}));
    return all;
}
template <class N, class List, int dim, class Real>
constexpr Reduction<dim, Real> reduction_of(int phase) {
    using Reduces = typename N::Part::reduces;
    return {.phase = phase,
            .quantity = Reduces::Quantity::name,
            .unit = Reduces::Quantity::unit,
            .of_none = Reduces::of_none,
            .both = &Reduces::both,
            .body = &reduce_block<N, List, dim, Real>};
}

/// The result for all particles of the phase: the same bits for any number of threads.
template <int dim, class Real>
double reduced(const PhaseStore<dim, Real>& phase, const Reduction<dim, Real>& row, int threads);

/// The result of one part for all particles of a view.
template <class Part, class View>
double reduced_by(const View& view) {
    using P = std::remove_cvref_t<decltype(view.material())>;
    using State = std::remove_cvref_t<decltype(view.state)>;
    using Store = std::remove_cvref_t<decltype(view.state.store)>;
    constexpr int dim = Store::dimension;
    using Real = typename Store::Number;
    return reduced<dim, Real>(view.state.store,
                              reduction_of<Node<Part, P, P, P, void>, typename State::Fields, dim, Real>(0), 1);
}

} // namespace detail

/// The combined result of a phase's reductions `Reduces`, such as Sum<StoredEnergy>:
/// `reduced<sph::Sum<Heat>>(scene[bar])`. @param view a phase of a scene
template <class Reduces, class View>
double reduced(const View& view) {
    using P = std::remove_cvref_t<decltype(view.material())>;
    double all = Reduces::of_none;
    const auto take = [&]<class N>(std::type_identity<N>) {
        if constexpr (std::is_same_v<typename N::Part::reduces, Reduces>)
            all = Reduces::both(all, detail::reduced_by<typename N::Part>(view));
    };
    [&]<class... N>(TypeList<N...>) {
        (take(std::type_identity<N>{}), ...);
    }(typename detail::ReductionsOfPhase<P, typename P::terms>::type{});
    return all;
}

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/reductions_code.hpp>
#endif
