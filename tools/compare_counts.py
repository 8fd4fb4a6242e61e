#!/usr/bin/env python3
"""Compares two files of instruction counts; fails when one has grown by more than 3 %, or when a loop of the library takes
a fifth more than the same loop by hand. Where it is of water alone and the compiler that of the stored counts, it is 3 %
for a pair, 3 % for all of a sweep, and 6 % where the same work is split over two sweeps: what a sum takes at its beginning
and end weighs twice there.

    python3 tools/compare_counts.py benchmarks/baseline_counts.json counts.json

The files are written by tools/count_instructions.py. Ends with 0 if none of that is so, 1 if it is or a count is missing, and
77 if the counts come from different compilers and so say nothing about the code. When fewer or more instructions are
meant to be, the new file becomes the stored one:

    python3 tools/count_instructions.py build-benchmark/benchmarks/count_instructions -o benchmarks/baseline_counts.json
"""

import argparse
import json
import sys

NOT_COMPARABLE = 77


def read(path):
    try:
        with open(path) as file:
            found = json.load(file)
        return found["compiler"], {case: float(number) for case, number in found["counts"].items()}
    except OSError as error:
        sys.exit(f"compare_counts.py: cannot read {path}: {error.strerror}")
    except (ValueError, KeyError, TypeError, AttributeError):
        sys.exit(f"compare_counts.py: {path} is not a file of counts as tools/count_instructions.py writes them")


def over_by_hand(counts):
    """{case: its instructions over those of the same work by hand}"""
    hand = "_by_hand_"
    return {case.replace(hand, "_"): counts[case.replace(hand, "_")] / number
            for case, number in counts.items() if hand in case and case.replace(hand, "_") in counts}


def over_by_hand_a_pair(counts):
    """{number type: instructions of the water's loops for a pair over those by hand}, from what they take more where
    particles have more neighbours"""
    def more(loops, real):
        return counts[f"fluid_loops_of_more_{loops}{real}"] - counts[f"fluid_loops_{loops}{real}"]
    return {real: more("", real) / more("by_hand_", real) for real in ("float", "double")
            if all(f"fluid_loops_{case}{real}" in counts for case in ("", "by_hand_", "of_more_", "of_more_by_hand_"))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--tolerance", type=float, default=3, help="growth that is let pass, percent (default: 3)")
    parser.add_argument("--by-hand", type=float, default=1.2,
                        help="how many times the instructions of a loop by hand are let pass (default: 1.2)")
    parser.add_argument("--by-hand-water", type=float, default=1.03,
                        help="the same for water alone, the cases fluid_*, of one compiler: for a pair and in one sweep; its "
                             "excess counts twice for two sweeps (default: 1.03)")
    arguments = parser.parse_args()
    (old_compiler, old), (new_compiler, new) = read(arguments.old), read(arguments.new)

    width = max(map(len, [*old, *new, "case"]))
    print(f"{'case':{width}}  {'old':>10}  {'new':>10}  {'change':>8}")
    grown = []
    for case in sorted({*old, *new}):
        before, now = old.get(case), new.get(case)
        shown = ["-" if number is None else f"{number:.1f}" for number in (before, now)]
        row = f"{case:{width}}  {shown[0]:>10}  {shown[1]:>10}"
        if before and now is not None:
            change = 100 * (now / before - 1)
            row += f"  {change:+7.1f}%"
        if before is not None and now is None:
            grown.append(f"{case} is missing")
            row += "  missing"
        elif before and now is not None and change > arguments.tolerance:
            grown.append(f"{case} by {change:.1f} %")
            row += "  grown"
        print(row)

    beyond = []
    for case, ratio in sorted(over_by_hand(new).items()):
        of_water = case.startswith("fluid_") and old_compiler == new_compiler
        sweeps = 1 if "_in_one_sweep_" in case else 2
        most = 1 + sweeps * (arguments.by_hand_water - 1) if of_water else arguments.by_hand
        print(f"{case}: {ratio:.3f} times those by hand, at most {most:g}")
        if ratio > most:
            beyond.append(case)
    for real, ratio in over_by_hand_a_pair(new).items():
        print(f"{real}, for a pair: {ratio:.3f} times those by hand, at most {arguments.by_hand_water:g}")
        if old_compiler == new_compiler and ratio > arguments.by_hand_water:
            beyond.append(f"a pair of the fluid in {real}")
    if beyond:
        print(f"more than that many times the instructions of the loop by hand: {', '.join(beyond)}")
        return 1
    if old_compiler != new_compiler:
        print(f"not compared: the old counts are of {old_compiler}, the new ones of {new_compiler}")
        return NOT_COMPARABLE
    if grown:
        print(f"more than {arguments.tolerance:g} % more instructions: {'; '.join(grown)}")
        return 1
    print(f"no count has grown by more than {arguments.tolerance:g} %")
    return 0


if __name__ == "__main__":
    sys.exit(main())
