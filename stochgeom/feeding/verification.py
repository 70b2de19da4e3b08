"""Other people's plans: a list of angles, run and reported on, and what is claimed of it.

What the report says, and how it is worked out, is in `stochgeom.feeding.reports`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from itertools import islice, pairwise
from typing import Final

from stochgeom.arguments import expect
from stochgeom.decision.costs import as_cost_ratio
from stochgeom.errors import InputError, InvalidAngleError, NumberLimitError, VerificationError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.feeding.nearby_courses import NearbyCourses, PartErrorReport
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.propagation import outcomes
from stochgeom.feeding.reports import PlanReport, within_a_turn
from stochgeom.geometry.part import PartLike
from stochgeom.transfer.step_function import StepFunction

MAX_ACTIONS: Final = 1_000_000
"""Longest plan that is looked at."""

ACCEPTED: Final = "accepted: degrees such as 71, 35.5 or 71/2, or directions such as 3:2 or (3, 2)"

_ENTRY: Final = re.compile(r"(\([^()]*\)|[^\s,()]+)(\s*,\s*|\s+|\Z)")


def verify_plan(
    part: PartLike | StepFunction,
    angles: str | Iterable[Angle] | FeedingPlan,
    cost_ratio: RationalLike = 1,
    *,
    cumulative: bool = False,
    action: str = "squeeze",
    vertex_error: RationalLike | None = None,
) -> PlanReport:
    """Run a plan, whoever made it, and report what it does.

    Parameters
    ----------
    part : Part, its vertices, or StepFunction
        What is fed, or the transfer function of the action on it.
    angles : str, iterable of Angle, or FeedingPlan
        One angle for each action, at most `MAX_ACTIONS`; text as `parse_angles` reads it. A plan
        stands for its nominal angles and its kind of action.
    cost_ratio : rational >= 0, default 1
        c, the cost of the filter over the cost of one action.
    cumulative : bool, default False
        Whether the angles are poses of the gripper, as the source prints them; otherwise each is
        relative to the gripper's last pose.
    action : str, default "squeeze"
        What the gripper does; not used with a transfer function or a plan.
    vertex_error : rational >= 0, optional
        epsilon. The report's `part_errors` then says whether the plan is proven to work for every
        part whose vertices lie within epsilon of the given ones, defined in
        `stochgeom.feeding.part_errors`; for a plan its own mouth counts, and its gripper error.

    Raises
    ------
    InvalidAngleError
        If text is no angle; the message names the action, counted from 0.
    InputError
        If there are no angles, too many, or other objects than angles. If the vertex error is
        negative, or comes with a transfer function.
    NumberError
        If the vertex error is not an exact number.
    CostError
        If the cost ratio is negative or not a rational number.
    InvalidPartError
        If the vertices are no simple polygon.

    Examples
    --------
    >>> report = verify_plan([(0, 0), (3, 0), (3, 2), (0, 2)], "0, -45")
    >>> report.orients_up_to_symmetry, report.final_orientations, report.first_misfit
    (True, 2, None)
    >>> second = report.margins[1]
    >>> second.low.degrees(2), second.high.degrees(2)
    ('-56.31', '-33.69')
    >>> report = verify_plan([(0, 0), (3, 0), (3, 2), (0, 2)], "0, -45", vertex_error="1/10")
    >>> report.part_errors.proven, report.part_errors.finals[0].width.degrees(1)
    (True, '7.6')
    """
    plan = angles if isinstance(angles, FeedingPlan) else None
    if isinstance(angles, FeedingPlan):
        listed, action = angles.angles, angles.action_name
    else:
        listed = parse_angles(angles) if isinstance(angles, str) else _angles_of(angles)
    if cumulative:
        listed = (listed[0], *(after - before for before, after in pairwise(listed)))
    c = as_cost_ratio(cost_ratio)
    if isinstance(part, StepFunction):
        problem = FeedingProblem.of_transfer(part)
    else:
        problem = FeedingProblem(part, action)
    for outcome in outcomes(problem.transfer, within_a_turn(listed)):
        last = outcome
    report = PlanReport(problem.transfer, listed, c, last, problem.preimages)
    if vertex_error is None:
        return report
    return replace(report, part_errors=_part_errors(problem, report, plan, action, vertex_error))


def _part_errors(
    problem: FeedingProblem,
    report: PlanReport,
    plan: FeedingPlan | None,
    action: str,
    vertex_error: RationalLike,
) -> PartErrorReport:
    """Return what is proven of a plan, or of a list of angles, if vertices are off."""
    if problem.part is None:
        raise InputError(
            "a transfer function has no vertices; accepted: a part", where="vertex error"
        )
    if plan is not None and plan.transfer == problem.transfer:
        courses = NearbyCourses.of_plan(plan, problem.part)
    else:
        mouth, end = report.mouth, report.final_orientation
        courses = NearbyCourses(
            problem.part, problem.transfer, report.angles, mouth, end, action=action
        )
    return courses.report(vertex_error)


def _angles_of(angles: Iterable[Angle]) -> tuple[Angle, ...]:
    """Return the angles after a look at their kind and number."""
    expect(angles, Iterable, "angles, or text such as '0, 71, 3:2'", "angles")
    listed = tuple(islice(angles, MAX_ACTIONS + 1))
    _check_count(len(listed))
    for k, angle in enumerate(listed):
        if not isinstance(angle, Angle):
            raise InputError(
                f"{angle!r:.60} is no Angle; accepted: angles, or text such as '0, 71, 3:2'",
                where=f"action {k}",
            )
    return listed


def _check_count(count: int) -> None:
    if not count:
        raise InputError("no actions; accepted: at least one angle", where="angles")
    if count > MAX_ACTIONS:
        raise InputError(f"too many; accepted: at most {MAX_ACTIONS} actions", where="angles")


# --- text ----------------------------------------------------------------------------------------


def parse_angles(text: str) -> tuple[Angle, ...]:
    """Read angles separated by commas or white space, exactly.

    Parameters
    ----------
    text : str
        Each angle is a number of degrees, such as ``71``, ``35.5`` or ``71/2``, or a rational
        direction, such as ``3:2`` or ``(3, 2)``: the angle of the vector (3, 2).

    Raises
    ------
    InvalidAngleError
        If an entry is no angle; the message names the action, counted from 0.
    NumberLimitError
        If a number is too long.
    InputError
        If there are no angles, or more than `MAX_ACTIONS`.

    Examples
    --------
    >>> parse_angles("0, 35.5 3:2 (0, -1)")
    (Angle(0, (1, 0)), Angle('71/720', (1, 0)), Angle(0, (3, 2)), Angle(0, (0, -1)))
    """
    body = expect(text, str, "text such as '0, 71, 3:2'", "angles").strip()
    known: dict[str, Angle] = {}
    angles: list[Angle] = []
    position, gap = 0, ""
    while position < len(body) or "," in gap:
        where = f"action {len(angles)}"
        entry = _ENTRY.match(body, position)
        if entry is None:
            raise InvalidAngleError(
                f"{body[position : position + 40]!r} is no angle; {ACCEPTED}", where=where
            )
        word, gap = entry.groups()
        if word not in known:
            known[word] = _angle_of(word, where)
        angles.append(known[word])
        _check_count(len(angles))
        position = entry.end()
    _check_count(len(angles))
    return tuple(angles)


def _angle_of(word: str, where: str) -> Angle:
    """Read one angle."""
    try:
        if word.startswith("("):
            x, y = word[1:-1].split(",")
        elif ":" in word:
            x, y = word.split(":")
        else:
            return Angle.from_degrees(rational(word.removesuffix("°"), where=where))
        return Angle(0, (rational(x, where=where), rational(y, where=where)))
    except NumberLimitError:
        raise
    except ValueError:  # no number, the zero vector, or not two of them
        raise InvalidAngleError(f"{word[:60]!r} is no angle; {ACCEPTED}", where=where) from None


# --- claims --------------------------------------------------------------------------------------


def check_claim(report: PlanReport, claim: str) -> None:
    """Compare a plan with what is claimed of it.

    Parameters
    ----------
    report : PlanReport
        What the plan does.
    claim : str
        ``"up-to-symmetry"``: the final orientations are 2 pi / T equally spaced ones.
        ``"probability=P"``: one orientation is reached with at least the probability P, a
        number such as 0.5 or 2/3.

    Raises
    ------
    VerificationError
        If the plan does not do it.
    InputError
        If nothing of that kind can be claimed.

    Examples
    --------
    >>> report = verify_plan([(0, 0), (3, 0), (3, 2), (0, 2)], "0, -45")
    >>> check_claim(report, "up-to-symmetry")
    >>> check_claim(report, "probability=0.6")
    Traceback (most recent call last):
    ...
    stochgeom.errors.VerificationError: probability=0.6: the most likely final orientation has \
the probability 0.50000000
    """
    expect(report, PlanReport, "what verify_plan returns")
    kind, _, value = expect(claim, str, "text such as 'probability=1/2'", "claim").partition("=")
    if claim == "up-to-symmetry":
        if not report.orients_up_to_symmetry:
            raise VerificationError(
                f"the plan ends in {report.final_orientations} orientations, "
                f"not in {report.transfer.order} equivalent ones",
                where=claim,
            )
    elif kind == "probability":
        least = rational(value, where="claim")
        if not 0 < least <= 1:
            raise InputError(
                f"{claim!r:.60}; accepted: probabilities above 0, up to 1", where="claim"
            )
        if report.probability < least:
            raise VerificationError(
                "the most likely final orientation has the probability "
                f"{report.probability.decimal(8)}",
                where=claim,
            )
    else:
        raise InputError(f"{claim!r:.60}; accepted: up-to-symmetry, probability=P", where="claim")
