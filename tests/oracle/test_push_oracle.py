"""Pushes by brute force: a part is turned downhill, from vertex to vertex, until it lies still.

For a given orientation the slope of the centre's height above the jaw is read off the lowest
vertices; the part is turned about the contact until the next vertex touches, and so on. Whole
numbers and all vertices, not those of the hull; nothing of the library decides.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key
from itertools import permutations
from math import atan2, gcd, lcm

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push import push_function
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    centered_parts,
    circle_parts,
    directions,
    large_directions,
    long_centered_parts,
)

any_part = st.one_of(
    centered_parts(), centered_parts(), centered_parts(), circle_parts(), long_centered_parts()
)
turns = st.one_of(directions, directions, large_directions)


# --- the slow road -------------------------------------------------------------------------------


def scaled(part):
    """Return the vertices as seen from the centre of mass, in whole numbers, and their scale."""
    cx, cy = part.center_of_mass
    found = [(x - cx, y - cy) for x, y in part.vertices]
    scale = lcm(*(int(value.denominator) for pair in found for value in pair))
    return list({(int(x * scale), int(y * scale)) for x, y in found}), scale


def plain(part):
    return scaled(part)[0]


def turned(vertices, turn):
    c, s = turn
    return [(x * c - y * s, x * s + y * c) for x, y in vertices]


def lowest(points):
    bottom = min(y for _, y in points)
    return sorted(p for p in points if p[1] == bottom)


def slopes(vertices, turn):
    """Return the slope of the radius before and after a turn, up to a positive factor.

    A vertex at (x, y) of the turned part rises by x per radian; what matters is the lowest one.
    """
    touching = lowest(turned(vertices, turn))
    return -touching[-1][0], -touching[0][0]


def slow_push(vertices, turn):
    """Return where a turn goes to, as a turn, and the angle on the way in float radians."""
    way = 0.0
    for _ in range(2 * len(vertices) + 2):
        before, after = slopes(vertices, turn)
        if before < 0 < after:
            return turn, way
        # At a maximum, 0 and 0, the right-hand step applies. Where one slope is zero the part is
        # over the end of an edge: it goes on to the side on which it is not held.
        left = before > 0 or (before == 0 and after > 0)
        following = next_contact(vertices, turn, left=left)
        (a, b), (c, d) = turn, following
        x, y = unit((a * c + b * d, a * d - b * c))
        step = atan2(y, x)
        assert (step < 0) == left
        way += step
        turn = following
    raise AssertionError("the part never lies still")


def next_contact(vertices, turn, *, left):
    """Return the first turn, clockwise or counter-clockwise, at which a second vertex touches."""
    points = turned(vertices, turn)
    touching = lowest(points)
    pivot = touching[-1] if left else touching[0]
    ways = [(x - pivot[0], y - pivot[1]) for x, y in points if (x, y) != pivot]
    # Rays of the closed upper half plane by argument. Clockwise the one of the least argument
    # comes down first, counter-clockwise the one of the greatest.
    ways.sort(key=cmp_to_key(lambda a, b: a[1] * b[0] - a[0] * b[1]))
    if left:
        ways = [way for way in ways if way[1] > 0]
        x, y = ways[0]
    else:
        x, y = ways[-1]
        x, y = -x, -y  # level when it points the other way
    # Turning back by arg(x, y) makes it level.
    return unit((turn[0] * x + turn[1] * y, turn[1] * x - turn[0] * y))


def slow_extrema(vertices):
    """Return minima and maxima in [0, 360) degrees, as sets of directions of unit size."""
    minima, maxima = set(), set()
    for (px, py), (qx, qy) in permutations(vertices, 2):
        level = (qx - px, py - qy)
        before, after = slopes(vertices, level)
        if before < 0 < after:
            minima.add(unit(level))
    for x, y in vertices:
        # Turned by this the vertex is straight below the centre; it has to be the only contact.
        upright = (-y, -x)
        if upright != (0, 0) and lowest(turned(vertices, upright)) == [(0, -x * x - y * y)]:
            maxima.add(unit(upright))
    return minima, maxima


def unit(direction):
    """Return a direction in lowest terms."""
    x, y = direction
    common = gcd(x, y)
    return x // common, y // common


def as_turn(angle):
    return tuple(map(int, angle.direction))


def over_a_full_turn(angles, order):
    """Return one period of angles as the directions of a full turn."""
    return {
        unit(as_turn(angle + Angle.from_turns(Fraction(k, order))))
        for angle in angles
        for k in range(order)
    }


def slow_order(found):
    """Return how often the extrema repeat in a full turn, by turning them by eighths."""
    for order, (c, s) in ((8, (1, 1)), (4, (0, 1)), (2, (-1, 0))):
        if all({unit((x * c - y * s, x * s + y * c)) for x, y in kind} == kind for kind in found):
            return order
    return 1


# --- the comparison ------------------------------------------------------------------------------


@given(any_part)
def test_extrema(part):
    r, (minima, maxima) = RadiusFunction(part), slow_extrema(plain(part))
    assert over_a_full_turn(r.minima, 1) == minima
    assert over_a_full_turn(r.maxima, 1) == maxima
    assert len(r.minima) == len(minima) == len(maxima) == len(r.maxima)


@given(any_part)
def test_breaks_values_and_smallest_period(part):
    s, found = push_function(part), slow_extrema(plain(part))
    assert over_a_full_turn(s.values, s.order) == found[0]
    assert over_a_full_turn(s.breaks, s.order) == found[1]
    assert len(s) * s.order == len(found[1])
    assert s.order == slow_order(found)


def sampled(part, sample, *functions):
    """Return the sample as angles, with all breaks, values and flush orientations."""
    special = [angle for s in functions for angle in (*s.breaks, *s.values)]
    return [Angle(0, turn) for turn in sample] + special + list(RadiusFunction(part).transitions)


@given(any_part, st.lists(turns, min_size=1, max_size=5))
def test_every_orientation_is_pushed_downhill_to_a_flush_edge(part, sample):
    s, vertices = push_function(part), plain(part)
    for theta in sampled(part, sample, s):
        turn, way = slow_push(vertices, as_turn(theta))
        value = s(theta)
        assert unit(as_turn(value)) == unit(turn)
        assert abs(value.to_float() - theta.to_float() - way) < 1e-3  # the lift


@given(any_part, st.lists(turns, min_size=1, max_size=5))
def test_push_then_squeeze(part, sample):
    s, squeeze, vertices = push_grasp_function(part), squeeze_function(part), plain(part)
    for theta in sampled(part, sample, s, squeeze):
        turn, way = slow_push(vertices, as_turn(theta))
        pushed = Angle(0, turn)
        while pushed.to_float() - theta.to_float() - way < -1:
            pushed += Angle(1)
        while pushed.to_float() - theta.to_float() - way > 1:
            pushed -= Angle(1)
        assert s(theta) == squeeze(pushed)


@given(any_part, st.lists(turns, min_size=1, max_size=5))
def test_squared_radii(part, sample):
    r, (vertices, scale) = RadiusFunction(part), scaled(part)
    for theta in sampled(part, sample):
        c, s = as_turn(theta)
        height = -lowest(turned(vertices, (c, s)))[0][1]
        assert height > 0
        assert r.squared(theta) == Fraction(height**2, (c * c + s * s) * scale**2)
