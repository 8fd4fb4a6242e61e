#!/usr/bin/env python3
"""Fails where a header includes one of a folder that stands behind its own in the table of CONTRIBUTING.md.

    python3 tests/rooms/check_rooms.py
"""
import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def order():
    """The folders of include/imbibe/ as the table has them, from the ground up."""
    with open(os.path.join(ROOT, "CONTRIBUTING.md"), encoding="utf-8") as page:
        table = page.read().split("| folder | holds |", 1)[1].split("\n\n", 1)[0]
    return [folder for row in table.splitlines()[2:] for folder in re.findall(r"`(\w+)`", row.split("|")[1])]


def main():
    folders = order()
    found = sorted(os.path.basename(path) for path in glob.glob(os.path.join(ROOT, "include/imbibe/*"))
                   if os.path.isdir(path))
    if sorted(folders) != found:
        sys.exit(f"check_rooms.py: CONTRIBUTING.md has the folders {sorted(folders)}, include/imbibe/ {found}")
    headers = glob.glob(os.path.join(ROOT, "include/imbibe/*/*.hpp"))
    wrong = []
    for path in sorted(headers):
        own = os.path.basename(os.path.dirname(path))
        with open(path, encoding="utf-8") as header:
            for folder, name in re.findall(r"#include <imbibe/(\w+)/(\w+\.hpp)>", header.read()):
                if folders.index(folder) > folders.index(own):
                    wrong.append(f"{os.path.relpath(path, ROOT)} includes {folder}/{name}")
    if wrong:
        sys.exit("check_rooms.py: of a folder that stands later in the table of CONTRIBUTING.md:\n" + "\n".join(wrong))
    print(f"{len(headers)} headers in {len(folders)} folders")


main()
