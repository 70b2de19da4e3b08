"""Optimal plans with sensors: those that are carried out once, and those that are repeated.

*Once.* The cost of a plan is the expected cost of its moves plus the expected loss of its
decisions: an additive cost, which the recursion of 7.2.4 minimises (`sensor_plan`).

*Until it succeeds.* A part that is not accepted falls back, and all begins anew: the plan costs
E[cost of a round] / P(success of a round). That is no additive cost; what to do after one reading
depends on how good the other branches are (`iterative_sensor_plan`, and
`stochgeom.sensing.plan_tasks` for how it is done).
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import Any

from stochgeom.decision.additive_costs import goal_numbers
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_costs import Prices, read_prices
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import CostError
from stochgeom.sensing.decisions import Decisions, accept_groups, accept_one_of, lose_by_state
from stochgeom.sensing.plan_tasks import PlanTask, Sensors
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_search import NODE_LIMIT

__all__ = [
    "NODE_LIMIT",
    "Sensor",
    "SensorPlan",
    "iterative_sensor_plan",
    "plan_for_cost",
    "sensor_plan",
]


def sensor_plan(
    problem: PlanningProblem,
    sensors: Sensors,
    horizon: int | None = None,
    *,
    stages: Sequence[str] | None = None,
    action_costs: Prices | None = None,
    decisions: Decisions | None = None,
    good_enough: Any = None,
    node_limit: int = NODE_LIMIT,
    time_limit: float | None = None,
    progress: Callable[[float], None] | None = None,
) -> SensorPlan:
    """Return the plan with sensors of least expected cost, carried out once (7.2.4, 7.2.5).

    Parameters
    ----------
    problem : PlanningProblem
        What is known before, and what actions do.
    sensors : Sensor, or several, or mapping from labels
        What may be looked at, as often as one likes; each costs its own cost. Of none: plans that
        do not look.
    horizon : int, optional
        Most moves on any way through the tree, sensings included; at most 300.
    stages : sequence of str, optional
        Instead of the horizon: for each move in turn ``"any"``, ``"act"`` or ``"sense"``.
    action_costs : number, or mapping from actions, optional
        Costs of the actions; default: those of the problem's additive cost.
    decisions : Decisions, optional
        What a subplan may end in, and its losses; default: the state costs of the problem.
    good_enough : number, optional
        Cut a subplan off where it loses no more than this on average. The plan is then not proven
        to be the best.
    node_limit : int, default 1,000,000
        Most nodes of the tree of all plans.
    time_limit : float, optional
        Seconds. When they are over, the best plan of fewer moves is returned, not proven.
    progress : callable, optional
        Told shares of the work done.

    Raises
    ------
    NodeLimitError
        If the tree of all plans has more nodes than the limit; says how many.
    SensorError, ShapeMismatchError, MixedNumbersError
        If what is given is no sensor, or does not fit the problem.

    Notes
    -----
    Time is that of the tree in the worst case, (actions + readings)^horizon nodes; equal
    hyperstates are searched once and bounds leave out much of it.

    Examples
    --------
    Look before you pay:

    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> cost = AdditiveCost(actions="1/8", states={"tails": 1})
    >>> coin = PlanningProblem(
    ...     ["heads", "tails"], ["1/2", "1/2"], ["turn"], [[[0, 1], [1, 0]]], cost)
    >>> plan = sensor_plan(coin, Sensor.perfect(coin.states, cost="1/16"), 2)
    >>> plan.expected_cost
    mpq(1,8)
    >>> print(plan.tree.text())
    read sensor
      heads (0.5000): end (0.0000)
      tails (0.5000)
        do turn
        end (0.0000)
    """
    check_problem(problem)
    prices = None if action_costs is None else read_prices(problem, action_costs)
    if decisions is None:
        decisions, own = lose_by_state(problem)
        prices = own if prices is None else prices
    elif prices is None:
        prices = lose_by_state(problem)[1] if problem.cost is not None else read_prices(problem, 0)
    task = PlanTask(problem, sensors, decisions, prices, horizon, stages, node_limit)
    task.good_enough = None if good_enough is None else 0 - task.number(good_enough, "good enough")
    return task.run(time_limit, progress)


def iterative_sensor_plan(
    problem: PlanningProblem,
    sensors: Sensors,
    horizon: int | None = None,
    *,
    stages: Sequence[str] | None = None,
    round_cost: Any = 1,
    action_costs: Prices = 1,
    accepted: Decisions | Iterable[Hashable] | None = None,
    good_enough: Any = None,
    node_limit: int = NODE_LIMIT,
    time_limit: float | None = None,
    progress: Callable[[float], None] | None = None,
) -> SensorPlan:
    """Return the plan with sensors of least expected cost, repeated until it succeeds.

    Parameters
    ----------
    problem, sensors, horizon, stages, node_limit, time_limit, progress
        As for `sensor_plan`.
    round_cost : number, default 1
        What a round costs besides its moves: the filter, and a first action that the prior holds
        already. More than 0.
    action_costs : number, or mapping from actions, default 1
        Costs of the actions.
    accepted : Decisions, or states, optional
        What can be accepted at the end of a round: one state of these; default: of all.
    good_enough : number, optional
        Cut a subplan off where its probability of success, given its readings, is this much.

    Returns
    -------
    SensorPlan
        Of least E[cost of a round] / P(success of a round).

    Raises
    ------
    NoPlanError
        If no plan ever succeeds.
    CostError
        If the cost of a round is not positive.

    Examples
    --------
    The prior of the errata, a sensor that tells one state from the rest, no action that helps:

    >>> problem = PlanningProblem(
    ...     range(5), ["0.6", "0.1", "0.1", "0.1", "0.1"], ["wait"],
    ...     [[[int(j == k) for j in range(5)] for k in range(5)]])
    >>> sensor = Sensor.from_function(range(5), lambda state: "it" if state == 0 else "other")
    >>> plan = iterative_sensor_plan(problem, sensor, 2)
    >>> plan.expected_cost, plan.success, plan.proven
    (mpq(10,7), mpq(7,10), True)
    """
    check_problem(problem)
    if not isinstance(accepted, Decisions):
        accepted = accept_one_of(problem.states, accepted)
    prices = read_prices(problem, action_costs)
    task = PlanTask(problem, sensors, accepted, prices, horizon, stages, node_limit)
    task.round_cost = task.number(round_cost, "cost of a round")
    if not task.round_cost > 0:
        raise CostError(f"{task.round_cost}; accepted: more than 0", where="cost of a round")
    task.good_enough = None if good_enough is None else task.number(good_enough, "good enough")
    return task.run(time_limit, progress)


def plan_for_cost(
    problem: PlanningProblem, sensors: Sensors, horizon: int | None = None, **settings: Any
) -> SensorPlan:
    """Return the best plan with sensors by the problem's own cost.

    Parameters
    ----------
    problem : PlanningProblem
        With an `IterativeCost`, or one that is additive.
    sensors, horizon, **settings
        As for `iterative_sensor_plan`, or `sensor_plan`.

    Raises
    ------
    SensorError
        If the problem's cost is of another kind: the recursion holds for these.

    Examples
    --------
    >>> problem = PlanningProblem(
    ...     range(3), ["1/2", "1/4", "1/4"], ["wait"], [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]],
    ...     IterativeCost(test=2))
    >>> plan_for_cost(problem, Sensor.from_function(range(3), lambda s: s == 0), 1).expected_cost
    mpq(8,3)
    """
    check_problem(problem)
    cost = problem.cost
    if not isinstance(cost, IterativeCost):
        return sensor_plan(problem, sensors, horizon, **settings)
    return iterative_sensor_plan(
        problem,
        sensors,
        horizon,
        round_cost=cost.test,
        action_costs=cost.actions,
        accepted=_accepted_by(cost, problem),
        **settings,
    )


def ends_by_cost(problem: PlanningProblem) -> tuple[Decisions, tuple[Any, ...], Any]:
    """Return what plans end in, the prices of the actions, and the cost of a round or None.

    By the problem's own cost, as `plan_for_cost` takes it; without a cost plans accept a state and
    actions cost nothing.

    Raises
    ------
    SensorError
        If the problem's cost is neither iterative nor additive.

    Examples
    --------
    >>> problem = PlanningProblem.from_matrices(["1/2", "1/2"], {"turn": [[0, 1], [1, 0]]})
    >>> ends_by_cost(problem)[1:]
    ((mpq(0,1),), None)
    >>> ends_by_cost(problem.with_cost(IterativeCost(test=2)))[1:]
    ((mpq(1,1),), 2)
    """
    cost = problem.cost
    if cost is None:
        return accept_one_of(problem.states), read_prices(problem, 0), None
    if not isinstance(cost, IterativeCost):
        return *lose_by_state(problem), None
    return _accepted_by(cost, problem), read_prices(problem, cost.actions), cost.test


def _accepted_by(cost: IterativeCost, problem: PlanningProblem) -> Decisions:
    if cost.goal is None:
        return accept_one_of(problem.states)
    states = [problem.states[k] for k in goal_numbers(problem, cost.goal)]
    return accept_groups(problem.states, {"goal": states})
