#!/usr/bin/env python3
"""Pictures of a three-dimensional run from its folder: water as a surface, solids as skins, several times beside each
other, or a movie of all of them.

    python3 tools/render_space.py out-dam-break --times 0 200 400 800 -o dam_break.png
    python3 tools/render_space.py out-sponge --count 4 --slice y 3.5 -o sponge.png
    python3 tools/render_space.py out-sponge --field sponge pressure --opacity 0.5 --view 30 20 -o sponge.pdf
    python3 tools/render_space.py out-dam-break --movie dam_break.mp4

Fluids are coloured by their speed, solids by how far they have been displaced (in one colour where the files do not
tell), one phase by a field of its own (--field); of walls the edges of the room between them are drawn, and what stands
in it. Needs VTK and, where there is no screen, Xvfb: sh tools/install_packages.sh pictures
"""

import argparse
import glob
import math
import os
import shutil
import subprocess
import sys
import tempfile

import particle_files
from missing_packages import SYSTEM, end_without
from picture_style import INK, SPONGE, WALL, WATER, np, plt, readable_unit, save
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize, to_rgb
from tool_errors import end_with, whole_number

REMEDY = "sh tools/install_packages.sh pictures"
try:
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (what draws)
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkLookupTable
    from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
    from vtkmodules.vtkFiltersCore import (vtkAppendPolyData, vtkClipPolyData, vtkCutter, vtkFlyingEdges3D,
                                           vtkPolyDataNormals, vtkWindowedSincPolyDataFilter)
    from vtkmodules.vtkFiltersSources import vtkOutlineSource
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                             vtkWindowToImageFilter)
except ImportError as missing:
    if os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        end_without(missing)
    end_with(f"{sys.executable} has no VTK; {REMEDY}")

DPI = 150
FRAME = "#9aa5af"  # the edges of the room between the walls
STONE = ListedColormap([WALL])  # what stands in it


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="the folder of a run")
    parser.add_argument("-o", "--output", default="space.png", help="the picture, .png or .pdf (default: space.png)")
    parser.add_argument("--movie", metavar="FILE", help="instead: a movie of all snapshots, .mp4 or .gif")
    parser.add_argument("--fps", type=whole_number, default=12, help="pictures a second of the movie (default: 12)")
    parser.add_argument("--times", nargs="+", type=float, metavar="MS",
                        help="which times, in ms (the nearest are taken)")
    parser.add_argument("--count", type=whole_number, default=4, help="how many times, evenly spaced (default: 4)")
    parser.add_argument("--fluid", nargs="+", default=["water"], metavar="PHASE",
                        help="phases drawn as liquids, coloured by their speed (default: water)")
    parser.add_argument("--walls", nargs="*", default=["tank", "plates", "vessel", "wall", "tray"], metavar="PHASE",
                        help="phases of which only the room between them is outlined, and what stands in it is drawn")
    parser.add_argument("--field", nargs=2, metavar=("PHASE", "FIELD"),
                        help="a phase to be coloured by one of its fields, and that field's name in the files")
    parser.add_argument("--opacity", type=float, default=1, help="of the liquids, 0 (not drawn) to 1 (default: 1)")
    parser.add_argument("--view", nargs=2, type=float, default=[-28, 18], metavar=("AZIMUTH", "ELEVATION"),
                        help="where the eye is, degrees: 0 0 looks along y, 90 0 against x (default: -28 18)")
    parser.add_argument("--zoom", type=float, default=1, help="how many times larger (default: 1)")
    parser.add_argument("--slice", nargs=2, metavar=("AXIS", "MM"),
                        help="cuts the scene at a position along x, y or z; what lies between cut and eye goes")
    parser.add_argument("--columns", type=whole_number, default=2, help="panels beside each other (default: 2)")
    parser.add_argument("--size", nargs=2, type=whole_number, metavar=("WIDTH", "HEIGHT"),
                        help="of the picture, in pixels (default: 1600, or 900 of one panel, as high as the scene is)")
    parser.add_argument("--title", help="a line above the picture")
    arguments = parser.parse_args()
    if arguments.slice:
        axis, position = arguments.slice
        try:
            arguments.slice = "xyz".index(axis.lower()), float(position) * 1e-3
        except ValueError:
            end_with(f"--slice {axis} {position} is no axis (x, y or z) and position in mm")
    written = arguments.movie or arguments.output
    if not os.path.isdir(os.path.dirname(written) or "."):
        end_with(f"cannot write {written}: there is no folder {os.path.dirname(written)}")
    for name, value, least, most in (("opacity", arguments.opacity, 0, 1), ("zoom", arguments.zoom, 0.01, 100)):
        if not least <= value <= most:
            end_with(f"--{name} {value:g} is not from {least:g} to {most:g}")
    if arguments.movie and not arguments.movie.endswith((".mp4", ".gif")):
        end_with(f"--movie {arguments.movie} must end in .mp4 or .gif")
    if arguments.movie and not shutil.which("ffmpeg"):
        end_with(f"a movie needs ffmpeg, which is missing; {REMEDY}")
    return arguments


def find_display():
    """VTK draws through an X server, seen or not: without one the program starts itself once more beside Xvfb."""
    if os.environ.get("DISPLAY") or sys.platform in ("win32", "darwin"):
        return
    if not (shutil.which("xvfb-run") and shutil.which("xauth")):
        end_with(f"there is no screen (DISPLAY is not set) and no xvfb-run to do without; {REMEDY}")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 640x480x24", sys.executable, *sys.argv])


# What a run holds.

class Phase:
    """A phase to be drawn: its snapshots, and what gives its colour."""

    def __init__(self, name, series, arguments):
        self.name, self.series, self.liquid = name, series, name in arguments.fluid
        self.first = self.at(series[0][0])
        self.spacing = particle_files.spacing_of(self.first)
        wall = name in arguments.walls
        self.map = WATER if self.liquid else STONE if wall else SPONGE
        if not wall and len(self.first.points) > 1 and np.ptp(self.first.points[:, 2]) == 0:
            end_with(f"{name} lies in a plane; tools/render_plane.py draws runs in two dimensions")
        arrays = self.first.arrays
        if arguments.field and arguments.field[0] == name:
            self.field = arguments.field[1]
            if self.field not in arrays or arrays[self.field].ndim > 1 and arrays[self.field].shape[1] != 3:
                known = ", ".join(sorted(key for key, of in arrays.items() if of.ndim == 1 or of.shape[1] == 3))
                end_with(f"the snapshots of {name} have no number or vector {self.field}; they have: {known}")
        else:
            self.field = next((key for key in (["velocity"] if self.liquid else ["displacement", "reference_position"])
                               if key in arrays), None)
        self.norm, self.factor, self.label = None, 1, ""

    def at(self, time):
        return particle_files.read_snapshot(min(self.series, key=lambda entry: abs(entry[0] - time))[1])

    def values(self, snapshot):
        """What gives each particle's colour; of a vector its length."""
        if self.field is None:
            return np.zeros(len(snapshot.points))
        if self.field not in snapshot.arrays:
            end_with(f"a later snapshot of {self.name} has no {self.field}")
        values = snapshot.arrays[self.field].astype(float)
        if self.field == "reference_position":
            values = snapshot.points - values
        return np.nan_to_num(values if values.ndim == 1 else np.linalg.norm(values, axis=1))

    def set_scale(self, snapshots):
        """From 0, or the least value of a field, to what one particle in 200 exceeds; in a readable unit."""
        ends = [np.percentile(self.values(s), [0.5, 99.5]) for s in snapshots if len(s.points)] or [[0, 1]]
        low, high = min(e[0] for e in ends), max(e[1] for e in ends)
        word = {"velocity": "speed", "reference_position": "displacement"}.get(self.field, self.field)
        if word in ("speed", "displacement"):
            low = 0
        self.factor, unit = readable_unit(self.first.units.get(self.field, ""), max(abs(low), abs(high)))
        self.norm = Normalize(low * self.factor, high * self.factor if high > low else low * self.factor + 1)
        self.label = f"{word.replace('_', ' ')} of the {self.name}" + (f" [{unit}]" if unit not in ("", "1") else "")


def read_run(arguments):
    """The phases to be drawn, the walls, and the times."""
    lists = {os.path.splitext(os.path.basename(path))[0]: particle_files.read_series(path)
             for path in sorted(glob.glob(os.path.join(arguments.folder, "*.pvd")))}
    lists = {name: series for name, series in lists.items() if series}
    if not lists:
        end_with(f"there is no .pvd file with a snapshot in {arguments.folder}")
    hidden = arguments.walls + (arguments.fluid if arguments.opacity == 0 else [])
    drawn = [name for name in lists if name not in hidden]
    if not drawn:
        end_with(f"nothing is left to draw in {arguments.folder}: its phases ({', '.join(lists)}) are walls or hidden")
    if arguments.field and arguments.field[0] not in drawn:
        end_with(f"there is no {arguments.field[0]} to colour in {arguments.folder}; phases drawn: {', '.join(drawn)}")
    phases = [Phase(name, lists[name], arguments) for name in drawn]
    walls = [Phase(name, lists[name], arguments) for name in arguments.walls if name in lists]
    known = sorted({time for phase in phases for time, _ in phase.series})
    if arguments.movie:
        return phases, walls, known
    if arguments.times:
        return phases, walls, [min(known, key=lambda t: abs(t - wanted * 1e-3)) for wanted in arguments.times]
    return phases, walls, [known[round(k)] for k in np.linspace(0, len(known) - 1, min(arguments.count, len(known)))]


def set_scales(phases, times):
    """Sets the scale of each phase for all the times (of many, a dozen of them); returns the box that holds all but
    strays: (low, high)."""
    some = times if len(times) < 12 else [times[k] for k in np.linspace(0, len(times) - 1, 12).astype(int)]
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for phase in phases:
        snapshots = [phase.at(time) for time in some]
        if phase.field:
            phase.set_scale(snapshots)
        for points in (s.points[np.isfinite(s.points).all(axis=1)] for s in snapshots):
            if len(points):
                most = np.percentile(points, [1, 99], axis=0)
                near = 0.04 * np.ptp(most, axis=0).max()
                low = np.minimum(low, np.maximum(points.min(axis=0), most[0] - near) - phase.spacing / 2)
                high = np.maximum(high, np.minimum(points.max(axis=0), most[1] + near) + phase.spacing / 2)
    if not (low < high).all():
        end_with("there is no particle in these snapshots")
    return low, high


def room(walls, box):
    """The room between the walls: per side, what stands there in the middle of that side, else as far as walls reach.
    Not far beyond the box of what is drawn."""
    points = np.concatenate([wall.first.points for wall in walls])
    spacing = max(wall.spacing for wall in walls)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, margin = (low + high) / 2, 0.1 * (box[1] - box[0]).max()
    inner = [low - spacing / 2, high + spacing / 2]
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        beam = points[(abs(points - middle)[:, others] < 2 * spacing).all(axis=1), axis]
        if (abs(beam - middle[axis]) < 2 * spacing).any():
            continue  # a plate there: no room
        below, above = beam[beam < middle[axis]], beam[beam > middle[axis]]
        inner[0][axis] = innermost(below, spacing) + spacing / 2 if len(below) else inner[0][axis]
        inner[1][axis] = -innermost(-above, spacing) - spacing / 2 if len(above) else inner[1][axis]
    return np.maximum(inner[0], box[0] - margin), np.minimum(inner[1], box[1] + margin)


def innermost(beam, spacing):
    """The last layer of the wall that begins with the lowest of these numbers; what stands in the room is behind a gap."""
    layers = np.unique(beam)
    return layers[np.append(np.diff(layers) > 1.5 * spacing, True)][0]


def standing_in(room, wall, time):
    """What of a wall stands in the room between the walls, such as a pillar."""
    snapshot, edge = wall.at(time), wall.spacing / 4
    inside = ((snapshot.points > room[0] + edge) & (snapshot.points < room[1] - edge)).all(axis=1)
    return particle_files.Snapshot(snapshot.points[inside], {key: of[inside] for key, of in snapshot.arrays.items()},
                                   snapshot.units, snapshot.constants)


# From particles to a surface.

def corners(at, shape):
    """For places in units of cells: the flat indices of the eight corners of each one's cell, and their shares."""
    base = np.floor(at).astype(np.int64)
    part, corner = at - base, np.array(list(np.ndindex(2, 2, 2)))[:, None]
    return np.ravel_multi_index(tuple(np.moveaxis(base + corner, 2, 0)), shape), \
        np.where(corner, part, 1 - part).prod(axis=2)


def kernel_sums(index, weights, shape, width):
    """The sums of weight W on the grid; W is a Gauss curve of that width in cells."""
    total = np.bincount(index.ravel(), weights.ravel(), np.prod(shape)).reshape(shape).astype(np.float32)
    reach = math.ceil(3.2 * width)
    taps = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2).astype(np.float32)
    one = np.empty_like(total)
    for axis in range(3):
        padded = np.moveaxis(np.pad(total, [(reach, reach) if k == axis else (0, 0) for k in range(3)]), axis, 0)
        total[:] = 0
        for k, tap in enumerate(taps / taps.sum()):  # in place: to make new arrays takes longer than to add them
            total += np.multiply(np.moveaxis(padded[k:k + shape[axis]], 0, axis), tap, out=one)
    return total


def density_image(phase, points, values):
    """A grid with `fill`, which is a half on the surface, and `value`, that gives the colour. `fill` is the sum of V W.
    Half a spacing above the topmost particles of a pool it is a half. In a thin sheet, a thread or a drop it would not
    reach that anywhere, so there each particle weighs more: so much that a thread has the volume of its particles."""
    width = (0.85 if phase.liquid else 0.55) * phase.spacing
    margin = 4.5 * width
    low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    cell = max(width / 2, (np.prod(high - low) / 3e7) ** (1 / 3))  # a grid of at most so many cells
    width = max(width, 1.2 * cell)
    enough = 0.5 * math.exp(0.5 * phase.spacing ** 2 / math.pi / width ** 2)  # amid a thread of section d^2
    shape = tuple(np.ceil((high - low) / cell).astype(int)[::-1] + 1)
    index, share = corners(((points - low) / cell)[:, ::-1], shape)
    share *= (phase.spacing / cell) ** 3
    crowd = kernel_sums(index, share, shape, width / cell).ravel()
    share *= np.maximum(1, enough / ((crowd[index] * share).sum(axis=0) / share.sum(axis=0)))
    fill = kernel_sums(index, share, shape, width / cell)
    value = kernel_sums(index, share * values, shape, width / cell) / np.maximum(fill, 1e-6)
    image = vtkImageData()
    image.SetDimensions(*shape[::-1])
    image.SetOrigin(*low)
    image.SetSpacing(cell, cell, cell)
    for name, array in (("fill", fill), ("value", value)):
        added = numpy_to_vtk(np.ascontiguousarray(array).ravel(), deep=True)
        added.SetName(name)
        image.GetPointData().AddArray(added)
    image.GetPointData().SetActiveScalars("fill")
    return image


def made(source, **settings):
    """A VTK object with these settings: Name=value calls SetName(value)."""
    for name, value in settings.items():
        getattr(source, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    return source


def chain(*filters):
    """What the last of these filters makes, each fed by the one before."""
    for before, after in zip(filters, filters[1:]):
        after.SetInputConnection(before.GetOutputPort())
    filters[-1].Update()
    return filters[-1].GetOutput()


def surface(phase, image, cut, eye):
    """The triangles of the surface; behind the plane of a cut, closed there. A liquid is cut a little further from the
    eye than a solid, that shows where both are."""
    contour = made(vtkFlyingEdges3D(), InputData=image, ComputeNormals=False, ComputeScalars=False,
                   InterpolateAttributes=True)
    contour.SetValue(0, 0.5)
    smoother = made(vtkWindowedSincPolyDataFilter(), NumberOfIterations=20, BoundarySmoothing=False,
                    NonManifoldSmoothing=True, NormalizeCoordinates=True, PassBand=0.6 if phase.liquid else 0.03)
    filters = [contour, smoother, made(vtkPolyDataNormals(), Splitting=False)]
    if not cut:
        return chain(*filters)
    axis, position = cut
    away = [0.0, 0.0, 0.0]
    away[axis] = -1.0 if eye[axis] > 0 else 1.0
    position += sum(away) * (0.05 * phase.spacing if phase.liquid else 0)
    plane = made(vtkPlane(), Origin=tuple(position * abs(a) for a in away), Normal=tuple(away))
    cap = made(vtkClipPolyData(), Value=0.48)  # a little beyond the smoothed surface: no gap between them
    cap.SetInputArrayToProcess(0, 0, 0, 0, "fill")
    both = vtkAppendPolyData()
    both.AddInputData(chain(*filters, made(vtkClipPolyData(), ClipFunction=plane)))
    both.AddInputData(chain(made(vtkCutter(), InputData=image, CutFunction=plane), cap,
                            made(vtkPolyDataNormals(), Splitting=False)))
    return chain(both)


# The scene and its picture.

def lookup_table(phase):
    if phase.norm is None:
        low, high, colours = 0, 1, phase.map(np.full(2, 0.35))
    else:
        low, high, colours = phase.norm.vmin, phase.norm.vmax, phase.map(np.linspace(0, 1, 256))
    table = made(vtkLookupTable(), NumberOfTableValues=len(colours), TableRange=(low, high))
    for k, colour in enumerate(colours):
        table.SetTableValue(k, *colour)
    return table


def actor_of(phase, snapshot, box, arguments, eye):
    """A phase at one time as VTK draws it; None where nothing of it is inside the box."""
    points = snapshot.points.astype(float)
    margin = 0.15 * (box[1] - box[0]).max()  # what flew further is out of the picture
    use = ((points >= box[0] - margin) & (points <= box[1] + margin)).all(axis=1)
    if not use.any():
        return None
    image = density_image(phase, points[use], phase.values(snapshot)[use] * phase.factor)
    mapper = made(vtkPolyDataMapper(), InputData=surface(phase, image, arguments.slice, eye),
                  LookupTable=lookup_table(phase), UseLookupTableScalarRange=True, InterpolateScalarsBeforeMapping=True)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("value")
    actor = made(vtkActor(), Mapper=mapper)
    made(actor.GetProperty(), Ambient=0.3, Diffuse=0.75, Specular=0.8 if phase.liquid else 0.12,
         SpecularPower=60 if phase.liquid else 15, Opacity=arguments.opacity if phase.liquid else 1)
    return actor


def outline(low, high):
    """The edges of a box."""
    source = made(vtkOutlineSource(), Bounds=tuple(np.column_stack([low, high]).ravel()))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = made(vtkActor(), Mapper=mapper)
    made(actor.GetProperty(), Color=to_rgb(FRAME), LineWidth=2.2, Lighting=False)
    return actor


class Camera:
    """Looks at a box, in perspective."""
    ANGLE = 22.0  # of view, upright, degrees

    def __init__(self, azimuth, elevation, zoom):
        a, e = np.radians([azimuth, np.clip(elevation, -89, 89)])
        self.eye = np.array([np.sin(a) * np.cos(e), -np.cos(a) * np.cos(e), np.sin(e)])
        self.right = np.array([np.cos(a), np.sin(a), 0])
        self.up, self.zoom = np.cross(self.eye, self.right), zoom
        self.axes = np.stack([self.right, self.up, self.eye])

    def aim(self, low, high):
        self.corners = np.array([[(low, high)[(k >> d) & 1][d] for d in range(3)] for k in range(8)]) @ self.axes.T

    def fit(self, aspect):
        """For a picture whose height is `aspect` times its width, or of the shape of the box: where the middle of the
        view and the eye's distance from it must be for the box to fill it; and height over width of the box as seen."""
        half, middle = math.tan(math.radians(self.ANGLE / 2)), self.corners.mean(axis=0)
        for _ in range(5):  # perspective moves the middle of what is seen
            offset = self.corners - middle
            reach = np.abs(offset[:, :2]) * [aspect or 0, 1] / half
            distance = (offset[:, 2] + reach.max(axis=1)).max()
            seen = offset[:, :2] * (distance / (distance - offset[:, 2]))[:, None]
            middle[:2] += (seen.min(axis=0) + seen.max(axis=0)) / 2
        return middle @ self.axes, distance, np.ptp(seen[:, 1]) / np.ptp(seen[:, 0])

    def look(self, camera, aspect):
        """Sets VTK's camera such that the box just fills a picture of this height over width."""
        focus, distance, _ = self.fit(aspect)
        made(camera, FocalPoint=tuple(focus), Position=tuple(focus + self.eye * distance * 1.02 / self.zoom),
             ViewUp=tuple(self.up), ViewAngle=self.ANGLE)


def photograph(actors, camera, width, height, depth):
    """The image of a scene, (height, width, 3). It is drawn at twice the size: smooth edges."""
    renderer = made(vtkRenderer(), Background=(1, 1, 1), AutomaticLightCreation=False)
    for actor in actors:
        renderer.AddActor(actor)
    for place, strength in (((-0.7, 1.2, 0.8), 0.75), ((0.5, 0.1, 1), 0.75)):
        light = made(vtkLight(), Position=place, FocalPoint=(0, 0, 0), Intensity=strength)
        light.SetLightTypeToCameraLight()
        renderer.AddLight(light)
    if all(actor.GetProperty().GetOpacity() == 1 for actor in actors):
        made(renderer, UseSSAO=True, SSAORadius=0.2 * depth, SSAOBias=0.01 * depth, SSAOKernelSize=128, SSAOBlur=True)
    else:
        made(renderer, UseDepthPeeling=True, MaximumNumberOfPeels=12, OcclusionRatio=0)
    window = made(vtkRenderWindow(), OffScreenRendering=True, MultiSamples=0, AlphaBitPlanes=True,
                  Size=(2 * width, 2 * height))
    window.AddRenderer(renderer)
    camera.look(renderer.GetActiveCamera(), height / width)
    renderer.ResetCameraClippingRange()
    shot = chain(made(vtkWindowToImageFilter(), Input=window, ReadFrontBuffer=False))
    pixels = vtk_to_numpy(shot.GetPointData().GetScalars()).reshape(2 * height, 2 * width, 3)[::-1] / 255
    window.Finalize()
    return (pixels[::2, ::2] + pixels[1::2, ::2] + pixels[::2, 1::2] + pixels[1::2, 1::2]) / 4


def draw(phases, walls, times, box, arguments):
    """The figure with a panel for each time and a bar for each scale."""
    camera = Camera(*arguments.view, arguments.zoom)
    scene = np.array([box, room(walls, box)] if walls else [box])
    if arguments.slice:
        axis, position = arguments.slice
        low, high = scene[:, 0, axis].min(), scene[:, 1, axis].max()
        if not low < position < high:
            end_with(f"--slice at {position * 1e3:g} mm is outside the scene, from {low * 1e3:g} to {high * 1e3:g} mm")
        scene[:, 1 if camera.eye[axis] > 0 else 0, axis] = position
    camera.aim(scene[:, 0].min(axis=0), scene[:, 1].max(axis=0))
    columns = min(arguments.columns, len(times))
    rows = -(-len(times) // columns)
    bars = [phase for phase in phases if phase.norm]
    label, top, bottom = 0.3, 0.4 * bool(arguments.title) + 0.05, 0.75 * bool(bars) + 0.05
    width = (arguments.size[0] + 0.01 if arguments.size else 1600 if columns > 1 else 900) / DPI  # cut to whole pixels
    panel = width / columns
    height = ((arguments.size[1] + 0.01) / DPI if arguments.size else
              top + bottom + rows * (label + panel * min(1.5 if columns > 1 else 1.2, camera.fit(None)[2])))
    tall = (height - top - bottom) / rows - label
    if tall < 0.3 or panel < 0.3:
        end_with(f"--size is too small for {rows} x {columns} panels and their scales")
    figure = plt.figure(figsize=(width, height))
    for k, time in enumerate(times):
        shown = [(phase, phase.at(time)) for phase in phases]
        shown += [(wall, standing_in(scene[1], wall, time)) for wall in walls]
        actors = [actor_of(phase, snapshot, box, arguments, camera.eye) for phase, snapshot in shown]
        actors = [actor for actor in actors if actor] + ([outline(*scene[1])] if walls else [])
        image = photograph(actors, camera, round(panel * DPI), round(tall * DPI), np.linalg.norm(box[1] - box[0]))
        x, y = k % columns * panel, height - top - (k // columns + 1) * (label + tall)
        axes = figure.add_axes([x / width, y / height, panel / width, tall / height])
        axes.imshow(image, interpolation="antialiased", aspect="auto")
        axes.axis("off")
        figure.text((x + panel / 2) / width, (y + tall + 0.04) / height, f"{float(f'{time * 1e3:.3g}'):.6g} ms",
                    weight="bold", ha="center", color=INK, fontsize=11)
    bar = min(3.2, (width - 0.6) / max(1, len(bars)) - 0.5)
    left = (width - len(bars) * (bar + 0.5) + 0.5) / 2
    for k, phase in enumerate(bars):
        axes = figure.add_axes([(left + k * (bar + 0.5)) / width, 0.52 / height, bar / width, 0.11 / height])
        one = figure.colorbar(ScalarMappable(phase.norm, phase.map), cax=axes, orientation="horizontal")
        one.outline.set_visible(False)
        one.set_label(phase.label, fontsize=min(9, 3.6 * (bar + 0.4)))
        axes.tick_params(labelsize=8, length=2)
        axes.locator_params(nbins=min(5, int(1.5 + 2 * bar)))
    if arguments.title:
        figure.text(0.15 / width, 1 - 0.25 / height, arguments.title, weight="bold", fontsize=12, va="center")
    return figure


def write_movie(phases, walls, times, box, arguments):
    """Draws a picture for each time and has ffmpeg join them."""
    with tempfile.TemporaryDirectory() as folder:
        for k, time in enumerate(times):
            save(draw(phases, walls, [time], box, arguments), os.path.join(folder, f"{k:06d}.png"), DPI)
        how = (["-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"] if arguments.movie.endswith(".gif") else
               ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "18"])
        done = subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(arguments.fps), "-i",
                               os.path.join(folder, "%06d.png"), *how, arguments.movie], capture_output=True, text=True)
    if done.returncode:
        end_with(f"ffmpeg cannot write {arguments.movie}: {(done.stderr.splitlines() or ['no reason given'])[-1]}")


def main():
    arguments = read_arguments()
    phases, walls, times = read_run(arguments)
    find_display()
    box = set_scales(phases, times)
    if arguments.movie:
        write_movie(phases, walls, times, box, arguments)
    else:
        save(draw(phases, walls, times, box, arguments), arguments.output, DPI)


if __name__ == "__main__":
    main()
