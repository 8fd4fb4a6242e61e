#!/usr/bin/env python3
"""Draws what accuracy costs: the error of every run of a study against its time, and the front of those worth it.

    python3 tools/plot_accuracy.py study.csv -o study.png
    python3 tools/plot_accuracy.py study.csv --join spacing --time "pair evaluations" -o study.png
    python3 tools/plot_accuracy.py study.csv --time instructions -o study.png
    python3 tools/plot_accuracy.py study.csv --buys -o study.png       # and a table: what each choice costs and buys

The file is one that `imbibe::accuracy::write` wrote. Runs that differ on the axis `--join` alone are joined by a line;
a ring marks what is on the front: nothing else was both faster and more accurate. Bars span the repetitions. What
stands for time may be pair evaluations, or instructions where tools/accuracy_instructions.py has added them.
"""

import argparse
import textwrap

from picture_style import CURVES, GREY, np, plt, save
from matplotlib.ticker import LogFormatterSciNotation, LogLocator, NullFormatter
from tool_errors import end_with, read_text, rows_of, whole_number

COUNTED = "instructions"  # a column that not every table has
MEASURED = ["error", "least error", "greatest error", "seconds [s]", "pair evaluations", "front", "failure"]


def read_rows(path):
    """The axes' names, and each row as {column: word}; what was measured as numbers."""
    heads, *lines = rows_of(path, read_text(path)) or [[]]
    if not lines or any(name not in heads for name in MEASURED):
        end_with(f"{path} is not the table of an accuracy study")
    table = []
    for k, line in enumerate(lines, 1):
        if len(line) != len(heads):
            end_with(f"{path} has a row, number {k}, that is not of {len(heads)} columns")
        row = dict(zip(heads, line))
        for name in MEASURED[:-1] + [COUNTED] * (COUNTED in row):
            if not is_number(row[name]):
                end_with(f"{path} has a row, number {k}, with '{row[name]}' where the number of '{name}' should be")
            row[name] = float(row[name])
        table.append(row)
    return [name for name in heads if name not in (*MEASURED, COUNTED)], table


def is_beaten(row, rows, time):
    """Is another row at least as fast and as accurate, and better in one of the two?"""
    return any(other[time] <= row[time] and other["error"] <= row["error"] and
               (other[time] < row[time] or other["error"] < row["error"]) for other in rows)


def is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def print_buys(groups, labels, join, time):
    """A row for each choice but the base's, where both did the most work; choices that never came to that are named."""
    base = {row[join]: row for row in next(iter(groups.values()))}
    print(f"| choice | {join} | {time} / base's | error | base's error |\n|---|---|---|---|---|")
    for choice, group in list(groups.items())[1:]:
        shared = [row for row in group if row[join] in base]
        if shared:
            row = max(shared, key=lambda one: one["pair evaluations"])
            first = base[row[join]]
            print(f"| {labels[choice]} | {row[join]} | {row[time] / first[time]:.2f} | {row['error']:.2%} | "
                  f"{first['error']:.2%} |")
        else:
            print(f"| {labels[choice]} | none that the base has | | | |")


def label_ticks(axis):
    """At twice and five times a power of ten as well, where fewer than two powers are in the picture."""
    low, high = np.log10(axis.get_view_interval())
    if np.floor(high) - np.ceil(low) + 1 < 2:
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(LogFormatterSciNotation(minor_thresholds=(np.inf, np.inf)))
        axis.set_minor_formatter(NullFormatter())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="CSV file of a study")
    parser.add_argument("-o", "--output", default="accuracy.png", help="the picture to write (default: accuracy.png)")
    parser.add_argument("--join", help="join runs that differ on this axis alone (default: the first axis)")
    parser.add_argument("--time", default="seconds [s]", choices=["seconds [s]", "pair evaluations", COUNTED],
                        help="what is meant by time (default: seconds)")
    parser.add_argument("--buys", action="store_true", help="print what each choice costs and buys beside the base")
    parser.add_argument("--title", help="a line above the picture")
    parser.add_argument("--dpi", type=whole_number, default=150)
    arguments = parser.parse_args()

    axes, rows = read_rows(arguments.file)
    join = arguments.join or axes[0]
    if join not in axes:
        parser.error(f"there is no axis '{join}'; the axes are: {', '.join(axes)}")
    if arguments.time not in rows[0]:
        end_with(f"{arguments.file} has no instructions; tools/accuracy_instructions.py counts them")
    drawn = [row for row in rows if np.isfinite(row["error"]) and row["error"] > 0 and row[arguments.time] > 0]
    if not drawn:
        end_with(f"no run in {arguments.file} came to an end")

    others = [axis for axis in axes if axis != join]
    varied = [axis for axis in others if len({row[axis] for row in rows}) > 1]
    groups = {}
    for row in drawn:
        groups.setdefault(tuple(row[axis] for axis in varied), []).append(row)

    base = next(iter(groups))
    labels = {}
    for choice in groups:
        words = [word if not is_number(word) else f"{axis} {word}" for axis, word in zip(varied, choice)]
        labels[choice] = ", ".join(word for word, own, first in zip(words, choice, base)
                                   if choice == base or own != first)
    if arguments.buys:
        print_buys(groups, labels, join, arguments.time)

    figure, panel = plt.subplots(figsize=(8, 5.2))
    markers = "osD^vP*X"
    for k, (choice, group) in enumerate(groups.items()):
        group.sort(key=lambda row: row[arguments.time])
        time = [row[arguments.time] for row in group]
        error = np.array([row["error"] for row in group])
        spread = [error - [row["least error"] for row in group], [row["greatest error"] for row in group] - error]
        panel.errorbar(time, error, yerr=np.maximum(spread, 0), color=CURVES[k % len(CURVES)],
                       marker=markers[k // len(CURVES) % len(markers)], markersize=4.5, linewidth=1.1, capsize=2,
                       label=textwrap.fill(labels[choice], 44))
        for row in group:
            panel.annotate(row[join], (row[arguments.time], row["error"]), textcoords="offset points", xytext=(4, 4),
                           fontsize=6.5, color=GREY)
    front = [row for row in drawn if not is_beaten(row, drawn, arguments.time)]
    panel.plot([row[arguments.time] for row in front], [row["error"] for row in front], "o", markersize=11,
               markerfacecolor="none", markeredgecolor=GREY, markeredgewidth=1.1, label="on the front", zorder=0)
    panel.set(xscale="log", yscale="log", ylabel="error",
              xlabel="processor time [s]" if arguments.time.startswith("seconds") else arguments.time)
    label_ticks(panel.xaxis)
    label_ticks(panel.yaxis)
    panel.grid(True, which="both")
    panel.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5), title=f"numbers: {join}", title_fontsize=8)
    if arguments.title:
        panel.set_title(arguments.title, loc="left")
    figure.tight_layout()
    save(figure, arguments.output, arguments.dpi)
    failed = len(rows) - len(drawn)
    print(f"{arguments.output}: {len(drawn)} runs, {len(front)} on the front" +
          (f"; {failed} did not come to an end" if failed else ""))


if __name__ == "__main__":
    main()
