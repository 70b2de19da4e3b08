"""``stochgeom parts``: the catalogue as a table and as a document."""

from __future__ import annotations

from stochgeom.io.load import load_part
from stochgeom.io.plan_json import part_json
from stochgeom.thesis.parts import catalogue_names
from tests.commands import call


def test_the_table_names_every_part(capsys):
    result = call(capsys, "parts")
    assert (result.code, result.err) == (0, "")
    header, *rows = result.out.splitlines()
    assert header.split("  ")[1:][0] == "part"
    assert [row.split()[0] for row in rows] == list(catalogue_names())


def test_rows_literally(capsys):
    rows = call(capsys, "parts").out.splitlines()
    assert rows[2].split() == ["rectangle", "4", "4", "(3/2,", "1)", "uniform", "centroid"]
    assert rows[8].split()[:5] == ["key", "11", "7", "(5,", "6)"]


def test_the_document(capsys):
    result = call(capsys, "parts", "--json")
    assert (result.code, result.err) == (0, "")
    assert result.document["schema"] == "stochgeom/parts/1"
    assert result.document["parts"] == [part_json(load_part(name)) for name in catalogue_names()]


def test_nothing_else_is_accepted(capsys):
    assert call(capsys, "parts", "house").code == 2
