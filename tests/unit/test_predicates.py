"""`stochgeom.exact.predicates`: worked cases, and arrays against single pairs."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.predicates import (
    Turn,
    as_objects,
    compare_arguments,
    compare_points,
    cross_sign,
    cross_signs,
    dot_sign,
    dot_signs,
    fits_float,
    half_plane,
    half_planes,
    orientation,
    sign,
)
from tests.strategies import int64s, near_ties, small

COMPASS = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1)]
COMPASS += [(-x, -y) for x, y in COMPASS]
"""Directions in increasing order of argument from 0, the second half opposite to the first."""

rows = st.lists(st.tuples(int64s, int64s, int64s, int64s), min_size=1, max_size=12)


def columns(quadruples, dtype=np.int64):
    return [np.array(column, dtype=dtype) for column in zip(*quadruples, strict=True)]


def objects(quadruples):
    return columns([[mpz(value) for value in row] for row in quadruples], dtype=object)


# --- one pair ------------------------------------------------------------------------------------


def test_sign():
    assert [sign(value) for value in (-7, 0, 3, mpz(-1), mpz(0))] == [-1, 0, 1, -1, 0]


def test_arguments_increase_around_the_compass():
    for i, a in enumerate(COMPASS):
        for j, b in enumerate(COMPASS):
            assert compare_arguments(*a, *b) == (i > j) - (i < j)
            assert compare_arguments(*a, 3 * b[0], 3 * b[1]) == (i > j) - (i < j)
            gap = (j - i) % 16
            assert cross_sign(*a, *b) == (0 if gap in (0, 8) else 1 if gap < 8 else -1)
    assert [half_plane(*a) for a in COMPASS] == [0] * 8 + [1] * 8


def test_the_dot_product_tells_acute_from_obtuse():
    assert dot_sign(1, 2, 2, -1) == 0
    assert dot_sign(1, 2, 2, 1) == 1
    assert dot_sign(1, 2, -2, -1) == -1
    assert dot_sign(2**63, 1, -1, 2**63) == 0
    assert dot_sign(2**63, 1, -1, 2**63 + 1) == 1


@given(st.tuples(small, small, small, small), st.integers(1, 10**30))
def test_signs_of_products_are_those_of_the_numbers(row, factor):
    ax, ay, bx, by = row
    assert cross_sign(*row) == sign(ax * by - ay * bx) == -cross_sign(bx, by, ax, ay)
    assert dot_sign(*row) == sign(ax * bx + ay * by) == dot_sign(bx, by, ax, ay)
    assert cross_sign(factor * ax, factor * ay, bx, by) == cross_sign(*row)


# --- points --------------------------------------------------------------------------------------


points = st.tuples(small, small, st.integers(1, 6)).map(lambda p: tuple(map(mpz, p)))
"""Homogeneous points of small numbers, not reduced."""


def plain(point):
    x, y, w = map(int, point)
    return Fraction(x, w), Fraction(y, w)


def stretched(point, factor):
    return tuple(factor * value for value in point)


def test_turns_have_names():
    origin, east, north = (0, 0, 1), (5, 0, 1), (0, 5, 1)
    assert orientation(origin, east, north) is Turn.LEFT
    assert orientation(origin, north, east) is Turn.RIGHT
    assert orientation(origin, east, (7, 0, 3)) is Turn.STRAIGHT
    assert orientation(origin, origin, east) is Turn.STRAIGHT


@given(points, points, points, st.integers(1, 9))
def test_orientation_is_the_sign_of_the_area(p, q, r, factor):
    (px, py), (qx, qy), (rx, ry) = map(plain, (p, q, r))
    area = (qx - px) * (ry - py) - (qy - py) * (rx - px)
    assert orientation(p, q, r) == orientation(q, r, p) == sign(area)
    assert orientation(r, q, p) == -sign(area)
    assert orientation(p, stretched(q, factor), r) == sign(area)


@given(points, points, st.integers(1, 9))
def test_points_are_ordered_by_x_then_y(p, q, factor):
    a, b = plain(p), plain(q)
    assert compare_points(stretched(p, factor), q) == (a > b) - (a < b)


# --- arrays --------------------------------------------------------------------------------------


@given(rows)
def test_arrays_agree_with_single_pairs(quadruples):
    crosses = [cross_sign(*row) for row in quadruples]
    dots = [dot_sign(*row) for row in quadruples]
    for made in (columns(quadruples), objects(quadruples)):
        assert cross_signs(*made).tolist() == crosses
        assert dot_signs(*made).tolist() == dots
        assert cross_signs(*made).dtype == dot_signs(*made).dtype == np.int8


@given(rows)
def test_arrays_of_both_kinds_mix(quadruples):
    ax, ay, _, _ = columns(quadruples)
    _, _, bx, by = objects(quadruples)
    assert cross_signs(ax, ay, bx, by).tolist() == [cross_sign(*row) for row in quadruples]
    assert dot_signs(bx, by, ax, ay).tolist() == [dot_sign(*row) for row in quadruples]


@given(st.lists(near_ties(), min_size=1, max_size=8))
def test_products_that_float64_cannot_tell_apart(quadruples):
    made = columns(quadruples)
    assert fits_float(*made)
    a, b, c, d = made
    expected = [sign(w * z - x * y) for w, x, y, z in quadruples]
    assert cross_signs(a, b, c, d).tolist() == expected
    assert dot_signs(a, b, d, -c).tolist() == expected


def test_neighbouring_fibonacci_numbers():
    # F(k) F(k+2) - F(k+1)**2 is 1 for odd k and -1 for even k.
    numbers = [1, 1]
    while numbers[-1] + numbers[-2] < 2**53:
        numbers.append(numbers[-1] + numbers[-2])
    assert numbers[-1] > 2**52
    f = np.array(numbers)
    signs = cross_signs(f[:-2], f[1:-1], f[1:-1], f[2:])
    assert signs.tolist() == [1 if k % 2 == 0 else -1 for k in range(len(numbers) - 2)]


@pytest.mark.parametrize("top", [2**53 - 3, 2**52, 2**51 + 1, 2**31])
def test_neighbouring_integers(top):
    # a (a + 2) - (a + 1)**2 = -1, and the float64 products are the same.
    a = np.arange(top - 1000, top)
    assert (cross_signs(a, a + 1, a + 1, a + 2) == -1).all()
    assert (cross_signs(a + 1, a, a + 2, a + 1) == 1).all()
    assert (cross_signs(a, a + 1, a, a + 1) == 0).all()
    assert (dot_signs(a, -a - 1, a + 2, a + 1) == -1).all()
    if top > 2**51:
        assert (a.astype(float) * (a + 2) == (a + 1.0) ** 2).any()


def test_the_limits_of_int64():
    least, most = -(2**63), 2**63 - 1
    quadruples = [
        (least, most, most, least),  # 2**126 - (2**63 - 1)**2 > 0
        (least, least, least, least),
        (most, most, least, least),
        (2**62, 1, 2**62, 1),
        (least, -1, most, 1),
        (2**62, 2**62 + 1, 2**62 - 1, 2**62),
        (0, least, 0, least),
    ]
    assert cross_signs(*columns(quadruples)).tolist() == [1, 0, 0, 0, -1, 1, 0]
    assert dot_signs(*columns(quadruples)).tolist() == [-1, 1, -1, 1, -1, 1, 1]


def test_what_fits_float64():
    inside, outside = np.array([2**53 - 1, 1 - 2**53]), np.array([2**53])
    assert fits_float(inside, np.array([], dtype=np.int64))
    assert not fits_float(inside, outside)
    assert not fits_float(-outside)
    assert not fits_float(np.array([-(2**63)]))
    assert not fits_float(inside.astype(object))
    assert not fits_float(np.array([1], dtype=np.int32))


def test_narrow_and_unsigned_integers_do_not_wrap():
    bytes_ = [np.array([v], dtype=np.int8) for v in (-128, 127, 127, -128)]
    assert cross_signs(*bytes_).tolist() == [1]
    words = [np.array([v], dtype=np.uint64) for v in (2**64 - 1, 1, 1, 2**64 - 1)]
    assert cross_signs(*words).tolist() == [1]
    assert dot_signs(*words).tolist() == [1]


def test_empty_arrays():
    none = np.array([], dtype=np.int64)
    assert cross_signs(none, none, none, none).tolist() == []
    assert dot_signs(none, none, none, none).tolist() == []
    assert half_planes(none, none).tolist() == []


def test_half_planes():
    x, y = np.array(COMPASS).T
    expected = [False] * 8 + [True] * 8
    assert half_planes(x, y).tolist() == expected
    assert half_planes(as_objects(x), as_objects(y)).tolist() == expected
    assert half_planes(as_objects(x), as_objects(y)).dtype == np.bool_


def test_objects_hold_unbounded_integers():
    array = as_objects(np.array([2**62, -(2**63)]))
    assert (array * array).tolist() == [2**124, 2**126]
    assert as_objects(array) is array
