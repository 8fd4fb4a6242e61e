#!/usr/bin/env python3
"""Runs the sponge for a few steps and looks at all it leaves: what it says, its table, its files for ParaView (read by
VTK itself), its pictures. Then with steps that are far too long, after which it must go on from where it was good. Then
gives it options it must refuse, before it has written anything.

    python3 tests/output/run_sponge.py build/sponge
"""
import csv
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    sys.exit(f"{missing.name} is missing; install python3-vtk9")

SPONGE = sys.argv[1]


def check(condition, *words):
    if not condition:
        sys.exit(" ".join(str(word) for word in ("run_sponge: FAILED:", *words)))


def run(*options):
    done = subprocess.run([SPONGE, *map(str, options)], capture_output=True, text=True, timeout=1500)
    return done.returncode, done.stdout + done.stderr


def check_good_run(folder):
    code, said = run("--quick", "--end", 0.004, "--snapshots", 1, "--threads", 1, "--output", folder)
    check(code == 0, "exit status", code, said)
    for words in ("Scene in 3D, float", "effects:", "bytes each", "Schedule:", "Neighbours:", "Time step:",
                  "Expected wall time", "Pores: porosity", "M particle-steps/s", "Summary (sound composition",
                  "all accounted for"):
        check(words in said, f"'{words}' is not in what it said:\n{said}")

    with open(folder / "sponge.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for column in ("time [s]", "mean displacement [m]", "drained mass [kg]", "kinetic energy of the water [J]",
                   "elastic energy of the sponge [J]", "momentum along x [kg m/s]", "momentum along z [kg m/s]",
                   "greatest density of the water [kg/m^3]", "time step [s]"):
        check(column in rows[0], f"no column '{column}' in", list(rows[0]))
    check(float(rows[0]["time [s]"]) == 0 and abs(float(rows[-1]["time [s]"]) - 0.004) < 1e-4, "times", rows[0], rows[-1])
    check(rows[1]["what limits the time step"] == "elastic wave, Sponge", "limit", rows[1])
    # nothing touches yet: the water's momentum is its weight times the time, and the sponge is held
    fallen = float(rows[-1]["kinetic energy of the water [J]"])
    check(fallen > 0, "the water does not fall")
    check(float(rows[-1]["momentum along z [kg m/s]"]) < 0, "the water falls upwards")

    for phase in ("water", "sponge", "vessel"):
        entries = list(ElementTree.parse(folder / f"{phase}.pvd").iter("DataSet"))
        check(len(entries) == 5, phase, "has", len(entries), "snapshots, not 5")
        counts = set()
        for entry in entries:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(folder / entry.get("file")))
            reader.Update()
            check(reader.GetErrorCode() == 0, entry.get("file"), "error", reader.GetErrorCode())
            counts.add(reader.GetOutput().GetNumberOfPoints())
        check(len(counts) == 1 and counts.pop() > 1000, phase, "has lost particles, or has few")

    for picture in ("snapshots.png", "displacement.png", "drained.png"):
        content = (folder / picture).read_bytes()
        check(content.startswith(b"\x89PNG") and len(content) > 10000, picture, "is no picture")


def check_stopped_by_its_guard(folder):
    """Steps that are too long end in a clear word, with the offending state and a good one on disk."""
    common = ["--quick", "--snapshots", 0, "--threads", 1, "--output", folder]
    code, said = run(*common, "--cfl", 2, "--end", 0.1)
    check(code > 0, "steps far too long: exit status", code, said)
    check("broken" in said and "--restart goes on" in said and "--cfl" in said, "steps far too long:", said)
    check(any((folder / "broken").iterdir()), "no offending state in", folder / "broken")
    code, said = run(*common, "--cfl", 0.5, "--end", 0.002, "--restart")
    check(code == 0 and "all accounted for" in said, "going on with shorter steps:", code, said)


def check_refused(root, expected, *options):
    """Refused with these words, by a status that is not 0, before a folder is made."""
    folder = root / "refused"
    code, said = run("--output", folder, *options)
    check(code not in (0, None) and code > 0, options, "gave the status", code)
    check(all(words in said for words in expected), options, "said:", said)
    check(not folder.exists(), options, "left a folder")


with tempfile.TemporaryDirectory() as name:
    root = Path(name)
    check_good_run(root / "run")
    check_stopped_by_its_guard(root / "stopped")
    check_refused(root, ["--nonsense"], "--nonsense")
    check_refused(root, ["--support", "paper"], "--support", 1.3)
    check_refused(root, ["--young-modulus", "sound"], "--composition", "paper", "--young-modulus", 1e5)
    check_refused(root, ["--accuracy", "sound"], "--composition", "paper", "--accuracy", "draft")
    check_refused(root, ["--accuracy", "--water-spacing"], "--accuracy", "draft", "--water-spacing", 1)
    check_refused(root, ["pore radius", "0.004 m", "3.5e-3"], "--pore-radius", 4)
    (root / "file").write_text("in the way")
    os.environ["LC_ALL"] = "C"
    code, said = run("--quick", "--output", root / "file" / "below")
    check(code == 2 and "file" in said and "Scene in" not in said, "an unwritable folder:", code, said)
    check((root / "file").read_text() == "in the way", "what was in the way is gone")
print("run_sponge: all as it should be")
