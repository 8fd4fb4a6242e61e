#!/usr/bin/env python3
"""Runs all benchmarks and writes docs/speed.md, with tables, pictures and the command behind each number.

    cmake --preset benchmark && cmake --build --preset benchmark
    cmake --preset benchmark-clang && cmake --build --preset benchmark-clang
    python3 tools/benchmark_report.py --build build-benchmark --clang build-benchmark-clang

The results stay as JSON in build-benchmark/results/; --reuse writes the report from them again without measuring. With
--quick it takes two minutes instead of ten a round and leaves out the largest scenes. Nothing else should run on the
machine; the report says how busy it was.

Numbers of instructions depend on the compiler only: --counts writes new ones and leaves the rest of the page.
"""

import argparse
import json
import os
import re
import sys

import benchmark_results as results
import compare_counts
import count_instructions
import serial_share
from picture_style import CURVES, DASHES, plt, save

REALS = ("float", "double")
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def table(head, rows):
    """Lines of a table in Markdown: the first column to the left, numbers to the right."""
    line = lambda cells: "| " + " | ".join(str(cell) for cell in cells) + " |"
    return [line(head), line(["---"] + ["---:"] * (len(head) - 1)), *map(line, rows), ""]


def ns(row, counter="particle", digits=0):
    """A time in nanoseconds, or a dash where it was not measured."""
    return "-" if row is None or counter not in row else f"{row[counter] * 1e9:.{digits}f}"


def lanes(row):
    """Neighbours, the particle itself included, among the lanes that are computed."""
    return percent((row["neighbours"] + 1) / (row["runs"] * row["width"]))


def percent(part):
    return f"{100 * part:.0f} %"


def bar_row(what, target, value, digits=2, at_most=True):
    """A row of the table of targets."""
    met = value <= target if at_most else value >= target
    return [what, f"{'at most' if at_most else 'at least'} {target:g}", f"{value:.{digits}f}", "yes" if met else "**no**"]


def bar_of_instructions(real, ratio):
    return bar_row(f"fluid in one sweep over the loop by hand, instructions, {real}", 1.03, ratio)


def all_counts(program):
    """What count_instructions.py counts, and under "threads" the rows of serial_share.py."""
    return count_instructions.counts_of(program) | {"threads": serial_share.rows_of(program)}


def section_of_instructions(build, counts):
    """Lines of the section of instructions."""
    found = counts["counts"]
    cases = sorted({name.rsplit("_", 1)[0] for name in found})
    number = lambda name: "-" if name not in found else f"{found[name]:,.{0 if found[name] >= 100 else 1}f}"
    return [
        "## Instructions", "",
        f"Per particle (kernels: per value and gradient), for AVX2 (`-O3 -march=x86-64-v3`, {counts['compiler']}); the "
        "same in every run. `tools/compare_counts.py` reports one that has grown.", "",
        f"```sh\npython3 tools/count_instructions.py {os.path.basename(os.path.normpath(build))}"
        "/benchmarks/count_instructions -o counts.json\n```", "",
        *table(["work", *REALS], [[case.replace("_", " "), *(number(f"{case}_{real}") for real in REALS)]
                                  for case in cases]),
        "## More threads", "",
        "The greatest speed-up by the share of instructions that one thread does alone (Amdahl), 8,000 particles, "
        "float. Larger scenes have a smaller share. All threads wait at the end of each parallel loop.", "",
        f"```sh\npython3 tools/serial_share.py {os.path.basename(os.path.normpath(build))}"
        "/benchmarks/count_instructions\n```", "",
        *table(serial_share.HEAD, counts["threads"])]


def write_counts(page, build, counts, commit):
    """The page with other numbers of instructions, and the commit they are of."""
    page = page[:page.index("## Instructions")] + "\n".join(section_of_instructions(build, counts)).rstrip() + "\n"
    over = compare_counts.over_by_hand(counts["counts"])
    for real in REALS:
        row = bar_of_instructions(real, over[f"fluid_loops_in_one_sweep_{real}"])
        page, found = re.subn(rf"^\| {row[0]} \|.*$", "| " + " | ".join(row) + " |", page, flags=re.MULTILINE)
        if found != 1:
            sys.exit(f"benchmark_report.py: the page has no row '{row[0]}'")
    return re.sub(r"^(- imbibe: .*?)(?:, instructions \w+)?$", rf"\1, instructions {commit}", page, flags=re.MULTILINE)


class Report:
    def __init__(self, arguments):
        self.build, self.output = arguments.build, arguments.output
        self.quick, self.commit = results.how(os.path.join(self.build, "results"))
        self.pictures = os.path.splitext(self.output)[0]
        self.rows, self.contexts = results.read(os.path.join(self.build, "results"))
        self.clang = arguments.clang
        if self.clang:
            self.rows["clang"] = results.read(os.path.join(self.clang, "results"))[0]["bench_sweep"]
        self.lines = []
        peaks = self.rows.get("peaks", {})
        self.flops = {real: row["flops"] for real in REALS for name, row in peaks.items()
                      if re.fullmatch(rf"multiply_add/{real}/\d+/1_thread", name)}
        self.bandwidth = peaks.get("triad/1_thread", {}).get("bytes")

    def get(self, program, name):
        return self.rows.get(program, {}).get(name)

    def matches(self, program, pattern):
        """(groups of the match, row) of every benchmark whose whole name fits the pattern."""
        return [(found.groups(), row) for name, row in self.rows.get(program, {}).items()
                if (found := re.fullmatch(pattern, name))]

    def section(self, title, programs, *text):
        commands = [results.command_of(self.build, program, self.quick)
                    for program in ([programs] if isinstance(programs, str) else programs)]
        self.lines += [f"## {title}", "", *text, "", "```sh", *commands, "```", ""]

    def picture(self, name, figure, caption):
        os.makedirs(self.pictures, exist_ok=True)
        save(figure, os.path.join(self.pictures, name), 150)
        self.lines += [f"![{caption}]({os.path.basename(self.pictures)}/{name})", ""]

    # ---- the sections ----

    def head(self):
        others = [context["others"] for context in self.contexts if "others" in context]
        options = (" --quick" if self.quick else "") + (" --clang build-benchmark-clang" if self.clang else "")
        presets = "presets `benchmark` and `benchmark-clang`" if self.clang else "preset `benchmark`"
        self.lines += [
            "# Speed", "",
            f"Written by `python3 tools/benchmark_report.py{options}`, with the {presets}.", "",
            f"- Processor: {results.machine()}",
            f"- Compiler: {results.compiler(self.build)}",
            f"- imbibe: {self.commit}",
            f"- Processors busy with other programs: {min(others):.2f} to {max(others):.2f}"
            if others else "- Processors busy with other programs: unknown",
            "- Times: CPU time of one thread, wall time of two; the least of "
            f"{'one repetition' if self.quick else 'five repetitions'}{self.rounds_in_words()}",
            ""]
        if others and max(others) > 0.2:
            self.lines += ["**The machine was busy: trust ratios, not the numbers themselves.**", ""]

    def rounds_in_words(self):
        rounds = len(results.files_of(os.path.join(self.build, "results"), "bench_steps"))
        return f" in each of {rounds} rounds" if rounds > 1 else ""

    def bars(self):
        """The targets of the core beside these results."""
        rows = []

        def bar(what, target, value, digits=2, at_most=True):
            if value is not None:
                rows.append(bar_row(what, target, value, digits, at_most))

        def value(program, name, counter="particle", scale=1e9):
            row = self.get(program, name)
            return row[counter] * scale if row and counter in row else None

        def ratio(a, b):
            return a / b if a and b else None

        def rate(scene):
            """Million particle-steps a second."""
            time = value("bench_steps", scene)
            return 1e3 / time if time else None

        for real, loop, solid in (("float", 110, 250), ("double", 260, 500)):
            name = f"fluid/one_sweep/{real}/26"
            bar(f"fluid in one sweep over the loop by hand, {real}", 1.1, value("bench_sweep", name, "ratio", 1))
            bar(f"the same with clang++ -ffp-contract=fast, {real}", 1.15, value("clang", name, "ratio", 1))
            bar(f"fluid in one sweep, ns per particle, {real}", loop, value("bench_sweep", name), digits=0)
            bar(f"the loop by hand, ns per particle, {real}", loop, value("bench_sweep", name, "hand"), digits=0)
            name = f"hypoelastic/{real}/26"
            bar(f"hypoelastic solid, ns per particle, {real}", solid, value("bench_sweep", name), digits=0)
            bar(f"the loops by hand, ns per particle, {real}", solid, value("bench_sweep", name, "hand"), digits=0)
        for real in REALS:
            if over := self.over_by_hand().get(f"fluid_loops_in_one_sweep_{real}"):
                rows.append(bar_of_instructions(real, over))
        moved = "neighbours/float/moved/{}/26".format
        bar("neighbours with sort, ns per particle, float", 85, value("bench_search", moved(100000)), digits=0)
        bar("nanoflann's radius search over that", 12,
            ratio(value("bench_search", "nanoflann/float/sorted/100000/26"), value("bench_search", moved(100000))),
            digits=1, at_most=False)
        bar("neighbours with sort, 1,000,000 particles over 100,000", 1.2,
            ratio(value("bench_search", moved(1000000)), value("bench_search", moved(100000))))
        bar("cube of water, million particle-steps/s, float", 4, rate("cube/float/100000/1"), at_most=False)
        bar("the same, searched in one step of four", 4, rate("cube_searched_in_1_of_4/float/100000/1"), at_most=False)
        for real, least in (("float", 4), ("double", 2.5)):
            bar(f"dam break, million particle-steps/s, {real}", least, rate(f"dam_break/{real}/100000/1"), at_most=False)
            bar("the same, searched in every step", least,
                rate(f"dam_break_searched_in_every_step/{real}/100000/1"), at_most=False)
        bar("total-Lagrangian column, its law alone, 50 neighbours, million particle-steps/s, float", 4,
            rate("column_of_law_alone/float/100000/1"), at_most=False)
        bar("the same with hourglass control and viscosity, 28 neighbours", 4, rate("column/float/100000/1"),
            at_most=False)
        stored = value("bench_steps", "cube/float/100000/1", "bytes", 1)
        runs = value("bench_steps", "cube/float/100000/1", "list_bytes", 1)
        bar("water alone, float, bytes per particle", 120, stored, digits=0)
        bar("the same with its runs", 250, stored + runs if stored and runs else None, digits=0)
        for scene in ("cube/float", "dam_break/float", "column/float"):
            bar(f"two threads over one, {scene.replace('_', ' ').replace('/', ', ')}", 1.85,
                ratio(value("bench_steps", scene + "/100000/1"), value("bench_steps", scene + "/100000/2")), at_most=False)
        for real, most in (("float", 10), ("double", 1)):
            bar(f"cube, {real}: {most},000,000 particles over 100,000, time per particle-step", 1.15,
                ratio(value("bench_steps", f"cube/{real}/{most}000000/1"), value("bench_steps", f"cube/{real}/100000/1")))
        if rows:
            self.lines += [
                "## Targets", "",
                "Targets are from prototypes on a Sapphire Rapids processor (two 512-bit units). Scenes have about "
                "100,000 particles and a support of 2.6 spacings unless the row says otherwise.", ""]
            self.lines += table(["what", "target", "measured", "met"], rows)

    def peaks(self):
        self.section("What the machine can do at most", "peaks",
                     "Multiply-adds in registers, each two operations, and a = b + s c over arrays far larger than "
                     "the caches: the peaks of the fractions below. A speed-up of multiplying below 2 means that the "
                     "two processors are not two cores, or are in use.")
        rows = []

        def row(what, pattern, counter, unit, digits=0):
            """On one thread, on two, and the second over the first."""
            rates = [found[0][1][counter] * 1e-9 if (found := self.matches("peaks", f"{pattern}/{threads}")) else None
                     for threads in ("1_thread", "2_threads")]
            rows.append([what, *(f"{rate:.{digits}f} {unit}" if rate else "-" for rate in rates),
                         f"{rates[1] / rates[0]:.2f}" if all(rates) else "-"])

        for real in REALS:
            for (width,), _ in self.matches("peaks", rf"multiply_add/{real}/(\d+)/1_thread"):
                row(f"{real}, {width} at a time", rf"multiply_add/{real}/\d+", "flops", "Gflop/s")
        row("memory", "triad", "bytes", "GB/s", 1)
        self.lines += table(["", "one thread", "two threads", "speed-up"], rows)
        reads = [(int(size), one["read"]) for (size,), one in self.matches("peaks", r"read/(\d+)")]
        if reads:
            self.lines += [
                "Latency of a read whose random place is known only from the read before. It matters for scenes larger "
                "than the caches. On a shared host it varies: repeat `bench_steps "
                "--benchmark_filter=cube/float/10000000`.", "",
                *table(["", *(f"{size} MiB" for size, _ in reads)],
                       [["latency, ns", *(f"{time * 1e9:.0f}" for _, time in reads)]])]

    def steps(self):
        def rows_of(program, pattern, size_name):
            rows = []
            for (name, real, size), one in self.matches(program, pattern + "/1"):
                two = self.get(program, f"{name}/{real}/{size}/2")
                stored = one["bytes"] + one["list_bytes"]
                rows.append([f"{name.replace('_', ' ')}{size_name(size)}, {real}", f"{one['particles']:,.0f}",
                             f"{one['working']:,.0f}", ns(one), ns(one, "moving"), f"{1e-6 / one['particle']:.2f}", ns(two),
                             f"{one['particle'] / two['particle']:.2f}" if two else "-",
                             percent(one["searched"]) if "searched" in one else "-", f"{one['neighbours']:.0f}",
                             f"{one['bytes']:.0f}", f"{one['list_bytes']:.0f}",
                             percent(stored * one["particles"] / self.bandwidth / one["working"] / one["particle"])
                             if self.bandwidth else "-"])
            return rows

        head = ["scene", "particles", "working", "ns per particle-step", "ns per moving particle", "million particle-steps/s",
                "two threads, ns", "speed-up", "steps with a search", "neighbours", "bytes per particle",
                "bytes of its runs", "memory's share"]
        self.section("Whole steps", "bench_steps",
                     "A particle-step is a step of a particle that has work: one that moves, or a wall particle with "
                     "water within reach. Memory's share is the part of the time that reading all stored data once "
                     "would take at the measured bandwidth.", "",
                     "| scene | is |", "|---|---|",
                     "| cube | water in free fall: continuity, pressure, artificial viscosity; Wendland C2, support of "
                     "2.6 spacings |",
                     "| dam break | that of the README in other sizes, its front at its greatest speed |",
                     "| column | total Lagrangian, with hourglass control, viscosity and a support of 2 spacings |",
                     "| column of law alone | total Lagrangian, support of 2.3 spacings |")
        self.lines += table(head, rows_of("bench_steps", r"(\w+)/(\w+)/(\d+)", lambda size: ""))
        figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
        for k, scene in enumerate(("cube", "dam_break", "column")):
            for real, dash in zip(REALS, DASHES):
                points = sorted((row["particles"], row["particle"] * 1e9)
                                for _, row in self.matches("bench_steps", rf"{scene}/{real}/(\d+)/1"))
                if points:
                    axes.plot(*zip(*points), dash, marker="o", ms=4, color=CURVES[k],
                              label=f"{scene.replace('_', ' ')}, {real}")
        self.finish(axes, "particles", "time per particle-step (ns)", log=True)
        self.picture("steps.png", figure, "Time per particle-step against the number of particles")

        self.section("The sponge", "bench_sponge", "Water and sponge are in contact from the start.")
        self.lines += table(head, rows_of("bench_sponge", r"(\w+)/(\w+)/(\d+)",
                                          lambda size: ", strip" if size == "1" else ", full"))

    def sweeps(self):
        self.section("Pair loops", "bench_sweep",
                     "A step without search and motion. The library runs this fluid in two sweeps (density rate, then "
                     "forces from the new density); one sweep has the same pair parts together.", "",
                     "| | |", "|---|---|",
                     "| by hand | the same work over the same runs without terms, fields and schedule |",
                     "| lanes used | share of lanes with a neighbour or the particle itself |",
                     "| of peak arithmetic | counts all lanes, and each addition, multiplication, maximum, quotient "
                     "and root as one operation |")
        rows = []
        for (kind, real, tenths), row in self.matches("bench_sweep", r"fluid/(\w+)/(\w+)/(\d+)"):
            peak = self.flops.get(real)
            reached = row["operations"] / row["particle"] / peak if kind == "one_sweep" and peak else None
            rows.append([f"fluid in {kind.replace('_', ' ')}, {real}", f"{int(tenths) / 10:.1f}",
                         f"{row['neighbours']:.0f}", ns(row), ns(row, "hand"), f"{row['ratio']:.2f}",
                         lanes(row), percent(reached) if reached else "-"])
        for (kind, real, tenths), row in self.matches("bench_sweep", r"(hypoelastic|total_lagrangian)/(\w+)/(\d+)"):
            by_hand = [ns(row, "hand"), f"{row['ratio']:.2f}", lanes(row)] if "hand" in row else ["-", "-", "-"]
            rows.append([f"{kind.replace('_', '-')} solid, {real}", f"{int(tenths) / 10:.1f}",
                         f"{row['neighbours']:.0f}", ns(row), *by_hand, "-"])
        self.lines += table(["loops", "support in spacings", "neighbours", "ns per particle", "by hand, ns",
                             "library / by hand", "lanes used", "of peak arithmetic"], rows)
        figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
        for k, real in enumerate(REALS):
            found = self.matches("bench_sweep", rf"fluid/one_sweep/{real}/(\d+)")
            sweeps = [(row["neighbours"], row) for _, row in found]
            near = {tenths: row["neighbours"] for (tenths,), row in found}
            search = [(near[tenths], row) for (tenths,), row in
                      self.matches("bench_search", rf"find_runs/{real}/sorted/100000/(\d+)") if tenths in near]
            for points, counter, dash, label in ((sweeps, "particle", "-", "pair loop"),
                                                 (sweeps, "hand", ":", "by hand"),
                                                 (search, "particle", "--", "search")):
                axes.plot([x for x, _ in points], [row[counter] * 1e9 for _, row in points], dash, marker="o", ms=4,
                          color=CURVES[k], label=f"{label}, {real}")
        self.finish(axes, "neighbours", "time per particle (ns)")
        axes.set_xlim(left=0)
        self.picture("neighbours.png", figure, "Time per particle against the number of neighbours")

    def search(self):
        self.section("Neighbours", "bench_search",
                     "One thread. *Moved* points were sorted one step ago.", "",
                     "| operation | is |", "|---|---|",
                     "| sort | grid and counting sort; for sorted points, finding that they are sorted |",
                     "| reorder | of one stored number |",
                     "| neighbours | sort, reordering of three coordinates, and runs |",
                     "| nanoflann | lists each neighbour separately, from the same points |")
        rows = []
        for (what, order, size, tenths), single in self.matches(
                "bench_search", r"(sort|reorder|find_runs|neighbours|nanoflann)/float/(\w+)/(\d+)/(\d+)"):
            double = self.get("bench_search", f"{what}/double/{order}/{size}/{tenths}")
            rows.append([f"{what.replace('_', ' ')}, {order}", f"{int(size):,}", f"{int(tenths) / 10:.1f}",
                         ns(single, digits=1), ns(double, digits=1),
                         f"{single['runs']:.1f}" if "runs" in single else "-",
                         f"{double['runs']:.1f}" if double and "runs" in double else "-"])
        self.lines += table(["operation, order of the points", "particles (about)", "support in spacings",
                             "float, ns per particle", "double, ns per particle", "runs, float", "runs, double"], rows)
        figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
        for k, order in enumerate(("sorted", "moved", "shuffled")):
            for real, dash in zip(REALS, DASHES):
                points = sorted((int(size), row["particle"] * 1e9) for (size,), row in
                                self.matches("bench_search", rf"neighbours/{real}/{order}/(\d+)/26"))
                if points:
                    axes.plot(*zip(*points), dash, marker="o", ms=4, color=CURVES[k], label=f"{order}, {real}")
        self.finish(axes, "particles", "search per particle (ns)", log=True)
        self.picture("search.png", figure, "Time of the search per particle against the number of particles")

    def terms(self):
        self.section("Terms one by one", "bench_terms",
                     "Single pair terms in a sweep, float, support of 2.6 spacings. Each number includes positions, "
                     "distance and runs, so they do not add up. [Effects](effects.md) has terms as parts of a step.")
        self.lines += table(["term", "ns per particle", "ns per neighbour"],
                            [[name, ns(row), ns(row, "neighbour", 2)]
                             for name, row in self.rows.get("bench_terms", {}).items()])

    def kernels(self):
        self.section("Kernels one by one", "bench_kernels",
                     "ns, one number at a time or in packs of the machine's width.")
        rows = {}
        for (kernel, what, real, width), row in self.matches("bench_kernels", r"(.+)/(\w+)/(\w+)/(\d+)"):
            rows.setdefault((kernel, what), {})[real, width == "1"] = ns(row, "evaluation", 2)
        columns = [(real, single) for real in REALS for single in (True, False)]
        self.lines += table(["kernel", *(f"{real}, {'one' if single else 'packs'}" for real, single in columns)],
                            [[f"{kernel}, {what}", *(cells.get(column, "-") for column in columns)]
                             for (kernel, what), cells in rows.items()])

    def widths(self):
        programs = [name for name in ("bench_widths_sse2", "bench_widths_avx2", "bench_widths_avx512")
                    if name in self.rows]
        if not programs:
            return
        self.section("Pack widths", programs,
                     "The fluid in two sweeps, 100,000 particles.")
        found = {(what, real, int(width)): row for name in programs
                 for (what, real, width), row in self.matches(name, r"(\w+)/(\w+)/(\d+)")}
        parts = ("search", "loops", "step")
        self.lines += table(["numbers at once", *(f"{what}, ns per particle" for what in parts)],
                            [[f"{width}, {real}", *(ns(found.get((what, real, width))) for what in parts)]
                             for real in REALS for width in sorted({w for _, r, w in found if r == real})])
        figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
        for k, what in enumerate(("step", "loops", "search")):
            for real, dash in zip(REALS, DASHES):
                points = sorted((w, row["particle"] * 1e9) for (x, r, w), row in found.items()
                                if (x, r) == (what, real))
                axes.plot(*zip(*points), dash, marker="o", ms=4, color=CURVES[k], label=f"{what}, {real}")
        self.finish(axes, "numbers computed at once", "time per particle (ns)")
        axes.set_xscale("log", base=2)
        axes.set_xticks(sorted({w for _, _, w in found}), [str(w) for w in sorted({w for _, _, w in found})])
        self.picture("widths.png", figure, "Time per particle against the width of packs")

    def over_by_hand(self):
        path = os.path.join(self.build, "results", "counts.json")
        if not os.path.exists(path):
            return {}
        with open(path) as file:
            return compare_counts.over_by_hand(json.load(file)["counts"])

    def counts(self):
        path = os.path.join(self.build, "results", "counts.json")
        if not os.path.exists(path):
            return
        with open(path) as file:
            counts = json.load(file)
        self.lines += section_of_instructions(self.build, counts)

    @staticmethod
    def finish(axes, x, y, log=False):
        if log:
            axes.set_xscale("log")
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        axes.set_ylim(bottom=0)
        axes.grid(True)
        axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))

    def write(self):
        for part in (self.head, self.bars, self.peaks, self.steps, self.sweeps, self.search, self.terms, self.kernels,
                     self.widths, self.counts):
            part()
        os.makedirs(os.path.dirname(os.path.abspath(self.output)), exist_ok=True)
        with open(self.output, "w") as file:
            file.write("\n".join(self.lines).rstrip() + "\n")
        print(f"wrote {self.output} and {self.pictures}/")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build-benchmark", help="the build folder (default: build-benchmark)")
    parser.add_argument("--clang", metavar="BUILD", help="build folder of the preset benchmark-clang, for one row more")
    parser.add_argument("--output", default=os.path.join(ROOT, "docs", "speed.md"), help="default: docs/speed.md")
    parser.add_argument("--quick", action="store_true", help="short and rough")
    parser.add_argument("--rounds", type=int, default=1, metavar="N",
                        help="measure all N times and take the best: other work on the machine comes and goes")
    parser.add_argument("--more", action="store_true", help="add to the stored results instead of forgetting them")
    parser.add_argument("--only", metavar="NAME", action="append",
                        help="with --more: this program again, such as bench_sweep, and none but those named so")
    parser.add_argument("--reuse", action="store_true", help="write the report from stored results")
    parser.add_argument("--counts", action="store_true", help="count instructions only, and write these into the page")
    arguments = parser.parse_args()
    if arguments.only and not arguments.more:
        parser.error("--only adds to stored results: it needs --more")
    folder = os.path.join(arguments.build, "results")
    program = os.path.abspath(os.path.join(arguments.build, "benchmarks", "count_instructions"))
    if arguments.counts:
        with open(arguments.output) as file:
            page = file.read()
        page = write_counts(page, arguments.build, all_counts(program), results.commit())
        with open(arguments.output, "w") as file:
            file.write(page)
        print(f"wrote {arguments.output}")
        return
    if not arguments.reuse:
        clang_folder = os.path.join(arguments.clang, "results") if arguments.clang else None
        for found in (folder, clang_folder) if not arguments.more else ():
            if found:
                results.clear(found)
        for _ in range(arguments.rounds):
            for name in arguments.only or [None]:
                results.run(arguments.build, folder, arguments.quick, name)
            if arguments.clang and "bench_sweep" in (arguments.only or ["bench_sweep"]):
                results.run(arguments.clang, clang_folder, arguments.quick, "bench_sweep")
        if not arguments.only:
            print("count_instructions ...", flush=True)
            counts = all_counts(program)
            with open(os.path.join(folder, "counts.json"), "w") as file:
                json.dump(counts, file, indent=4)
    Report(arguments).write()


if __name__ == "__main__":
    sys.exit(main())
