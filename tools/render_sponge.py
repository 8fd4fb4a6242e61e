#!/usr/bin/env python3
"""Pictures of water and sponge from a run's folder (water.pvd, sponge.pvd and, if there, vessel.pvd or wall.pvd).

    python3 tools/render_sponge.py out/sponge -o snapshots.png
    python3 tools/render_sponge.py out/sponge --times 0 25 50 100 --view cut -o cut.png

Above: the whole scene in perspective. Below: a cut through the middle of the slab, seen from the front; what lies
behind the cut fades to grey. Every particle is drawn at its true size, as the sphere of its own volume. Water is
coloured by its speed, the sponge by how far it has moved from where it started.
"""

import argparse
import os

import particle_files
from picture_style import GREY, INK, SPONGE, WALL, WATER, np, plt, save
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgb
from splatting import Canvas, halved
from tool_errors import end_with, whole_number


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="the folder of a run")
    parser.add_argument("-o", "--output", default="snapshots.png", help="the picture (default: snapshots.png)")
    parser.add_argument("--times", nargs="+", type=float, metavar="MS",
                        help="which times, in ms (the nearest are taken)")
    parser.add_argument("--count", type=whole_number, default=5, help="how many times, evenly spaced (default: 5)")
    parser.add_argument("--view", choices=("both", "cut", "space"), default="both", help="which views (default: both)")
    parser.add_argument("--thickness", type=float, metavar="MM",
                        help="how much is shown behind the cut, in mm (default: half a pore pitch if known, else 3.5)")
    parser.add_argument("--speed", type=float, metavar="M/S", help="the speed at the dark end of the blue scale")
    parser.add_argument("--displacement", type=float, metavar="MM", help="the same for the sponge's scale")
    parser.add_argument("--title", help="a line above the picture")
    parser.add_argument("--dpi", type=whole_number, default=150)
    return parser.parse_args()


SPHERE = (3 / (4 * np.pi)) ** (1 / 3)  # radius of the sphere that has the volume of a cube of side 1


class Moment:
    """What is drawn of one time: positions in mm, the quantity that gives the colour, spacing in mm, by phase."""

    def __init__(self, time):
        self.time, self.points, self.value, self.spacing, self.pitch, self.unplaced = time, {}, {}, {}, None, 0


def displacement(now, first):
    """How far each particle of the sponge is from where it started, m; None if the files do not tell."""
    arrays = now.arrays
    if "displacement" in arrays:
        return np.linalg.norm(arrays["displacement"], axis=1)
    for name in ("reference position", "reference_position", "initial position"):
        if name in arrays:
            return np.linalg.norm(now.points - arrays[name], axis=1)
    if "id" in arrays and "id" in first.arrays and len(now.points) == len(first.points):
        start = np.empty_like(first.points)
        start[np.argsort(arrays["id"])] = first.points[np.argsort(first.arrays["id"])]
        return np.linalg.norm(now.points - start, axis=1)
    return None


def read_moments(folder, times, count):
    """The chosen moments of a run."""
    series = {}
    for phase, name in (("water", "water"), ("sponge", "sponge"), ("wall", "wall"), ("wall", "vessel")):
        path = os.path.join(folder, name + ".pvd")
        if os.path.exists(path):
            series[phase] = particle_files.read_series(path)
    moving = [phase for phase in ("water", "sponge") if series.get(phase)]
    if not moving:
        end_with(f"there is no water.pvd or sponge.pvd with a snapshot in {folder}")
    known = sorted(set.intersection(*({time for time, _ in series[phase]} for phase in moving)))
    if not known:
        end_with(f"water and sponge in {folder} have no time in common")
    if times:
        chosen = [min(known, key=lambda time: abs(time - wanted * 1e-3)) for wanted in times]
    else:
        chosen = [known[round(k)] for k in np.linspace(0, len(known) - 1, max(1, min(count, len(known))))]

    first = {phase: particle_files.read_snapshot(series[phase][0][1]) for phase in moving}
    moments = []
    for time in sorted(set(chosen)):
        moment = Moment(time)
        for phase, entries in series.items():
            if not entries:
                continue
            path = min(entries, key=lambda entry: abs(entry[0] - time))[1]
            snapshot = particle_files.read_snapshot(path)
            points = snapshot.points * 1e3
            keep = np.isfinite(points).all(axis=1)
            moment.unplaced += int((~keep).sum())
            value = None
            if phase == "water" and "velocity" in snapshot.arrays:
                value = np.linalg.norm(snapshot.arrays["velocity"], axis=1)
            elif phase == "sponge":
                value = displacement(snapshot, first["sponge"])
                value = None if value is None else value * 1e3
                moment.pitch = snapshot.constants.get("pore_pitch")
            moment.points[phase] = points[keep]
            moment.value[phase] = None if value is None else np.nan_to_num(value[keep])
            moment.spacing[phase] = particle_files.spacing_of(first.get(phase, snapshot)) * 1e3
        moments.append(moment)
    return moments


def scale_for(moments, phase, wanted):
    """From 0 to the value that one particle in 200 exceeds, rounded up to a plain number."""
    values = [m.value[phase] for m in moments if m.value.get(phase) is not None and len(m.value[phase])]
    if not values:
        return None
    top = wanted or max(np.percentile(v, 99.5) for v in values)
    if top <= 0:
        top = 1.0
    if not wanted:
        power = 10 ** np.floor(np.log10(top))
        top = next(step * power for step in (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10) if step * power >= top * 0.999)
    return Normalize(0, top, clip=True)


def colours(moment, phase, scales):
    count = len(moment.points[phase])
    if phase == "wall":
        return np.tile(to_rgb(WALL), (count, 1))
    scale_map = WATER if phase == "water" else SPONGE
    value = moment.value[phase]
    if value is None or scales[phase] is None:
        return np.tile(scale_map(0.35)[:3], (count, 1))
    return scale_map(scales[phase](value))[:, :3]


def frame_of(moments, phases):
    """The box, mm, that holds all but a few stray particles at all the times: (lowest corner, highest corner). It is
    never much larger than what there was at first, so that a run that flew apart still gives a picture."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for moment in moments:
        for phase in phases:
            points = moment.points.get(phase)
            if points is not None and len(points):
                edge = SPHERE * moment.spacing[phase]
                most = np.percentile(points, [0.1, 99.9], axis=0)
                near = 0.15 * (most[1] - most[0]).max()  # a few that are not far away are let in
                least, greatest = points.min(axis=0), points.max(axis=0)
                low = np.minimum(low, np.where(least > most[0] - near, least, most[0]) - edge)
                high = np.maximum(high, np.where(greatest < most[1] + near, greatest, most[1]) + edge)
    start = np.concatenate([moments[0].points[phase] for phase in phases])
    more = np.ptp(start, axis=0).max()
    return np.maximum(low, start.min(axis=0) - more), np.minimum(high, start.max(axis=0) + more)


def widened(frame, walls):
    """The frame with as much of the walls (points, mm) as stands close around it: a tank that is to hold splashes may
    be three times as high as the water."""
    low, high = frame
    if walls is None or not len(walls):
        return frame
    some = 0.1 * (high - low).max()
    return (np.minimum(low, np.maximum(walls.min(axis=0) - 0.5, low - some)),
            np.maximum(high, np.minimum(walls.max(axis=0) + 0.5, high + some)))


def cut_view(moment, frame, middle, thickness, scales, pixels_per_mm):
    """The image of the cut y = middle, seen along y, for the frame (x, z)."""
    low, high = frame
    scale = 2 * pixels_per_mm
    canvas = Canvas(int((high[0] - low[0]) * scale), int((high[2] - low[2]) * scale))
    for phase in ("wall", "sponge", "water"):
        if phase not in moment.points:
            continue
        behind = moment.points[phase][:, 1] - middle
        use = (behind > -0.75 * moment.spacing[phase]) & (behind < thickness)
        points = moment.points[phase][use]
        canvas.spheres((points[:, 0] - low[0]) * scale, (points[:, 2] - low[2]) * scale, -points[:, 1] * scale,
                       np.full(len(points), SPHERE * moment.spacing[phase] * scale),
                       colours(moment, phase, scales)[use])
    return halved(canvas.image(depth_cue=1 / (thickness * scale), front=-middle * scale, sphere=0.55))


class Camera:
    """Looks at the middle of a box from the front, somewhat from the right and above, in perspective."""

    def __init__(self, low, high, around=-28.0, above=14.0):
        around, above = np.radians([around, above])
        self.centre = (low + high) / 2
        self.right = np.array([np.cos(around), np.sin(around), 0])
        forward = np.array([-np.sin(around) * np.cos(above), np.cos(around) * np.cos(above), -np.sin(above)])
        self.back, self.up = -forward, np.cross(self.right, forward)
        self.distance = 2.6 * np.linalg.norm(high - low)
        corners = np.array([[(low, high)[(k >> d) & 1][d] for d in range(3)] for k in range(8)])
        x, y, _, _ = self.seen(corners)
        self.low, self.high = np.array([x.min(), y.min()]), np.array([x.max(), y.max()])

    def seen(self, points):
        """x and y in the picture (mm at the centre's distance), depth towards the viewer, and the magnification."""
        offset = points - self.centre
        depth = offset @ self.back
        grow = self.distance / np.maximum(self.distance - depth, 0.2 * self.distance)
        return (offset @ self.right) * grow, (offset @ self.up) * grow, depth, grow


def space_view(moment, camera, scales, pixels_per_mm):
    """The image of the scene in perspective."""
    scale = 2 * pixels_per_mm
    width, height = np.ceil((camera.high - camera.low) * scale).astype(int)
    canvas = Canvas(width, height)
    for phase in ("sponge", "water"):
        if phase not in moment.points or not len(moment.points[phase]):
            continue
        x, y, depth, grow = camera.seen(moment.points[phase])
        canvas.spheres((x - camera.low[0]) * scale, (y - camera.low[1]) * scale, depth * scale,
                       SPHERE * moment.spacing[phase] * scale * grow, colours(moment, phase, scales))
    size = scale * max(moment.spacing.get(phase, 0) for phase in ("sponge", "water"))
    return halved(canvas.image(sphere=0.45, surface=0.75, occlusion=0.6, size=size))


def outside(moment, frame):
    """How many particles the frame leaves out, those with a position that is not a number among them."""
    low, high = frame
    return moment.unplaced + sum(int(((moment.points[phase] < low) | (moment.points[phase] > high)).any(axis=1).sum())
               for phase in ("water", "sponge") if phase in moment.points)


def draw(moments, arguments):
    phases = [phase for phase in ("water", "sponge") if phase in moments[0].points]
    body = frame_of(moments, phases)
    frame = widened(body, moments[0].points.get("wall"))
    scales = {"water": scale_for(moments, "water", arguments.speed),
              "sponge": scale_for(moments, "sponge", arguments.displacement)}
    slab = moments[0].points.get("sponge", moments[0].points.get("water"))
    middle = (slab[:, 1].min() + slab[:, 1].max()) / 2
    pitch = next((m.pitch * 1e3 for m in moments if m.pitch), 7.0)
    thickness = arguments.thickness or pitch / 2
    camera = Camera(*body)

    # Sizes in inches: one width for all columns, heights as the contents need.
    column = {1: 4.2, 2: 3.2, 3: 3.2}.get(len(moments), 2.5)
    left, right, gap, bottom = 0.25 if arguments.view == "space" else 0.72, 0.15, 0.12, 1.2
    top = 0.45 + 0.3 * bool(arguments.title)
    rows = []
    if arguments.view in ("both", "space"):
        rows.append(("space", column * (camera.high - camera.low)[1] / (camera.high - camera.low)[0]))
    if arguments.view in ("both", "cut"):
        rows.append(("cut", column * (frame[1] - frame[0])[2] / (frame[1] - frame[0])[0]))
    width = left + len(moments) * (column + gap) - gap + right
    height = top + sum(size for _, size in rows) + 0.15 * (len(rows) - 1) + bottom
    figure = plt.figure(figsize=(width, height))

    def place(k, row):
        y = height - top - sum(size for _, size in rows[: row + 1]) - 0.15 * row
        return figure.add_axes([(left + k * (column + gap)) / width, y / height, column / width, rows[row][1] / height])

    for k, moment in enumerate(moments):
        for row, (view, _) in enumerate(rows):
            axes = place(k, row)
            if row == 0:
                axes.set_title(f"{moment.time * 1e3:.3g} ms", weight="bold", color=INK)
            if view == "space":
                axes.imshow(space_view(moment, camera, scales, column * arguments.dpi / (camera.high - camera.low)[0]),
                            interpolation="antialiased")
                axes.axis("off")
                continue
            low, high = frame
            axes.imshow(cut_view(moment, frame, middle, thickness, scales, column * arguments.dpi / (high - low)[0]),
                        extent=(low[0], high[0], low[2], high[2]), interpolation="antialiased", aspect="equal")
            axes.set_xlabel("x [mm]")
            axes.locator_params(nbins=5)
            if k == 0:
                axes.set_ylabel("z [mm]")
            else:
                axes.tick_params(labelleft=False)
            lost = outside(moment, frame)
            if lost:
                axes.annotate(f"{lost} particle{'s' * (lost > 1)} outside", (1, 0), (0, -27), xycoords="axes fraction",
                              textcoords="offset points", ha="right", va="top", fontsize=7, color=GREY)

    bars = [(scales["water"], WATER, "water speed [m/s]"), (scales["sponge"], SPONGE, "sponge displacement [mm]")]
    bars = [bar for bar in bars if bar[0]]
    bar = min(3.2, (width - left - right - 0.5) / max(1, len(bars)))
    for k, (scale, colour_map, words) in enumerate(bars):
        axes = figure.add_axes([(left + k * (bar + 0.5)) / width, 0.48 / height, bar / width, 0.1 / height])
        one = figure.colorbar(ScalarMappable(scale, colour_map), cax=axes, orientation="horizontal")
        one.outline.set_visible(False)
        one.set_label(words, fontsize=9)
        axes.tick_params(labelsize=8, length=2)
        axes.locator_params(nbins=5)
    if arguments.title:
        figure.text(left / width, 1 - 0.25 / height, arguments.title, weight="bold", fontsize=12, va="center")
    save(figure, arguments.output, arguments.dpi)


def main():
    arguments = read_arguments()
    draw(read_moments(arguments.folder, arguments.times, arguments.count), arguments)


if __name__ == "__main__":
    main()
