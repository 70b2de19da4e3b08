"""Outlines and plan documents of parts over fields."""

from __future__ import annotations

import json

import pytest

from stochgeom.errors import FormatError, NumberError
from stochgeom.geometry.part import Part
from stochgeom.io.load import load_part, part_of
from stochgeom.io.outlines import parse_outline
from stochgeom.io.plan_json import part_json
from tests.commands import call

TRIANGLE = Part([(0, 0), (1, 0), ("1/2", "sqrt(3)/2")])


@pytest.mark.parametrize(
    "text",
    [
        "0 0\n1 0\n1/2 1/2*sqrt(3)\n",
        "0,0\n1,0\n0.5,sqrt(0.75)\n",
        '{"vertices": [[0, 0], [1, 0], ["1/2", "sqrt(3)/2"]]}',
        '[[0, 0], ["sqrt(1)", 0], ["1/2", "sqrt(3)/2"]]',
    ],
)
def test_square_roots_are_read(text):
    assert part_of(parse_outline(text)).vertices == TRIANGLE.vertices


@pytest.mark.parametrize("n", [3, 5, 7, 8, 10, 20])
def test_a_part_written_reads_back(n):
    part = Part.regular(n)
    document = part_json(part)
    assert ("field" in document) == (n != 4)
    assert part_of(parse_outline(json.dumps(document))) == Part(
        part.vertices, part.center_of_mass, part.name
    )


def test_the_field_is_named():
    document = part_json(Part.regular(5))
    assert document["field"] == {"regular polygon": 5}
    assert document["vertices"][2] == ["-1/2 - 1/2*g", "1/2*g*s"]
    assert part_json(TRIANGLE)["field"] == {"square root of": 3}


@pytest.mark.parametrize("source", ["regular-3", "regular-6", "regular-97"])
def test_regular_polygons_by_name(source):
    part = load_part(source)
    assert part == Part.regular(int(source.removeprefix("regular-")))


def test_a_plan_document_is_a_source(tmp_path, capsys):
    path = tmp_path / "plan.json"
    path.write_text(call(capsys, "plan", "regular-7", "--json").out, encoding="utf-8")
    assert load_part(str(path)).vertices == Part.regular(7).vertices


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ('{"vertices": [["g", 0], [1, 0], [0, 1]]}', NumberError, "vertex 0, x: 'g' is not a"),
        (
            '{"vertices": [[0, 0]], "field": "pentagon"}',
            FormatError,
            "field: .*not a field; accepted",
        ),
        ('{"vertices": [[0, 0]], "field": {"regular polygon": 2}}', FormatError, "not a field"),
        (
            '{"vertices": [["h", 0], [1, 0], [0, 1]], "field": {"regular polygon": 5}}',
            NumberError,
            "vertex 0, x: 'h': 'h' is not known",
        ),
    ],
)
def test_bad_documents(text, error, words):
    with pytest.raises(error, match=words):
        parse_outline(text)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("plan", "regular-2"), "a regular polygon of 2 vertices; accepted: 3 or more"),
        (("plan", "regular-5000"), "accepted: 3 to 1000 vertices"),
        (("plan", "regular-1000000"), "accepted: 3 to 1000 vertices"),
        (
            ("plan", "--vertices", "0,0 sqrt(2),0 0,sqrt(3)"),
            "vertex 2, y: sqrt(3) is in Q(sqrt(3))",
        ),
        (("plan", "--vertices", "0,0 1,0 0,sqrt(-3)"), "square root of -3"),
    ],
)
def test_the_command_says_what_is_wrong(arguments, words, capsys):
    result = call(capsys, *arguments)
    assert result.code == 2
    assert words in result.err
    assert result.err.count("\n") == 1
