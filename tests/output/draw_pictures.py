#!/usr/bin/env python3
"""Runs the drawing tools on a small made-up run and looks at what they drew. Usage: draw_pictures.py FOLDER
With --full: as many particles as in the paper. The pictures stay in FOLDER/pictures to be looked at."""

import os
import shutil
import subprocess
import sys
import time

try:
    import numpy as np
    from matplotlib.image import imread
except ImportError as missing:
    sys.exit(f"{missing.name} is missing; install python3-matplotlib")

TOOLS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools")


def lattice(low, high, spacing):
    axes = [np.arange(a + spacing / 2, b, spacing) for a, b in zip(low, high)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)


def write_vtp(path, points, arrays, spacing):
    """A file such as output/vtk.hpp writes."""
    blocks, described, offset = [], [], 0
    for name, values in [("position", points), *arrays.items()]:
        values = np.ascontiguousarray(values, "<f4" if name != "id" else "<i8")
        kind = "Float32" if name != "id" else "Int64"
        components = 1 if values.ndim == 1 else values.shape[1]
        described.append(f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
                         f'format="appended" offset="{offset}"/>')
        blocks.append(np.uint64(values.nbytes).tobytes() + values.tobytes())
        offset += len(blocks[-1])
    with open(path, "wb") as file:
        file.write(('<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
                    'header_type="UInt64"><PolyData><FieldData><DataArray type="Float64" Name="spacing" '
                    f'NumberOfTuples="1" format="ascii">{spacing}</DataArray></FieldData><Piece NumberOfPoints='
                    f'"{len(points)}"><Points>{described[0]}</Points><PointData>{"".join(described[1:])}</PointData>'
                    '</Piece></PolyData><AppendedData encoding="raw">_').encode())
        file.write(b"".join(blocks) + b"</AppendedData></VTKFile>")


def make_run(folder, shrink, times):
    """A block of water that falls on a slab with 5 x 5 pores and runs through them: invented motion, not physics."""
    os.makedirs(folder)
    rng = np.random.default_rng(1)
    s, w, mm = 5e-4 * shrink, 8e-4 * shrink, 1e-3
    slab = lattice((-17.5 * mm, -17.5 * mm, -4.5 * mm), (17.5 * mm, 17.5 * mm, 0), s)
    centre = (np.round(slab[:, :2] / (7 * mm))) * 7 * mm
    slab = slab[np.linalg.norm(slab[:, :2] - centre, axis=1) > 1.5 * mm]
    water = lattice((-12.4 * mm, -12.4 * mm, 1 * mm), (12.4 * mm, 12.4 * mm, 57.8 * mm), w)
    floor = lattice((-17.5 * mm, -17.5 * mm, -36 * mm), (17.5 * mm, 17.5 * mm, -34.5 * mm), s * 1.5)
    jitter = rng.normal(0, 0.12 * w, water.shape)
    pore = np.round(np.clip(water[:, :2] / (7 * mm), -2, 2)) * 7 * mm
    lists = {"water": [], "sponge": [], "wall": []}
    for k, t in enumerate(times):
        s_of_t = t / times[-1]
        # Water: the block sinks, what is below its start runs through the nearest pore, and from there over the floor.
        height = (water[:, 2] + jitter[:, 2] * 5) / (58 * mm)
        gone = 1.05 * s_of_t - height
        stray = jitter * min(1, 6 * s_of_t)
        position = water + stray
        position[:, 2] = np.maximum(1.4 * mm - 1.05 * s_of_t * 58 * mm + water[:, 2] + stray[:, 2], 0.2 * mm)
        jet, spread = gone > 0, gone > 0.3
        position[jet, :2] = pore[jet] + (water[jet, :2] - pore[jet]) * 0.28
        position[jet, 2] = -gone[jet] / 0.3 * 34 * mm
        position[spread, :2] = water[spread, :2] * 1.35 + jitter[spread, :2] * 5
        position[spread, 2] = -34 * mm + np.abs(jitter[spread, 2]) * 12
        velocity = np.zeros_like(position)
        velocity[:, 2] = -0.25 * min(1, 5 * s_of_t)
        velocity[jet, 2] = -np.sqrt(0.06 + 2 * 9.8 * gone[jet] / 0.3 * 34 * mm)
        velocity[spread] = rng.normal(0, 0.15, (spread.sum(), 3))
        # Sponge: sags most in its middle, held at two sides.
        shape = np.cos(np.pi * slab[:, 0] / (35 * mm)) ** 2 * (0.7 + 0.3 * np.cos(np.pi * slab[:, 1] / (35 * mm)))
        bend = np.zeros_like(slab)
        bend[:, 2] = -3 * mm * np.sin(np.pi * 0.8 * s_of_t) * shape
        order = rng.permutation(len(slab))  # particles move in memory; their ids tell who they are
        files = {"water": (position, {"velocity": velocity}, w),
                 "sponge": ((slab + bend)[order], {"id": order}, s), "wall": (floor, {}, s * 1.5)}
        for phase, (points, arrays, spacing) in files.items():
            name = f"{phase}_{k:06d}.vtp"
            write_vtp(os.path.join(folder, name), points, arrays, spacing)
            lists[phase].append(f'<DataSet timestep="{t!r}" part="0" file="{name}"/>')
    for phase, entries in lists.items():
        with open(os.path.join(folder, phase + ".pvd"), "w") as file:
            file.write('<VTKFile type="Collection"><Collection>' + "\n".join(entries) + "</Collection></VTKFile>")
    return len(water), len(slab)


def tool(name, *arguments, fails=None):
    done = subprocess.run([sys.executable, os.path.join(TOOLS, name), *arguments], capture_output=True, text=True)
    if fails is None:
        assert done.returncode == 0, f"{name} {arguments}\n{done.stdout}{done.stderr}"
    else:
        last = (done.stderr.splitlines() or [""])[-1]  # behind the usage, where there is one
        assert done.returncode in (1, 2) and last.startswith(name + ": ") and fails in last, \
            f"{name} {arguments} ended with {done.returncode} and said: {done.stderr}"
        assert "Traceback" not in done.stderr, done.stderr
    return done.stdout


def share(picture, test):
    """The part of the picture's pixels whose red, green and blue pass the test."""
    colour = imread(picture)[..., :3]
    return test(colour[..., 0], colour[..., 1], colour[..., 2]).mean()


def blue(r, g, b):
    return (b > r + 0.1) & (b > 0.2)


def brown(r, g, b):
    return (r > b + 0.1) & (r > 0.2)


STUDY = "spacing,error,least error,greatest error,seconds [s],pair evaluations,front,failure\n"


def refuse_bad_input(folder, run):
    """Files that are missing, damaged or of another kind, and options out of range: one line each, and no traceback."""
    bad = os.path.join(folder, "bad")
    os.makedirs(bad)

    def written(name, content):
        path = os.path.join(bad, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return path

    def damaged_run(name, file, content):
        """The run once more, with another content of one file; without that file if there is none."""
        copy = os.path.join(bad, name)
        shutil.copytree(run, copy)
        os.remove(os.path.join(copy, file))
        if content is not None:
            written(os.path.join(name, file), content)
        return copy

    picture, nowhere = os.path.join(bad, "x.png"), os.path.join(bad, "none", "x")
    no_text = written("no_text.csv", b"\x89PNG\r\n\xff\n")
    tool("plot_curves.py", no_text, "-o", picture, fails="it is no text")
    tool("plot_accuracy.py", no_text, "-o", picture, fails="it is no text")
    row = "0.1,1e-3,1e-3,1e-3,0.5,1000,0,\n"
    tool("plot_accuracy.py", written("study.csv", STUDY + row + row.replace("1e-3", "4e-3")), "-o", picture)
    two_axes = "kernel," + STUDY + "".join(  # the finest first: it is the work that says which that is
        f"{kernel},{spacing},{error},{error},{error},{seconds},{pairs},0,\n" for kernel, spacing, error, seconds, pairs in
        (("a", 0.1, 0.02, 4, 8e3), ("a", 0.2, 0.04, 1, 1e3), ("b", 0.1, 0.01, 6, 8e3), ("b", 0.2, 0.03, 2, 1e3)))
    bought = tool("plot_accuracy.py", written("two.csv", two_axes), "--join", "spacing", "--buys", "-o", picture)
    assert "| b | 0.1 | 1.50 | 1.00% | 2.00% |" in bought, bought
    for table, said in ((STUDY + row + "0.1,1e-3\n", "number 2, that is not of 8 columns"),
                        (STUDY + row + row.replace("0.5", "long"), "number 2, with 'long'"),
                        ("a,b\n1,2\n", "not the table of an accuracy study")):
        tool("plot_accuracy.py", written("bad_study.csv", table), "-o", picture, fails=said)

    tables = [written(f"{k}.csv", f"time [s],mean displacement [m]\n0,0\n0.1,{k}e-3\n") for k in range(4)]
    tool("sponge_claims.py", "pores", "sound", *tables, fails="0.csv has no column 'drained fraction'")
    tool("sponge_claims.py", "support", "sound", *tables, "-o", nowhere, fails="cannot write")
    tool("effects_report.py", bad, "--page", nowhere, fails="cannot read")

    with open(os.path.join(run, "water_000003.vtp"), "rb") as file:
        snapshot = file.read()
    runs = [(damaged_run("list", "water.pvd", "<VTKFile><Coll"), "water.pvd is damaged"),
            (damaged_run("entry", "water.pvd", '<VTKFile><DataSet file="x"/></VTKFile>'), "water.pvd is damaged"),
            (damaged_run("missing", "water_000003.vtp", None), "No such file"),
            (damaged_run("short", "water_000003.vtp", snapshot[:len(snapshot) // 2]), "is cut short"),
            (damaged_run("empty", "water_000003.vtp", ""), "is cut short"),
            (damaged_run("hole", "water_000003.vtp", snapshot[:-60000] + snapshot[-50:]), "is damaged")]
    for damaged, said in runs:
        tool("render_plane.py", damaged, "-o", picture, "--times", "60", fails=said)
    tool("render_sponge.py", damaged, "-o", picture, "--times", "60", fails=said)
    plane = ("render_plane.py", run, "-o", picture, "--dpi", "40", "--walls", "wall")
    for option, number in (("--count", "0"), ("--count", "two"), ("--columns", "-2")):
        tool(*plane, option, number, fails=f"'{number}' must be a whole number above 0")
    tool(*plane, "--slice", "900", "901", fails="no particle from y = 900 to 901 mm")
    tool(*plane, "--slice", "-1", "1", "--count", "1")
    tool("render_plane.py", run, "--fluid", "sponge", "-o", picture, fails="no velocity")
    tool("render_sponge.py", run, "-o", picture, "--count", "0", fails="'0' must be a whole number above 0")
    try:
        import scipy  # noqa: F401
    except ImportError:
        return
    tool("sponge_bars.py", nowhere, fails="cannot read")


def main():
    full = "--full" in sys.argv
    folder = os.path.join(sys.argv[1], "pictures")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    run = os.path.join(folder, "run")
    counts = make_run(run, 1 if full else 2.2, [0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12])
    out = os.path.join(folder, "snapshots.png")
    start = time.time()
    tool("render_sponge.py", run, "-o", out, "--title", "A made-up run",
         *(("--count", "4") if full else ("--count", "3", "--dpi", "60")))
    seconds = time.time() - start
    print(f"{counts[0]} water and {counts[1]} sponge particles: drawn in {seconds:.1f} s")
    assert share(out, blue) > 0.05 and share(out, brown) > 0.01, (share(out, blue), share(out, brown))
    for view in ("cut", "space"):
        one = os.path.join(folder, view + ".png")
        tool("render_sponge.py", run, "-o", one, "--view", view, "--times", "0", "100", "--dpi", "60")
        assert share(one, blue) > 0.05 and share(one, brown) > 0.01, (view, share(one, blue), share(one, brown))
    tool("render_sponge.py", folder, "-o", out, fails="water.pvd")
    tool("render_sponge.py", run, "-o", os.path.join(folder, "none", "x.png"), "--view", "cut", "--count", "1",
         "--dpi", "40", fails="cannot write")

    for k, radius in enumerate((0.5, 1.0, 1.5, 2.0)):
        t = np.linspace(0, 0.5, 200)
        with open(os.path.join(folder, f"pores_{k}.csv"), "w") as file:
            file.write("time [s],mean displacement [m],drained mass [kg],kinetic energy [J],elastic energy [J]\n")
            for x in t:
                y = 2.4e-3 * (1 + 0.1 * k) * (1 - np.exp(-x / 0.02)) * np.exp(-x * (0.2 + radius))
                file.write(f"{x},{y},{0.03 * radius * x},{5e-3 * np.exp(-9 * x)},{3e-3 * x * np.exp(-3 * x)}\n")
            file.write("0.5,1e-")  # a run that is still writing
    curves = os.path.join(folder, "curves.png")
    tables = [os.path.join(folder, f"pores_{k}.csv") for k in range(4)]
    tool("plot_curves.py", *tables, "--y", "mean displacement", "--labels", "r = 0.5 h", "r = 1 h", "r = 1.5 h",
         "r = 2 h", "-o", curves)
    assert share(curves, lambda r, g, b: (np.abs(r - g) > 0.2) | (np.abs(g - b) > 0.2)) > 0.002
    tool("plot_curves.py", tables[0], "-o", os.path.join(folder, "overview.png"), "--title", "Sponge, r = 0.5 h")
    tool("plot_curves.py", tables[0], "--y", "speed", "-o", curves, fails="has no column 'speed'")
    tool("plot_curves.py", os.path.join(folder, "none.csv"), "-o", curves, fails="cannot read")
    refuse_bad_input(folder, run)
    print("pictures drawn in", folder)


main()
