"""Worked cases of `sign_of_form`: classical identities, and forms that are only nearly zero."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq, mpz

from stochgeom.errors import FloatRefusedError, PrecisionLimitError
from stochgeom.exact import forms
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.forms import sign_of_form


def arctan(p, q=1):
    """Return arctan(q / p) for p > 0, or the obtuse angle for p < 0."""
    return Angle(0, (p, q))


IDENTITIES = {
    "Machin": [(4, arctan(5)), (-1, arctan(239))],
    "Euler": [(1, arctan(2)), (1, arctan(3))],
    "Euler, 5 and 2": [(5, arctan(7)), (2, arctan(79, 3))],
    "Hermann": [(2, arctan(2)), (-1, arctan(7))],
    "Hutton": [(2, arctan(3)), (1, arctan(7))],
    "Dase": [(1, arctan(2)), (1, arctan(5)), (1, arctan(8))],
    "Gauss": [(12, arctan(18)), (8, arctan(57)), (-5, arctan(239))],
    "Stoermer, three": [(6, arctan(8)), (2, arctan(57)), (1, arctan(239))],
    "Stoermer, four": [
        (44, arctan(57)),
        (7, arctan(239)),
        (-12, arctan(682)),
        (24, arctan(12943)),
    ],
    "Takano": [(12, arctan(49)), (32, arctan(57)), (-5, arctan(239)), (12, arctan(110443))],
}
"""Each sums to an eighth of a turn."""

SMALL_NUMBERS = [mpq(1, mpz(10) ** n) for n in (5, 18, 19, 38, 39, 60, 300)]


@pytest.mark.parametrize("terms", IDENTITIES.values(), ids=IDENTITIES.keys())
class TestIdentities:
    def test_sum_to_an_eighth_of_a_turn(self, terms):
        assert sign_of_form("-1/8", terms) == 0
        assert sign_of_form("1/8", [(-q, angle) for q, angle in terms]) == 0

    @pytest.mark.parametrize("factor", [7, mpq(1, 3), mpq(10**40 + 7, 3 * 10**29), "0.1234567"])
    def test_hold_times_any_rational(self, terms, factor):
        factor = mpq(factor)
        assert sign_of_form(-factor / 8, [(factor * q, angle) for q, angle in terms]) == 0

    @pytest.mark.parametrize("little", SMALL_NUMBERS, ids=lambda v: f"{len(str(v))} digits")
    def test_and_nothing_near_them(self, terms, little):
        assert sign_of_form(mpq(-1, 8) + little, terms) == 1
        assert sign_of_form(mpq(-1, 8) - little, terms) == -1

    @pytest.mark.parametrize("digits", [20, 60, 300])
    def test_nor_when_an_angle_is_a_little_off(self, terms, digits):
        little = Angle(0, (mpz(10) ** digits, 1))
        q, angle = terms[0]
        larger = [(q, angle + little), *terms[1:]]
        smaller = [(q, angle - little), *terms[1:]]
        assert sign_of_form("-1/8", larger) == 1
        assert sign_of_form("-1/8", smaller) == -1
        assert sign_of_form("-1/8", [*larger, (-q, little)]) == 0

    def test_hold_for_lifted_angles(self, terms):
        lifted = [(q, angle + 3 * FULL_TURN) for q, angle in terms]
        assert sign_of_form(mpq(-1, 8) - 3 * sum(q for q, _ in terms), lifted) == 0

    def test_hold_beside_rational_turns(self, terms):
        third = Angle.from_turns("1/3")
        moved = [(q, angle + third) for q, angle in terms]
        assert sign_of_form(mpq(-1, 8) - mpq(sum(q for q, _ in terms), 3), moved) == 0


# --- forms of few terms --------------------------------------------------------------------------


def test_rational_forms():
    assert sign_of_form(0) == 0
    assert sign_of_form("1/3", []) == 1
    assert sign_of_form(mpq(-1, 10**400)) == -1
    assert sign_of_form("-1/8", [("1/2", Angle(0, (0, 1)))]) == 0
    assert sign_of_form(0, [(1, ZERO), (0, arctan(7))]) == 0
    assert sign_of_form("-71/180", [(2, Angle.from_degrees(71))]) == 0
    assert sign_of_form(0, [("1/71", Angle.from_degrees(71)), (-1, Angle.from_degrees(1))]) == 0
    assert sign_of_form(0, [(3, HALF_TURN), ("-3/2", FULL_TURN), (mpq(1, 10**99), HALF_TURN)]) == 1


def test_one_irrational_angle_is_never_zero():
    assert sign_of_form(0, [(mpq(1, 10**99), arctan(3, 2))]) == 1
    assert sign_of_form(0, [(mpq(-1, 10**99), arctan(3, 2))]) == -1
    assert sign_of_form(1, [(-1, Angle(0, (10**400, -1)))]) == 1
    assert sign_of_form(0, [(1, Angle(-1, (10**400, -1)))]) == -1


def test_terms_of_one_direction_are_gathered():
    angle = arctan(3, 2)
    assert sign_of_form(0, [("1/3", angle), ("1/6", angle), ("-1/2", angle)]) == 0
    assert sign_of_form(1, [(1, angle - FULL_TURN), (-1, angle)]) == 0
    assert sign_of_form(0, [(1, Angle(0, (30, 20))), (-1, angle)]) == 0


def test_conjugate_and_perpendicular_directions_cancel():
    z = (123, 457)
    assert sign_of_form(-1, [(1, Angle(0, z)), (1, Angle(0, (123, -457)))]) == 0
    assert sign_of_form("-1/4", [(-1, Angle(0, z)), (1, Angle(0, (-457, 123)))]) == 0
    assert sign_of_form("-1/4", [(1, Angle(0, z)), (1, Angle(0, (457, 123)))]) == 0


def test_terms_may_come_from_an_iterator_and_coefficients_as_text():
    terms = [("4", arctan(5)), ("-1", arctan(239))]
    assert sign_of_form("-0.125", iter(terms)) == 0
    assert sign_of_form(Fraction(-1, 8), dict(terms).items()) == 0


@pytest.mark.parametrize("turns", [0.5, 0])
def test_floats_are_refused(turns):
    with pytest.raises(FloatRefusedError):
        sign_of_form(turns, [(0.5, arctan(2))])


# --- large coefficients, long directions ---------------------------------------------------------


def test_large_coefficients_raise_nothing_to_powers():
    # As a power, a 20-bit direction times 10**7 would have 186 Mbit.
    wide, narrow = arctan(10**6 + 3, 10**6 - 1), arctan(10**6 + 33, 999_979)
    n, m = 10**7, 10**7 - 1
    assert sign_of_form(0, [(n, wide), (-n, wide + narrow), (n, narrow)]) == 0
    assert sign_of_form(0, [(n, wide), (-m, wide + narrow), (n, narrow)]) == 1
    assert sign_of_form(mpq(-n, 8), [(4 * n, arctan(5)), (-n, arctan(239))]) == 0
    assert sign_of_form(mpq(-n, 8), [(4 * n + 1, arctan(5)), (-n, arctan(239))]) == 1


def test_the_cost_ratio_of_many_digits():
    c = mpq("0.1234567")
    narrow, wide = arctan(5), arctan(239)
    # (1 + c) / (4 a) against (1 + c) / (45 degrees + b): equal by Machin's formula
    terms = [(4 * (1 + c), narrow), (-(1 + c), wide)]
    assert sign_of_form(-(1 + c) / 8, terms) == 0
    assert sign_of_form(-(1 + c) / 8, [(4 * (1 + c) + mpq(1, 10**50), narrow), terms[1]]) == 1


def test_directions_of_400_digits():
    a = Angle(0, (mpz(10) ** 400 + 7, mpz(10) ** 399 + 31))
    b = Angle(0, (mpz(10) ** 400 + 9, 3 * mpz(10) ** 399 + 1))
    q = mpq(10**20 + 39, 10**19 + 51)
    assert sign_of_form(0, [(q, a + b), (-q, a), (-q, b)]) == 0
    little = Angle(0, (mpz(10) ** 1000, 1))
    assert sign_of_form(0, [(q, a + b), (-q, a + little), (-q, b)]) == -1
    assert sign_of_form(0, [(q, a + b + little), (-q, a), (-q, b)]) == 1


def test_powers_of_one_number():
    z = arctan(3, 2)
    assert sign_of_form(0, [(60, 35 * z), (-35, 60 * z)]) == 0
    assert sign_of_form(0, [(mpq(1, 96), 96 * z), (mpq(-1, 97), 97 * z)]) == 0
    assert sign_of_form(mpq(1, 10**80), [(mpq(1, 96), 96 * z), (mpq(-1, 97), 97 * z)]) == 1


def test_the_cap_has_a_name(monkeypatch):
    # Nothing in reach needs four million bits; with a lower cap 10**-200 is out of reach.
    monkeypatch.setattr("stochgeom.exact.balls.MAX_BITS", 256)
    monkeypatch.setattr(forms, "MAX_BITS", 256)
    terms = [(mpq(4), arctan(5)), (mpq(-1), arctan(239))]
    with pytest.raises(PrecisionLimitError, match="still undecided at 256 bits"):
        sign_of_form(mpq(-1, 8) + mpq(1, mpz(10) ** 200), terms)
    assert sign_of_form("-1/8", terms) == 0  # exact: no precision would show it
