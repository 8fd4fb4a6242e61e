#!/usr/bin/env python3
"""Tells what of the differences between the cases of a study is theirs, and what is chance: each case was run several
times (build/sponge_study support --repeats 4), and splashes fall in another way each time.

    python3 tools/sponge_repeats.py a1.csv a2.csv b1.csv b2.csv --repeats 2 --labels a b -o repeats.png

Draws the mean of each case with the range of its runs, and prints, until several times, in shares of the greatest
displacement: how far the runs of one case part, how far the means of the cases part, and how far these means would part
on average if all runs were of one case. That is the mean range of so many normally distributed numbers with the
variance within the cases, divided by the number of repeats; like the others it is the greatest over time.
"""

import argparse

from picture_style import CURVES, np, plt, readable_unit, save
from plot_curves import read_table, require_columns
from tool_errors import end_with, whole_number


def read_curves(files, repeats, column):
    """times [s] and curves[case, repeat, time] of a column, up to the time that all runs have reached; its unit."""
    tables = [read_table(path) for path in files]
    for path, table in zip(files, tables):
        require_columns(path, table, ["time", column])
        if len(table["time"][1]) < 2:
            end_with(f"{path} has fewer than two rows")
    end = min(table["time"][1][-1] for table in tables)
    times = np.linspace(0, end, 1001)
    curves = np.array([np.interp(times, table["time"][1], table[column][1]) for table in tables])
    return times, curves.reshape(-1, repeats, len(times)), tables[0][column][0]


def mean_range_of_normal(number):
    """The mean difference between the greatest and the least of so many standard normal numbers: the integral of
    1 - P^n - (1 - P)^n over x, where P is their distribution function."""
    from math import erf, sqrt

    x = np.linspace(-8, 8, 4001)
    below = np.array([0.5 * (1 + erf(v / sqrt(2))) for v in x])
    return float(np.sum(1 - below**number - (1 - below) ** number) * (x[1] - x[0]))


def spreads(curves):
    """Over time: how far the runs of a case part at most, how far the means part, and how far chance parts means."""
    cases, repeats, _ = curves.shape
    within = np.ptp(curves, axis=1).max(axis=0)
    between = np.ptp(curves.mean(axis=1), axis=0)
    deviation = np.sqrt(curves.var(axis=1, ddof=1).mean(axis=0) / repeats)
    return within, between, mean_range_of_normal(cases) * deviation


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", help="the tables of the runs, those of a case one after the other")
    parser.add_argument("--repeats", type=int, required=True, help="runs of each case, 2 or more")
    parser.add_argument("--column", default="mean displacement", help="of the tables (default: mean displacement)")
    parser.add_argument("--until", type=float, nargs="+", default=[0.15, 0.25, 0.5], help="times, s; those after the end of a run count as it (default: 0.15 0.25 0.5)")
    parser.add_argument("--labels", nargs="+", help="what to call the cases")
    parser.add_argument("-o", "--output", default="repeats.png", help="the picture to write (default: repeats.png)")
    parser.add_argument("--dpi", type=whole_number, default=150)
    arguments = parser.parse_args()
    if arguments.repeats < 2 or len(arguments.files) % arguments.repeats:
        parser.error(f"{len(arguments.files)} files are not {arguments.repeats} runs a case; 2 or more are needed")
    number = len(arguments.files) // arguments.repeats
    if number < 2:
        parser.error("one case only; there is nothing to compare")
    labels = arguments.labels or [f"case {k + 1}" for k in range(number)]
    if len(labels) != number:
        parser.error(f"{len(labels)} labels for {number} cases")

    times, curves, unit = read_curves(arguments.files, arguments.repeats, arguments.column)
    greatest = np.abs(curves).max()
    if greatest == 0:
        end_with(f"'{arguments.column}' is 0 in all runs")
    within, between, by_chance = spreads(curves)
    print("| until, s | runs of one case part by | means of the cases part by | by chance they would by |")
    print("|---|---|---|---|")
    for until in sorted({min(until, times[-1]) for until in arguments.until}):
        row = [f"{100 * spread[times <= until].max() / greatest:.1f} %" for spread in (within, between, by_chance)]
        print(f"| {until:.3g} | {' | '.join(row)} |")

    x_factor, x_unit = readable_unit("s", times[-1])
    factor, shown = readable_unit(unit, greatest)
    figure, (top, bottom) = plt.subplots(2, 1, sharex=True, figsize=(7.5, 6), height_ratios=[2, 1], layout="constrained")
    for k, label in enumerate(labels):
        colour = CURVES[k % len(CURVES)]
        top.fill_between(times * x_factor, curves[k].min(axis=0) * factor, curves[k].max(axis=0) * factor,
                         color=colour, alpha=0.2, linewidth=0)
        top.plot(times * x_factor, curves[k].mean(axis=0) * factor, color=colour, label=label)
    top.set_ylabel(f"{arguments.column} [{shown}]")
    top.set_title(f"mean and range of {arguments.repeats} runs each", loc="left")
    for spread, label, colour in ((within, "runs of one case", CURVES[7]), (between, "means of the cases", CURVES[0]),
                                  (by_chance, "means, by chance", CURVES[1])):
        bottom.plot(times * x_factor, 100 * spread / greatest, color=colour, label=label)
    bottom.set_ylabel("farthest apart [%]")
    bottom.set_xlabel(f"time [{x_unit}]")
    for axes in (top, bottom):
        axes.grid(True)
        axes.margins(x=0.01)
        axes.legend(fontsize=9)
    save(figure, arguments.output, arguments.dpi)


if __name__ == "__main__":
    main()
