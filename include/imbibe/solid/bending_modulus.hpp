// The Young's modulus with which a plate of a few layers of particles bends as it should.
#pragma once

#include <imbibe/core/error.hpp>

#include <cmath>

namespace imbibe {

/// E/(1 - 1/n^2), Pa: the Young's modulus to give a plate that is n layers of particles thick, so that it bends as one
/// of Young's modulus E.
///
/// The energy of bending is summed over the layers, sum_k y_k^2 dy, which is H^3/12 (1 - 1/n^2): no particle knows how
/// the strain changes within it. So a plate of 3, 5, 10 layers is too soft in bending by 11, 4 and 1 %. How far the beam
/// of Turek and Hron hangs with and without is in docs/validation.md.
///
/// Not for what is stretched or compressed more than bent: that comes out too stiff by as much. It does not make up for
/// what a support of more than 1.5 spacings softens (solid/total_lagrangian.hpp).
///
/// Source: own; the second moment of n layers against that of the plate.
///
/// Throws Error for fewer than two layers, which do not bend at all, and unless E is a finite number above 0 Pa.
inline double bending_modulus(double young_modulus, int layers) {
    require(std::isfinite(young_modulus) && young_modulus > 0, "bending_modulus: Young's modulus = ", young_modulus,
            " Pa; it must be a finite number above 0 Pa");
    require(layers >= 2, "bending_modulus: a plate of ", layers, " layers of particles has no stiffness in bending; ",
            "give it at least 2, better 4");
    return young_modulus / (1 - 1.0 / (static_cast<double>(layers) * layers));
}

} // namespace imbibe
