// What a Guard checks, with which bounds, and what it throws.
#pragma once

#include <imbibe/core/error.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// What a guard found.
enum class Cause {
    not_finite,    ///< a field that is given or integrated, such as a position, is not a finite number
    too_fast,      ///< a particle is faster than the bound, in sound speeds
    wrong_density, ///< a density is out of bounds
    left_domain,   ///< a particle is outside the domain
    inside_wall,   ///< a particle is inside a wall, on its way through
    narrow_pore,   ///< a pore has fewer particles across than asked for
    energy,        ///< energy has grown without a source
    met            ///< phases, or bodies of one, have met although nothing acts between them (`Solver::meetings`)
};

/// Thrown by a Guard: what, where, when. The message is a sentence with the likely reason and a remedy.
class Diverged : public Error {
public:
    /// The message, and the values of the members.
    Diverged(const std::string& message, Cause what, std::string in_phase, std::vector<double> where, double when,
             long long step)
        : Error(message), cause(what), phase(std::move(in_phase)), position(std::move(where)), time(when), steps(step) {
    }
    Cause cause;                  ///< what was found
    std::string phase;            ///< empty for the whole scene
    std::vector<double> position; ///< of the particle, or of the middle of the pore, m; empty if there is none
    double time;                  ///< s
    long long steps;              ///< taken until then
};

/// The bounds that a Guard keeps a scene in.
template <int dim>
struct GuardSettings {
    /// Steps between two checks of all particles. In between only the greatest speeds are checked.
    int interval = 10;
    /// The greatest speed, in sound speeds of the phase. A weakly compressible scene is wrong well before 1.
    double speed = 1;
    /// Bounds of the density, as shares of that at rest.
    double least_density = 0.5, greatest_density = 1.5;
    /// The domain, m: a particle outside ends the run, except those of walls, which may reach out of it. A domain one
    /// spacing larger than the inside of the tank detects leaks. Periodic sides are not checked, because they have no
    /// outside.
    std::array<double, static_cast<std::size_t>(dim)> lower = filled(-std::numeric_limits<double>::infinity()),
                                                      /// The upper corner of the domain, m.
        upper = filled(std::numeric_limits<double>::infinity());
    /// The largest share of a particle's surroundings that particles of one wall may fill (0: none; 1: all), over the
    /// support radius. The share is a half at a wall's face, seven eighths in a corner of three walls, 0.97 and more in
    /// the middle of three layers. Checked where that support is at least 2 spacings of the wall, and no particle was
    /// removed since the last search. Walls of one or two layers may never fill so much: there the domain must detect
    /// the particle.
    double inside_wall = dim == 2 ? 0.92 : 0.96;
    /// How much kinetic and potential energy may appear, as a share of the scene's energy turnover: its kinetic energy,
    /// or the released potential energy if that is more, plus what lifts everything by a hundredth of a spacing. Energy
    /// that stress and pressure have released since the guard's first check (`stored_energy`) and possible rounding of
    /// positions do not count.
    /// Infinite: not checked; for scenes that the program drives by velocities that it sets, or whose solids are added
    /// under stress. Also not checked while a wall or held particles (`Solver::hold`) move or gravity changes, nor
    /// where gravity has a component along a periodic side: the flow then gains energy in every period, and there is no
    /// potential energy.
    double energy = 0.2;
    /// The fewest particles of a fluid that must fit across the pores of a solid or wall that it is coupled to, in the
    /// present positions: below 2 only single particles pass, whatever the physics. 0: not checked, as where pores may
    /// close. A thousandth less still counts. A pore that has closed to 0.4 spacings of its body between two checks is
    /// no longer seen as one, and particles that lie off their lattice by more than a tenth of a spacing may be taken
    /// for pores. See narrowest_passage().
    double least_pore = 0;
    /// Steps between two checks of the pores, which change slowly and cost two searches.
    int pore_interval = 200;

    /// Throws Error for a number out of range.
    void check() const {
        require(interval >= 1, "Guard: interval = ", interval, " steps; it must be at least 1");
        require(speed > 0, "Guard: speed = ", speed, " sound speeds; it must be above 0");
        require(least_density < 1 && greatest_density > 1, "Guard: the bounds of the density are ", least_density,
                " and ", greatest_density, " of that at rest; the first must be below 1, the second above");
        for (std::size_t d = 0; d < dim; ++d)
            require(lower[d] < upper[d], "Guard: the domain ends at ", upper[d], " m where it begins at ", lower[d],
                    " m");
        require(inside_wall > 0, "Guard: inside_wall = ", inside_wall,
                " (a share); it must be above 0, usually 0.92 in 2D and 0.96 in 3D");
        require(energy > 0, "Guard: energy = ", energy, " (a share); it must be above 0");
        require(least_pore >= 0 && std::isfinite(least_pore), "Guard: least_pore = ", least_pore,
                " particles; it must be 0 (not looked at) or a finite number above, usually 2");
        require(pore_interval >= 1, "Guard: pore_interval = ", pore_interval, " steps; it must be at least 1");
    }

private:
    static constexpr std::array<double, static_cast<std::size_t>(dim)> filled(double x) {
        std::array<double, static_cast<std::size_t>(dim)> all{};
        all.fill(x);
        return all;
    }
};

} // namespace imbibe
