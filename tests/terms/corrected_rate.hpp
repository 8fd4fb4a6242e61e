// What CorrectedContinuity gives a particle: its sum and what it makes of it.
#pragma once

#include "cloud.hpp"

#include <imbibe/fluid/corrected_gradients.hpp>

namespace cloud {

/// drho/dt of a particle among others, kg/m^3/s.
template <class K, class A, class Sources>
double corrected_rate(A a, const Sources& sources) {
    a.set(raw_strain_rate, sum(typename CorrectedContinuity<K>::Sum{}, a, sources));
    return plain(typename CorrectedContinuity<K>::Rate{}(a));
}

} // namespace cloud
