"""`stochgeom.geometry.hull`: convex outlines recognised, hulls of others, points placed."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.geometry.hull import convex_hull, convex_outline, hull_edges, locate
from stochgeom.geometry.points import Points

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
PENTAGRAM = [(0, 10), (6, -8), (-10, 3), (10, 3), (-6, -8)]


def points(pairs):
    return Points.from_pairs(pairs)


def circle_point(t):
    t = Fraction(t)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


CIRCLE = [circle_point(Fraction(k, 1000 + k)) for k in range(8)]


# --- recognised in O(n) --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("outline", "corners"),
    [
        (SQUARE, [0, 1, 2, 3]),
        ([(0, 0), (1, 0), (0, 1)], [0, 1, 2]),
        (SQUARE[::-1], [3, 2, 1, 0]),
        # vertices on straight runs, at the start of the list too
        ([(2, 0), (3, 0), (4, 0), (4, 4), (0, 4), (0, 2), (0, 0)], [2, 3, 4, 6]),
        ([(2, 0), (0, 0), (0, 4), (4, 4), (4, 2), (4, 0)], [5, 3, 2, 1]),
        (CIRCLE, list(range(8))),
    ],
)
def test_convex_outlines_are_recognised(outline, corners):
    found = convex_outline(points(outline))
    assert found.indices.tolist() == corners
    assert found.points.pairs() == tuple((mpq(x), mpq(y)) for x, y in (outline[k] for k in corners))


@pytest.mark.parametrize(
    "outline",
    [
        [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)],  # turns both ways
        PENTAGRAM,  # turns one way, but twice round
        SQUARE + SQUARE,
        [(0, 0), (4, 0), (6, 0), (4, 0), (4, 4), (0, 4)],  # a spike
        [(0, 0), (4, 0), (2, 0), (4, 4)],  # folds back
        [(0, 0), (1, 1), (2, 2)],
        [(0, 0), (2, 2), (1, 1)],
        [(0, 0), (4, 4), (4, 0), (0, 4)],  # an hourglass
    ],
)
def test_other_outlines_are_not(outline):
    assert convex_outline(points(outline)) is None
    assert convex_outline(points(outline[::-1])) is None


# --- computed in O(n log n) ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("cloud", "corners"),
    [
        ([(0, 0), (4, 0), (2, 1), (4, 4), (2, 0)], [0, 1, 3]),
        ([(2, 2), (4, 0), (0, 0), (0, 4), (4, 4)], [1, 4, 3, 2]),
        # of equal points the first is kept, and collinear ones are dropped
        ([(4, 0), (4, 0), (0, 0), (2, 0), (0, 4), (0, 0), (2, 2)], [0, 4, 2]),
        ([*CIRCLE, *CIRCLE[2:5], (0, 0)], [0, 1, 2, 3, 4, 5, 6, 7, 11]),
        (PENTAGRAM, [0, 2, 4, 1, 3]),
        ([*CIRCLE, (0, 0), (Fraction(1, 2), Fraction(1, 3))], [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
    ],
)
def test_hulls(cloud, corners):
    hull = convex_hull(points(cloud))
    assert hull.indices.tolist() == corners
    assert len(hull) == len(corners)
    assert hull.points.pairs() == points(cloud).take(np.array(corners)).pairs()


def test_huge_and_tiny_turns_are_told_apart():
    far = 10**400
    nearly_straight = [(0, 0), (far, 0), (2 * far, 1), (far, far)]
    assert convex_hull(points(nearly_straight)).indices.tolist() == [0, 1, 2, 3]
    straight = [(0, 0), (far, 0), (2 * far, 0), (far, far)]
    assert convex_hull(points(straight)).indices.tolist() == [0, 2, 3]
    dented = [(0, 0), (far, 1), (2 * far, 0), (far, far)]
    assert convex_hull(points(dented)).indices.tolist() == [0, 2, 3]


def test_edges_run_counter_clockwise():
    x, y = hull_edges(convex_hull(points([(0, 0), (3, 0), (3, 2), (0, 2)])))
    assert list(zip(x.tolist(), y.tolist(), strict=True)) == [(3, 0), (0, 2), (-3, 0), (0, -2)]


# --- placing a point -----------------------------------------------------------------------------


@pytest.mark.parametrize("scale", [1, Fraction(1, 7), 10**30])
def test_locate(scale):
    square = convex_hull(points([(scale * x, scale * y) for x, y in SQUARE]))
    places = {
        (1, 1): 1,
        (0, 2): 0,
        (4, 4): 0,
        (5, 0): -1,  # on the line of an edge, beyond its end
        (-1, 4): -1,
        ("1e-50", 2): 1,
        ("-1e-50", 2): -1,
    }
    for (x, y), side in places.items():
        assert locate(square, (scale * mpq(x), scale * mpq(y))) == side


def test_locate_in_a_hull_with_many_denominators():
    circle = convex_hull(points(CIRCLE))
    assert circle.points.w is not None
    middle = (sum(map(mpq, xs)) / 8 for xs in zip(*CIRCLE, strict=True))
    assert locate(circle, tuple(middle)) == 1
    assert [locate(circle, (mpq(x), mpq(y))) for x, y in CIRCLE] == [0] * 8
    assert locate(circle, (mpq(1), mpq(1))) == -1
