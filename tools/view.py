#!/usr/bin/env python3
"""A run as one page that turns: an HTML file to be opened in a browser, without a network, from a run's folder.

    python3 tools/view.py out-sponge                        writes out-sponge/view.html
    python3 tools/view.py out-dam-break --fields speed pressure -o dam_break.html
    python3 tools/view.py out-sponge --frames 20 --points 200000

In the page the run is turned, zoomed, cut by a plane, coloured by a field and played. Particles are drawn at their true
size, as the sphere (in a plane: the disc) of their own volume. Positions are rounded to 1/65535 of the box, fields to
1/255 of their range. The page holds three.js, which `sh tools/install_packages.sh view` fetches.
"""

import argparse
import base64
import glob
import hashlib
import json
import os

import particle_files
from missing_packages import end_without
from tool_errors import end_with, read_text, whole_number, write_text

try:
    import numpy as np
except ImportError as missing:
    end_without(missing)

TOOLS = os.path.dirname(os.path.abspath(__file__))
LIBRARY = os.path.join(os.path.dirname(TOOLS), "build-view", "three")
MODULES = {"three-core": "build/three.core.min.js", "three": "build/three.module.min.js",
           "three-orbit": "examples/jsm/controls/OrbitControls.js"}  # the page's name of each, and its file
MEGABYTES = 30  # of the page, by default
PROGRAM_BYTES = 2e6  # of the page without its blocks
FRAMES, FEWEST_FRAMES = 60, 30  # by default, and before particles are left out
STILL_POINTS = 100_000  # of a phase that stands still, by default: it is stored once
FIELDS = 4  # of each phase, by default

# Fields that a reader looks for first; what is no picture of the flow; phases that are walls though they move.
FIRST = ["displacement", "speed", "temperature", "saturation", "liquid_fraction", "pressure", "density"]
NO_FIELDS = {"id", "mass", "mobility", "reference_position", "reference position", "initial position"}
WALLS = {"tank", "vessel", "wall", "walls", "lid", "sides", "tray", "plates"}


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="the folder of a run")
    parser.add_argument("-o", "--output", metavar="FILE", help="the page (default: view.html in the folder)")
    parser.add_argument("--fields", nargs="+", metavar="FIELD",
                        help=f"fields to colour by, the first of them at first (default: up to {FIELDS} of each phase)")
    parser.add_argument("--every", type=whole_number, metavar="N", help="each N-th snapshot")
    parser.add_argument("--frames", type=whole_number, metavar="N",
                        help=f"at most N snapshots, evenly spaced (default: {FRAMES}, or fewer where they are large)")
    parser.add_argument("--points", type=whole_number, metavar="N", help="about N particles in a snapshot")
    parser.add_argument("--megabytes", type=whole_number, default=MEGABYTES, metavar="N",
                        help="about how large the page may be: snapshots, then particles are left out; has no effect on "
                             f"--points (default: {MEGABYTES})")
    parser.add_argument("--size", type=float, default=1.0, help="the size of a particle, 1 being its own (default: 1)")
    parser.add_argument("--title", help="the title of the page (default: from the folder's name)")
    arguments = parser.parse_args()
    if arguments.every and arguments.frames:
        parser.error("--every and --frames both choose snapshots; give one of the two")
    if not 0 < arguments.size < 100:
        parser.error("--size must be above 0 and below 100")
    if arguments.megabytes < 4:
        parser.error("--megabytes must be at least 4")
    return arguments


def library():
    """The modules of the page, each as {name: text}."""
    paths = {name: os.path.join(LIBRARY, path) for name, path in MODULES.items()}
    if not all(os.path.exists(path) for path in paths.values()):
        end_with("three.js is missing, which the page is made with; run: sh tools/install_packages.sh view")
    return {name: read_text(path) for name, path in paths.items()}


def series_of(folder):
    """{phase: [(time, path)]} of all phases with snapshots."""
    if not os.path.isdir(folder):
        end_with(f"there is no folder {folder}")
    lists = {os.path.splitext(os.path.basename(path))[0]: particle_files.read_series(path)
             for path in sorted(glob.glob(os.path.join(folder, "*.pvd")))}
    lists = {name: entries for name, entries in lists.items() if entries}
    if not lists:
        end_with(f"there is no .pvd file with a snapshot in {folder}")
    return lists


def thinned(times, count):
    """At most `count` of the times, evenly spaced, the first and the last among them."""
    if len(times) <= count:
        return times
    return [times[round(k)] for k in np.linspace(0, len(times) - 1, count)] if count > 1 else times[-1:]


def read_fields(snapshot, names=None):
    """{name: (values, unit)} of a snapshot: scalars as they are, vectors and tensors by their magnitude."""
    found = {}
    for name, values in snapshot.arrays.items():
        if name in NO_FIELDS:
            continue
        called = name if values.ndim == 1 else "speed" if name == "velocity" else name
        if names is None or called in names:
            size = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
            found[called] = (size.astype(np.float64), snapshot.units.get(name, ""))
    return found


class Phase:
    """One phase of a run: where it is, what it is and what of it the page holds."""

    def __init__(self, name, entries, times):
        self.name = name
        self.paths = [min(entries, key=lambda entry: abs(entry[0] - time))[1] for time in times]
        self.spacing, self.still, self.solid, self.most, self.sum = None, True, False, 0, 0
        self.points, self.ranges, self.units, self.share = [], {}, {}, 1.0
        for path in dict.fromkeys(self.paths):
            self.look_at(particle_files.read_snapshot(path))
        self.wall = False

    def look_at(self, snapshot):
        """Takes in how many there are, where, and in which ranges their fields lie."""
        if len(snapshot.points) == 0:
            return
        points = snapshot.points[np.isfinite(snapshot.points).all(axis=1)]
        self.spacing = self.spacing or particle_files.spacing_of(snapshot)
        self.solid = self.solid or "displacement" in snapshot.arrays or "reference_position" in snapshot.arrays
        self.most = max(self.most, len(snapshot.points))
        self.sum += len(snapshot.points)
        if len(points):
            most = np.percentile(points, [0.1, 99.9, 2, 98], axis=0)
            here = np.array([points.min(axis=0), points.max(axis=0), *most])
            self.still = self.still and np.array_equal(here, self.points[-1] if self.points else here)
            self.points.append(here)
        for name, (values, unit) in read_fields(snapshot).items():
            values = values[np.isfinite(values)]
            if len(values):
                now = np.array([*np.percentile(values, [0.5, 99.5]), values.min(), values.max()])
                old = self.ranges.get(name, now)
                self.ranges[name] = np.where([True, False, True, False], np.minimum(old, now), np.maximum(old, now))
                self.units[name] = unit or ""
        if snapshot.arrays.get("velocity", np.zeros(1)).any():
            self.still = False

    def chosen_fields(self, wanted):
        """The fields of this phase that the page is to have."""
        if wanted:
            return [name for name in wanted if name in self.ranges]
        if self.wall:
            return []
        varied = [name for name, (_, _, least, most) in self.ranges.items() if most > least]
        return sorted(varied, key=lambda name: FIRST.index(name) if name in FIRST else len(FIRST))[:FIELDS]

    def cost(self, fields):
        """How many bytes of text all its particles take in all the frames."""
        return 4 / 3 * (6 * (self.most if self.still else self.sum) + len(fields) * self.sum)


def scale_of(least_of_most, most_of_most, least, most):
    """The range of a colour scale: all but one value in 200 at each end, from 0 if that is near, in plain numbers."""
    low, high = least_of_most, most_of_most
    if high <= low:
        low, high = least, most
    if high <= low:
        return float(low), float(low + (abs(low) or 1.0))
    if -0.05 * high < low < 0.3 * high:
        power = 10.0 ** np.floor(np.log10(high))
        steps = (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)
        return 0.0, float(next(step * power for step in steps if step * power >= high * 0.999))
    step = 10.0 ** np.floor(np.log10(high - low)) / 10
    return float(np.floor(low / step + 1e-6) * step), float(np.ceil(high / step - 1e-6) * step)


def box_of(phases):
    """The box that holds all but what flew far away: (lowest corner, highest corner)."""
    everything = np.array([here for phase in phases for here in phase.points])
    least, greatest, low, high = (getattr(everything[:, k], how)(axis=0) for k, how in
                                  enumerate(("min", "max", "min", "max")))
    near = 0.5 * max((high - low).max(), max(phase.spacing for phase in phases))
    return np.maximum(least, low - near), np.minimum(greatest, high + near)


def view_of(phases, box):
    """The box that the page shows at first: all walls, and what moves but for the few that leave them."""
    whole = [here[:2] for phase in phases for here in (phase.points if phase.wall else phase.points[:1])]
    everything = np.vstack(whole + [here[4:] for phase in phases for here in phase.points])
    edge = 0.5 * max(phase.spacing for phase in phases)
    return np.maximum(everything.min(axis=0), box[0]) - edge, np.minimum(everything.max(axis=0), box[1]) + edge


def choose_shares(phases, fields, points, most):
    """Sets the share of each phase's particles that the page holds, of whose blocks the text has `most` bytes."""
    if points:
        share = min(1.0, points / sum(phase.most for phase in phases))
        for phase in phases:
            phase.share = share
        return
    left = most
    for phase in (phase for phase in phases if phase.still):
        phase.share = min(1.0, STILL_POINTS / phase.most)
        left -= phase.share * phase.cost(fields[phase])
    moving = [phase for phase in phases if not phase.still]
    asked = sum(phase.cost(fields[phase]) for phase in moving)
    for phase in moving:
        phase.share = min(1.0, max(left, 0.1 * most) / asked)


def kept(snapshot, share, box):
    """The indices of the particles to be drawn, by id so that the same ones are in all frames, and how many lie
    outside of the box."""
    points = snapshot.points
    inside = np.isfinite(points).all(axis=1)
    inside[inside] = ((points[inside] >= box[0]) & (points[inside] <= box[1])).all(axis=1)
    identity = np.asarray(snapshot.arrays.get("id", np.arange(len(points)))).astype(np.uint64)
    order = np.argsort(identity, kind="stable")
    if share < 1:  # the hash spreads them evenly
        lot = (identity * np.uint64(0x9E3779B97F4A7C15) >> np.uint64(40)).astype(np.float64) / 2 ** 24
        inside_and_drawn = inside & (lot < share)
    else:
        inside_and_drawn = inside
    return order[inside_and_drawn[order]], int((~inside).sum())


class Blocks:
    """The numbers of the page as base64, each block once."""

    def __init__(self):
        self.texts, self.known = [], {}

    def add(self, numbers):
        """The index of the block with these numbers."""
        content = numbers.tobytes()
        key = hashlib.sha256(content).digest()
        if key not in self.known:
            self.known[key] = len(self.texts)
            self.texts.append(base64.b64encode(content).decode())
        return self.known[key]


def rounded(values, low, high, most, kind):
    """Values between low and high as whole numbers from 0 to `most`."""
    width = np.where(high > low, high - low, 1)
    share = np.clip((np.nan_to_num(values, nan=0.0) - low) / width, 0, 1)
    return np.round(share * most).astype(kind)


def encoded(phase, fields, box, flat, size, blocks):
    """What the page is told about a phase."""
    scales = {name: scale_of(*phase.ranges[name]) for name in fields}
    frames, places, outside = {}, [], []
    for path in phase.paths:
        if path not in frames:
            snapshot = particle_files.read_snapshot(path)
            chosen, lost = kept(snapshot, phase.share, box)
            values = read_fields(snapshot, fields)
            frames[path] = len(places)
            outside.append(lost)
            places.append({"count": len(chosen), "total": len(snapshot.points),
                           "places": blocks.add(rounded(snapshot.points[chosen], *box, 65535, "<u2")),
                           "values": [blocks.add(rounded(values[name][0][chosen], *scales[name], 255, "u1"))
                                      if name in values else -1 for name in fields]})
    radius = phase.spacing * ((1 / np.pi) ** 0.5 if flat else (3 / (4 * np.pi)) ** (1 / 3))
    wider = size * phase.share ** (-1 / (2 if flat else 3))
    return {"name": phase.name, "kind": "wall" if phase.wall else "solid" if phase.solid else "fluid",
            "radius": radius * wider, "share": phase.share, "frames": places, "outside": max(outside),
            "at": [frames[path] for path in phase.paths],
            "fields": [{"name": name, "unit": phase.units[name], "low": scales[name][0], "high": scales[name][1],
                        "below": bool(phase.ranges[name][2] < scales[name][0]),
                        "above": bool(phase.ranges[name][3] > scales[name][1])} for name in fields]}


def number(count):
    """A whole number with its thousands apart."""
    return f"{count:,}".replace(",", "\u202f")


def notes_of(phases, times, all_times):
    """What the page leaves out, a line each."""
    notes = []
    if len(times) < len(all_times):
        notes.append(f"{len(times)} of {len(all_times)} snapshots")
    for phase in phases:
        if phase["share"] < 1:
            drawn, total = max((frame["count"], frame["total"]) for frame in phase["frames"])
            notes.append(f"{phase['name']}: {number(drawn)} of {number(total)} particles, drawn larger to fill the "
                         "same volume")
        if phase["outside"]:
            notes.append(f"{phase['name']}: up to {number(phase['outside'])} far away, not drawn")
    return notes


def read_phases(lists, arguments):
    """The phases of the run, the times of the frames, and those of all snapshots."""
    all_times = sorted({time for time, _ in max(lists.values(), key=lambda entries: len(set(entries)))})
    times = all_times[:: arguments.every] if arguments.every else thinned(all_times, arguments.frames or FRAMES)
    phases = [Phase(name, entries, times) for name, entries in lists.items()]
    phases = [phase for phase in phases if phase.points]
    tell_walls(phases)
    if not phases:
        end_with(f"there is no particle in the snapshots of {arguments.folder}")
    return phases, times, all_times


def tell_walls(phases):
    """Says of each phase whether it is a wall: by its name, or because it alone stands still."""
    rest = all(phase.still for phase in phases)
    for phase in phases:
        phase.wall = not phase.solid and (phase.name in WALLS or (phase.still and not rest))


def check_fields(phases, wanted):
    """Ends where a field is asked for that no phase has."""
    known = sorted({name for phase in phases for name in phase.ranges})
    for name in wanted or []:
        if name not in known:
            end_with(f"no phase of the run has a field {name}; fields that there are: {', '.join(known) or 'none'}")


def whole_run(arguments):
    """All that the page is told, and the blocks with its numbers."""
    lists = series_of(arguments.folder)
    phases, times, all_times = read_phases(lists, arguments)
    check_fields(phases, arguments.fields)
    fields = {phase: phase.chosen_fields(arguments.fields) for phase in phases}
    choose_shares(phases, fields, arguments.points, 1e6 * arguments.megabytes - PROGRAM_BYTES)
    if not (arguments.every or arguments.frames or arguments.points) and len(times) > FEWEST_FRAMES:
        share = min((phase.share for phase in phases if not phase.still), default=1)
        most = max(FEWEST_FRAMES, int(share * len(times)))
        if most < len(times):  # frames are left out before particles
            arguments.frames = most
            return whole_run(arguments)

    box = box_of(phases)
    view = view_of(phases, box)
    flat = all(np.array_equal(here[0][2], here[1][2]) for phase in phases for here in phase.points)
    blocks = Blocks()
    phases.sort(key=lambda phase: (phase.wall, phase.solid))
    told = [encoded(phase, fields[phase], box, flat, arguments.size, blocks) for phase in phases]
    name = os.path.basename(os.path.abspath(arguments.folder))
    return {"title": arguments.title or name.removeprefix("out-").replace("-", " ").replace("_", " ").capitalize(),
            "flat": flat, "low": box[0].tolist(), "high": box[1].tolist(),
            "view_low": view[0].tolist(), "view_high": view[1].tolist(), "times": times, "phases": told,
            "notes": notes_of(told, times, all_times)}, blocks


def import_map(modules):
    """Each module by its name, as an address that holds its text; none of them looks for a file."""
    texts = {name: text.replace("./three.core.min.js", "three-core") for name, text in modules.items()}
    return json.dumps({"imports": {name: "data:text/javascript;base64," + base64.b64encode(text.encode()).decode()
                                   for name, text in texts.items()}})


def page(run, blocks, modules):
    """The text of the page."""
    template = read_text(os.path.join(TOOLS, "view_page.html"))
    parts = {"import map": import_map(modules), "run": json.dumps(run).replace("<", "\\u003c"),
             "blocks": "\n".join(f'<script type="text/plain" id="block{k}">{text}</script>'
                                 for k, text in enumerate(blocks.texts)),
             "program": read_text(os.path.join(TOOLS, "view_page.js"))}
    for name, text in parts.items():
        before, after = template.split(f"<!-- {name} -->")
        template = before + text + after
    return template


def main():
    arguments = read_arguments()
    modules = library()
    run, blocks = whole_run(arguments)
    path = arguments.output or os.path.join(arguments.folder, "view.html")
    text = page(run, blocks, modules)
    write_text(path, text)
    drawn = max(sum(phase["frames"][phase["at"][k]]["count"] for phase in run["phases"])
                for k in range(len(run["times"])))
    print(f"{path}: {len(run['times'])} snapshots of up to {number(drawn)} particles, "
          f"{len(text.encode()) / 1e6:.1f} MB")
    for note in run["notes"]:
        print(f"  {note}")


if __name__ == "__main__":
    main()
