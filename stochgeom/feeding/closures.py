"""The closure of a set that a plan collapses: the gap between two arcs goes where they go.

Lemma 5.1 of the source: a plan that brings two arcs Theta_a and Theta_c to one orientation brings
the gap Theta_b between them there as well, since every action keeps the order of orientations,

    Theta_a <= Theta_b <= Theta_c    before and after each action (Eq. 5.5),

and what is between two equal ends is equal to them. Order is that of lifted angles. On the circle
there are two gaps between two arcs, and the lemma holds of one of them: the one across which the
arcs, lifted, end at the same lifted angle. The source takes the smaller one (Def. 5.3), which is
right for squeezes, whose plans collapse at most half a turn. A plan of push-grasps may collapse
more, and then the gap that it closes is the larger one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, final

from stochgeom.arguments import as_list, expect, shown
from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.directions import nominal_angle
from stochgeom.feeding.plans import FeedingPlan

ACCEPTED: Final = "two arcs apart from each other that the plan brings to one orientation"


@final
@dataclass(frozen=True, slots=True)
class Closure:
    """Two arcs that a plan collapses into one orientation, the gap between them, and their images.

    Made by `closure_of`.

    Attributes
    ----------
    first, gap, last : Arc
        Theta_a, Theta_b and Theta_c, lifted: each begins where the one before it ends.
    images : tuple of (ClosedArc, ClosedArc, ClosedArc)
        What the three are after each action, lifted.
    """

    first: Arc
    gap: Arc
    last: Arc
    images: tuple[tuple[ClosedArc, ClosedArc, ClosedArc], ...]

    @property
    def arc(self) -> Arc:
        """C Theta: the two arcs and the gap."""
        return Arc(self.first.start, self.last.end - self.first.start)

    @property
    def final_orientation(self) -> Angle:
        """Where all of it ends, relative to the gripper after the last action, lifted."""
        return self.images[-1][0].start


def closure_of(plan: FeedingPlan, arcs: Sequence[Arc] | None = None) -> Closure:
    """Return the closure of two arcs that a plan collapses into one orientation (Lemma 5.1).

    Parameters
    ----------
    plan : FeedingPlan
        Any plan.
    arcs : sequence of two Arcs, optional
        Of orientations before the first action, in either order. Default: what of the plan's mouth
        is in the first and in the last step of the first action; a mouth of one or two steps is
        cut into three, and of one that is wider than half a turn the first half turn is taken.

    Raises
    ------
    InputError
        If there are not two arcs, they overlap, nothing is between them, or they do not end in one
        orientation.

    Notes
    -----
    Decided exactly; O(k log m) for k actions of m steps.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ten = Angle.from_degrees(10)
    >>> closure = closure_of(plan, [Arc(6 * ten, ten), Arc(20 * ten, ten)])
    >>> closure.gap.start.degrees(0), closure.gap.end.degrees(0)
    ('70', '200')
    >>> [image.start.degrees(0) for image in closure.images[-1]]
    ['180', '180', '180']
    """
    expect(plan, FeedingPlan, "a FeedingPlan, such as plan_feeding(part)", "plan")
    first, last = _ends_of_the_mouth(plan) if arcs is None else _two_apart(arcs)
    # Within a full turn after the start of the first arc.
    last = last.rotate((last.start - first.start).reduced() - (last.start - first.start))
    here, there = (_collapsed(plan, arc) for arc in (first, last))
    if there - here == FULL_TURN:  # the gap beyond the last arc
        first, last = last, first.rotate(FULL_TURN)
    elif here != there:
        raise InputError(
            f"the plan brings one arc to {here.reduced()}, the other to {there.reduced()}; "
            f"accepted: {ACCEPTED}",
            where="arcs",
        )
    if first.end == last.start:
        raise InputError(
            f"the arcs touch at {first.end.reduced()}; accepted: {ACCEPTED}", where="arcs"
        )
    gap = Arc(first.end, last.start - first.end)
    runs = [plan.execute_arc(arc) for arc in (first, gap, last)]
    return Closure(first, gap, last, tuple(zip(*runs, strict=True)))


def _two_apart(arcs: Sequence[Arc]) -> tuple[Arc, Arc]:
    listed = as_list(arcs, ACCEPTED, "arcs")
    if len(listed) != 2 or not all(isinstance(arc, Arc) for arc in listed):
        raise InputError(f"{shown(listed)} is no pair of Arcs; accepted: {ACCEPTED}", where="arcs")
    first, last = listed
    if first.intersects(last):
        place = last.start if first.contains(last.start) else first.start
        raise InputError(f"both hold {place.reduced()}; accepted: {ACCEPTED}", where="arcs")
    return first, last


def _collapsed(plan: FeedingPlan, arc: Arc) -> Angle:
    """Return the lifted orientation that an arc ends in."""
    final = plan.execute_arc(arc)[-1]
    if final.width:
        raise InputError(
            f"the plan does not collapse the arc of {arc.width} from {arc.start.reduced()}: its "
            f"image is {final.width} wide; accepted: {ACCEPTED}",
            where="arcs",
        )
    return final.start


def _ends_of_the_mouth(plan: FeedingPlan) -> tuple[Arc, Arc]:
    """Return what of the mouth is in the first and in the last step of the first action."""
    alpha, transfer = plan.angles[0], plan.transfer
    start = plan.mouth.start
    end = min(plan.mouth.end, start + HALF_TURN)
    low, high = transfer.step_at(start - alpha), transfer.step_before(end - alpha)
    # Of more than two steps there is a first and a last one, and some between.
    left = transfer.lifted_breaks[low + 1] + alpha if low < high else nominal_angle(start, end)
    right = transfer.lifted_breaks[high] + alpha if high - low > 1 else nominal_angle(left, end)
    return Arc(start, left - start), Arc(right, end - right)
