// The Young's modulus that corrects the bending stiffness of a plate of a few layers of particles.
#pragma once

#include <imbibe/core/error.hpp>

#include <cmath>

namespace imbibe {

/// E/(1 - 1/n^2), Pa: the Young's modulus for a plate n layers of particles thick, with which it bends like one of
/// Young's modulus E.
///
/// The energy of bending is summed over the layers, sum_k y_k^2 dy, which is H^3/12 (1 - 1/n^2): the variation of the
/// strain within a particle is missing. So a plate of 3, 5, 10 layers is too soft in bending by 11, 4 and 1 %.
/// docs/validation.md has the sag of the beam of Turek and Hron with and without it.
///
/// Not for bodies that are stretched or compressed more than bent: they come out too stiff by as much. It does not
/// correct the softening by a support of more than 1.5 spacings (solid/total_lagrangian.hpp).
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
