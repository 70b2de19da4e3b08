"""Laws of arcs, and every question about them on a circle of 72 cells of 5 degrees."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, union_arcs, union_measure
from tests.strategies import TINY, angles, arcs

CELLS = 72
grid_arcs = st.tuples(st.integers(-80, 150), st.integers(1, CELLS))
"""Arcs on the grid: first cell, lifted, and number of cells."""

cell_counts = st.sampled_from([9, 18, 24, 36, 72])
"""Circles of 45, 90, 120, 180 and 360 degrees."""


def deg(cells):
    return Angle.from_degrees(5 * cells)


def made(grid_arc):
    return Arc(deg(grid_arc[0]), deg(grid_arc[1]))


def covered(grid_arc, circle=CELLS):
    """Return the cells of the circle that an arc covers."""
    first, count = grid_arc
    return {cell % circle for cell in range(first, first + count)}


def cells_of(pieces):
    """Return the cells of arcs that lie inside one circle, in the order given."""
    found = []
    for piece in pieces:
        first = piece.start.rational_turns * CELLS
        count = piece.width.rational_turns * CELLS
        assert first.denominator == count.denominator == 1
        found += range(int(first), int(first + count))
    return found


# --- on the grid ---------------------------------------------------------------------------------


@given(grid_arcs, st.integers(-200, 200))
def test_contains(a, cell):
    inside = cell % CELLS in covered(a)
    assert made(a).contains(deg(cell)) == inside
    assert made(a).contains(deg(cell) + TINY) == inside
    assert made(a).contains(deg(cell + 1) - TINY) == inside


@given(grid_arcs, grid_arcs)
def test_intersects(a, b):
    assert made(a).intersects(made(b)) == bool(covered(a) & covered(b))
    assert made(a).intersects(made(b)) == made(b).intersects(made(a))


@given(grid_arcs, cell_counts)
def test_split(a, circle):
    pieces = made(a).split(deg(circle))
    assert cells_of(pieces) == sorted(covered(a, circle))
    assert len(pieces) <= 2
    assert all(ZERO <= p.start < p.end <= deg(circle) for p in pieces)


@given(st.lists(grid_arcs, max_size=6), cell_counts)
def test_union(some, circle):
    union = union_arcs(map(made, some), deg(circle))
    cells = set().union(*(covered(a, circle) for a in some))
    assert cells_of(union) == sorted(cells)
    assert all(a.end < b.start for a, b in pairwise(union))
    assert union_measure(map(made, some), deg(circle)) == deg(len(cells))


# --- anywhere ------------------------------------------------------------------------------------

some_arcs = st.one_of(arcs(), arcs(), grid_arcs.map(made))


@given(some_arcs, angles())
def test_rotation_and_full_turns_change_nothing(a, theta):
    assert a.contains(theta) == a.contains(theta - 3 * FULL_TURN)
    assert a.contains(theta) == a.rotate(theta).contains(2 * theta)
    assert a.contains(a.start + FULL_TURN)
    assert a.contains(a.end) == (a.width == FULL_TURN)


@given(some_arcs, some_arcs, angles())
def test_intersection_means_a_common_start(a, b, theta):
    assert a.intersects(b) == a.rotate(theta).intersects(b.rotate(theta - FULL_TURN))
    if a.contains(theta) and b.contains(theta):
        assert a.intersects(b)


@given(some_arcs)
def test_pieces_have_the_width_of_the_whole(a):
    pieces = a.split()
    assert sum((p.width for p in pieces), start=ZERO) == a.width
    assert union_measure([a]) == a.width
    assert all(a.contains(p.start) for p in pieces)


@given(st.lists(some_arcs, max_size=5), st.lists(some_arcs, max_size=5), angles())
def test_measure_is_monotone_and_subadditive(first, second, theta):
    one, two = union_measure(first), union_measure(second)
    both = union_measure([*first, *second])
    assert max(one, two) <= both <= one + two
    assert both <= FULL_TURN
    if not any(a.intersects(b) for a in first for b in second):
        assert both == one + two
    moved = [a.rotate(theta) for a in (*second, *first)]
    assert union_measure(moved) == both


@given(st.lists(some_arcs, min_size=1, max_size=5), angles())
def test_a_union_contains_what_its_arcs_contain(some, theta):
    union = union_arcs(some)
    assert any(a.contains(theta) for a in some) == any(a.contains(theta) for a in union)
    assert union_arcs(union) == union


@given(some_arcs, st.integers(-3, 3))
def test_complements_fill_the_circle(a, shift):
    if a.width < FULL_TURN:
        rest = Arc(a.end + Angle(shift), FULL_TURN - a.width)
        assert not a.intersects(rest)
        assert union_arcs([a, rest]) == (Arc(ZERO, FULL_TURN),)
