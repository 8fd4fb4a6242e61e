#!/usr/bin/env python3
"""What the checks spend their time on: the twenty programs and tests that take longest to compile and to run, from
ninja's log and from what ctest writes (tests.xml, checks.xml) in the build folders.

    .ci/run && python3 tools/check_costs.py            prints them
    .ci/run && python3 tools/check_costs.py --write    puts them into CONTRIBUTING.md

Seconds are those of the clock, of each file and test by itself; on two cores ninja compiles three files at a time, and
ctest runs two tests.
"""

import argparse
import collections
import glob
import os
import re
import xml.etree.ElementTree as ElementTree

from benchmark_results import machine
from marked_tables import with_table
from tool_errors import end_with, read_text, write_text

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDERS = ["build", "build-headers", "build-clang", "build-benchmark"]  # what .ci/run fills
MANY = ("compile_error_",)  # so many tests that they count as one


class Costs:
    """Of one program, test or target."""

    def __init__(self):
        self.files, self.tests, self.compile, self.run = 0, 0, 0.0, 0.0


def built(folder):
    """[(target, is it a file that was compiled, seconds)] from ninja's log, of each output the last time."""
    last = {}
    for line in read_text(os.path.join(folder, ".ninja_log")).splitlines()[1:]:
        begin, end, _, output, _ = line.split("\t")
        last[output] = (int(end) - int(begin)) / 1000
    for output, seconds in last.items():
        of_target = re.search(r"CMakeFiles/([^/]+)[.]dir/", output)
        yield of_target[1] if of_target else os.path.basename(output), output.endswith(".o"), seconds


def tested(folder):
    """[(test, seconds)]"""
    for path in glob.glob(os.path.join(folder, "*.xml")):
        for case in ElementTree.fromstring(read_text(path)).iter("testcase"):
            yield case.get("name"), float(case.get("time"))


def costs_of(folder):
    found = collections.defaultdict(Costs)
    for target, is_file, seconds in built(folder):
        name = target.removeprefix("test_")
        found[name].compile += seconds
        found[name].files += is_file
    for test, seconds in tested(folder):
        name = next((many + "*" for many in MANY if test.startswith(many)), test)
        found[name].run += seconds
        found[name].tests += 1
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=20, help="how many (default: 20)")
    parser.add_argument("--write", action="store_true", help="write them into CONTRIBUTING.md")
    arguments = parser.parse_args()
    folders = [folder for folder in FOLDERS if os.path.exists(os.path.join(ROOT, folder, ".ninja_log"))]
    if not folders:
        end_with("nothing is built here; run .ci/run first")
    rows, totals = [], []
    for folder in folders:
        costs = costs_of(os.path.join(ROOT, folder))
        rows += [(it.compile + it.run, folder, name, it) for name, it in costs.items()]
        totals.append(f"`{folder}` {sum(it.compile for it in costs.values()):.0f} + "
                      f"{sum(it.run for it in costs.values()):.0f} s")
    rows.sort(key=lambda row: -row[0])
    lines = [f"{machine()}. Compiling and running, in all: {', '.join(totals)}.", "",
             "| item | build folder | files | compiling, s | tests | running, s |",
             "| --- | --- | ---: | ---: | ---: | ---: |"]
    lines += [f"| `{name}` | `{folder}` | {it.files or ''} | {it.compile:.0f} | {it.tests or ''} | {it.run:.0f} |"
              for _, folder, name, it in rows[:arguments.rows]]
    if arguments.write:
        page = os.path.join(ROOT, "CONTRIBUTING.md")
        write_text(page, with_table(read_text(page), "costs", "tools/check_costs.py", "\n".join([*lines, ""])))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
