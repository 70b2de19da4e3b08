"""Plans that weigh how stable the final grasp is against what it costs to get there.

A round of an i-step plan costs i + c; a grasp that slips easily costs more to carry away. With a
cost g for each stable grasp, in units of one action, the plan of least (i + c + g) / p is sought
over all plan lengths and all final orientations: for each cost, the optimal plan among those that
end in a grasp of that cost, under the cost ratio c + g.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.decision.costs import as_cost_ratio
from stochgeom.errors import GoalError
from stochgeom.exact.angles import Angle
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.feeding.gripper_error import GripperError
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.stability import stable_grasps
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.transfer.squeeze import squeeze_function

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior

DIGITS: Final = 6
"""Decimals of the costs made of stabilities, whose ratios are irrational in general."""


def stability_costs(part: PartLike, weight: RationalLike) -> dict[Angle, mpq]:
    """Return a cost for each stable grasp: weight * (1 - Psi / the largest Psi), to 6 decimals.

    The most stable grasps cost nothing, and a grasp of no stability would cost the weight.

    Parameters
    ----------
    part : Part, or its vertices
        Whose grasps are meant.
    weight : rational >= 0
        In units of one action.

    Returns
    -------
    dict
        From the orientations of `stable_grasps` to costs.

    Raises
    ------
    CostError
        If the weight is negative or not a rational number.

    Examples
    --------
    >>> costs = stability_costs([(0, 0), (3, 0), (3, 2), (0, 2)], 10)
    >>> {angle.degrees(0): float(cost) for angle, cost in costs.items()}
    {'0': 0.0, '90': 4.01703}
    """
    w = as_cost_ratio(weight)
    grasps = stable_grasps(part)
    best = max(grasp.stability for grasp in grasps)
    return {grasp.orientation: w * (1 - _share(grasp.stability, best)) for grasp in grasps}


def _share(part: Angle, whole: Angle) -> mpq:
    """Return the quotient of two angles, to `DIGITS` decimals; exactly 1 for equal ones."""
    if part == whole:
        return mpq(1)
    a, b = part.rational_turns, whole.rational_turns
    if a is not None and b is not None:
        return mpq(rational_decimal(a / b, DIGITS))
    # A quotient of unequal angles that lies half way between two decimals is a quotient of equal
    # logarithms: too rare to look for, and refused at the cap of the precision.
    return mpq(certified_decimal(lambda: part.ball() / whole.ball(), DIGITS))


def plan_weighing_grasps(
    part: PartLike,
    grasp_costs: Mapping[Angle, RationalLike],
    cost_ratio: RationalLike = 1,
    action: str = "squeeze",
    *,
    prior: Prior | None = None,
    gripper_error: GripperError | None = None,
) -> FeedingPlan:
    """Return the plan of least expected cost when final grasps have costs of their own.

    Parameters
    ----------
    part : Part, or its vertices
        What is fed.
    grasp_costs : mapping
        From stable orientations, modulo the period of the squeeze function, to rational costs of 0
        or more for each round, such as `stability_costs` gives. Grasps that are not in it are no
        goals.
    cost_ratio, action, prior, gripper_error
        As for `stochgeom.feeding.planner.plan_feeding`.

    Returns
    -------
    FeedingPlan
        Its `cost_ratio` includes the cost of its final grasp.

    Raises
    ------
    GoalError
        If the mapping names no grasp that the action can end in.

    Examples
    --------
    Four squeezes bring this part into any of its four grasps; weight decides for the most stable.

    >>> part = [(52, 58), (0, 55), (8, 17), (51, 0)]
    >>> for weight in (0, 1):
    ...     plan = plan_weighing_grasps(part, stability_costs(part, weight))
    ...     print(weight, plan.steps, plan.final_orientation.degrees(1), plan.expected_cost)
    0 4 91.0 10.0000
    1 4 21.6 10.0000
    """
    part = as_part(part)
    c = as_cost_ratio(cost_ratio)
    expect(grasp_costs, Mapping, "a mapping from orientations, such as stability_costs(part)")
    problem = FeedingProblem(part, action, prior=prior, gripper_error=gripper_error)
    best: FeedingPlan | None = None
    for cost, goals in _goals_by_cost(problem, grasp_costs).items():
        one = FeedingProblem(part, action, prior=prior, gripper_error=gripper_error, goal=goals)
        plan = one.optimal_plan(c + cost)
        if best is None or _order(plan, best) < 0:
            best = plan
    if best is None:
        raise GoalError(
            f"none of the {len(grasp_costs)} grasps with a cost is a final orientation; accepted: "
            "orientations of stable_grasps(part)"
        )
    return best


def _goals_by_cost(
    problem: FeedingProblem, grasp_costs: Mapping[Angle, RationalLike]
) -> dict[mpq, tuple[Angle, ...]]:
    """Return the final orientations of each cost, cheapest first."""
    assert problem.part is not None
    period = squeeze_function(problem.part).period
    costs = {
        angle % period: as_cost_ratio(rational(cost, where=f"cost of the grasp at {angle}"))
        for angle, cost in grasp_costs.items()
    }
    found: dict[mpq, list[Angle]] = {}
    for value in problem.transfer.values:
        cost = costs.get(value % period)
        if cost is not None:
            found.setdefault(cost, []).append(value)
    return {cost: tuple(found[cost]) for cost in sorted(found)}


def _order(plan: FeedingPlan, other: FeedingPlan) -> int:
    """Compare by expected cost, then by steps; of equal ones the cheaper grasp came first."""
    return plan.expected_cost.compare(other.expected_cost) or plan.steps - other.steps
