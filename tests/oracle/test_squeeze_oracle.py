"""Squeeze functions by brute force: every orientation that could be an extremum is tried.

Candidates for minima turn the line through two vertices level, candidates for maxima turn it
upright. At each the one-sided slopes of the width are taken over all vertices; nothing of the
library decides.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key
from itertools import permutations

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    circle_parts,
    directions,
    large_directions,
    nearly_regular,
    parts,
    rational_parts,
)

any_part = st.one_of(parts(), parts(), rational_parts(), circle_parts(), nearly_regular(most=7))


# --- the slow road -------------------------------------------------------------------------------


def plain(part):
    """Return the outline as pairs of standard fractions."""
    return [
        tuple(Fraction(int(v.numerator), int(v.denominator)) for v in pair)
        for pair in part.vertices
    ]


def reduced(direction):
    """Return a direction in [0, 180) degrees, with a first non-zero component of size 1."""
    x, y = direction
    if y < 0 or (y == 0 and x < 0):
        x, y = -x, -y
    size = abs(x) or abs(y)
    return x / Fraction(size), y / Fraction(size)


by_angle = cmp_to_key(lambda a, b: a[1] * b[0] - a[0] * b[1])
"""Order of directions in [0, 180) degrees."""


def slopes(vertices, turn):
    """Return the slope of the width before and after a turn, up to a positive factor.

    A vertex at (x, y) of the turned part rises by x per radian.
    """
    c, s = turn
    turned = [(x * c - y * s, x * s + y * c) for x, y in vertices]
    top, bottom = max(y for _, y in turned), min(y for _, y in turned)
    upper = [x for x, y in turned if y == top]
    lower = [x for x, y in turned if y == bottom]
    return min(upper) - max(lower), max(upper) - min(lower)


def slow_extrema(part):
    """Return minima and maxima in [0, 180) degrees as directions, increasing."""
    vertices = plain(part)
    minima, maxima = set(), set()
    for (px, py), (qx, qy) in permutations(set(vertices), 2):
        dx, dy = qx - px, qy - py
        level, upright = reduced((dx, -dy)), reduced((dy, dx))
        before, after = slopes(vertices, level)
        if before < 0 < after:
            minima.add(level)
        before, after = slopes(vertices, upright)
        if before == 0 == after:  # smooth, and a sinusoid is concave where it is positive
            maxima.add(upright)
    return sorted(minima, key=by_angle), sorted(maxima, key=by_angle)


def slow_squeeze(extrema, turn):
    """Return the minimum that a turn goes to, as a direction: the one after the last maximum."""
    minima, maxima = extrema
    turn = reduced(turn)
    at_most = [k for k, break_ in enumerate(maxima) if by_angle(break_) <= by_angle(turn)]
    # The step begins at the last maximum at most `turn`, around the half turn if there is none.
    start = maxima[at_most[-1]] if at_most else maxima[-1]
    later = [value for value in minima if by_angle(value) > by_angle(start)]
    return later[0] if later else minima[0]


def slow_order(found):
    """Return how often the extrema repeat in a full turn, by turning them.

    Directions of rational points repeat after 180, 90 or 45 degrees: no other share of half a
    turn has a rational tangent.
    """
    for order, (c, s) in ((8, (1, 1)), (4, (0, 1))):
        turned = [{reduced((x * c - y * s, x * s + y * c)) for x, y in kind} for kind in found]
        if turned == [set(kind) for kind in found]:
            return order
    return 2


def directions_over_half_a_turn(angles, order):
    """Return the library's angles, repeated over half a turn, as directions."""
    found = set()
    for angle in angles:
        for k in range(order // 2):
            turned = angle + Angle.from_turns(Fraction(k, order))
            found.add(reduced(tuple(Fraction(int(v)) for v in turned.direction)))
    return sorted(found, key=by_angle)


# --- the comparison ------------------------------------------------------------------------------


@given(any_part)
def test_breaks_values_and_smallest_period(part):
    s = squeeze_function(part)
    minima, maxima = found = slow_extrema(part)
    assert directions_over_half_a_turn(s.breaks, s.order) == maxima
    assert directions_over_half_a_turn(s.values, s.order) == minima
    assert len(s) * s.order == 2 * len(maxima)
    assert s.order == slow_order(found)


@given(any_part, st.lists(st.one_of(directions, large_directions), min_size=1, max_size=5))
def test_every_orientation_goes_to_the_minimum_of_its_step(part, sample):
    s, extrema = squeeze_function(part), slow_extrema(part)
    sample += [tuple(map(int, angle.direction)) for angle in (*s.breaks, *s.values)]
    for turn in sample:
        value = s(Angle(0, turn))
        direction = tuple(Fraction(int(v)) for v in value.direction)
        assert reduced(direction) == slow_squeeze(extrema, tuple(map(Fraction, turn)))
        # The lift: a squeeze turns a part by less than half a turn.
        assert abs(value.to_float() - Angle(0, turn).to_float()) < 3.1415926536
