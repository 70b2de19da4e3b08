"""What a recomputation found: claims, each with its number and whether it holds."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import final

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.halves import near_half
from stochgeom.exact.scalars import rational
from stochgeom.feeding.plans import FeedingPlan


@final
@dataclass(frozen=True, slots=True)
class Fact:
    """One step of the argument that settles an erratum.

    Attributes
    ----------
    claim : str
        What was computed, and what it should be.
    found : str
        What it is.
    holds : bool
        Whether the claim is true; decided exactly unless the claim names an enclosure.
    """

    claim: str
    found: str
    holds: bool


Facts = tuple[Fact, ...]


def equal(claim: str, found: object, expected: object) -> Fact:
    """Return the fact that something is what it should be.

    Examples
    --------
    >>> equal("sides of the rectangle", 4, 4)
    Fact(claim='sides of the rectangle', found='4', holds=True)
    """
    return Fact(claim, _shown(found), found == expected)


def _shown(value: object) -> str:
    if isinstance(value, list | tuple):
        return ", ".join(map(_shown, value))
    return str(value)


def half_unit(printed: str) -> Fraction:
    """Return how far a number may be from its printed decimal: half of the last place.

    Examples
    --------
    >>> half_unit("16.0"), half_unit("0.12")
    (Fraction(1, 20), Fraction(1, 200))
    """
    return Fraction(1, 2 * 10 ** len(printed.partition(".")[2]))


def fraction(text: str) -> Fraction:
    """Return the exact value of a printed decimal, which may begin with its point.

    Examples
    --------
    >>> fraction(".25")
    Fraction(1, 4)
    """
    value = rational(text)
    return Fraction(int(value.numerator), int(value.denominator))


def places(value: Fraction, digits: int = 3) -> str:
    """Return a rational number of an argument, correctly rounded.

    Examples
    --------
    >>> places(Fraction(4) / Fraction("0.365"))
    '10.959'
    """
    return rational_decimal(rational(value), digits)


def middles(plan: FeedingPlan) -> list[Angle]:
    """Return twice the middles of the ranges of all actions but the first."""
    return [a.low + a.high for a in plan.actions if a.low is not None and a.high is not None]


def halves(doubled: Iterable[Angle]) -> tuple[Angle, ...]:
    """Return directions within a millionth of a turn of half of each angle."""
    return tuple(near_half(d)[0] if d >= ZERO else -near_half(-d)[0] for d in doubled)
