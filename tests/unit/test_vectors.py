"""`AngleVector` entry by entry against `Angle`, and its edges: overflow, shadows, sorting."""

from __future__ import annotations

from functools import cmp_to_key
from itertools import pairwise

import numpy as np
import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import FloatRefusedError
from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.predicates import compare_arguments
from stochgeom.exact.vectors import AngleVector, argsort_arguments
from tests.strategies import TINY, angles, directions, int64s, long_directions

any_angles = st.one_of(
    angles(),
    angles(),
    angles().map(lambda a: a + TINY),
    st.builds(Angle, st.integers(-3, 3), long_directions),
)
lists = st.lists(any_angles, max_size=8)
machine_directions = st.tuples(int64s, int64s).filter(lambda p: p != (0, 0))
EDGE = 2**53 - 1


def vector_of(pairs, dtype=np.int64, turns=None):
    """Return a vector over directions as given, not reduced."""
    x, y = (np.array(column, dtype=dtype) for column in zip(*pairs, strict=True))
    zeros = np.zeros(len(pairs), dtype=np.int64)
    return AngleVector(zeros if turns is None else np.array(turns, dtype=np.int64), x, y)


# --- a sequence ----------------------------------------------------------------------------------


@given(lists)
def test_a_vector_is_the_sequence_of_its_angles(some):
    vector = AngleVector.from_angles(some)
    assert len(vector) == len(some)
    assert list(vector) == some
    assert vector.angles == tuple(some)
    for k in range(-len(some), len(some)):
        assert vector[k] == some[k] == vector[np.int64(k)]
    assert list(vector[1:]) == some[1:]
    assert list(vector[::-2]) == some[::-2]
    assert list(eval(repr(vector))) == some


@given(lists)
def test_entries_made_anew_are_the_angles_given(some):
    # `take` drops the angles kept since `from_angles`: these are made from the arrays.
    vector = AngleVector.from_angles(some).take(slice(None))
    assert [vector[k] for k in range(len(some))] == some
    mask = np.array([bool(angle) for angle in some], dtype=np.bool_)
    assert list(vector.take(mask)) == [angle for angle in some if angle]
    order = np.argsort([angle.to_float() for angle in some])
    assert list(vector.take(order)) == [some[k] for k in order]


@given(st.lists(st.lists(any_angles, max_size=3), min_size=1, max_size=4))
def test_concatenation(several):
    joined = AngleVector.concatenate([AngleVector.from_angles(some) for some in several])
    assert list(joined) == [angle for some in several for angle in some]


def test_machine_integers_where_they_suffice():
    small = AngleVector.from_angles([Angle(2, (3, 2)), Angle(0, (EDGE, 1))])
    assert {small.x.dtype, small.y.dtype, small.turn_parts.dtype} == {np.dtype(np.int64)}
    large = AngleVector.from_angles([Angle(2, (3, 2)), Angle("1/3", (EDGE + 1, 1))])
    assert large.x.dtype == large.turn_parts.dtype == object
    assert list(AngleVector.concatenate([small, large])) == [*small, *large]


def test_an_index_out_of_range():
    vector = AngleVector.from_angles([ZERO, FULL_TURN])
    for one in (vector, vector.take(slice(None))):
        for k in (2, -3):
            with pytest.raises(IndexError):
                one[k]


def test_empty_vectors():
    empty = AngleVector.from_angles([])
    assert list(empty) == list(empty.rotate(EIGHTH_TURN)) == []
    assert empty.shadow.tolist() == empty.to_float().tolist() == []
    assert empty.error < 1e-12
    order, fresh = argsort_arguments(empty.x, empty.y)
    assert order.tolist() == fresh.tolist() == []


@pytest.mark.parametrize("place", [0, 1, 2])
def test_float_arrays_are_refused(place):
    arrays = [np.array([0, 1]), np.array([3, 1]), np.array([2, 0])]
    arrays[place] = arrays[place].astype(np.float64)
    with pytest.raises(FloatRefusedError, match="accepted: arrays of integers"):
        AngleVector(*arrays)


@given(lists, lists)
def test_equality_of_vectors(first, second):
    a, b = AngleVector.from_angles(first), AngleVector.from_angles(second)
    assert a.equals(b) == (first == second)
    scaled = AngleVector(a.turn_parts, 3 * a.x, 3 * a.y)
    assert a.equals(scaled)
    assert scaled.equals(a.take(slice(None)))
    if first:
        assert not a.equals(a.take(slice(1, None)))


# --- rotation ------------------------------------------------------------------------------------


@given(lists, any_angles, any_angles)
def test_rotation_adds_to_every_entry(some, a, b):
    vector = AngleVector.from_angles(some)
    assert list(vector.rotate(a)) == [entry + a for entry in some]
    assert list(vector.rotate(a).rotate(b)) == [entry + a + b for entry in some]
    assert list(vector.rotate(a).rotate(-a)) == some


@given(st.lists(machine_directions, min_size=1, max_size=6), any_angles, st.integers(-9, 9))
def test_rotation_of_machine_integers(pairs, a, k):
    vector, exact = vector_of(pairs), [Angle(0, pair) for pair in pairs]
    for step in (a, k * EIGHTH_TURN, Angle(0, (-1, 1)), Angle(0, (0, -1))):
        vector, exact = vector.rotate(step), [entry + step for entry in exact]
        assert [vector[j] for j in range(len(pairs))] == exact


@pytest.mark.parametrize("pair", [(EDGE, EDGE), (EDGE, -EDGE), (-EDGE, EDGE - 1), (EDGE, 0)])
def test_eighths_at_the_edge_of_float64(pair):
    vector, exact = vector_of([pair]), Angle(0, pair)
    for _ in range(17):
        vector, exact = vector.rotate(EIGHTH_TURN), exact + EIGHTH_TURN
        assert vector[0] == exact


def test_whole_turns_do_not_overflow():
    for turns in (2**63 - 1, -(2**63), 2**62):
        vector = vector_of([(3, 2)], turns=[turns])
        for _ in range(3):
            vector = vector.rotate(Angle(2**52 + 1))
        assert vector[0] == Angle(turns + 3 * (2**52 + 1), (3, 2))
        assert vector_of([(3, -2)], turns=[turns]).rotate(HALF)[0] == Angle(turns, (3, -2)) + HALF
    narrow = AngleVector(*(np.array([k], dtype=np.int32) for k in (2**31 - 1, 3, 2)))
    assert narrow.rotate(Angle(2**40))[0] == Angle(2**40 + 2**31 - 1, (3, 2))


HALF = Angle(0, (-1, 0))


def test_rotation_by_rational_turns():
    vector = vector_of([(3, 2), (1, 0), (0, -5)]).rotate(Angle.from_degrees(71))
    assert vector[1] == Angle.from_degrees(71)
    assert vector[2] == Angle.from_degrees(341)
    again = vector.rotate(Angle.from_degrees(19))
    assert again[1] == QUARTER_TURN
    assert again[1].turn_part == 0
    assert again[0] == Angle(0, (-2, 3))


# --- shadows -------------------------------------------------------------------------------------


def test_shadows_by_hand():
    pairs = [(1, 0), (1, 1), (0, 1), (-1, 0), (0, -1), (1, -1)]
    expected = np.pi * np.array([0, 0.25, 0.5, 1, 1.5, 1.75])
    for dtype in (np.int64, object):
        vector = vector_of(pairs, dtype)
        assert np.abs(vector.shadow - expected).max() <= vector.error
        assert vector.error < 1e-13


def test_a_shadow_can_not_be_spoilt():
    vector = vector_of([(1, 1), (0, 1)])
    copy = vector.to_float()
    copy[:] = 0
    assert vector.shadow.all()


def test_the_error_grows_with_the_turns():
    one = AngleVector.from_angles([Angle(1, (3, 2))])
    for turns in (10**6, -(10**6), mpq(10**6) + mpq(1, 3)):
        far = AngleVector.from_angles([Angle(turns, (3, 2)), ZERO])
        assert 10**5 * one.error < far.error < 10**6 * one.error


def test_directions_of_400_digits_have_shadows():
    big = mpz(10) ** 400
    pairs = [(big, big), (-big, 1), (-big, -1), (big, -1), (1, -big), (-1, big)]
    vector = vector_of(pairs, dtype=object)
    expected = np.pi * np.array([0.25, 1, 1, 2, 1.5, 0.5])
    assert np.abs(vector.shadow - expected).max() <= vector.error


# --- sorting by argument -------------------------------------------------------------------------


def sort_slowly(pairs):
    def compare(i, j):
        return compare_arguments(*pairs[i], *pairs[j]) or i - j

    return sorted(range(len(pairs)), key=cmp_to_key(compare))


def check_sorting(pairs, dtype):
    x, y = (np.array(column, dtype=dtype) for column in zip(*pairs, strict=True))
    order, fresh = argsort_arguments(x, y)
    expected = sort_slowly(pairs)
    assert order.tolist() == expected
    differs = [compare_arguments(*pairs[i], *pairs[j]) != 0 for i, j in pairwise(expected)]
    assert fresh.tolist() == [True, *differs]


@given(st.lists(directions, min_size=1, max_size=12))
def test_sorting_of_few_directions(pairs):
    check_sorting(pairs, np.int64)


@given(st.lists(machine_directions, min_size=1, max_size=10))
def test_sorting_of_machine_integers(pairs):
    check_sorting(pairs, np.int64)


@given(
    st.lists(st.one_of(directions, long_directions), min_size=1, max_size=5),
    st.lists(st.tuples(st.integers(0, 4), st.integers(-2, 2), st.integers(1, 3)), max_size=10),
)
def test_sorting_of_directions_that_differ_by_very_little(pairs, moves):
    many = list(pairs)
    for place, step, length in moves:
        x, y = pairs[place % len(pairs)]
        turned = (2**200 * x - step * y, 2**200 * y + step * x)  # by about step * 2**-200
        many.append((length * turned[0], length * turned[1]))
    check_sorting([(mpz(x), mpz(y)) for x, y in many], object)


@given(
    st.tuples(st.integers(-(2**30), 2**30), st.integers(1, 2**30)),
    st.lists(st.integers(1, 2**32), min_size=2, max_size=8),
)
def test_equal_directions_stay_in_order(pair, lengths):
    # Above 2**53 the components are rounded, so that equal directions cast different shadows.
    check_sorting([(pair[0] * length, pair[1] * length) for length in lengths], np.int64)


def test_sorting_near_the_positive_x_axis():
    big = mpz(10) ** 300
    check_sorting([(big, mpz(-1)), (big, mpz(1)), (big, mpz(0)), (big, mpz(-2))], object)
    check_sorting([(2**62, -1), (2**62, 1), (2**62, 0), (2**62, -2)], np.int64)
    check_sorting([(-(2**62), -1), (-(2**62), 1), (-(2**62), 0), (-1, 0)], np.int64)
