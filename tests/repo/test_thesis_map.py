"""Every row of the map of the thesis names public objects and tests that exist."""

from __future__ import annotations

import ast
import re
from importlib import import_module

import pytest

import stochgeom
from stochgeom.thesis.source_map import MapRow, map_markdown, map_rows
from tests.repo.sources import ROOT

ROWS = map_rows()


def problems(row):
    """Return what is wrong with a row, a line of text for each."""
    found = [f"no public object {name}" for name in row.objects if not object_exists(name)]
    found += [f"no test {name}" for name in row.tests if not exists(name)]
    if row.open is None:
        found += [] if row.objects else ["no object"]
        found += [] if row.tests else ["no test"]
    return found


def object_exists(name):
    """Whether a name is public: in the facade, in a module of the package, or a document."""
    if name.endswith(".md"):
        return (ROOT / name).is_file()
    parts = name.split(".")
    if any(part.startswith("_") for part in parts):
        return False
    if parts[0] in stochgeom.__all__:
        owner, rest = getattr(stochgeom, parts[0]), parts[1:]
    else:
        split = next((k for k, part in enumerate(parts) if part[0].isupper()), len(parts) - 1)
        try:
            owner = import_module(".".join(["stochgeom", *parts[:split]]))
        except ModuleNotFoundError:
            return False
        rest = parts[split:]
    for part in rest:
        # What only `__init__` or a dataclass sets is named in the docstring.
        listed = re.search(rf"^\s+[\w, ]*\b{part}\b[\w, ]* :", owner.__doc__ or "", re.MULTILINE)
        if not hasattr(owner, part):
            return bool(listed) and part == rest[-1]
        owner = getattr(owner, part)
    return True


def exists(node):
    """Whether a file has a test, or a class with tests, of that name."""
    path, *names = node.split("::")
    if not (ROOT / path).is_file() or not path.rpartition("/")[2].startswith("test_"):
        return False
    body = ast.parse((ROOT / path).read_text(encoding="utf-8")).body
    for name in names:
        match = [item for item in body if getattr(item, "name", None) == name]
        if not match:
            return False
        body = match[-1].body
    return True


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.source)
def test_a_row_has_objects_and_tests(row):
    assert problems(row) == []


def test_no_row_is_open():
    assert [row.source for row in ROWS if row.open is not None] == []


def test_rows_are_different():
    assert len({row.source for row in ROWS}) == len(ROWS)


@pytest.mark.parametrize("part", ["Table 3.1", "Table 4.1", "Table C.1", "Tables 6.1", "Thm. 5.4"])
def test_what_readers_look_for_is_there(part):
    assert any(part in row.source for row in ROWS)


def test_the_document_is_up_to_date():
    path = ROOT / "docs" / "thesis-map.md"
    assert path.read_text(encoding="utf-8") == map_markdown(ROWS)


class TestTheCheckItself:
    GOOD = MapRow("1", "x", "y", ("Part",), ("tests/repo/test_thesis_map.py",), None)

    @pytest.mark.parametrize(
        ("objects", "tests"),
        [
            ((), GOOD.tests),
            (GOOD.objects, ()),
            (("NoSuchThing",), GOOD.tests),
            (("Part.no_such_thing",), GOOD.tests),
            (("thesis.tables.no_such_thing",), GOOD.tests),
            (("thesis.no_such_module.thing",), GOOD.tests),
            (("stochgeom._HOMES",), GOOD.tests),
            (("docs/nothing.md",), GOOD.tests),
            (GOOD.objects, ("tests/repo/test_nothing.py",)),
            (GOOD.objects, ("tests/repo/sources.py",)),
            (GOOD.objects, ("tests/repo/test_thesis_map.py::test_nothing",)),
            (GOOD.objects, ("tests/repo/test_thesis_map.py::TestTheCheckItself::nothing",)),
        ],
    )
    def test_a_bad_row_is_found(self, objects, tests):
        assert len(problems(MapRow("1", "x", "y", objects, tests, None))) == 1

    def test_an_open_row_may_be_empty_but_not_wrong(self):
        assert problems(MapRow("1", "x", "y", (), (), "missing")) == []
        assert problems(MapRow("1", "x", "y", ("NoSuchThing",), (), "missing"))

    @pytest.mark.parametrize(
        "name", ["Part", "Hyperstate.most_likely", "thesis.tables.table_4_1", "docs/notation.md"]
    )
    def test_good_objects(self, name):
        assert object_exists(name)
