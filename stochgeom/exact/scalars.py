"""Exact rational scalars: what is accepted as a number, and how it becomes an `mpq`.

Accepted are `int`, `fractions.Fraction`, gmpy2 `mpz` and `mpq`, `decimal.Decimal`, numpy
integers, and text in decimal, scientific or fraction notation: ``"0.1"`` is exactly one tenth.
Binary floats are refused, because the number meant and the number held differ; who wants one
says which by name: `from_float_exact` (the binary value) or `from_float_shortest` (the shortest
decimal that reads back as the same float).

Text has a length and an exponent limit, so that ``"1e999999999"`` is an error and not a machine
out of memory.
"""

from __future__ import annotations

import math
import numbers
import operator
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, Final, SupportsFloat, SupportsIndex, TypeAlias

import gmpy2
from gmpy2 import mpq, mpz

from stochgeom.errors import FloatRefusedError, NumberError, NumberLimitError

MAX_TEXT_LENGTH: Final = 20_000
"""Longest text, in characters, that is read as one number."""

MAX_EXPONENT: Final = 10_000
"""Largest absolute power of ten in scientific notation."""

ACCEPTED: Final = "accepted: whole numbers, fractions and decimals such as 3, 2/7, -0.25, 1e-3"

RationalLike: TypeAlias = "int | Fraction | Decimal | str | mpz | mpq | SupportsIndex"
"""Anything `rational` takes."""

_INTEGER = re.compile(r"-?[0-9]+\Z")
_DECIMAL = re.compile(r"([+-]?)([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?[0-9]+))?\Z")
_FRACTION = re.compile(r"([+-]?[0-9]+)\s*/\s*([0-9]+)\Z")
_MPZ: Final = type(mpz())
_MPQ: Final = type(mpq())


def rational(value: RationalLike, *, where: str | None = None) -> mpq:
    """Return the exact rational number that `value` stands for.

    Parameters
    ----------
    value : int, Fraction, Decimal, mpz, mpq, numpy integer or str
        Text may be ``"3"``, ``"2/7"``, ``"-0.25"`` or ``"1e-3"``.
    where : str, optional
        The place named in an error, such as ``"vertex 7, x"``.

    Raises
    ------
    FloatRefusedError
        For a binary float.
    NumberLimitError
        For text over `MAX_TEXT_LENGTH` or an exponent over `MAX_EXPONENT`.
    NumberError
        For anything else that is not a number, NaN and infinity among them.

    Examples
    --------
    >>> rational("0.1")
    mpq(1,10)
    >>> rational(" -2/4 ")
    mpq(-1,2)
    """
    kind = type(value)
    if kind is _MPQ:
        return value
    if kind is int or kind is _MPZ or kind is Fraction:
        return mpq(value)
    if isinstance(value, str):
        return parse_rational(value, where=where)
    if isinstance(value, bool):
        raise NumberError(f"{value!r} is a truth value, not a number; {ACCEPTED}", where=where)
    if isinstance(value, Decimal):
        return _from_decimal(value, where)
    if isinstance(value, numbers.Real) and not isinstance(value, numbers.Rational):
        raise FloatRefusedError(
            f"{value!r} is a binary float; give text or a Fraction, or say which value is meant: "
            "from_float_exact (the binary value) or from_float_shortest (the shortest decimal)",
            where=where,
        )
    try:
        return mpq(Fraction(value)) if isinstance(value, Fraction) else _from_index(value)
    except TypeError:
        raise NumberError(
            f"{value!r} of type {kind.__name__} is not an exact number; {ACCEPTED}", where=where
        ) from None


def parse_rational(text: str, *, where: str | None = None) -> mpq:
    """Read a decimal, scientific or fraction notation exactly.

    Examples
    --------
    >>> parse_rational("1.25e1")
    mpq(25,2)
    >>> parse_rational("nan", where="line 3")
    Traceback (most recent call last):
    ...
    stochgeom.errors.NumberError: line 3: 'nan' is not a number; accepted: whole numbers, \
fractions and decimals such as 3, 2/7, -0.25, 1e-3
    """
    if len(text) > MAX_TEXT_LENGTH:
        raise NumberLimitError(
            f"number text of {len(text)} characters, beginning {text[:20]!r}; "
            f"accepted: at most {MAX_TEXT_LENGTH} characters",
            where=where,
        )
    body = text.strip()
    if _INTEGER.match(body):
        return mpq(mpz(body))
    match = _DECIMAL.match(body)
    if match and (match[2] or match[3]):
        return _decimal_value(body, match, where)
    match = _FRACTION.match(body)
    if match is None:
        raise NumberError(f"{text[:60]!r} is not a number; {ACCEPTED}", where=where)
    denominator = mpz(match[2])
    if denominator == 0:
        raise NumberError(f"{text[:60]!r} divides by zero; {ACCEPTED}", where=where)
    return mpq(mpz(match[1]), denominator)


def _decimal_value(body: str, match: re.Match[str], where: str | None) -> mpq:
    sign, whole, fraction, exponent_text = match.groups()
    fraction = fraction or ""
    # A long exponent is judged by its length before it is read as a number.
    digits = (exponent_text or "0").lstrip("+-").lstrip("0")
    if len(digits) > len(str(MAX_EXPONENT)) or int(digits or 0) > MAX_EXPONENT:
        raise NumberLimitError(
            f"{body[:60]!r} has the exponent {exponent_text[:20]}; "
            f"accepted: exponents from -{MAX_EXPONENT} to {MAX_EXPONENT}",
            where=where,
        )
    mantissa = mpz(sign + (whole + fraction or "0"))
    exponent = int(digits or 0)
    power = (-exponent if (exponent_text or "").startswith("-") else exponent) - len(fraction)
    if power >= 0:
        return mpq(mantissa * mpz(10) ** power)
    return mpq(mantissa, mpz(10) ** -power)


def _from_index(value: Any) -> mpq:
    return mpq(operator.index(value))


def _from_decimal(value: Decimal, where: str | None) -> mpq:
    if not value.is_finite():
        raise NumberError(f"{value} is not a finite number; {ACCEPTED}", where=where)
    return parse_rational(str(value), where=where)


def from_float_exact(value: float, *, where: str | None = None) -> mpq:
    """Return the exact binary value of a float: ``0.1`` is not one tenth.

    Examples
    --------
    >>> from_float_exact(0.5)
    mpq(1,2)
    >>> from_float_exact(0.1)
    mpq(3602879701896397,36028797018963968)
    """
    _require_finite(value, where)
    return mpq(*value.as_integer_ratio())  # also of numpy's narrower and wider floats


def from_float_shortest(value: SupportsFloat, *, where: str | None = None) -> mpq:
    """Return the shortest decimal that reads back as the same float: ``0.1`` is one tenth.

    Examples
    --------
    >>> from_float_shortest(0.1)
    mpq(1,10)
    """
    _require_finite(value, where)
    # numpy prints its own kinds of floats as the shortest decimal for their own precision.
    text = repr(float(value)) if isinstance(value, float) else str(value)
    return parse_rational(text, where=where)


def _require_finite(value: Any, where: str | None) -> None:
    if not isinstance(value, numbers.Real) or not math.isfinite(value):
        raise NumberError(f"{value!r} is not a finite float", where=where)


def is_pair(value: object) -> bool:
    """Tell whether a value holds two things in order, as (x, y) does.

    Examples
    --------
    >>> is_pair([1, 2]), is_pair("12"), is_pair({1, 2})
    (True, False, False)
    """
    unordered_or_text = (str, bytes, set, frozenset, dict)
    return (
        not isinstance(value, unordered_or_text) and hasattr(value, "__len__") and len(value) == 2
    )


def rational_text(value: mpq | mpz | int) -> str:
    """Return ``"p"`` or ``"p/q"`` in lowest terms: the notation of every file we write.

    Examples
    --------
    >>> rational_text(mpq(6, 4)), rational_text(mpq(-4, 2))
    ('3/2', '-2')
    """
    return str(mpq(value))  # str() of a Python integer refuses more than 4300 digits


def integer_literal(value: int | mpz) -> str:
    """Return a Python integer literal, hexadecimal where Python refuses so long a decimal one.

    Examples
    --------
    >>> integer_literal(-7), integer_literal(10**5000)[:5]
    ('-7', '0x31e')
    """
    return str(value) if value.bit_length() <= 10_000 else hex(value)


def common_denominator(values: list[mpq]) -> mpz:
    """Return the least common multiple of the denominators.

    Examples
    --------
    >>> common_denominator([mpq(1, 6), mpq(3, 4)])
    mpz(12)
    """
    return gmpy2.lcm(*{value.denominator for value in values}) if values else mpz(1)
