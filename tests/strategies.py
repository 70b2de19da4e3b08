"""All random input of the tests, on small grids so that degenerate cases are common.

A coordinate range of -4..4 makes parallel edges, right angles, symmetric parts and exact ties
frequent; `tests/unit/test_strategies.py` checks that they are.
"""

from __future__ import annotations

from fractions import Fraction

from hypothesis import strategies as st

from stochgeom.errors import InvalidPartError
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.geometry.part import Part
from stochgeom.transfer.step_function import StepFunction

small = st.integers(-4, 4)
"""Coordinates on which degenerate cases are common."""

fractions = st.fractions(-20, 20, max_denominator=12)
"""Rationals with small denominators."""

points = st.tuples(small, small)

rational_points = st.tuples(fractions, fractions)

directions = points.filter(lambda p: p != (0, 0))
"""Non-zero integer vectors."""

large_directions = st.tuples(st.integers(-(10**40), 10**40), st.integers(-(10**40), 10**40)).filter(
    lambda p: p != (0, 0)
)

PYTHAGOREAN = [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-5, 12), (8, -15), (-20, -21)]
"""Directions of whole length: exact rotations."""

rotations = st.sampled_from(PYTHAGOREAN)


@st.composite
def angles(draw: st.DrawFn, *, rational_turns: bool = True) -> Angle:
    """Lifted angles; with `rational_turns` some like 71 degrees, no rational direction."""
    x, y = draw(st.one_of(directions, directions, large_directions))
    turns = st.integers(-3, 3).map(Fraction)
    if rational_turns:
        turns = st.one_of(turns, turns, st.fractions(-3, 3, max_denominator=24))
    return Angle(draw(turns), (x, y))


@st.composite
def arcs(draw: st.DrawFn) -> Arc:
    """Arcs of rational directions, full turns among them."""
    start = draw(angles(rational_turns=False))
    width = Angle(0, draw(directions))
    return Arc(start, width if width else Angle(1))


@st.composite
def star_polygons(draw: st.DrawFn, *, least: int = 3, most: int = 9) -> Part:
    """Simple polygons, often not convex: distinct grid points in order about one of the plane."""
    corners = draw(st.lists(points, min_size=least, max_size=most, unique=True))
    eye = (
        Fraction(sum(x for x, _ in corners), len(corners)) + Fraction(1, 97),
        Fraction(sum(y for _, y in corners), len(corners)) + Fraction(1, 89),
    )
    corners.sort(key=lambda p: Angle(0, (p[0] - eye[0], p[1] - eye[1])))
    return _part_or_reject(corners)


@st.composite
def hulls(draw: st.DrawFn, *, least: int = 3, most: int = 10) -> Part:
    """Convex polygons: hulls of distinct grid points."""
    corners = draw(st.lists(points, min_size=least, max_size=most, unique=True))
    return _part_or_reject(_in_hull_order(corners))


def parts() -> st.SearchStrategy[Part]:
    """Simple polygons of all kinds, small symmetric ones among them."""
    return st.one_of(hulls(), star_polygons(), st.sampled_from(SPECIAL))


@st.composite
def step_functions(draw: st.DrawFn) -> StepFunction:
    """Step maps of period 360, 180, 120, 90 or 45 degrees with rational-degree parts.

    Breaks and values come from one grid of 5 degrees, so that ties are the rule.
    """
    order = draw(st.sampled_from([1, 2, 3, 4, 8]))
    cells = 72 // order
    count = draw(st.integers(1, min(6, cells)))
    breaks = sorted(draw(st.sets(st.integers(0, cells - 1), min_size=count, max_size=count)))
    first = draw(st.integers(-cells, cells))
    rises = draw(st.lists(st.integers(0, cells), min_size=count - 1, max_size=count - 1))
    values = [first]
    for rise in rises:
        values.append(min(values[-1] + rise, first + cells))
    grid = [Angle.from_degrees(5 * k) for k in (*breaks, *values)]
    return StepFunction(grid[:count], grid[count:], Angle.from_turns(Fraction(1, order)))


def _part_or_reject(corners: list[tuple[int, int]]) -> Part:
    from hypothesis import reject

    try:
        return Part(corners)
    except InvalidPartError:
        reject()


def _in_hull_order(corners: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Gift wrapping on integers, written apart from the library's own hull."""
    start = min(corners)
    chain = [start]
    while True:
        here = chain[-1]
        best = None
        for p in corners:
            if p == here:
                continue
            if best is None:
                best = p
                continue
            cross = (best[0] - here[0]) * (p[1] - here[1]) - (best[1] - here[1]) * (p[0] - here[0])
            farther = (p[0] - here[0]) ** 2 + (p[1] - here[1]) ** 2 > (best[0] - here[0]) ** 2 + (
                best[1] - here[1]
            ) ** 2
            if cross < 0 or (cross == 0 and farther):
                best = p
        if best is None or best == start or len(chain) > len(corners):
            return chain
        chain.append(best)


SPECIAL = [
    Part([(0, 0), (1, 0), (1, 1), (0, 1)], name="square"),
    Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="rectangle"),
    Part([(0, 0), (1, 0), (0, 1)], name="right triangle"),
    Part([(0, 0), (5, 0), (-1, 1)], name="obtuse triangle"),
    Part([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)], name="period 90, r = 1"),
    Part([(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)], name="octagon"),
    Part([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)], name="square of 8"),
    Part([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], name="L"),
]
"""Corners of the input space: squares, shared squeeze functions, hidden symmetry, collinearity."""
