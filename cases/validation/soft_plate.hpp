// Half a metre of water on a soft plate that is clamped at both ends: how far its middle hangs down.
//
// Reference: two-dimensional elasticity by finite elements, 2.10e-3 m, give or take 4 %. After Fourey et al. (2017),
// with a softer plate and less water.
// Geometry: 1 m wide, the plate 0.05 m thick; the water's spacing is twice the plate's.
// Scheme: that of the comparison of couplings (cases/couplings/plate.hpp), with a support of 2.6 spacings in the
// water and 1.5 in the plate, whose modulus is that of `bending_modulus`.
// Measure: the sag after 0.16 s, damped, under the water and under the same weight without it.
#pragma once

#include "case.hpp"

#include "../couplings/plate.hpp"

#include <imbibe/solid/bending_modulus.hpp>

namespace validation::soft_plate {

namespace plate = couplings::plate;

inline std::vector<Measured> measure(int across) {
    const double reference = 2.10e-3, spacing = plate::thickness / across;
    const double modulus = imbibe::bending_modulus(plate::young_modulus, across);
    std::vector<Measured> found{{"sag without water, m", "4 %", plate::dry_sag(spacing, modulus), reference}};
    const auto add = [&]<class Kit>(Kit) {
        const auto seen = plate::wet_sag<Kit>({2 * spacing, 2.6, 0.4}, modulus);
        imbibe::require(seen.failure.empty(), seen.failure);
        found.push_back({imbibe::text("sag under water, ", Kit::name, ", m"), "4 %", seen.curve.back(), reference});
    };
    add(couplings::Extrapolated{});
    add(couplings::Riemann{});
    add(couplings::AlongNormals{});
    return found;
}

} // namespace validation::soft_plate
