"""Satisfactory plans by chance: random plans until one is good enough (thesis 7.1.2).

Works well where many plans will do. The same seed gives the same plans.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from stochgeom.arguments import as_count
from stochgeom.decision.plan_results import Limits, PlanResult, model_of

if TYPE_CHECKING:
    from stochgeom.decision.plan_costs import CostModel, PlanCost
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


def random_plan(
    problem: PlanningProblem,
    horizon: int,
    cost: PlanCost | None = None,
    *,
    seed: int,
    tries: int = 1000,
    threshold: Any = None,
    time_limit: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> PlanResult:
    """Return the best of some random plans and all their beginnings.

    Parameters
    ----------
    problem : PlanningProblem
        The problem.
    horizon : int
        Length of the random plans; every action is equally likely at each place.
    cost : PlanCost, optional
        Default: the problem's own.
    seed : int
        Of the random numbers.
    tries : int, default 1000
        Most plans that are drawn.
    threshold : number, optional
        A plan that costs no more ends the search.
    time_limit : float, optional
        Most seconds.
    progress : callable, optional
        ``progress(share)`` is told how far the search is.

    Returns
    -------
    PlanResult
        Proven only if its cost is the lower bound, which is the cost with perfect information.

    Raises
    ------
    InputError
        If the horizon or the number of tries is below 1, or the seed below 0.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> from stochgeom.decision.goal_costs import GoalCost
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> problem = PlanningProblem.from_function(
    ...     range(4), [mpq(1, 4)] * 4, ["left", "right"],
    ...     lambda k, a: max(k - 1, 0) if a == "left" else min(k + 1, 3),
    ... )
    >>> found = random_plan(problem, 5, GoalCost(0), seed=1, threshold="1/4")
    >>> found.cost <= mpq(1, 4), found.reason
    (True, 'threshold')
    """
    horizon, tries = as_count(horizon, "actions", where="horizon"), as_count(tries, "tries")
    seed = as_count(seed, "as a seed", least=0)
    model = model_of(problem, cost)
    limits = Limits(tries * horizon, time_limit, progress)
    enough = None if threshold is None else model.as_cost(threshold)
    walks = _beginnings(model, horizon, random.Random(seed))
    plan, spent, hyperstate = next(walks)
    best = _Candidate(model.value(spent, hyperstate), plan, hyperstate)
    seen = {plan}
    made, reason = 1, "tries"
    while not limits.reached(made):
        if enough is not None and not enough < best.cost:
            reason = "threshold"
            break
        plan, spent, hyperstate = next(walks)
        made += 1
        seen.add(plan)
        best = best.better(_Candidate(model.value(spent, hyperstate), plan, hyperstate))
    bound = min(model.bound(model.nothing, problem.prior, horizon), best.cost)
    proven = not bound < best.cost
    if limits.reason == "time limit":
        reason = limits.reason
    labels = tuple(problem.actions[action] for action in best.plan)
    return PlanResult(
        problem,
        labels,
        best.cost,
        best.hyperstate,
        proven,
        bound,
        (labels,),
        made,
        len(seen),
        "proven" if proven else reason,
        model,
    )


@dataclass(frozen=True)
class _Candidate:
    cost: Any
    plan: tuple[int, ...]
    hyperstate: Vector

    def better(self, other: _Candidate) -> _Candidate:
        """Return the cheaper of two, of equal ones the shorter."""
        if other.cost < self.cost:
            return other
        is_shorter = len(other.plan) < len(self.plan)
        return other if is_shorter and not self.cost < other.cost else self


def _beginnings(
    model: CostModel, horizon: int, source: random.Random
) -> Iterator[tuple[tuple[int, ...], Any, Vector]]:
    """Yield random plans, each after all its beginnings: actions, what is spent, hyperstate."""
    problem = model.problem
    while True:
        plan: tuple[int, ...] = ()
        spent, hyperstate = model.nothing, problem.prior
        for _ in range(horizon):
            action = source.randrange(len(problem.actions))
            plan = (*plan, action)
            spent = spent + model.prices[action]
            hyperstate = problem.after_number(hyperstate, action)
            yield plan, spent, hyperstate
