"""Laws of `Angle`: an ordered group, with one form for each element."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction
from math import gcd

import pytest
import sympy
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, QUARTER_TURN, ZERO, Angle
from tests.strategies import TINY, angles, directions, fractions, long_directions

any_angles = st.one_of(
    angles(),
    angles(),
    angles().map(lambda a: a + TINY),
    st.builds(Angle, st.integers(-3, 3), long_directions),
)
"""Angles, some of them just above another one."""

counts = st.integers(-12, 12)

periods = st.one_of(
    st.sampled_from([FULL_TURN, Angle(1), QUARTER_TURN, Angle.from_degrees(120), Angle(7, (3, 2))]),
    directions.map(lambda p: Angle(0, p)).filter(bool),
    st.builds(
        lambda p, q: Angle.from_turns(Fraction(p, q)), st.integers(1, 99), st.integers(1, 50)
    ),
)


def parts(angle):
    return angle.turn_part, angle.direction


# --- group ---------------------------------------------------------------------------------------


@given(any_angles, any_angles, any_angles)
def test_addition_is_associative(a, b, c):
    assert (a + b) + c == a + (b + c)


@given(any_angles, any_angles)
def test_addition_is_commutative(a, b):
    assert a + b == b + a


@given(any_angles)
def test_zero_is_neutral(a):
    assert a + ZERO == ZERO + a == a - ZERO == a
    assert bool(a) == (a != ZERO)


@given(any_angles, any_angles)
def test_subtraction_undoes_addition(a, b):
    assert (a + b) - b == a
    assert (a - b) + b == a
    assert a - b == a + -b == -(b - a)
    assert a - a == ZERO == a + -a
    assert (ZERO - a) == -a
    assert ZERO - -a == a


@given(any_angles, counts)
def test_a_multiple_is_a_repeated_sum(a, n):
    total = ZERO
    for _ in range(abs(n)):
        total = total + a if n > 0 else total - a
    assert n * a == a * n == total


@given(any_angles, any_angles, counts, counts)
def test_multiples_distribute(a, b, m, n):
    assert (m + n) * a == m * a + n * a
    assert (m * n) * a == m * (n * a)
    assert n * (a + b) == n * a + n * b


# --- order ---------------------------------------------------------------------------------------


@given(any_angles, any_angles)
def test_the_order_is_total(a, b):
    assert (a < b) + (a == b) + (a > b) == 1
    assert (a <= b) == (a < b or a == b)
    assert (a >= b) == (not a < b)
    assert a.compare(b) == -b.compare(a) == (a > b) - (a < b)


@given(any_angles, any_angles, any_angles)
def test_the_order_is_transitive(a, b, c):
    low, middle, high = sorted([a, b, c])
    assert low <= middle <= high
    assert low <= high


@given(any_angles, any_angles, any_angles)
def test_the_order_is_compatible_with_addition(a, b, c):
    assert (a < b) == (a + c < b + c) == (a - c < b - c)
    assert (a < b) == (-b < -a) == (b - a > ZERO)


@given(any_angles, any_angles, st.integers(1, 5))
def test_the_order_is_archimedean(a, b, n):
    assert (a < b) == (n * a < n * b)
    assert a < a + TINY < a + n * TINY + TINY


@given(any_angles, any_angles)
def test_floats_keep_the_order(a, b):
    assume(a < b)
    assert a.to_float() <= b.to_float()


# --- canonical form ------------------------------------------------------------------------------


@given(any_angles)
def test_the_parts_are_canonical(a):
    t, (x, y) = parts(a)
    assert gcd(int(x), int(y)) == 1
    if 8 % t.denominator == 0:
        assert t.denominator == 1
    else:
        assert 0 <= y < x


@given(any_angles, st.integers(-20, 20), st.integers(1, 9), st.integers(1, 9))
def test_eighths_move_between_turns_and_direction(a, eighths, p, q):
    t, (x, y) = a.turn_part, a.direction
    carry = 0
    for _ in range(eighths % 8):
        below = y < 0
        x, y = x - y, x + y
        carry += below and y >= 0  # passed the positive x axis
    moved = Angle(
        t + carry - mpq(eighths % 8, 8), (Fraction(int(x) * p, q), Fraction(int(y) * p, q))
    )
    assert parts(moved) == parts(a)


@given(any_angles, any_angles)
def test_equal_means_equal_parts(a, b):
    assert (a == b) == (parts(a) == parts(b)) == (not a - b)
    roundabout = (a - b) + b
    assert parts(roundabout) == parts(a)
    assert hash(roundabout) == hash(a)


@given(any_angles)
def test_values_survive_text_pickle_and_copy(a):
    for twin in (
        eval(repr(a)),
        pickle.loads(pickle.dumps(a)),
        copy.copy(a),
        copy.deepcopy(a),
        Angle(*parts(a)),
    ):
        assert twin == a
        assert parts(twin) == parts(a)
        assert hash(twin) == hash(a)


@given(angles(), angles())
def test_rational_turns_are_a_homomorphism(a, b):
    p, q = a.rational_turns, b.rational_turns
    if p is not None:
        assert Angle.from_turns(p) == a
    if p is not None and q is not None:
        assert (a + b).rational_turns == p + q
        assert (a < b) == (p < q)
    if (p is None) != (q is None):
        assert (a + b).rational_turns is None


@given(fractions, fractions)
def test_degrees_from_text_add_exactly(p, q):
    total = Angle.from_degrees(str(p)) + Angle.from_degrees(str(q))
    assert total == Angle.from_degrees(p + q) == Angle.from_turns((p + q) / 360)


# --- division with rest --------------------------------------------------------------------------


@given(any_angles, periods)
def test_division_with_rest(a, period):
    count, rest = divmod(a, period)
    assert isinstance(count, int)
    assert ZERO <= rest < period
    assert period * count + rest == a
    assert (a // period, a % period) == (count, rest)


@given(angles(), periods, st.integers(-50, 50))
def test_whole_periods_leave_no_rest(a, period, n):
    assert divmod(n * period, period) == (n, ZERO)
    count, rest = divmod(a, period)
    assert divmod(a + n * period, period) == (count + n, rest)
    assert (n * period - TINY) // period == n - 1


@given(angles(), st.sampled_from([FULL_TURN, QUARTER_TURN, Angle.from_turns("1/7")]))
def test_division_of_very_large_angles(a, period):
    far = a + Angle(10**60)
    count, rest = divmod(far, period)
    assert ZERO <= rest < period
    assert period * count + rest == far


@given(any_angles)
def test_reduction_leaves_one_turn(a):
    rest = a.reduced()
    assert ZERO <= rest < FULL_TURN
    assert (a - rest).rational_turns.denominator == 1
    assert rest.reduced() == rest


@given(st.one_of(directions, long_directions), directions)
def test_the_angle_between_vectors_turns_one_into_the_other(u, v):
    between = Angle.between(u, v)
    assert ZERO <= between < FULL_TURN
    assert (Angle(0, u) + between).reduced() == Angle(0, v)
    assert Angle.between(v, u) == (-between).reduced()


# --- against sympy -------------------------------------------------------------------------------

small_turns = st.builds(Fraction, st.integers(-24, 24), st.integers(1, 12))
small_angles = st.lists(st.tuples(st.sampled_from([1, 1, -1]), small_turns, directions), max_size=3)
"""Sums of a few small angles as (sign, turns, direction)."""


def ours(terms):
    total = ZERO
    for sign, t, direction in terms:
        angle = Angle(t, direction)
        total = total + angle if sign > 0 else total - angle
    return total


def theirs(terms):
    """Return the sum in turns, to 50 digits, from sympy alone."""
    value = sympy.Integer(0)
    for sign, t, (x, y) in terms:
        argument = sympy.atan2(y, x)
        if y < 0:
            argument += 2 * sympy.pi
        turns = sympy.Rational(*Fraction(t).as_integer_ratio()) + argument / (2 * sympy.pi)
        value += sign * turns
    return sympy.N(value, 50, maxn=200)


@given(small_angles, small_angles)
def test_group_and_order_agree_with_sympy(first, second):
    a, b = ours(first), ours(second)
    x, y = theirs(first), theirs(second)
    difference = x - y
    # Sums of so few and small angles are equal or differ by far more than 10**-30.
    if abs(difference) < sympy.Float("1e-30"):
        assert a == b
        assert hash(a) == hash(b)
    else:
        assert a.compare(b) == (1 if difference > 0 else -1)
    own = sympy.N(a.to_sympy() / (2 * sympy.pi), 50, maxn=200)
    assert abs(own - x) < sympy.Float("1e-40")


@given(small_angles)
def test_rational_sums_are_recognised(terms):
    a, x = ours(terms), theirs(terms)
    if a.rational_turns is not None:
        exact = sympy.Rational(int(a.rational_turns.numerator), int(a.rational_turns.denominator))
        assert abs(x - exact) < sympy.Float("1e-40")
    else:  # rational sums would have one of the given denominators, times an eighth
        scaled = x * 8 * 27720
        assert abs(scaled - sympy.floor(scaled + sympy.Rational(1, 2))) > sympy.Float("1e-25")


@pytest.mark.parametrize("n", range(1, 9))
def test_expressions_of_multiples_agree_with_sympy(n):
    a = Angle(0, (3, 2))
    difference = (n * a).to_sympy() - n * a.to_sympy()
    assert abs(sympy.N(difference, 30, maxn=100, chop=True)) < sympy.Float("1e-25")
