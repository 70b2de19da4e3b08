"""`TurnRatio`: exact costs and probabilities, and their comparison."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import flint
import pytest
import sympy
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.errors import FloatRefusedError, InputError, NumberError
from stochgeom.exact.angles import FULL_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.ratios import TurnRatio
from tests.strategies import TINY, angles, fractions

A, B, EIGHTH = Angle(0, (5, 1)), Angle(0, (239, 1)), Angle(0, (1, 1))

positive_angles = angles().map(lambda a: a if a > ZERO else FULL_TURN - a)
coefficients = st.one_of(st.integers(0, 6), fractions.map(abs)).map(mpq)
ratios = st.builds(TurnRatio, coefficients, positive_angles, st.booleans())


def cost(steps, ratio, width):
    """Return the expected cost (i + c) 2 pi / h."""
    return TurnRatio(steps + mpq(ratio), width, inverse=True)


# --- worked cases --------------------------------------------------------------------------------


def test_rational_values():
    assert TurnRatio(mpq(2), QUARTER_TURN).rational == mpq(1, 2)
    assert TurnRatio(mpq(2), QUARTER_TURN, inverse=True).rational == 8
    assert TurnRatio(mpq(0), A).rational == 0
    assert TurnRatio(mpq(1), A).rational is None
    assert TurnRatio(mpq(1), 4 * A - B).rational == mpq(1, 8)


def test_decimals():
    assert TurnRatio(mpq(1), Angle(0, (3, 2))).decimal(4) == "0.0936"
    assert TurnRatio(mpq(2), Angle(0, (3, 2)), inverse=True).decimal(6) == "21.371284"
    assert TurnRatio(mpq(1, 3), QUARTER_TURN).decimal(3) == "0.083"
    assert TurnRatio(mpq(5), Angle.from_degrees(360)).decimal(0) == "5"
    assert TurnRatio(mpq(1), EIGHTH).decimal(2) == "0.12"  # a tie, to even
    assert str(TurnRatio(mpq(1), A)) == "0.0314"
    assert TurnRatio(mpq(0), A).decimal(2) == "0.00"


def test_sympy():
    ratio = TurnRatio(mpq(2), Angle(0, (3, 2)), inverse=True)
    assert ratio.to_sympy() == 4 * sympy.pi / sympy.atan(sympy.Rational(2, 3))
    assert TurnRatio(mpq(3, 7), QUARTER_TURN).to_sympy() == sympy.Rational(3, 28)


def test_floats():
    assert float(TurnRatio(mpq(1), QUARTER_TURN)) == 0.25
    for n in (3, 7, 49, 360):
        third = Angle.from_turns(mpq(1, n))
        assert float(TurnRatio(mpq(1), third)) == 1 / n  # correctly rounded
        assert float(TurnRatio(mpq(1), third, inverse=True)) == n
    assert float(TurnRatio(mpq(0), A)) == 0.0


def test_a_float_of_a_tiny_ratio_has_all_its_digits():
    assert float(TurnRatio(mpq(1), TINY)) == pytest.approx(2.0**-200 / 6.283185307179586)
    # At 128 bits this difference of two angles near 34 degrees has some 17 bits left.
    near = Angle.from_degrees("33.690067525979786913525494561660")
    difference = near - Angle(0, (3, 2))
    small = difference if difference > ZERO else -difference
    with working_precision(600):
        expected = float(small.ball())
    assert float(TurnRatio(mpq(1), small)) == pytest.approx(expected, rel=1e-15)
    assert 1e-34 < expected < 1e-32


# --- refused -------------------------------------------------------------------------------------


@pytest.mark.parametrize("angle", [ZERO, -A, -TINY])
def test_the_angle_is_positive(angle):
    with pytest.raises(InputError, match="accepted: a coefficient of 0 or more and a positive"):
        TurnRatio(mpq(1), angle)


def test_the_coefficient_is_an_exact_number_of_0_or_more():
    with pytest.raises(InputError, match="accepted: a coefficient of 0 or more"):
        TurnRatio(mpq(-1, 10**30), A)
    for value in (0.5, float("nan")):
        with pytest.raises(FloatRefusedError):
            TurnRatio(value, A)
    with pytest.raises(NumberError):
        TurnRatio("one", A)
    assert TurnRatio("1/2", A) == TurnRatio(Fraction(1, 2), A) == TurnRatio(mpq(1, 2), A)
    assert TurnRatio(2, QUARTER_TURN).rational == mpq(1, 2)


def test_inverse_and_direct_irrational_ratios_do_not_compare():
    direct, inverse = TurnRatio(mpq(1), A), TurnRatio(mpq(1), B, inverse=True)
    with pytest.raises(InputError, match="not comparable by a linear form"):
        direct.compare(inverse)
    assert direct != inverse


def test_other_things_are_not_equal():
    ratio = TurnRatio(mpq(1), QUARTER_TURN)
    assert ratio == mpq(1, 4) == ratio
    assert ratio == Fraction(1, 4)
    assert ratio == Decimal("0.25")
    for other in ("1/4", "x", None, 0.25, [], QUARTER_TURN):
        assert ratio != other
    for other in ("1/4", QUARTER_TURN, None, 0.25):
        with pytest.raises((TypeError, NumberError)):
            ratio < other  # noqa: B015
        with pytest.raises((TypeError, NumberError)):
            ratio >= other  # noqa: B015


def test_equal_ratios_and_numbers_have_equal_hashes():
    quarter = TurnRatio(mpq(1), QUARTER_TURN)
    twins = [TurnRatio(mpq(1, 2), 2 * QUARTER_TURN), TurnRatio(mpq(1, 16), QUARTER_TURN, True)]
    everything = {quarter, *twins, Fraction(1, 4), mpq(1, 4), Decimal("0.25")}
    assert len(everything) == 1
    a, b = TurnRatio(mpq(4), A, inverse=True), TurnRatio(mpq(8), 2 * A, inverse=True)
    assert a == b
    assert hash(a) == hash(b)


# --- exact comparison ----------------------------------------------------------------------------


def test_exact_ties_of_cost():
    # Two steps for a width h cost what one step costs for h / 2, at c = 0.
    assert cost(2, 0, 2 * A) == cost(1, 0, A)
    # At c = 1: (1 + 1) / h against (2 + 1) / (3 h / 2), with 3 h / 2 = 3 A and h = 2 A.
    assert cost(1, 1, 2 * A) == cost(2, 1, 3 * A)
    assert cost(1, "0.1234567", 11234567 * EIGHTH) == cost(2, "0.1234567", 21234567 * EIGHTH)
    assert not cost(1, 1, 2 * A) < cost(2, 1, 3 * A)
    assert cost(1, 1, 2 * A) < cost(2, 1, 3 * A - TINY)
    assert cost(1, 1, 2 * A) > cost(2, 1, 3 * A + TINY)
    assert cost(1, "0.9999999", 2 * A) < cost(2, 1, 3 * A)


def test_ties_that_only_an_identity_shows():
    # Machin: 4 arctan(1/5) = 45 degrees + arctan(1/239).
    assert TurnRatio(4, A) == TurnRatio(1, EIGHTH + B)
    assert TurnRatio(1, A, inverse=True) == TurnRatio(4, EIGHTH + B, inverse=True)
    assert TurnRatio(1, A, inverse=True) < TurnRatio(4, EIGHTH + B - TINY, inverse=True)


def test_comparison_with_numbers():
    ratio = TurnRatio(1, A)  # 0.0314...
    assert ratio > 0
    assert ratio > -1
    assert ratio < Fraction("0.0315")
    assert ratio.compare("0.0315") == -1
    assert ratio > Decimal("0.0314")
    assert ratio != mpq(314, 10000)
    inverse = TurnRatio(1, A, inverse=True)  # 31.83...
    assert mpq(31) < inverse < 32
    assert TurnRatio(0, A) == 0
    assert TurnRatio(0, A) < TurnRatio(1, B)
    assert TurnRatio(1, B) > TurnRatio(0, A, inverse=True)
    assert ratio < TurnRatio(1, QUARTER_TURN) < inverse
    assert sorted([TurnRatio(1, B), mpq(1), ratio]) == [TurnRatio(1, B), ratio, mpq(1)]


def value_of(ratio):
    with working_precision(2000):
        return ratio.ball()


@given(ratios, ratios)
def test_comparison_is_that_of_long_enclosures(p, q):
    assume(p.inverse == q.inverse or p.rational is not None or q.rational is not None)
    difference = value_of(p) - value_of(q)
    if difference > 0:
        assert p > q
    elif difference < 0:
        assert p < q
    else:  # not told apart by 2000 bits
        assert p == q
        assert hash(p) == hash(q)
    assert p.compare(q) == -q.compare(p)


@given(ratios, fractions)
def test_comparison_with_rationals(p, number):
    if p.rational is not None:
        assert p.compare(number) == (p.rational > number) - (p.rational < number)
        assert p == p.rational
        assert hash(p) == hash(p.rational)
    else:
        assert p.compare(number) == (
            1 if value_of(p) > flint.fmpq(*number.as_integer_ratio()) else -1
        )
    assert (p < number) == (p.compare(number) < 0)
    assert (p >= number) == (p.compare(number) >= 0)


@given(coefficients, positive_angles, st.booleans(), st.integers(1, 5))
def test_the_same_number_in_other_words(c, angle, inverse, n):
    p = TurnRatio(c, angle, inverse)
    q = TurnRatio(n * c if inverse else c / n, n * angle, inverse)
    assert p == q
    assert hash(p) == hash(q)
    assert p.decimal(9) == q.decimal(9)
