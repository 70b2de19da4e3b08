"""The manual: a place for every public name, pictures up to date, no page that nobody reaches."""

from __future__ import annotations

import re
import runpy

import pytest

import stochgeom
from tests.repo.sources import ROOT, relative

DOCS = ROOT / "docs"
PAGES = sorted(
    page
    for page in DOCS.rglob("*.md")
    if page.parent.name != "decisions" and page.name != "README.md"
)
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
PICTURES = runpy.run_path(str(DOCS / "pictures.py"))["pictures"]()


def entries_of(page: str) -> set[str]:
    """Return the documents that the tables of contents of a page list."""
    blocks = re.findall(r"^```\{toctree\}\n(.*?)^```", page, flags=re.MULTILINE | re.DOTALL)
    lines = [line.strip() for block in blocks for line in block.splitlines()]
    return {line for line in lines if line and not line.startswith(":")}


def reached_from(name: str) -> set[str]:
    """Return the pages that one reaches from a page by tables of contents, itself included."""
    page = DOCS / f"{name}.md"
    folder = page.parent.relative_to(DOCS)
    found = {name}
    for entry in entries_of(page.read_text(encoding="utf-8")):
        if "*" not in entry:
            found |= reached_from((folder / entry).as_posix())
    return found


def test_every_page_is_reached_from_the_first():
    names = {page.relative_to(DOCS).with_suffix("").as_posix() for page in PAGES}
    assert reached_from("index") == names


@pytest.mark.parametrize("package", sorted({h.split(".")[0] for h in stochgeom._HOMES.values()}))
def test_every_package_has_a_page_of_its_public_names(package):
    text = (DOCS / "reference" / f"{package}.md").read_text(encoding="utf-8")
    directive = "automodule:: stochgeom.errors" if package == "errors" else "public-names:: "
    assert directive in text
    assert package == "errors" or f"public-names:: {package}\n" in text


@pytest.mark.parametrize("name", sorted(PICTURES))
def test_a_picture_is_what_the_code_draws(name):
    assert (DOCS / "pictures" / name).read_text(encoding="utf-8") == PICTURES[name]


def test_no_picture_is_left_over():
    assert {path.name for path in (DOCS / "pictures").iterdir()} == set(PICTURES)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=relative)
def test_a_notebook_stands_in_the_list(path):
    listed = (ROOT / "notebooks" / "README.md").read_text(encoding="utf-8")
    assert f"({path.name})" in listed


@pytest.mark.parametrize("path", NOTEBOOKS, ids=relative)
def test_a_notebook_is_committed_without_output(path):
    text = path.read_text(encoding="utf-8")
    assert '"output_type"' not in text
    assert not re.search(r'"execution_count": [0-9]', text)


def test_entries_are_read():
    page = "# A\n\n```{toctree}\n:maxdepth: 1\n\nb/c\nd\n```\n\ntext\n"
    assert entries_of(page) == {"b/c", "d"}
