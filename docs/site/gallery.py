#!/usr/bin/env python3
"""Puts views that turn into the gallery of the site: tools/view.py makes one of the folder of each run, beside the pages,
and a click on the picture of that run opens it there. A picture whose run is not given stays alone.

    build/sponge --quick && build/dam_break
    sh tools/install_packages.sh docs view
    cmake --preset docs && cmake --build --preset docs --target gallery

The target makes the site and calls:

    python3 docs/site/gallery.py build-docs out-sponge out-dam-break
"""

import argparse
import os
import subprocess
import sys

from costs import ROOT

sys.path.append(os.path.join(ROOT, "tools"))
from tool_errors import end_with, read_text, write_text

# The folder of a run: its picture in docs/gallery.md, and the program that makes it.
RUNS = {"out-sponge": ("sponge_surface.png", "build/sponge --quick"),
        "out-dam-break": ("dam_break_space.png", "build/dam_break")}
MEGABYTES = 10  # of a view
PICTURE = '<img src="{}" alt=""/>'
LINK = '<a class="turn" href="{}">{}<span>Turn it</span></a>'
# The first click puts the view in the place of the picture, the second opens it alone.
SCRIPT = """<script type="text/javascript">
for (const link of document.querySelectorAll('a.turn'))
    link.addEventListener('click', event => {
        event.preventDefault();
        const view = document.createElement('iframe');
        view.src = link.href + '#playing&paper=' +
            (document.documentElement.classList.contains('dark-mode') ? 'dark' : 'light');
        view.title = 'A view that turns';
        link.before(view);
        link.innerHTML = '<span>Fill the window</span>';
        link.parentElement.classList.add('turning');
        view.scrollIntoView({ block: 'nearest' });
    }, { once: true });
</script>
"""


def with_view(text, picture, view):
    """The text of the page, in which the picture opens the view."""
    image = PICTURE.format(picture)
    if LINK.format(view, image) in text:
        return text
    if image not in text:
        end_with(f"the gallery does not show {picture}; build the site anew: cmake --build --preset docs")
    return text.replace(image, LINK.format(view, image), 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="where the site was built, such as build-docs")
    parser.add_argument("runs", nargs="+", metavar="RUN", help=f"the folder of a run: {', '.join(RUNS)}")
    arguments = parser.parse_args()
    html = os.path.join(arguments.build, "html")
    path = os.path.join(html, "gallery.html")
    text = read_text(path)
    for folder in arguments.runs:
        name = os.path.basename(os.path.abspath(folder))
        if name not in RUNS:
            end_with(f"the gallery has no view of {name}; it has one of {' and '.join(RUNS)}")
        picture, command = RUNS[name]
        if not os.path.isdir(folder):
            end_with(f"there is no folder {folder}; make it: {command}")
        view = name.replace("out-", "view-") + ".html"
        if subprocess.call([sys.executable, os.path.join(ROOT, "tools", "view.py"), folder, "--megabytes", str(MEGABYTES),
                            "-o", os.path.join(html, view)]):
            sys.exit(1)
        text = with_view(text, picture, view)
    write_text(path, text if SCRIPT in text else text.replace("</body>", SCRIPT + "</body>"))


if __name__ == "__main__":
    main()
