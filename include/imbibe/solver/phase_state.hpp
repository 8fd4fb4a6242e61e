// The particles of one phase as a program sees them: the columns of its store, by the names of its fields.
#pragma once

#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/phase_store.hpp>
#include <imbibe/solver/rules.hpp>

#include <Eigen/Core>

#include <any>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// The values of one field of all particles: n rows, one column per component. Their order in memory is set here
/// explicitly, because a host may have changed Eigen's default (EIGEN_DEFAULT_TO_ROW_MAJOR).
template <class Real, int columns>
using FieldValues = Eigen::Matrix<Real, Eigen::Dynamic, columns, Eigen::ColMajor>;

/// Eigen's view of one field of all particles, no copy.
/// @tparam Numbers FieldValues or const FieldValues
template <class Numbers>
using FieldView = Eigen::Map<Numbers, 0, Eigen::OuterStride<>>;

/// A view of a phase. It holds no numbers and is valid as long as the scene.
/// @tparam List the fields of the phase, @tparam Store a PhaseStore, or a const one: then nothing can be changed
template <class P, class List, class Store>
class PhaseState {
    template <class T>
    using Seen = std::conditional_t<std::is_const_v<Store>, const T, T>;

public:
    static constexpr int dimension = Store::dimension, component_total = component_count<dimension, List>;
    using Fields = List;
    using Number = Seen<typename Store::Number>;
    template <class F>
    static constexpr int offset = component_offset<dimension, F, List>;
    template <class F>
    static constexpr bool stores = contains<F, List>;
    static constexpr bool keeps_reference = stores<ReferencePosition>;

    Store& store;
    Seen<P>& material;
    const std::vector<std::uint32_t>& ids; ///< the number of each particle in the order in which they were added

    explicit PhaseState(Store& of) : store(of), material(*std::any_cast<P>(&of.material)), ids(of.ids) {}

    int size() const { return store.size(); }
    std::size_t stride() const { return store.stride(); }
    /// Component k of the phase's fields, for all particles.
    Number* column(int k) const {
        if constexpr (!std::is_const_v<Store>)
            store.note_all_written(); // by the caller, possibly
        return store.column(k);
    }
    template <class F>
    Number* field(F) const {
        return column(offset<F>);
    }
    template <class F>
    auto view(F) const {
        if constexpr (!stores<F>)
            break_rule<rules::FieldNotStored<F, P, list_a_term_that_uses_it_or_look_at_another>>();
        constexpr int columns = components(F::rank, dimension);
        using Values = Seen<FieldValues<typename Store::Number, columns>>;
        return FieldView<Values>(field(F{}), size(), columns,
                                 Eigen::OuterStride<>(static_cast<Eigen::Index>(stride())));
    }
    auto points() const { return points_of(position); }
    template <class F>
    auto points_of(F) const {
        return std::as_const(store).points_of(offset<F>);
    }
};

} // namespace imbibe::detail
