#!/usr/bin/env python3
"""Counts the instructions of every run of an accuracy study under valgrind: a time that no other program disturbs.

    cmake --build --preset benchmark --target accuracy_cost_counted
    python3 tools/accuracy_instructions.py build-benchmark/studies/accuracy_cost_counted taylor-green --quick -o study.csv
    python3 tools/plot_accuracy.py study.csv --time instructions -o study.png

Runs the study as accuracy_cost does, then each row of its table once more, alone, some fifty times slower than without
valgrind: hence --quick for most. The table gets a column `instructions`, of one repetition with all that a run has, its
setting up included.
"""

import argparse
import csv
import os
import shutil
import sys
import tempfile

from count_instructions import number_after, output_of


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program accuracy_cost_counted")
    parser.add_argument("case", help="which scene")
    parser.add_argument("--quick", action="store_true", help="the coarsest spacings only")
    parser.add_argument("-o", "--output", default="accuracy.csv", help="the table to write (default: accuracy.csv)")
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("accuracy_instructions.py: valgrind is missing; run: sh tools/install_packages.sh benchmarks")

    study = [os.path.abspath(arguments.program), arguments.case] + ["--quick"] * arguments.quick
    output_of([*study, "-o", arguments.output])
    with open(arguments.output, newline="") as file:
        rows = list(csv.DictReader(file))
    with tempfile.TemporaryDirectory() as folder:
        for k, row in enumerate(rows):
            command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={os.path.join(folder, 'callgrind.out')}",
                       *study, "--row", str(k), "-o", os.path.join(folder, "row.csv")]
            row["instructions"] = number_after("Collected", output_of(command), command)
            print(f"{k + 1:3} of {len(rows)}: {row['instructions']:.4g} instructions", flush=True)
    with open(arguments.output, "w", newline="") as file:
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(rows)
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
