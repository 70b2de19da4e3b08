"""The exact core by second roads: MPFR with directed rounding, mpmath, Arb, continued fractions."""

from __future__ import annotations

import re
from fractions import Fraction
from math import floor

import flint
import gmpy2
import mpmath
import numpy as np
import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.vectors import AngleVector
from tests.strategies import (
    TINY,
    angles,
    directions,
    int64s,
    long_directions,
    long_fractions,
    signed,
)

any_angles = st.one_of(
    angles(),
    angles().map(lambda a: a + TINY),
    angles().map(lambda a: -a),
    st.builds(Angle, st.integers(-3, 3), long_directions),
)


# --- MPFR, rounded down and rounded up -----------------------------------------------------------


def rounding(direction, precision):
    return gmpy2.context(precision=precision, round=direction)


def turns_between(angle, precision):
    """Return two MPFR numbers that the angle lies between, in turns."""
    down = rounding(gmpy2.RoundDown, precision)
    up = rounding(gmpy2.RoundUp, precision)
    with down:
        least_pi = gmpy2.const_pi()
    with up:
        most_pi = gmpy2.const_pi()
    assert least_pi < most_pi
    x, y = angle.direction
    t = angle.turn_part
    ends = []
    for ctx, positive, negative in ((down, most_pi, least_pi), (up, least_pi, most_pi)):
        argument = ctx.atan2(y, x)  # the components are exact at this precision
        share = ctx.div(argument, positive if argument > 0 else negative)
        share = ctx.div(share, 2)
        if y < 0:
            share = ctx.add(share, 1)
        ends.append(ctx.add(share, ctx.div(t.numerator, t.denominator)))
    return ends


def decimal_by_mpfr(angle, unit, digits):
    """Return the integer nearest to angle * unit * 10**digits, from both roundings."""
    precision = 200 + 4 * digits + sum(abs(v).bit_length() for v in angle.direction)
    while True:
        low, high = turns_between(angle, precision)
        # Exact from here on: an MPFR number is a rational one.
        scale = unit * 10**digits
        first, last = (
            floor(Fraction(*v.as_integer_ratio()) * scale + Fraction(1, 2)) for v in (low, high)
        )
        if first == last:
            return first
        precision *= 2


def check_decimal(text, number, digits):
    assert re.fullmatch(r"-?[0-9]+" + (rf"\.[0-9]{{{digits}}}" if digits else ""), text)
    assert Fraction(text) == Fraction(number, 10**digits)
    assert not re.fullmatch(r"-[0.]*", text)


@given(any_angles, st.integers(0, 60))
def test_degrees_and_turns_are_correctly_rounded(angle, digits):
    exact = angle.rational_turns
    for unit, text in ((360, angle.degrees(digits)), (1, angle.turns(digits))):
        if exact is None:
            number = decimal_by_mpfr(angle, unit, digits)
        else:  # Python's own rounding of fractions, half to even
            number = round(
                Fraction(int(exact.numerator), int(exact.denominator)) * unit * 10**digits
            )
        check_decimal(text, number, digits)


@pytest.mark.parametrize("digits", [0, 1, 17, 50, 99, 100, 101, 300])
def test_degrees_next_to_a_tie(digits):
    # The middle between two decimals, and 10**-400 turns to either side of it.
    for whole in (22, 23, 10**40 + 1):
        tie = Angle.from_degrees(mpq(2 * whole + 1, 2 * mpz(10) ** digits))
        little = Angle(0, (mpz(10) ** 400, 1))
        check_decimal((tie - little).degrees(digits), whole, digits)
        check_decimal(tie.degrees(digits), whole + whole % 2, digits)
        check_decimal((tie + little).degrees(digits), whole + 1, digits)


# --- floats --------------------------------------------------------------------------------------


def radians(angle, digits=120):
    """Return the angle in radians by mpmath."""
    with mpmath.workdps(digits):
        (x, y), t = angle.direction, angle.turn_part
        argument = mpmath.atan2(int(y), int(x))
        if y < 0:
            argument += 2 * mpmath.pi
        return argument + 2 * mpmath.pi * int(t.numerator) / int(t.denominator)


@given(any_angles)
def test_radians_are_within_one_unit_in_the_last_place(angle):
    found, value = angle.to_float(), radians(angle)
    with mpmath.workdps(120):
        assert abs(mpmath.mpf(found) - value) <= np.spacing(abs(found))


@pytest.mark.parametrize("digits", range(4, 60, 3))
def test_radians_of_a_difference_of_almost_equal_angles(digits):
    # A rational number of turns beside a direction: what is left after cancellation is 10**-digits.
    angle = Angle(0, (3, 2))
    near = Angle.from_degrees(angle.degrees(digits))
    small = near - angle if near > angle else angle - near
    found = small.to_float()
    with mpmath.workdps(200):
        value = abs(radians(near, 200) - radians(angle, 200))
        assert abs(mpmath.mpf(found) - value) <= np.spacing(found)
        ratio = float(TurnRatio(7, small))
        assert abs(mpmath.mpf(ratio) - 7 * value / (2 * mpmath.pi)) <= np.spacing(ratio)
    assert 0 < found < 10.0**-digits


POINTS = 5_000


def many_points():
    """Return directions of float64 integers: random, near axes, near diagonals, of all sizes."""
    rng = np.random.default_rng(20_240_229)
    limit = 2**53
    spread = rng.integers(-limit + 1, limit, (2, POINTS))
    sizes = rng.integers(0, 53, (2, POINTS))
    uneven = spread >> sizes
    near = rng.integers(-99, 100, POINTS)
    base = rng.integers(1, limit - 100, POINTS)
    diagonal = np.array([base, base + near]) * rng.choice([-1, 1], (2, POINTS))
    axis = np.array([base, near])[:, :]
    both = np.concatenate([spread, uneven, diagonal, axis, axis[::-1]], axis=1)
    return both[:, (both != 0).any(axis=0)]


def test_arctan2_of_numpy_is_within_4_units_in_the_last_place():
    # The bound that the shadows rest on; numpy's arctan2 differs between machines.
    x, y = many_points()
    found = np.arctan2(y.astype(np.float64), x.astype(np.float64))
    units = np.spacing(np.abs(found))
    worst = 0.0
    with working_precision(160):
        for a, b, value, unit in zip(
            x.tolist(), y.tolist(), found.tolist(), units.tolist(), strict=True
        ):
            off = abs(flint.arb(value) - flint.arb.atan2(flint.arb(b), flint.arb(a))) / unit
            worst = max(worst, float(off.upper()))
    assert len(found) > 20_000
    assert worst < 4


# --- shadows -------------------------------------------------------------------------------------

far_turns = st.one_of(st.just(0), st.integers(-3, 3), st.integers(-(10**6), 10**6), long_fractions)
all_directions = st.one_of(
    directions,
    st.tuples(int64s, int64s).filter(lambda p: p != (0, 0)),
    long_directions,
    st.tuples(signed(10**399, 10**400), st.one_of(signed(0, 9), signed(10**300, 10**400))),
)


def check_shadow(vector, exact):
    bound = flint.arb(vector.error)
    with working_precision(300):
        for angle, value in zip(exact, vector.shadow.tolist(), strict=True):
            truth = angle.ball() * 2 * flint.arb.pi()
            assert abs(truth - flint.arb(value)) < bound


@given(st.lists(st.builds(Angle, far_turns, all_directions), min_size=1, max_size=6))
def test_shadows_are_within_their_bound(some):
    vector = AngleVector.from_angles(some)
    check_shadow(vector, some)
    check_shadow(vector.rotate(TINY), [angle + TINY for angle in some])
    one = AngleVector.from_angles(some[:1])
    check_shadow(one, some[:1])
    assert one.error <= (2 + abs(float(some[0].turn_part))) * 2.0**-46


@given(
    st.lists(st.tuples(int64s, int64s).filter(any), min_size=1, max_size=6),
    st.lists(st.integers(-(10**6), 10**6), min_size=6, max_size=6),
)
def test_shadows_of_machine_integers_not_reduced(pairs, turns):
    x, y = np.array(pairs, dtype=np.int64).T
    vector = AngleVector(np.array(turns[: len(pairs)], dtype=np.int64), x, y)
    check_shadow(vector, [Angle(t, p) for t, p in zip(turns, pairs, strict=False)])


def test_shadows_of_many_points():
    x, y = (column[::20] for column in many_points())
    vector = AngleVector.from_directions(x, y)
    check_shadow(vector, list(vector))


# --- linear forms --------------------------------------------------------------------------------

terms = st.lists(st.tuples(long_fractions, any_angles), max_size=4)


@given(long_fractions, terms)
def test_signs_of_forms_by_mpmath(turns, some):
    with mpmath.workdps(120):
        value = 2 * mpmath.pi * turns.numerator / turns.denominator
        for q, angle in some:
            value += radians(angle) * q.numerator / q.denominator
        sign = 0 if abs(value) < mpmath.mpf(10) ** -100 else int(mpmath.sign(value))
    assert sign_of_form(turns, some) == sign


@given(long_fractions, terms, long_fractions.map(abs).filter(bool))
def test_signs_of_forms_scale_and_reflect(turns, some, factor):
    sign = sign_of_form(turns, some)
    assert sign_of_form(-turns, [(-q, angle) for q, angle in some]) == -sign
    assert sign_of_form(factor * turns, [(factor * q, angle) for q, angle in some]) == sign
    assert sign_of_form(turns, some[::-1]) == sign
    assert sign_of_form(turns - 1, [*some, (1, FULL_TURN)]) == sign
    assert sign_of_form(turns, [*some, *((-q, angle) for q, angle in some)]) == (turns > 0) - (
        turns < 0
    )


def gaussian_power_product(factors, exponents):
    """Return the product of the factors to their powers, by Python's integers alone."""
    re, im = 1, 0
    for (x, y), n in zip(factors, exponents, strict=True):
        for _ in range(abs(n)):
            re, im = (
                (re * x - im * y, re * y + im * x) if n > 0 else (re * x + im * y, im * x - re * y)
            )
    return re, im


@st.composite
def zero_forms(draw):
    """Draw (turns, terms) that cancel because directions are products of one another.

    For each product w of powers of given z_k: q (arg w + 2 pi lift - sum n_k arg z_k) = 0, with
    the lift found by mpmath. Rational turns are added to the angles and taken off again.
    """
    factors = draw(st.lists(directions, min_size=1, max_size=4))
    turns, some = Fraction(0), []
    for _ in range(draw(st.integers(1, 3))):
        exponents = [draw(st.integers(-6, 6)) for _ in factors]
        q = draw(long_fractions)
        product = gaussian_power_product(factors, exponents)
        with mpmath.workdps(60):
            total = mpmath.fsum(
                n * radians(Angle(0, z)) for n, z in zip(exponents, factors, strict=True)
            )
            lift = int(mpmath.nint((total - radians(Angle(0, product))) / (2 * mpmath.pi)))
        t = draw(long_fractions)
        turns += q * (lift - t)
        some.append((q, Angle(0, product) + Angle(t)))
        some += [(-q * n, Angle(0, z)) for n, z in zip(exponents, factors, strict=True)]
    return turns, draw(st.permutations(some))


@given(zero_forms())
def test_forms_that_are_zero_by_construction(form):
    turns, some = form
    assert sign_of_form(turns, some) == 0


@given(zero_forms(), st.sampled_from([20, 60, 300]), st.sampled_from([1, -1]))
def test_forms_that_are_nearly_zero(form, digits, sign):
    turns, some = form
    assert sign_of_form(turns + Fraction(sign, 10**digits), some) == sign
    little = Angle(0, (10**digits, 1))
    assert sign_of_form(turns, [*some, (sign, little)]) == sign
    q, angle = some[0]
    if q:
        expected = sign if q > 0 else -sign
        assert sign_of_form(turns, [(q, angle + sign * little), *some[1:]]) == expected


@pytest.mark.parametrize(
    ("u", "v"), [((3, 2), (5, 1)), ((1, 9), (-7, 4)), ((10**6 + 3, 10**6 - 1), (-1, -(10**5)))]
)
def test_convergents_change_sides(u, v):
    """The convergents p / q of a / b lie on alternate sides: q a - p b > 0 for every other one."""
    a, b = Angle(0, u), Angle(1, v)
    with mpmath.workdps(400):
        rest = radians(a, 400) / radians(b, 400)
        p0, q0, p1, q1 = 0, 1, 1, 0
        for k in range(120):
            whole = int(mpmath.floor(rest))
            p0, q0, p1, q1 = p1, q1, whole * p1 + p0, whole * q1 + q0
            rest = 1 / (rest - whole)
            assert sign_of_form(0, [(q1, a), (-p1, b)]) == (1 if k % 2 == 0 else -1)
    assert q1 > 10**40  # so q a - p b is below 10**-40, and both products are above 10**40
