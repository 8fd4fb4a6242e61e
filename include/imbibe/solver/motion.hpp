// How particles move: velocities from accelerations, positions from velocities, and the resulting speeds.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/closed_fluid.hpp>
#include <imbibe/solver/neighbourhood.hpp>

namespace imbibe::detail {

/// Computes SupportedShare in one step.
template <int dim, class Real>
class Support {
public:
    Support() = default;
    /// @param g of the scene, m/s^2
    /// @param sound how far sound travels in the step, in support radii
    Support(const Vector<double, dim>& g, double sound)
        : follow(static_cast<Real>(std::clamp(sound / supports, 0.0, 1.0))) {
        const double g2 = squared_norm(g);
        for (int d = 0; d < dim; ++d) {
            gravity[d] = static_cast<Real>(g[d]);
            per_weight[d] = g2 > 0 ? static_cast<Real>(g[d] / g2) : Real(0);
        }
    }
    /// The contribution of component d of an acceleration to (g - a).g/|g|^2.
    IMBIBE_INLINE Real along(std::size_t d, Real a) const {
        const int k = static_cast<int>(d);
        return per_weight[k] * (gravity[k] - a);
    }
    /// The running mean after this step. Without previous support it follows at once: water at rest is supported from
    /// its first step on, and a blow counts for no more than its weight.
    IMBIBE_INLINE Real mean(Real before, Real now) const {
        return before == 0 ? std::min(std::max(now, Real(0)), Real(1)) : before + follow * (now - before);
    }

private:
    // Averaging time: as long as sound takes for this many support radii. With 0, sound would count as support, and
    // density smoothing would not damp it; with more, landing water would count as falling for longer.
    static constexpr double supports = 10;
    Vector<Real, dim> gravity{}, per_weight{};
    Real follow = 0;
};
template <int dim, class Real>
class IMBIBE_PER_BUILD Mover : public Neighbourhood<dim, Real> {
    using Base = Neighbourhood<dim, Real>;

public:
    using Phase = typename Base::Phase;
    using Base::Base, Base::phases;

    /// velocity += dt * acceleration, for particles of the chosen phases that move and are not held; measures the
    /// motion.
    void kick(double dt, const Bits& chosen = all_phases);
    /// position += dt * (velocity + transport correction), for these and for prescribed motion.
    void drift(double dt, const Bits& chosen = all_phases);

    /// Keeps a copy of everything integrated: positions, velocities, states. For integrators with several stages.
    void remember();
    /// What was remembered, advanced by dt with the present rates (of positions: the present velocities).
    /// Neighbours and the order of the particles must not have changed since.
    void advance_remembered(double dt);

    /// to += by * (velocity + transport correction), a vector field of a phase, also for one that a host moves.
    void add_velocities(const Phase& s, Real* to, double by) const;
    /// Keeps a copy of some sums, of all phases.
    void keep_sums(std::span<const ColumnRange> columns);
    /// Restores these sums. The order of the particles must not have changed since.
    void restore_sums(std::span<const ColumnRange> columns);

    /// Measures the speeds of every phase; its acceleration is at least gravity. For the first step.
    void measure_motion();

    /// The same for velocities that a host has increased since the last step. Differences by rounding are ignored:
    /// looking at a scene changes nothing.
    void notice_greater_speeds();

protected:
    static constexpr Bits all_phases{{~0ull, ~0ull, ~0ull, ~0ull}};

private:
    static std::size_t columns_remembered(const Phase& s) {
        std::size_t columns = (s.row->drifts ? dim : 0) + (s.row->moves ? dim : 0);
        for (const StateRow& state : s.row->states)
            columns += static_cast<std::size_t>(state.components);
        return columns;
    }
    void copy_column(const Real* from, Real* to, int n) {
        const auto block = [&](int begin, int end) { std::copy_n(from + begin, end - begin, to + begin); };
        loop_blocks(n, 4096, this->threads, Callable<void(int, int)>(block));
    }
    // Calls f(phase, column, k) for every column, the k-th of its phase.
    template <class F>
    void for_each_kept(std::span<const ColumnRange> columns, const F& f) {
        int last = -1;
        std::size_t at = 0;
        for (const ColumnRange& range : columns) { // the columns of a phase are contiguous
            at = range.phase == last ? at : 0;
            last = range.phase;
            for (int c = 0; c < range.components; ++c)
                f(this->phase(range.phase), range.first + c, at++);
        }
    }
    void advance_state(Phase& s, int column, const Real* old, int rate_column, double dt) const;

    // velocity = old + dt * acceleration; the speeds and the greatest acceleration; the supported share, if a term
    // reads it. Compiled for each set of stored fields: a branch in the loop would prevent packs.
    Motion advance_velocities(Phase& s, const Real* old, double dt) const;
    template <bool has_mobility, bool has_share>
    Motion advance_velocities(Phase& s, const Real* old, double dt) const;
    // With a transport correction the distance is unknown, so neighbours are found anew in every step. The motion of
    // walls is measured from their positions.
    static void note_way(Phase& s, double dt) {
        if (!s.row->moves)
            return;
        if (s.row->transport_correction >= 0)
            s.travelled = std::numeric_limits<double>::infinity();
        else
            s.travelled += dt * s.motion.fastest;
    }
    // position = old + dt * (velocity + transport correction).
    void advance_positions(Phase& s, const Real* old, double dt) const;
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/motion_code.hpp>
#endif
