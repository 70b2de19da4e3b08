"""`stochgeom.geometry.points`: what is read as points, and how it is stored."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq, mpz

from stochgeom.errors import FloatRefusedError, InvalidPartError, NumberError, NumberLimitError
from stochgeom.geometry.points import Points, as_point

LIMIT = 2**52


def circle_point(t):
    t = Fraction(t)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


CIRCLE = [circle_point(Fraction(k, 1000 + k)) for k in range(8)]


# --- reading -------------------------------------------------------------------------------------


def test_every_exact_notation_is_read():
    mixed = [(0, "1/3"), (Fraction(1, 2), Decimal("0.25")), (mpq(5, 6), mpz(-2)), ("1e-2", "-7")]
    assert Points.from_pairs(mixed).pairs() == (
        (0, mpq(1, 3)),
        (mpq(1, 2), mpq(1, 4)),
        (mpq(5, 6), -2),
        (mpq(1, 100), -7),
    )


def test_small_integers_are_kept_in_int64():
    points = Points.from_pairs([(1, 2), (3, 4), (-5, 6)])
    assert points.x.dtype == points.y.dtype == np.int64
    assert points.w is None
    assert points.scale == 1


def test_a_small_common_denominator_is_shared():
    points = Points.from_pairs([("1/2", 0), ("1/3", 1), (5, "3/4")])
    assert points.w is None
    assert points.scale == 12
    assert points.x.tolist() == [6, 4, 60]
    assert points.pairs() == ((mpq(1, 2), 0), (mpq(1, 3), 1), (5, mpq(3, 4)))


def test_a_large_common_denominator_is_not():
    points = Points.from_pairs(CIRCLE)
    assert points.w is not None
    assert points.scale == 1
    assert max(int(w).bit_length() for w in points.w) <= 22
    assert points.pairs() == tuple((mpq(x), mpq(y)) for x, y in CIRCLE)


@pytest.mark.parametrize("size", [LIMIT - 1, LIMIT, 2**53, 2**62, 2**63 - 1, 2**80, 10**400])
def test_no_size_of_integers_loses_a_digit(size):
    pairs = [(size, -size), (-size, size - 1), (1 - size, 0)]
    points = Points.from_pairs(pairs)
    assert (points.x.dtype == np.int64) == (size < LIMIT)
    assert points.pairs() == tuple((mpq(x), mpq(y)) for x, y in pairs)


@pytest.mark.parametrize("kind", [np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint64])
def test_integer_arrays_of_every_kind_are_read(kind):
    array = np.array([(0, 0), (100, 0), (0, 100)], dtype=kind)
    points = Points.from_pairs(array)
    assert points.x.dtype == np.int64
    assert points.pairs() == Points.from_pairs(array.tolist()).pairs()


@pytest.mark.parametrize("kind", [np.int64, np.uint64])
def test_the_ends_of_the_array_types_are_read(kind):
    ends = np.iinfo(kind)
    array = np.array([(ends.min, ends.max), (ends.max, ends.min), (0, 1)], dtype=kind)
    assert Points.from_pairs(array).pairs() == tuple((mpq(x), mpq(y)) for x, y in array.tolist())


def test_an_array_of_exact_objects_is_read():
    array = np.array([(mpq(1, 2), 3), ("1/4", Fraction(1, 3))], dtype=object)
    assert Points.from_pairs(array).pairs() == ((mpq(1, 2), 3), (mpq(1, 4), mpq(1, 3)))


def test_rows_may_be_arrays_and_points_may_come_from_a_generator():
    rows = [np.array([1, 2]), np.array([3, 4])]
    assert Points.from_pairs(row for row in rows).pairs() == ((1, 2), (3, 4))


def test_a_later_change_of_the_array_changes_nothing():
    array = np.array([(0, 0), (4, 0), (0, 4)])
    points = Points.from_pairs(array)
    array[:] = 9
    assert points.pairs() == ((0, 0), (4, 0), (0, 4))


def test_no_points():
    assert len(Points.from_pairs([])) == 0
    assert Points.from_pairs([]).pairs() == ()


# --- refusing ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pairs", "error", "where", "accepted"),
    [
        ([(0, 0), (0.5, 0)], FloatRefusedError, "vertex 1, x", "from_float_exact"),
        ([(0, 0), (0, float("nan"))], FloatRefusedError, "vertex 1, y", "from_float_shortest"),
        ([(0, np.float64(1))], FloatRefusedError, "vertex 0, y", "text or a Fraction"),
        ([("nan", 0)], NumberError, "vertex 0, x", "accepted: whole numbers"),
        ([(0, 0), (1, "inf")], NumberError, "vertex 1, y", "accepted: whole numbers"),
        ([(0, Decimal("NaN"))], NumberError, "vertex 0, y", "accepted: whole numbers"),
        ([(0, Decimal("-Infinity"))], NumberError, "vertex 0, y", "accepted: whole numbers"),
        ([(0, "1/0")], NumberError, "vertex 0, y", "divides by zero"),
        ([(0, "1e999999999")], NumberLimitError, "vertex 0, y", "accepted: exponents"),
        ([(0, "9" * 20_001)], NumberLimitError, "vertex 0, y", "accepted: at most 20000"),
        ([(0, None)], NumberError, "vertex 0, y", "accepted: whole numbers"),
        ([(True, 0)], NumberError, "vertex 0, x", "truth value"),
        ([(1j, 0)], NumberError, "vertex 0, x", "not an exact number"),
        ([(0, 0), (1, 2, 3)], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), (1,)], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), 7], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), "12"], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), b"12"], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), {1, 2}], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), {1: 5, 2: 6}], NumberError, "vertex 1", "accepted: (x, y)"),
        ([(0, 0), (1, (2, 3))], NumberError, "vertex 1, y", "not an exact number"),
        (7, NumberError, "vertex list", "accepted: pairs of exact numbers"),
        (None, NumberError, "vertex list", "accepted: pairs of exact numbers"),
        ("0,0 1,0 0,1", NumberError, "vertex 0", "accepted: (x, y)"),
    ],
)
def test_what_is_no_list_of_exact_points_is_refused(pairs, error, where, accepted):
    with pytest.raises(error) as caught:
        Points.from_pairs(pairs)
    assert type(caught.value) is error
    assert caught.value.where == where
    assert accepted in caught.value.message


@pytest.mark.parametrize(
    ("array", "error", "where", "accepted"),
    [
        (np.zeros((3, 2)), FloatRefusedError, "vertex array", "an integer array"),
        (np.zeros((3, 2), dtype=np.float16), FloatRefusedError, "vertex array", "integer array"),
        (np.full((3, 2), np.nan), FloatRefusedError, "vertex array", "an integer array"),
        (np.zeros((3, 3), dtype=int), InvalidPartError, "vertex array", "shape (n, 2)"),
        (np.zeros(6, dtype=int), InvalidPartError, "vertex array", "shape (n, 2)"),
        (np.zeros((3, 2, 1), dtype=int), InvalidPartError, "vertex array", "shape (n, 2)"),
        (np.array(5), InvalidPartError, "vertex array", "shape (n, 2)"),
        (np.zeros((3, 2), dtype=bool), NumberError, "vertex 0, x", "truth value"),
        (np.zeros((3, 2), dtype=complex), NumberError, "vertex 0, x", "not an exact number"),
        (np.array([(0, 0.5)], dtype=object), FloatRefusedError, "vertex 0, y", "from_float"),
        (np.array([("a", "b")]), NumberError, "vertex 0, x", "accepted: whole numbers"),
    ],
)
def test_arrays_of_other_kinds_are_refused(array, error, where, accepted):
    with pytest.raises(error) as caught:
        Points.from_pairs(array)
    assert type(caught.value) is error
    assert caught.value.where == where
    assert accepted in caught.value.message


def test_the_place_is_named_as_asked():
    with pytest.raises(FloatRefusedError) as caught:
        Points.from_pairs([(0, 0), (1, 0.5)], "hole 2, vertex")
    assert caught.value.where == "hole 2, vertex 1, y"
    with pytest.raises(NumberError) as caught:
        as_point((1, 2, 3), "center of mass")
    assert caught.value.where == "center of mass"


# --- asking --------------------------------------------------------------------------------------


@pytest.mark.parametrize("pairs", [[(0, 1), (2, 3), (4, 9)], [("1/2", 0), (1, 2), (3, 4)], CIRCLE])
def test_points_keep_their_place(pairs):
    points = Points.from_pairs(pairs)
    assert len(points) == len(pairs)
    assert [points.point(k) for k in range(len(points))] == list(points.pairs())
    assert points.take(np.array([2, 0])).pairs() == (points.point(2), points.point(0))
    for (x, y, w), (px, py) in zip(points.homogeneous(), points.pairs(), strict=True):
        assert w > 0
        assert (mpq(x, w * points.scale), mpq(y, w * points.scale)) == (px, py)


@pytest.mark.parametrize("pairs", [[(0, 1), (2, 3), (4, 9)], [("1/2", 0), (1, 2), (3, 4)], CIRCLE])
def test_vectors_are_differences_up_to_a_positive_factor(pairs):
    points = Points.from_pairs(pairs)
    tails, heads = np.array([0, 2, 1]), np.array([1, 0, 1])
    xs, ys = points.vectors(tails, heads)
    for x, y, tail, head in zip(xs, ys, tails, heads, strict=True):
        (ax, ay), (bx, by) = points.point(tail), points.point(head)
        assert int(x) * (by - ay) == int(y) * (bx - ax)
        assert int(x) * (bx - ax) >= 0
        assert int(y) * (by - ay) >= 0
        assert (x == 0 and y == 0) == (tail == head)


def test_floats_are_correctly_rounded():
    for pairs in ([(3, -4), (2**51 + 1, 0)], [("1/3", "0.1")], [(2**70 + 1, 10**300)], CIRCLE):
        points = Points.from_pairs(pairs)
        xs, ys = points.to_float()
        exact = points.pairs()
        assert xs.tolist() == [int(x.numerator) / int(x.denominator) for x, _ in exact]
        assert ys.tolist() == [int(y.numerator) / int(y.denominator) for _, y in exact]
        assert xs.dtype == ys.dtype == np.float64
