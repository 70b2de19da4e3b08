"""Sets of orientations form a Boolean algebra, cell by cell.

Critical orientations are multiples of 30 degrees: whether multiples of 15 degrees belong to a set
says everything about it.
"""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval
from tests.strategies import cell_sets, orientations

GRID = [Angle.from_degrees(15 * k) for k in range(24)]
steps = st.integers(-30, 30)
MANY = max(100, settings().max_examples // 5)


def members(cells):
    """Return the numbers of the grid orientations in a set; odd ones stand for open arcs."""
    return {k for k, theta in enumerate(GRID) if theta in cells}


@given(cell_sets(), cell_sets())
@settings(max_examples=MANY)
def test_the_algebra_is_that_of_the_members(a, b):
    mine, theirs = members(a), members(b)
    assert members(~a) == set(range(24)) - mine
    assert members(a | b) == mine | theirs
    assert members(a & b) == mine & theirs
    assert members(a - b) == mine - theirs
    assert members(a ^ b) == mine ^ theirs
    assert (a <= b) == (mine <= theirs)
    assert bool(a) == bool(mine)
    assert a.is_whole == (len(mine) == 24)


@given(cell_sets(), cell_sets())
@settings(max_examples=MANY)
def test_equal_sets_have_equal_parts(a, b):
    assert (a == b) == (members(a) == members(b))
    assert a != b or hash(a) == hash(b)
    assert (a | b) & ~b == a - b
    assert ~(a | b) == ~a & ~b
    assert ~~a == a


@given(cell_sets())
@settings(max_examples=MANY)
def test_intervals_put_together_make_the_set(a):
    found = a.intervals()
    assert CellSet.of(found) == a
    for item in found:
        assert (item.start in a) == item.includes_start
        assert (item.end in a) == item.includes_end or a.is_whole
    # Maximal: two of them never touch, but where the orientation between is left out.
    ends = {item.end.reduced() for item in found if item.includes_end}
    assert not ends & {item.start for item in found if item.width and not a.is_whole}


@given(cell_sets())
@settings(max_examples=MANY)
def test_the_measure_counts_the_arcs(a):
    assert a.measure.rational == Fraction(sum(k % 2 for k in members(a)), 12)
    assert sum((arc.width for arc in a.half_open()), start=ZERO).rational_turns == (
        a.measure.rational
    )


@given(cell_sets(), steps)
@settings(max_examples=MANY)
def test_turning_moves_the_members(a, step):
    turned = a.rotate(Angle.from_degrees(15 * step))
    assert members(turned) == {(k + step) % 24 for k in members(a)}
    assert members(a.reflect()) == {-k % 24 for k in members(a)}


@given(cell_sets(), st.integers(0, 11))
@settings(max_examples=MANY)
def test_shrinking_keeps_what_has_the_margin(a, step):
    kept = a.shrunk(Angle.from_degrees(15 * step))
    inside = members(a)
    # Between grid orientations an arc belongs if the two multiples of 15 about it tell so.
    fine = {Fraction(k) for k in inside} | {
        Fraction(2 * k + 1, 2) for k in range(24) if (k if k % 2 else (k + 1) % 24) in inside
    }

    def has_margin(k):
        window = [Fraction(2 * k + n, 2) % 24 for n in range(-2 * step, 2 * step + 1)]
        return all(place in fine for place in window)

    assert members(kept) == {k for k in range(24) if has_margin(k)}


@given(cell_sets(), orientations)
@settings(max_examples=MANY)
def test_membership_is_asked_on_the_circle(a, theta):
    assert (theta in a) == (theta + FULL_TURN in a) == (theta in CellSet.at([theta]) & a)
    assert (theta in a) != (theta in ~a)


@given(st.lists(st.tuples(st.integers(-24, 24), st.integers(0, 12), st.booleans(), st.booleans())))
@settings(max_examples=MANY)
def test_a_union_of_intervals_holds_what_they_hold(listed):
    intervals = [
        Interval(Angle.from_degrees(30 * start), Angle.from_degrees(30 * width), *ends)
        for start, width, *ends in listed
        if width or all(ends)
    ]

    def holds(item, theta):
        ahead = (theta - item.start).reduced()
        at_end = not (theta - item.end).reduced()
        inside = bool(ahead) and ahead < item.width
        return inside or (item.includes_end and at_end) or (item.includes_start and not ahead)

    expected = {k for k, theta in enumerate(GRID) if any(holds(item, theta) for item in intervals)}
    assert members(CellSet.of(intervals)) == expected
