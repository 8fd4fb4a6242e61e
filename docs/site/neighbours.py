#!/usr/bin/env python3
"""Puts links to the page before and to the page after at the foot of every page of the tree, in the order of tree.dox.

    python3 docs/site/neighbours.py build-docs      after Doxygen; the target `docs` calls it
"""

import argparse
import glob
import html
import os
import re
import sys

from costs import ROOT, lines_of
from filter import page_name

sys.path.append(os.path.join(ROOT, "tools"))
from tool_errors import end_with, read_text, write_text

FOOT = "</div><!-- contents -->"  # Doxygen's
START = ("index", "Start")


def reading_order():
    """[(name, title)] of the pages as tree.dox has them, the main page first."""
    files = [os.path.join(ROOT, "CONTRIBUTING.md"), os.path.join(ROOT, "CHANGELOG.md"),
             *glob.glob(os.path.join(ROOT, "docs", "*.md"))]
    titles = {page_name(path): lines_of(path)[0].lstrip("# ").replace("`", "") for path in files}
    order = [START]
    for line in lines_of(ROOT, "docs", "site", "tree.dox"):
        if kind := re.search(r"@page (\w+) (.*)", line):
            order.append((kind[1], kind[2]))
        elif below := re.match(r"- @subpage (\w+)", line):
            order.append((below[1], titles[below[1]]))
    return order


def links(before, after):
    """What stands at the foot of a page between these two, each (name, title) or None."""
    made = [f'<a class="{kind}" rel="{rel}" href="{page[0]}.html"><span>{word}</span>{html.escape(page[1])}</a>'
            for page, kind, rel, word in ((before, "before", "prev", "Previous"), (after, "after", "next", "Next")) if page]
    return f'<nav class="neighbours" aria-label="Previous and next page">{"".join(made)}</nav>'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="where the site was built, such as build-docs")
    folder = os.path.join(parser.parse_args().build, "html")
    order = [None, *reading_order(), None]
    for before, (name, _), after in zip(order, order[1:-1], order[2:]):
        path = os.path.join(folder, f"{name}.html")
        text = read_text(path)
        if text.count(FOOT) != 1 or 'class="neighbours"' in text:
            end_with(f"{path} has no place for the links to the pages before and after it; build the site anew")
        write_text(path, text.replace(FOOT, FOOT + "\n" + links(before, after)))


if __name__ == "__main__":
    main()
