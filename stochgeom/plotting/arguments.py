"""What drawing functions accept, with the errors of what they do not."""

from __future__ import annotations

from typing import Any, Final, TypeAlias

from stochgeom.arguments import expect
from stochgeom.errors import InputError, NumberLimitError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.geometry.part import Part
from stochgeom.plotting.scene import shortened

MOST_TURNS: Final = 10

SMALLEST_DRAWN: Final = 1e-200
LARGEST_DRAWN: Final = 1e200
"""Sizes between which floats hold a number, and what a picture makes of it."""

DRAWN_SIZES: Final = f"from {SMALLEST_DRAWN:g} to {LARGEST_DRAWN:g}"

_DIGITS: Final = 40
"""Of a number in a message."""

Orientation: TypeAlias = "Angle | RationalLike"
"""An angle, or degrees as an exact number or text."""


def as_angle(theta: Orientation) -> Angle:
    """Return an angle as it is, or of degrees.

    Examples
    --------
    >>> as_angle("22.5").degrees(1)
    '22.5'
    """
    if isinstance(theta, Angle):
        return theta
    return Angle.from_turns(rational(theta, where="degrees") / 360)


def is_drawn(number: Any) -> bool:
    """Tell whether floats hold a positive number, and what a picture makes of it.

    Examples
    --------
    >>> is_drawn(3), is_drawn(10**400)
    (True, False)
    """
    try:
        return SMALLEST_DRAWN < float(number) < LARGEST_DRAWN
    except (OverflowError, NumberLimitError):
        return False


def as_drawn(number: Any, where: str) -> float:
    """Return an exact number in floats, to be drawn.

    Raises
    ------
    NumberLimitError
        If floats do not hold it.

    Examples
    --------
    >>> as_drawn(-3, "edge 1")
    -3.0
    """
    if number and not is_drawn(abs(number)):
        raise NumberLimitError(
            f"{shortened(str(number), _DIGITS)} is no number to draw; accepted: 0, or sizes "
            f"{DRAWN_SIZES}",
            where=where,
        )
    return float(number)


def part_of(plan: FeedingPlan) -> Part:
    """Return the part of a plan.

    Raises
    ------
    InputError
        If this is no plan, or one for a transfer function without a part.
    """
    plan = expect(plan, FeedingPlan, "a plan, such as plan_feeding(part)")
    if plan.part is None:
        raise InputError("a plan of a transfer function has no part to draw; accepted: a part's")
    return plan.part
