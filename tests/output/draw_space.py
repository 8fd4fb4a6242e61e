#!/usr/bin/env python3
"""Has tools/render_space.py draw a made-up run and measures what it drew. Usage: draw_space.py FOLDER
Ends with 77, which is a test left out, where VTK or Xvfb is missing. The pictures stay in FOLDER/space."""

import os
import shutil
import subprocess
import sys

LEFT_OUT = 77
try:
    import numpy as np
    from matplotlib.image import imread
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
except ImportError as missing:
    print(f"left out: {missing.name} is missing; sh tools/install_packages.sh pictures")
    sys.exit(LEFT_OUT)
if not os.environ.get("DISPLAY") and not (shutil.which("xvfb-run") and shutil.which("xauth")):
    print("left out: there is neither a screen nor xvfb-run; sh tools/install_packages.sh pictures")
    sys.exit(LEFT_OUT)

TOOL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "render_space.py")
MM = 1e-3


def lattice(low, high, spacing):
    """Particles that fill a box, its sides in mm."""
    axes = [np.arange(a + spacing / 2, b, spacing) for a, b in zip(low, high)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3) * MM


def write_phase(folder, name, spacing, moments):
    """moments: {time in s: (points, {field: values})}"""
    entries = []
    for k, (time, (points, fields)) in enumerate(moments.items()):
        data, places = vtkPolyData(), vtkPoints()
        places.SetData(numpy_to_vtk(points, deep=True))
        data.SetPoints(places)
        constants = {"spacing": np.array([spacing * MM])}
        for to, arrays in ((data.GetPointData(), fields), (data.GetFieldData(), constants)):
            for field, values in arrays.items():
                array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
                array.SetName(field)
                to.AddArray(array)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(folder, f"{name}_{k}.vtp"))
        writer.SetInputData(data)
        assert writer.Write() == 1
        entries.append(f'<DataSet timestep="{time}" file="{name}_{k}.vtp"/>')
    with open(os.path.join(folder, name + ".pvd"), "w") as file:
        file.write("<VTKFile><Collection>" + "".join(entries) + "</Collection></VTKFile>")


def make_run(folder, pillars=()):
    """A room of 40 x 4 x 20 mm: in its lower left quarter water, that has become a thread and a drop at 10 ms, and a
    cube of a solid in the upper right corner. The walls have these pillars as well."""
    os.makedirs(folder)
    pool, cube = lattice((0, 0, 0), (20, 4, 10), 0.5), lattice((36, 0, 16), (40, 4, 20), 0.5)
    thin = np.concatenate([lattice((0, 1.75, 5), (20, 2.25, 5.5), 0.5), [[30 * MM, 2 * MM, 5 * MM]]])
    write_phase(folder, "water", 0.5, {time: (points, {"velocity": [2, 0, 0] - points * [50, 0, 0]})
                                       for time, points in ((0.0, pool), (0.01, thin))})
    write_phase(folder, "sponge", 0.5, {time: (cube, {"displacement": cube * [0, 0, time], "stress": cube[:, 0],
                                                      "deviator": np.ones((len(cube), 6))}) for time in (0.0, 0.01)})
    walls = [lattice(*ends, 1) for ends in (((-1, 0, -1), (41, 4, 0)), ((-1, 0, 20), (41, 4, 21)),
                                            ((-1, 0, 0), (0, 4, 20)), ((40, 0, 0), (41, 4, 20)))]
    write_phase(folder, "vessel", 1, {0.0: (np.concatenate([*walls, *pillars]), {})})


def tool(*arguments, fails=None, **surroundings):
    done = subprocess.run([sys.executable, TOOL, *arguments], capture_output=True, text=True,
                          env={**os.environ, **surroundings})
    if fails is None:
        assert done.returncode == 0 and not done.stderr, f"{arguments}\n{done.stdout}{done.stderr}"
    else:
        lines = done.stderr.splitlines() or [""]
        assert done.returncode == 1 and len(lines) == 1, f"{arguments} ended with {done.returncode}: {done.stderr}"
        assert lines[0].startswith("render_space.py: ") and fails in lines[0], lines[0]


class Picture:
    def __init__(self, path, width, height):
        self.colour = imread(path)[..., :3]
        assert self.colour.shape[:2] == (height, width), self.colour.shape
        r, g, b = np.moveaxis(self.colour, 2, 0)
        self.blue, self.brown = (b > r + 0.1) & (b > 0.2), (r > b + 0.1) & (r > 0.2)
        self.grey = (r > 0.5) & (r < 0.93) & (abs(b - r) < 0.12)  # the edges of the room

    def room(self):
        """The rows and columns, first and last, of the front edges of the room."""
        rows = np.flatnonzero(self.grey.mean(axis=1) > 0.2)
        columns = np.flatnonzero(self.grey.mean(axis=0) > 0.2)
        return rows[0], rows[-1], columns[0], columns[-1]


def main():
    folder = os.path.join(sys.argv[1], "space")
    shutil.rmtree(folder, ignore_errors=True)
    run, out, width, height = os.path.join(folder, "run"), os.path.join(folder, "front.png"), 900, 640
    make_run(run)
    front = (run, "--view", "0", "0", "--size", str(width), str(height), "-o", out)

    # Seen from the front the water fills a quarter of the room; with half a spacing more on its free sides it would be
    # 0.260. Its edges are rounded, which in perspective leaves 0.2 mm beside the walls; a cut has no such edges.
    for cut, quarter in (((), 0.243), (("--slice", "y", "0.75"), 0.25)):
        tool(*front, "--times", "0", *cut)
        picture = Picture(out, width, height)
        top, bottom, left, right = picture.room()
        inside = slice(top, bottom + 1), slice(left, right + 1)
        water, solid = picture.blue[inside].mean(), picture.brown[inside].mean()
        print(f"water {water:.4f} ({quarter}), solid {solid:.4f} (0.02) of the room{', cut' * bool(cut)}")
        assert abs(water - quarter) < 0.004 and 0.018 < solid < 0.026, (water, solid)

    # A pillar is drawn, and the room is as large as without it.
    with_pillar, scale = os.path.join(folder, "pillar"), (right - left) / 40
    make_run(with_pillar, [lattice((28, 0, 0), (32, 4, 15), 1)])
    before = picture.grey
    tool(with_pillar, *front[1:], "--times", "0", "--slice", "y", "0.75")
    picture = Picture(out, width, height)
    pillar = (picture.grey & ~before).sum() / scale ** 2
    print(f"pillar of {pillar:.1f} mm^2 (60)")
    assert picture.room() == (top, bottom, left, right) and 50 < pillar < 66, (picture.room(), pillar)

    # A thread one particle thick and a single one are still there, with about their volume.
    tool(*front, "--times", "10")
    picture = Picture(out, width, height)
    top, bottom, left, right = picture.room()
    middle = left + round((right - left) * 0.6)
    scale = (right - left) / 40
    thread = picture.blue[top:bottom, left + 1:middle].any(axis=0).sum() / scale
    thick = np.median(picture.blue[top:bottom, left + round(2 * scale):left + round(18 * scale)].sum(axis=0)) / scale
    drop = picture.blue[top:bottom, middle:right].sum() / scale ** 2
    print(f"thread {thread:.1f} mm long (20) and {thick:.2f} mm thick (0.56), drop of {drop:.2f} mm^2 (0.30)")
    assert 18.5 < thread < 20.5 and 0.4 < thick < 0.75 and 0.15 < drop < 0.5, (thread, thick, drop)

    tool(run, "--count", "2", "--size", "800", "400", "--field", "sponge", "stress", "--opacity", "0.5", "--title",
         "A made-up run", "-o", os.path.join(folder, "all.pdf"))
    with open(os.path.join(folder, "all.pdf"), "rb") as file:
        assert file.read(4) == b"%PDF"

    nowhere = os.path.join(folder, "none")
    tool(nowhere, fails="there is no .pvd file with a snapshot")
    tool(run, "--field", "foam", "stress", fails="no foam to colour in")
    tool(run, "--field", "sponge", "heat", fails="no number or vector heat; they have: displacement, stress")
    tool(run, "--field", "sponge", "deviator", fails="no number or vector deviator")
    tool(run, "--slice", "w", "3", fails="no axis")
    tool(run, "--slice", "y", "900", fails="is outside the scene, from")
    tool(run, "--zoom", "0", fails="--zoom 0 is not from")
    tool(run, "--walls", "vessel", "water", "sponge", fails="nothing is left to draw")
    tool(run, "--size", "60", "60", fails="too small")
    tool(run, "-o", os.path.join(nowhere, "x.png"), fails="cannot write")
    tool(run, "--movie", "x.avi", fails="must end in .mp4 or .gif")
    tool(run, "--movie", "x.mp4", fails="needs ffmpeg", PATH=nowhere)
    tool(run, fails="no xvfb-run", PATH=nowhere, DISPLAY="")
    print("pictures drawn in", folder)


main()
