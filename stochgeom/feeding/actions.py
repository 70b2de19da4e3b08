"""Actions of a plan, with the exact range of angles that each works for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import final

from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.decimals import Rounding, rational_decimal, significant
from stochgeom.exact.directions import nominal_inside


@final
@dataclass(frozen=True)
class Action:
    """Turn the gripper by an angle relative to its last pose, close, open.

    Attributes
    ----------
    low, high : Angle or None
        The action does its work for every angle in (low, high], whatever the other actions do
        inside their ranges. None for the first turn: any angle does the same under a uniform
        prior, and under another one `free_angle` is where the mouth catches most.
    margin : Angle
        delta: the angle is chosen so that delta more and delta less are in the range as well.
    free_angle : Angle
        The angle of an action without a range.
    """

    low: Angle | None
    high: Angle | None
    margin: Angle = ZERO
    free_angle: Angle = ZERO

    @cached_property
    def angle(self) -> Angle:
        """The simplest rational direction near the middle of the range; `free_angle` without."""
        if self.low is None or self.high is None:
            return self.free_angle
        return nominal_inside(self.low, self.high, self.margin)

    @property
    def tolerance(self) -> Angle | None:
        """The width of the range; None if the angle is free."""
        return None if self.low is None or self.high is None else self.high - self.low

    def decimals(self, digits: int = 4) -> tuple[str, str, str]:
        """Return angle, low and high in degrees, so that the decimals work as they stand.

        The range is rounded inwards, and the angle lies inside the rounded range with the margin
        to both sides, with more digits than asked for if need be: who types in what is printed
        gets a plan that works.

        Raises
        ------
        InputError
            If the action has no range.

        Examples
        --------
        >>> Action(Angle(0, (3, 1)), Angle(0, (1, 3))).decimals(2)
        ('45.00', '18.44', '71.56')
        """
        lower, upper = both_ends(self.angle, self.low, self.high)
        # It ends: a rational margin meets an end of the range only if it is an eighth of a turn or
        # so, for ranges and angles are rational directions; such a meeting is seen in every
        # decimal.
        while True:
            low = lower.degrees(digits, Rounding.UP)
            high = upper.degrees(digits, Rounding.DOWN)
            angle = self.angle.degrees(digits)
            first, typed, last = (Angle.from_turns(mpq(text) / 360) for text in (low, angle, high))
            # At the upper end itself the printed plan would bear no error at all.
            if first < typed - self.margin and typed + self.margin <= last and typed < last:
                return angle, low, high
            digits += 1


def both_ends(angle: Angle, low: Angle | None, high: Angle | None) -> tuple[Angle, Angle]:
    """Return the ends of an action's range.

    Raises
    ------
    InputError
        If it has none.

    Examples
    --------
    >>> both_ends(Angle(), None, None)
    Traceback (most recent call last):
    ...
    stochgeom.errors.InputError: the action at 0.0000° has no range; accepted: one with both ends
    """
    if low is None or high is None:
        raise InputError(f"the action at {angle} has no range; accepted: one with both ends")
    return low, high


def printed_margin(actions: Iterable[Action], digits: int = 4) -> str | None:
    """Return the least distance of a printed angle from a printed end of its range.

    In degrees, rounded down, with as many digits as show that it is not 0; None if no action has a
    range.

    Examples
    --------
    >>> printed_margin([Action(None, None), Action(Angle(0, (3, 1)), Angle(0, (1, 3)))])
    '26.5650'
    """
    distances: list[mpq] = []
    for action in actions:
        if action.low is not None and action.high is not None:
            angle, low, high = map(mpq, action.decimals(digits))
            distances += [angle - low, high - angle]
    if not distances:
        return None
    least = min(distances)  # above 0: a printed angle is below its printed upper end
    return significant(lambda d: rational_decimal(least, d, Rounding.DOWN), digits)
