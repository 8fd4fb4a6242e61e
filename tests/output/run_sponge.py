#!/usr/bin/env python3
"""Runs the sponge for a few steps and looks at all it leaves: what it says, its table, its files for ParaView (read by
VTK itself), its pictures. Then with steps that are far too long, after which it must go on from where it was good, and
on a disk that is full. Then gives it options it must refuse, before it has written anything, and lets it meet what an earlier run left in its
folder. At last the study of its pores, which must not take one run for another, and the judge of its tables.

    python3 tests/output/run_sponge.py build/sponge [build/sponge_study]

Without a second name the study is the program sponge_study beside the first.
"""
import csv
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    sys.exit(f"{missing.name} is missing; install python3-vtk9")

SPONGE = sys.argv[1]
STUDY = sys.argv[2] if len(sys.argv) > 2 else str(Path(SPONGE).with_name("sponge_study"))
TOOLS = Path(__file__).resolve().parents[2] / "tools"


def check(condition, *words):
    if not condition:
        sys.exit(" ".join(str(word) for word in ("run_sponge: FAILED:", *words)))


def run(*options, program=SPONGE, tools=True, largest_file=None):
    """Its status and all it said. Without tools it draws no pictures, which takes longer than a short run. To a program
    that may write no file of more than so many bytes the disk is full: writing fails, and it is not killed for it."""
    surroundings = os.environ if tools else {**os.environ, "IMBIBE_TOOLS": "none"}

    def fill_the_disk():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

    done = subprocess.run([program, *map(str, options)], capture_output=True, text=True, timeout=1500, env=surroundings,
                          restore_signals=largest_file is None,
                          preexec_fn=None if largest_file is None else fill_the_disk)
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
                   "elastic energy of the sponge [J]", "potential energy of the sponge [J]",
                   "momentum along x [kg m/s]", "momentum along z [kg m/s]",
                   "greatest density of the water [kg/m^3]", "time step [s]"):
        check(column in rows[0], f"no column '{column}' in", list(rows[0]))
    check(float(rows[0]["time [s]"]) == 0 and abs(float(rows[-1]["time [s]"]) - 0.004) < 1e-4, "times", rows[0],
          rows[-1])
    check(rows[1]["what limits the time step"] == "sound, Water", "limit", rows[1])
    # the slab's middle is 2 mm above the plane from which heights count, and sinks by the mean of its particles
    heights = [float(row["potential energy of the sponge [J]"]) for row in rows]
    sunk = [float(row["mean vertical displacement [m]"]) for row in rows]
    check(heights[0] > 0 and sunk[-1] < -1e-5, "the sponge is not heavy", heights, sunk)
    check(abs(heights[-1] / heights[0] - 1 - sunk[-1] / 2e-3) < 1e-3, "height of the sponge", heights, sunk)
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


def draw_cut(folder, picture):
    done = subprocess.run([sys.executable, TOOLS / "render_sponge.py", folder, "--view", "cut", "--count", "1", "--dpi",
                           "40", "-o", picture], capture_output=True, text=True)
    check(done.returncode == 0, "render_sponge.py:", done.stdout + done.stderr)
    return picture.read_bytes()


def check_tank_is_drawn(folder, scratch):
    """A picture of the same run without the list of its walls is another picture."""
    with_tank = draw_cut(folder, scratch / "tank.png")
    (folder / "vessel.pvd").rename(folder / "hidden")
    check(draw_cut(folder, scratch / "none.png") != with_tank, "the tank is not drawn")
    (folder / "hidden").rename(folder / "vessel.pvd")


def check_finished_run_is_replaced(folder):
    """The command of the README twice: the second run takes the folder of the first, and leaves nothing of it that
    would pass for its own."""
    check((folder / "finished.txt").read_text() == "to 0.004 s\n", "what says that the run has ended")
    code, said = run("--quick", "--end", 0.001, "--snapshots", 0, "--threads", 1, "--output", folder)
    check(code == 0, "the same command twice: exit status", code, said)
    for name in ("water.pvd", "sponge.pvd", "vessel.pvd", "snapshots.png", "displacement.png", "drained.png"):
        check(not (folder / name).exists(), name, "of the earlier run is still there")
    check("ParaView" not in said, "a run without snapshots points at some:\n" + said)


def check_stopped_by_its_guard(folder):
    """Steps that are too long end in a clear word, with the offending state and a good one on disk. What is in the
    folder then is not lost by forgetting --restart, and not gone on with by other physics."""
    common = ["--quick", "--snapshots", 0, "--threads", 1, "--output", folder]
    code, said = run(*common, "--cfl", 2, "--end", 0.1)
    check(code > 0, "steps far too long: exit status", code, said)
    check("BROKE OFF" in said and "broken" in said, "steps far too long:", said)
    check("--restart goes on from the last checkpoint, which was good, for example with --cfl 1\n" in said,
          "the advice:", said)
    check(any((folder / "broken").iterdir()), "no offending state in", folder / "broken")

    before = (folder / "checkpoint").read_bytes(), (folder / "sponge.csv").read_bytes()
    code, said = run(*common, "--cfl", 0.5, "--end", 0.002)
    check(code == 2, "--restart forgotten: exit status", code, said)
    for words in (str(folder), "holds a run to 0", "--restart goes on", "--overwrite begins anew"):
        check(words in said, f"--restart forgotten: '{words}' is not in", said)
    for option, value, words in (("--young-modulus", 9e4, "--young-modulus: 70000 Pa; now it is 90000 Pa"),
                                 ("--freeboard", 6, "--freeboard: 0 mm; now it is 6 mm")):
        code, said = run(*common, "--end", 0.1, "--restart", option, value)
        check(code == 2 and words in said, option, "changed in a run:", code, said)
    check(before == ((folder / "checkpoint").read_bytes(), (folder / "sponge.csv").read_bytes()),
          "a refused command has changed the run")

    code, said = run(*common, "--cfl", 0.5, "--end", 0.002, "--restart")
    check(code == 0 and "all accounted for" in said, "going on with shorter steps:", code, said)
    check("From here on --cfl: 0.5; until now: 2\n" in said, "a changed number of the scheme:", said)

    (folder / "finished.txt").unlink()
    code, said = run(*common, "--end", 0.001, "--overwrite")
    check(code == 0 and (folder / "finished.txt").exists(), "--overwrite:", code, said)


def check_accuracy(folder):
    """What a word for the accuracy is to cost and to bring is said before the run."""
    code, said = run("--accuracy", "draft", "--strip", "--pool", 7, "--end", 1e-4, "--snapshots", 0, "--threads", 1,
                     "--output", folder, tools=False)
    check(code == 0, "--accuracy draft:", code, said)
    before = said[:said.index("100.0 %")]
    for words in ("draft", "18 %", "that of the finest run", "Expected wall time"):
        check(words in before, f"--accuracy draft does not say '{words}' before it runs:", said)


def check_full_disk(folder):
    """A disk that takes no more ends a run in a clear word, and what was there before stays: the run can go on."""
    common = ["--quick", "--snapshots", 0, "--threads", 1, "--output", folder]
    code, said = run(*common, "--end", 0.001, tools=False)
    check(code == 0, "before the disk is full:", code, said)
    good = (folder / "checkpoint").read_bytes()
    code, said = run(*common, "--end", 0.002, "--restart", tools=False, largest_file=len(good) // 2)
    words = f"cannot write {folder / 'checkpoint'}: the disk refused it"
    check(code > 0 and words in said, "a full disk:", code, said)
    check("from the last checkpoint once the folder can be written again" in said, "the advice:", said)
    check((folder / "checkpoint").read_bytes() == good, "a full disk has changed the checkpoint")
    code, said = run(*common, "--end", 0.002, "--restart", tools=False)
    check(code == 0 and "all accounted for" in said, "once there is room again:", code, said)


def check_advice_of_the_paper(folder):
    """Its step is fixed, so that another --cfl would be refused."""
    options = ["--composition", "paper", "--strip", "--pool", 7, "--threads", 1, "--snapshots", 0, "--output", folder]
    code, said = run(*options, "--time-step", 1e-4, "--end", 0.1)
    check(code == 1 and "--restart goes on" in said and "with --time-step 5e-05\n" in said, "too long a step:", said)
    check(said.count("Warning: Water: the support radius") == 1, "a warning is to be said once:", said)


def check_asked_to_stop(folder, by):
    """By Ctrl-C, or as a system that shuts down asks."""
    process = subprocess.Popen([SPONGE, "--quick", "--snapshots", "0", "--threads", "1", "--output", folder],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    while not (folder / "checkpoint").exists() and process.poll() is None:
        time.sleep(0.1)
    process.send_signal(by)
    said, _ = process.communicate(timeout=300)
    check(process.returncode == 1 and "Stopped at t = " in said and "--restart goes on from here" in said, said)
    check("BROKE" not in said, "what the user stops is not broken:", said)


def check_study(root):
    """A run with other options, in the folders of a study that was finished, that does not come to its end: the study
    with the first options must not judge its tables as its own."""
    common = ["pores", "--strip", "--pool", 3, "--water-spacing", 1, "--snapshots", 0, "--threads", 1, "--output", root,
              "--end", 0.002]
    code, said = run(*common, program=STUDY, tools=False)
    check(code == 0, "the study: exit status", code, said)
    code, said = run(*common, program=STUDY, tools=False)
    check(code == 0 and said.count("finished before") == 4, "the study again:", code, said)

    case = next(root.glob("sound-r0.5-*"))
    table = (case / "sponge.csv").read_text()
    process = subprocess.Popen([STUDY, *map(str, common[:-1]), "5", "--young-modulus", "9e4"], stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True)
    while (not (case / "checkpoint").exists() or "90000" not in (case / "running.txt").read_text()) and \
            process.poll() is None:
        time.sleep(0.1)
    process.kill()
    process.communicate()
    check(not (case / "finished.txt").exists(), "a run that was killed passes for finished")
    code, said = run(*common, program=STUDY, tools=False)
    check(code == 2 and "--overwrite begins anew" in said and "finished before" not in said,
          "the study in the folder of an interrupted run with other options:", code, said)
    code, said = run(*common, "--overwrite", program=STUDY, tools=False)
    check(code == 0 and said.count("finished before") == 3, "the study, --overwrite:", code, said)
    check((case / "sponge.csv").read_text() == table, "the table of the study is not what it was")
    code, said = run("pores", "--snapshots", "nan", "--output", root / "new", program=STUDY)
    check(code > 0 and "--snapshots: nan ms; it must be" in said, "the study, --snapshots nan:", said)


def check_claims(folder):
    """Orders are strict: four runs that are alike are in none, and runs without a length decide nothing."""
    folder.mkdir()

    def verdicts(displacements, end):
        paths = []
        for k, most in enumerate(displacements):
            paths.append(folder / f"{k}.csv")
            times = [0] if end == 0 else [end * i / 20 for i in range(21)]
            paths[-1].write_text("time [s],mean displacement [m],drained fraction [1]\n" +
                                 "".join(f"{t},{most * t},0\n" for t in times))
        done = subprocess.run([sys.executable, TOOLS / "sponge_claims.py", "pores", "sound", *paths],
                              capture_output=True, text=True)
        check(done.returncode == 0, "sponge_claims.py:", done.stdout + done.stderr)
        return [line.split("|")[3].strip() for line in done.stdout.splitlines() if line.startswith("| 1.")]

    check(verdicts([4, 3, 2, 1], 0.2) == ["met"] * 3, "an order that is there is not seen")
    check(verdicts([4, 4, 2, 1], 0.2) == ["not met"] * 3, "two that are alike pass for ordered")
    check(verdicts([0, 0, 0, 0], 0.2) == ["not met"] * 3, "four that have not moved pass for ordered")
    check(all(v.startswith("undecided") for v in verdicts([1, 1, 1, 1], 0)), "runs without a length decide something")


def check_repeats(folder):
    """Two runs of each of two cases: theirs is what is far greater than what chance makes of means."""
    folder.mkdir()
    paths = []
    for k, most in enumerate([0.99, 1.01, 1.19, 1.21]):
        paths.append(folder / f"{k}.csv")
        paths[-1].write_text("time [s],mean displacement [m]\n" + f"0,0\n0.1,{most}\n0.2,{most}\n")
    command = [sys.executable, TOOLS / "sponge_repeats.py", *paths, "-o", folder / "repeats.png", "--repeats"]
    done = subprocess.run([*command, "2"], capture_output=True, text=True)
    # 0.02/1.21, 0.2/1.21, and 1.128 standard deviations of a mean, 0.01, over 1.21
    check("| 0.15 | 1.7 % | 16.5 % | 0.9 % |" in done.stdout, "sponge_repeats.py:", done.stdout + done.stderr)
    check((folder / "repeats.png").stat().st_size > 0, "sponge_repeats.py drew nothing")
    done = subprocess.run([*command, "3"], capture_output=True, text=True)
    check(done.returncode == 2 and "4 files are not 3 runs a case" in done.stderr, "sponge_repeats.py:", done.stderr)


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
    check_tank_is_drawn(root / "run", root)
    check_finished_run_is_replaced(root / "run")
    check_stopped_by_its_guard(root / "stopped")
    check_full_disk(root / "full")
    check_accuracy(root / "draft")
    check_advice_of_the_paper(root / "paper")
    check_asked_to_stop(root / "interrupted", signal.SIGINT)
    check_asked_to_stop(root / "terminated", signal.SIGTERM)
    check_study(root / "study")
    check_claims(root / "claims")
    check_repeats(root / "repeats")
    check_refused(root, ["--nonsense"], "--nonsense")
    check_refused(root, ["--support", "paper"], "--support", 1.3)
    check_refused(root, ["--young-modulus", "sound"], "--composition", "paper", "--young-modulus", 1e5)
    check_refused(root, ["--accuracy", "sound"], "--composition", "paper", "--accuracy", "draft")
    check_refused(root, ["--accuracy", "--water-spacing"], "--accuracy", "draft", "--water-spacing", 1)
    check_refused(root, ["--pore-radius: 4 mm", "below 3.5 mm"], "--pore-radius", 4)
    check_refused(root, ["--water-spacing: 0.8 mm", "width of 7 mm", "0.875 mm"], "--strip", "--water-spacing", 0.8)
    check_refused(root, ["--cfl", "--time-step 1e-05 s"], "--cfl", 0.5, "--time-step", 1e-5)
    check_refused(root, ["--threads: 100000;", "at most 1024"], "--threads", 100000)
    check_refused(root, ["there is no checkpoint", "--restart", "--output"], "--restart")
    for option, unit in (("--snapshots", " ms"), ("--checkpoints", " s"), ("--search-interval", " steps"),
                         ("--threads", "")):
        for value in (-1, "inf", "nan"):
            check_refused(root, [f"{option}: {value}{unit}; it must be at least 0"], option, value)
    (root / "file").write_text("in the way")
    os.environ["LC_ALL"] = "C"
    code, said = run("--quick", "--output", root / "file" / "below")
    check(code == 2 and "file" in said and "Scene in" not in said, "an unwritable folder:", code, said)
    check((root / "file").read_text() == "in the way", "what was in the way is gone")
print("run_sponge: all as it should be")
