#!/usr/bin/env python3
"""Counts the instructions of every case of benchmarks/count_instructions.cpp under valgrind, per particle.

    python3 tools/count_instructions.py build-benchmark/benchmarks/count_instructions -o counts.json

Unlike times, the counts do not depend on what else the machine does, but they do depend on the compiler, whose name is
written beside them. Two files are compared by tools/compare_counts.py.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import tempfile

from tool_errors import end_with, write_text


def output_of(command):
    """What the command prints on both streams, or the end of the program with a line that says what failed."""
    try:
        done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except OSError as error:
        end_with(f"cannot run {command[0]}: {error.strerror}")
    if done.returncode != 0:
        end_with(f"failed: {' '.join(command)}\n{done.stdout}")
    return done.stdout


def number_after(word, text, command):
    found = re.search(rf"{word}\s*:?\s*(\d+)", text)
    if not found or int(found.group(1)) == 0:
        end_with(f"no number after '{word}' in what this printed: {' '.join(command)}\n{text}")
    return int(found.group(1))


def count(program, case):
    """Instructions per particle, or per evaluation, of one case."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--toggle-collect=measured",
                   f"--callgrind-out-file={os.path.join(folder, 'callgrind.out')}", program, case]
        text = output_of(command)
    return number_after("Collected", text, command) / number_after("items", text, command)


def counts_of(program):
    """{"compiler": ..., "counts": {case: instructions}} of all cases of the program."""
    if not shutil.which("valgrind"):
        end_with("valgrind is missing; run: sh tools/install_packages.sh benchmarks")
    lines = output_of([program]).splitlines()
    compiler = [line.split(" ", 1)[1] for line in lines if line.startswith("compiler ")]
    cases = [line.split(" ", 1)[1] for line in lines if line.startswith("case ")]
    return {"compiler": compiler[0], "counts": {case: round(count(program, case), 2) for case in cases}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program count_instructions")
    parser.add_argument("-o", "--output", default="counts.json", help="the file to write (default: counts.json)")
    arguments = parser.parse_args()
    found = counts_of(os.path.abspath(arguments.program))
    write_text(arguments.output, json.dumps(found, indent=4) + "\n")
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
