// The schedule as an ordinary function: small sets of rows whose order is known, random ones whose order is checked.
#include <imbibe/solver/schedule.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <random>
#include <vector>

namespace schedule_test {

namespace {

using imbibe::Bits;
using imbibe::Fault;
using imbibe::Plan;
using imbibe::Row;
using imbibe::schedule;
using imbibe::Step;

Bits bits(std::initializer_list<int> columns) {
    Bits b;
    for (int c : columns)
        b.set(c);
    return b;
}
Row particle(int phase, std::initializer_list<int> reads, std::initializer_list<int> sets) {
    return {.reads = bits(reads), .sets = bits(sets), .phase = phase};
}
Row adding(int phase, std::initializer_list<int> reads, std::initializer_list<int> adds) {
    return {.reads = bits(reads), .adds = bits(adds), .phase = phase};
}
Row pair(int phase, std::initializer_list<int> reads, std::initializer_list<int> adds) {
    return {.reads = bits(reads), .adds = bits(adds), .phase = phase, .pair = true};
}
Row advance(int phase, int rate, int state) {
    return {.reads = bits({rate}), .sets = bits({state}), .phase = phase, .advances = true};
}

// The rows of a step, in order.
std::vector<int> rows_of(const Plan& plan, int step) {
    REQUIRE(step < plan.size);
    const Step& s = plan.steps[static_cast<std::size_t>(step)];
    return {s.rows.begin(), s.rows.begin() + s.size};
}
bool is_sweep(const Plan& plan, int step) {
    return plan.steps[static_cast<std::size_t>(step)].sweep;
}
int place(const Plan& plan, int row) {
    for (int k = 0; k < plan.size; ++k)
        for (int r : rows_of(plan, k))
            if (r == row)
                return k;
    return -1;
}
using Rows = std::vector<int>;

// Does the plan keep to what the rows declare? Written without a look at how the plan is made: goes through the steps
// and keeps book of which rows are done.
template <std::size_t n>
void check_plan(const std::array<Row, n>& rows, const Plan& plan) {
    REQUIRE(plan.fault == Fault::none);
    // All rows on which these depend, with or without those behind the states that they read.
    const auto rows_behind = [&](Bits needed, bool through_states) {
        Bits behind;
        for (std::size_t pass = 0; pass < n; ++pass)
            for (int r = 0; r < static_cast<int>(n); ++r) {
                const Row& row = rows[static_cast<std::size_t>(r)];
                if ((through_states || !row.advances) && ((row.adds | row.sets) & needed).any()) {
                    behind.set(r);
                    needed = needed | row.reads;
                }
            }
        return behind;
    };
    // What the rates of advanced states are computed from, and what anything else is: these last rows, and all that are
    // of no rate, see the new state, unless its own rate depends on them.
    Bits rates, others;
    for (const Row& r : rows)
        if (r.advances)
            rates = rates | r.reads;
    const Bits of_rates = rows_behind(rates, false);
    for (int r = 0; r < static_cast<int>(n); ++r)
        if (!rows[static_cast<std::size_t>(r)].advances && !of_rates.test(r))
            others = others | rows[static_cast<std::size_t>(r)].reads;
    const Bits of_others = rows_behind(others, false);
    Bits done, swept;
    int round = 0;
    for (int k = 0; k < plan.size; ++k) {
        const Step& step = plan.steps[static_cast<std::size_t>(k)];
        REQUIRE(step.round >= round);
        REQUIRE(step.size > 0);
        if (step.round > round || !step.sweep) { // sweeps of a round see what was there before them
            done = done | swept;
            swept = {};
        }
        round = step.round;
        for (int r : rows_of(plan, k)) {
            const Row& row = rows[static_cast<std::size_t>(r)];
            REQUIRE_FALSE(done.test(r));
            REQUIRE_FALSE(swept.test(r));
            REQUIRE(row.phase == step.phase);
            REQUIRE(row.pair == step.sweep);
            for (int other = 0; other < static_cast<int>(n); ++other) {
                const Row& writer = rows[static_cast<std::size_t>(other)];
                if (writer.advances) {
                    if (other == r || !(row.reads & writer.sets).any())
                        continue;
                    if (rows_behind(writer.reads, true).test(r))
                        REQUIRE_FALSE(done.test(other));
                    else if (!of_rates.test(r) || of_others.test(r))
                        REQUIRE(done.test(other));
                } else if ((row.reads & (writer.adds | writer.sets)).any()) {
                    REQUIRE(done.test(other));
                }
            }
            (step.sweep ? swept : done).set(r);
        }
    }
    done = done | swept;
    CHECK(done.count() == static_cast<int>(n));
}

} // namespace

TEST_CASE("Sets of bits", "[schedule]") {
    const Bits a = bits({0, 63, 64, 255}), b = bits({63, 100});
    CHECK(a.count() == 4);
    CHECK((a & b) == bits({63}));
    CHECK((a | b).count() == 5);
    CHECK((a - b) == bits({0, 64, 255}));
    CHECK_FALSE((b - a).test(63));
    CHECK_FALSE(Bits{}.any());
    CHECK(bits({255}).any());
}

TEST_CASE("A fluid whose density is given takes one particle loop and one sweep", "[schedule]") {
    // columns: 0 density (given), 1 pressure, 2 p/rho^2, 3 acceleration, 4 mass (given)
    const std::array<Row, 4> rows{pair(0, {2, 4}, {3}), particle(0, {0, 1}, {2}), pair(0, {4, 0}, {3}),
                                  particle(0, {0}, {1})};
    const Plan plan = schedule(rows, bits({0, 4}));
    check_plan(rows, plan);
    REQUIRE(plan.size == 2);
    CHECK(plan.rounds == 1);
    CHECK(rows_of(plan, 0) == Rows{3, 1}); // state before p/rho^2, whatever the order of declaration
    CHECK_FALSE(is_sweep(plan, 0));
    CHECK(rows_of(plan, 1) == Rows{0, 2}); // pressure and viscosity in one sweep
    CHECK(is_sweep(plan, 1));
    CHECK(plan.sweeps(0) == 1);
}

TEST_CASE("The plan is a constant expression", "[schedule]") {
    constexpr Plan plan = [] {
        std::array<Row, 2> rows{};
        rows[0].reads.set(1), rows[0].sets.set(2);
        rows[1].reads.set(0), rows[1].sets.set(1);
        Bits given;
        given.set(0);
        return schedule(rows, given);
    }();
    static_assert(plan.fault == Fault::none && plan.size == 1 && plan.steps[0].rows[0] == 1);
    CHECK(plan.steps[0].rows[1] == 0);
}

TEST_CASE("An advanced state: its rate sees the old value, everyone else the new one", "[schedule]") {
    // 0 density, 1 density rate, 2 pressure, 3 acceleration, 4 velocity; density and velocity are given
    const std::array<Row, 5> rows{
        pair(0, {2, 0}, {3}),  // force: new density
        particle(0, {0}, {2}), // equation of state: new density
        pair(0, {4, 0}, {1}),  // continuity, with the old density
        adding(0, {0}, {1}),   // another contribution to the rate, of the old density
        advance(0, 1, 0),
    };
    const Plan plan = schedule(rows, bits({0, 4}));
    check_plan(rows, plan);
    CHECK(place(plan, 2) < place(plan, 4));
    CHECK(place(plan, 3) < place(plan, 4));
    CHECK(place(plan, 4) <= place(plan, 1)); // in the same loop, one after the other
    CHECK(place(plan, 1) < place(plan, 0));
    CHECK(plan.sweeps(0) == 2);
    CHECK(plan.rounds == 2);
    CHECK(rows_of(plan, 2) == Rows{4, 1});
}

TEST_CASE("A rate that depends on its own state and on another advanced state", "[schedule]") {
    // 0 stress, 1 its rate, 2 density, 3 its rate, 4 pressure, 5 acceleration, 6 velocity, 7 velocity gradient
    const std::array<Row, 7> rows{
        pair(0, {6, 2}, {7}),        // gradient, with the old density
        particle(0, {7, 0, 2}, {1}), // stress rate, with the old stress and density
        pair(0, {6}, {3}),           // continuity
        advance(0, 1, 0),
        advance(0, 3, 2),
        particle(0, {2}, {4}),
        pair(0, {0, 2, 4}, {5}),
    };
    const Plan plan = schedule(rows, bits({0, 2, 6}));
    check_plan(rows, plan);
    CHECK(plan.sweeps(0) == 2);
    CHECK(rows_of(plan, 0) == Rows{0, 2}); // gradient and continuity share a sweep
    CHECK(place(plan, 6) == plan.size - 1);
}

TEST_CASE("A state that only looks on leaves the forces the new pressure", "[schedule]") {
    // 0 density, 1 its rate, 2 pressure, 3 acceleration, 4 velocity, 5 energy, 6 its rate, 7 conductivity, 8 work
    const std::array<Row, 8> rows{
        pair(0, {4}, {1}),     // continuity
        particle(0, {0}, {2}), // pressure: of the new density for the force, and so for the work
        pair(0, {2, 0}, {3}),  // force
        pair(0, {2, 4}, {6}),  // work of the pressure
        advance(0, 1, 0),
        advance(0, 6, 5),
        particle(0, {5, 0}, {7}), // of the old energy, and of the old density: it is for the rate alone
        pair(0, {5, 7}, {6}),
    };
    const Plan plan = schedule(rows, bits({0, 4, 5}));
    check_plan(rows, plan);
    CHECK(place(plan, 4) <= place(plan, 1)); // in the same loop, one after the other
    CHECK(place(plan, 1) < place(plan, 2));
    CHECK(place(plan, 3) < place(plan, 5));
    CHECK(place(plan, 6) < place(plan, 4));
    CHECK(plan.sweeps(0) == 2);
}
TEST_CASE("Two states that depend on each other advance together", "[schedule]") {
    // 0 density, 1 its rate, 2 energy, 3 its rate, 4 pressure, 5 acceleration, 6 velocity
    const std::array<Row, 6> rows{
        particle(0, {0, 2}, {4}), // pressure: of both as they were, for both rates are made of it
        pair(0, {4, 6}, {1}),
        pair(0, {4, 6}, {3}),
        advance(0, 1, 0),
        advance(0, 3, 2),
        pair(0, {4}, {5}),
    };
    const Plan plan = schedule(rows, bits({0, 2, 6}));
    check_plan(rows, plan);
    CHECK(place(plan, 0) < place(plan, 3));
    CHECK(place(plan, 0) < place(plan, 4));
    CHECK(plan.sweeps(0) == 1);
}
TEST_CASE("Two phases: a phase that is due is swept at once, others wait for it", "[schedule]") {
    // Pressure is continued from the fluid (phase 0) to a wall (phase 1), whose pressure the fluid's sweep reads.
    // 0 density f, 1 pressure f, 2 acceleration f, 3 sum w, 4 pressure w
    const std::array<Row, 5> rows{
        particle(0, {0}, {1}), pair(0, {1}, {2}), pair(0, {1, 4}, {2}), pair(1, {1}, {3}), particle(1, {3}, {4}),
    };
    const Plan plan = schedule(rows, bits({0}));
    check_plan(rows, plan);
    CHECK(plan.sweeps(0) == 1);
    CHECK(plan.sweeps(1) == 1);
    CHECK(plan.rounds == 2);
    CHECK(rows_of(plan, plan.size - 1) == Rows{1, 2}); // inner and coupling forces fused
    CHECK(place(plan, 3) < place(plan, 4));
}

TEST_CASE("Two phases that need nothing of each other share a round", "[schedule]") {
    const std::array<Row, 4> rows{pair(0, {0}, {1}), pair(1, {2}, {3}), particle(0, {1}, {4}), particle(1, {3}, {5})};
    const Plan plan = schedule(rows, bits({0, 2}));
    check_plan(rows, plan);
    CHECK(plan.sweeps(0) == 1);
    CHECK(plan.sweeps(1) == 1);
    CHECK(plan.steps[0].round == 0);
    CHECK(plan.steps[1].round == 0);
}

TEST_CASE("Sums nobody waits for do not cause a sweep of their own", "[schedule]") {
    // XSPH's sum (2 -> 3) and the forces (4 -> 5) are wanted at the end only; continuity (0 -> 1) is waited for.
    const std::array<Row, 4> rows{pair(0, {2}, {3}), pair(0, {0}, {1}), particle(0, {1}, {4}), pair(0, {4}, {5})};
    const Plan plan = schedule(rows, bits({0, 2}));
    check_plan(rows, plan);
    CHECK(plan.sweeps(0) == 2);
    CHECK(rows_of(plan, 0) == Rows{1});
    CHECK(rows_of(plan, plan.size - 1) == Rows{0, 3});
}

TEST_CASE("Nobody sets a field", "[schedule]") {
    const std::array<Row, 2> rows{particle(0, {0}, {1}), pair(0, {1, 7}, {2})};
    const Plan plan = schedule(rows, bits({0}));
    CHECK(plan.fault == Fault::nobody_sets);
    CHECK(plan.column == 7);
    CHECK(plan.row == 1);
    CHECK(schedule(rows, bits({0, 7})).fault == Fault::none);
}

TEST_CASE("Nobody adds to the rate of an advanced state", "[schedule]") {
    const std::array<Row, 1> rows{advance(0, 1, 0)};
    const Plan plan = schedule(rows, bits({0}));
    CHECK(plan.fault == Fault::nobody_sets);
    CHECK(plan.column == 1);
}

TEST_CASE("Two setters of one field", "[schedule]") {
    SECTION("two that set") {
        const std::array<Row, 3> rows{particle(0, {0}, {1}), particle(0, {0}, {2}), particle(0, {0}, {1})};
        const Plan plan = schedule(rows, bits({0}));
        CHECK(plan.fault == Fault::set_twice);
        CHECK(plan.column == 1);
        CHECK(plan.row + plan.other == 2);
    }
    SECTION("one that sets what another adds to") {
        const std::array<Row, 2> rows{pair(0, {0}, {1}), particle(0, {0}, {1})};
        const Plan plan = schedule(rows, bits({0}));
        CHECK(plan.fault == Fault::set_twice);
        CHECK(plan.column == 1);
    }
    SECTION("two that add are welcome") {
        const std::array<Row, 2> rows{pair(0, {0}, {1}), particle(0, {0}, {})};
        CHECK(schedule(rows, bits({0})).fault == Fault::none);
    }
}

TEST_CASE("What waits for a sum over all particles is in no loop with what is summed", "[schedule]") {
    // columns: 0 velocity, 1 density, 2 density rate, 3 pressure; rows: continuity, relaxation, advance, pressure
    std::array<Row, 4> rows{adding(0, {0}, {2}), adding(0, {1}, {2}), advance(0, 2, 1), particle(0, {1}, {3})};
    CHECK(rows_of(schedule(rows, bits({0, 1})), 0) == std::vector{0, 1, 2, 3});
    rows[0].summed = rows[1].waits_for_all = rows[2].waits_for_all = true;
    const Plan apart = schedule(rows, bits({0, 1}));
    REQUIRE(apart.fault == Fault::none);
    REQUIRE(apart.size == 2);
    CHECK(rows_of(apart, 0) == std::vector{0});
    CHECK(rows_of(apart, 1) == std::vector{1, 2, 3});
    // the relaxation first in the list, or nothing to sum: then nobody waits
    std::swap(rows[0], rows[1]);
    CHECK(rows_of(schedule(rows, bits({0, 1})), 0) == std::vector{1});
    rows[1].summed = false;
    CHECK(schedule(rows, bits({0, 1})).size == 1);
    rows[1] = pair(0, {0}, {2});
    rows[1].summed = true; // a sweep is a loop of its own, but the relaxation waits all the same
    const Plan swept = schedule(rows, bits({0, 1}));
    REQUIRE(swept.size == 2);
    CHECK(rows_of(swept, 0) == std::vector{1});
    CHECK(rows_of(swept, 1) == std::vector{0, 2, 3});
}

TEST_CASE("A cycle is reported by rows that are on it", "[schedule]") {
    SECTION("of two") {
        const std::array<Row, 2> rows{particle(0, {1}, {0}), particle(0, {0}, {1})};
        const Plan plan = schedule(rows, Bits{});
        CHECK(plan.fault == Fault::cycle);
        CHECK(plan.row + plan.other == 1);
    }
    SECTION("of one with itself") {
        const std::array<Row, 2> rows{particle(0, {5}, {3}), particle(0, {0, 5}, {0})};
        const Plan plan = schedule(rows, bits({0, 5}));
        CHECK(plan.fault == Fault::cycle);
        CHECK(plan.row == 1);
        CHECK(plan.other == -1);
    }
    SECTION("with innocent rows that wait for it, listed first") {
        const std::array<Row, 6> rows{pair(0, {4}, {6}),     particle(0, {3}, {4}), particle(0, {9}, {0}),
                                      particle(0, {2}, {3}), pair(0, {3, 0}, {1}),  particle(0, {1}, {2})};
        const Plan plan = schedule(rows, bits({9}));
        CHECK(plan.fault == Fault::cycle);
        // 3 -> 4 -> 5 -> 3; rows 0 and 1 only wait, row 2 is done
        for (int r : {plan.row, plan.other})
            CHECK((r == 3 || r == 4 || r == 5));
        CHECK(plan.row != plan.other);
    }
}

TEST_CASE("What does not fit is said to be too large, not a cycle", "[schedule]") {
    SECTION("more rows than a loop has room for") {
        std::array<Row, 60> rows{};
        for (int r = 0; r < 60; ++r)
            rows[static_cast<std::size_t>(r)] = particle(0, {0}, {r + 1});
        CHECK(schedule(rows, bits({0})).fault == Fault::too_large);
    }
    SECTION("more loops than a plan has room for") {
        std::array<Row, 100> rows{}; // one chain: every row waits for the one before it
        for (int r = 0; r < 100; ++r)
            rows[static_cast<std::size_t>(r)] = r % 2 == 0 ? pair(0, {r}, {r + 1}) : particle(0, {r}, {r + 1});
        CHECK(schedule(rows, bits({0})).fault == Fault::too_large);
    }
    SECTION("a long chain that fits") {
        std::array<Row, 40> rows{};
        for (int r = 0; r < 40; ++r)
            rows[static_cast<std::size_t>(r)] = r % 2 == 0 ? pair(0, {r}, {r + 1}) : particle(0, {r}, {r + 1});
        const Plan plan = schedule(rows, bits({0}));
        check_plan(rows, plan);
        CHECK(plan.size == 40);
    }
    SECTION("more rows than there are bits") {
        const auto rows = std::make_unique<std::array<Row, 300>>();
        CHECK(schedule(*rows, Bits{}).fault == Fault::too_large);
    }
}

namespace {

constexpr int random_rows = 14;

// Row r writes column r + 1 and reads some columns before it: so there is an order. Then the rows are shuffled.
std::array<Row, random_rows> random_graph(std::mt19937& generator, int phases, int states) {
    std::array<Row, random_rows> rows{};
    const auto draw = [&](int below) { return static_cast<int>(generator() % static_cast<unsigned>(below)); };
    for (int r = 0; r < random_rows; ++r) {
        Row& row = rows[static_cast<std::size_t>(r)];
        row.phase = draw(phases);
        row.pair = draw(2) == 0;
        const int reads = 1 + draw(3);
        for (int k = 0; k < reads; ++k) {
            const int c = draw(r + 1);
            // A particle row reads only what its own phase has.
            if (row.pair || c == 0 || rows[static_cast<std::size_t>(c - 1)].phase == row.phase)
                row.reads.set(c);
        }
        (row.pair ? row.adds : row.sets).set(r + 1);
    }
    const int moved = random_rows - states; // the last rows move states, 100 and so on, by what some row computes
    for (int state = 0; state < states; ++state) {
        Row& last = rows[static_cast<std::size_t>(moved + state)];
        const int rate = 1 + draw(moved);
        last = advance(rows[static_cast<std::size_t>(rate - 1)].phase, rate, 100 + state);
        for (int k = 0; k < 4; ++k) { // others read the state
            Row& reader = rows[static_cast<std::size_t>(draw(moved))];
            if (reader.pair || reader.phase == last.phase)
                reader.reads.set(100 + state);
        }
    }
    std::shuffle(rows.begin(), rows.end(), generator);
    return rows;
}

// The most pair rows one after the other on any path: no order can do with fewer sweeps.
int longest_chain(const std::array<Row, random_rows>& rows) {
    std::array<int, random_rows> depth{};
    int longest = 0;
    for (int pass = 0; pass < random_rows; ++pass)
        for (std::size_t r = 0; r < random_rows; ++r) {
            depth[r] = rows[r].pair;
            for (std::size_t w = 0; w < random_rows; ++w)
                if (w != r && (rows[r].reads & (rows[w].adds | rows[w].sets)).any())
                    depth[r] = std::max(depth[r], depth[w] + rows[r].pair);
            longest = std::max(longest, depth[r]);
        }
    return longest;
}

} // namespace

TEST_CASE("Random graphs of one phase: a right order, and no sweep too many", "[schedule]") {
    std::mt19937 generator(1);
    for (int k = 0; k < 300; ++k) {
        const auto rows = random_graph(generator, 1, 0);
        const Plan plan = schedule(rows, bits({0}));
        check_plan(rows, plan);
        CHECK(plan.sweeps(0) == longest_chain(rows));
    }
}

TEST_CASE("Random graphs of several phases: a right order", "[schedule]") {
    std::mt19937 generator(2);
    for (int k = 0; k < 300; ++k) {
        const auto rows = random_graph(generator, 3, 0);
        check_plan(rows, schedule(rows, bits({0})));
    }
}

TEST_CASE("Random graphs with advanced states: a right order", "[schedule]") {
    std::mt19937 generator(3);
    for (int k = 0; k < 1200; ++k) {
        const auto rows = random_graph(generator, 2, 1 + k % 3);
        check_plan(rows, schedule(rows, bits({0, 100, 101, 102})));
    }
}

} // namespace schedule_test
