#!/usr/bin/env python3
"""Adds the headings of the pages in docs/ to the search of the site, from each of their words on: "break" finds "A dam
break". Doxygen itself finds titles of pages and names of the headers, from their first letter on.

    python3 docs/site/search.py build-docs      after Doxygen; the target `docs` calls it
"""

import argparse
import glob
import html
import json
import os
import re
import sys

from costs import ROOT, lines_of
from filter import page_name, slug

sys.path.append(os.path.join(ROOT, "tools"))
from tool_errors import end_with, read_text, write_text

BEGIN = "var searchData=\n[\n"
SHORT = {"a", "an", "and", "at", "by", "for", "from", "in", "is", "it", "its", "of", "on", "or", "that", "the", "to",
         "with"}


def headings(path):
    """(heading, address, title of the page) of all headings of a page but its title, whose address is the page's."""
    name, title, in_code = page_name(path), None, False
    for line in lines_of(path):
        in_code ^= line.startswith("```")
        if line.startswith("#") and not in_code:
            heading = line.lstrip("# ")
            anchor = f"#{name}-{slug(heading)}" if title else ""
            title = title or heading
            yield heading.replace("`", ""), f"../{name}.html{anchor}", title


def identity(words, number):
    """What Doxygen's script compares with what is typed, and a number that no other result has."""
    return "".join(c if c.isalnum() else f"_{ord(c):02x}" for c in words.lower()) + f"_{number}"


def results():
    """{first letter: [lines of a file of the index]}"""
    found, number = {}, 100_000
    for path in sorted(glob.glob(os.path.join(ROOT, "docs", "*.md"))):
        for heading, address, title in headings(path):
            words = heading.split()
            for k, word in enumerate(words):
                if word.lower() in SHORT or not re.match("[A-Za-z]", word) or (heading == title and k == 0):
                    continue
                number += 1
                entry = [identity(" ".join(words[k:]), number), [html.escape(heading), [address, 1, html.escape(title)]]]
                found.setdefault(word[0].lower(), []).append("  " + json.dumps(entry, ensure_ascii=False))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="where the site was built, such as build-docs")
    search = os.path.join(parser.parse_args().build, "html", "search")
    letters = re.search(r'0: "(.*?)"', read_text(os.path.join(search, "searchdata.js")))[1]
    for letter, lines in results().items():
        path = os.path.join(search, f"all_{letters.index(letter):x}.js") if letter in letters else None
        text = read_text(path) if path else ""
        if BEGIN not in text:
            end_with(f"Doxygen's index has no place for what begins with {letter}")
        write_text(path, text.replace(BEGIN, BEGIN + "".join(line + ",\n" for line in lines), 1))


if __name__ == "__main__":
    main()
