// The terms of a fluid that is immiscible with another one: interface tension, and the wetting of solids.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/interface/interface_tension.hpp>

#include <type_traits>

namespace imbibe {

/// The tension of the interface with another fluid that lists it too, beside a method of their flow:
/// `struct Oil : Fluid<UnderPressure<>, CorrectedGradients<K>, Instead<DensityFloor>, MorrisViscosity<K>,
/// CapillaryFluid<K>> {};`, `Water` the same, and `struct Between : CouplingOf<Oil, Water, MorrisViscosity<K>> {};`
/// with the coefficients InterfaceTensionParameters. `presets::TwoLiquids` has all of it.
///
/// In couplings with walls and solids, which bear the pull, ContactAngleParameters set the contact angle of the
/// interface.
template <class Kernel = WendlandC2>
struct CapillaryFluid : Method<InterfaceForce<Kernel>> {
    /// The terms between such a fluid and another one, and between it and a wall or solid.
    template <class Liquid, class Other>
    using coupling =
        std::conditional_t<detail::is_fluid<Other>, TypeList<InterfaceTension<Kernel>, InterfaceForce<Kernel>>,
                           TypeList<Into<Liquid, ContactAngle<Kernel>>, ContactLineForce<Kernel>>>;
};

} // namespace imbibe
