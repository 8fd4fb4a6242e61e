"""How the pictures of imbibe look: one plain style, the colours, and saving to a file."""

from missing_packages import end_without
from tool_errors import end_with

try:
    import matplotlib

    matplotlib.use("Agg")  # draws into files; needs no screen
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.colors import LinearSegmentedColormap
except ImportError as missing:
    end_without(missing)

INK, GREY, FAINT = "#22303c", "#6b7783", "#dfe4e8"

# Eight colours that differ for colour-blind readers and in print.
CURVES = ["#1f6fb4", "#d9822b", "#2f8f6b", "#b5478a", "#7a6a3a", "#5b5fc7", "#c2413b", "#4a5560"]
DASHES = ["-", "--", ":", "-."]

# Pale at rest, dark when something happens: on white paper a thin fast jet must not vanish.
WATER = LinearSegmentedColormap.from_list("water", ["#b4d8ee", "#6db1da", "#2a7ab9", "#0b4787", "#07244f"])
SPONGE = LinearSegmentedColormap.from_list("sponge", ["#ecd6a6", "#ebbb70", "#e08a45", "#b84a2b", "#6e1f1c"])
WALL = "#c9d0d6"
ICE = "#ded9f0"

plt.rcParams.update({
    "font.family": "sans-serif", "font.size": 10, "text.color": INK,
    "axes.edgecolor": GREY, "axes.labelcolor": INK, "axes.linewidth": 0.7, "axes.titlesize": 11,
    "axes.spines.top": False, "axes.spines.right": False,
    "xtick.color": GREY, "ytick.color": GREY, "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7, "xtick.major.size": 3, "ytick.major.size": 3,
    "grid.color": FAINT, "grid.linewidth": 0.7, "legend.frameon": False, "lines.linewidth": 1.7,
    "figure.facecolor": "white", "savefig.facecolor": "white",
})

PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def readable_unit(unit, largest):
    """The factor and the unit in which `largest` reads between 1 and 1000: 0.003 of "m" is 3 "mm"."""
    base = {"kg": "g"}.get(unit, unit)
    scale = 1000.0 if unit == "kg" else 1.0
    if base not in ("m", "s", "g", "J", "W", "N", "Pa") or not np.isfinite(largest) or largest <= 0:
        return 1.0, unit
    for size, prefix in PREFIXES:
        if base in ("m", "s") and size > 1:  # nobody counts in kiloseconds
            continue
        if base == "g" and size == 1e3 and largest * scale >= size:
            return 1.0, "kg"
        if largest * scale >= size:
            return scale / size, prefix + base
    return 1.0, unit


def save(figure, path, dpi):
    """Writes the picture, or ends with one line that says why not."""
    try:
        figure.savefig(path, dpi=dpi)
    except (OSError, ValueError) as error:
        end_with(f"cannot write {path}: {error}")
    plt.close(figure)
