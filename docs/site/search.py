#!/usr/bin/env python3
"""Makes what the search of the site (search_text.js) reads beside Doxygen's lists of names: html/search/text.js, with the
text of every page of the tree and of the comment of every type and group, cut at the headings, and an index of its words
for lunr.js. Words of two letters or more, but for stop words, are in the index as they stand; search_text.js also looks for words that begin alike.

    python3 docs/site/search.py build-docs      after Doxygen; the target `docs` calls it
"""

import argparse
import glob
import html.parser
import json
import os
import re
import sys

from costs import ROOT
from neighbours import reading_order

sys.path.append(os.path.join(ROOT, "tools"))
from missing_packages import end_without
from tool_errors import end_with, read_text, write_text

try:
    from lunr import lunr
    from lunr.builder import Builder
    from lunr.stop_word_filter import stop_word_filter
except ImportError as error:
    end_without(error, "docs", "lunr")

OF_HEADERS = ("struct", "class", "concept", "group__")
EMPTY = {"area", "br", "col", "hr", "img", "input", "link", "meta", "wbr"}  # elements that have no end
INLINE = {"a", "b", "code", "em", "i", "span", "strong", "sub", "sup", "tt"}  # those that end no word
LEFT_OUT = {"compoundTemplParams", "ttc"}
WORD = re.compile(r"\w*[^\W\d_]\w+|\w+[^\W\d_]\w*")  # two letters or digits, at least one of them a letter


class Sections(html.parser.HTMLParser):
    """The text of a page that Doxygen wrote, cut at its headings: [[anchor, heading, prose, code]], the first without
    heading."""

    def __init__(self, of_headers):
        super().__init__()
        self.found, self.open = [[""] * 4], []
        self.left_out = {"table"} if of_headers else set()  # what a type costs, which docs/effects.md says
        self.code = set() if of_headers else {"fragment"}  # in a comment these are equations

    def within(self, kind):
        return any(it == kind for _, it in self.open)

    def add(self, text):
        if self.within("text") and not self.within("left out"):
            self.found[-1][1 if self.within("heading") else 3 if self.within("code") else 2] += text

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        classes = set((attributes.get("class") or "").split())
        if tag not in INLINE:
            self.add(" ")
        if tag == "a" and "anchor" in classes and self.within("heading"):
            self.found[-1][0] = attributes["id"]
        if tag in EMPTY:
            return
        kind = None
        if "textblock" in classes:
            kind = "text"
        elif classes & LEFT_OUT or tag in self.left_out:
            kind = "left out"
        elif classes & self.code:
            kind = "code"
        elif re.fullmatch("h[1-6]", tag) and self.within("text"):
            kind = "heading"
            self.found.append([""] * 4)
        self.open.append((tag, kind))

    def handle_endtag(self, tag):
        if tag not in EMPTY and any(it == tag for it, _ in self.open):
            while self.open.pop()[0] != tag:
                pass
        if tag not in INLINE:
            self.add(" ")

    def handle_data(self, data):
        self.add(data)


def title_of(text):
    """What the page of a type or a group is about."""
    title = html.unescape(re.search(r"<title>\w+: (.*?)</title>", text, re.DOTALL)[1])
    return re.sub(r"^imbibe::| Concept Reference$", "", title)


def sections(text, of_headers):
    """[[anchor, heading, text]] of a page, code last, so that the first of a word is one of prose if it can be."""
    parser = Sections(of_headers)
    parser.feed(text)
    for anchor, heading, prose, code in parser.found:
        heading, content = (re.sub(r"\s+", " ", it).strip() for it in (heading, f"{prose} {code}"))
        if heading or content and not content.startswith("A part of "):
            yield [anchor, heading, content]


def index(documents):
    """Lunr's index of the words of headings and text."""
    builder = Builder()
    builder.pipeline.add(stop_word_filter)
    fields = [{"field_name": "heading", "boost": 5}, "text"]
    made = lunr(ref="number", fields=fields, documents=documents, builder=builder).serialize()
    for _, vector in made["fieldVectors"]:
        vector[1::2] = [round(score, 2) for score in vector[1::2]]
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="where the site was built, such as build-docs")
    folder = os.path.join(parser.parse_args().build, "html")
    hand_written = {f"{name}.html": title for name, title in reading_order()}
    of_headers = sorted(os.path.basename(it) for it in glob.glob(os.path.join(folder, "*.html"))
                        if os.path.basename(it).startswith(OF_HEADERS) and not it.endswith("-members.html"))
    pages, found, documents = [], [], []
    for file in [*hand_written, *of_headers]:
        page = read_text(os.path.join(folder, file))
        title, parts = hand_written.get(file) or title_of(page), list(sections(page, file in of_headers))
        if file in hand_written and not parts:
            end_with(f"the search finds no text in {file}")
        pages += [[file, title]] if parts else []
        for anchor, heading, text in parts:
            documents.append(({"number": len(found), "heading": " ".join(WORD.findall(heading or title)),
                               "text": " ".join(WORD.findall(text))}, {"boost": 2 if file in hand_written else 1}))
            found.append([len(pages) - 1, anchor, heading, text])
    made = json.dumps({"pages": pages, "sections": found, "index": index(documents)}, ensure_ascii=False,
                      separators=(",", ":"))
    write_text(os.path.join(folder, "search", "text.js"), f"var searchText = {made};\n")
    print(f"search: {len(pages)} pages, {len(found)} sections, {len(made.encode()) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
