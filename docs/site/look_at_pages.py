#!/usr/bin/env python3
"""Opens the pages of the site in a browser without a window, wide and as narrow as a telephone, and says what a reader
would trip over: a picture that does not show, text or a table that runs out of the page, an error of a script, a page
without a title. What it saw stays as pictures, to be looked at:

    sh tools/install_packages.sh docs browser
    cmake --preset docs && cmake --build --preset docs
    python3 docs/site/look_at_pages.py build-docs          writes build-docs/looks/<page>_<width>.png

Looked at are the hand-written pages, the lists of names and, of the pages that Doxygen makes of the headers, all that
docs/policies.md names and of the others every tenth. Then the pages are turned from the first to the last by the links at
their foot, and for each a word is searched for that no other page has.
"""

import argparse
import glob
import json
import os
import pathlib
import re
import sys

from costs import rows
from neighbours import reading_order
from selenium import webdriver
from selenium.common.exceptions import TimeoutException
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.wait import WebDriverWait

WIDTHS = (1280, 390)
GREATEST_HEIGHT = 12000

# What of a page a reader would trip over, one line each. What scrolls by itself, such as a wide table, may be wide.
FAULTS = r"""
const faults = [];
for (const image of document.images)
    if (image.complete && image.naturalWidth === 0) faults.push('the picture ' + image.getAttribute('src') + ' does not show');
for (const image of document.querySelectorAll('object, iframe'))
    if (image.offsetWidth === 0 && image.offsetParent) faults.push('nothing shows of ' + (image.data || image.src));
const contents = document.querySelector('div.contents');
if (!contents || contents.innerText.trim().length < 20) faults.push('there is next to nothing on it');
if (!document.querySelector('.title, h1')) faults.push('it has no title');
const text = document.querySelector('#doc-content') || document.documentElement;
const edges = text.getBoundingClientRect();
if (edges.width < Math.min(0.6 * innerWidth, 600))
    faults.push('there is room of ' + Math.round(edges.width) + ' for the text');
if (document.documentElement.scrollWidth > innerWidth || text.scrollWidth > text.clientWidth)
    faults.push('all of it scrolls sideways');
const scrolls = element => {
    for (; element !== text && element !== document.body; element = element.parentElement)
        if (['auto', 'scroll', 'hidden'].includes(getComputedStyle(element).overflowX)) return true;
    return false;
};
let widest = null, most = edges.right + 1;
for (const element of text.querySelectorAll('div.contents *, div.header *')) {
    const right = element.getBoundingClientRect().right;
    if (right > most && !scrolls(element)) { most = right; widest = element; }
}
if (widest)
    faults.push('it reaches ' + Math.round(most - edges.right) + ' out of the page: ' +
                widest.outerHTML.replace(/\s+/g, ' ').slice(0, 80));
return faults;
"""
# The pages that the search shows.
FOUND = "return [...document.querySelectorAll('#MSearchResultsWindow a')].map(it => it.href.split('#')[0])"
FORGET = "document.getElementById('MSearchResultsWindow').replaceChildren()"
# The text scrolls within the window: this is how high it would have to be to show all of it.
HEIGHT = """
const text = document.querySelector('#doc-content');
return text ? text.scrollHeight + 150 : document.documentElement.scrollHeight;
"""


def browser():
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--allow-file-access-from-files"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "SEVERE"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def narrow_to(driver, width, height=900):
    """Lays the page out for a screen of that size. A window cannot be made as narrow as a telephone."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})


def chosen(html):
    """The pages to look at."""
    made = sorted(os.path.basename(path) for path in glob.glob(os.path.join(html, "*.html")))
    others = ("dir_", "functions", "files", "graph_legend", "namespacemembers", "view-")  # they have no title
    made = [page for page in made if not page.endswith(("-members.html", "_source.html")) and not page.startswith(others)]
    of_headers = [page for page in made if page.startswith(("struct", "class", "namespace", "concept"))]
    names = {name for row in rows("policies.md", "| | Policies |") for name in re.findall(r"`([A-Z]\w+)(?!\w|::)", row[1])}
    named = {page for name in names for kind in ("struct", "class") for space in ("", "presets_1_1")
             if (page := f"{kind}imbibe_1_1{space}{name}.html") in made}
    if len(named) < len(names):
        sys.exit(f"look_at_pages.py: of {len(names)} names in docs/policies.md only {len(named)} have a page")
    return [page for page in made if page not in of_headers or page in named] + \
        [page for page in of_headers if page not in named][::10]


def look(driver, html, looks, page, width):
    """Leaves a picture of the page and returns its faults."""
    narrow_to(driver, width)
    driver.get(address(html, page))
    found = driver.execute_script(FAULTS) + [entry["message"] for entry in driver.get_log("browser")]
    height = driver.execute_script(HEIGHT)
    narrow_to(driver, width, min(max(height, 900), GREATEST_HEIGHT))
    driver.save_screenshot(os.path.join(looks, f"{page[:-5]}_{width}.png"))
    return [f"{page}, {width} wide: {fault}" for fault in found]


def address(html, page):
    return pathlib.Path(html, page).absolute().as_uri()


def turn_the_pages(driver, html):
    """What is wrong with the links to the next page, one after the other."""
    narrow_to(driver, WIDTHS[1])
    pages = [f"{name}.html" for name, _ in reading_order()]
    driver.get(address(html, pages[0]))
    for page, after in zip(pages, pages[1:]):
        driver.find_element(By.CSS_SELECTOR, ".neighbours .after").click()
        if driver.current_url != address(html, after):
            return [f"{page}: the next page is {driver.current_url}, not {after}"]
        before = driver.find_element(By.CSS_SELECTOR, ".neighbours .before").get_attribute("href")
        if before != address(html, page):
            return [f"{after}: the page before is {before}, not {page}"]
    return []


def words_of_one_page(html):
    """{page: a word that is in its text and in nothing else that the search finds}"""
    with open(os.path.join(html, "search", "text.js"), encoding="utf-8") as file:
        text = json.loads(file.read().removeprefix("var searchText = ").rstrip(";\n"))
    found = {}
    for word, where in text["index"]["invertedIndex"]:
        if len(where["text"]) == 1 and not where["heading"] and re.fullmatch("[a-z]{7,}", word):
            found.setdefault(text["pages"][text["sections"][int(*where["text"])][0]][0], word)
    return {page: found[page] for name, _ in reading_order() if (page := f"{name}.html") in found}


def search(driver, html):
    """Pages that a word of theirs does not find, and how many were looked for."""
    words, faults = words_of_one_page(html), []
    narrow_to(driver, WIDTHS[0])
    driver.get(address(html, "index.html"))
    field = driver.find_element(By.ID, "MSearchField")
    for page, word in words.items():
        driver.execute_script(FORGET)
        field.clear()
        field.send_keys(f"the {word}'s 5")  # what is in no index does not count
        try:
            WebDriverWait(driver, 10).until(lambda _: address(html, page) in driver.execute_script(FOUND))
        except TimeoutException:
            faults.append(f"{page}: the search for '{word}' does not find it")
    return faults, len(words)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="where the site was built, such as build-docs")
    build = parser.parse_args().build
    html, looks = os.path.join(build, "html"), os.path.join(build, "looks")
    pages = chosen(html)
    if not pages:
        sys.exit(f"look_at_pages.py: there is no page in {html}; build the site first: cmake --build --preset docs")
    os.makedirs(looks, exist_ok=True)
    with browser() as driver:
        faults = [fault for page in pages for width in WIDTHS for fault in look(driver, html, looks, page, width)]
        faults += turn_the_pages(driver, html)
        wrong, searched = search(driver, html)
        faults += wrong
    print("".join(fault + "\n" for fault in faults), end="")
    print(f"{len(pages)} pages looked at, {searched} searched for, {len(faults)} faults; pictures in {looks}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
