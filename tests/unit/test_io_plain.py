"""Outlines with a vertex per line, and the vertices and points of the command line."""

from __future__ import annotations

import time

import pytest
from gmpy2 import mpq

from stochgeom.io.outlines import parse_outline, parse_point, parse_vertices

TRIANGLE = ((mpq(0), mpq(0)), (mpq(3), mpq(0)), (mpq(3), mpq(2)))


@pytest.mark.parametrize(
    "text",
    [
        "0 0\n3 0\n3 2\n",
        "0 0\n3 0\n3 2",
        "0,0\n3,0\n3,2\n",
        "0, 0\n3 ,0\n  3 , 2  \n",
        "0;0\n3; 0\n3 ;2\n",
        "0\t0\n3\t0\n3\t\t2\n",
        "0 0\n3,0\n3;2\n",
        "0 0\r\n3 0\r\n3 2\r\n",
        "0 0\r3 0\r3 2\r",
        "\ufeff0 0\n3 0\n3 2\n",
        "# a triangle\n\n0 0\n   \n3 0  # a corner\n\t# half way\n3 2\n\n",
        "0 0\n3 0\n3 2\n0 0\n",
        "0 0\n3 0\n3 2\n0.0 0/7\n",
        "+0 -0\n3. 0e5\n30e-1 .2e1\n",
    ],
)
def test_every_notation_of_one_triangle(text):
    assert parse_outline(text).vertices == TRIANGLE


def test_numbers_are_read_from_their_text():
    outline = parse_outline("0.1 -0.1\n1/3 -2/6\n1e-30 -1.5E+2\n")
    assert outline.vertices == (
        (mpq(1, 10), mpq(-1, 10)),
        (mpq(1, 3), mpq(-1, 3)),
        (mpq(1, 10**30), mpq(-150)),
    )


def test_places_are_the_lines_of_the_source():
    outline = parse_outline("# heading\n0 0\n\n3 0\n3 2\n0 0\n")
    assert outline.places == ("line 2", "line 4", "line 5")


def test_only_one_closing_vertex_is_left_out():
    assert len(parse_outline("0 0\n3 0\n3 2\n0 0\n0 0\n").vertices) == 4


def test_repeated_vertices_stay():
    assert len(parse_outline("0 0\n0 0\n3 0\n3 2\n").vertices) == 4


def test_the_geometry_is_not_checked():
    assert parse_outline("1 1\n").vertices == ((mpq(1), mpq(1)),)
    assert parse_outline("1 1\n1 1\n").vertices == ((mpq(1), mpq(1)),)


def test_the_default_name_is_the_callers():
    assert parse_outline("1 1", name="dot").name == "dot"
    assert parse_outline("1 1").name is None


@pytest.mark.parametrize(
    "text",
    [
        "0,0 3,0 3,2",
        "  0,0   3,0\n3,2 ",
        "0, 0 3 ,0 3 , 2",
        "0,0 3,0 3,2 0,0",
        "0 0; 3 0; 3 2",
        "0 0;3 0;3 2;",
        "0,0; 3,0; 3, 2",
        "0 0; 3 0; 3 2; 0 0",
    ],
)
def test_vertices_of_the_command_line(text):
    assert parse_vertices(text) == TRIANGLE


def test_vertices_that_begin_with_a_minus():
    assert parse_vertices("-1,-2 -1/2,-.5") == ((mpq(-1), mpq(-2)), (mpq(-1, 2), mpq(-1, 2)))


@pytest.mark.parametrize("text", ["-1.5,2/7", " -1.5 , 2/7 ", "-1.5 2/7", "-1.5;2/7", "-3/2\t2/7"])
def test_a_point_of_the_command_line(text):
    assert parse_point(text) == (mpq(-3, 2), mpq(2, 7))


def test_a_hundred_thousand_lines_take_a_moment():
    """Linear time: a reader that slices the text afresh for each line needs minutes."""
    text = "".join(f"{i}.5 -{i}\n" for i in range(100_000))
    start = time.process_time()
    outline = parse_outline(text)
    assert time.process_time() - start < 10
    assert len(outline.vertices) == len(outline.places) == 100_000
