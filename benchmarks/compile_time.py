#!/usr/bin/env python3
"""Measures what programs with imbibe cost a compiler and writes the tables in docs/compile_time.md between their marks.

    python3 benchmarks/compile_time.py                      all of it: half an hour on a busy core
    python3 benchmarks/compile_time.py --only gyroid        only the rows with this word in them; the others stay
    python3 benchmarks/compile_time.py --check              writes nothing: fails where memory is over its budget

Every file is compiled alone, on one core, with -O3 -march=native and OpenMP. Seconds are those of the processor, user
and system, the least of the repeats: on a machine with other work they still vary by a third. Memory is the greatest
of any part of the compiler. The size of the code does not vary.
"""

import argparse
import glob
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.append(os.path.join(ROOT, "tools"))
from marked_tables import put_row

SPONGE = [f"examples/support/sponge_run_{name}.cpp"
          for name in ("paper_float", "paper_double", "sound_float", "sound_double")]
FROM_A_PRESET = "examples/guides/from_a_preset.cpp"  # a dam break, too
BUDGET = {  # s and GB, linked with imbibe::core and with precompiled headers, as the README's build makes its examples
    "examples/dam_break.cpp": (5, 0.7), FROM_A_PRESET: (5, 0.7), SPONGE[2]: (10, 1.0)}
WAYS = {  # how a program can be compiled: as where CMake links a library, or where it precompiles the headers
    "core": ["-DIMBIBE_COMPILED_CORE"], "presets": ["-DIMBIBE_COMPILED_CORE", "-DIMBIBE_COMPILED_PRESETS"],
    "precompiled": []}
IN_WORDS = {("core",): "linked with imbibe::core", ("presets",): "linked with imbibe::presets",
            ("core", "precompiled"): "linked with imbibe::core, headers precompiled", (): "from headers alone"}
CODE = {  # what the code of a program is for, by the names of its functions: the first that fits
    "sweeps over neighbours": r"sweep_(block|sources)",
    "output": r"Vtk|Snapshots|AtomicFile|require_writable|xml_escaped",
    "`describe`, `Progress` and warnings": r"describe|Progress::|[Ww]arning|(type|full_type)_name|name_(in|among)|in_words",
    "neighbour search, sorting and moving": r"imbibe::search|Neighbourhood|Mover|PairDistances",
    "geometry": r"imbibe::(fill|tank|Box|point_text|detail::(fill|tank|require_distinct|lattice))|stored_places",
    "checks and texts of errors": r"imbibe::(text|require\w*|Error)\b|::check",
    "the rest": r"",
}


class Compiler:
    def __init__(self, name, core, repeats):
        self.name, self.core, self.repeats = name, core, repeats
        self.folder = tempfile.TemporaryDirectory()
        self.object = os.path.join(self.folder.name, "out.o")

    def once(self, path, flags=(), output=None):
        """(seconds, GB, what the compiler printed) of one compilation."""
        command = [self.name, "-std=c++20", "-O3", "-march=native", "-fopenmp", "-w", '-DIMBIBE_TOOLS_DIR="tools"',
                   *flags, f"-I{ROOT}/include", f"-I{ROOT}/examples", "-isystem", "/usr/include/eigen3", "-c", path,
                   "-o", output or self.object]
        with tempfile.TemporaryFile("w+") as printed:
            child = subprocess.Popen(command, stdout=printed, stderr=printed,
                                     preexec_fn=lambda: os.sched_setaffinity(0, {self.core}))
            _, status, used = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            printed.seek(0)
            text = printed.read()
        if child.returncode != 0:
            sys.exit(f"compile_time.py: failed: {' '.join(command)}\n{text}")
        return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024e-9, text

    def measure(self, path, ways=()):
        """(seconds, GB, kB of code) of a program compiled in some of WAYS: the least of the repeats."""
        flags = [flag for way in ways for flag in WAYS[way]]
        if "precompiled" in ways:
            header = os.path.join(self.folder.name, "read.hpp")
            if not os.path.exists(header):
                with open(header, "w") as file:
                    file.write("#include <imbibe/imbibe.hpp>\n")
                self.once(header, [*flags, "-x", "c++-header"], header + ".gch")
            flags += ["-include", header]
        runs = [self.once(path, flags)[:2] for _ in range(self.repeats)]
        sizes = subprocess.run(["size", self.object], capture_output=True, text=True).stdout.split("\n")[1]
        found = (*(min(values) for values in zip(*runs)), int(sizes.split()[0]) * 1e-3)
        print(f"{self.name} {os.path.relpath(path, ROOT)} {' '.join(ways)}: {found[0]:.1f} s, {found[1]:.2f} GB, "
              f"{found[2]:.0f} kB of code", flush=True)
        return found


class Page:
    """The document. Every row is written as soon as it is measured, in the place of the row that begins alike."""

    def __init__(self, path):
        self.path = path

    def put(self, table, cells):
        put_row(self.path, table, "benchmarks/compile_time.py", cells)


def programs():
    """[(file, ways of WAYS, is it one of those that the build makes the main example of)]"""
    def under(folder):
        return sorted(os.path.relpath(path, ROOT) for path in glob.glob(os.path.join(ROOT, folder, "*.cpp")))

    parts = ["examples/sponge.cpp", "examples/support/sponge_run.cpp", *SPONGE]
    alone = [path for path in under("examples") if path not in parts and not path.endswith("sponge_study.cpp")]
    return [(path, ("core", "precompiled"), False) for path in BUDGET] + \
        [(path, ("core",), False) for path in [*alone, FROM_A_PRESET, *under("presets")]] + \
        [(path, ("presets",), False) for path in ("examples/gyroid.cpp", FROM_A_PRESET, SPONGE[2])] + \
        [(path, ("core",), True) for path in parts] + [(path, (), False) for path in BUDGET]


def measure_programs(page, compilers, only):
    sponge, chosen = [], [program for program in programs() if only in program[0]]
    for path, ways, of_the_sponge in chosen:
        found = compilers[0].measure(os.path.join(ROOT, path), ways)
        if of_the_sponge:
            sponge.append(found)
        limits = BUDGET[path] if "precompiled" in ways else ()
        budget = ", ".join(f"{limit} {unit} {'kept' if value <= limit else 'missed'}"
                           for limit, unit, value in zip(limits, ("s", "GB"), found))
        page.put("programs", [f"`{path}`, {IN_WORDS[ways]}", *in_words(found), budget])
    if len(sponge) == sum(of_the_sponge for *_, of_the_sponge in programs()):
        columns = list(zip(*sponge))
        page.put("programs", [f"the main example, its {len(sponge)} files",
                              *in_words((sum(columns[0]), max(columns[1]), sum(columns[2]))), ""])
    for compiler in compilers[1:]:
        for path in BUDGET if not only else [path for path, ways, _ in chosen if not ways]:
            found = compiler.measure(os.path.join(ROOT, path))
            page.put("programs", [f"`{path}`, from headers alone, {compiler.name}", *in_words(found), ""])


def in_words(found):
    return [f"{found[0]:.1f}", f"{found[1]:.2f}", f"{found[2]:.0f}"]


def measure_phases(page, compiler):
    """What g++ itself says of its time for the dam break, linked with imbibe::core."""
    report = compiler.once(os.path.join(ROOT, "examples/dam_break.cpp"), [*WAYS["core"], "-ftime-report"])[2]
    words = {"phase parsing": "reading headers, with the templates that needs",
             "phase lang. deferred": "instantiating the rest of the templates",
             "phase opt and generate": "optimising and writing code"}
    found = {}
    for name in words:  # user and system seconds
        numbers = re.search(rf"{re.escape(name)}\s*:\s*([\d.]+) \([^)]*\)\s*([\d.]+)", report).groups()
        found[name] = sum(float(number) for number in numbers)
    for name, seconds in found.items():
        page.put("phases", [words[name], f"{seconds:.1f}", f"{100 * seconds / sum(found.values()):.0f} %"])


def measure_code(page, compiler):
    """What the code of the dam break is for, linked with imbibe::core."""
    compiler.measure(os.path.join(ROOT, "examples/dam_break.cpp"), ["core"])
    symbols = subprocess.run(["nm", "-S", "-C", compiler.object], capture_output=True, text=True, check=True).stdout
    sizes = dict.fromkeys(CODE, 0)
    for size, name in re.findall(r"^\w+ (\w+) [tTwWuU] (.*)$", symbols, re.MULTILINE):
        sizes[next(words for words, pattern in CODE.items() if re.search(pattern, name))] += int(size, 16)
    for words, size in sizes.items():
        page.put("code", [words, f"{size * 1e-3:.0f}", f"{100 * size / sum(sizes.values()):.0f} %"])


def check(compiler):
    """Fails where a program of a budget takes more memory than that; seconds say too little on a shared machine."""
    over = []
    for path, (_, limit) in BUDGET.items():
        memory = compiler.measure(os.path.join(ROOT, path), ("core",))[1]
        over += [f"{path}: {memory:.2f} GB"] if memory > limit else []
    if over:
        sys.exit("compile_time.py: over the budget: " + "; ".join(over))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compilers", nargs="+", default=["g++", "clang++"], help="the first one compiles everything")
    parser.add_argument("--core", type=int, default=max(os.sched_getaffinity(0)), help="which core (default: the last)")
    parser.add_argument("--repeats", type=int, default=1, help="the least of so many is kept (default: 1)")
    parser.add_argument("--check", action="store_true", help="only compare memory with its budget; write nothing")
    parser.add_argument("--only", default="", help="only programs whose path has this in it; or phases, code")
    parser.add_argument("--page", default=os.path.join(ROOT, "docs", "compile_time.md"), help="the page to write into")
    arguments = parser.parse_args()
    compilers = [Compiler(name, arguments.core, arguments.repeats) for name in arguments.compilers]
    if arguments.check:
        return check(compilers[0])
    page = Page(arguments.page)
    if arguments.only in ("", "phases"):
        measure_phases(page, compilers[0])
    if arguments.only in ("", "code"):
        measure_code(page, compilers[0])
    measure_programs(page, compilers, arguments.only)


if __name__ == "__main__":
    main()
