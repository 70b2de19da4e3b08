"""`stochgeom.exact.decimals` and the balls behind it: worked cases and the rounding law."""

from __future__ import annotations

import re
import threading
from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

import flint
import numpy as np
import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.balls import (
    argument_ball,
    ball_sign,
    rational_ball,
    sign_by_refinement,
    working_precision,
)
from stochgeom.exact.decimals import MAX_DIGITS, certified_decimal, rational_decimal
from tests.strategies import long_fractions

# --- rational values -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (mpq(2, 3), 4, "0.6667"),
        (mpq(-2, 3), 4, "-0.6667"),
        (mpq(2, 3), 0, "1"),
        (5, 0, "5"),
        (5, 2, "5.00"),
        (mpq(-5), 1, "-5.0"),
        (0, 3, "0.000"),
        (mpq(1, 1000), 3, "0.001"),
        (mpq(1, 1000), 2, "0.00"),
        (mpq(99, 100), 1, "1.0"),
        (mpq(-99, 100), 1, "-1.0"),
        (mpq(123456789, 10), 0, "12345679"),
        (mpz(10) ** 40, 1, "1" + "0" * 40 + ".0"),
    ],
)
def test_rational_decimal(value, digits, text):
    assert rational_decimal(value, digits) == text


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (mpq(1, 2), 0, "0"),
        (mpq(3, 2), 0, "2"),
        (mpq(5, 2), 0, "2"),
        (mpq(45, 2), 0, "22"),
        (mpq(47, 2), 0, "24"),
        (mpq(1, 8), 2, "0.12"),
        (mpq(3, 8), 2, "0.38"),
        (mpq(-3, 2), 0, "-2"),
        (mpq(-5, 2), 0, "-2"),
        (mpq(-1, 8), 2, "-0.12"),
        (mpq(1, 2) + mpq(1, 10**40), 0, "1"),
        (mpq(1, 2) - mpq(1, 10**40), 0, "0"),
        (mpq(5, 2) + mpq(1, 10**40), 0, "3"),
    ],
)
def test_ties_go_to_the_even_digit(value, digits, text):
    assert rational_decimal(value, digits) == text


def test_there_is_no_negative_zero():
    assert rational_decimal(mpq(-1, 1000), 2) == "0.00"
    assert rational_decimal(mpq(-1, 2), 0) == "0"
    assert rational_decimal(mpq(-5, 1000), 2) == "0.00"
    assert rational_decimal(mpq(-6, 1000), 2) == "-0.01"
    assert certified_decimal(lambda: -flint.arb.pi() / 1000, 2) == "0.00"


@given(long_fractions, st.integers(0, 12))
def test_rounding_is_that_of_decimal_and_of_fractions(value, digits):
    text = rational_decimal(mpq(value.numerator, value.denominator), digits)
    assert Fraction(text) == round(value, digits)  # half to even, exactly
    exact = Context(prec=400).divide(Decimal(value.numerator), Decimal(value.denominator))
    quantized = exact.quantize(Decimal(1).scaleb(-digits), rounding=ROUND_HALF_EVEN)
    assert text == f"{abs(quantized) if quantized == 0 else quantized:f}"


@given(st.integers(-(10**9), 10**9), st.integers(0, 6))
def test_ties_by_construction(whole, digits):
    value = mpq(2 * whole + 1, 2 * 10**digits)
    text = rational_decimal(value, digits)
    even = whole if whole % 2 == 0 else whole + 1
    assert Fraction(text) == Fraction(even, 10**digits)
    assert re.fullmatch(r"-?[0-9]+" + (rf"\.[0-9]{{{digits}}}" if digits else ""), text)


# --- irrational values ---------------------------------------------------------------------------

PI = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803"


def pi_text(digits):
    return str(Decimal(PI).quantize(Decimal(1).scaleb(-digits), context=Context(prec=100)))


@pytest.mark.parametrize("digits", [1, 2, 3, 4, 5, 9, 30, 60, 80])
def test_decimals_of_pi(digits):
    assert certified_decimal(flint.arb.pi, digits) == pi_text(digits)
    assert certified_decimal(lambda: -flint.arb.pi(), digits) == f"-{pi_text(digits)}"


def test_a_long_run_of_nines_takes_more_bits():
    # 1/2 - 10**-500 is not half: the enclosure has to shrink below 10**-500.
    nearly = flint.fmpq(1, 2) - flint.fmpq(1, 10**500)
    assert certified_decimal(lambda: flint.arb(nearly) + 0 * flint.arb.pi(), 0) == "0"
    assert certified_decimal(lambda: 1 - flint.arb(nearly) + 0 * flint.arb.pi(), 0) == "1"


def test_an_enclosure_that_does_not_shrink_ends_at_the_cap():
    # So would a rational tie, which belongs to `rational_decimal`.
    with pytest.raises(PrecisionLimitError, match="0 decimals are still undecided"):
        certified_decimal(lambda: flint.arb(0.5, 0.001), 0)


# --- digits --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "digits", [-1, MAX_DIGITS + 1, 10**30, np.int64(-1), 2.0, 2.5, float("nan"), "2", None]
)
def test_digits_are_a_whole_number_within_limits(digits):
    for attempt in (
        lambda: rational_decimal(mpq(1, 3), digits),
        lambda: certified_decimal(flint.arb.pi, digits),
    ):
        with pytest.raises(InputError, match=f"accepted: whole numbers from 0 to {MAX_DIGITS}"):
            attempt()


def test_numpy_digits_do_not_wrap():
    for digits in (np.int64(25), np.int8(25), mpz(25)):
        assert certified_decimal(flint.arb.pi, digits) == "3.1415926535897932384626434"
        assert rational_decimal(mpq(1, 3), digits) == "0." + "3" * 25


def test_many_digits():
    assert rational_decimal(mpq(1, 3), MAX_DIGITS) == "0." + "3" * MAX_DIGITS
    assert certified_decimal(flint.arb.pi, 5000).startswith(PI[:-1])


# --- balls ---------------------------------------------------------------------------------------


def test_precision_is_put_back():
    before = flint.ctx.prec
    with working_precision(300), working_precision(500):
        assert flint.ctx.prec == 500
    assert flint.ctx.prec == before
    with pytest.raises(KeyError), working_precision(300):
        raise KeyError
    assert flint.ctx.prec == before


def test_threads_do_not_disturb_each_other():
    found = set()

    def work(digits):
        for _ in range(30):
            found.add(certified_decimal(flint.arb.pi, digits))

    threads = [threading.Thread(target=work, args=(digits,)) for digits in (3, 40, 80)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {pi_text(3), pi_text(40), pi_text(80)}


def test_the_sign_of_a_ball_is_certain_or_open():
    assert ball_sign(flint.arb(2, 1)) == 1
    assert ball_sign(flint.arb(-2, 1)) == -1
    assert ball_sign(flint.arb(0)) == 0
    assert ball_sign(flint.arb(0, 1)) is None
    assert ball_sign(flint.arb(1, 1)) is None
    assert ball_sign(flint.arb("nan")) is None


def test_refinement_stops_at_the_cap():
    with pytest.raises(PrecisionLimitError, match="still undecided at 4194304 bits"):
        sign_by_refinement(lambda: flint.arb(0, 1))


@given(long_fractions)
def test_a_rational_ball_holds_its_number(value):
    ball = rational_ball(mpq(value.numerator, value.denominator))
    assert ball.contains(flint.fmpq(value.numerator, value.denominator))


@pytest.mark.parametrize(
    ("x", "y", "eighths"),
    [(1, 0, 0), (2, 2, 1), (0, 3, 2), (-1, 1, 3), (-5, 0, 4), (-1, -1, 5), (0, -1, 6), (1, -1, 7)],
)
def test_an_argument_ball_holds_the_turns(x, y, eighths):
    assert argument_ball(x, y).contains(flint.fmpq(eighths, 8))
    assert argument_ball(x, y).rel_accuracy_bits() > 40 or eighths == 0
