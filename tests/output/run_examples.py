#!/usr/bin/env python3
"""Runs every small example once, coarse where it takes a resolution, and checks that it comes to its end, writes what it
says it writes, and prints a result that is not far from what its first lines promise; and that it refuses arguments that
are no numbers or out of range.

    python3 tests/output/run_examples.py build
"""

import csv
import os
import re
import subprocess
import sys
import tempfile

# (example, arguments, a file that it writes, if any, and the time it ends with, a number that it prints, or the greatest
# of a column of a table that it writes, and between what it may be)
EXAMPLES = [
    ("dam_break", [], "out-dam-break/water.pvd", 1.0, None),
    ("dam_break_2d", ["16"], "out-dam-break-2d/water.pvd", 0.7,
     (r"3\.096\s+([\d.]+)", 3.8, 4.2)),  # front at T = 3.096, in L; 3.624 in the experiment
    ("elastic_gate", [], "out-elastic-gate/gate.pvd", 0.4,
     ("out-elastic-gate/gate.csv", "sideways [m]", 0.040, 0.044)),  # 42 mm says the example; 45 in the experiment
    ("rubber_rings", [], "out-rubber-rings/rings.pvd", 0.03, (r"leaves with ([\d.]+) m/s", 2.5, 2.75)),
    ("soft_plate", [], "out-soft-plate/plate.pvd", 0.1, (r"hangs down by ([\d.]+) mm", 2.2, 2.45)),
    ("cylinders", ["0.2", "20"], "out-cylinders/glycerine.pvd", None, (r"F/\(mu U\) = ([\d.]+)", 49, 52)),
    ("gyroid", [], "out-gyroid/sponge.pvd", 0.15, (r"(\d+) % of the water is through", 87, 97)),
    ("drinking_sponge", ["45", "2", "0.5"], "out-drinking-sponge/sponge.pvd", 0.03,
     (r"(\d+) % of the pores are full", 60, 95)),
    ("landing_drop", ["90", "10"], "out-landing-drop/water.pvd", None,
     (r"it covers ([\d.]+) mm now", 2.3, 3.1)),  # 2.83 mm by Young's angle
    ("oil_in_sponge", ["20", "60", "0.15"], "out-oil-in-sponge/oil.pvd", None, (r"(\d+) % of the oil is out", 55, 85)),
    ("porous", ["--across", "24"], None, None, (r"along y: k = ([\d.]+)e-09", 3.4, 3.9)),
    ("freezing_pores", ["30"], "out-freezing-pores/water.pvd", None,
     (r"3.01 s: (\d+) % of the water is ice", 90, 97)),  # 91 in a body of the mean properties
    ("soaked_sponge", ["3"], "out-soaked-sponge/water.pvd", 10.5,
     (r"10.5 s: ([\d.]+) of 2.43 kg/m", 2.0, 2.2)),  # 2.14 with a spacing of 1.5 mm
    ("squeezed_foam", ["0.3", "16"], None, None, (r"strain 0.250: .*k along ([\d.]+)e-09", 1.0, 5.0)),
]

# (example, arguments, what it says before it has begun)
REFUSED = [
    ("dam_break_2d", ["--help"], "the number of particles across the column, '--help', must be a number from 4 to 1000"),
    ("elastic_gate", ["abc"], "the spacing in mm, 'abc', must be a number"),
    ("elastic_gate", ["1", "1.2e7", "0.5"], "Poisson's ratio, '0.5', must be a number from 0 to 0.499"),
    ("rubber_rings", ["1", "0.3x"], "epsilon of the artificial stress, '0.3x', must be a number"),
    ("landing_drop", ["20"], "the contact angle in degrees, '20', must be a number from 30 to 150"),
    ("soft_plate", [""], "the number of particles across the plate, '', must be a number"),
    ("cylinders", ["0.9"], "the share of the plane that cylinders fill, '0.9', must be a number"),
    ("gyroid", ["nan"], "the solid fraction, 'nan', must be a number"),
    ("drinking_sponge", ["200"], "the contact angle in degrees, '200', must be a number from 0 to 180"),
    ("freezing_pores", ["10"], "the number of particles over the height, '10', must be a number from 30 to 400"),
    ("soaked_sponge", ["5"], "the spacing in mm, '5', must be a number from 0.5 to 3"),
    ("porous", ["none.stl"], "a mesh needs --unit, an image --voxel and --threshold"),
    ("porous", ["none.stl", "--unit", "mm"], "read_mesh: none.stl cannot be opened"),
    ("oil_in_sponge", ["0"], "the viscosity of oil over that of water, '0', must be a number from 0.05 to 20"),
]


def fail(*words):
    sys.exit(" ".join(["run_examples: FAILED:", *(str(word) for word in words)]))


def run(program, arguments, file, end, promise):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, *arguments], cwd=folder, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        text = done.stdout.replace("\r", "\n")
        if done.returncode != 0:
            fail(program, *arguments, "ended with", done.returncode, "and said:\n" + text[-2000:])
        times = []
        if file:
            path = os.path.join(folder, file)
            if not os.path.exists(path):
                fail(program, "has not written", file)
            with open(path) as series:
                times = [float(time) for time in re.findall(r'timestep="([^"]+)"', series.read())]
            if len(times) < 5 or (end and abs(times[-1] - end) > 0.02 * end):
                fail(program, "wrote", len(times), "moments, the last at", times[-1:], "s, not at", end)
        if promise and promise[0].endswith(".csv"):
            table, column, *bounds = promise
            with open(os.path.join(folder, table)) as rows:
                greatest = max(float(row[column]) for row in csv.DictReader(rows))
            text, promise = f"{column} at most {greatest:g}", (re.escape(column) + r" at most (\S+)", *bounds)
    said = ""
    if promise:
        pattern, low, high = promise
        found = re.search(pattern, text)
        if not found or not low <= float(found.group(1)) <= high:
            fail(program, "printed", found.group(0) if found else "nothing like " + pattern, "instead of", low, "to", high,
                 "\n" + text[-2000:])
        said = ": " + found.group(0)
    print(f"run_examples: {os.path.basename(program)}, {len(times)} moments{said}", flush=True)


def refused(program, arguments, expected):
    done = subprocess.run([program, *arguments], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
    if done.returncode != 2 or not done.stdout.startswith(f"{os.path.basename(program)}: {expected}"):
        fail(program, *arguments, "ended with", done.returncode, "and said:\n" + done.stdout[-2000:])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for example, *rest in REFUSED:
        refused(os.path.join(os.path.abspath(sys.argv[1]), example), *rest)
    for example, *rest in EXAMPLES:
        run(os.path.join(os.path.abspath(sys.argv[1]), example), *rest)


if __name__ == "__main__":
    main()
