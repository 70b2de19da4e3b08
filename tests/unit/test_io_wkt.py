"""Outlines in well-known text."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.io.outlines import parse_outline

TRIANGLE = ((mpq(0), mpq(0)), (mpq(3), mpq(0)), (mpq(3), mpq(2)))
HOLE = ((mpq(2), mpq(1, 2)), (mpq(5, 2), mpq(1, 2)), (mpq(5, 2), mpq(1)))


@pytest.mark.parametrize(
    "text",
    [
        "POLYGON ((0 0, 3 0, 3 2, 0 0))",
        "POLYGON ((0 0, 3 0, 3 2))",
        "polygon((0 0,3 0,3 2,0 0))",
        "  Polygon\n(\n(0 0,\n 3 0,\n 3\t2 , 0 0 )\n)\n",
        "SRID=4326;POLYGON((0 0,3 0,3 2,0 0))",
        "srid = 0 ; POLYGON((0 0,3 0,3 2,0 0))",
        "\ufeffPOLYGON ((0 0, 3 0, 3 2, 0 0))\r\n",
        "POLYGON ((0 0, 3.0 0e0, 30e-1 4/2, 0.0 -0))",
    ],
)
def test_every_notation_of_one_triangle(text):
    outline = parse_outline(text)
    assert outline.vertices == TRIANGLE
    assert outline.holes == ()


@pytest.mark.parametrize(
    "text",
    [
        "POLYGON ((0 0, 3 0, 3 2, 0 0), (2 0.5, 2.5 0.5, 2.5 1, 2 0.5))",
        "POLYGON((0 0,3 0,3 2),(2 1/2,5/2 1/2,5/2 1))",
    ],
)
def test_further_rings_are_holes(text):
    outline = parse_outline(text)
    assert outline.vertices == TRIANGLE
    assert outline.holes == (HOLE,)


def test_holes_keep_their_order():
    outline = parse_outline("POLYGON ((0 0, 9 0, 9 9), (1 1, 2 1, 2 2), (3 3, 4 3, 4 4))")
    assert [hole[0] for hole in outline.holes] == [(1, 1), (3, 3)]


def test_places_are_lines_and_columns():
    outline = parse_outline("\n POLYGON ((0 0, 3 0,\n3 2,  0 0))")
    assert outline.places == ("line 2, column 12", "line 2, column 17", "line 3, column 1")


def test_numbers_are_read_from_their_text():
    outline = parse_outline("POLYGON ((0.1 -0.1, 1e-30 -1.5E+2))")
    assert outline.vertices == ((mpq(1, 10), mpq(-1, 10)), (mpq(1, 10**30), mpq(-150)))


def test_the_default_name_is_the_callers():
    assert parse_outline("POLYGON ((0 0, 3 0, 3 2))", name="wedge").name == "wedge"
