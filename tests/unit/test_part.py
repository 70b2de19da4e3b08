"""`stochgeom.geometry.part` and `.outline`: what a part is, what it refuses, how it moves."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.errors import (
    CollinearOutlineError,
    FloatRefusedError,
    InputError,
    InvalidHoleError,
    InvalidPartError,
    NotRationalError,
    NumberError,
    SelfIntersectionError,
    TooFewVerticesError,
)
from stochgeom.feeding.planner import plan_feeding
from stochgeom.geometry.part import Part, as_part

SQUARE = [(0, 0), (6, 0), (6, 6), (0, 6)]
L = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)]
HOLE = [(1, 1), (3, 1), (3, 2), (1, 2)]


# --- worked cases --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("vertices", "area", "centroid"),
    [
        ([(0, 0), (3, 0), (3, 2), (0, 2)], 6, (mpq(3, 2), 1)),
        ([(0, 0), (3, 0), (0, 3)], mpq(9, 2), (1, 1)),
        (L, 6, (mpq(3, 2), 1)),
        ([("1/2", 0), ("7/2", 0), ("1/2", 3)], mpq(9, 2), (mpq(3, 2), 1)),
    ],
)
def test_area_and_centroid(vertices, area, centroid):
    for outline in (vertices, vertices[::-1], vertices[2:] + vertices[:2]):
        part = Part(outline)
        assert part.area == area
        assert part.centroid == part.center_of_mass == centroid
        assert not part.has_given_center


def test_a_hole_shifts_only_the_centroid():
    whole, holed = Part(SQUARE), Part(SQUARE, holes=[HOLE])
    assert holed.area == 36 - 2
    assert holed.centroid == (mpq(36 * 3 - 2 * 2, 34), mpq(36 * 3 - 2 * mpq(3, 2), 34))
    assert Part(SQUARE, holes=[HOLE[::-1]]).centroid == holed.centroid
    assert holed.hull.points.pairs() == whole.hull.points.pairs()
    assert holed.holes == (tuple(HOLE),)
    two = Part(SQUARE, holes=[HOLE, [(4, 4), (5, 4), (4, 5)]])
    assert two.area == 34 - mpq(1, 2)


def test_vertices_stay_as_given():
    clockwise = [(0, 6), (6, 6), (6, 6), (6, 0), (3, 0), (0, 0)]
    part = Part(clockwise, name="bent")
    assert part.vertices == tuple(clockwise)
    assert len(part) == 6
    assert part.name == "bent"


def test_the_hull_names_vertices_of_the_outline():
    assert Part(L).hull.indices.tolist() == [0, 1, 2, 4, 5]
    repeated = Part([(6, 0), (6, 6), (6, 6), (0, 6), (0, 0), (3, 0)])
    corners = {tuple(map(int, repeated.vertices[k])) for k in repeated.hull.indices}
    assert corners == set(SQUARE)
    assert len(repeated.hull) == 4


@pytest.mark.parametrize(
    ("center", "side"),
    [((3, 3), 1), ((0, 3), 0), ((6, 6), 0), (("1e-40", 3), 1), (("-1e-40", 3), -1), ((12, 0), -1)],
)
def test_a_center_of_mass_may_lie_anywhere_for_squeezing(center, side):
    part = Part(SQUARE, center_of_mass=center)
    assert part.has_given_center
    assert part.center_of_mass == (mpq(center[0]), mpq(center[1]))
    assert part.center_of_mass_side == side
    assert part.centroid == (3, 3)
    plan = plan_feeding(part)
    assert plan.verify()
    assert plan.expected_cost == plan_feeding(SQUARE).expected_cost


def test_a_center_of_mass_beside_a_hull_with_denominators():
    shifted = Part(SQUARE).scale("1/7").translate("1/3", "-1/5")
    for center, side in (((3, 3), 1), ((6, 6), 0), ((12, 0), -1)):
        part = Part(SQUARE, center).scale("1/7").translate("1/3", "-1/5")
        assert part.vertices == shifted.vertices
        assert part.center_of_mass_side == side


# --- refusing ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "vertices",
    [
        [],
        [(0, 0)],
        [(0, 0), (1, 1)],
        [(0, 0)] * 5,
        [(0, 0), (0, 0), (1, 1), (1, 1)],
        [(0, 0), (1, 1), (0, 0), (1, 1)],
        [(0, 0), ("1/2", 1), ("2/4", "1.0")],
    ],
)
def test_fewer_than_three_distinct_vertices(vertices):
    with pytest.raises(TooFewVerticesError, match="accepted: at least 3") as caught:
        Part(vertices)
    assert str(len({(mpq(x), mpq(y)) for x, y in vertices})) in caught.value.message
    assert isinstance(caught.value, InvalidPartError)


@pytest.mark.parametrize(
    "vertices",
    [
        [(0, 0), (1, 1), (2, 2)],
        [(0, 0), (2, 2), (1, 1), (3, 3)],
        [(0, 0), (1, 1), (2, 2), (0, 0)],
        [(5, 0), (5, 7), (5, 3), (5, 3)],
        [("1/3", "1/7"), ("2/3", "2/7"), (1, "3/7")],
        [(10**400, 0), (0, 10**400), (1, 10**400 - 1)],
    ],
)
def test_all_vertices_on_one_line(vertices):
    with pytest.raises(CollinearOutlineError, match="accepted: an outline that encloses an area"):
        Part(vertices)


@pytest.mark.parametrize(
    ("vertices", "edges", "word"),
    [
        ([(0, 0), (2, 2), (2, 0), (0, 2)], (0, 2), "cross"),
        ([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], (0, 3), "touch"),
        ([(0, 0), (2, 2), (4, 0), (4, 4), (2, 2), (0, 4)], (0, 3), "touch"),
        ([(0, 0), (4, 0), (4, 4), (8, 4), (4, 4), (0, 4)], (2, 3), "overlap"),
        # repeated vertices do not shift the numbers of the edges
        ([(0, 0), (0, 0), (2, 2), (2, 0), (0, 2)], (1, 3), "cross"),
        ([(0, 0), (2, 2), (2, 2), (2, 2), (2, 0), (0, 2), (0, 0)], (0, 4), "cross"),
        # twice round the same square
        (SQUARE + SQUARE, (3, 7), "overlap"),
    ],
)
def test_an_outline_that_meets_itself(vertices, edges, word):
    with pytest.raises(SelfIntersectionError) as caught:
        Part(vertices)
    error = caught.value
    assert error.where == f"edges {error.edges[0]} and {error.edges[1]}"
    assert error.edges == edges
    assert word in error.message
    assert "accepted: an outline that does not meet itself" in error.message
    for edge in edges:
        tail, head = vertices[edge], vertices[(edge + 1) % len(vertices)]
        assert f"edge {edge} from {tail} to {head}" in error.message


def test_fractions_are_shown_as_such():
    with pytest.raises(SelfIntersectionError, match=r"edge 0 from \(0, 0\) to \(1/2, 1/2\)"):
        Part([(0, 0), ("1/2", "1/2"), ("1/2", 0), (0, "1/2")])


@pytest.mark.parametrize(
    ("holes", "error", "where", "accepted"),
    [
        ([[(7, 7), (8, 7), (7, 8)]], InvalidHoleError, "hole 0", "accepted: holes inside it"),
        ([HOLE, [(7, 7), (8, 7), (7, 8)]], InvalidHoleError, "hole 1", "accepted: holes inside"),
        ([[(-1, -1), (7, -1), (7, 7), (-1, 7)]], InvalidHoleError, "hole 0", "holes inside it"),
        ([[(5, 5), (7, 5), (5, 7)]], InvalidHoleError, "hole 0", "edge 2 of hole 0 from"),
        ([[(0, 0), (1, 0), (0, 1)]], InvalidHoleError, "hole 0", "nor the outline"),
        ([[(3, 0), (4, 1), (2, 1)]], InvalidHoleError, "hole 0", "touch"),
        ([SQUARE], InvalidHoleError, "hole 0", "overlap"),
        ([HOLE, [(2, "1.5"), (4, 3), (4, "1.5")]], InvalidHoleError, "hole 1", "each other"),
        ([HOLE, [(3, 2), (4, 3), (3, 4)]], InvalidHoleError, "hole 1", "touch"),
        ([HOLE, [(2, "1.2"), ("2.1", "1.2"), (2, "1.4")]], InvalidHoleError, "hole 1", "beside"),
        ([[(2, "1.2"), ("2.1", "1.2"), (2, "1.4")], HOLE], InvalidHoleError, "hole 0", "beside"),
        ([[(1, 1), (3, 3), (3, 1), (1, 3)]], InvalidHoleError, "hole 0", "cross"),
        ([[(1, 1), (3, 1)]], TooFewVerticesError, "hole 0", "accepted: at least 3"),
        ([HOLE, [(4, 4), (5, 5), (4, 4)]], TooFewVerticesError, "hole 1", "at least 3"),
        ([[(1, 1), (3, 1), (4, 1)]], CollinearOutlineError, "hole 0", "encloses an area"),
        ([[(1, 1), (3, 1.5), (3, 1)]], FloatRefusedError, "hole 0, vertex 1, y", "from_float"),
        ([[(1, 1), (3, 1, 2), (3, 1)]], NumberError, "hole 0, vertex 1", "accepted: (x, y)"),
        ([np.zeros((3, 3), int)], InvalidPartError, "hole 0, vertex array", "shape (n, 2)"),
        (HOLE, NumberError, "hole 0, vertex 0", "accepted: (x, y)"),
        ([7], NumberError, "hole 0, vertex list", "accepted: pairs of exact numbers"),
        (7, InvalidHoleError, "holes", "accepted: lists of vertices"),
        (None, InvalidHoleError, "holes", "accepted: lists of vertices"),
    ],
)
def test_holes_that_are_none(holes, error, where, accepted):
    for outline in (SQUARE, [*SQUARE[:3], (3, "5.9"), SQUARE[3]]):  # convex, and not
        with pytest.raises(error) as caught:
            Part(outline, holes=holes)
        assert type(caught.value) is error
        assert caught.value.where == where
        assert accepted in caught.value.message


@pytest.mark.parametrize(
    ("center", "error", "where"),
    [
        ((1, 2, 3), NumberError, "center of mass"),
        (5, NumberError, "center of mass"),
        ("1,2", NumberError, "center of mass"),
        ((1, 0.5), FloatRefusedError, "center of mass, y"),
        (("nan", 1), NumberError, "center of mass, x"),
    ],
)
def test_a_center_of_mass_that_is_none(center, error, where):
    with pytest.raises(error) as caught:
        Part(SQUARE, center_of_mass=center)
    assert caught.value.where == where
    assert "accepted" in caught.value.message or "from_float" in caught.value.message


# --- moving --------------------------------------------------------------------------------------


def test_similarity_maps():
    part = Part([(0, 0), (4, 0), (0, 2)], center_of_mass=(1, 1), name="wedge")
    assert part.translate("1/2", -1).vertices == (
        (mpq(1, 2), -1),
        (mpq(9, 2), -1),
        (mpq(1, 2), 1),
    )
    assert part.scale("3/2").vertices == ((0, 0), (6, 0), (0, 3))
    assert part.rotate((0, 1)).vertices == ((0, 0), (0, 4), (-2, 0))
    assert part.rotate(("3/7", "4/7")).vertices[1] == (mpq(12, 5), mpq(16, 5))
    assert part.multiply((1, 2)).vertices == ((0, 0), (4, 8), (-4, 2))
    assert part.reflect().vertices == ((0, 0), (4, 0), (0, -2))
    assert part.reflect().center_of_mass == (1, -1)
    assert part.multiply((0, 1)).center_of_mass == (-1, 1)
    assert {moved.name for moved in (part.scale(2), part.reflect(), part.rotate((3, 4)))} == {
        "wedge"
    }


def test_holes_move_with_the_part():
    part = Part(SQUARE, holes=[HOLE])
    assert part.translate(1, 2).holes == (tuple((x + 1, y + 2) for x, y in HOLE),)
    assert part.reflect().centroid == (part.centroid[0], -part.centroid[1])


@pytest.mark.parametrize(
    ("move", "error", "accepted"),
    [
        (lambda p: p.scale(0), InputError, "accepted: positive numbers"),
        (lambda p: p.scale(-2), InputError, "accepted: positive numbers"),
        (lambda p: p.scale(0.5), FloatRefusedError, "from_float"),
        (lambda p: p.rotate((1, 1)), NotRationalError, "accepted: directions of rational length"),
        (lambda p: p.rotate(("1/2", "1/2")), NotRationalError, "accepted: directions of rational"),
        (lambda p: p.rotate((0, 0)), NotRationalError, "accepted: directions of rational length"),
        (lambda p: p.rotate((1, 0.5)), FloatRefusedError, "from_float"),
        (lambda p: p.multiply((0, 0)), InputError, "maps the part to a point"),
        (lambda p: p.translate("x", 0), NumberError, "accepted: whole numbers"),
    ],
)
def test_maps_that_are_none(move, error, accepted):
    with pytest.raises(error) as caught:
        move(Part(SQUARE))
    assert accepted in caught.value.message


# --- as a value ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "part",
    [
        Part(SQUARE),
        Part([(0, 0), ("1/3", 0), (0, "2/7")], center_of_mass=("1/9", 1), name="it's"),
        Part(SQUARE, holes=[HOLE]),
        Part([(0, 0), (10**5000, 0), (0, "1/" + "7" * 50)]),
    ],
)
def test_repr_reads_back(part):
    again = eval(repr(part))
    assert again == part
    assert hash(again) == hash(part)
    assert repr(again) == repr(part)


def test_repr_of_many_vertices_is_short():
    wall = [(0, 0), *((k, 1) for k in range(1000)), (1000, 0)]
    assert repr(Part(wall[::-1], name="wall")) == "<Part wall of 1002 vertices>"
    assert repr(Part(wall)) == "<Part without name of 1002 vertices>"


def test_equality():
    assert Part(SQUARE) == Part(np.array(SQUARE)) == Part([(Fraction(x), y) for x, y in SQUARE])
    assert Part(SQUARE) == Part(SQUARE, center_of_mass=(3, 3))
    different = [
        Part(SQUARE[::-1]),
        Part(SQUARE, name="square"),
        Part(SQUARE, center_of_mass=(3, 2)),
        Part(SQUARE, holes=[HOLE]),
    ]
    assert len({Part(SQUARE), *different}) == 5
    assert Part(SQUARE) != SQUARE


def test_as_part():
    part = Part(SQUARE)
    assert as_part(part) is part
    assert as_part(np.array(SQUARE)) == part
