"""Numbers of 400 digits, angles 2**-200 apart, and a process whose settings were tampered with."""

from __future__ import annotations

import decimal
import random
import sys
import threading
from contextlib import contextmanager
from itertools import pairwise

import flint
import gmpy2
import mpmath
import numpy as np
import pytest
from gmpy2 import mpq, mpz

from stochgeom.errors import NumberLimitError, StochgeomError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, union_measure
from stochgeom.exact.directions import just_above, nominal_angle
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.predicates import cross_sign, cross_signs
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational
from stochgeom.exact.vectors import AngleVector, argsort_arguments

DIGITS = 400
STEP = Angle(0, (2**200, 1))


def farey_neighbours(count):
    """Return directions of 400 digits and more, clockwise, neighbours with cross product 1."""
    x, y = mpz(10) ** DIGITS + 7, mpz(10) ** (DIGITS - 1) + 9
    # The least direction (u, v) with x v - y u = 1, and then (u + k x, v + k y) for k = 0, 1, ...
    u = -gmpy2.invert(y, x) % x
    v = (1 + y * u) // x
    assert x * v - y * u == 1
    return [(u + k * x, v + k * y) for k in range(count)] + [(x, y)]


# --- long numbers --------------------------------------------------------------------------------


def test_neighbouring_directions_of_400_digits_are_told_apart():
    # They differ by less than 10**-800; arguments fall towards the last one.
    directions = farey_neighbours(6)
    angles = [Angle(0, direction) for direction in directions]
    for (a, b), (p, q) in zip(pairwise(angles), pairwise(directions), strict=True):
        assert cross_sign(*q, *p) == 1
        assert b < a
        assert a != b
        assert ZERO < a - b < STEP
        assert a.degrees(700) == b.degrees(700)
        assert a.to_float() == b.to_float()
        assert sign_of_form(0, [(1, b), (-1, a)]) == -1
        assert b < nominal_angle(b, a) < a
        assert b < just_above(b, a) < a


def test_arrays_of_long_numbers():
    directions = farey_neighbours(40)
    shuffled = random.Random(1).sample(directions, len(directions))
    x, y = (np.array(column, dtype=object) for column in zip(*shuffled, strict=True))
    order, fresh = argsort_arguments(x, y)
    assert [shuffled[k] for k in order] == directions[::-1]
    assert fresh.all()
    assert (cross_signs(x[order][:-1], y[order][:-1], x[order][1:], y[order][1:]) == 1).all()
    vector = AngleVector.from_directions(x[order], y[order])
    sequence = LiftedAngles(vector, QUARTER_TURN)
    gap = vector[-1] - vector[-2]
    m = len(vector)
    # Of the gaps 1 / (|p| |q|) between neighbours the last one is the largest: shortest p and q.
    assert sequence.last_below(gap)[m - 2] == m - 2
    assert sequence.last_below(gap + STEP).tolist()[:3] == [m - 1] * 3
    assert sequence.largest_gaps(np.arange(m)).tolist() == [m - 1]
    assert sequence.widest(np.arange(m - 1), np.arange(1, m)).tolist() == [m - 2]
    assert sequence.exact_decisions > 0


def test_long_text_becomes_exact_angles():
    text = "0." + "3" * DIGITS
    angle = Angle(0, (1, text))
    assert angle < Angle(0, (3, 1))
    assert Angle(0, (3, 1)) - angle < STEP
    assert Angle.from_degrees(text) + Angle.from_degrees(text) == Angle.from_degrees(
        rational(text) * 2
    )
    assert Angle.from_degrees("9" * DIGITS + ".5").degrees(0) == "1" + "0" * DIGITS


def test_a_rational_number_of_turns_against_a_direction():
    # 300 digits of arctan(2/3), cut off and rounded up, lie to both sides of it.
    with mpmath.workdps(420):
        turns = mpmath.atan2(2, 3) / (2 * mpmath.pi)
        below = int(mpmath.floor(turns * mpmath.mpf(10) ** 400))
    angle = Angle(0, (3, 2))
    low, high = (Angle.from_turns(mpq(n, mpz(10) ** 400)) for n in (below, below + 1))
    assert low < angle < high
    assert angle - low < STEP
    assert high.compare(angle) == 1
    assert sign_of_form(0, [(3, low), (-3, angle)]) == -1
    assert low < nominal_angle(low, angle) < angle
    assert low < just_above(low, angle) < angle
    assert Arc(low, high - low).contains(angle)
    assert not Arc(low, angle - low).contains(angle)
    assert union_measure([Arc(low, angle - low), Arc(angle, high - angle)]) == high - low


# --- many small steps ----------------------------------------------------------------------------


def test_a_sum_that_comes_back_exactly():
    rng = random.Random(2)
    steps = [Angle(0, (rng.randint(-9, 9) or 1, rng.randint(-9, 9))) for _ in range(300)]
    total = sum(steps, start=ZERO)
    rng.shuffle(steps)
    for step in steps:
        total -= step
    assert total == ZERO
    assert not total


def test_a_crowd_within_2_to_the_minus_200():
    rng = random.Random(3)
    heap = [Angle(0, (3, 2)) + k * STEP for k in range(-30, 31)]
    shuffled = rng.sample(heap, len(heap))
    assert sorted(shuffled) == heap
    vector = AngleVector.from_angles(shuffled)
    order, fresh = argsort_arguments(vector.x, vector.y)
    assert [shuffled[k] for k in order] == heap
    assert fresh.all()
    sequence = LiftedAngles(AngleVector.from_angles(heap), HALF_TURN)
    assert sequence.last_below(5 * STEP).tolist()[:56] == [k + 4 for k in range(56)]
    assert sequence.last_below(6 * STEP).tolist()[:55] == [k + 5 for k in range(55)]
    steps = np.arange(60)
    assert sequence.widest(steps, steps + 1).tolist() == list(range(60))


def test_errors_about_long_numbers_stay_short_and_in_the_family():
    long = mpz(10) ** 30_000 + 1
    for attempt in (
        lambda: Angle(0, (3, 2)) * long,
        lambda: Angle(0, (long, 1)) * 1000,
        lambda: Angle(long, (3, 2)).to_float(),
        lambda: rational("7" * 10**6),
        lambda: rational("1e" + "7" * 1000),
    ):
        with pytest.raises(NumberLimitError) as caught:
            attempt()
        assert len(str(caught.value)) < 300
        assert isinstance(caught.value, StochgeomError)


# --- a hostile process ---------------------------------------------------------------------------


def answers():
    """Return answers of every module: numbers, text, signs, arrays."""
    a, b = Angle(0, (3, 2)), Angle("71/360", (5, 1))
    vector = AngleVector.from_angles([a, b, a + b, a + STEP, Angle(0, (10**30, 1))])
    sequence = LiftedAngles(AngleVector.from_angles([ZERO, a, a + STEP, b]), FULL_TURN)
    return [
        rational(decimal.Decimal("1.23456789012345678901234567890")),
        rational("1e-400") * 10**400,
        a.degrees(50),
        b.turns(40),
        (a + b).degrees(0),
        a.to_float(),
        repr(a * 50),
        a < b < a + b,
        divmod(Angle(10**20, (3, 2)), QUARTER_TURN),
        sign_of_form("-1/8", [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))]),
        sign_of_form(mpq(1, 10**60) - mpq(1, 8), [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))]),
        nominal_angle(a, b),
        just_above(a, b),
        TurnRatio(mpq("0.1234567"), a, inverse=True).decimal(30),
        float(TurnRatio(1, Angle.from_degrees(120))),
        vector.shadow.tolist(),
        vector.rotate(b).angles,
        argsort_arguments(vector.x, vector.y)[0].tolist(),
        sequence.last_below(a).tolist(),
        sequence.exact_decisions,
    ]


@contextmanager
def coarse_decimal():
    with decimal.localcontext() as context:
        context.prec, context.rounding = 2, decimal.ROUND_UP
        context.traps[decimal.Inexact] = True
        yield


@contextmanager
def coarse_mpfr():
    with gmpy2.context(precision=4, round=gmpy2.RoundUp, trap_inexact=True):
        yield


@contextmanager
def coarse_flint():
    before = flint.ctx.prec
    flint.ctx.prec = 3
    try:
        yield
        assert flint.ctx.prec == 3
    finally:
        flint.ctx.prec = before


@contextmanager
def coarse_mpmath():
    with mpmath.workdps(3):
        yield


@contextmanager
def strict_numpy():
    with np.errstate(all="raise"), np.printoptions(legacy="1.13", precision=2):
        yield


@contextmanager
def short_integers():
    before = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(640)
    try:
        assert rational("9" * 5000) == mpz(10) ** 5000 - 1
        assert rational(mpz(10) ** 5000) == mpz(10) ** 5000
        yield
    finally:
        sys.set_int_max_str_digits(before)


@pytest.mark.parametrize(
    "setting",
    [coarse_decimal, coarse_mpfr, coarse_flint, coarse_mpmath, strict_numpy, short_integers],
)
def test_settings_of_other_libraries_change_nothing(setting):
    expected = answers()
    with setting():
        found = answers()
    assert found == expected


def test_threads_get_the_same_answers():
    expected, found = answers(), []

    def work():
        found.extend(answers() for _ in range(5))

    threads = [threading.Thread(target=work) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 30
    assert all(one == expected for one in found)
