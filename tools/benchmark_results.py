"""Runs the benchmarks and reads what they wrote: the half of tools/benchmark_report.py that measures."""

import json
import os
import platform
import re
import statistics
import subprocess
import sys
import time

TIMES = ("particle", "moving", "hand", "evaluation", "neighbour", "read")  # counters in seconds: the least is the best guess
RATES = ("flops",)  # the greatest is

FULL = ["--benchmark_repetitions=5", "--benchmark_min_time=0.2"]
QUICK = ["--benchmark_repetitions=1", "--benchmark_min_time=0.01", "--benchmark_filter=-1000000"]


def stop(message):
    sys.exit(f"benchmark_report.py: {message}")


def programs_in(build):
    """The names of the programs in the build folder, and the folder they are in."""
    folder = os.path.join(build, "benchmarks")
    names = [name for name in (sorted(os.listdir(folder)) if os.path.isdir(folder) else [])
             if (name == "peaks" or name.startswith("bench_")) and os.access(os.path.join(folder, name), os.X_OK)
             and os.path.isfile(os.path.join(folder, name))]
    if not names:
        stop(f"there are no benchmarks in {folder}; run: cmake --preset benchmark && cmake --build --preset benchmark")
    return folder, names


def run(build, results, quick, only=None):
    """Runs every program, or that named `only`, and leaves its JSON in `results`, beside those of earlier rounds."""
    folder, names = programs_in(build)
    if only:
        names = [name for name in names if name == only] or stop(f"there is no {only} in {folder}")
    os.makedirs(results, exist_ok=True)
    options = QUICK if quick else FULL
    with open(os.path.join(results, "options.json"), "w") as file:
        json.dump({"options": options, "commit": commit()}, file)
    for name in names:
        output = os.path.join(results, f"{name}.{len(files_of(results, name))}.json")
        print(f"{name} ...", flush=True)
        others = Others()
        # No report line on the terminal is needed, the file has it all.
        done = subprocess.run([os.path.join(folder, name), f"--benchmark_out={output}", *options], text=True,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if done.returncode == -4:
            print(f"{name}: this processor lacks the instruction set it is compiled for; left out")
            if os.path.exists(output):
                os.remove(output)
        elif done.returncode != 0:
            stop(f"{name} failed with {done.returncode}:\n{done.stderr}")
        else:
            note(output, "others", others.share())


class Others:
    """What other programs, and the machine's host, have of the processors from now on."""

    def __init__(self):
        self.begin = self.now()

    def share(self):
        """Processors that others kept busy, on average."""
        (seconds, busy), (seconds_then, busy_then) = self.now(), self.begin
        return max(0.0, (busy - busy_then) / (seconds - seconds_then))

    @staticmethod
    def now():
        """(seconds on a clock, seconds of all processors that neither were idle nor worked for this program)"""
        try:
            import psutil  # here, so that what measures nothing, as a test of a page's constants, does without it
        except ImportError:
            stop("needs psutil: run sh tools/install_packages.sh benchmarks, then Debian's own /usr/bin/python3")
        machine, own = psutil.cpu_times(), os.times()
        busy = machine.user + machine.nice + machine.system + getattr(machine, "steal", 0.0)
        return time.monotonic(), busy - (own.user + own.system + own.children_user + own.children_system)


def note(output, name, value):
    """Adds to what the file of a program's results says of how it was measured."""
    with open(output) as file:
        measured = json.load(file)
    measured["context"][name] = value
    with open(output, "w") as file:
        json.dump(measured, file, indent=1)


def files_of(results, name=r"(?:peaks|bench_\w+)"):
    """The files of a program's results, or of all programs': one a round."""
    found = sorted(os.listdir(results)) if os.path.isdir(results) else []
    return [file for file in found if re.fullmatch(name + r"\.\d+\.json", file)]


def clear(results):
    """Forgets the rounds of before."""
    for file in files_of(results):
        os.remove(os.path.join(results, file))


def how(results):
    """(whether the results are those of a quick run, the commit of the library that they are of)"""
    try:
        with open(os.path.join(results, "options.json")) as file:
            stored = json.load(file)
            return stored["options"] == QUICK, stored["commit"]
    except (OSError, ValueError, KeyError, TypeError):
        return False, "unknown version"


def commit():
    """The commit that is checked out here."""
    return first_line(["git", "-C", os.path.dirname(os.path.abspath(__file__)), "describe", "--always",
                       "--dirty"]).strip() or "unknown version"


def command_of(build, name, quick):
    """The command that made the results of a program, from the repository root."""
    return " ".join([f"{os.path.basename(os.path.normpath(build))}/benchmarks/{name}", *(QUICK if quick else FULL)])


def read(results):
    """{program: {benchmark: {counter: number}}}, the best of all repetitions of all rounds, and the contexts."""
    rows, contexts = {}, []
    for file in files_of(results):
        name = file.split(".")[0]
        try:
            with open(os.path.join(results, file)) as stream:
                measured = json.load(stream)
        except ValueError:
            stop(f"{file} is not complete; run the benchmarks again")
        contexts.append(measured["context"])
        for row in measured["benchmarks"]:
            if row.get("error_occurred"):
                stop(f"{name}, {row['name']}: {row['error_message']}")
            if row["run_type"] == "iteration":
                rows.setdefault(name, {}).setdefault(clean(row["run_name"]), []).append(row)
    if not rows:
        stop(f"there are no results in {results}")
    return {name: {benchmark: best(of) for benchmark, of in found.items()} for name, found in rows.items()}, contexts


def clean(name):
    return re.sub(r"(/iterations:\d+)?(/real_time|/manual_time)?$", "", name)


def best(repetitions):
    counters = {}
    for key, value in repetitions[0].items():
        if isinstance(value, (int, float)):
            values = [row[key] for row in repetitions]
            pick = min if key in TIMES else max if key in RATES else statistics.median
            counters[key] = pick(values)
    return counters


def first_line(command):
    try:
        return subprocess.run(command, text=True, capture_output=True, env={**os.environ, "LC_ALL": "C"}).stdout
    except OSError:
        return ""


def machine():
    """What the processor is called, and how many of it there are."""
    model = re.search(r"^Model name:\s*(.+)$", first_line(["lscpu"]), re.MULTILINE)
    return f"{model.group(1) if model else platform.processor() or platform.machine()}, {os.cpu_count()} logical cores"


def compiler(build):
    """The compiler and the options of a build folder."""
    try:
        with open(os.path.join(build, "CMakeCache.txt")) as file:
            cache = dict(re.findall(r"^(\w+):\w+=(.*)$", file.read(), re.MULTILINE))
    except OSError:
        return "unknown compiler"
    version = first_line([cache.get("CMAKE_CXX_COMPILER", "c++"), "--version"]).splitlines()
    kind = cache.get("CMAKE_BUILD_TYPE", "")
    flags = [cache.get("CMAKE_CXX_FLAGS", ""), cache.get(f"CMAKE_CXX_FLAGS_{kind.upper()}", ""),
             "-march=native" if cache.get("IMBIBE_NATIVE", "ON") == "ON" else ""]
    return f"{version[0] if version else 'unknown compiler'}, `{' '.join(flag for flag in flags if flag)}`"
