"""Decimals for people: correctly rounded, from an exact value or a certified enclosure.

Ties (a value exactly in the middle of two decimals) go to the even last digit, as Python's
`round` and IEEE 754 do. Only rational values can tie, so a caller must recognise an exactly
rational value first and give it to `rational_decimal`; for irrational values the enclosure
shrinks until the digits agree.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from enum import Enum
from typing import SupportsIndex

import flint
from gmpy2 import f_divmod, mpq, mpz

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.balls import MAX_BITS, START_BITS, Ball, working_precision

MAX_DIGITS = 100_000
"""Most decimals that may be asked for."""


class Rounding(Enum):
    """Which neighbouring decimal stands for a number between two of them."""

    NEAREST = "nearest, ties to even"
    DOWN = "not above"
    UP = "not below"


def rational_decimal(value: mpq | int, digits: int, rounding: Rounding = Rounding.NEAREST) -> str:
    """Return `value` with `digits` decimals after the point.

    Examples
    --------
    >>> rational_decimal(mpq(2, 3), 4), rational_decimal(mpq(1, 8), 2), rational_decimal(5, 0)
    ('0.6667', '0.12', '5')
    >>> rational_decimal(mpq(-1, 3), 2, Rounding.UP), rational_decimal(mpq(-1, 3), 2, Rounding.DOWN)
    ('-0.33', '-0.34')
    """
    digits = check_digits(digits)
    scaled = mpq(value) * mpz(10) ** digits
    whole, rest = f_divmod(scaled.numerator, scaled.denominator)
    twice = 2 * rest
    if rounding is Rounding.UP:
        whole += rest > 0
    elif rounding is Rounding.NEAREST and (
        twice > scaled.denominator or (twice == scaled.denominator and whole % 2)
    ):
        whole += 1
    return _place_point(whole, digits)


def certified_decimal(
    enclose: Callable[[], Ball], digits: int, rounding: Rounding = Rounding.NEAREST
) -> str:
    """Return the irrational number inside `enclose()` with `digits` decimals.

    Parameters
    ----------
    enclose : callable
        Returns a ball around the number, computed at the working precision.
    digits : int
        Decimals after the point.
    rounding : Rounding
        To the nearest decimal, or to the one below or above.

    Raises
    ------
    PrecisionLimitError
        If the digits still differ at `stochgeom.exact.balls.MAX_BITS`; a rational tie, which
        the caller should have recognised, would end here.

    Examples
    --------
    >>> import flint
    >>> certified_decimal(lambda: flint.arb.pi(), 5)
    '3.14159'
    """
    digits = check_digits(digits)
    bits = START_BITS + 4 * digits
    while bits <= MAX_BITS:
        whole = _scaled_floor(enclose, digits, rounding, bits)
        if whole is not None:  # an irrational number is never whole: one more is above it
            return _place_point(whole + (rounding is Rounding.UP), digits)
        bits *= 2
    raise PrecisionLimitError(f"{digits} decimals are still undecided at {MAX_BITS} bits")


def decimal_if_clear(enclose: Callable[[], Ball], digits: int) -> str | None:
    """Return the nearest decimal if a first enclosure decides it, else None.

    For numbers that may be rational: one that is a tie never decides. The enclosure must not be
    exact.

    Examples
    --------
    >>> import flint
    >>> decimal_if_clear(lambda: flint.arb(1).exp(), 3)
    '2.718'
    >>> decimal_if_clear(lambda: flint.arb(1) / 8 + flint.arb.pi() - flint.arb.pi(), 2) is None
    True
    """
    digits = check_digits(digits)
    whole = _scaled_floor(enclose, digits, Rounding.NEAREST, START_BITS + 4 * digits)
    return None if whole is None else _place_point(whole, digits)


def _scaled_floor(
    enclose: Callable[[], Ball], digits: int, rounding: Rounding, bits: int
) -> mpz | None:
    with working_precision(bits):
        scaled = enclose() * 10**digits
        if rounding is Rounding.NEAREST:
            scaled += flint.arb(1) / 2
        whole = scaled.floor().unique_fmpz()
    return None if whole is None else mpz(int(whole))


def significant(printed: Callable[[int], str], digits: int) -> str:
    """Return the decimal of a number that is not 0, and shows that it is not.

    Parameters
    ----------
    printed : callable
        Returns the number with so many decimals, in any rounding.
    digits : int
        Decimals after the point. If all of them would be 0, as many as three significant digits
        need.

    Examples
    --------
    >>> tiny = mpq(1, 700_000)
    >>> significant(lambda digits: rational_decimal(tiny, digits, Rounding.DOWN), 4)
    '0.00000142'
    >>> significant(lambda digits: rational_decimal(mpq(2, 3), digits), 2)
    '0.67'
    """
    text, places = printed(digits), digits
    while not text.strip("-0."):
        places = 2 * places + 2
        text = printed(places)
    if places == digits:
        return text
    decimals = text.partition(".")[2]
    return printed(len(decimals) - len(decimals.lstrip("0")) + 3)


def check_digits(digits: SupportsIndex) -> int:
    """Return a number of decimals as an int; refuse what is negative, absurd or no whole number."""
    try:
        count = operator.index(digits)  # powers of ten in numpy's integers would wrap
    except TypeError:
        count = -1
    if not 0 <= count <= MAX_DIGITS:
        raise InputError(f"digits = {digits!r}; accepted: whole numbers from 0 to {MAX_DIGITS}")
    return count


def _place_point(scaled: mpz, digits: int) -> str:
    text = str(abs(scaled)).rjust(digits + 1, "0")
    minus = "-" if scaled < 0 else ""
    return minus + (f"{text[:-digits]}.{text[-digits:]}" if digits else text)
