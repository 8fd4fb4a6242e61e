"""What each effect and each kernel costs, read from the tables of docs/effects.md and docs/speed.md, for the pages of
their types."""

import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
HEADERS = os.path.join(ROOT, "include", "imbibe")


def lines_of(*path):
    with open(os.path.join(*path)) as file:
        return file.read().splitlines()


def rows(page, heading):
    """The cells of the rows of the table that begins with this heading."""
    inside = False
    for line in lines_of(ROOT, "docs", page):
        if line.startswith(heading):
            inside = True
        elif inside and not line.startswith("|"):
            return
        elif inside and "---" not in line:
            yield [cell.strip() for cell in line.strip("|").split("|")]


def effects():
    """{effect: [(what was measured, numbers)]}"""
    found, base = {}, ""
    for effect, *numbers, _ in rows("effects.md", "| effect |"):
        own, _, other = effect.partition(" in place of ")
        names = re.findall(r"`(\w+)", own)
        if effect.startswith("**"):
            base = effect.strip("*").partition(":")[0]
        for name in names:
            if effect.startswith("**"):
                what = f"[all of {base}](@ref effects)"
            else:
                rest = "".join(f" and {it}" for it in names if it != name)
                what = f"[{'in' if other else 'beside'} {base}{rest}](@ref effects)"
            found.setdefault(name, []).append((what + (f" in place of {other}" if other else ""), numbers))
    for name, time, _ in rows("speed.md", "| term | ns per particle |"):
        name, _, once = name.partition(" ")
        words = " ".join(["alone in a sweep", *once.split()])
        found.setdefault(name, []).append((f"[{words}](@ref speed)", ["", "", "", "", time]))
    return found


def kernels():
    """{kernel: [(a value or a gradient, numbers)]}"""
    named = {}
    for file in os.listdir(os.path.join(HEADERS, "kernels")):
        text = "\n".join(lines_of(HEADERS, "kernels", file))
        for struct, name in re.findall(r"^struct (\w+) \{\n.*? name = \"(.*?)\"", text, re.MULTILINE):
            named[name.lower()] = struct
    found = {}
    for kernel, *numbers in rows("speed.md", "| kernel |"):
        name, _, what = kernel.rpartition(", ")
        found.setdefault(named[name.lower()], []).append((f"[a {what}](@ref speed)", numbers))
    return found


def tables():
    """{effect or kernel: the lines that say in its comment what it costs}"""
    made = {}
    for found, heading in ((effects(), "| per particle | bytes | sweeps | loads | instructions | ns |"),
                           (kernels(), "| ns | float, one | float, packs | double, one | double, packs |")):
        for name, measured in found.items():
            made[name] = ["@par Cost", "", heading, "| --- |" + " ---: |" * (heading.count("|") - 2),
                          *(f"| {what} | {' | '.join(numbers)} |" for what, numbers in measured)]
    for part, cost in rows("effects.md", "| part |"):
        made[part.strip("`")] = ["@par Cost", cost[0].upper() + cost[1:] + "."]
    for kind, names in rows("policies.md", "| | Policies |"):
        if kind not in ("Methods", "Time", "Watching", "Bodies", "Put together"):
            for name in re.findall(r"`(\w+)", names):
                if name not in made and name[0].isupper():
                    raise SystemExit(f"costs.py: nothing says what {name} costs: give it a row in docs/effects.md")
                made.setdefault(name, ["@par Cost", "None in a step: called when the scene is set up."])
    return made
