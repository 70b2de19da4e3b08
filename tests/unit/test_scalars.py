"""Worked cases of `stochgeom.exact.scalars`: what is a number here, and what is not."""

from __future__ import annotations

from decimal import Decimal
from enum import IntEnum
from fractions import Fraction

import flint
import gmpy2
import numpy as np
import pytest
import sympy
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import FloatRefusedError, NumberError, NumberLimitError
from stochgeom.exact.scalars import (
    MAX_EXPONENT,
    MAX_TEXT_LENGTH,
    common_denominator,
    from_float_exact,
    from_float_shortest,
    parse_rational,
    rational,
    rational_text,
)
from tests.strategies import long_fractions

# --- accepted ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "numerator", "denominator"),
    [
        ("3", 3, 1),
        ("-3", -3, 1),
        ("+3", 3, 1),
        ("-0", 0, 1),
        ("-0.0", 0, 1),
        ("007", 7, 1),
        ("-010", -10, 1),  # ten, not eight
        ("0.1", 1, 10),
        ("-.5", -1, 2),
        ("+.5", 1, 2),
        ("1.", 1, 1),
        ("1.250", 5, 4),
        ("1e3", 1000, 1),
        ("1E+3", 1000, 1),
        ("25e-2", 1, 4),
        ("-1.5e1", -15, 1),
        ("0.00125e3", 5, 4),
        ("2/7", 2, 7),
        ("+2/7", 2, 7),
        ("-4/6", -2, 3),
        ("4 / 6", 2, 3),
        ("0/5", 0, 1),
        (" 3\t", 3, 1),
        ("3\n", 3, 1),
        ("\u00a03", 3, 1),  # a no-break space, as copied from a web page
    ],
)
def test_text(text, numerator, denominator):
    value = rational(text)
    assert type(value) is type(mpq())
    assert value == mpq(numerator, denominator)
    assert parse_rational(text) == value


class _OwnFraction(Fraction):
    pass


class _Colour(IntEnum):
    RED = 3


@pytest.mark.parametrize(
    "three",
    [
        3,
        mpz(3),
        mpq(3),
        Fraction(3),
        Decimal(3),
        Decimal("3.00"),
        Decimal("0.3E+1"),
        np.int8(3),
        np.int64(3),
        np.uint64(3),
        np.array(3),
        np.str_("3"),
        sympy.Integer(3),
        flint.fmpz(3),
        _OwnFraction(3),
        _Colour.RED,
    ],
    ids=lambda value: type(value).__name__,
)
def test_every_kind_of_exact_number_is_accepted(three):
    value = rational(three)
    assert type(value) is type(mpq())
    assert value == 3


def test_machine_integers_keep_all_their_bits():
    assert rational(np.uint64(2**64 - 1)) == 2**64 - 1
    assert rational(np.int64(-(2**63))) == -(2**63)


@given(long_fractions)
def test_fractions_pass_unchanged(value):
    found = rational(value)
    assert (found.numerator, found.denominator) == (value.numerator, value.denominator)
    assert rational(rational_text(found)) == found
    assert Fraction(rational_text(found)) == value


@given(st.decimals(allow_nan=False, allow_infinity=False))
def test_decimals_are_read_as_python_reads_them(value):
    if abs(value.as_tuple().exponent) <= MAX_EXPONENT:
        expected = Fraction(value)
        assert Fraction(str(rational(value))) == expected
        assert Fraction(str(rational(str(value)))) == expected


@given(st.from_regex(r"[+-]?[0-9]{1,6}(\.[0-9]{0,6})?([eE][+-]?[0-9]{1,3})?", fullmatch=True))
def test_decimal_text_is_read_as_python_reads_it(text):
    # \Z of the pattern lets no digit of another alphabet pass: [0-9] is written out.
    assert Fraction(str(rational(text))) == Fraction(Decimal(text))


# --- refused -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        *["", " ", ".", "-", "+", "e5", "1e", "1e+", ".e1", "abc", "1 2", "1_000", "1,5"],
        *["--3", "+-3", "- 3", "0x10", "0b1", "0o7", "3j", "1.2.3", "1e2.5", "1e2e3"],
        *["nan", "NaN", "inf", "-Infinity", "1//2", "1/", "/2", "1/-2", "1.5/2", "1/2/3", "1e1/2"],
        *["\uff13", "1/\u0663", "\u0663", "\u00b2", "\u2212" + "3", "\u00bd", "3\x00", "3\u200b"],
    ],
)
def test_other_text_is_no_number(text):
    with pytest.raises(NumberError, match="accepted: whole numbers") as caught:
        rational(text, where="vertex 7, x")
    assert caught.value.where == "vertex 7, x"
    assert str(caught.value).startswith("vertex 7, x: ")
    assert not isinstance(caught.value, FloatRefusedError | NumberLimitError)


def test_division_by_zero_is_named():
    with pytest.raises(NumberError, match="'1/000' divides by zero"):
        rational("1/000")


@pytest.mark.parametrize(
    "value",
    [
        0.5,
        1.0,
        -0.0,
        float("nan"),
        float("inf"),
        np.float16(1),
        np.float32(1),
        np.float64(1),
        np.longdouble(1),
        gmpy2.mpfr(1),
        sympy.Float(1),
    ],
    ids=lambda value: type(value).__name__,
)
def test_binary_floats_are_refused_and_the_two_policies_named(value):
    with pytest.raises(FloatRefusedError, match=r"from_float_exact.*from_float_shortest") as caught:
        rational(value, where="line 3")
    assert isinstance(caught.value, NumberError)
    assert isinstance(caught.value, TypeError)
    assert caught.value.where == "line 3"


@pytest.mark.parametrize(
    "value",
    [
        *[True, False, np.True_, np.array(True), None, 1j, b"3", [3], (1, 2), {}, object()],
        *[np.array([3]), np.array(1.5), np.timedelta64(3), gmpy2.mpc(1), sympy.pi, flint.arb(3)],
        *[Decimal("NaN"), Decimal("sNaN"), Decimal("Infinity"), Decimal("-Infinity")],
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_is_no_number_is_refused(value):
    with pytest.raises(NumberError) as caught:
        rational(value, where="here")
    assert "accepted: whole numbers" in str(caught.value)
    assert caught.value.where == "here"


def test_true_is_no_one():
    with pytest.raises(NumberError, match="True is a truth value"):
        rational(True)


# --- limits --------------------------------------------------------------------------------------


def test_the_longest_text_is_read():
    assert rational("9" * MAX_TEXT_LENGTH) == mpz(10) ** MAX_TEXT_LENGTH - 1
    assert rational("1/" + "9" * (MAX_TEXT_LENGTH - 2)).denominator.bit_length() > 60_000


def test_longer_text_is_refused_without_printing_it():
    for text in ("9" * (MAX_TEXT_LENGTH + 1), " " * MAX_TEXT_LENGTH + "3", "x" * 10**6):
        with pytest.raises(NumberLimitError, match=f"at most {MAX_TEXT_LENGTH} char") as caught:
            rational(text, where="line 1")
        assert len(str(caught.value)) < 200


def test_the_largest_exponent_is_read():
    assert rational(f"1e{MAX_EXPONENT}") == mpz(10) ** MAX_EXPONENT
    assert rational(f"-2e-{MAX_EXPONENT}") == mpq(-2, mpz(10) ** MAX_EXPONENT)
    assert rational("1e" + "0" * 5000 + "1") == 10
    assert rational("1e-" + "0" * 5000 + "1") == mpq(1, 10)
    assert rational("0." + "0" * 15_000 + "1") == mpq(1, mpz(10) ** 15_001)


@pytest.mark.parametrize(
    "value",
    [
        f"1e{MAX_EXPONENT + 1}",
        f"1e-{MAX_EXPONENT + 1}",
        "1e999999999",
        "-1E+999999999999999999999",
        "0e99999",
        "1e" + "9" * 15_000,
        "1e" + "0" * 5000 + "10001",
        Decimal("1e999999"),
        Decimal("1e-999999"),
    ],
    ids=lambda value: str(value)[:20],
)
def test_a_larger_exponent_is_refused_at_once(value):
    with pytest.raises(
        NumberLimitError, match="accepted: exponents from -10000 to 10000"
    ) as caught:
        rational(value)
    assert len(str(caught.value)) < 250


# --- floats by name ------------------------------------------------------------------------------


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_the_two_float_policies(value):
    assert Fraction(str(from_float_exact(value))) == Fraction(value)
    shortest = from_float_shortest(value)
    assert float(Fraction(str(shortest))) == value
    assert Fraction(str(shortest)) == Fraction(repr(value))


@given(st.floats(allow_nan=False, allow_infinity=False, width=32))
def test_the_two_float_policies_in_single_precision(value):
    single = np.float32(value)
    assert Fraction(str(from_float_exact(single))) == Fraction(value)
    shortest = from_float_shortest(single)
    assert np.float32(Fraction(str(shortest))) == single
    assert Fraction(str(shortest)) == Fraction(np.format_float_scientific(single, unique=True))


def test_float_policies_by_hand():
    assert from_float_exact(0.1) == mpq(3602879701896397, 2**55)
    assert from_float_shortest(0.1) == mpq(1, 10)
    assert from_float_shortest(np.float64(0.1)) == mpq(1, 10)
    assert from_float_shortest(np.float32(0.1)) == mpq(1, 10)
    assert from_float_exact(np.float32(0.1)) == mpq(13421773, 2**27)
    assert from_float_exact(np.longdouble(1) + np.finfo(np.longdouble).eps) > 1
    assert from_float_exact(5e-324) == mpq(1, mpz(2) ** 1074)
    assert from_float_shortest(5e-324) == mpq(5, mpz(10) ** 324)
    assert from_float_shortest(-0.0) == 0


@pytest.mark.parametrize("make", [from_float_exact, from_float_shortest])
@pytest.mark.parametrize(
    "value", [float("nan"), float("inf"), -float("inf"), np.float32("nan"), "0.1", None, 1j]
)
def test_only_finite_floats_have_a_value(make, value):
    with pytest.raises(NumberError, match="not a finite float") as caught:
        make(value, where="line 9")
    assert caught.value.where == "line 9"


# --- text, denominators --------------------------------------------------------------------------


def test_rational_text():
    assert rational_text(mpq(6, 4)) == "3/2"
    assert rational_text(mpq(-4, 2)) == "-2"
    assert rational_text(mpz(7)) == rational_text(7) == "7"
    assert rational_text(mpq(0)) == "0"


def test_rational_text_has_no_limit_on_digits():
    assert rational_text(10**5000) == "1" + "0" * 5000
    assert rational_text(mpq(1, mpz(10) ** 5000)) == "1/1" + "0" * 5000


def test_common_denominator():
    assert common_denominator([]) == 1
    assert common_denominator([mpq(5, 6)]) == 6
    assert common_denominator([mpq(1, 6), mpq(3, 4), mpq(-7, 6), mpq(2)]) == 12
