"""What a list of angles does to a part, and how far each angle may move.

The prior is uniform, the angles are those of `stochgeom.feeding.plans`: action j turns a state
theta to theta - alpha_j before the jaws close. Everything is exact.

The mouth. After all actions the orientations of a period are divided into arcs between breaks,
each of which ends in one orientation (`stochgeom.feeding.propagation`). The first action turns
the uniform prior, so these arcs move by alpha_0 and keep their widths. The widest is the plan's
mouth, the orientations that it feeds.

Margins. Before action j >= 1 the mouth has become the closed arc [u, v], both ends taken. Action j
and those after it take an arc [p, q) of turned orientations to the final orientation, and nothing
else near it, for all of this is monotone. So with the other actions as they are the mouth ends
where it does for just the angles with p <= u - alpha and v - alpha < q, that is low < alpha <= high

    low = v - q,    high = u - p,

and both ends are sharp. These ranges are not independent; those of a planned `Action`, which are,
lie inside them. A mouth of a full turn has no ends: it ends in one orientation if all states before
action j, modulo a full turn, are turned into [p, q), and (low, high] is the range around alpha_j
for which they are; if [p, q) is a full turn, that is all angles.

The first misfit. Phase I knows h_k, the widest arc that k actions collapse (thesis Thm 5.1). If
the mouth is narrower, at least one angle is to blame. Follow all arcs of width h_k whose images are
narrower than h_{k-1}: those that some k actions collapse. Action j fits if it turns the image of
one of them, which fitted so far, into an arc of width h_{k-j} that k - j actions can collapse. The
first action that does not fit is the first from which no arc of width h_k can be rescued in the
way of phase I. If all fit, such an arc is collapsed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.intervals import inward_decimals
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.actions import both_ends
from stochgeom.feeding.nearby_courses import PartErrorReport
from stochgeom.feeding.preimages import Preimages
from stochgeom.feeding.propagation import Outcome, outcomes
from stochgeom.transfer.step_function import StepFunction

Steps = tuple[int, int]
"""Numbers of the first and the last step, or value, of an arc."""


@final
@dataclass(frozen=True, slots=True)
class CollapsedArc:
    """An arc of orientations before the first action, and where the plan takes all of them.

    Attributes
    ----------
    arc : Arc
        Half open, its start in [0, T).
    orientation : Angle
        The final orientation, in [0, 360) degrees.
    """

    arc: Arc
    orientation: Angle


@final
@dataclass(frozen=True, slots=True)
class Margin:
    """How far the angle of one action can move while the others stay.

    Attributes
    ----------
    angle : Angle
        The angle of the plan.
    low, high : Angle or None
        The mouth ends where it does for the angles in (low, high], and for no others near by. None
        for the first action, which under a uniform prior may turn as it likes.
    """

    angle: Angle
    low: Angle | None
    high: Angle | None

    def decimals(self, digits: int = 4) -> tuple[str, str, str]:
        """Return angle, low and high in degrees, the ends rounded inwards.

        With more digits than asked for, if the range is narrower than one of the last of them.

        Raises
        ------
        InputError
            If the action has no range.

        Examples
        --------
        >>> Margin(Angle(0, (1, 1)), Angle(0, (3, 1)), Angle(0, (1, 3))).decimals(2)
        ('45.00', '18.44', '71.56')
        """
        ends = both_ends(self.angle, self.low, self.high)
        return self.angle.degrees(digits), *inward_decimals(*ends, digits)

    @property
    def below(self) -> Angle | None:
        """By how much the angle can fall; at this much it is too low. None if it is free."""
        return None if self.low is None else self.angle - self.low

    @property
    def above(self) -> Angle | None:
        """By how much the angle can rise, at most. None if it is free."""
        return None if self.high is None else self.high - self.angle


@final
@dataclass(frozen=True, eq=False, repr=False)
class PlanReport:
    """What a list of actions does to a part under a uniform prior.

    Made by `verify_plan`.

    Attributes
    ----------
    transfer : StepFunction
        Of every action.
    angles : tuple of Angle
        Of the actions, each relative to the gripper's last pose.
    cost_ratio : mpq
        c, the cost of the filter over the cost of an action.
    outcome : Outcome
        The hyperstate after all actions, as step numbers; the first angle is taken as 0.
    preimages : Preimages
        Phase I for the same transfer function.
    part_errors : PartErrorReport or None
        What is proven for parts whose vertices are off, if that was asked.
    """

    transfer: StepFunction
    angles: tuple[Angle, ...]
    cost_ratio: mpq
    outcome: Outcome
    preimages: Preimages
    part_errors: PartErrorReport | None = None

    @property
    def steps(self) -> int:
        """k, the number of actions."""
        return len(self.angles)

    # --- what it does ----------------------------------------------------------------------------

    @cached_property
    def collapsed(self) -> tuple[CollapsedArc, ...]:
        """The arcs of one period that end in one orientation each, by increasing start.

        Those of the other periods follow: an arc moved by T ends T further on.
        """
        arcs = [self._collapsed_arc(place) for place in range(len(self.outcome.states))]
        return tuple(sorted(arcs, key=lambda item: item.arc.start))

    @cached_property
    def _mouth_place(self) -> int:
        """The place of the mouth in the outcome: of the widest arcs, the one of smallest start."""
        outcome, breaks = self.outcome, self.transfer.lifted_breaks
        widest: list[int] = breaks.widest(outcome.starts, outcome.ends).tolist()
        return min(widest, key=lambda place: self._collapsed_arc(place).arc.start)

    def _collapsed_arc(self, place: int) -> CollapsedArc:
        transfer, outcome = self.transfer, self.outcome
        breaks, first = transfer.lifted_breaks, int(outcome.starts[place])
        width = breaks[int(outcome.ends[place])] - breaks[first]
        laps, start = divmod(breaks[first] + self.angles[0].reduced(), transfer.period)
        state = int(outcome.states[place]) - laps * len(transfer)
        return CollapsedArc(Arc(start, width), transfer.lifted_values[state].reduced())

    @property
    def mouth(self) -> Arc:
        """The widest arc that ends in one orientation; of equal ones that of smallest start."""
        return self._collapsed_arc(self._mouth_place).arc

    @property
    def final_orientation(self) -> Angle:
        """Where the mouth ends, in [0, 360) degrees."""
        return self._collapsed_arc(self._mouth_place).orientation

    @property
    def final_orientations(self) -> int:
        """The number of different final orientations over a full turn."""
        return len(self.outcome)

    @property
    def hyperstate(self) -> Hyperstate:
        """The final orientations with the exact measures of what ends in each."""
        return self.outcome.hyperstate()

    @property
    def orients_up_to_symmetry(self) -> bool:
        """Whether the final orientations are exactly 2 pi / T equally spaced ones (Def. 4.3)."""
        return len(self.outcome.states) == 1

    # --- what it is worth ------------------------------------------------------------------------

    @property
    def probability(self) -> TurnRatio:
        """Probability of the most likely final orientation: mouth / (2 pi)."""
        return TurnRatio(mpq(1), self.mouth.width)

    @property
    def probability_up_to_symmetry(self) -> TurnRatio:
        """Probability of any of the 2 pi / T orientations equivalent to it."""
        return TurnRatio(mpq(self.transfer.order), self.mouth.width)

    @property
    def expected_cost(self) -> TurnRatio:
        """(k + c) 2 pi / mouth, until that orientation is accepted (Eq. 4.5)."""
        return TurnRatio(self.steps + self.cost_ratio, self.mouth.width, inverse=True)

    @property
    def expected_cost_up_to_symmetry(self) -> TurnRatio:
        """(k + c) T / mouth: the cost when any of the equivalent orientations is accepted."""
        per_round = (self.steps + self.cost_ratio) / self.transfer.order
        return TurnRatio(per_round, self.mouth.width, inverse=True)

    @cached_property
    def best_width(self) -> Angle:
        """h_k: no plan of k actions collapses a wider arc, and one collapses one as wide."""
        return self.preimages.of_steps(self.steps).width

    @property
    def best_probability(self) -> TurnRatio:
        """Probability of one final orientation after the best plan of as many actions."""
        return TurnRatio(mpq(1), self.best_width)

    @property
    def better_exists(self) -> bool:
        """Whether another plan of as many actions has a larger probability."""
        return self.mouth.width < self.best_width

    # --- how it does it --------------------------------------------------------------------------

    @cached_property
    def margins(self) -> tuple[Margin, ...]:
        """For each action the exact range of angles for which the mouth ends where it does."""
        transfer = self.transfer
        breaks, values = transfer.lifted_breaks, transfer.lifted_values
        angles, images = within_a_turn(self.angles), self._images()
        whole_circle = self.mouth.width == FULL_TURN
        found = []
        p, q = breaks[images[-1][0]], breaks[images[-1][0] + 1]
        for j in range(self.steps - 1, 0, -1):
            # Action j and those after it take just the turned orientations [p, q) to the end.
            places = [values[k] - angles[j] - p for k in images[j - 1]]
            if whole_circle:
                places = [place % FULL_TURN for place in places]
            if q - p == FULL_TURN:
                places = places[:1]
            alpha = self.angles[j]
            found.append(Margin(alpha, alpha + max(places) - (q - p), alpha + min(places)))
            before = transfer.preimage(Arc(p + angles[j], q - p))
            assert before is not None  # the image of the mouth is in it
            p, q = before.start, before.end
        return (Margin(self.angles[0], None, None), *reversed(found))

    def _images(self) -> list[Sequence[int]]:
        """Return what the mouth becomes after each action, as numbers of values.

        Its two ends suffice; of a whole circle, which has none, all states.
        """
        angles, place = within_a_turn(self.angles), self._mouth_place
        if self.mouth.width == FULL_TURN:
            return [outcome.states.tolist() for outcome in outcomes(self.transfer, angles)]
        image = int(self.outcome.starts[place]), int(self.outcome.ends[place]) - 1
        images: list[Sequence[int]] = [image]
        for alpha in angles[1:]:
            image = self._act(image, alpha)
            images.append(image)
        return images

    def _act(self, image: Steps, alpha: Angle) -> Steps:
        """Return the image of an image, as numbers of values."""
        transfer = self.transfer
        first, last = (transfer.step_at(transfer.lifted_values[k] - alpha) for k in image)
        return first, last

    @cached_property
    def first_misfit(self) -> int | None:
        """The first action, counted from 0, that turns no arc of width h_k into its next goal.

        None if the plan collapses an arc of that width. Defined in the module's docstring.
        """
        if not self.better_exists:
            return None
        m, angles = len(self.transfer), within_a_turn(self.angles)
        images = self._widest_arcs(self.steps)
        for j in range(1, self.steps):
            goals = self._widest_arcs(self.steps - j)
            turned = {self._act(image, angles[j]) for image in images}
            # Steps first..last lie in steps a..b of some period if they do in the one of `first`.
            images = [
                (first, last)
                for first, last in turned
                if any((first - a) % m + last - first <= b - a for a, b in goals)
            ]
            if not images:
                return j
        raise AssertionError("a plan that fits in every action collapses h_k")  # pragma: no cover

    def _widest_arcs(self, steps: int) -> list[Steps]:
        """Return all arcs of width h_i, as steps, that i actions can collapse."""
        transfer = self.transfer
        if steps == 1:
            last = np.arange(len(transfer))
        else:
            last = transfer.lifted_values.last_below(self.preimages.of_steps(steps - 1).width)
        widest = transfer.lifted_breaks.largest_gaps(last).tolist()
        return [(first, int(last[first])) for first in widest]

    def __repr__(self) -> str:
        return (
            f"<PlanReport: {self.steps} action{'s' if self.steps != 1 else ''}, "
            f"{self.final_orientations} final orientation"
            f"{'s' if self.final_orientations != 1 else ''}, probability {self.probability}>"
        )


def within_a_turn(angles: tuple[Angle, ...]) -> list[Angle]:
    """Return the angles modulo a full turn, which is all that a gripper knows of them."""
    return [angle if ZERO <= angle < FULL_TURN else angle.reduced() for angle in angles]
