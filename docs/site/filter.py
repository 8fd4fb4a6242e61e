#!/usr/bin/env python3
"""What Doxygen reads in place of a header or a page of docs/ (FILTER_PATTERNS in Doxyfile.in); prints it.

In headers: the names that every term, field and kernel has by contract (`reads`, `adds`, `operator()`, ...) get the one
sentence that says what they mean, so that it is not written beside each; below each effect and each kernel stands what
it costs (costs.py); and all names are put into the group of the header's folder (tree.dox).

In pages: `Name` becomes a link to what the headers say about it, and `examples/name.cpp` one to its source; links to
other pages, to headings and to examples, written so that they work wherever Markdown is shown, become Doxygen's. All but
README.md get a table of contents. To tree.dox it adds a page for the source of each example.

    python3 docs/site/filter.py include/imbibe/fluid/continuity.hpp
"""

import glob
import os
import re
import sys

from costs import HEADERS, ROOT, lines_of, tables

# Members that mean the same wherever they stand.
CONTRACT = [
    # terms and their parts: core/term.hpp
    (r"using reads =", "The fields it reads, of the particle and of its neighbours."),
    (r"using adds =", "The fields to which it adds."),
    (r"using sets =", "The fields it sets."),
    (r"using stores =", "The fields it brings along, which no part of it computes."),
    (r"using parts =", "Its parts: functions of one particle or of a pair."),
    (r"using neighbourhood =", "The neighbours it sums over: those of the stress-free solid."),
    (r"using Parameters =", "Its coefficients."),
    (r"\w*Parameters parameters\{", "Its coefficients, those that the phase or the coupling was given."),
    (r"static constexpr bool once\b", "Evaluated when the particles are added, not in every step."),
    (r"static constexpr const char\* limit_name\b", "What its limit on the time step is called."),
    (r"static double time_step_limit\(", "The longest stable step, s."),
    (r"using reductions =", "What its fields are summed up to, or are at most or least."),
    (r"using reduces =", "What becomes of what it returns for all particles of a phase."),
    (r"static constexpr const char\* advection_limit_name\b", "What its limit on long steps is called."),
    (r"using effect =", "The equation that it is a form of, of which a phase has one only."),
    (r"static constexpr bool of_solids\b", "It asks for the elastic moduli of a solid."),
    (r"static constexpr double greatest_poisson_ratio\b", "A scene warns of a phase whose Poisson's ratio is above this."),
    (r"static constexpr bool needs_viscosity\b", "It asks for the viscosity of its phase, or of one of the two of a coupling."),
    (r"static constexpr bool one_sided\b", "It is listed in couplings only, as Into the wall or the solid."),
    (r"static constexpr bool within_phases\b", "It is listed in phases only, not in couplings."),
    (r"static constexpr bool between_fluids\b", "It is listed in phases, and in couplings of two fluids."),
    (r"static constexpr bool between_fluid_and_other\b", "It is listed in couplings of a fluid and what is none."),
    (r"using beside_in_couplings =", "What a coupling needs beside a term of its effect."),
    (r"using reacts_to =", "The terms of the same coupling that it is the reaction to."),
    (r"using corrected_kernel =", "The kernel that a gradient and its correction share."),
    (r"static constexpr bool changes_volume\b", "The volume of a fluid that fills a periodic box is not kept against it."),
    (r"using Prepared =", "What it computes of the lattice before the first step."),
    (r"Prepared prepared\{\};", "What the term has prepared."),
    (r"using pressure_kernel =", "The kernel of a pressure force whose lattice resists shear."),
    (r"using viscosity_law =", "The law that its viscosity follows."),
    (r"static constexpr bool in_packs\b", "It is called for as many particles at once as the processor computes."),
    (r".*\boperator\(\)\(const auto&( a)?, const auto&( b)?,", "What neighbour b contributes to particle a."),
    (r".*\boperator\(\)\(const auto&( a)?\) const", "The value for particle a."),
    # fields: core/field.hpp
    (r"static constexpr bool given\b", "Is it known when the particles are added?"),
    (r"static constexpr bool shown\b", "Is it written to output files?"),
    (r"static constexpr std::string_view name\b", "What it is called in files."),
    (r"static constexpr std::string_view unit\b", "Its unit."),
    (r"static constexpr std::string_view rate_name\b", "What its rate is called in files."),
    (r"static constexpr std::string_view rate_unit\b", "The unit of its rate."),
    (r"inline constexpr (Rate<)?\w+>? \w+\{\};", "The field, as lists of fields and views name it."),
    # phases and couplings: core/phase.hpp
    (r"using terms =", "Its terms."),
    (r"static constexpr bool moves\b", "Do its particles move?"),
    (r"Coefficients<.*> coefficients\{\};", "The coefficients of its terms."),
    (r"constexpr void set\(const P& parameters\)", "Replaces the coefficients of one term."),
    (r"void check\(std::string_view name\) const", "Throws Error for a number out of range; the message has the name."),
    # integrators: time/; what they evaluate: solver/composition.hpp
    (r"static void start\(Engine& engine\)", "Computes what the first step begins with."),
    (r"static void step\(Engine& engine, double dt\)", "One step of the length dt, s."),
    (r"using Rows =", "Its rows of the schedule."),
    (r"static constexpr Plan plan =", "The order of its rows."),
    (r"static constexpr Bits added =", "The columns to which its rows add."),
    (r"static constexpr bool gravity =", "Does the acceleration start from gravity, or from what is in it?"),
    # small vectors and packs: core/vector.hpp, core/pack.hpp, core/pack_functions.hpp
    (r"using Scalar =", "The type of one number."),
    (r"using Lanes =|Lanes lanes;", "The numbers, in the processor's own type."),
    (r"static constexpr int size =", "How many numbers it has."),
    (r"T c\[", "The numbers."),
    (r".*\boperator\[\]\(int", "One of the numbers, in the order in which they are stored."),
    (r".*\boperator\(\)\(int i, int j\)", "Component (i, j)."),
    (r"static constexpr \w+ zero\(\)", "All numbers zero."),
    (r"friend IMBIBE_INLINE|IMBIBE_INLINE constexpr Pack& operator", "Lane by lane."),
    (r"IMBIBE_INLINE constexpr A&? operator", "Component by component."),
    # kernels: kernels/kernel.hpp
    (r"static constexpr const char\* name\b", "What it is called in messages and tables."),
]


NAMED = r"(?:struct|class|concept|using) (?:IMBIBE_PER_BUILD )?(\w+)\b(?!.*;$| *<)"
# Several names declared at once, of which Doxygen gives the comment to the first only.
SEVERAL = (r"((?:static constexpr )?(?!return|using|struct|enum|const)[\w:]+(?:<.*>)?) (\w+[^,()]*(?:, \w+[^,]*)+);"
           r"(?: *///< (.*))?$")


def public_names():
    """{name: its full name} of the types outside namespace detail."""
    found = {}
    for folder, _, files in sorted(os.walk(HEADERS)):
        for file in sorted(files):
            spaces = []
            for line in lines_of(folder, file):
                if opened := re.match(r"(?:inline )?namespace ([\w:]+) \{", line):
                    spaces.append(opened[1])
                elif line.startswith("} // namespace") and spaces:
                    spaces.pop()
                elif (named := re.match(NAMED, line)) and spaces and "detail" not in "::".join(spaces):
                    found.setdefault(named[1], "::".join([*spaces, named[1]]))
    return found


def header(lines):
    """With a sentence for what has its meaning by contract, and the costs of the effects."""
    cost, comment, effect = tables(), [], ""
    for number, line in enumerate(lines):
        words = line.strip()
        if words.startswith("///"):
            line = readable(line, first=not comment)
            comment.append(words)
            below = lines[number + 1:number + 4]
            if lines[number] == words and not below[0].startswith("///"):
                named = re.search(r"^struct (\w+)", "\n".join(below), re.MULTILINE)
                if named and named[1] in cost:
                    line = "\n".join([line, "///", *(f"/// {it}" for it in cost[named[1]])])
            yield line
            continue
        struct = re.match(r"struct (\w+)(?:(?: :.*)? \{| :.*,$)", words)
        if struct and line == words:
            effect = struct[1]
        several = re.match(SEVERAL, words)
        if several and (comment or several[3] or "string_view" in words):
            text = several[3] or " ".join(it.removeprefix("///").strip() for it in comment)
            yield " ".join(commented(f"{several[1]} {it};", text) for it in several[2].split(", "))
        elif not comment and not (struct and line == words):
            yield commented(line, f"A part of {effect}." if struct and effect else "")
        else:
            yield line
        if not words.startswith(("template", "requires")):
            comment = []


def grouped(lines, path):
    """With all that the header declares in the group of its folder."""
    folder = os.path.basename(os.path.dirname(path))
    for line in lines:
        if re.match(r"namespace (?!.*detail).*\{$", line):
            line += f" /** @addtogroup folder_{folder} */ /** @{{ */"
        elif re.match(r"\} // namespace (?!.*detail)", line):
            line = "/** @} */ " + line
        yield line


def readable(line, first):
    """A line of a comment so that Doxygen neither takes the dot of a product for the end of a sentence nor makes the
    first letter of an equation a capital."""
    line = re.sub(r"(?<=[\w)\]*]) \. (?=[\w(\[])|(?<=[\w)])\.(?=[(\[]|grad_|x\b|x_)", " · ", line)
    line = line.replace("St. Venant", r"St.\ Venant")
    return re.sub(r"^( *///<? )(?=[a-z])", "\\1\u200b", line) if first else line


def commented(line, otherwise):
    """With the sentence of the contract before it, or another one."""
    for pattern, sentence in CONTRACT:
        if re.match(pattern, line.strip()):
            return f"/** {sentence} */ {line}"
    return f"/** {otherwise} */ {line}" if otherwise else line


def slug(heading):
    """A heading's anchor, as the forges make it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def sources():
    """The examples, as Doxygen names their pages: dam_break.cpp, guides/inflow.cpp."""
    folder = os.path.join(ROOT, "examples")
    found = glob.glob(os.path.join(folder, "**", "*.cpp"), recursive=True)
    return [it for it in sorted(os.path.relpath(path, folder) for path in found) if not it.startswith("support")]


def page(text, path):
    """A page with links that Doxygen follows."""
    names, own, programs = public_names(), page_name(path), sources()

    def link(match):
        target, _, anchor = match[2].partition("#")
        if (source := re.match(r"(?:\.\./)?examples/(.*)", target)) and source[1] in programs:
            return f"[{match[1]}](@ref {source[1]})"
        if re.match(r"\w+:", target) or (target and not target.endswith(".md")):
            return match[0]
        name = page_name(target) if target else own
        words = match[1].replace("\n", " ")  # which Doxygen wants on one line
        return f"[{words}](@ref {name}{'-' + anchor if anchor else ''})"

    def type_link(match):
        full = names.get(match[1])
        return f"[{match[0].strip('`')}](@ref {full})" if full else match[0]

    def source_link(match):
        return f"[{match[0][1:-1]}](@ref {match[1]})" if match[1] in programs else match[0]

    def heading(match):
        return f"{match[0]} {{#{own if match[1] == '#' else f'{own}-{slug(match[2])}'}}}"

    parts = re.split(r"(^```.*?^```$|^    [^\n]*$)", text, flags=re.MULTILINE | re.DOTALL)
    for k in range(0, len(parts), 2):  # between the blocks of code
        if own != "index":  # the main page has its name already
            parts[k] = re.sub(r"^(#+) (.*)$", heading, parts[k], flags=re.MULTILINE)
        parts[k] = re.sub(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)", link, parts[k])
        parts[k] = re.sub(r"(?<!\[)`(\w+)(?:<[^`\n]*>)?`(?!\])", type_link, parts[k])
        parts[k] = re.sub(r"(?<!\[)`examples/([\w/]+\.cpp)`(?!\])", source_link, parts[k])
    return "".join(parts) + ("" if own == "index" else "\n\n\\tableofcontents{html:2}")


def page_name(path):
    name = os.path.basename(path).removesuffix(".md").lower()
    return "index" if name == "readme" else name


def main():
    path = sys.argv[1]
    lines = lines_of(path)
    if path.endswith(".dox"):
        lines += [f"/** @example {it} */" for it in sources()]
        print("\n".join(lines))
    elif path.endswith(".hpp"):
        print("\n".join(grouped(header(lines), path)))
    else:
        print(page("\n".join(lines), path))


if __name__ == "__main__":
    main()
