#!/usr/bin/env python3
"""Measures what each effect of a scene costs and writes the tables in docs/effects.md, between their marks.

    cmake --preset benchmark && cmake --build --preset benchmark --target effects out_of_reach
    python3 tools/effects_report.py build-benchmark/benchmarks
    python3 tools/effects_report.py build-benchmark/benchmarks --check

With --check nothing is written: it fails where bytes, sweeps or loads are others than the page says; with --count, too,
where what is out of reach, or a guard, costs more instructions than it may (some minutes).

The cases are those of benchmarks/effects.cpp and benchmarks/out_of_reach.cpp. Bytes, sweeps and loads are constants of
the compiler, instructions are counted by valgrind, and times are measured, each case in turn and several rounds of them,
the shortest kept.
"""

import argparse
import os
import re

from count_instructions import counts_of, output_of
from benchmark_results import machine
from marked_tables import with_table
from tool_errors import end_with, read_text, write_text

ROUNDS = 5
TOOL = "tools/effects_report.py"


def cases_of(program):
    """[(case, [bytes, sweeps, rounds, loads], effect, good for)] in the program's order, each base before what adds
    to it."""
    found = []
    for line in output_of([program]).splitlines():
        if line.startswith("costs "):
            costs, effect, good_for = line.split(" | ")
            _, case, *numbers = costs.split()
            found.append((case, [int(number) for number in numbers], effect, good_for))
    return found


def times_of(program, cases):
    """{case: the time the program prints, the shortest}"""
    times = {}
    for _ in range(ROUNDS):
        for case in cases:
            text = output_of([program, "--time", case])
            measured = float(re.search(r"seconds ([\d.]+)", text).group(1))
            times[case] = min(measured, times.get(case, measured))
    return times


def table_of_effects(program):
    found = cases_of(program)
    counted = counts_of(program)
    counts, times = counted["counts"], times_of(program, [case for case, *_ in found])
    lines = [f"Compiler: {counted['compiler']}, `-O3 -march=x86-64-v3`. Processor: {machine()}.", "",
             "| effect | bytes | sweeps | loads | instructions | ns | good for |",
             "| --- | ---: | ---: | ---: | ---: | ---: | --- |"]
    base = None
    for case, numbers, effect, good_for in found:
        size, sweeps, _, loads = numbers
        values = [size, sweeps, loads, counts[case], times[case]]
        if base is None or not case.startswith(base[0]):
            base = (case, values)
            lines.append(f"| **{effect}** | {size} | {sweeps} | {loads} | {counts[case]:.0f} | {times[case]:.0f} | "
                         f"{good_for} |")
        else:
            more = [now - before for now, before in zip(values, base[1])]
            share = [100 * (now / before - 1) for now, before in zip(values[3:], base[1][3:])]
            lines.append(f"| + {effect} | {more[0]:+d} | {more[1]:+d} | {more[2]:+d} | {more[3]:+.0f} ({share[0]:+.0f} %) | "
                         f"{more[4]:+.0f} ({share[1]:+.0f} %) | {good_for} |")
    return "\n".join([*lines, ""])


REACH = {
    "sponge_alone": "the sponge alone",
    "water_alone": "water and vessel alone",
    "walls_twice": "the same, with all walls once more where no water is",
    "out_of_reach": "all of them, the water 4.5 mm above the sponge, out of reach",
    "within_reach": "all of them, the water 0.4 mm above the sponge",
    "guarded": "the same with a `Guard`",
}


def table_of_reach(program):
    counts, times = counts_of(program)["counts"], times_of(program, REACH)
    lines = ["| scene | million instructions a step | ms a step |", "| --- | ---: | ---: |"]
    lines += [f"| {words} | {counts[case] * 1e-6:.1f} | {times[case] * 1e-3:.1f} |" for case, words in REACH.items()]
    apart = counts["sponge_alone"] + counts["water_alone"]
    share = {case: 100 * (counts[case] / apart - 1) for case in REACH}
    return "\n".join([*lines, "", f"Out of reach a step takes {share['out_of_reach']:+.1f} % instructions against those of "
                      f"its two halves together, within reach {share['within_reach']:+.1f} %. Walls that no water is near, as many as those "
                      f"that it is near, cost {100 * (counts['walls_twice'] / counts['water_alone'] - 1):+.1f} %. A guard costs "
                      f"{100 * (counts['guarded'] / counts['within_reach'] - 1):.1f} %.", ""])


def check(page, effects):
    """What is not as the page says."""
    wrong, base = [], None
    for case, (size, sweeps, _, loads), effect, _ in cases_of(effects):
        if base is None or not case.startswith(base[0]):
            base = (case, size, sweeps, loads)
            row = f"| **{effect}** | {size} | {sweeps} | {loads} |"
        else:
            row = f"| + {effect} | {size - base[1]:+d} | {sweeps - base[2]:+d} | {loads - base[3]:+d} |"
        if f"\n{row}" not in page:
            wrong.append(f"the page has no row that begins with {row}")
    return wrong


def check_counts(reach):
    """What costs more than it may."""
    wrong, counts = [], counts_of(reach)["counts"]
    for words, now, before, most in [
            ("out of reach a step", counts["out_of_reach"], counts["sponge_alone"] + counts["water_alone"], 1.03),
            ("a guard's step", counts["guarded"], counts["within_reach"], 1.02)]:
        print(f"{words} takes {now / before:.3f} times the instructions of one without, at most {most}")
        if now > most * before:
            wrong.append(f"{words} takes {now / before:.3f} times the instructions, more than {most}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="where the programs effects and out_of_reach are")
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser.add_argument("--page", default=os.path.join(root, "docs", "effects.md"), help="the page to write into")
    parser.add_argument("--check", action="store_true", help="write nothing, compare bytes, sweeps and loads")
    parser.add_argument("--count", action="store_true", help="with --check, count instructions, too")
    arguments = parser.parse_args()
    folder = os.path.abspath(arguments.folder)
    page = read_text(arguments.page)
    if arguments.check:
        wrong = check(page, os.path.join(folder, "effects"))
        if arguments.count:
            wrong += check_counts(os.path.join(folder, "out_of_reach"))
        if wrong:
            end_with("; ".join(wrong) + "; write the page anew where this is meant to be")
        return
    page = with_table(page, "effects", TOOL, table_of_effects(os.path.join(folder, "effects")))
    page = with_table(page, "reach", TOOL, table_of_reach(os.path.join(folder, "out_of_reach")))
    write_text(arguments.page, page)
    print(f"wrote {arguments.page}")


if __name__ == "__main__":
    main()
