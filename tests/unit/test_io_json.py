"""Outlines in JSON: lists, objects, plan documents and GeoJSON."""

from __future__ import annotations

import json

import pytest
from gmpy2 import mpq

from stochgeom.io.outlines import parse_outline

TRIANGLE = ((mpq(0), mpq(0)), (mpq(3), mpq(0)), (mpq(3), mpq(2)))
HOLE = ((mpq(2), mpq(1, 2)), (mpq(5, 2), mpq(1, 2)), (mpq(5, 2), mpq(1)))
PAIRS = [[0, 0], [3, 0], [3, 2]]
CLOSED = [*PAIRS, PAIRS[0]]
HOLE_PAIRS = [[2, "1/2"], ["2.5", 0.5], ["5/2", 1]]


@pytest.mark.parametrize(
    "document",
    [
        PAIRS,
        CLOSED,
        [["0", "0"], ["3", "0"], ["3", "2"]],
        [["0.0", 0], [3.0, "0/5"], ["6/2", "20e-1"]],
        {"vertices": PAIRS},
        {"vertices": CLOSED, "holes": [], "name": None, "center_of_mass": None},
        {"part": {"vertices": PAIRS}},
        {"type": "Polygon", "coordinates": [CLOSED]},
        {"type": "Polygon", "coordinates": [PAIRS], "bbox": [0, 0, 3, 2]},
        {
            "type": "Feature",
            "properties": None,
            "geometry": {"type": "Polygon", "coordinates": [PAIRS]},
        },
    ],
)
@pytest.mark.parametrize("indent", [None, 2])
def test_every_shape_of_one_triangle(document, indent):
    outline = parse_outline(json.dumps(document, indent=indent))
    assert outline.vertices == TRIANGLE
    assert outline.holes == ()
    assert outline.center_of_mass is None
    assert outline.name is None
    assert outline.places == ()


@pytest.mark.parametrize("text", ["\ufeff[[0,0],[3,0],[3,2]]", "\r\n [[0,0],\r\n[3,0],[3,2]]\r\n"])
def test_byte_order_mark_and_line_ends(text):
    assert parse_outline(text).vertices == TRIANGLE


def test_numbers_are_read_from_their_text():
    outline = parse_outline('[[0.1, -0.1], [1e-30, -1.5E+2], ["1/3", "-.25"]]')
    assert outline.vertices == (
        (mpq(1, 10), mpq(-1, 10)),
        (mpq(1, 10**30), mpq(-150)),
        (mpq(1, 3), mpq(-1, 4)),
    )


def test_more_digits_than_python_reads_by_itself():
    digits = "9" * 5000
    assert parse_outline(f"[[{digits}, 0]]").vertices == ((mpq(10**5000 - 1), mpq(0)),)


def test_the_optional_keys():
    document = {
        "name": "wedge",
        "vertices": PAIRS,
        "center_of_mass": [0.1, "2/3"],
        "holes": [[*HOLE_PAIRS, HOLE_PAIRS[0]]],
    }
    outline = parse_outline(json.dumps(document), name="file")
    assert outline.vertices == TRIANGLE
    assert outline.center_of_mass == (mpq(1, 10), mpq(2, 3))
    assert outline.holes == (HOLE,)
    assert outline.name == "wedge"


@pytest.mark.parametrize("name", [None, ""])
def test_without_a_name_the_default_holds(name):
    document = {"vertices": PAIRS, "name": name}
    assert parse_outline(json.dumps(document), name="file").name == "file"


def test_a_plan_document():
    document = {
        "schema": "stochgeom/plan/1",
        "part": {
            "name": "wedge",
            "vertices": [["0", "0"], ["3", "0"], ["3", "2"]],
            "center_of_mass": ["2", "2/3"],
        },
        "transfer": {"action": "squeeze", "period": None, "breaks": [], "values": []},
        "preimages": [],
        "plan": {"steps": 0},
    }
    outline = parse_outline(json.dumps(document))
    assert outline.vertices == TRIANGLE
    assert outline.center_of_mass == (mpq(2), mpq(2, 3))
    assert outline.name == "wedge"


def test_geojson_rings_after_the_first_are_holes():
    document = {
        "type": "Polygon",
        "coordinates": [CLOSED, [*HOLE_PAIRS, HOLE_PAIRS[0]]],
        "name": "wedge",
        "center_of_mass": [1, 1],
    }
    outline = parse_outline(json.dumps(document))
    assert outline.vertices == TRIANGLE
    assert outline.holes == (HOLE,)
    assert outline.name == "wedge"
    assert outline.center_of_mass == (1, 1)


@pytest.mark.parametrize(
    "key",
    [
        "description",
        "filename",
        "units",
        "material",
        "source",
        "date",
        "id",
        "color",
        "label",
        "comment",
        "$schema",
        "schema",
        "type",
        "vertex_count",
        "",
    ],
)
def test_keys_of_other_programs_are_passed_over(key):
    assert parse_outline(json.dumps({key: [{"deep": 1.5}], "vertices": PAIRS})).vertices == TRIANGLE
