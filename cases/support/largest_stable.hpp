// How far a number can be taken before a run goes wrong: a bisection of what a caller calls stable.
#pragma once

#include <algorithm>
#include <cmath>

namespace imbibe::bench {

/// The largest value that is stable, of those between `low` and `high`, to 4 %: at first steps of a factor sqrt(2) from
/// `start` until the verdict changes, then halves. 0 if not even `low` is stable, `high` if that is.
/// Of the values that it tries each stable one is greater than those before, and each other one less.
template <class IsStable>
double largest_stable(double low, double start, double high, const IsStable& is_stable) {
    double good = 0, bad = 0, at = start;
    const double factor = std::sqrt(2.0);
    if (is_stable(at)) {
        for (good = at; bad == 0; good = bad == 0 ? at : good) {
            if (good >= high * (1 - 1e-9))
                return high;
            at = std::min(good * factor, high);
            if (!is_stable(at))
                bad = at;
        }
    } else {
        for (bad = at; good == 0; bad = good == 0 ? at : bad) {
            if (bad <= low * (1 + 1e-9))
                return 0;
            at = std::max(bad / factor, low);
            if (is_stable(at))
                good = at;
        }
    }
    while (bad / good > 1.04) {
        const double middle = std::sqrt(good * bad);
        (is_stable(middle) ? good : bad) = middle;
    }
    return good;
}

} // namespace imbibe::bench
