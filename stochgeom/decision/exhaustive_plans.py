"""All plans up to a horizon, one by one: brute force (thesis 2.4, 6.4).

With m actions there are m + m^2 + ... + m^k plans of 1 to k actions. Nothing is merged and nothing
is left out; the searches that do so must find the same. Float problems go through numpy level by
level, all actions and all beginnings at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_count
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_results import NODE_LIMIT, Limits, PlanResult, check_problem
from stochgeom.errors import NodeLimitError

if TYPE_CHECKING:
    from stochgeom.decision.plan_costs import CostModel
    from stochgeom.decision.planning_problem import PlanningProblem, Vector

_BLOCK: Final = 1 << 13
"""Beginnings that are extended at once: more would not fit a processor's cache."""


_BEYOND: Final = 12
"""Actions beyond the largest horizon that is possible, up to which plans are counted to be told."""


def count_plans(actions: int, horizon: int, shortest: int = 1) -> int:
    """Return the number of plans of `shortest` to `horizon` actions.

    Examples
    --------
    >>> count_plans(12, 5), count_plans(12, 3)
    (271452, 1884)
    """
    return sum(actions**k for k in range(shortest, horizon + 1))


def fitting_horizon(actions: int, horizon: int, shortest: int, node_limit: int) -> int:
    """Return the largest horizon, up to a given one, with no more plans than the limit.

    Examples
    --------
    >>> fitting_horizon(12, 10**9, 1, 1_000_000), fitting_horizon(12, 3, 1, 1_000_000)
    (5, 3)
    """
    total = 0
    for length in range(shortest, horizon + 1):
        total += actions**length
        if total > node_limit:
            return length - 1
    return horizon


def check_count(actions: int, horizon: int, shortest: int, node_limit: int) -> int:
    """Return the number of plans if it is within the limit.

    Raises
    ------
    NodeLimitError
        If it is not; the number is told unless it is huge, and the largest horizon within the
        limit.
    """
    fits = fitting_horizon(actions, horizon, shortest, node_limit)
    if fits < horizon:
        shown = min(horizon, fits + _BEYOND)
        more = "more than " if shown < horizon else ""
        raise NodeLimitError(
            f"{actions} actions make {more}{count_plans(actions, shown, shortest)} plans of at "
            f"most {horizon}, the limit is {node_limit} nodes; accepted: a horizon of at most "
            f"{max(fits, 0)}, or a higher limit",
            where="horizon",
        )
    return count_plans(actions, horizon, shortest)


def every_plan(
    problem: PlanningProblem, horizon: int, *, shortest: int = 1
) -> Iterator[tuple[tuple[Any, ...], Vector]]:
    """Yield every plan with the hyperstate it leads to, in lexicographic order.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> turn = PlanningProblem.from_matrices([1, 0], {"turn": [[0, 1], [1, 0]]})
    >>> [len(plan) for plan, hyperstate in every_plan(turn, 2, shortest=0)]
    [0, 1, 2]
    """
    check_problem(problem)
    horizon = as_count(horizon, "actions", least=0, where="horizon")
    shortest = as_count(shortest, "actions", least=0, where="shortest")
    pending: list[tuple[tuple[Any, ...], Vector]] = [((), problem.prior)]
    while pending:
        plan, hyperstate = pending.pop()
        if len(plan) >= shortest:
            yield plan, hyperstate
        if len(plan) < horizon:
            pending += [
                ((*plan, action), problem.after(hyperstate, action))
                for action in reversed(problem.actions)
            ]


def exhaustive_search(
    model: CostModel,
    horizon: int,
    *,
    shortest: int = 1,
    all_optimal: bool = False,
    node_limit: int = NODE_LIMIT,
    limits: Limits | None = None,
) -> PlanResult:
    """Return the best of all plans up to a horizon.

    Raises
    ------
    NodeLimitError
        If there are more plans than the node limit.
    """
    problem = model.problem
    total = check_count(len(problem.actions), horizon, shortest, node_limit)
    if problem.numbers is NumberKind.FLOAT:
        cost, words = _best_floats(model, horizon, shortest, all_optimal)
    else:
        cost, words = _best_exact(model, horizon, shortest, limits)
    plans = tuple(words if all_optimal else words[:1])
    end = problem.run(plans[0])
    return PlanResult(
        problem, plans[0], cost, end, True, cost, plans, total, total, "proven", model
    )


def _best_exact(
    model: CostModel, horizon: int, shortest: int, limits: Limits | None
) -> tuple[Any, list[tuple[Any, ...]]]:
    best: Any = None
    plans: list[tuple[Any, ...]] = []
    for made, (plan, hyperstate) in enumerate(
        every_plan(model.problem, horizon, shortest=shortest)
    ):
        if limits is not None:
            limits.reached(made)  # only to show the progress: the number of plans is known
        cost = model.value(model.spent_on(plan), hyperstate)
        if not plans or cost < best or (not best < cost and len(plan) < len(plans[0])):
            best, plans = cost, [plan]
        elif not best < cost and len(plan) == len(plans[0]):
            plans.append(plan)
    return best, plans


def _best_floats(
    model: CostModel, horizon: int, shortest: int, all_optimal: bool
) -> tuple[float, list[tuple[Any, ...]]]:
    problem = model.problem
    prices = np.array(model.prices, dtype=np.float64)
    side_by_side = np.hstack(list(problem.stacked))
    hyperstates = np.asarray(problem.prior, dtype=np.float64)[np.newaxis]
    spent = np.zeros(1)
    best, words = np.inf, np.array([-1])
    length = 0
    if shortest == 0:
        best, words = float(model.values(spent, hyperstates)[0]), np.array([0])
    for depth in range(1, horizon + 1):
        last = depth == horizon
        kept: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
        for start in range(0, len(spent), _BLOCK):
            block = slice(start, start + _BLOCK)
            # One product; rows in the order of the plans: a beginning's extensions stand together.
            rows = (hyperstates[block] @ side_by_side).reshape(-1, len(problem.states))
            total = (spent[block, np.newaxis] + prices).ravel()
            costs = model.values(total, rows)
            least = float(costs.min())
            if least < best or (words[0] < 0 and length == 0):
                best, length, words = least, depth, np.array([], dtype=int)
            if least == best and length == depth:
                words = np.concatenate([words, np.flatnonzero(costs == best) + start * len(prices)])
                words = words if all_optimal else words[:1]
            if not last:
                kept.append((rows, total))
        if not last:
            hyperstates = np.concatenate([rows for rows, _ in kept])
            spent = np.concatenate([total for _, total in kept])
    return best, [_word(problem, int(number), length) for number in words]


def _word(problem: PlanningProblem, number: int, length: int) -> tuple[Any, ...]:
    """Return the plan whose number in base m has the actions for digits."""
    word = []
    for _ in range(length):
        number, digit = divmod(number, len(problem.actions))
        word.append(problem.actions[digit])
    return tuple(reversed(word))
