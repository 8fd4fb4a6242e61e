#!/usr/bin/env python3
"""What more threads can bring at most: which share of a step's instructions one thread does alone, and how many parallel
loops a step has, at the end of each of which all threads wait for the last one.

    python3 tools/serial_share.py build-benchmark/benchmarks/count_instructions

Counts steps of benchmarks/count_instructions.cpp on one thread under valgrind. What parallel_for (core/parallel.hpp) runs
is what threads share. The speed-up is Amdahl's, 1/(s + (1 - s)/threads): no waiting, and memory as fast as all threads
ask for.
"""

import argparse
import os
import re
import shutil
import tempfile

from count_instructions import number_after, output_of
from tool_errors import end_with

STEPS = {"dam_break_step_float": 4, "fluid_step_float": 1, "solid_step_float": 1}  # of each case
THREADS = (2, 16, 64)


def calls_of_loops(lines):
    """How often parallel_for was called."""
    names, calls, callee = {}, 0, ""
    for line in lines:
        found = re.match(r"c?fn=\((\d+)\)(?: (.*))?", line)
        if found:
            names.setdefault(found.group(1), found.group(2) or "")
            if line.startswith("cfn"):
                callee = names[found.group(1)]
        elif line.startswith("calls=") and "parallel_for" in callee:
            calls += int(line[6:].split()[0])
    return calls


def share_of(program, case):
    """The serial share of the instructions of one case, and its parallel loops."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "callgrind.out")
        command = ["valgrind", "--tool=callgrind", "--toggle-collect=measured", f"--callgrind-out-file={out}", program,
                   case]
        total = number_after("Collected", output_of(command), command)
        inclusive = output_of(["callgrind_annotate", "--inclusive=yes", "--threshold=100", out])
        with open(out) as file:
            calls = calls_of_loops(file)
    if calls == 0:
        end_with(f"{case} of {program} calls no parallel_for; is it a step?")
    shared = sum(int(count.replace(",", "")) for count in
                 re.findall(r"^\s*([\d,]+) \(.*?\)\s+\S+?:void imbibe::parallel_for\b", inclusive, re.MULTILINE))
    return 1 - shared / total, calls


def rows_of(program):
    """A row for each case: its name, the serial share in percent, loops a step, and the speed-up for each of THREADS."""
    if not shutil.which("valgrind"):
        end_with("valgrind is missing; run: sh tools/install_packages.sh benchmarks")
    rows = []
    for case, steps in STEPS.items():
        serial, calls = share_of(os.path.abspath(program), case)
        rows.append([case.replace("_step_float", "").replace("_", " "), f"{100 * serial:.2f}", f"{calls / steps:.0f}",
                     *(f"{1 / (serial + (1 - serial) / threads):.1f}" for threads in THREADS)])
    return rows


HEAD = ["step", "serial, %", "parallel loops", *(f"{threads} threads" for threads in THREADS)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program count_instructions")
    rows = rows_of(parser.parse_args().program)
    for row in [HEAD, *rows]:
        print("".join(f"{cell:>16}" for cell in row))


if __name__ == "__main__":
    main()
