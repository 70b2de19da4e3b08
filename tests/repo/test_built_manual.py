"""The manual as Sphinx builds it and a browser shows it: the pages of the thesis, and one notebook.

The other pages are left out, and one small notebook stands for all: `make docs` builds the rest.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from stochgeom.plotting.source_figures import SOURCE_FIGURES
from tests.browser import Browser, find_browser
from tests.repo.sources import ROOT

EXECUTABLE = find_browser()
in_a_browser = pytest.mark.skipif(EXECUTABLE is None, reason="no Chromium found on the path")

CHAPTERS = sorted(path.stem for path in (ROOT / "docs" / "thesis").glob("*.md"))
PAGES = [*(f"thesis/{name}" for name in CHAPTERS), "notebooks/small"]

BOXES = "article .drawing, article .table-wrapper, article .cell_output"
LEGIBLE = """box => {
    const fits = box.scrollWidth <= box.clientWidth;
    const scrolls = getComputedStyle(box).overflowX == 'auto';
    return box.getBoundingClientRect().right <= innerWidth && (fits || scrolls);
}"""
"""Whether all of a box can be seen: it lies on the page, and what does not fit scrolls."""


def small_notebook(code: str) -> str:
    """Return a notebook with a heading, a link and one cell of code."""
    text = {"cell_type": "markdown", "id": "a", "metadata": {}}
    cell = {"cell_type": "code", "id": "b", "metadata": {}, "outputs": [], "execution_count": None}
    words = "# Small\n\n[all](../docs/thesis/index.md)"
    cells = [text | {"source": words}, cell | {"source": code}]
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return json.dumps({"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5})


def build(folder: Path, code: str, pages: str) -> subprocess.CompletedProcess[str]:
    """Build some pages of the manual beside a notebook with the code, into ``folder/built``."""
    left_out = shutil.ignore_patterns("notebooks", "__pycache__")
    shutil.copytree(ROOT / "docs", folder / "docs", ignore=left_out)
    (folder / "notebooks" / "data").mkdir(parents=True)
    notebook = folder / "notebooks" / "small.ipynb"
    notebook.write_text(small_notebook(code), encoding="utf-8")
    sphinx = [sys.executable, "-m", "sphinx", "-b", "html", "-q"]
    places = [str(folder / "docs"), str(folder / "built")]
    return subprocess.run(
        [*sphinx, "-D", f"include_patterns={pages}", *places],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
    )


@pytest.fixture(scope="module")
def manual(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("manual")
    code = (
        "import stochgeom as sg\npart = sg.catalogue_part('house')\ndisplay(part)\nprint(part.area)"
    )
    run = build(folder, code, "index.md,thesis/*,notebooks/*")
    assert run.returncode == 0, run.stderr
    return folder / "built"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser(EXECUTABLE) as found:
        yield found


def test_every_figure_is_a_picture_of_some_page(manual):
    shown = "".join((manual / f"{page}.html").read_text(encoding="utf-8") for page in PAGES)
    missing = [name for name in SOURCE_FIGURES if f"_images/fig-{name[3:]}.svg" not in shown]
    assert missing == []


def test_a_notebook_shows_its_output_and_its_links_lead_on(manual):
    page = (manual / "notebooks" / "small.html").read_text(encoding="utf-8")
    assert re.search(r'cell_output.*<img[^>]*src="[^"]*[.]svg"', page, flags=re.DOTALL)
    assert re.search(r"cell_output.*\b5\b", page, flags=re.DOTALL)  # its area
    assert 'href="../thesis/index.html"' in page


def test_a_notebook_that_fails_ends_the_build(tmp_path):
    run = build(tmp_path, "assert 2 < 1", "index.md,notebooks/*")
    assert run.returncode != 0
    assert re.search(r"ExecutionError: \S*small\.ipynb", run.stderr)


@in_a_browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_whole_without_a_network(manual, browser, page, scheme):
    browser.screen(400, prefers_color_scheme=scheme)
    browser.open(manual / f"{page}.html")
    pictures = "[...document.querySelectorAll('article img')]"
    # Decoding waits for a picture that is not there yet, and fails for one that never will be.
    assert browser.evaluate(f"Promise.all({pictures}.map(i => i.decode())).then(() => true)")
    assert [way for way in browser.requests() if not way.startswith(("file:", "data:"))] == []
    assert browser.complaints() == []
    assert browser.evaluate(f"[...document.querySelectorAll({BOXES!r})].every({LEGIBLE})")


@in_a_browser
@pytest.mark.parametrize("page", ["thesis/chapter-4", "notebooks/small"])
@pytest.mark.parametrize(("scheme", "inverted"), [("light", False), ("dark", True)])
def test_pictures_are_dark_on_dark_pages(manual, browser, page, scheme, inverted):
    browser.screen(1200, prefers_color_scheme=scheme)
    browser.open(manual / f"{page}.html")
    picture = "document.querySelector('article .drawing img, article .cell_output img')"
    assert ("invert" in browser.evaluate(f"getComputedStyle({picture}).filter")) == inverted
