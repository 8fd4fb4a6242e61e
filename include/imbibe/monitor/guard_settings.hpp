// What a Guard looks for, in which bounds, and what it throws.
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
    too_fast,      ///< a particle is faster than sound
    wrong_density, ///< a density is out of bounds
    left_domain,   ///< a particle is outside the domain
    inside_wall,   ///< a particle is among those of a wall, on its way through
    narrow_pore,   ///< a pore has fewer particles across than asked for
    energy,        ///< energy has come from nowhere
    met            ///< phases, or bodies of one, have met though nothing acts between them (`Solver::meetings`)
};

/// Thrown by a Guard: what, where, when. The message says it in a sentence, with the likely reason and a remedy.
class Diverged : public Error {
public:
    /// The sentence, and what its members are to hold.
    Diverged(const std::string& message, Cause what, std::string in_phase, std::vector<double> where, double when,
             long long step)
        : Error(message), cause(what), phase(std::move(in_phase)), position(std::move(where)), time(when), steps(step) {
    }
    Cause cause;                  ///< what was found
    std::string phase;            ///< empty where the whole scene is meant
    std::vector<double> position; ///< of the particle, or of the middle of the pore, m; empty where neither is meant
    double time;                  ///< s
    long long steps;              ///< taken until then
};

/// The bounds that a Guard keeps a scene in.
template <int dim>
struct GuardSettings {
    /// Steps between two looks at all particles. Between them only the greatest speeds are looked at.
    int interval = 10;
    /// The greatest speed, in sound speeds of the phase. A weakly compressible scene is wrong well before 1.
    double speed = 1;
    /// Bounds of the density, as shares of that at rest.
    double least_density = 0.5, greatest_density = 1.5;
    /// The domain, m: a particle outside ends the run, but those of walls, which may reach out of it. As wide as the
    /// inside of the tank and a spacing more, it notices leaks. Not looked at along periodic sides, where there is no
    /// outside.
    std::array<double, static_cast<std::size_t>(dim)> lower = filled(-std::numeric_limits<double>::infinity()),
                                                      /// The upper corner of the domain, m.
        upper = filled(std::numeric_limits<double>::infinity());
    /// How much of a particle's surroundings particles of one wall may fill (0: none; 1: all), over the support radius.
    /// At a wall's face it is a half, in a corner of three walls seven eighths, in the middle of three layers 0.97 and
    /// more. Looked at where that support is at least 2 spacings of the wall, and no particle was removed since the
    /// last search. Walls of one or two layers may never fill so much: there the domain has to notice.
    double inside_wall = dim == 2 ? 0.92 : 0.96;
    /// How much kinetic and potential energy may appear, as a share of what the scene turns over (its kinetic energy,
    /// or the potential energy that has been released, whichever is more, and what lifts everything by a hundredth of a
    /// spacing), and beside what stress and pressure have released since the guard's first look (`stored_energy`) and
    /// what rounding of positions may have put in.
    /// Infinite: not looked at, as for scenes that the program drives by velocities that it sets, or whose solids are
    /// added under stress. Not looked at either while a wall moves, or particles that are held (`Solver::hold`), or
    /// gravity changes, nor where gravity has a component along a periodic side: it drives the flow round and round,
    /// and there is no potential energy.
    double energy = 0.2;
    /// The fewest particles of a fluid that are to fit across the pores of a solid or wall that it is coupled to, as
    /// they lie now: below 2 no more than single ones pass, whatever the physics says. 0: not looked at, as where pores
    /// are meant to be closed. A thousandth less is taken for as many. A pore that has closed to 0.4 spacings of its body
    /// between two looks is no longer seen as one, and particles that lie off their lattice by more than a tenth of a
    /// spacing may be taken for pores. See narrowest_passage().
    double least_pore = 0;
    /// Steps between two looks at the pores, which change slowly and take two searches.
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
