"""Diameters, hulls and antipodal pairs by all pairs of vertices, in plain fractions."""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key
from itertools import combinations, pairwise, permutations

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.geometry.calipers import antipodal_pairs, rotate_calipers
from stochgeom.geometry.diameter import DiameterFunction
from tests.strategies import (
    circle_parts,
    directions,
    large_directions,
    nearly_regular,
    parts,
    rational_parts,
)

any_part = st.one_of(parts(), parts(), rational_parts(), circle_parts(), nearly_regular(most=7))
turns = st.one_of(directions, directions, large_directions)


# --- the slow road -------------------------------------------------------------------------------


def plain(pairs):
    """Return points as pairs of standard fractions."""
    return [tuple(Fraction(int(v.numerator), int(v.denominator)) for v in pair) for pair in pairs]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def slow_squared_diameter(vertices, turn):
    """The largest squared difference of heights of two turned vertices."""
    c, s = turn
    heights = [x * s + y * c for x, y in vertices]
    return max((a - b) ** 2 for a, b in combinations(heights, 2)) / Fraction(c * c + s * s)


def slow_hull(vertices):
    """Ends of all directed pairs that have every other point on their left or between them."""
    found = set()
    for p, q in permutations(set(vertices), 2):
        along = minus(q, p)
        sides = [(cross(along, minus(r, p)), dot(along, minus(r, p))) for r in vertices]
        if all(c > 0 or (c == 0 and 0 <= d <= dot(along, along)) for c, d in sides):
            found |= {p, q}
    return found


def slow_antipodal_pairs(hull):
    """Pairs of ends of the hull as seen along each edge, and between neighbouring edges."""
    n = len(hull)
    edges = [minus(hull[(k + 1) % n], hull[k]) for k in range(n)]
    upper = [(x, y) if y > 0 or (y == 0 and x > 0) else (-x, -y) for x, y in edges]
    upper.sort(key=cmp_to_key(lambda a, b: -cross(a, b)))
    around = [*upper, (-upper[0][0], -upper[0][1])]
    between = [(a[0] + b[0], a[1] + b[1]) for a, b in pairwise(around) if cross(a, b) != 0]
    found = set()
    for along in (*upper, *between):
        heights = [cross(along, p) for p in hull]
        tops = [k for k, h in enumerate(heights) if h == max(heights)]
        bottoms = [k for k, h in enumerate(heights) if h == min(heights)]
        found |= {(min(i, j), max(i, j)) for i in tops for j in bottoms}
    return sorted(found)


def slow_contacts(hull, turn):
    """The lowest and the highest vertices of the turned hull."""
    c, s = turn
    heights = [x * s + y * c for x, y in hull]
    return (
        {k for k, h in enumerate(heights) if h == min(heights)},
        {k for k, h in enumerate(heights) if h == max(heights)},
    )


# --- the comparison ------------------------------------------------------------------------------


@given(any_part, st.lists(turns, min_size=1, max_size=5))
def test_squared_diameters(part, sample):
    d, vertices = DiameterFunction(part), plain(part.vertices)
    for turn in sample:
        assert d.squared(Angle(0, turn)) == slow_squared_diameter(vertices, turn)


@given(any_part)
def test_squared_diameters_at_extrema_and_transitions(part):
    d, vertices = DiameterFunction(part), plain(part.vertices)
    for angle in (*d.minima, *d.maxima, *d.transitions):
        turn = tuple(map(int, angle.direction))
        assert d.squared(angle) == slow_squared_diameter(vertices, turn)


@given(any_part)
def test_hulls(part):
    assert set(plain(part.hull.points.pairs())) == slow_hull(plain(part.vertices))


@given(any_part)
def test_antipodal_pairs(part):
    assert antipodal_pairs(part.hull) == slow_antipodal_pairs(plain(part.hull.points.pairs()))


@given(any_part, st.lists(turns, min_size=1, max_size=5))
def test_contacts(part, sample):
    hull, calipers = plain(part.hull.points.pairs()), rotate_calipers(part.hull)
    transitions = DiameterFunction(part).transitions
    half_turn = Angle(0, (-1, 0))
    for turn in sample:
        theta = Angle(0, turn) % half_turn
        c, s = map(int, theta.direction)
        lowest, highest = slow_contacts(hull, (c, s))
        piece = sum(1 for start in transitions if start <= theta) - 1
        lower, upper = int(calipers.lower[piece]), int(calipers.upper[piece])
        if piece < 0:  # before the first transition the last piece runs upside down
            lower, upper = upper, lower
        assert lower in lowest
        assert upper in highest
