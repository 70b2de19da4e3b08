"""How a part and the gripper move while a plan is carried out: the key frames of an animation.

The picture is taken from above. The gripper turns about the middle of the picture and the part
about its own middle, which stays there: all that changes is angles, and the distances of the two
jaws from the middle. Time counts actions: at time k the k-th action is over. Within an action the
jaws open, the gripper turns, the jaws close until they touch, and then turn the part.

The angles of key frames are decimals of exact angles. While the jaws turn the part their distances
are samples, between which they move evenly. A picture decides nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import ceil, pi
from typing import TYPE_CHECKING, Final, final

import numpy as np

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.plotting.silhouettes import Silhouette, silhouette
from stochgeom.transfer.push import push_function
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.feeding.plans import FeedingPlan
    from stochgeom.geometry.part import Part

OPEN: Final = 1.14
"""How far an open jaw stands from the middle; the part has radius 1."""

DECIMALS: Final = 4
"""Of the angles in degrees."""

# The share of an action's time at which so much of it is done. After the last of them nothing
# moves: whole times are inside a pause.
_OPENED, _TURNED, _TOUCHED, _CLOSED = 0.12, 0.42, 0.54, 0.92
_PUSHED, _TOUCHED_BY_BOTH = 0.72, 0.78

_SAMPLE: Final = 7.5 * pi / 180
"""Radians between samples of a jaw's distance."""


@final
@dataclass(frozen=True, slots=True)
class KeyFrame:
    """The picture at one time.

    Attributes
    ----------
    time : float
        In actions, from 0.
    gripper, part : str
        Degrees counter-clockwise, of the gripper from where it was before the first action; None
        where they move evenly between the key frames around this one.
    lower, upper : float
        The distances of the jaws from the middle.
    """

    time: float
    gripper: str | None
    part: str | None
    lower: float
    upper: float


@final
class Hold:
    """What the jaws do to a part: where they touch it, and where a push turns it.

    Parameters
    ----------
    part : Part
        Drawn with radius 1.

    Examples
    --------
    >>> from stochgeom.geometry.part import Part
    >>> Hold(Part([(0, 0), (8, 0), (8, 6), (0, 6)])).touching(0.0)
    (0.6, 0.6)
    """

    def __init__(self, part: Part) -> None:
        self.part = part
        self.shape: Silhouette = silhouette(part)

    @cached_property
    def push(self) -> StepFunction:
        """Where a push by the lower jaw alone turns the part."""
        return push_function(self.part)

    def touching(self, theta: float) -> tuple[float, float]:
        """Return how far from the middle the lower and the upper jaw touch, at radians."""
        heights = self.shape.hull @ np.array([np.sin(theta), np.cos(theta)])
        return float(-heights.min()), float(heights.max())


@final
class Trace:
    """One part on its way through a plan.

    Parameters
    ----------
    plan : FeedingPlan
        What is done: squeezes or push-grasps.
    hold : Hold
        Of the plan's part.
    start : Angle
        The orientation before the first action.

    Attributes
    ----------
    states : tuple of Angle
        The orientation relative to the gripper before the first action and after each one.
    grippers, poses : tuple of Angle
        The gripper and the part on the table, at the same times.
    """

    def __init__(self, plan: FeedingPlan, hold: Hold, start: Angle) -> None:
        self.plan, self.start = plan, start
        self.hold = hold
        self.states = plan.execute(start)
        self.grippers = (ZERO, *plan.cumulative_angles)
        self.poses = tuple(s + g for s, g in zip(self.states, self.grippers, strict=True))

    def frames(self, actions: int) -> list[KeyFrame]:
        """Return the key frames of the first so many actions, their times increasing strictly.

        Examples
        --------
        >>> from stochgeom.feeding.planner import orient_up_to_symmetry
        >>> plan = orient_up_to_symmetry([(0, 0), (3, 0), (3, 2), (0, 2)])
        >>> trace = Trace(plan, Hold(plan.part), Angle.from_degrees(20))
        >>> [(f.time, f.part) for f in trace.frames(2) if f.time in (0.0, 1.0, 2.0)]
        [(0.0, '20.0000'), (1.0, '0.0000'), (2.0, '-45.0000')]
        """
        frames = [KeyFrame(0.0, *self._angles(0, self.poses[0]), OPEN, OPEN)]
        for k in range(actions):
            frames.extend(self._action(k))
        return frames

    def _action(self, k: int) -> Iterator[KeyFrame]:
        """Yield the frames of action k, counted from 0, after the one at time k."""
        pose, alpha = self.poses[k], self.plan.angles[k]
        yield KeyFrame(k + _OPENED, *self._angles(k, pose), OPEN, OPEN)
        yield KeyFrame(k + _TURNED, *self._angles(k + 1, pose), OPEN, OPEN)
        turned, end = self.states[k] - alpha, self.states[k + 1]
        if self.plan.action_name == "push-grasp":
            pushed = self.hold.push(turned)
            yield from self._closing(k, turned, pushed, (_TOUCHED, _PUSHED), one_jaw=True)
            turned, begins = pushed, _TOUCHED_BY_BOTH
        else:
            begins = _TOUCHED
        yield from self._closing(k, turned, end, (begins, _CLOSED))
        yield KeyFrame(
            k + 1.0, *self._angles(k + 1, self.poses[k + 1]), *self.hold.touching(end.to_float())
        )

    def _closing(
        self,
        k: int,
        start: Angle,
        end: Angle,
        times: tuple[float, float],
        *,
        one_jaw: bool = False,
    ) -> Iterator[KeyFrame]:
        """Yield the frames while jaws that touch the part turn it, relative to the gripper."""
        first, turn = start.to_float(), (end - start).to_float()
        samples = max(1, ceil(abs(turn) / _SAMPLE))
        for sample in range(samples + 1):
            share = sample / samples
            lower, upper = self.hold.touching(first + share * turn)
            state = {0: start, samples: end}.get(sample)
            yield KeyFrame(
                k + times[0] + share * (times[1] - times[0]),
                None if state is None else self.grippers[k + 1].degrees(DECIMALS),
                None if state is None else (state + self.grippers[k + 1]).degrees(DECIMALS),
                lower,
                OPEN if one_jaw else upper,
            )

    def _angles(self, k: int, pose: Angle) -> tuple[str, str]:
        return self.grippers[k].degrees(DECIMALS), pose.degrees(DECIMALS)
