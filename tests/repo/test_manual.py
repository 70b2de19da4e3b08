"""The manual: a place for every public name, pictures up to date, no page that nobody reaches."""

from __future__ import annotations

import json
import posixpath
import re
import runpy
from fnmatch import fnmatch
from pathlib import Path

import pytest
from notebook_pages import copied_notebook

import stochgeom
from tests.repo.sources import ROOT, relative

DOCS = ROOT / "docs"
PAGES = sorted(
    page
    for page in DOCS.rglob("*.md")
    if page.parent.name != "decisions" and page.name != "README.md"
)
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
LINK = re.compile(r"\]\(([^)#:]+)(?=[)#])")
PICTURES = runpy.run_path(str(DOCS / "pictures.py"))["pictures"]()


def entries_of(page: str) -> set[str]:
    """Return the documents that the tables of contents of a page list."""
    blocks = re.findall(r"^```\{toctree\}\n(.*?)^```", page, flags=re.MULTILINE | re.DOTALL)
    lines = [line.strip() for block in blocks for line in block.splitlines()]
    return {line for line in lines if line and not line.startswith(":")}


def reached_from(name: str) -> set[str]:
    """Return the pages that one reaches from a page by tables of contents, itself included.

    What lists by a pattern is kept as a pattern.
    """
    page = DOCS / f"{name}.md"
    folder = page.parent.relative_to(DOCS).as_posix()
    found = {name}
    for entry in entries_of(page.read_text(encoding="utf-8")):
        path = posixpath.normpath(posixpath.join(folder, entry))
        found |= {path} if "*" in path else reached_from(path)
    return found


def test_every_page_is_reached_from_the_first():
    names = {page.relative_to(DOCS).with_suffix("").as_posix() for page in PAGES}
    assert {name for name in reached_from("index") if "*" not in name} == names


@pytest.mark.parametrize("path", NOTEBOOKS, ids=relative)
def test_every_notebook_is_reached_from_the_first_page(path):
    patterns = [name for name in reached_from("index") if "*" in name]
    assert any(fnmatch(f"notebooks/{path.stem}", pattern) for pattern in patterns)


def leads_to(folder: Path, link: str) -> str:
    """Return the path that a link of a file in a folder leads to."""
    return posixpath.normpath((folder / link).as_posix())


@pytest.mark.parametrize("path", NOTEBOOKS, ids=relative)
def test_a_copied_notebook_differs_in_its_links_only(path):
    source = path.read_text(encoding="utf-8")
    before, after = json.loads(source), json.loads(copied_notebook(source))
    for ours, copied in zip(before.pop("cells"), after.pop("cells"), strict=True):
        text, moved = "".join(ours.pop("source")), "".join(copied.pop("source"))
        assert ours == copied
        if ours["cell_type"] == "code":
            assert text == moved
            continue
        assert LINK.sub("](", text) == LINK.sub("](", moved)
        for link, there in zip(LINK.findall(text), LINK.findall(moved), strict=True):
            goal = leads_to(path.parent, link)
            # What stands beside a notebook stands beside its copy, but for the list of them.
            beside = goal.replace(f"{ROOT}/notebooks/", f"{DOCS}/notebooks/")
            listed = beside.replace("/notebooks/README.md", "/howto/notebooks.md")
            assert leads_to(DOCS / "notebooks", there) == listed
            assert (DOCS / "howto" / "notebooks.md").exists()
    assert before == after


def test_notebooks_are_executed_and_may_not_fail():
    settings = runpy.run_path(str(DOCS / "conf.py"))
    assert settings["nb_execution_mode"] == "force"
    assert settings["nb_execution_raise_on_error"] is True


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
