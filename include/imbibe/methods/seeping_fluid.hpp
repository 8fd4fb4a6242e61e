// A fluid that flows in and out of skeletons with unresolved pores.
#pragma once

#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/mixture/darcy_drag.hpp>
#include <imbibe/mixture/in_pores.hpp>
#include <imbibe/mixture/pore_pressure.hpp>
#include <imbibe/mixture/pore_space.hpp>

#include <type_traits>

namespace imbibe {

namespace detail {
// Has a phase a law of stress that is a PorousSkeleton?
template <class... T>
constexpr bool has_pores(TypeList<T...>) {
    [[maybe_unused]] const auto is = []<class Term>(std::type_identity<Term>) {
        return requires {
            requires Term::porous;
        };
    };
    return (is(std::type_identity<T>{}) || ...);
}
} // namespace detail

/// A weakly compressible fluid with a free surface, as WeaklyCompressible, that flows in the pores of skeletons too.
/// Listed beside it: the state InPores and a viscosity, which the drag in the pores needs as well,
/// `Fluid<InPores<>, SeepingFluid<K>, MorrisViscosity<K>>`.
///
/// Between it and a solid with PorousSkeleton act PoreSpace, PorePressure, PoreContents and DarcyDrag: `struct Soaking
/// : CouplingOf<Water, Sponge> {};`. Between it and walls or other solids act the same terms as with
/// WeaklyCompressible.
template <class Kernel = WendlandC2>
struct SeepingFluid
    : Method<VolumeContinuity<Kernel>, PoreDensityDiffusion<Kernel>, PoreDensityFloor, VolumePressure<Kernel>> {
    /// The terms between such a fluid and a wall or solid.
    template <class Liquid, class Other>
    using coupling = std::conditional_t<detail::has_pores(typename Other::terms{}),
                                        TypeList<Into<Liquid, PoreSpace<Kernel>>, Into<Other, PoreContents<Kernel>>,
                                                 PorePressure<Kernel>, DarcyDrag<Kernel>>,
                                        typename WeaklyCompressible<Kernel>::template coupling<Liquid, Other>>;
};

} // namespace imbibe
