#!/usr/bin/env python3
"""Draws columns of one or more CSV files that imbibe wrote against time.

    python3 tools/plot_curves.py out/sponge.csv -o curves.png
    python3 tools/plot_curves.py a/run.csv b/run.csv --y "mean displacement" --labels "r = h" "r = 2 h" -o both.png

Columns of different units get a panel each; names and units come from the first line of the files.
"""

import argparse
import os
import re

from picture_style import CURVES, DASHES, np, plt, readable_unit, save
from tool_errors import end_with, read_text, rows_of, whole_number


def read_table(path):
    """{name: (unit, values)} of a CSV file whose first line names the columns as `name [unit]`. Columns of words are
    left out, and a last line that is not complete, as a run still going or killed may leave it."""
    content = read_text(path)
    lines = rows_of(path, content[: content.rfind("\n") + 1])
    if not lines:
        end_with(f"{path} is empty")
    heads = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", head).groups() for head in lines[0]]
    if any(len(line) != len(heads) for line in lines):
        end_with(f"{path} has a row that is not of {len(heads)} columns")
    table = {}
    for k, (name, unit) in enumerate(heads):
        try:
            table[name] = (unit or "", np.array([float(line[k]) for line in lines[1:]]))
        except ValueError:
            pass
    return table


def require_columns(path, table, names):
    """Ends the program where the table that is from `path` lacks one of these columns."""
    for name in names:
        if name not in table:
            end_with(f"{path} has no column '{name}'; it has: {', '.join(table)}")


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", help="CSV files")
    parser.add_argument("-o", "--output", default="curves.png", help="the picture to write (default: curves.png)")
    parser.add_argument("--x", default="time", help="the column along the horizontal axis (default: time)")
    parser.add_argument("--y", nargs="+", help="the columns to draw (default: all others)")
    parser.add_argument("--labels", nargs="+", help="what to call the files in the legend (default: their names)")
    parser.add_argument("--title", help="a line above the picture")
    parser.add_argument("--dpi", type=whole_number, default=150)
    arguments = parser.parse_args()
    if arguments.labels and len(arguments.labels) != len(arguments.files):
        parser.error(f"{len(arguments.labels)} labels for {len(arguments.files)} files")
    return arguments


def names_of(files):
    """The shortest names that tell the files apart: their own, or with their folders if those are the same."""
    short = [os.path.splitext(os.path.basename(path))[0] for path in files]
    if len(set(short)) == len(short):
        return short
    return [os.path.basename(os.path.dirname(os.path.abspath(path))) or path for path in files]


def main():
    arguments = read_arguments()
    tables = [read_table(path) for path in arguments.files]
    labels = arguments.labels or names_of(arguments.files)
    columns = arguments.y or [name for name in tables[0] if name != arguments.x]
    for path, table in zip(arguments.files, tables):
        require_columns(path, table, [arguments.x, *columns])

    panels = {}
    for name in columns:
        panels.setdefault(tables[0][name][0], []).append(name)

    def largest(names):
        values = np.concatenate([table[name][1] for table in tables for name in names])
        values = np.abs(values[np.isfinite(values)])
        return values.max() if len(values) else 0.0

    x_factor, x_unit = readable_unit(tables[0][arguments.x][0], largest([arguments.x]))
    height = 4.4 if len(panels) == 1 else 2.5 * len(panels) + 0.6
    figure, all_axes = plt.subplots(len(panels), 1, sharex=True, squeeze=False, figsize=(7.5, height),
                                    layout="constrained")
    for axes, (unit, names) in zip(all_axes[:, 0], panels.items()):
        factor, shown = readable_unit(unit, largest(names))
        for f, (table, label) in enumerate(zip(tables, labels)):
            for c, name in enumerate(names):
                several = len(tables) > 1
                axes.plot(table[arguments.x][1] * x_factor, table[name][1] * factor,
                          color=CURVES[(f if several else c) % len(CURVES)],
                          linestyle=DASHES[c % len(DASHES)] if several else "-",
                          label=", ".join([label] * several + [name] * (len(names) > 1)))
        name = names[0] if len(names) == 1 else ""
        axes.set_ylabel(" ".join(part for part in (name, f"[{shown}]" if shown else "") if part))
        axes.grid(True)
        axes.margins(x=0.01)
        if len(names) > 1 or (len(tables) > 1 and axes is all_axes[0, 0]):
            many = len(axes.lines) > 6  # then there is no room for it among the curves
            axes.legend(fontsize=9, **(dict(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=2) if many else {}))
    all_axes[-1, 0].set_xlabel(f"{arguments.x} [{x_unit}]" if x_unit else arguments.x)
    if arguments.title:
        figure.suptitle(arguments.title, x=0.02, ha="left", weight="bold", fontsize=11)
    save(figure, arguments.output, arguments.dpi)


if __name__ == "__main__":
    main()
