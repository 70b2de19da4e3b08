"""Actions of a plan, with the exact range of angles that each works for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import final

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.directions import nominal_angle


@final
@dataclass(frozen=True)
class Action:
    """Turn the gripper by an angle relative to its last pose, close, open.

    Attributes
    ----------
    low, high : Angle or None
        The action does its work for every angle in (low, high], whatever the other actions do
        inside their ranges. None for the random first turn.
    """

    low: Angle | None
    high: Angle | None

    @cached_property
    def angle(self) -> Angle:
        """The simplest rational direction near the middle of the range; 0 if it is free."""
        if self.low is None or self.high is None:
            return ZERO
        return nominal_angle(self.low, self.high)

    @property
    def tolerance(self) -> Angle | None:
        """The width of the range; None if the angle is free."""
        return None if self.low is None or self.high is None else self.high - self.low
