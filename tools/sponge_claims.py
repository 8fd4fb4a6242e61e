#!/usr/bin/env python3
"""Holds the paper's claims on the sponge against the tables of a study: prints which are met, and by how much.

    python3 tools/sponge_claims.py pores sound out-study/sound-r*/sponge.csv -o claims.md

The tables are given in the order of the pore radii 0.5, 1, 1.5, 2 mm (pores) or of the support radii 1, 1.1, 1.2,
1.3 mm (support). A run that broke off earlier than a claim needs leaves that claim undecided.
"""

import argparse

from picture_style import np
from plot_curves import read_table, require_columns
from tool_errors import end_with, write_text


def at(table, column, time):
    """The value of a column at a time, or None where the run did not get so far."""
    t = table["time"][1]
    if len(t) == 0 or t[-1] < time * (1 - 1e-6):
        return None
    return float(np.interp(time, t, table[column][1]))


def mean_over(table, column, begin, end):
    t, y = table["time"][1], table[column][1]
    if len(t) == 0 or t[-1] < end * (1 - 1e-3) or end <= begin:
        return None
    inside = (t >= begin) & (t <= end)
    return float(y[inside].mean()) if inside.any() else None


def verdict(met):
    return "undecided: a run ended before" if met is None else ("met" if met else "not met")


def ordered(values, falling):
    if any(v is None for v in values):
        return None
    pairs = zip(values, values[1:])
    return all(a > b for a, b in pairs) if falling else all(a < b for a, b in pairs)


def largest_first_smallest_last(values):
    """Strictly: four that are alike, as four that have not moved, are in no order."""
    if any(v is None for v in values):
        return None
    return values[0] > max(values[1:]) and values[-1] < min(values[:-1])


def millimetres(values):
    return ", ".join("-" if v is None else f"{v * 1e3:.3f}" for v in values) + " mm"


def percent(values):
    return ", ".join("-" if v is None else f"{v * 100:.2f}" for v in values) + " %"


def claims_on_pores(tables):
    displacement, drained = "mean displacement", "drained fraction"
    end = min(float(t["time"][1][-1]) for t in tables)
    peaks = [float(t[displacement][1].max()) if t["time"][1][-1] > 0 else None for t in tables]
    whole = [mean_over(t, displacement, 0, end) for t in tables]
    late = [mean_over(t, displacement, 0.6 * end, end) for t in tables]
    through = [at(t, drained, 0.075) for t in tables]
    strain = [at(t, displacement, 0.1) for t in tables]
    final = [at(t, drained, end) if end > 0 else None for t in tables]
    both = lambda a, b: None if a is None or b is None else a > b
    return [
        ("1. Mean displacement is largest for r = 0.5 h, smallest for 2 h: the greatest of the run", millimetres(peaks),
         verdict(largest_first_smallest_last(peaks))),
        (f"1. the same, mean over the run (0 to {end:.3g} s)", millimetres(whole),
         verdict(largest_first_smallest_last(whole))),
        (f"1. the same, mean from {0.6 * end:.3g} s to {end:.3g} s", millimetres(late),
         verdict(largest_first_smallest_last(late))),
        ("2. At 0.075 s more water has passed 2 h than 1.5 h", percent(through), verdict(both(through[3], through[2]))),
        ("2. At 0.1 s the strain (mean displacement) is larger for 1.5 h than for 2 h", millimetres(strain),
         verdict(both(strain[2], strain[3]))),
        (f"Drainage grows strictly with the pores ({end:.3g} s)", percent(final), verdict(ordered(final, False))),
    ]


def spread(tables, begin, end):
    """The greatest distance between any two of the curves from begin to end, in units of the greatest displacement;
    None where there is none to compare with."""
    greatest = max(t["mean displacement"][1].max() for t in tables)
    if greatest <= 0 or end <= begin:
        return None
    times = np.linspace(begin, end, 400)
    curves = np.array([np.interp(times, t["time"][1], t["mean displacement"][1]) for t in tables])
    return float((curves.max(axis=0) - curves.min(axis=0)).max() / greatest)


def claims_on_support(tables):
    end = min(float(t["time"][1][-1]) for t in tables)
    peaks = [float(t["mean displacement"][1].max()) for t in tables]
    until = min(0.15, end)
    early, late = spread(tables, 0, until), spread(tables, 0.15, end) if end > 0.15 else None
    agree = None if early is None else early < 0.1 if early >= 0.1 or until == 0.15 else None
    part = None if late is None else late > early
    apart = None if early is None else (max(peaks) - min(peaks)) / max(peaks)
    return [
        ("3. Displacements agree until 0.15 s (within 10 % of the greatest)" +
         ("" if until == 0.15 else f": until {until:.3g} s"), percent([early]), verdict(agree)),
        ("3. and part afterwards" + (f" (0.15 s to {end:.3g} s)" if end > 0.15 else ""), percent([late]),
         verdict(part)),
        ("The greatest of each run, spread " + percent([apart]), millimetres(peaks), ""),
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", choices=["pores", "support"])
    parser.add_argument("composition")
    parser.add_argument("files", nargs=4, help="the tables of the four runs")
    parser.add_argument("-o", "--output", help="also write the table to this file, in Markdown")
    arguments = parser.parse_args()
    tables = [read_table(path) for path in arguments.files]
    columns = ["time", "mean displacement", *(["drained fraction"] if arguments.study == "pores" else [])]
    for path, table in zip(arguments.files, tables):
        require_columns(path, table, columns)
        if len(table["time"][1]) == 0:
            end_with(f"{path} has no rows yet")
    rows = (claims_on_pores if arguments.study == "pores" else claims_on_support)(tables)
    order = "r = 0.5, 1, 1.5, 2 mm" if arguments.study == "pores" else "h = 1, 1.1, 1.2, 1.3 mm"
    lines = [f"| claim ({arguments.composition}) | {order} | |", "|---|---|---|"]
    rows.append(("4. Left open by the authors: K_f as a function of h, several fluids, solidification", "-",
                 "not a matter of these runs"))
    lines += [f"| {claim} | {numbers} | {said} |" for claim, numbers, said in rows]
    print("\n" + "\n".join(lines))
    if arguments.output:
        write_text(arguments.output, "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
