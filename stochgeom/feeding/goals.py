"""Final orientations to choose: by angle, or the most stable one.

An action leaves a part in one of the values of its transfer function, and equivalent orientations
cannot be told apart: a goal is one of these values, modulo the period. People read angles off
tables, so an angle within half a degree of a final orientation names it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypeAlias

from stochgeom.errors import GoalError, NumberError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.stability import stabilities
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.geometry.part import Part

MOST_STABLE: Final = "most stable"

Goal: TypeAlias = "Angle | RationalLike | tuple[Angle | RationalLike, ...]"
"""An exact angle, degrees as an exact number or text, "most stable", or a tuple: any of these."""

NEAR: Final = Angle.from_degrees("1/2")

_SHOWN: Final = 12


def final_steps(goal: Goal, transfer: StepFunction, part: Part | None) -> tuple[int, ...]:
    """Return the numbers of the steps, in one period, whose value is the goal.

    Parameters
    ----------
    goal : Angle, degrees as text, or "most stable"
        The most stable grasps may be several equal ones: then each of them will do.
    transfer : StepFunction
        Of the action.
    part : Part or None
        Whose grasps are meant; needed for the most stable ones.

    Raises
    ------
    GoalError
        If no final orientation is within half a degree, or stability is asked of no part.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> s = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> final_steps("90", s, None), final_steps("89.7", s, None)
    ((0,), (0,))
    """
    if isinstance(goal, tuple):
        if not goal:
            raise GoalError("no goals; accepted: one or more, or None for any", where="goal")
        return tuple(sorted({k for one in goal for k in final_steps(one, transfer, part)}))
    if goal == MOST_STABLE:
        return _most_stable(transfer, part)
    if not isinstance(goal, Angle):
        try:
            goal = Angle.from_degrees(goal)
        except NumberError as error:
            fault = error.message.partition("; accepted")[0]
            raise GoalError(
                f"{fault}; accepted: an angle in degrees, or {MOST_STABLE!r}", where="goal"
            ) from error
    distances = [_distance(value, goal, transfer.period) for value in transfer.values]
    nearest = min(distances)
    if nearest > NEAR:
        raise GoalError(
            f"{goal} is {nearest} from the nearest final orientation; accepted, modulo "
            f"{transfer.period}: {_listed(transfer)}",
            where="goal",
        )
    return tuple(k for k, distance in enumerate(distances) if distance == nearest)


def _distance(a: Angle, b: Angle, period: Angle) -> Angle:
    ahead = (a - b) % period
    return min(ahead, period - ahead)


def _listed(transfer: StepFunction) -> str:
    angles = sorted(value % transfer.period for value in transfer.values)
    more = ", ..." if len(angles) > _SHOWN else ""
    return ", ".join(str(angle) for angle in angles[:_SHOWN]) + more


def _most_stable(transfer: StepFunction, part: Part | None) -> tuple[int, ...]:
    if part is None:
        raise GoalError(
            f"{MOST_STABLE!r} asks for a part, and there is only a transfer function; accepted: "
            "an angle",
            where="goal",
        )
    found = stabilities(part, transfer.values)
    best = max(found)
    return tuple(k for k, value in enumerate(found) if value == best)
