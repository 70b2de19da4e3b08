"""What a plan does to all parts near a part: the proof.

What is claimed, and why it is true, is in `stochgeom.feeding.part_errors`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final, final

from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.algebraic_directions import exact_direction
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.outer_arcs import TURN, Units, units_around
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.surds import Scalar
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.geometry.center_error import CenterError
from stochgeom.geometry.contact_zones import ContactZones, push_zones, squeeze_zones
from stochgeom.geometry.near_contacts import NearbyParts
from stochgeom.geometry.part import Part
from stochgeom.transfer.step_function import StepFunction

ACTIONS: Final = ("squeeze", "push-grasp")
"""The actions for which part errors are understood."""


@final
@dataclass(frozen=True, slots=True)
class PartErrorReport:
    """What is proven of a plan for all parts near a part.

    Attributes
    ----------
    vertex_error : mpq
        epsilon: no vertex is farther from its place.
    proven : bool
        Whether the plan is proven to work for every such part. False says only that this proof
        fails.
    starts : tuple of Arc
        The starts for which it is: most of the mouth, and of each of its equivalents. For squeezes
        those in half a turn; half a turn on, the same holds. Empty if nothing is proven.
    finals : tuple of ClosedArc
        For each of `starts` an arc that holds the final orientations. If the mouth is a whole
        period, starts next to its ends may end in the arc before or after instead.
    one_orientation : bool
        Whether, moreover, each such part has exactly one orientation in each of `finals`: no
        second edge can lie flush beside the first.
    reason : str or None
        Why the proof fails.
    """

    vertex_error: mpq
    proven: bool
    starts: tuple[Arc, ...] = ()
    finals: tuple[ClosedArc, ...] = ()
    one_orientation: bool = False
    reason: str | None = None

    @property
    def probability(self) -> mpq:
        """A lower bound for the probability of each final state under a uniform prior."""
        return min((_turns_at_most(arc.width) for arc in self.starts), default=mpq(0))


def _turns_at_most(angle: Angle) -> mpq:
    exact = angle.rational_turns
    return mpq(units_around(angle)[0], TURN) if exact is None else exact


@final
class NearbyCourses:
    """A plan on its way through all parts near a part: what is proven for an epsilon.

    Parameters
    ----------
    part : Part
        The part as it should be.
    transfer : StepFunction
        Of every action on it.
    angles : sequence of Angle
        Of the actions, each relative to the gripper's last pose.
    mouth : Arc
        Starts that the actions take to one orientation of the part.
    final_orientation : Angle
        That orientation.
    action : str, default "squeeze"
        What the gripper does.
    gripper_errors : (Angle, Angle), default none
        By how much the first action and each other one may be off, either way.

    Raises
    ------
    InputError
        If the action is another one.
    """

    def __init__(
        self,
        part: Part,
        transfer: StepFunction,
        angles: Sequence[Angle],
        mouth: Arc,
        final_orientation: Angle,
        *,
        action: str = "squeeze",
        gripper_errors: tuple[Angle, Angle] = (ZERO, ZERO),
    ) -> None:
        if action not in ACTIONS:
            raise InputError(
                f"vertex errors with the action {action!r}; accepted: {', '.join(ACTIONS)}",
                where="plan",
            )
        self.mouth, self.final, self.pushes = mouth, final_orientation, action == "push-grasp"
        self.first_angle, self.first_error = angles[0], gripper_errors[0]
        self.is_period = mouth.width == transfer.period
        # Squeezes repeat after half a turn, whatever the part; push-grasps after a full turn.
        count = transfer.order if self.pushes else transfer.order // 2
        self.shifts = [transfer.period * k for k in range(count)]
        start = mouth.start - self.first_angle - self.first_error
        end = mouth.end - self.first_angle + self.first_error
        # The mouth and its equivalents as the jaws meet them first.
        self.turned_mouths = [
            (units_around(start + shift)[0], units_around(end + shift)[1]) for shift in self.shifts
        ]
        known: dict[Angle, Units] = {}
        for angle in angles[1:]:
            if angle not in known:
                turn, error = angle.reduced(), gripper_errors[1]
                known[angle] = units_around(turn - error)[0], units_around(turn + error)[1]
        self.turns = [known[angle] for angle in angles[1:]]
        self.near, self.center = NearbyParts(part), CenterError(part)

    @classmethod
    def of_plan(cls, plan: FeedingPlan, part: Part) -> NearbyCourses:
        """Return those of a plan, its gripper error included."""
        first_error = ZERO if plan.prior is None else plan.gripper_error
        return cls(
            part,
            plan.transfer,
            plan.angles,
            plan.mouth,
            plan.final_orientation,
            action=plan.action_name,
            gripper_errors=(first_error, plan.gripper_error),
        )

    # --- the proof -------------------------------------------------------------------------------

    def report(self, vertex_error: RationalLike) -> PartErrorReport:
        """Return what is proven for a vertex error.

        Raises
        ------
        InputError
            If it is negative.
        NumberError
            If it is not an exact number.
        """
        epsilon = rational(vertex_error, where="vertex error")
        if epsilon < 0:
            raise InputError(f"{epsilon}; accepted: 0 or more", where="vertex error")
        return self._prove(epsilon) if epsilon else self._exact_report()

    def _exact_report(self) -> PartErrorReport:
        """Return the report for the part itself, of which all is known."""
        return PartErrorReport(
            mpq(0),
            True,
            tuple(self.mouth.rotate(shift) for shift in self.shifts),
            tuple(ClosedArc((self.final + shift).reduced(), ZERO) for shift in self.shifts),
            True,
        )

    def _prove(self, epsilon: mpq) -> PartErrorReport:
        if 4 * epsilon * epsilon >= self.final_clearance:
            return _unproven(epsilon, "another vertex may touch a jaw in the final orientation")
        motions = self._motions(epsilon)
        if motions is None:
            return _unproven(epsilon, "nothing is certain of where such a part turns")
        first, period = motions[0], motions[0].period
        arcs = [arc for mouth in self.turned_mouths if (arc := _certain_starts(first, mouth))]
        images = [first.image(arc) for arc in arcs]
        following = [*images[1:], *((low + period, high + period) for low, high in images[:1])]
        if len(arcs) < len(self.shifts) or (
            self.is_period and any(map(first.rest_between, images, following))
        ):
            return _unproven(epsilon, "a part may rest at an end of the mouth")
        starts = [start for start in map(self._starts, self.shifts, arcs) if start is not None]
        if len(starts) < len(arcs):
            return _unproven(epsilon, "no start is certain if the first action may be off")
        finals = [self._run(motions, image) for image in images]
        reached = [motions[-1].resting_on(final_arc) for final_arc in finals]
        for place, final_arc in enumerate(finals):
            if not self._is_final_state(place, final_arc, reached[place]):
                ends = _closed_arc(final_arc)
                between = f"between {ends.start.reduced()} and {ends.end.reduced()}"
                return _unproven(epsilon, f"another edge may lie flush in the end, {between}")
        return PartErrorReport(
            epsilon,
            True,
            tuple(starts),
            tuple(map(_closed_arc, finals)),
            all(len(pairs) == 1 for pairs in reached),
        )

    def _motions(self, epsilon: mpq) -> list[ContactZones] | None:
        """Return what is certain of each motion of an action; None if nothing is of one."""
        squeeze = squeeze_zones(self.near, epsilon)
        if squeeze is None or not self.pushes:
            return None if squeeze is None else [squeeze]
        center_error = self.center.bound(epsilon)
        push = None if center_error is None else push_zones(self.near, epsilon, center_error)
        return None if push is None else [push, squeeze]

    def _run(self, motions: Sequence[ContactZones], image: Units) -> Units:
        """Return an arc that holds what all actions make of the image of the first motion."""
        for motion in motions[1:]:
            image = motion.image(image)
        for below, above in self.turns:
            image = image[0] - above, image[1] - below
            for motion in motions:
                image = motion.image(image)
        return image

    def _is_final_state(self, place: int, arc: Units, pairs: set[frozenset[int]]) -> bool:
        """Tell whether a part that rests on some of the pairs in an arc is in the final state.

        The arc must not reach a quarter turn from the nominal orientation: half a turn on, the
        same edge lies on the other jaw.
        """
        below, above = units_around((self.final + self.shifts[place]).reduced())
        lap = -((above - arc[0]) // TURN) * TURN
        jaws = self._final_points[place]
        return (
            above + lap - TURN // 4 < arc[0]
            and arc[1] < below + lap + TURN // 4
            and all(pair <= jaws[0] or pair <= jaws[1] for pair in pairs)
        )

    def _starts(self, shift: Angle, turned: Units) -> Arc | None:
        """Return the certain starts as orientations before the first action, if there are any."""
        if self.is_period:
            return self.mouth.rotate(shift)
        low = turned[0] + units_around(self.first_angle + self.first_error)[1]
        high = turned[1] + units_around(self.first_angle - self.first_error)[0]
        if low >= high:
            return None
        start = Angle.from_turns(mpq(low, TURN))
        return Arc(start, Angle.from_turns(mpq(high, TURN)) - start)

    @cached_property
    def _final_points(self) -> list[tuple[frozenset[int], frozenset[int]]]:
        """For each of `shifts` the points on either jaw in the final orientation."""
        return [self.near.on_jaws(direction) for direction in self._final_directions]

    @cached_property
    def final_clearance(self) -> Scalar:
        """The square of the least distance of another point from a jaw in the final orientation.

        If epsilon is half of that distance or more, nothing is proven.
        """
        return min(map(self.near.least_clearance, self._final_directions))

    @property
    def _final_directions(self) -> list[tuple[Any, Any]]:
        return [exact_direction(self.final + shift, self.near.part.field) for shift in self.shifts]


def _certain_starts(zones: ContactZones, mouth: Units) -> Units | None:
    """Return the mouth without the zones at its ends, None if a part may rest in what is cut off.

    (With a smaller epsilon, such a rest would leave the zone and stand in the mouth.)
    """
    low, high = mouth
    at_low, at_high = zones.uncertain.around(low), zones.uncertain.around(high)
    if at_low is not None:
        if zones.rest_arcs.first_from(low) <= at_low[1]:
            return None
        low = at_low[1] + 1
    if at_high is not None:
        if zones.rest_arcs.last_to(high) >= at_high[0]:
            return None
        high = at_high[0] - 1
    return (low, high) if low < high else None


def _unproven(epsilon: mpq, reason: str) -> PartErrorReport:
    return PartErrorReport(epsilon, False, reason=reason)


def _closed_arc(arc: Units) -> ClosedArc:
    """Return an arc of units as angles, its start in [0, 360) degrees."""
    low, high = arc
    return ClosedArc(
        Angle.from_turns(mpq(low % TURN, TURN)), Angle.from_turns(mpq(high - low, TURN))
    )
