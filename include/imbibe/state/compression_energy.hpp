// What a fluid or a solid with an equation of state stores by its density.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// m c^2 (rho/rho_0 - 1)^2/2 of a particle, J: what the linear equation of state stores, and any other near rho_0.
struct CompressionEnergy {
    using reads = Fields<mass, density>;
    using reduces = Sum<StoredEnergy>;

    double operator()(const auto& a) const {
        return 0.5 * a[mass] * sq(a.material.sound_speed * (a[density] / a.material.density - 1));
    }
};

} // namespace imbibe
