"""Actions of a plan, with the exact range of angles that each works for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import final

from stochgeom.exact.angles import ZERO, Angle
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
