#!/usr/bin/env python3
"""What must hold of every run of the sponge, whatever its numbers: a table of how near each run came to the bars.

    python3 tools/sponge_bars.py out-study/sound-r*-h2.6 -o bars.md

Reads each folder's table (sponge.csv) and all of its snapshots. Needs scipy (`sh tools/install_packages.sh studies`).

The bars: no water behind the walls; at most one particle of the water in a thousand nearer than half a spacing to the
sponge; a density within 2 % of that at rest. What has no bar is shown to be judged: how many of the water's particles
are in pairs (nearer than half a spacing to each other, as crystals would be) and how many are spray (with fewer than
ten others within 2.6 spacings, of 73 inside water).
"""

import argparse
import os

import particle_files
from picture_style import np
from plot_curves import read_table, require_columns
from tool_errors import end_with, write_text

try:
    from scipy.spatial import cKDTree
except ImportError:
    end_with("needs scipy; on Debian: sh tools/install_packages.sh studies")

SIDE = 35e-3  # m: the tank and the slab are as long as that, and as wide, but for a strip, which is periodic across
SETTLED = 60e-3  # s: the sound of the impact, at 30 ms, has died away


def beyond_the_walls(water, vessel, spacing):
    """How far behind the faces of the walls the water is, m, and the number of particles that are outside of the tank,
    where they come over its rim. Those about to leave below are not asked."""
    across = [0] if np.ptp(vessel[:, 1]) < SIDE / 2 else [0, 1]
    water = water[water[:, 2] > vessel[:, 2].min() + 2 * spacing]
    behind = np.maximum(-water[:, across], water[:, across] - SIDE).max(axis=1, initial=0)
    thickness = -vessel[:, 0].min() + spacing / 2
    in_the_walls = (behind < thickness) & (water[:, 2] < vessel[:, 2].max())
    return behind[in_the_walls].max(initial=0), (behind >= thickness).sum()


def bars_of(folder):
    """{what: text} of one run."""
    greatest = {}

    def see(what, value, time):
        greatest[what] = max(greatest.get(what, (-1.0, 0.0)), (float(value), time))

    series = {phase: particle_files.read_series(os.path.join(folder, phase + ".pvd"))
              for phase in ("water", "sponge", "vessel")}
    for (time, path), (_, sponge), (_, vessel) in zip(series["water"], series["sponge"], series["vessel"]):
        now = particle_files.read_snapshot(path)
        water, spacing = now.points.astype(float), now.constants["spacing"]
        if len(water) == 0:
            continue
        tree = cKDTree(water)
        to_sponge = tree.query(particle_files.read_snapshot(sponge).points, distance_upper_bound=spacing / 2)
        see("in the sponge", np.unique(to_sponge[1][np.isfinite(to_sponge[0])]).size / len(water), time)
        see("pairs", np.isfinite(tree.query(water, k=2, distance_upper_bound=spacing / 2)[0][:, 1]).mean(), time)
        spray = (tree.query_ball_point(water, 2.6 * spacing, return_length=True) - 1 < 10).mean()
        see("spray", spray, time)
        behind, outside = beyond_the_walls(water, particle_files.read_snapshot(vessel).points, spacing)
        see("behind the walls", behind / spacing, time)
        see("outside", outside, time)
        see("off" if time < SETTLED else "off, settled", (abs(now.arrays["density"] / 1000 - 1) > 0.02).mean(),
            time)

    if not greatest:
        end_with(f"{folder} has no snapshot with water; run with --snapshots above 0")

    path = os.path.join(folder, "sponge.csv")
    table = read_table(path)
    names = ["least density of the water", "greatest density of the water", "time"]
    require_columns(path, table, names)
    least, most, time = (table[name][1] for name in names)
    if len(time) == 0:
        end_with(f"{path} has no rows yet")

    def said(what, scale, form):
        if what not in greatest:
            return "-"
        value, when = greatest[what]
        return form.format(value * scale) + (f" at {when * 1e3:.0f} ms" if value > 0 else "")

    return {
        "reached": f"{time[-1]:.3g} s",
        "behind the faces of the walls, spacings": said("behind the walls", 1, "{:.2f}"),
        "particles over the rim": said("outside", 1, "{:.0f}"),
        "nearer than half a spacing to the sponge, of a thousand": said("in the sponge", 1e3, "{:.2f}"),
        f"density off by over 2 %, until {SETTLED * 1e3:.0f} ms": said("off", 100, "{:.2f} %"),
        "the same, later": said("off, settled", 100, "{:.2f} %"),
        "least and greatest density of any particle, kg/m³": f"{least.min():.0f}, {most.max():.0f}",
        "in pairs, of a thousand": said("pairs", 1e3, "{:.2f}"),
        "spray, greatest share": said("spray", 100, "{:.1f} %"),
        "spray at the end": f"{spray * 100:.1f} %",
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", help="the folders of the runs")
    parser.add_argument("-o", "--output", help="also write the table to this file, in Markdown")
    arguments = parser.parse_args()
    runs = [bars_of(folder) for folder in arguments.folders]
    names = [os.path.basename(os.path.normpath(folder)) for folder in arguments.folders]
    lines = ["| | " + " | ".join(names) + " |", "|---|" + "---|" * len(names)]
    lines += [f"| {what} | " + " | ".join(run[what] for run in runs) + " |" for what in runs[0]]
    print("\n".join(lines))
    if arguments.output:
        write_text(arguments.output, "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
