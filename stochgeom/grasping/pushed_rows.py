"""What becomes of one orientation in a grasp under the uniform pushing model.

If a jaw touches first, the orientation at which the second one touches is uniform between the
initial one and the stable one ahead (thesis App. C). So the share of each outcome is the share of
its preimage under the squeeze on that way: a ratio of two angles.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from gmpy2 import mpq

from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.cells import merge
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability


@final
@dataclass(frozen=True, slots=True)
class Share:
    """The number part / whole, of two angles with 0 < part < whole."""

    part: Angle
    whole: Angle

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        return self.part.ball() / self.whole.ball()


@final
class PushedRows:
    """Shares of the outcomes of any initial orientation, for one jaw that touches first.

    Parameters
    ----------
    push : PushStability
        The jaw.
    squeeze : SqueezeStability
        What follows.
    """

    def __init__(self, push: PushStability, squeeze: SqueezeStability) -> None:
        self._push, self._squeeze = push, squeeze
        angles = merge(push.critical, squeeze.angles)
        place = {angle: k for k, angle in enumerate(angles)}
        outcomes = squeeze.outcome_numbers(angles)
        self._ways: dict[tuple[Angle, int], list[tuple[Angle, int]]] = {}
        for stable, unstable, step in push.sides:
            way = _way(angles, outcomes, place[stable], place[unstable], step)
            self._ways[stable, step] = way

    def shares(self, theta: Angle) -> dict[int, tuple[Angle, Angle]]:
        """Return for each outcome with a positive share (part, whole), two angles.

        Parameters
        ----------
        theta : Angle
            An initial orientation, but for an unstable equilibrium.

        Returns
        -------
        dict
            By outcome: a transition of the contacts, or `WEDGED`. At a stable orientation the
            outcome of a squeeze from there, with (360, 360) degrees.
        """
        valley = self._push.valley_of(theta)
        order = theta.compare(valley.stable)
        if order == 0:
            (outcome,) = self._squeeze.outcomes_at(valley.stable.reduced())
            return {outcome: (FULL_TURN, FULL_TURN)}
        whole = theta - valley.stable if order > 0 else valley.stable - theta
        parts: dict[int, Angle] = {}
        start = Angle()
        for end, outcome in self._ways[valley.stable.reduced(), order]:
            last = min(end, whole)
            parts[outcome] = parts.get(outcome, Angle()) + (last - start)
            if whole <= end:
                break
            start = end
        return {outcome: (part, whole) for outcome, part in parts.items()}


def _way(
    angles: list[Angle], outcomes: list[tuple[int, ...]], first: int, last: int, step: int
) -> list[tuple[Angle, int]]:
    """Return (way from the stable orientation, outcome of the arc that ends there), outwards."""
    m, k, found = len(angles), first, []
    while k != last:
        (outcome,) = outcomes[k if step > 0 else k - 1]  # open arcs have one outcome
        k = (k + step) % m
        way = angles[k] - angles[first] if step > 0 else angles[first] - angles[k]
        found.append((way.reduced(), outcome))
    return found


def as_probability(share: tuple[Angle, Angle]) -> Probability:
    """Return part / whole as a number, exact where it is rational for plain reasons.

    Examples
    --------
    >>> as_probability((Angle(0, (3, 2)), Angle.from_degrees(90))).decimal()
    '0.3743'
    """
    part, whole = share
    if part == whole:
        return AngleSum(1)
    turns, all_turns = part.rational_turns, whole.rational_turns
    if all_turns is not None:
        return (
            AngleSum(0, [(1 / all_turns, part)]) if turns is None else AngleSum(turns / all_turns)
        )
    number = Share(part, whole)
    return Enclosed([(mpq(1), Atom(number, number.ball))])
