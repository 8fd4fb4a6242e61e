#!/usr/bin/env python3
"""Has tools/compare_peers.py read made-up reports and logs, and compares what it writes with numbers worked out here.

    python3 tests/peers/compare_peers.py
"""

import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
TOOL = os.path.join(ROOT, "tools", "compare_peers.py")

# 1000 moving particles of 4000, 500 steps, 0.2 s: at 1 s of CPU 2000 ns a step and moving particle, 500 of all; 5000
# and 1250 ns a simulated ms.
DAM = {"scene": "dam_break", "code": "imbibe", "version": "9.9.9", "precision": "float", "threads": 1, "spacing": 0.01,
       "moving": 1000, "working": 2000, "all": 4000, "neighbours": 70, "steps": 500, "simulated_s": 0.2, "wall_s": 1.5,
       "cpu_s": 1.0, "peak_bytes": 400000, "measured": [0.7, 1.1]}
REFERENCE = ["--reference", "dam_break=0.7,1.0"]  # an error of sqrt((0 + 0.1^2)/2) = 7.07 %

RUN_OUT = """DualSPHysics5 v5.4.001 (made up)
CaseNp=4,000
CaseNbound=3,000
CaseNfluid=1,000
RunMode="Single core"
[Simulation finished  made up]
Total Runtime....................: 9.000000 sec.
Simulation Runtime...............: 6.000000 sec.
Runtime per physical second......: 30.000000 sec.
Steps of simulation..............: 1,500
CPU Memory.......................: 2,000,000 (1.91 MiB)
"""
SPHINXSYS = "N=100 Time = 0.1 Dt = 0.001 dt = 0.0002\nTotal wall time for computation: 8.000000000 seconds.\n"
PYSPH_LOG = "INFO|made up|Run took: 12.00000 secs\n"
PYSPH_INFO = json.dumps({"fname": "dam", "completed": True, "cpu_time": 12.0})
TRIXI = """│ #threads: ………………………………………… 2                                       │
#timesteps:    100 │ Δt: 1.0000e-04 │ sim. time: 1.0000e-02 (5.000%)      │ run time: 4.0000e-01 s
#timesteps:   2000 │ Δt: 1.0000e-04 │ sim. time: 2.0000e-01 (100.000%)    │ run time: 1.0000e+01 s
"""


class Folder:
    def __init__(self, path):
        self.path = path

    def write(self, name, content):
        path = os.path.join(self.path, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return path


def run(*arguments, fails=None):
    """What the tool prints; with `fails`, what it must say when it ends with 1 or 2."""
    done = subprocess.run([sys.executable, TOOL, *arguments], text=True, capture_output=True)
    if fails is not None:
        for part in [fails] if isinstance(fails, str) else fails:
            check(done.returncode in (1, 2) and part in done.stderr and "Traceback" not in done.stderr,
                  f"expected '{part}', got {done.returncode}: {done.stderr}")
        return None
    check(done.returncode == 0, f"ended with {done.returncode}: {done.stderr}")
    return done.stdout


def check(holds, message):
    if not holds:
        sys.exit(f"compare_peers.py: {message}")


def rows(text):
    """The rows of all tables as {head: cell}."""
    found, head = [], None
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else None
        if cells is None:
            head = None
        elif head is None:
            head = cells
        elif not cells[0].startswith("---"):
            check(len(cells) == len(head), f"a row of another length than its head: {line}")
            found.append(dict(zip(head, cells)))
    return found


def expect(row, **wanted):
    names = {"code": "code", "clock": "clock", "particles": "particles", "step": "ns a particle-step",
             "ms": "ns a particle and simulated ms", "bytes": "bytes a particle", "error": "error", "steps": "steps",
             "times_step": "times imbibe, a step", "times_ms": "times imbibe, a simulated ms", "threads": "threads",
             "precision": "precision"}
    for name, value in wanted.items():
        check(row[names[name]] == value, f"{names[name]} is '{row[names[name]]}', not '{value}', in {row}")


def peer(code, log, format, **more):
    """A report of another code that leaves to its log what that says."""
    kept = {name: DAM[name] for name in ("scene", "threads", "spacing", "moving", "all", "measured")}
    return {**kept, "code": code, "version": "1", "precision": "double", "log": log, "format": format, **more}


def main():
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(path)
        ours = folder.write("ours.json", DAM)
        double = folder.write("double.json", {**DAM, "precision": "double", "cpu_s": 2.0})
        two = folder.write("two.json", {**DAM, "precision": "double", "threads": 2})  # a wall time of 1.5 s

        [row] = rows(run(ours, *REFERENCE))
        expect(row, code="imbibe 9.9.9", clock="CPU", particles="1,000 / 4,000", step="2,000 / 500", ms="5,000 / 1,250",
               bytes="400 / 100", error="7.1 %", times_step="1.00 / 1.00", times_ms="1.00 / 1.00")
        expect(rows(run(two, *REFERENCE))[0], clock="wall", step="3,000 / 750")
        expect(rows(run(ours, "--reference", "dam_break=0.35,0.55"))[0], error="100.0 %")

        # Of repeated runs the quickest counts.
        slow = folder.write("slow.json", {**DAM, "cpu_s": 7.0})
        check(rows(run(slow, ours, *REFERENCE)) == [row], "the quicker of two runs does not count")

        # DualSPHysics: 6 s, 1500 steps, 0.2 s simulated; mixed precision is held against float.
        folder.write("Run.out", RUN_OUT)
        told = {name: value for name, value in peer("DualSPHysics", "Run.out", "dualsphysics").items()
                if name not in ("moving", "all", "threads", "version")}
        dual = folder.write("dual.json", {**told, "precision": "mixed"})
        mine, its = rows(run(dual, ours, double, *REFERENCE))[0], rows(run(dual, ours, double, *REFERENCE))[2]
        expect(mine, code="imbibe 9.9.9")
        expect(its, code="DualSPHysics 5.4.001", clock="wall", threads="1", steps="1,500", step="4,000 / 1,000",
               ms="30,000 / 7,500", bytes="2,000 / 500", times_step="2.00 / 2.00", times_ms="6.00 / 6.00")
        expect(rows(run(dual, double, *REFERENCE))[1], times_step="-", times_ms="-")

        # SPHinXsys, PySPH: wall time from the log, all else from the report. Other numbers of wall particles show.
        folder.write("sphinxsys.txt", SPHINXSYS)
        sphinxsys = folder.write("sphinxsys.json", peer("SPHinXsys", "sphinxsys.txt", "sphinxsys", steps=1000,
                                                        simulated_s=0.2, all=8000))
        expect(rows(run(sphinxsys, double, *REFERENCE))[1], step="8,000 / 1,000", ms="40,000 / 5,000", bytes="-",
               times_step="2.00 / 1.00", times_ms="4.00 / 2.00", precision="double")
        for name, content in (("pysph.log", PYSPH_LOG), ("pysph.info", PYSPH_INFO)):
            folder.write(name, content)
            pysph = folder.write("pysph.json", peer("PySPH", name, "pysph", steps=1000, simulated_s=0.2))
            expect(rows(run(pysph, *REFERENCE))[0], step="12,000 / 3,000", times_step="-")
        folder.write("pysph.info", json.dumps({"completed": False, "cpu_time": 0}))
        run(pysph, fails="'wall_s' is missing; it must be a number above 0. Write it into the report, because its log")

        # TrixiParticles: the last line of progress; the threads are told as well.
        folder.write("trixi.txt", TRIXI)
        told = peer("TrixiParticles", "trixi.txt", "trixi")
        trixi = folder.write("trixi.json", {name: value for name, value in told.items() if name != "threads"})
        expect(rows(run(trixi, two, *REFERENCE))[1], threads="2", steps="2,000", step="5,000 / 1,250",
               ms="50,000 / 12,500", times_ms="6.67 / 6.67")

        # Costs at one error: twice the spacing has four times the error and an eighth of the cost, so at twice the
        # error of the finer run the spacing is sqrt(2) as large, and the cost sqrt(8) times less.
        fine = folder.write("fine.json", {**DAM, "cpu_s": 8.0, "measured": [0.7 * 1.02, 1.02]})
        coarse = folder.write("coarse.json", {**DAM, "spacing": 0.02, "measured": [0.7 * 1.08, 1.08]})
        last = rows(run(fine, coarse, "--at-error", "0.04", *REFERENCE))[-1]
        check((last["spacing, mm"], last["ms a simulated ms"], last["times imbibe"]) == ("14.1", "14.1", "1.00"),
              f"at an error of 4 %: {last}")
        run(fine, coarse, "--at-error", "0.5", *REFERENCE, fails="lies between the errors of no two spacings")

        # Into a page, and into a file.
        page = folder.write("page.md", "# A page\n\n<!-- peers: begin. Written by tools/compare_peers.py. -->\nold\n"
                                       "<!-- peers: end -->\nend\n")
        run(ours, "--write", page, *REFERENCE)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        check(rows(text) == [row] and "old" not in text and text.startswith("# A page") and text.endswith("end\n"),
              f"the page is not as it should be: {text}")
        output = os.path.join(path, "table.md")
        run(ours, "-o", output, *REFERENCE)
        with open(output, encoding="utf-8") as file:
            check(rows(file.read()) == [row], "the file has another table than what is printed")

        # What is wrong is named, with what is allowed.
        def fails(said, **entries):
            report = {name: value for name, value in {**DAM, **entries}.items() if value != "left out"}
            run(folder.write("wrong.json", report), fails=["wrong.json: ", said])

        fails("'scene' is \"dam\"; it must be one of dam_break, column, elastic_gate", scene="dam")
        fails("'precision' is \"half\"; it must be one of float, double, mixed", precision="half")
        fails("'steps' is missing; it must be a whole number above 0. Write it into the report.", steps="left out")
        fails("'steps' is 1.5; it must be a whole number above 0", steps=1.5)
        fails("'wall_s' is -1; it must be a number above 0", wall_s=-1)
        fails("'all' is 10; it must be 1000 or more", all=10)
        fails("'working' is 5000; it must be from 1000 to 4000", working=5000)
        fails("'peak_bytes' is \"much\"; it must be a number above 0. Leave it out", peak_bytes="much")
        fails("'measured' is [1]; it must be a list of 2 numbers", measured=[1])
        fails("'code' is \"a|b\"; it must be a text on one line", code="a|b")
        fails("'wall' is unknown; known are all, code, cpu_s", wall=1)
        fails("'format' is \"gadget\"; it must be one of dualsphysics, sphinxsys, pysph, trixi", log="a",
              format="gadget")
        run(folder.write("peer.json", peer("PySPH", "nowhere.log", "pysph")), fails=["cannot read", "nowhere.log"])
        run(folder.write("log.txt", RUN_OUT), fails="is no JSON")
        run(folder.write("list.json", [1]), fails="holds no report")
        run(os.path.join(path, "nowhere.json"), fails="cannot read")
        run(ours, "--at-error", "2", fails="must be a number above 0 and below 1")
        run(ours, "--reference", "dam_break=1", fails="with as many numbers above 0 as are measured: dam_break 2")
    print("compare_peers.py writes what it should")


main()
