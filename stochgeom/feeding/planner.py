"""Planning in one call: for a part, or for any transfer function.

`stochgeom.feeding.problem.FeedingProblem` holds what several plans of one part share.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.goals import Goal
from stochgeom.feeding.gripper_error import GripperError
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import PartLike
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior


def plan_feeding(
    part: PartLike,
    cost_ratio: RationalLike = 1,
    action: str = "squeeze",
    *,
    prior: Prior | None = None,
    gripper_error: GripperError | None = None,
    goal: Goal | None = None,
) -> FeedingPlan:
    """Return the plan that feeds a part at least expected cost.

    Parameters
    ----------
    part : Part, or its vertices
        Any simple polygon; for ``"push-grasp"`` with its centre of mass strictly inside the hull.
    cost_ratio : rational >= 0, default 1
        c, the cost of the filter over the cost of one action.
    action : str, default "squeeze"
        What the gripper does: ``"squeeze"`` or ``"push-grasp"``.
    prior : Prior, optional
        Of the orientations before the first action; default: uniform.
    gripper_error : Angle, or degrees as text, optional
        Every action may be off by so much either way.
    goal : Angle, degrees as text, or "most stable", optional
        The final orientation; default: any.

    Returns
    -------
    FeedingPlan
        The stochastically optimal plan (thesis Def. 4.4, Figs. 5.1 and 5.8, App. F); of equal costs
        the one of fewest steps.

    Raises
    ------
    CostError
        If the cost ratio is negative or not a rational number.
    InvalidPartError
        If the vertices are no simple polygon, or the action needs another centre of mass.
    GripperErrorError, GoalError
        If the error or the goal is not acceptable.
    NoPlanError
        If the gripper error leaves nothing to catch under the prior.

    Notes
    -----
    O(n log n) for the transfer function and O(n) for each plan length tried, besides placing the
    mouth under a prior.

    Examples
    --------
    >>> house = [(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]
    >>> plan_feeding(house).expected_cost.decimal(1)
    '5.0'
    >>> plan = plan_feeding(house, cost_ratio=4, gripper_error="20")
    >>> plan.steps, plan.error_bound.degrees(2)
    (2, '26.56')
    """
    problem = FeedingProblem(part, action, prior=prior, gripper_error=gripper_error, goal=goal)
    return problem.optimal_plan(cost_ratio)


def orient_up_to_symmetry(
    part: PartLike,
    cost_ratio: RationalLike = 1,
    action: str = "squeeze",
    *,
    prior: Prior | None = None,
    gripper_error: GripperError | None = None,
    goal: Goal | None = None,
) -> FeedingPlan:
    """Return the shortest plan that orients a part up to the symmetry of its transfer function.

    Without gripper error such a plan always exists (thesis Thm 5.3); parameters as in
    `plan_feeding`.

    Raises
    ------
    NoPlanError
        If the gripper error is too large, saying how large it may be.

    Examples
    --------
    >>> orient_up_to_symmetry([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]).steps
    2
    """
    problem = FeedingProblem(part, action, prior=prior, gripper_error=gripper_error, goal=goal)
    return problem.geometric_plan(cost_ratio)


def plan_transfer(
    transfer: StepFunction,
    cost_ratio: RationalLike = 1,
    *,
    prior: Prior | None = None,
    gripper_error: GripperError | None = None,
    goal: Goal | None = None,
) -> FeedingPlan:
    """Return the plan of least expected cost for any monotone step map (thesis 5.10).

    Parameters as in `plan_feeding`; the actions are turns followed by the map.

    Examples
    --------
    >>> from stochgeom.exact.angles import Angle
    >>> s = StepFunction([Angle.from_degrees(d) for d in (0, 100)], [Angle(), Angle(0, (0, 1))])
    >>> plan_transfer(s).expected_cost.decimal(2)
    '2.77'
    """
    problem = FeedingProblem.of_transfer(
        transfer, prior=prior, gripper_error=gripper_error, goal=goal
    )
    return problem.optimal_plan(cost_ratio)
