#!/usr/bin/env python3
"""Makes pages of small made-up runs with tools/view.py and opens them in Chromium, without a screen. Usage:
view_page.py FOLDER. Ends with 77, and says why, where three.js or Chromium is missing."""

import os
import re
import shutil
import subprocess
import sys

try:
    import numpy as np
    from matplotlib.image import imread
except ImportError as missing:
    sys.exit(f"{missing.name} is missing; install python3-matplotlib")

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
VIEW = os.path.join(ROOT, "tools", "view.py")
GALLERY = os.path.join(ROOT, "docs", "site", "gallery.py")
LIBRARY = os.path.join(ROOT, "build-view", "three", "package.json")
SKIPPED = 77
KINDS = {"f": "Float32", "i": "Int32"}


def lattice(low, high, spacing):
    axes = [np.arange(a + spacing / 2, b, spacing) for a, b in zip(low, high)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)


def write_vtp(path, points, arrays, units, spacing):
    """A file such as output/vtk.hpp writes; without a spacing if there is none."""
    blocks, described, offset = [], [], 0
    for name, values in [("position", points), *arrays.items()]:
        values = np.ascontiguousarray(values, "<i4" if name == "id" else "<f4")
        components = 1 if values.ndim == 1 else values.shape[1]
        described.append(f'<DataArray type="{KINDS[values.dtype.kind]}" Name="{name}" '
                         f'NumberOfComponents="{components}" format="appended" offset="{offset}">'
                         f'<InformationKey name="UNITS_LABEL" location="vtkDataArray">{units.get(name, "m")}</InformationKey></DataArray>')
        blocks.append(np.uint64(values.nbytes).tobytes() + values.tobytes())
        offset += len(blocks[-1])
    constant = spacing and ('<DataArray type="Float64" Name="spacing" NumberOfTuples="1" format="ascii">'
                            f'{spacing}</DataArray>')
    with open(path, "wb") as file:
        file.write(('<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
                    f'header_type="UInt64"><PolyData><FieldData>{constant or ""}</FieldData><Piece NumberOfPoints='
                    f'"{len(points)}"><Points>{described[0]}</Points><PointData>{"".join(described[1:])}</PointData>'
                    '</Piece></PolyData><AppendedData encoding="raw">_').encode())
        file.write(b"".join(blocks) + b"</AppendedData></VTKFile>")


def make_run(folder, frames, flat, n=10):
    """A block of water that sinks, shrinks by a layer at each of the times, and comes in another order, over a floor.
    Returns how many there are of it at each of the times, and how many of the floor."""
    os.makedirs(folder)
    s, rng = 1e-3, np.random.default_rng(1)
    depth = s if flat else n * s
    water, floor = lattice((0, 0, 0), (n * s, n * s, depth), s), lattice((0, 0, 0), (2 * n * s, 3 * s, depth), s)
    axis = 1 if flat else 2
    if flat:
        water[:, 2] = floor[:, 2] = 0
        floor -= (0, 6 * s, 0)
    else:
        floor = floor[:, [0, 2, 1]] - (0, 0, 6 * s)
    counts, lists = [], {"water": "", "tank": ""}
    for k in range(frames):
        here = np.flatnonzero(water[:, 0] > k * s)
        here = rng.permutation(here)
        points = water[here].copy()
        points[:, axis] -= 0.3 * s * k
        arrays = {"id": here, "velocity": np.tile([0.0, 0.0, 0.0], (len(here), 1)), "pressure": 9810 * points[:, axis]}
        arrays["velocity"][:, axis] = -0.1 * k
        units = {"velocity": "m/s", "pressure": "Pa"}
        write_vtp(os.path.join(folder, f"water_{k}.vtp"), points, arrays, units, None if flat else s)
        write_vtp(os.path.join(folder, f"tank_{k}.vtp"), floor, {"pressure": np.zeros(len(floor))}, units, s)
        for name in lists:
            lists[name] += f'<DataSet timestep="{0.0123456 * k!r}" part="0" file="{name}_{k}.vtp"/>\n'
        counts.append(len(here))
    for name, entries in lists.items():
        with open(os.path.join(folder, name + ".pvd"), "w") as file:
            file.write(f'<VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
    return counts, len(floor)


def view(*arguments, fails=None):
    done = subprocess.run([sys.executable, VIEW, *arguments], capture_output=True, text=True)
    if fails is None:
        assert done.returncode == 0, f"view.py {arguments}\n{done.stdout}{done.stderr}"
    else:
        last = (done.stderr.splitlines() or [""])[-1]
        assert done.returncode in (1, 2) and last.startswith("view.py: ") and fails in last, \
            f"view.py {arguments} ended with {done.returncode} and said: {done.stderr}"
        assert "Traceback" not in done.stderr, done.stderr
    return done.stdout


def chromium(program, folder, page, *options):
    """What Chromium prints when it is given a page."""
    done = subprocess.run(
        [program, "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars",
         f"--user-data-dir={os.path.join(folder, 'profile')}", "--window-size=600,400", "--virtual-time-budget=3000",
         *options, "file://" + page], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


def seen(program, folder, page, where=""):
    """{name: value} of what the page says of itself when it has drawn, and its text."""
    text = chromium(program, folder, page + where, "--dump-dom")
    said = dict(re.findall(r' data-(\w+)="([^"]*)"', re.search(r"<body[^>]*>", text)[0]))
    assert "error" not in said, said["error"]
    assert "drawn" in said, "the page has drawn nothing"
    return said, text


def refuse_bad_input(folder, run):
    """One line each, and no traceback."""
    view(os.path.join(folder, "none"), fails="there is no folder")
    empty = os.path.join(folder, "empty")
    os.makedirs(empty)
    view(empty, fails="there is no .pvd file with a snapshot")
    with open(os.path.join(empty, "water.pvd"), "w") as file:
        file.write("<VTKFile type='Collection'><Collection></Collection></VTKFile>")
    view(empty, fails="there is no .pvd file with a snapshot")
    view(run, "--fields", "colour", fails="field colour; fields that there are: pressure, speed")
    view(run, "--every", "2", "--frames", "3", fails="give one of the two")
    view(run, "--frames", "0", fails="above 0")
    view(run, "--size", "nan", fails="above 0")
    view(run, "--megabytes", "3", fails="at least 4")
    view(run, "-o", os.path.join(folder, "none", "x.html"), fails="cannot write")


def look_at_pages(program, folder, run, counts, walls, plane, plane_counts, plane_walls):
    """Opens the pages of both runs."""
    page = os.path.join(folder, "space.html")
    said = view(run, "-o", page)
    assert f"{len(counts)} snapshots of up to 1\u202f600 particles" in said, said
    with open(page, encoding="utf-8") as file:
        text = file.read()
    assert not re.search(r'(src|href)="(?!data:)', text), "the page loads something"
    body, text = seen(program, folder, page)
    assert body["drawn"] == body["counted"] == str(counts[0] + walls), body
    assert "t = 0 ms" in text and ">Space<" in text
    body, text = seen(program, folder, page, f"#frame={len(counts) - 1}")
    assert body["drawn"] == str(counts[-1] + walls) and body["frame"] == str(len(counts) - 1), (body, counts)
    assert "t = 37.0 ms" in text, re.search(r't = [^<]*', text)[0]
    body, _ = seen(program, folder, page, "#cut=z,0.5&look.tank=hidden&field.water=pressure")
    assert 0 < int(body["counted"]) < counts[0] == int(body["drawn"]), body

    _, text = seen(program, folder, page, "#playing&paper=dark")
    assert 'aria-label="Pause"' in text and '<html lang="en" data-paper="dark">' in text, text[:200]

    # Keys step through it.
    with open(page, encoding="utf-8") as file:
        text = file.read()
    with_keys = os.path.join(folder, "keys.html")
    with open(with_keys, "w", encoding="utf-8") as file:
        file.write(text.replace("</body>", """<script type="module">
            for (const key of ["ArrowRight", "ArrowRight", "ArrowLeft"])
                document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
            </script></body>"""))
    body, _ = seen(program, folder, with_keys)
    assert body["frame"] == "1" and body["drawn"] == str(counts[1] + walls), (body, counts)

    picture = os.path.join(folder, "space.png")
    chromium(program, folder, page, "--screenshot=" + picture)
    colour = imread(picture)[:, :300, :3]
    blue = (colour[..., 2] > colour[..., 0] + 0.1).mean()
    assert blue > 0.02, f"a share of {blue} of the picture is blue"

    body, text = seen(program, folder, page_of(plane, folder, "plane", "--fields", "pressure"))
    assert body["drawn"] == str(plane_counts[0] + plane_walls), body
    page = page_of(run, folder, "thinned", "--points", "500", "--every", "3")
    body, text = seen(program, folder, page)
    assert 400 < int(body["drawn"]) < 600 and "particles, drawn larger" in text and "2 of 4 snapshots" in text, body


def put_into_a_gallery(program, folder):
    """The script of the site puts a view beside the gallery, to which the picture of the run leads."""
    run, html = os.path.join(folder, "out-dam-break"), os.path.join(folder, "html")
    counts, walls = make_run(run, 2, flat=False)
    os.makedirs(html)
    page = os.path.join(html, "gallery.html")
    with open(page, "w", encoding="utf-8") as file:
        file.write('<html><body><div><img src="dam_break_space.png" alt=""/></div></body></html>')
    for _ in range(2):  # the second time changes nothing
        subprocess.run([sys.executable, GALLERY, folder, run], check=True, capture_output=True)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        assert text.count('<a class="turn" href="view-dam-break.html"><img') == text.count("<script") == 1, text
    body, _ = seen(program, folder, os.path.join(html, "view-dam-break.html"))
    assert body["drawn"] == str(counts[0] + walls), body
    with open(page, "w", encoding="utf-8") as file:
        file.write(text.replace("</body>", "<script>document.querySelector('a.turn').click();</script></body>"))
    text = chromium(program, folder, page, "--dump-dom")
    assert re.search(r'<iframe src="[^"]*view-dam-break.html#playing&amp;paper=light"', text), text
    for arguments, said in (((folder, os.path.join(folder, "out-space")), "has no view of out-space"),
                            ((folder, os.path.join(folder, "none", "out-sponge")), "make it: build/sponge --quick")):
        done = subprocess.run([sys.executable, GALLERY, *arguments], capture_output=True, text=True)
        assert done.returncode == 1 and done.stderr.startswith("gallery.py: ") and said in done.stderr, done.stderr


def page_of(run, folder, name, *arguments):
    page = os.path.join(folder, name + ".html")
    view(run, "-o", page, *arguments)
    return page


def main():
    folder = os.path.join(os.path.abspath(sys.argv[1]), "view")
    shutil.rmtree(folder, ignore_errors=True)
    run, plane = os.path.join(folder, "out-space"), os.path.join(folder, "out-plane")
    counts, walls = make_run(run, 4, flat=False)
    plane_counts, plane_walls = make_run(plane, 2, flat=True)
    if not os.path.exists(LIBRARY):
        view(run, fails="run: sh tools/install_packages.sh view")
        print("skipped: there is no three.js to make pages with; sh tools/install_packages.sh view")
        sys.exit(SKIPPED)
    refuse_bad_input(folder, run)
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not program:
        view(run)
        print("skipped: there is no Chromium to open the pages with; sh tools/install_packages.sh browser")
        sys.exit(SKIPPED)
    look_at_pages(program, folder, run, counts, walls, plane, plane_counts, plane_walls)
    put_into_a_gallery(program, folder)
    print("pages opened in", folder)


main()
