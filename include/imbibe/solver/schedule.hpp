// The schedule: an ordinary function that orders the parts of all terms so that every value is computed before it is
// read. It knows nothing of fields or terms, only rows of bits: one row per part, one column per field of each phase.
// The solver calls it at compile time, tests call it at run time.
//
// A *round* is: the particle rows that are ready, then one sweep over the neighbours for each phase that is due. A
// phase is due when all its remaining pair rows are ready; if no phase is, the ready pair rows are swept whose sums
// another row waits for. So pair rows are fused into as few sweeps as the data flow allows.
//
// State that is advanced *within* a step (density, stress: the symplectic Euler scheme) has an advancing row. The rows
// from which its rate is computed see the old value, all others the new one. A row from which both a rate and something
// else are computed sees the old value only of states whose advance depends on it: a term that integrates the work of
// the pressure must not make the forces see the pressure of the old density, which would be explicit Euler.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace imbibe {

/// A set of columns or rows: up to 256 bits.
struct Bits {
    /// The bits, 64 in a word. Not a std::array, and no loops below, because compilers limit the number of calls in
    /// constant evaluation.
    std::uint64_t words[4]{};

    /// The greatest number of bits.
    static constexpr int capacity = 256;
    /// Sets bit k. Bits beyond the capacity are dropped: a scene that needs them is refused as too large.
    constexpr void set(int k) {
        if (k < capacity)
            words[k / 64] |= std::uint64_t{1} << (k % 64);
    }
    /// Is bit k set?
    constexpr bool test(int k) const { return k < capacity && (words[k / 64] >> (k % 64) & 1); }
    /// The first set bit from k on; the capacity if there is none.
    constexpr int next(int k) const {
        for (; k < capacity; k = (k / 64 + 1) * 64)
            if (const std::uint64_t left = words[k / 64] >> (k % 64); left != 0)
                return k + std::countr_zero(left);
        return capacity;
    }
    /// Is one set?
    constexpr bool any() const { return (words[0] | words[1] | words[2] | words[3]) != 0; }
    /// How many are set.
    constexpr int count() const {
        // Not as a loop: with AVX-512's VPOPCNTDQ, g++ 12 makes a loop that counts half of the bits.
        return std::popcount(words[0]) + std::popcount(words[1]) + std::popcount(words[2]) + std::popcount(words[3]);
    }
    // These take a copy: with a reference, g++ 12 fails on a Bits of which some words were never written.
    /// The bits of a or b.
    friend constexpr Bits operator|(Bits a, const Bits& b) {
        a.words[0] |= b.words[0];
        a.words[1] |= b.words[1];
        a.words[2] |= b.words[2];
        a.words[3] |= b.words[3];
        return a;
    }
    /// The bits of a and b.
    friend constexpr Bits operator&(Bits a, const Bits& b) {
        a.words[0] &= b.words[0];
        a.words[1] &= b.words[1];
        a.words[2] &= b.words[2];
        a.words[3] &= b.words[3];
        return a;
    }
    /// The bits of a that are not in b.
    friend constexpr Bits operator-(Bits a, const Bits& b) {
        a.words[0] &= ~b.words[0];
        a.words[1] &= ~b.words[1];
        a.words[2] &= ~b.words[2];
        a.words[3] &= ~b.words[3];
        return a;
    }
    /// Are they the same?
    friend constexpr bool operator==(const Bits&, const Bits&) = default;
};

/// One part of one term on one phase: the columns it reads, adds to and sets.
struct Row {
    /// Columns.
    Bits reads{}, adds{}, sets{};
    int phase = 0;         ///< the phase it writes to
    bool pair = false;     ///< a sum over neighbours, or a function of one particle
    bool advances = false; ///< moves a state by its rate; `sets` is the state, `reads` the rate
    /// A particle row whose results are summed over all particles before any row of its phase with `waits_for_all` is
    /// evaluated, so it cannot share a loop with such a row: a density rate, before the volume is kept.
    bool summed = false, waits_for_all = false;
};

/// The chosen rows and all rows that write what they read, recursively; but none that advances a state, which is read
/// with its old value.
template <std::size_t n>
constexpr Bits with_what_they_read(const std::array<Row, n>& rows, Bits chosen) {
    for (Bits before, read; before != chosen;) {
        before = chosen;
        for (std::size_t k = 0; k < n; ++k)
            if (chosen.test(static_cast<int>(k)))
                read = read | rows[k].reads;
        for (std::size_t k = 0; k < n; ++k)
            if (!rows[k].advances && ((rows[k].adds | rows[k].sets) & read).any())
                chosen.set(static_cast<int>(k));
    }
    return chosen;
}

/// One loop: over the particles of a phase, or over their neighbours.
struct Step {
    bool sweep = false;         ///< over neighbours, or over particles
    int phase = 0;              ///< the phase it writes to
    int round = 0;              ///< the round it belongs to
    std::array<int, 48> rows{}; ///< in the order of evaluation
    int size = 0;               ///< how many rows
};

/// What can be wrong with a set of rows.
enum class Fault { none, nobody_sets, set_twice, cycle, too_large };

/// The order found, or what prevents one.
struct Plan {
    std::array<Step, 48> steps{}; ///< in the order of evaluation
    int size = 0;                 ///< how many steps
    int rounds = 0;               ///< how many rounds
    Fault fault = Fault::none;    ///< what is wrong
    int column = -1;          ///< the column at fault
    int row = -1, other = -1; ///< the rows at fault

    /// How many steps sweep over the neighbours of a phase.
    constexpr int sweeps(int phase) const {
        int n = 0;
        for (int k = 0; k < size; ++k)
            n += steps[static_cast<std::size_t>(k)].sweep && steps[static_cast<std::size_t>(k)].phase == phase;
        return n;
    }
};

namespace detail {

// The state of the scheduling algorithm.
template <std::size_t n>
class Scheduler {
public:
    constexpr Scheduler(const std::array<Row, n>& all, const Bits& given_columns) : rows(all), given(given_columns) {}

    constexpr Plan run() {
        find_faults();
        if (plan.fault != Fault::none)
            return plan;
        find_ancestors();
        find_old();
        while (done.count() < static_cast<int>(n)) {
            const int before = done.count();
            particle_loops();
            if (done.count() < static_cast<int>(n))
                sweeps();
            if (plan.fault == Fault::too_large)
                return plan;
            if (done.count() == before) {
                find_cycle();
                return plan;
            }
            ++plan.rounds;
        }
        return plan;
    }

private:
    const std::array<Row, n>& rows;
    Bits given;
    Bits done;      // rows
    Bits ancestors; // rows from which the rates of advanced states are computed
    Bits advanced;  // columns
    Bits providers[Bits::capacity]; // by column: the rows that write it
    Bits old[Bits::capacity];       // by row: the states of which it sees the old value
    Plan plan;

    constexpr const Row& row(int r) const { return rows[static_cast<std::size_t>(r)]; }

    constexpr void find_faults() {
        if (n > 256) {
            plan.fault = Fault::too_large;
            return;
        }
        for (int r = 0; r < static_cast<int>(n); ++r) {
            if (row(r).advances) {
                advanced = advanced | row(r).sets;
                continue;
            }
            const Bits writes = row(r).sets | row(r).adds;
            for (int c = writes.next(0); c < Bits::capacity; c = writes.next(c + 1))
                providers[c].set(r);
        }
        for (int r = 0; r < static_cast<int>(n); ++r) {
            const Bits all = row(r).reads | row(r).sets;
            for (int c = all.next(0); c < Bits::capacity; c = all.next(c + 1)) {
                const Bits& who = providers[c];
                if (row(r).reads.test(c) && !given.test(c) && !who.any()) {
                    plan = {.fault = Fault::nobody_sets, .column = c, .row = r};
                    return;
                }
                if (row(r).sets.test(c) && !row(r).advances)
                    for (int other = 0; other < static_cast<int>(n); ++other)
                        if (other != r && (who.test(other) || row(other).sets.test(c))) { // or advances it
                            plan = {.fault = Fault::set_twice, .column = c, .row = r, .other = other};
                            return;
                        }
            }
        }
    }

    constexpr void find_ancestors() {
        Bits advances;
        for (int r = 0; r < static_cast<int>(n); ++r)
            if (row(r).advances)
                advances.set(r);
        ancestors = with_what_they_read(rows, advances) - advances;
    }

    // The states of which a row sees the old value. A row from which only rates are computed sees old values of all
    // states: it shares a sweep with other rates, and no other row is affected. A row that others read too sees old
    // values of those states whose own advance waits for it.
    constexpr void find_old() {
        const Bits shared = shared_ancestors();
        for (int r = 0; r < static_cast<int>(n); ++r)
            if (ancestors.test(r) && !shared.test(r))
                old[r] = row(r).reads & advanced;
        for (const Row& advance : rows)
            if (advance.advances) {
                const Bits behind = rows_behind(advance);
                for (int r = 0; r < static_cast<int>(n); ++r)
                    if (shared.test(r) && behind.test(r)) {
                        Bits& seen = old[r];
                        seen = seen | (row(r).reads & advance.sets);
                    }
            }
    }
    // The ancestors whose results other rows depend on too, and the rows that read these results: they must see the
    // same states.
    constexpr Bits shared_ancestors() const {
        Bits others, written;
        for (int r = 0; r < static_cast<int>(n); ++r)
            if (!row(r).advances && !ancestors.test(r))
                others.set(r);
        Bits shared = with_what_they_read(rows, others) & ancestors;
        for (Bits before; before != shared;) {
            before = shared;
            for (int r = 0; r < static_cast<int>(n); ++r)
                if (shared.test(r))
                    written = written | row(r).adds | row(r).sets;
            for (int r = 0; r < static_cast<int>(n); ++r)
                if (ancestors.test(r) && (row(r).reads & written).any())
                    shared.set(r);
        }
        return shared;
    }
    // All rows on which the advance of a state depends, also through other states.
    constexpr Bits rows_behind(const Row& advance) const {
        Bits behind, needed = advance.reads;
        for (bool grew = true; grew;) {
            grew = false;
            for (int r = 0; r < static_cast<int>(n); ++r)
                if (!behind.test(r) && ((row(r).adds | row(r).sets) & needed).any()) {
                    behind.set(r);
                    needed = needed | row(r).reads;
                    grew = true;
                }
        }
        return behind;
    }

    constexpr bool ready(int r) const {
        const Row& it = row(r);
        for (int c = it.reads.next(0); c < Bits::capacity; c = it.reads.next(c + 1)) {
            if ((providers[c] - done).any())
                return false;
            if (advanced.test(c) && !it.advances && !sees_old(r, c) && !column_advanced(c))
                return false;
        }
        if (it.advances) // rows that need the old value must be done before
            for (int other = 0; other < static_cast<int>(n); ++other)
                if (!done.test(other) && needs_old(other, it))
                    return false;
        return true;
    }

    constexpr bool sees_old(int r, int c) const { return old[r].test(c); }
    constexpr bool needs_old(int r, const Row& advance) const { return (old[r] & advance.sets).any(); }

    constexpr bool column_advanced(int c) const {
        for (int r = 0; r < static_cast<int>(n); ++r)
            if (row(r).advances && row(r).sets.test(c))
                return done.test(r);
        return true;
    }

    // A row that row r waits for; -1 if there is none.
    constexpr int waits_for(int r) const {
        const Bits& reads = row(r).reads;
        for (int c = reads.next(0); c < Bits::capacity; c = reads.next(c + 1))
            for (int other = 0; other < static_cast<int>(n); ++other) {
                if (done.test(other))
                    continue;
                if (providers[c].test(other))
                    return other;
                if (row(other).advances && row(other).sets.test(c) && !row(r).advances && !sees_old(r, c))
                    return other;
            }
        if (row(r).advances)
            for (int other = 0; other < static_cast<int>(n); ++other)
                if (!done.test(other) && needs_old(other, row(r)))
                    return other;
        return -1;
    }

    // No row is ready any more. Following the dependencies from row to row ends in a cycle: two neighbours on it are
    // the rows at fault, not the rows that wait for them.
    constexpr void find_cycle() {
        int r = 0;
        while (r + 1 < static_cast<int>(n) && (done.test(r) || waits_for(r) < 0))
            ++r;
        if (waits_for(r) < 0) { // no cycle: a row that never becomes ready
            plan.fault = Fault::cycle;
            plan.row = r;
            return;
        }
        for (std::size_t k = 0; k < n; ++k)
            r = waits_for(r);
        plan.fault = Fault::cycle;
        plan.row = r;
        plan.other = waits_for(r) == r ? -1 : waits_for(r);
    }

    constexpr void append(const Step& step) {
        if (plan.size == static_cast<int>(plan.steps.size())) {
            plan.fault = Fault::too_large;
            return;
        }
        plan.steps[static_cast<std::size_t>(plan.size++)] = step;
    }
    constexpr void append(Step& step, int r) {
        if (step.size == static_cast<int>(step.rows.size())) {
            plan.fault = Fault::too_large;
            return;
        }
        step.rows[static_cast<std::size_t>(step.size++)] = r;
    }

    // Successive ready particle rows share a loop as long as they belong to one phase.
    constexpr void particle_loops() {
        for (bool any = true; any;) {
            any = false;
            for (int r = 0; r < static_cast<int>(n); ++r) {
                if (row(r).pair || done.test(r) || !ready(r) || (row(r).waits_for_all && waits_for_sum({}, r)))
                    continue;
                any = true;
                Step step{.sweep = false, .phase = row(r).phase, .round = plan.rounds};
                for (bool grew = true; grew;) {
                    grew = false;
                    for (int k = 0; k < static_cast<int>(n); ++k)
                        if (!row(k).pair && row(k).phase == step.phase && !done.test(k) && ready(k) &&
                            !(row(k).waits_for_all && waits_for_sum(step, k))) {
                            append(step, k);
                            done.set(k);
                            grew = true;
                        }
                }
                append(step);
            }
        }
    }

    // Is a row whose results are summed over all particles of r's phase still pending, or in this loop?
    constexpr bool waits_for_sum(const Step& step, int r) const {
        for (int k = 0; k < static_cast<int>(n); ++k)
            if (row(k).summed && row(k).phase == row(r).phase && !done.test(k))
                return true;
        for (int k = 0; k < step.size; ++k)
            if (row(step.rows[static_cast<std::size_t>(k)]).summed)
                return true;
        return false;
    }

    // Does some pending row wait for what row r adds?
    constexpr bool awaited(int r) const {
        for (int k = 0; k < static_cast<int>(n); ++k)
            if (!done.test(k) && k != r && (row(k).reads & (row(r).adds | row(r).sets)).any())
                return true;
        return false;
    }

    constexpr void sweeps() {
        Bits is_ready, swept;
        int phases = 0;
        for (int r = 0; r < static_cast<int>(n); ++r) {
            phases = row(r).phase >= phases ? row(r).phase + 1 : phases;
            if (row(r).pair && !done.test(r) && ready(r))
                is_ready.set(r);
        }
        bool any_due = false;
        for (int p = 0; p < phases; ++p) {
            bool due = true, some = false;
            for (int r = 0; r < static_cast<int>(n); ++r)
                if (row(r).pair && row(r).phase == p && !done.test(r)) {
                    some = true;
                    due = due && is_ready.test(r);
                }
            if (some && due) {
                any_due = true;
                sweep(p, is_ready, false, swept);
            }
        }
        if (!any_due)
            for (int p = 0; p < phases; ++p)
                sweep(p, is_ready, true, swept);
        done = done | swept; // only now: a sweep sees the values from before the round's sweeps
    }

    constexpr void sweep(int p, const Bits& is_ready, bool only_awaited, Bits& swept) {
        Step step{.sweep = true, .phase = p, .round = plan.rounds};
        for (int r = 0; r < static_cast<int>(n); ++r)
            if (is_ready.test(r) && row(r).phase == p && (!only_awaited || awaited(r))) {
                append(step, r);
                swept.set(r);
            }
        if (step.size > 0)
            append(step);
    }
};

} // namespace detail

/// Orders the rows. Complexity: rows^2 times rounds.
/// @param rows what is to be ordered
/// @param given columns that have a value when a step begins
template <std::size_t n>
constexpr Plan schedule(const std::array<Row, n>& rows, const Bits& given) {
    return detail::Scheduler<n>(rows, given).run();
}

} // namespace imbibe
