"""Decimals for people: correctly rounded, from an exact value or a certified enclosure.

Ties (a value exactly in the middle of two decimals) go to the even last digit, as Python's
`round` and IEEE 754 do. Only rational values can tie, so a caller must recognise an exactly
rational value first and give it to `rational_decimal`; for irrational values the enclosure
shrinks until the digits agree.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import SupportsIndex

import flint
from gmpy2 import f_divmod, mpq, mpz

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.balls import MAX_BITS, START_BITS, Ball, working_precision

MAX_DIGITS = 100_000
"""Most decimals that may be asked for."""


def rational_decimal(value: mpq | int, digits: int) -> str:
    """Return `value` with `digits` decimals after the point, ties to even.

    Examples
    --------
    >>> rational_decimal(mpq(2, 3), 4), rational_decimal(mpq(1, 8), 2), rational_decimal(5, 0)
    ('0.6667', '0.12', '5')
    """
    digits = check_digits(digits)
    scaled = mpq(value) * mpz(10) ** digits
    whole, rest = f_divmod(scaled.numerator, scaled.denominator)
    twice = 2 * rest
    if twice > scaled.denominator or (twice == scaled.denominator and whole % 2):
        whole += 1
    return _place_point(whole, digits)


def certified_decimal(enclose: Callable[[], Ball], digits: int) -> str:
    """Return the irrational number inside `enclose()` with `digits` decimals.

    Parameters
    ----------
    enclose : callable
        Returns a ball around the number, computed at the working precision.
    digits : int
        Decimals after the point.

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
    scale = 10**digits
    while bits <= MAX_BITS:
        with working_precision(bits):
            rounded = (enclose() * scale + flint.arb(1) / 2).floor().unique_fmpz()
        if rounded is not None:
            return _place_point(mpz(int(rounded)), digits)
        bits *= 2
    raise PrecisionLimitError(f"{digits} decimals are still undecided at {MAX_BITS} bits")


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
