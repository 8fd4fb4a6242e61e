// What a reference case is: a scene as a function of its resolution, which gives numbers beside their references.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace validation {

/// A number that a case has computed, beside the reference.
struct Measured {
    std::string what; ///< with its unit
    std::string good; ///< the error that counts as good, and where
    double computed;  ///< by this run
    double reference; ///< from outside

    /// As a share of the reference; positive where the number is too large, without its sign.
    double error() const { return computed / reference - 1; }
};

/// One reference case.
struct Case {
    std::string name;             ///< on the command line
    std::string counts;           ///< what its resolution counts
    std::vector<int> resolutions; ///< at which it is run, coarse to fine
    std::vector<Measured> (*run)(int resolution);
};

/// The order at which the error falls from a resolution to a finer one: log(e1/e2)/log(n2/n1).
inline double observed_order(double coarse_error, int coarse, double fine_error, int fine) {
    return std::log(std::abs(coarse_error / fine_error)) / std::log(static_cast<double>(fine) / coarse);
}

} // namespace validation
