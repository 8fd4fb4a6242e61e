// The numbers of a scene that belong to no phase: gravity, time step, periodic sides, threads.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/parallel.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>

namespace imbibe {

/// Prints "Warning: <sentence>" to the standard error stream.
inline void print_warning(const std::string& sentence) {
    std::fprintf(stderr, "Warning: %s\n", sentence.c_str());
}

/// The numbers of a scene that belong to no phase.
template <int dim>
struct Settings {
    /// Acceleration that acts on every particle that moves, m/s^2.
    std::array<double, static_cast<std::size_t>(dim)> gravity{};
    /// Support radius H of all phases that do not set their own, m.
    double support_radius = 0;
    /// Courant-Friedrichs-Lewy number: the fraction of the longest stable step that is used.
    double cfl = 0.75;
    /// A fixed time step, s; 0: adaptive, the least of all limits times `cfl`.
    double time_step = 0;
    /// The longest step an adaptive run takes, s.
    double max_time_step = 1e-2;
    /// Lower end and length of the periodic sides, m; a length of 0: not periodic.
    std::array<double, static_cast<std::size_t>(dim)> periodic_lower{}, periodic_length{};
    /// The point relative to which positions are stored, m. In float, a coordinate of 10,000 spacings has lost so many
    /// digits that forces are wrong by 2e-3 (double: no error); with an origin near the particles the loss disappears.
    /// Points that are added and predicates on points are in world coordinates; the views `scene[phase]` and snapshots
    /// are relative to the origin.
    std::array<double, static_cast<std::size_t>(dim)> origin{};
    /// Number of steps after which particles are sorted and neighbours found again. Above 1, the steps in between reuse
    /// the neighbour lists, as the inner steps of dual time stepping do (Zhang, Rezavand and Hu 2020), unless a
    /// particle may have travelled more than 5 % of a support radius. Pairs that come within reach in between are
    /// missed: at 0.95 H and more the gradient of WendlandC2 is below 0.2 % of its greatest value, at 0.9 H (both have
    /// come 5 % nearer) it is 0.9 %. Positions may leave a periodic box by that much, too. See `search_skin`. The
    /// motion of walls that a program moves is noticed; of phases that move by themselves only velocities are checked,
    /// so a program that writes their positions must use 1.
    int search_interval = 1;
    /// Skin of neighbour lists that serve several steps, as a share of the support radius: neighbours are searched this
    /// much further, and the lists serve until a particle may have travelled half of that, so no pair is missed (Verlet
    /// 1967). 0: the 5 % of `search_interval`. It also serves the short steps of DualStepping. A wide skin makes
    /// searches rare and sums long; 0.1 is a good choice where a particle moves little in a step.
    double search_skin = 0;
    /// Threads, at most 1024; 0: all of the machine.
    int threads = 0;
    /// Is called with each warning (`Solver::warnings`) as it comes: something that deserves a look but is no error. A
    /// program may put its own function here, such as a log; an empty function prints nothing.
    std::function<void(const std::string&)> on_warning = print_warning;

    /// Throws Error for a number that is not finite or out of range.
    void check() const {
        require(threads >= 0 && threads <= most_threads, "threads = ", threads, "; it must be from 1 to ", most_threads,
                ", or 0 for all of the machine");
        for (double g : gravity)
            require(std::isfinite(g), "gravity has a component ", g, " m/s^2; all must be finite");
        require(std::isfinite(support_radius) && support_radius > 0, "support_radius = ", support_radius,
                " m; it must be above 0 m, usually 2 to 3 particle spacings");
        require(cfl > 0 && cfl <= 2, "cfl = ", cfl, "; it must be above 0 and not above 2, usually 0.75");
        require(std::isfinite(time_step) && time_step >= 0, "time_step = ", time_step,
                " s; it must not be negative (0 means adaptive)");
        require(max_time_step > 0, "max_time_step = ", max_time_step, " s; it must be above 0 s");
        require(search_interval >= 1, "search_interval = ", search_interval,
                "; it must be at least 1 (a search in every step)");
        require(search_skin >= 0 && search_skin <= 0.5, "search_skin = ", search_skin,
                " support radii; it must be from 0 (none) to 0.5, usually 0.1");
        for (double lower : periodic_lower)
            require(std::isfinite(lower), "a periodic_lower of ", lower, " m; it must be a finite number");
        for (double coordinate : origin)
            require(std::isfinite(coordinate), "an origin with a coordinate of ", coordinate,
                    " m; all must be finite numbers");
        for (double length : periodic_length)
            require(std::isfinite(length) && (length == 0 || length >= (1 + search_skin) * support_radius),
                    "a periodic length of ", length, " m; it must be 0 (not periodic) or at least the support radius, ",
                    (1 + search_skin) * support_radius, " m with its skin");
    }
};

} // namespace imbibe
