#!/usr/bin/env python3
"""Checks the pages (README.md, CONTRIBUTING.md, CHANGELOG.md, docs/*.md) and the comments of the headers, which are pages
too, against what they speak of:

- every block of C++ is cut from a file that is compiled. The line before it names the file:
      <!-- examples/dam_break.cpp -->                                        lines that stand there one after the other
      <!-- examples/dam_break.cpp: begin. This is the text of that file. --> all of it, up to <!-- ...: end -->
  (in a header it may stand further to the left)
- every line of CMake stands, for other names, in a file of tests/consume that the line before the block names likewise;
- every program and script that a block of commands calls is there, and so is every target it builds;
- every example is in docs/gallery.md, and every command there is also in another page or in a source;
- every term has its place in docs/policies.md, and its cost in docs/effects.md; its comment and that of every kernel and
  integrator names the source, and what it is not for;
- every link to a file, a page or a heading has where to go;
- every page, and every folder of headers, has its place in docs/site/tree.dox;
- every example is short.

    python3 docs/site/check_pages.py             says what is wrong, one line each
    python3 docs/site/check_pages.py --write     copies the whole files anew to where they are shown
"""

import glob
import os
import re
import sys

from costs import HEADERS, ROOT, lines_of
from filter import page_name, slug

GALLERY = os.path.join("docs", "gallery.md")
STUDIES = {"sponge_study.cpp"}  # programs among the examples that are not for copying
COMPILED = ("examples/", "tests/", "cases/", "studies/", "benchmarks/", "include/")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NOT_FOR = r"\b(?:Not|not to be used|not for)\b"
CUT = re.compile(r"<!-- (\S+) -->\n\Z")
WHOLE = re.compile(r"<!-- (\S+[.][ch]pp): begin[^\n]*-->\n\Z")
WHOLE_BLOCK = re.compile(r"(<!-- (\S+[.][ch]pp): begin[^\n]*-->\n).*?(<!-- \2: end -->)", re.DOTALL)


def text_of(path):
    with open(os.path.join(ROOT, path)) as file:
        return file.read()


def is_compiled(path):
    return path.startswith(COMPILED) and path.endswith((".cpp", ".hpp")) and os.path.exists(os.path.join(ROOT, path))


def faults_of_code(code, before, after):
    """What is wrong with a block of C++, given the text around it."""
    if whole := WHOLE.search(before):
        if not is_compiled(whole[1]):
            yield f"shows {whole[1]}, which is not compiled"
        elif not after.startswith(f"\n<!-- {whole[1]}: end -->") or code != text_of(whole[1]):
            yield f"does not show the text of {whole[1]}; python3 docs/site/check_pages.py --write copies it there"
    elif cut := CUT.search(before):
        if not is_compiled(cut[1]):
            yield f"cites {cut[1]}, which is not compiled"
        elif "\n" + code not in "\n" + text_of(cut[1]):
            yield f"shows lines that {cut[1]} does not have"
    else:
        yield "shows C++ and does not say from which compiled file"


def faults_of_header(path):
    """What is wrong with the blocks of C++ in the comments of a header: their lines, and how many there are."""
    comments = re.sub(r"^(?!///).*$", "", text_of(path).replace("    ///", "///"), flags=re.MULTILINE)
    comments = re.sub(r"^/// ?", "", comments, flags=re.MULTILINE)
    faults, blocks = [], 0
    for block in FENCE.finditer(comments):
        blocks += 1
        cut = CUT.search(comments[:block.start()])
        if not cut or not is_compiled(cut[1]):
            wrong = "shows C++ and does not say from which compiled file"
        elif flush_left(block[2]) not in flush_left(text_of(cut[1])):
            wrong = f"shows lines that {cut[1]} does not have"
        else:
            continue
        faults.append(f"{path}:{comments.count(chr(10), 0, block.start()) + 1}: {wrong}")
    return faults, blocks


def flush_left(code):
    return "\n" + re.sub(r"^ +", "", code, flags=re.MULTILINE)


def stand_ins():
    """What the projects of tests/consume say where a page says something that is its reader's."""
    header = text_of("include/imbibe/version.hpp")
    major, minor = (re.search(rf"VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR"))
    return {"my_program my_program.cpp": r"program \S+/main\.cpp \S+", "my_program": r"\w+",
            "/path/to/imbibe": r"\$\{IMBIBE_SOURCE\}",
            "add_subdirectory(imbibe)": r"add_subdirectory\(\$\{IMBIBE_SOURCE\} imbibe\)",
            f"imbibe {major}.{minor} ": r"imbibe \$\{EXPECTED_VERSION\} "}


def faults_of_cmake(code, before):
    """What is wrong with a block of CMake, given the text before it."""
    cut = CUT.search(before)
    if not cut or not cut[1].startswith("tests/consume/") or not os.path.exists(os.path.join(ROOT, cut[1])):
        yield "shows CMake and does not say from which file of tests/consume"
        return
    text = text_of(cut[1]).replace("include(../program.cmake)", text_of("tests/consume/program.cmake"))
    for line in code.splitlines():
        pattern = re.escape(line.split("#")[0].strip())
        for said, meant in stand_ins().items():
            pattern = pattern.replace(re.escape(said), meant)
        if not re.search(rf"^{pattern}$", text, re.MULTILINE):
            yield f"shows a line that {cut[1]} does not have: {line}"


def programs():
    """The names of all programs and targets that can be built, and the folders they are in, below that of the build."""
    for path in glob.glob(os.path.join(ROOT, "examples", "**", "*.cpp"), recursive=True):
        folder, name = os.path.split(os.path.relpath(path, os.path.join(ROOT, "examples"))[:-4])
        if folder != "support":
            yield {"guides": "guide_"}.get(folder, f"{folder}_" if folder else "") + name
    for path in glob.glob(os.path.join(ROOT, "**", "CMakeLists.txt"), recursive=True):
        folder = os.path.relpath(os.path.dirname(path), ROOT)
        for name in re.findall(r"add_(?:custom_target|executable)\((\w+)", "".join(lines_of(path))):
            yield from (name, f"{folder}/{name}")
    for path in glob.glob(os.path.join(ROOT, "benchmarks", "*.cpp")):
        name = os.path.basename(path)[:-4]
        yield from ([f"benchmarks/{name}", name] if name != "bench_widths" else
                    [f"benchmarks/{name}_{it}" for it in ("sse2", "avx2", "avx512")])
    for path in glob.glob(os.path.join(ROOT, "studies", "*.cpp")):
        name = os.path.basename(path)[:-4]
        yield from (f"studies/{name}", name)


def faults_of_commands(code, known):
    for called in re.findall(r"(?:^|[\s;&(])build[\w-]*/([\w/]+)", code):
        if called not in known | {"benchmarks", "my_program"}:
            yield f"calls {called}, a program that is not built"
    for script in re.findall(r"(?:^|[\s;&(])((?:tools|docs|\.ci)/[\w./-]+\.(?:py|sh))", code):
        if not os.path.exists(os.path.join(ROOT, script)):
            yield f"calls {script}, which is not there"
    for targets in re.findall(r"--target((?: [\w]+)+)", code):
        for target in targets.split():
            if target not in known | {"all_verify_interface_header_sets"}:
                yield f"builds {target}, which is not there"


def faults_of_the_gallery(text, pages):
    """Examples that the gallery leaves out, and commands that stand nowhere else."""
    sources = glob.glob(os.path.join(ROOT, "examples", "**", "*.cpp"), recursive=True) + \
        glob.glob(os.path.join(ROOT, "tools", "*.py"))
    for path in sorted(glob.glob(os.path.join(ROOT, "examples", "*.cpp"))):
        if f"](../examples/{os.path.basename(path)})" not in text:
            yield f"does not have {os.path.relpath(path, ROOT)}"
    elsewhere = "".join(map(text_of, [page for page in pages if page != GALLERY] + sources))
    for block in FENCE.finditer(text):
        for command in block[2].splitlines():
            if command not in elsewhere and "install_packages.sh" not in command and "--target" not in command:
                yield f"has a command that is nowhere else: {command}"


def faults_of_the_list(text):
    for path in sorted(glob.glob(os.path.join(HEADERS, "*", "*.hpp"))):
        with open(path) as file:
            public = re.sub(r"(?ms)^namespace detail \{.*?^\} // namespace detail$", "", file.read())
            for name, body in re.findall(r"^struct (\w+)[^\n]*\{\n(.*?)^\};", public, re.MULTILINE | re.DOTALL):
                is_term = re.search(r"^    using (?:parts|reads|adds|sets|stores) =", body, re.MULTILINE) and \
                    not re.search(r"^    using reduces =", body, re.MULTILINE)
                if is_term and not re.search(rf"`{name}\b", text):
                    yield f"does not have {name}"


def faults_of_comments(path):
    """Terms, kernels and integrators of a header whose comment leaves out where they are from or what they are not for."""
    public = re.sub(r"(?ms)^namespace detail \{.*?^\} // namespace detail$", "", text_of(path))
    for comment, name, body in re.findall(r"((?:^///[^\n]*\n)*)(?:^(?:template| )[^\n]*\n)*^struct (\w+)[^\n]*\{\n(.*?)^\};",
                                          public, re.MULTILINE | re.DOTALL):
        if re.search(r"^    using (?:parts|reads|adds|sets|stores) =|static void step\(", body, re.MULTILINE) or \
                "/kernels/" in path and "static constexpr const char* name" in body:
            if "Source: " not in comment:
                yield f"{path}: the comment of {name} names no source"
            if not re.search(NOT_FOR, comment):
                yield f"{path}: the comment of {name} does not say what it is not for"


def headings(path):
    """The anchors of a page."""
    found, in_code = set(), False
    for line in lines_of(path):
        if line.startswith("```"):
            in_code = not in_code
        elif line.startswith("#") and not in_code:
            found.add(slug(line.lstrip("# ")))
    return found


def faults_of_links(text, page):
    prose = re.sub(r"`[^`\n]*`", "", FENCE.sub("", text))
    for target, anchor in re.findall(r"\]\(([^)\s#]*)(?:#([^)\s]*))?\)", prose):
        if re.match(r"\w+:", target):
            continue
        path = os.path.join(ROOT, os.path.dirname(page), target) if target else os.path.join(ROOT, page)
        if not os.path.exists(path):
            yield f"links to {target}, which is not there"
        elif anchor and anchor not in headings(path):
            yield f"links to {target}#{anchor}, a heading that is not there"


def faults_of_the_tree(pages):
    """Pages and folders of headers that docs/site/tree.dox leaves out."""
    tree = text_of("docs/site/tree.dox")
    for page in pages:
        if page != "README.md" and not re.search(rf"@subpage {page_name(page)}$", tree, re.MULTILINE):
            yield f"docs/site/tree.dox does not have the page {page}"
    for folder in sorted(glob.glob(os.path.join(HEADERS, "*", ""))):
        if f"@defgroup folder_{os.path.basename(folder[:-1])} " not in tree:
            yield f"docs/site/tree.dox has no group for {os.path.relpath(folder, ROOT)}"


def main():
    pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md",
             *sorted(os.path.relpath(it, ROOT) for it in glob.glob(os.path.join(ROOT, "docs", "*.md")))]
    known, blocks = set(programs()), 0
    faults = list(faults_of_the_tree(pages))
    for page in pages:
        text = text_of(page)
        if sys.argv[1:] == ["--write"]:
            text = WHOLE_BLOCK.sub(lambda it: f"{it[1]}```cpp\n{text_of(it[2])}```\n{it[3]}", text)
            with open(os.path.join(ROOT, page), "w") as file:
                file.write(text)
        found = [(0, it) for it in faults_of_links(text, page)]
        if page in (os.path.join("docs", "policies.md"), os.path.join("docs", "effects.md")):
            found += [(0, it) for it in faults_of_the_list(text)]
        if page == GALLERY:
            found += [(0, it) for it in faults_of_the_gallery(text, pages)]
        if len(re.findall(r"^```", text, re.MULTILINE)) != 2 * len(FENCE.findall(text)):
            found.append((0, "has a block of code that does not end"))
        for block in FENCE.finditer(text):
            line = text.count("\n", 0, block.start()) + 1
            if block[1] == "cpp":
                blocks += 1
                found += [(line, it) for it in faults_of_code(block[2], text[:block.start()], text[block.end():])]
            elif block[1] == "cmake":
                found += [(line, it) for it in faults_of_cmake(block[2], text[:block.start()])]
            elif block[1] == "sh":
                found += [(line, it) for it in faults_of_commands(block[2], known)]
        faults += [f"{page}:{line}: {what}" if line else f"{page}: {what}" for line, what in found]
    faults += [f"{path} has {len(lines_of(path))} lines; an example that one would copy has less than 80"
               for path in sorted(glob.glob(os.path.join(ROOT, "examples", "*.cpp")))
               if len(lines_of(path)) >= 80 and os.path.basename(path) not in STUDIES]
    for path in sorted(glob.glob(os.path.join(HEADERS, "**", "*.hpp"), recursive=True)):
        wrong, more = faults_of_header(os.path.relpath(path, ROOT))
        faults, blocks = [*faults, *wrong, *faults_of_comments(os.path.relpath(path, ROOT))], blocks + more
    print("\n".join(faults) or f"{len(pages)} pages, {blocks} blocks of C++")
    return 1 if faults or not blocks else 0


if __name__ == "__main__":
    sys.exit(main())
