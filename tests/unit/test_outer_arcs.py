"""Unions of closed arcs with ends rounded outwards."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.exact.outer_arcs import TURN, OuterArcs, units_around
from tests.strategies import orientations

PERIOD = 24
small_arcs = st.lists(
    st.tuples(st.integers(-50, 50), st.integers(0, 30)).map(lambda p: (p[0], p[0] + p[1])),
    max_size=5,
)


def members(arcs):
    """Return the whole units of a union, modulo the period, one by one."""
    return {x % PERIOD for start, end in arcs for x in range(start, end + 1)}


@given(orientations)
def test_units_around_an_angle(theta):
    low, high = units_around(theta)
    assert _angle(low) <= theta <= _angle(high)
    assert high - low <= 2


def _angle(units):
    return Angle.from_turns(Fraction(units, TURN))


def test_exact_angles_need_no_room():
    for degrees in (-45, 0, 90, 720):
        low, high = units_around(Angle.from_degrees(degrees))
        assert low == high == degrees * TURN // 360
    low, high = units_around(Angle.from_degrees(1))
    assert high - low == 1


@given(small_arcs, st.integers(-60, 60))
def test_membership_and_neighbours(arcs, x):
    union, held = OuterArcs(arcs, PERIOD), members(arcs)
    assert bool(union) == bool(arcs)
    around = union.around(x)
    assert (around is not None) == (x % PERIOD in held)
    if held:
        later = [y for y in range(x, x + PERIOD) if y % PERIOD in held]
        assert union.first_from(x) == later[0]
        earlier = [y for y in range(x, x - PERIOD, -1) if y % PERIOD in held]
        assert union.last_to(x) == earlier[0]
    if around is not None:
        low, high = around
        assert low <= x <= high
        assert union.is_whole or all(y % PERIOD in held for y in range(low, high + 1))


@given(small_arcs, small_arcs)
def test_intersections(first, second):
    both = OuterArcs(first, PERIOD).intersection(OuterArcs(second, PERIOD))
    assert members(both) == members(first) & members(second)


@given(small_arcs, st.integers(-60, 60), st.integers(0, 23))
def test_parts_of_an_arc(arcs, start, width):
    parts = list(OuterArcs(arcs, PERIOD).parts_in((start, start + width)))
    found = [x for low, high in parts for x in range(low, high + 1)]
    assert found == [x for x in range(start, start + width + 1) if x % PERIOD in members(arcs)]


def test_whole_circles_are_known():
    assert OuterArcs([(3, 3 + PERIOD)], PERIOD).is_whole
    assert OuterArcs([(0, 13), (10, 25)], PERIOD).is_whole
    assert not OuterArcs([(0, PERIOD - 1)], PERIOD).is_whole  # the gap before 24 is open
    assert OuterArcs([], PERIOD).around(3) is None
