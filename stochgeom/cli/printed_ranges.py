"""What is printed of the gripper error that plans bear."""

from __future__ import annotations

from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.feeding.actions import printed_margin
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem

MOST_DECIMALS = 12
"""A given angle is shown with so many decimals more than asked for, if it has no more."""


def error_text(
    problem: FeedingProblem, optimal: FeedingPlan, geometric: FeedingPlan | None, digits: int
) -> str:
    """Return what the plans bear of gripper error, in a line each."""
    lines = []
    if problem.gripper_error is not None:
        given = _unrounded(problem.gripper_error, digits)
        lines.append(f"Every action may be off by {given} degrees either way.")
    plans = {plan.steps: plan for plan in (optimal, geometric) if plan is not None}
    for plan in plans.values():
        bound = plan.error_bound
        name = f"The {plan.steps}-step plan"
        if bound is None and plan.prior is None:
            lines.append(f"{name} bears any gripper error: its only turn is random.")
        elif bound is None:
            lines.append(f"{name} has one turn, and an error of it moves the mouth.")
        else:
            least, most = printed_margin(plan.actions, digits), bound.decimal(digits)
            middles = "" if least == most else f", and {most} at the middles of its ranges"
            line = f"{name} bears every gripper error below {least} degrees{middles}"
            if plan.prior is not None and not plan.gripper_error and plan.mouth.width != FULL_TURN:
                line += "; one of the first turn moves the mouth"
            lines.append(f"{line}.")
    if problem.gripper_error is not None:
        lines.append(_largest_error(problem, complete=geometric is not None, digits=digits))
    return "\n".join(lines)


def _unrounded(angle: Angle, digits: int) -> str:
    """Return an angle with as many decimals as it has, if they are few."""
    exact = angle.rational_turns
    for decimals in range(digits, digits + MOST_DECIMALS):
        if exact is not None and mpq(text := angle.degrees(decimals)) == exact * 360:
            return text
    return angle.degrees(digits)


def _largest_error(problem: FeedingProblem, *, complete: bool, digits: int) -> str:
    how = "uniquely" if problem.transfer.order == 1 else "up to symmetry"
    bound = problem.largest_gripper_error()
    if bound is None:
        return f"One action orients the part {how}, whatever its error."
    lacking = "" if complete else f"No plan orients the part {how} with this error. "
    most = bound.decimal(digits)
    return f"{lacking}Plans that orient it {how} exist for every error below {most} degrees."
