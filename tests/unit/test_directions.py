"""`nominal_angle`, `just_above` and their parts: inside, near the middle, simple."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq, mpz
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.errors import InvalidArcError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.directions import (
    just_above,
    nominal_angle,
    simplest_between,
    simplest_fraction,
)
from stochgeom.exact.forms import sign_of_form
from tests.strategies import TINY, angles, directions, field_angles, fields, long_directions

widths = st.one_of(
    directions.map(lambda p: Angle(0, p)),
    long_directions.map(lambda p: Angle(0, p)),
    st.integers(1, 60).flatmap(
        lambda q: st.integers(1, q).map(lambda p: Angle.from_turns(mpq(p, q)))
    ),
    st.sampled_from([TINY, Angle.from_turns(Fraction(1, 3 * 2**200)), FULL_TURN, FULL_TURN - TINY]),
).filter(bool)
"""Widths in (0, 360] degrees, of rational and of irrational numbers of turns."""

rational_directions = st.one_of(directions, long_directions).map(lambda p: Angle(0, p))


def deg(value):
    return Angle.from_degrees(value)


def check_near_the_middle(low, high):
    angle = nominal_angle(low, high)
    assert low < angle < high
    # |angle - (low + high) / 2| is at most an eighth of the width, or a 2**-10th more than that.
    eighth = (1 + mpq(1, 2**10)) / 8
    for side in (1, -1):
        off = [(side, angle), (-mpq(side, 2), low), (-mpq(side, 2), high)]
        assert sign_of_form(0, [*off, (eighth, low), (-eighth, high)]) <= 0
    return angle


def check_just_above(low, high):
    angle = just_above(low, high)
    assert low < angle < high
    # angle - low < (high - low) / 2**20
    assert sign_of_form(0, [(2**20, angle), (1 - 2**20, low), (-1, high)]) < 0
    return angle


# --- over a field --------------------------------------------------------------------------------


@settings(max_examples=max(20, settings().max_examples // 10))
@given(fields.flatmap(lambda f: st.tuples(field_angles(f), field_angles(f))))
def test_between_directions_over_a_field_it_is_a_rational_direction(ends):
    low, high = min(ends), max(ends)
    assume(low < high <= low + FULL_TURN)
    angle = nominal_angle(low, high)
    assert low < angle < high
    assert low < just_above(low, high) < angle
    if any(is_algebraic(end.direction[0]) for end in ends):
        assert angle.turn_part.denominator == 1
        assert not is_algebraic(angle.direction[0])


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (ZERO, Angle(0, ("sqrt(6)", 1)), Angle(0, (5, 1))),
        (Angle(-1), Angle(-1, ("sqrt(6)", 1)), Angle(-1, (5, 1))),
        (Angle(0, ("sqrt(6)", 1)), Angle.from_degrees(160), QUARTER_TURN),
        (Angle(0, ("sqrt(6)", 1)), Angle(1, ("sqrt(6)", 1)), HALF_TURN),
        (Angle(0, ("-sqrt(6)", -1)), Angle(0, (-1, -1)), Angle(0, (-3, -2))),
    ],
)
def test_the_simplest_one(low, high, expected):
    assert nominal_angle(low, high) == expected


# --- the law -------------------------------------------------------------------------------------


@given(angles(), widths)
def test_a_nominal_angle_lies_near_the_middle(low, width):
    angle = check_near_the_middle(low, low + width)
    assert nominal_angle(low, low + width) == angle


@given(angles(), widths)
def test_just_above_is_just_above(low, width):
    angle = check_just_above(low, low + width)
    assert just_above(low, low + width) == angle


@given(angles(rational_turns=False), directions, st.integers(-3, 3), st.integers(0, 3))
def test_turning_by_quarters_turns_the_answer(low, direction, turns, quarters):
    width = Angle(0, direction)
    assume(width)
    turn = turns * FULL_TURN + quarters * QUARTER_TURN
    assert nominal_angle(low + turn, low + turn + width) == nominal_angle(low, low + width) + turn


def test_every_width_of_small_numbers():
    grid = [Angle(0, (x, y)) for x in range(-3, 4) for y in range(-3, 4) if x or y]
    for width in {angle for angle in grid if angle}:
        for low in grid[::3]:
            check_near_the_middle(low, low + width)


# --- by hand -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (Angle(0, (3, 1)), Angle(0, (1, 3)), Angle(0, (1, 1))),
        (Angle(0, (1, 0)), Angle(0, (0, 1)), Angle(0, (1, 1))),
        (Angle(-1, (3, -1)), Angle(0, (3, 1)), ZERO),
        (Angle(0, (1, 5)), Angle(0, (-1, 5)), QUARTER_TURN),
        (ZERO, FULL_TURN, HALF_TURN),
        (Angle(-1), ZERO, -HALF_TURN),
        (deg(40), deg(47), deg("43.2")),
        (deg(0), deg(71), deg(40)),
        (deg(0), deg(1), deg("0.625")),
    ],
)
def test_the_simplest_angle_is_taken(low, high, expected):
    assert check_near_the_middle(low, high) == expected


def test_intervals_of_almost_nothing():
    low = Angle(0, (10**9, 10**9 - 7))
    for width in (TINY, Angle(0, (mpz(10) ** 300, 1)), Angle.from_turns(mpq(1, mpz(3) ** 200))):
        check_near_the_middle(low, low + width)
        check_near_the_middle(low - width, low)
        check_near_the_middle(low - width, low + width)
        check_just_above(low, low + width)
    angle = check_near_the_middle(low, low + TINY)
    assert 200 < max(map(abs, angle.direction)).bit_length() * 2 < 500  # about 1 / sqrt(width)


@pytest.mark.parametrize("start", [ZERO, deg(71), Angle(2, (-3, 2)), Angle("1/16"), -FULL_TURN])
def test_wide_intervals_and_those_across_quarter_turns(start):
    for width in (FULL_TURN, FULL_TURN - TINY, HALF_TURN, HALF_TURN + TINY, deg(200), deg(359)):
        check_near_the_middle(start, start + width)
        check_just_above(start, start + width)
    for quarter in range(-4, 5):
        middle = quarter * QUARTER_TURN
        check_near_the_middle(middle - deg(30), middle + deg(30))
        assert check_near_the_middle(middle - TINY, middle + TINY) == middle


def test_from_an_exact_dyadic_number_of_turns():
    # The enclosure of such a start has no radius, so that the start itself is the simplest choice.
    for low in (ZERO, FULL_TURN, Angle("1/16"), Angle("-3/32"), QUARTER_TURN):
        check_just_above(low, low + deg(71))


def test_rational_ends_a_rational_direction_apart():
    low = deg(71)
    for width in (Angle(0, (3, 2)), Angle(0, (-3, 2)), Angle(0, (1, -9)), TINY, FULL_TURN):
        check_near_the_middle(low, low + width)
        check_just_above(low, low + width)
        check_near_the_middle(low + Angle(0, (5, 4)), low + Angle(0, (5, 4)) + width)


@pytest.mark.parametrize("question", [nominal_angle, just_above])
@pytest.mark.parametrize("width", [ZERO, -TINY, deg(-71), FULL_TURN + TINY, Angle(3), deg(400)])
def test_empty_and_too_wide_intervals_are_refused(question, width):
    for low in (ZERO, Angle(0, (3, 2)), deg(71)):
        with pytest.raises(InvalidArcError, match="accepted: low < high, at most 360° apart"):
            question(low, low + width)


# --- simplest directions and fractions -----------------------------------------------------------


def simplest_slowly(low, high):
    denominator = 1
    while True:
        numerator = -(-low.numerator * denominator // low.denominator)  # the least not below
        if numerator <= high * denominator:
            return Fraction(numerator, denominator)
        denominator += 1


@given(
    st.fractions(0, 5, max_denominator=400),
    st.one_of(st.fractions(0, 2, max_denominator=50), st.fractions(0, "1/99", max_denominator=999)),
)
def test_the_simplest_fraction_by_trying_all(low, gap):
    found = simplest_fraction(mpq(low), mpq(low + gap))
    assert found == simplest_slowly(low, low + gap)


def test_the_simplest_fraction_of_one_point_or_nearly():
    assert simplest_fraction(mpq(355, 113), mpq(355, 113)) == mpq(355, 113)
    assert simplest_fraction(mpq(0), mpq(1, 7)) == 0
    assert simplest_fraction(mpq(314, 100), mpq(315, 100)) == mpq(22, 7)
    assert simplest_fraction(mpq(0), mpq(0)) == 0


def simplest_direction_slowly(first, last):
    """Return the simplest direction by trying quarter turns, then slopes by denominator."""
    quarters = first // QUARTER_TURN
    for k in (quarters, quarters + 1):
        if first <= k * QUARTER_TURN <= last:
            return k * QUARTER_TURN
    q = 1
    while True:
        for p in range(1, 40 * q):
            angle = quarters * QUARTER_TURN + Angle(0, (q, p))
            if first <= angle <= last:
                return angle
        q += 1


@given(directions, directions, st.integers(-2, 2))
def test_the_simplest_direction_by_trying_all(u, v, turns):
    first, last = sorted([Angle(turns, u), Angle(turns, v)])
    assert simplest_between(first, last) == simplest_direction_slowly(first, last)


@given(rational_directions, rational_directions)
def test_the_simplest_direction_lies_inside(a, b):
    first, last = sorted([a, b])
    found = simplest_between(first, last)
    assert first <= found <= last
    bits = max(map(abs, found.direction)).bit_length()
    assert bits <= max(*map(abs, first.direction), *map(abs, last.direction)).bit_length()
    assert simplest_between(first, first) == first


def test_between_nothing():
    with pytest.raises(InvalidArcError, match="accepted: first <= last"):
        simplest_between(QUARTER_TURN, ZERO)
