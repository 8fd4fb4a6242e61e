#!/usr/bin/env python3
"""Puts runs of the scenes of docs/peers.md by several codes side by side, as tables in Markdown.

    build-benchmark/benchmarks/peers_dam_break float > reports/imbibe.json
    python3 tools/compare_peers.py reports/*.json
    python3 tools/compare_peers.py reports/*.json --at-error 0.05     also what that error costs, between two spacings
    python3 tools/compare_peers.py reports/imbibe_*.json --write docs/peers.md     into the page, between its marks

A report is a file of JSON. The programs of benchmarks/peers/ print it. For another code one writes it by hand, with the
names that docs/peers.md lists; "log" may name the code's own output, beside the report, and "format" whose it is
(dualsphysics, sphinxsys, pysph, trixi). What the report lacks is then read there.
"""

import argparse
import json
import math
import os
import re
import sys

from marked_tables import with_table
from tool_errors import end_with, read_text, write_text

# What is measured of each scene, and the reference: docs/peers.md says where it is from.
SCENES = {"dam_break": ("Dam break", (0.8801, 1.2085)),
          "column": ("Column", (0.012111, 0.070273)),
          "elastic_gate": ("Elastic gate", (0.0340, 0.0440, 0.0464))}
PRECISIONS = ("float", "double", "mixed")
WHOLE, ABOVE_ZERO = ("threads", "steps"), ("spacing", "moving", "all", "simulated_s", "wall_s")
OPTIONAL = ("working", "neighbours", "cpu_s", "peak_bytes")
NAMES = {"scene", "code", "version", "precision", "measured", "log", "format", *WHOLE, *ABOVE_ZERO, *OPTIONAL}
NUMBER = r"([\d.]+(?:[eE][-+]?\d+)?)"


# ---- what the logs of other codes say ----

def last(pattern, text, number=float):
    """The number in the last match of a pattern, without commas between thousands; None without a match."""
    found = re.findall(pattern, text, re.MULTILINE)
    return number(found[-1].replace(",", "")) if found else None


def of_dualsphysics(text):
    """Run.out."""
    whole = lambda name: last(rf"^{name}\.*: *([\d,]+)", text, int)
    seconds = last(r"^Simulation Runtime\.*: *" + NUMBER, text)
    each = last(r"^Runtime per physical second\.*: *" + NUMBER, text)
    return {"version": (re.findall(r"\bv(5[.\d]+)", text) or [None])[0], "steps": whole("Steps of simulation"),
            "wall_s": seconds, "simulated_s": seconds / each if seconds and each else None,
            "threads": last(r"OpenMP\(Threads:(\d+)\)", text, int) or (1 if "Single core" in text else None),
            "moving": last(r"^CaseNfluid=([\d,]+)", text, int), "all": last(r"^CaseNp=([\d,]+)", text, int),
            "peak_bytes": whole("CPU Memory")}


def of_sphinxsys(text):
    """What the program prints. Its N counts the steps of advection, which are not those of the sums."""
    return {"wall_s": last(r"Total wall time for computation: *" + NUMBER, text)}


def of_pysph(text):
    """The log, or the file .info."""
    if text.lstrip().startswith("{"):
        try:
            told = json.loads(text)
        except ValueError:
            return {}
        return {"wall_s": told.get("cpu_time") if told.get("completed") else None}  # a wall time, whatever its name
    return {"wall_s": last(r"Run took: *" + NUMBER, text)}


def of_trixi(text):
    """What an InfoCallback prints: steps and times of its last line."""
    found = re.findall(r"#timesteps: *(\d+) .*?sim\. time: *" + NUMBER + r" .*?run time: *" + NUMBER, text)
    steps, simulated, wall = found[-1] if found else (None, None, None)
    return {"steps": steps and int(steps), "simulated_s": simulated and float(simulated),
            "wall_s": wall and float(wall), "threads": last(r"#threads:[ .…]*(\d+)", text, int)}


LOGS = {"dualsphysics": of_dualsphysics, "sphinxsys": of_sphinxsys, "pysph": of_pysph, "trixi": of_trixi}


# ---- reports ----

def wrong(path, name, value, allowed, remedy):
    shown = "missing" if value is None else json.dumps(value)
    end_with(f"{path}: '{name}' is {shown}; it must be {allowed}. {remedy}")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def read_report(path):
    """A report, completed from its log and checked."""
    try:
        report = json.loads(read_text(path))
    except ValueError as error:
        end_with(f"{path} is no JSON: {error}. Give the reports; a log is named in one as \"log\"")
    if not isinstance(report, dict):
        end_with(f"{path} holds no report: it must be one object {{...}} with the names that docs/peers.md lists")
    for name in sorted(set(report) - NAMES):
        end_with(f"{path}: '{name}' is unknown; known are {', '.join(sorted(NAMES))}")
    if "log" in report:
        if report.get("format") not in LOGS:
            wrong(path, "format", report.get("format"), f"one of {', '.join(LOGS)}", "It says whose log it is.")
        log = os.path.join(os.path.dirname(path), str(report["log"]))
        for name, value in LOGS[report["format"]](read_text(log)).items():
            if value is not None:
                report.setdefault(name, value)
    check(path, report)
    return report


def check(path, report):
    """Ends the program at the first entry that is missing or wrong."""
    there = "Write it into the report" + (", because its log does not say it." if "log" in report else ".")
    for name, known in (("scene", SCENES), ("precision", PRECISIONS)):
        if report.get(name) not in known:
            wrong(path, name, report.get(name), f"one of {', '.join(known)}", there)
    for name in ("code", "version"):
        if not isinstance(report.get(name), str) or not re.fullmatch(r"[^|\n]+", report[name]):
            wrong(path, name, report.get(name), "a text on one line without '|'", there)
    for name in WHOLE:
        if not is_number(report.get(name)) or report[name] < 1 or report[name] != int(report[name]):
            wrong(path, name, report.get(name), "a whole number above 0", there)
    for name in ABOVE_ZERO:
        if not is_number(report.get(name)) or report[name] <= 0:
            wrong(path, name, report.get(name), "a number above 0", there)
    for name in OPTIONAL:
        if name in report and (not is_number(report[name]) or report[name] <= 0):
            wrong(path, name, report[name], "a number above 0", "Leave it out if it is not known.")
    if report["all"] < report["moving"]:
        wrong(path, "all", report["all"], f"{report['moving']:g} or more", "It counts the moving particles too.")
    if "working" in report and not report["moving"] <= report["working"] <= report["all"]:
        wrong(path, "working", report["working"], f"from {report['moving']:g} to {report['all']:g}",
              "It counts the moving particles, and those of walls that have others within reach.")
    measured, wanted = report.get("measured"), len(SCENES[report["scene"]][1])
    if not isinstance(measured, list) or len(measured) != wanted or not all(map(is_number, measured)):
        wrong(path, "measured", measured, f"a list of {wanted} numbers", "docs/peers.md says which.")


def add_costs(report, references):
    """What is shown of a report."""
    cpu = report["threads"] == 1 and "cpu_s" in report
    report["clock"], report["seconds"] = ("CPU", report["cpu_s"]) if cpu else ("wall", report["wall_s"])
    deviations = [m / r - 1 for m, r in zip(report["measured"], references[report["scene"]])]
    report["error"] = math.sqrt(sum(d * d for d in deviations) / len(deviations))
    report["ms"] = report["seconds"] / report["simulated_s"]  # ms a simulated ms
    for count in ("moving", "all"):
        report[f"step_{count}"] = 1e9 * report["seconds"] / report["steps"] / report[count]
        report[f"ms_{count}"] = 1e6 * report["ms"] / report[count]  # ns a particle and simulated ms
        report[f"bytes_{count}"] = report["peak_bytes"] / report[count] if "peak_bytes" in report else None
    return report


def quickest(reports):
    """Of repeated runs the one that took least time."""
    best = {}
    for report in reports:
        key = tuple(report[name] for name in ("scene", "code", "version", "precision", "threads", "spacing"))
        if key not in best or report["seconds"] < best[key]["seconds"]:
            best[key] = report
    return list(best.values())


def same_kind(one, other):
    """May these two be compared: scene, threads, precision? Mixed precision is held against float."""
    plain = lambda report: "float" if report["precision"] == "mixed" else report["precision"]
    return one["scene"] == other["scene"] and one["threads"] == other["threads"] and plain(one) == plain(other)


def ours(reports, report):
    """The report of imbibe that a report is held against; None without one."""
    return next((it for it in reports if it["code"] == "imbibe" and same_kind(it, report) and
                 abs(it["spacing"] / report["spacing"] - 1) < 0.02), None)


# ---- tables ----

def table(head, rows, words):
    """Lines of a table in Markdown; the first `words` columns are text."""
    line = lambda cells: "| " + " | ".join(cells) + " |"
    return [line(head), line(["---"] * words + ["---:"] * (len(head) - words)), *map(line, rows), ""]


def both(report, name):
    """A number for the moving particles alone and one for all."""
    values = [report[f"{name}_{count}"] for count in ("moving", "all")]
    return "-" if None in values else " / ".join(f"{value:,.0f}" for value in values)


def times(report, base, names):
    return "-" if base is None else " / ".join(f"{report[name] / base[name]:.2f}" for name in names)


def table_of_scene(scene, reports):
    head = ["code", "precision", "clock", "threads", "spacing, mm", "particles", "neighbours", "steps",
            "ns a particle-step", "ns a particle and simulated ms", "bytes a particle", "error",
            "times imbibe, a step", "times imbibe, a simulated ms"]
    rows = []
    order = lambda it: (it["code"] != "imbibe", it["code"], it["spacing"], it["precision"], it["threads"])
    for it in sorted((it for it in reports if it["scene"] == scene), key=order):
        base = ours(reports, it)
        rows.append([f"{it['code']} {it['version']}", it["precision"], it["clock"], f"{it['threads']:.0f}",
                     f"{1e3 * it['spacing']:.3g}", f"{it['moving']:,.0f} / {it['all']:,.0f}",
                     f"{it['neighbours']:.0f}" if "neighbours" in it else "-", f"{it['steps']:,.0f}",
                     both(it, "step"), both(it, "ms"), both(it, "bytes"), f"{100 * it['error']:.1f} %",
                     times(it, base, ("step_moving", "step_all")), times(it, base, ("ms_moving", "ms_all"))])
    return [f"{SCENES[scene][0]}:", "", *table(head, rows, 3)] if rows else []


def at_error(reports, error):
    """What a code costs where its error is `error`, by a power law between the two spacings around it: {name: number},
    or None if the error is not between those of two of its spacings."""
    points = sorted(reports, key=lambda it: it["spacing"])
    for fine, coarse in zip(points, points[1:]):
        low, high = sorted((fine["error"], coarse["error"]))
        if low <= error <= high and low < high:
            share = math.log(error / fine["error"]) / math.log(coarse["error"] / fine["error"])
            return {name: fine[name] * (coarse[name] / fine[name]) ** share
                    for name in ("spacing", "moving", "ms", "ms_moving")}
    return None


def table_at_error(reports, error):
    groups = {}
    for it in reports:
        groups.setdefault((it["scene"], it["code"], it["version"], it["precision"], it["threads"]), []).append(it)
    found = [({**group[0], **cost}) for group in groups.values() if (cost := at_error(group, error))]
    head = ["scene", "code", "precision", "threads", "spacing, mm", "ms a simulated ms",
            "ns a particle and simulated ms", "times imbibe"]
    rows = []
    for it in sorted(found, key=lambda it: (it["scene"], it["code"] != "imbibe", it["code"], it["precision"])):
        base = next((other for other in found if other["code"] == "imbibe" and same_kind(other, it)), None)
        rows.append([SCENES[it["scene"]][0], f"{it['code']} {it['version']}", it["precision"], f"{it['threads']:.0f}",
                     f"{1e3 * it['spacing']:.3g}", f"{it['ms']:.3g}", f"{it['ms_moving']:,.0f}",
                     times(it, base, ("ms",))])
    if not rows:
        end_with(f"--at-error {error:g} lies between the errors of no two spacings of one code; give reports of a "
                 "coarser and a finer run, or another error")
    return [f"At an error of {100 * error:g} %:", "", *table(head, rows, 3)]


def reference(text):
    """The type of --reference: SCENE=NUMBER,..."""
    scene, _, numbers = text.partition("=")
    try:
        values = tuple(float(number) for number in numbers.split(","))
    except ValueError:
        values = ()
    if scene not in SCENES or len(values) != len(SCENES[scene][1]) or not all(value > 0 for value in values):
        raise argparse.ArgumentTypeError(f"'{text}' must be SCENE=NUMBER,..., with as many numbers above 0 as are "
                                         "measured: " + ", ".join(f"{it} {len(SCENES[it][1])}" for it in SCENES))
    return scene, values


def share(text):
    """The type of --at-error."""
    try:
        value = float(text)
    except ValueError:
        value = 0
    if not 0 < value < 1:
        raise argparse.ArgumentTypeError(f"'{text}' must be a number above 0 and below 1, such as 0.05")
    return value


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reports", nargs="+", metavar="REPORT", help="a file of JSON")
    parser.add_argument("--at-error", type=share, metavar="SHARE", help="compare costs where the error is so large")
    parser.add_argument("--reference", type=reference, action="append", default=[], metavar="SCENE=NUMBER,...",
                        help="another reference for what is measured of a scene")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("-o", "--output", metavar="FILE", help="write the tables there instead of printing them")
    where.add_argument("--write", metavar="PAGE",
                       help="write them into the page, between the marks of the table 'peers'")
    arguments = parser.parse_args()
    references = {scene: values for scene, (_, values) in SCENES.items()} | dict(arguments.reference)
    reports = quickest([add_costs(read_report(path), references) for path in arguments.reports])
    lines = [line for scene in SCENES for line in table_of_scene(scene, reports)]
    if arguments.at_error:
        lines += table_at_error(reports, arguments.at_error)
    text = "\n".join(lines)
    if arguments.write:
        page = read_text(arguments.write)
        write_text(arguments.write, with_table(page, "peers", "tools/compare_peers.py", text))
    elif arguments.output:
        write_text(arguments.output, text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
