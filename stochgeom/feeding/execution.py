"""Plans run forward, exactly: single orientations, arcs, whole maps, and the check of a plan.

Nothing here knows how a plan was found.
"""

from __future__ import annotations

from collections.abc import Sequence

from stochgeom.errors import VerificationError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.directions import just_above
from stochgeom.transfer.step_function import StepFunction

Range = tuple[Angle | None, Angle, Angle | None]
"""(low, nominal, high) of one action; low and high are None for a free first action."""


def run_angle(transfer: StepFunction, angles: Sequence[Angle], theta: Angle) -> tuple[Angle, ...]:
    """Return theta and the orientation after each action theta -> s(theta - alpha)."""
    states = [theta]
    for alpha in angles:
        states.append(transfer(states[-1] - alpha))
    return tuple(states)


def run_arc(transfer: StepFunction, angles: Sequence[Angle], arc: Arc) -> tuple[ClosedArc, ...]:
    """Return what a half-open arc becomes after each action: closed arcs, ends taken."""
    image = transfer.image(arc.rotate(-angles[0]))
    images = [image]
    for alpha in angles[1:]:
        low, high = transfer(image.start - alpha), transfer(image.end - alpha)
        image = ClosedArc(low, high - low)
        images.append(image)
    return tuple(images)


def composite(transfer: StepFunction, angles: Sequence[Angle]) -> StepFunction:
    """Return the transfer function of the whole sequence of actions (Eq. 4.2)."""
    whole = transfer.after_turning(angles[0])
    for alpha in angles[1:]:
        whole = transfer.after_turning(alpha).compose(whole)
    return whole


def check_plan(
    transfer: StepFunction, mouth: Arc, ranges: Sequence[Range], *, widest: bool = True
) -> None:
    """Run a plan at its nominal angles and at the ends of every range.

    At the lower end of a range the plan must fail, with the actions before it just above their
    own lower ends: only then does the last image reach as far as the preimage allows. (With
    other angles before it, the image may be narrower and the plan survive.)

    Parameters
    ----------
    transfer : StepFunction
        Of each action.
    mouth : Arc
        What the plan collapses.
    ranges : sequence of (low, nominal, high)
        One for each action.
    widest : bool, default True
        Whether no actions collapse a wider arc at any stage. Otherwise the actions after one at
        its lower end may make up for it, and nothing is said about that.

    Raises
    ------
    VerificationError
        Naming the first claim that does not hold.
    """
    for k, (bottom, angle, top) in enumerate(ranges):
        if bottom is not None and top is not None and not bottom < angle <= top:
            raise VerificationError(
                f"{angle} is not in its range, above {bottom} and up to {top}", where=f"action {k}"
            )
    nominal = [angle for _, angle, _ in ranges]
    high = [angle if top is None else top for _, angle, top in ranges]
    low = _just_above_lows(transfer, mouth, ranges)
    goal = _collapse(transfer, nominal, mouth, "at the nominal angles")
    for angles, what in ((high, "at the upper ends"), (low, "just above the lower ends")):
        if _collapse(transfer, angles, mouth, what) != goal:
            raise VerificationError(f"{what} the plan ends in another orientation")
    for k, (bottom, _, _) in enumerate(ranges):
        if bottom is None or not widest:
            continue
        last = run_arc(transfer, [*low[:k], bottom, *nominal[k + 1 :]], mouth)[-1]
        if not last.width and last.start.reduced() == goal:
            raise VerificationError(
                f"the plan still works at {bottom}, the open end of the range",
                where=f"action {k}",
            )


def _just_above_lows(transfer: StepFunction, mouth: Arc, ranges: Sequence[Range]) -> list[Angle]:
    """Return angles so little above the lower ends that each image keeps its last step."""
    angles: list[Angle] = []
    end = mouth.end
    for bottom, angle, top in ranges:
        if bottom is None or top is None:
            angles.append(angle)
            end = transfer.lifted_values[transfer.step_before(end - angle)]
            continue
        # Just above `bottom` the image's last orientation is in the step before this break.
        last_break = transfer.lifted_breaks[transfer.step_before(end - bottom)]
        angles.append(just_above(bottom, min(top, end - last_break)))
        end = transfer(end - angles[-1])
    return angles


def _collapse(transfer: StepFunction, angles: Sequence[Angle], mouth: Arc, what: str) -> Angle:
    """Return the one orientation the mouth ends in, in [0, 360) degrees."""
    last = run_arc(transfer, angles, mouth)[-1]
    if last.width:
        raise VerificationError(
            f"{what} the mouth is not collapsed: its image is {last.width} wide"
        )
    return last.start % FULL_TURN
