"""The numbers of a planning problem: rational, angle sums, or floats; chosen once.

A problem is *exact* if its prior, matrices and costs are rational numbers; the prior may also hold
`AngleSum` numbers, such as the widths of arcs in full turns, which stay what they are under
rational matrices. It is a *float* problem if a binary float stands anywhere in its prior and
matrices. Whole numbers suit both kinds: 0 and 1 are what they are in float64 too. Anything else is
a mixture, and is refused with the first entry that does not fit.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Iterator
from enum import Enum
from fractions import Fraction
from typing import Any, Final, TypeAlias, final

from gmpy2 import mpq, mpz

from stochgeom.errors import MixedNumbersError, NumberError, NumberLimitError
from stochgeom.exact.angles import Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational
from stochgeom.exact.sums import AngleSum

Number: TypeAlias = "mpq | AngleSum | float"
"""A probability or a cost of a planning problem."""

Entry: TypeAlias = "tuple[Any, str]"
"""A number as it was given, and where it stands."""

_LARGEST_WHOLE_FLOAT: Final = 2**53


@final
class NumberKind(Enum):
    """Which numbers a planning problem computes with."""

    RATIONAL = "rational"
    ANGLE_SUMS = "angle sums"
    FLOAT = "float"

    @property
    def exact(self) -> bool:
        """Whether computing makes no error."""
        return self is not NumberKind.FLOAT


def common_kind(entries: Iterable[Entry]) -> NumberKind:
    """Return the kind of some numbers.

    Parameters
    ----------
    entries : iterable of (number, str)
        The numbers with their places.

    Raises
    ------
    MixedNumbersError
        If floats and exact numbers that are not whole stand together; the entry that does not fit
        those before it is named.

    Examples
    --------
    >>> common_kind([(1, "prior, entry 0"), ("1/2", "action 'a', row 0, entry 0")])
    <NumberKind.RATIONAL: 'rational'>
    >>> common_kind([(0.5, "prior, entry 0"), ("1/2", "prior, entry 1")])
    Traceback (most recent call last):
    ...
    stochgeom.errors.MixedNumbersError: prior, entry 1: '1/2' is exact, and a float stands at \
prior, entry 0; accepted: exact numbers alone, or floats and whole numbers
    """
    kind = NumberKind.RATIONAL
    first: dict[bool, str] = {}
    for value, place in entries:
        if _is_neutral(value):
            continue
        is_float = _is_float(value)
        first.setdefault(is_float, place)
        if len(first) == 2:
            what, other = ("a float", "an exact number") if is_float else ("exact", "a float")
            raise MixedNumbersError(
                f"{value!r:.60} is {what}, and {other} stands at {first[not is_float]}; "
                "accepted: exact numbers alone, or floats and whole numbers",
                where=place,
            )
        if is_float:
            kind = NumberKind.FLOAT
        elif isinstance(value, AngleSum | TurnRatio | Angle):
            kind = NumberKind.ANGLE_SUMS
    return kind


def read_number(value: Any, kind: NumberKind, where: str) -> Number:
    """Return a number of a kind that `common_kind` found.

    Raises
    ------
    NumberError
        If it is no number, or not finite.

    Examples
    --------
    >>> read_number("0.1", NumberKind.RATIONAL, "entry 0")
    mpq(1,10)
    >>> read_number(1, NumberKind.FLOAT, "entry 0")
    1.0
    """
    if kind is NumberKind.FLOAT:
        if not (_is_float(value) or _is_neutral(value)) or not math.isfinite(value):
            raise NumberError(
                f"{value!r:.60} is not a finite float; accepted: a number", where=where
            )
        return float(value)
    if kind is NumberKind.ANGLE_SUMS:
        return _angle_sum(value, where)
    return rational(value, where=where)


def _angle_sum(value: Any, where: str) -> AngleSum:
    if isinstance(value, Angle):
        return AngleSum(0, [(1, value)])
    if isinstance(value, AngleSum | TurnRatio):
        return AngleSum.of(value)
    return AngleSum(rational(value, where=where))


def numbered(values: Iterable[Any], place: str) -> Iterator[Entry]:
    """Yield numbers with their places: ``"row 2, entry 0"``."""
    for k, value in enumerate(values):
        yield value, f"{place}, entry {k}"


def as_float(value: mpq, where: str) -> float:
    """Return a rational number as a float.

    Raises
    ------
    NumberLimitError
        If it is beyond the largest float.

    Examples
    --------
    >>> as_float(mpq(1, 3), "entry 0")
    0.3333333333333333
    """
    try:
        return float(value)
    except OverflowError:
        raise NumberLimitError(
            "the number is too large for a float; accepted: below 1.79e308", where=where
        ) from None


def _is_float(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, numbers.Rational | Fraction)


def _is_neutral(value: Any) -> bool:
    """Tell whether a value is a whole number, which suits every kind."""
    if isinstance(value, bool) or not isinstance(value, int | numbers.Integral | type(mpz())):
        return False
    return bool(abs(value) <= _LARGEST_WHOLE_FLOAT)
