"""Laws of numbers and angles over real algebraic fields; values checked against mpmath."""

from __future__ import annotations

import mpmath
import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.errors import MixedFieldsError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.fields import RealField
from stochgeom.exact.forms import rational_form, sign_of_form
from stochgeom.exact.sums import AngleSum
from stochgeom.exact.vectors import AngleVector
from tests.strategies import directions, field_angles, field_numbers, fields

DIGITS = 60


def value(number):
    """Return a number by its own sympy form, which shares nothing with the balls."""
    return (
        mpmath.mpf(str(number.to_sympy().evalf(DIGITS)))
        if is_algebraic(number)
        else mpmath.mpf(int(number.numerator)) / int(number.denominator)
    )


def turns(angle):
    """Return an angle in turns by mpmath."""
    x, y = (value(part) for part in angle.direction)
    arg = mpmath.atan2(y, x) / (2 * mpmath.pi)
    t = angle.turn_part
    return mpmath.mpf(int(t.numerator)) / int(t.denominator) + (arg + 1 if arg < 0 else arg)


@st.composite
def numbers(draw, count):
    field = draw(fields)
    return [draw(field_numbers(field)) for _ in range(count)]


@st.composite
def angles(draw, count):
    field: RealField = draw(fields)
    return [draw(field_angles(field)) for _ in range(count)]


# --- numbers --------------------------------------------------------------------------------------


@given(numbers(3))
def test_numbers_are_a_ring(drawn):
    a, b, c = drawn
    assert a + b == b + a
    assert a * b == b * a
    assert (a + b) * c == a * c + b * c
    assert (a * b) * c == a * (b * c)
    assert a - b == -(b - a)
    assert a - a == 0


@given(numbers(2))
def test_numbers_are_a_field(drawn):
    a, b = drawn
    assume(b)
    assert a / b * b == a
    assert (1 / b) * b == 1


@given(numbers(2))
def test_order_is_that_of_the_values(drawn):
    a, b = drawn
    with mpmath.workdps(DIGITS):
        difference = value(a) - value(b)
        if abs(difference) > mpmath.mpf(10) ** -30:
            assert (a < b, a == b, a > b) == (difference < 0, False, difference > 0)
        else:
            assert a == b
            assert hash(a) == hash(b)


# --- angles ---------------------------------------------------------------------------------------


@given(angles(3))
def test_angles_are_an_ordered_group(drawn):
    a, b, c = drawn
    assert (a + b) + c == a + (b + c)
    assert a + b == b + a
    assert a - b == -(b - a)
    assert (a - b) + b == a
    assert (a < b) == (a + c < b + c)


@given(angles(2))
def test_order_and_equality_are_those_of_the_values(drawn):
    a, b = drawn
    with mpmath.workdps(DIGITS):
        difference = turns(a) - turns(b)
        if abs(difference) > mpmath.mpf(10) ** -30:
            assert a.compare(b) == (1 if difference > 0 else -1)
            assert a != b
        else:
            assert a == b
            assert hash(a) == hash(b)
            assert a.compare(b) == 0


@given(angles(1), st.integers(-7, 7))
def test_multiples_and_remainders(drawn, n):
    (a,) = drawn
    total = ZERO
    for _ in range(abs(n)):
        total += a
    assert a * n == (total if n >= 0 else -total)
    count, rest = divmod(a, FULL_TURN)
    assert ZERO <= rest < FULL_TURN
    assert FULL_TURN * count + rest == a


@given(angles(1), st.integers(1, 12))
def test_remainders_by_shares_of_a_turn(drawn, q):
    (a,) = drawn
    share = Angle.from_turns(mpq(1, q))
    count, rest = divmod(a, share)
    assert ZERO <= rest < share
    assert share * count + rest == a


@given(angles(1))
def test_rational_turns_are_recognised(drawn):
    (a,) = drawn
    exact = a.rational_turns
    with mpmath.workdps(DIGITS):
        scaled = turns(a) * 360 * 1008  # every turn of these fields' roots of unity, and degrees
        whole = abs(scaled - mpmath.nint(scaled)) < mpmath.mpf(10) ** -20
    assert whole == (exact is not None)
    if exact is not None:
        assert a == Angle.from_turns(exact)


@given(fields.flatmap(lambda f: st.tuples(field_angles(f), directions)))
def test_equal_angles_of_different_making_are_one_key(drawn):
    a, direction = drawn
    b = Angle(0, direction)
    there_and_back = (a + b) - b
    assert there_and_back == a
    assert len({a, there_and_back}) == 1


@given(fields.flatmap(lambda f: st.lists(field_angles(f), min_size=1, max_size=6)))
def test_vectors_do_what_their_entries_do(listed):
    vector = AngleVector.from_angles(listed)
    assert list(vector) == listed
    turned = vector.rotate(listed[0])
    assert [turned[k] for k in range(len(turned))] == [a + listed[0] for a in listed]
    for shadow, a in zip(vector.shadow.tolist(), listed, strict=True):
        with mpmath.workdps(DIGITS):
            assert abs(shadow - 2 * mpmath.pi * turns(a)) <= vector.error


@given(angles(2), st.integers(-3, 3), st.integers(-3, 3))
def test_forms_are_zero_exactly_when_they_are(drawn, p, q):
    a, b = drawn
    whole = a * p + b * q
    assert sign_of_form(0, [(p, a), (q, b)]) == whole.compare(ZERO)
    assert sign_of_form(0, [(p, a), (q, b), (-1, whole)]) == 0
    assert sign_of_form(0, [(p, a), (q, b), (-1, whole), (mpq(1, 10**40), FULL_TURN)]) == 1
    exact = rational_form(0, [(p, a), (q, b)])
    assert exact == whole.rational_turns
    assert AngleSum(0, [(p, a), (q, b)]) == AngleSum(0, [(1, whole)])


def test_two_fields_do_not_mix():
    a, b = Angle(0, ("sqrt(2)", 3)), Angle(0, ("sqrt(3)", 2))
    with pytest.raises(MixedFieldsError, match="numbers of one field"):
        a + b
    assert (
        sign_of_form(0, [(1, b), (-1, a)]) == -sign_of_form(0, [(1, a), (-1, b)]) != 0
    )  # nothing is expanded
