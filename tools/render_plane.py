#!/usr/bin/env python3
"""Pictures of a two-dimensional run from its folder, or of a slice of one in three dimensions: all phases at several
times, one panel each.

    python3 tools/render_plane.py out-elastic-gate -o gate.png
    python3 tools/render_plane.py out-elastic-gate --times 40 120 400 --fluid water --speed 2 -o gate.png
    python3 tools/render_plane.py out-dam-break --slice 140 160 -o dam_break.png
    python3 tools/render_plane.py out-soaked-sponge --walls tray plate --field sponge saturation -o soaked_sponge.png
    python3 tools/render_plane.py out-first-hour --field water pressure -o first_hour.png

Each phase is drawn as a smooth area, the kernel average of its particles' colours: the fluid by its speed, what of it is
frozen in the colour of ice, walls grey, other phases in one colour or by how far they have been displaced (--displaced).
One phase, the fluid too, can be coloured by a field of the files instead (--field). --dots draws particles as discs of
their own area.
"""

import argparse
import glob
import os

import particle_files
from picture_style import GREY, ICE, SPONGE, WALL, WATER, np, plt, save
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection
from matplotlib.colors import Normalize, to_rgba
from tool_errors import end_with, whole_number


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="the folder of a run")
    parser.add_argument("-o", "--output", default="plane.png", help="the picture (default: plane.png)")
    parser.add_argument("--times", nargs="+", type=float, metavar="MS",
                        help="which times, in ms (the nearest are taken)")
    parser.add_argument("--count", type=whole_number, default=4, help="how many times, evenly spaced (default: 4)")
    parser.add_argument("--fluid", default="water", help="the phase that is coloured by its speed (default: water)")
    parser.add_argument("--walls", nargs="*", default=["tank", "plates", "vessel", "wall"], help="phases drawn in grey")
    parser.add_argument("--speed", type=float, metavar="M/S", help="the speed at the dark end of the scale")
    parser.add_argument("--displaced", metavar="PHASE", help="a total-Lagrangian solid to be coloured by its displacement")
    parser.add_argument("--field", nargs=2, metavar=("PHASE", "FIELD"),
                        help="a phase to be coloured by one of its scalar fields, and that field's name in the files")
    parser.add_argument("--dots", action="store_true", help="draw each particle as a disc of its own area")
    parser.add_argument("--columns", type=whole_number, default=2, help="panels beside each other (default: 2)")
    parser.add_argument("--slice", nargs=2, type=float, metavar="MM",
                        help="in three dimensions: only what lies between these two y, in mm, seen along y")
    parser.add_argument("--title", help="a line above the picture")
    parser.add_argument("--dpi", type=whole_number, default=150)
    return parser.parse_args()


def flat(snapshot, between):
    """A snapshot with points in the plane of the picture; of one in three dimensions, those in the slice."""
    if between:
        here = (snapshot.points[:, 1] > between[0] * 1e-3) & (snapshot.points[:, 1] < between[1] * 1e-3)
        snapshot.arrays = {name: values[here] for name, values in snapshot.arrays.items()}
        snapshot.points = snapshot.points[here][:, [0, 2]]
    return snapshot


def nearest(series, time):
    """The path of that snapshot of a phase which is nearest to a time."""
    return min(series, key=lambda entry: abs(entry[0] - time))[1]


def fluid_colours(snapshot, shares):
    """Colours of a fluid's particles by their share of the greatest speed; ice where more than half is frozen."""
    colours = WATER(shares)
    if "liquid_fraction" in snapshot.arrays:
        colours[snapshot.arrays["liquid_fraction"] < 0.5] = to_rgba(ICE)
    return colours


def smooth(snapshot, colours, spacing, low, high, pixels=700):
    """An image of a phase over the rectangle from `low` to `high` (m): the mean of its particles' colours (n, 4) by a
    Wendland kernel, clear where the sum of the particles' areas times the kernel is below a third."""
    cell = max(max(high - low) / pixels, spacing / 12)
    columns, rows = np.ceil((high - low) / cell).astype(int)
    support = 2 * spacing
    place = (snapshot.points[:, :2] - low) / cell - 0.5
    nearest = np.rint(place).astype(int)
    sums = np.zeros((5, rows * columns))
    weights = np.concatenate([colours[:, :3], np.ones((len(colours), 1)), colours[:, 3:]], axis=1).T
    reach = int(np.ceil(support / cell))
    for i in range(-reach, reach + 1):
        for j in range(-reach, reach + 1):
            at = nearest + (i, j)
            q = np.linalg.norm(at - place, axis=1) * cell / (support / 2)
            use = (q < 2) & (at >= 0).all(axis=1) & (at < (columns, rows)).all(axis=1)
            kernel = (1 - q[use] / 2) ** 4 * (2 * q[use] + 1)
            pixel = at[use, 1] * columns + at[use, 0]
            for k in range(5):
                sums[k] += np.bincount(pixel, weights[k, use] * kernel, rows * columns)
    covered = sums[3] * spacing**2 * 7 / (np.pi * support**2)
    image = sums[[0, 1, 2, 4]] / np.maximum(sums[3], 1e-12)
    image[3] *= np.clip((covered - 0.28) / 0.1, 0, 1)
    return image.T.reshape(rows, columns, 4), (low[0], low[0] + columns * cell, low[1], low[1] + rows * cell)


def shaded(arguments, moments):
    """The values of the field by which a phase is coloured, at each of the moments, and what to call them."""
    if arguments.displaced:
        phase, field, what = arguments.displaced, "displacement", f"displacement of the {arguments.displaced} [mm]"
    else:
        phase, field = arguments.field
        what = f"{field.replace('_', ' ')} of the {phase}"
    if any(field not in moment[phase].arrays for moment in moments):
        known = ", ".join(sorted(name for name, values in moments[0][phase].arrays.items() if values.ndim == 1))
        end_with(f"the snapshots of {phase} have no {field}; numbers that they have: {known}")
    unit = moments[0][phase].units.get(field, "")
    what += f" [{unit}]" if unit not in ("", "1") and not arguments.displaced else ""
    values = [moment[phase].arrays[field] for moment in moments]
    if arguments.displaced:
        values = [1e3 * np.linalg.norm(way, axis=1) for way in values]
    elif any(of.ndim != 1 for of in values):
        end_with(f"{field} of {phase} is no single number of each particle")
    return values, what


def main():
    arguments = read_arguments()
    if arguments.displaced and arguments.field:
        end_with("--displaced and --field colour a phase each, and there is one scale for them: give one of the two")
    lists = {os.path.splitext(os.path.basename(path))[0]: particle_files.read_series(path)
             for path in glob.glob(os.path.join(arguments.folder, "*.pvd"))}
    by_field = arguments.displaced or (arguments.field and arguments.field[0])
    for phase in filter(None, (arguments.fluid, by_field)):
        if phase not in lists:
            end_with(f"there is no {phase}.pvd in {arguments.folder}")
        if not lists[phase]:
            end_with(f"{phase}.pvd in {arguments.folder} has no snapshot")
    times = np.array([time for time, _ in lists[arguments.fluid]])
    wanted = np.array(arguments.times) * 1e-3 if arguments.times else np.linspace(times[0], times[-1], arguments.count)
    steps = [int(np.argmin(abs(times - time))) for time in wanted]

    moments = [{name: flat(particle_files.read_snapshot(nearest(series, times[step])), arguments.slice)
                for name, series in lists.items() if series} for step in steps]
    if any("velocity" not in moment[arguments.fluid].arrays for moment in moments):
        end_with(f"the snapshots of {arguments.fluid} have no velocity")
    speeds = [np.linalg.norm(moment[arguments.fluid].arrays["velocity"], axis=1) for moment in moments]
    fastest = arguments.speed or max((np.percentile(speed, 99.5) for speed in speeds if len(speed)), default=0) or 1.0
    shades, shades_in_words = shaded(arguments, moments) if by_field else ([[] for _ in moments], "")
    found = [of for of in shades if len(of)]
    # Single particles do not set the scale.
    least, most = np.percentile(np.concatenate(found), [1, 99]) if found else (0, 1)
    shade = Normalize(least if arguments.field else 0, most or 1.0)
    everything = np.vstack([snapshot.points[:, :2] for moment in moments for snapshot in moment.values()]) * 1e3
    if len(everything) == 0:
        end_with("there is no particle" + (f" from y = {arguments.slice[0]:g} to {arguments.slice[1]:g} mm"
                                           if arguments.slice else " in these snapshots"))
    low, high = everything.min(axis=0), everything.max(axis=0)
    low, high = np.where(low < high, low, low - 1), np.where(low < high, high, high + 1)
    low, high = low - 0.02 * (high - low), high + 0.02 * (high - low)

    columns = min(arguments.columns, len(steps))
    rows = -(-len(steps) // columns)
    width = 4.6
    height = width * (high[1] - low[1]) / (high[0] - low[0]) + 0.5
    figure, panels = plt.subplots(rows, columns, squeeze=False, layout="constrained", sharex=True, sharey=True,
                                  figsize=(width * columns, height * rows + (1.1 if by_field not in (None, arguments.fluid) else 0)))
    scale = Normalize(0, fastest)
    for panel, step, moment, speed, values in zip(panels.flat, steps, moments, speeds, shades):
        for name, snapshot in moment.items():
            if len(snapshot.points) == 0:
                continue
            spacing = particle_files.spacing_of(snapshot)
            colours = (SPONGE(shade(values)) if name == by_field and name != arguments.fluid
                       else WATER(shade(values)) if name == by_field
                       else fluid_colours(snapshot, scale(speed)) if name == arguments.fluid
                       else np.tile(to_rgba(WALL if name in arguments.walls else SPONGE(0.7)), (len(snapshot.points), 1)))
            if arguments.dots:
                size = 2e3 * spacing / np.sqrt(np.pi)
                panel.add_collection(EllipseCollection(size, size, 0, units="xy", offsets=snapshot.points[:, :2] * 1e3,
                                                       transOffset=panel.transData, facecolors=colours, linewidths=0))
            else:
                image, extent = smooth(snapshot, colours, spacing, low * 1e-3, high * 1e-3)
                panel.imshow(image, origin="lower", extent=np.array(extent) * 1e3, interpolation="bilinear")
        panel.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        panel.set_title(f"{times[step] * 1e3:.3g} ms" if times[step] < 1 else f"{times[step]:.3g} s", fontsize=10)
        panel.tick_params(labelsize=8)
    for panel in list(panels.flat)[len(steps):]:
        panel.set_visible(False)
    for panel in panels[-1]:
        panel.set_xlabel("x [mm]", fontsize=9)
    for panel in panels[:, 0]:
        panel.set_ylabel("z [mm]" if arguments.slice else "y [mm]", fontsize=9)
    bars = []
    if by_field != arguments.fluid:
        bars.append((ScalarMappable(scale, WATER), f"speed of the {arguments.fluid} [m/s]"))
    if by_field:
        bars.append((ScalarMappable(shade, WATER if by_field == arguments.fluid else SPONGE), shades_in_words))
    for colours, label in bars:
        bar = figure.colorbar(colours, ax=panels, orientation="horizontal", shrink=0.4, aspect=40)
        bar.set_label(label, fontsize=9)
        bar.outline.set_edgecolor(GREY)
    if arguments.title:
        figure.suptitle(arguments.title, x=0.02, ha="left")
    save(figure, arguments.output, arguments.dpi)


if __name__ == "__main__":
    main()
