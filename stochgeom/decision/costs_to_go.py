"""Costs to go: the least cost from each state if the state is seen before every action.

The best that can be done from a state with at most k actions left obeys Bellman's recursion

    V_0(i) = C(i),    V_k(i) = min(C(i), min over a of c(a) + sum over j of p_ij(a) V_(k-1)(j)),

which is dynamic programming: O(k m n^2) for n states and m actions, exact on exact problems.

Who sees less cannot do better: an open-loop plan chooses its actions for all states alike, so its
cost from a hyperstate lambda is at least sum lambda_i V_k(i). That is the bound which branch and
bound over open-loop plans uses.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Final, TypeAlias, final

import numpy as np

from stochgeom.decision.angle_products import product
from stochgeom.decision.infinity import INFINITE
from stochgeom.decision.probabilities import Enclosed

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem

Values: TypeAlias = "tuple[Any, ...]"
"""For each state a cost."""

DEEPEST: Final = 64
"""Most actions left for which costs to go are computed: exact numbers grow with each step."""

Combine: TypeAlias = "Callable[[Sequence[tuple[int, Any]], Values], Any]"
"""What the possible next states, with probabilities, and their costs make together."""


@final
class CostsToGo:
    """V_0, V_1, ... of a problem, each computed when it is first asked for.

    Parameters
    ----------
    problem : PlanningProblem
        States, actions and matrices.
    prices : tuple of numbers
        What each action costs.
    state_costs : tuple
        C, perhaps infinite.
    worst_case : bool, default False
        Take the worst possible next state instead of the mean.
    """

    def __init__(
        self,
        problem: PlanningProblem,
        prices: Values,
        state_costs: Values,
        *,
        worst_case: bool = False,
    ) -> None:
        self._problem, self._prices = problem, prices
        self._costs = [state_costs]
        self._settled = False
        self._combine: Combine = _worst if worst_case else _mean_of_successors

    def __call__(self, left: int) -> Values:
        """Return V_k for k actions left."""
        self._reach(left)
        return self._costs[min(left, len(self._costs) - 1)]

    def within(self, left: int) -> Values | None:
        """Return V_k, or None if k is above `DEEPEST` and V still changes there."""
        self._reach(min(left, DEEPEST + 1))
        return self(left) if left <= DEEPEST or self._settled else None

    def _reach(self, left: int) -> None:
        while len(self._costs) <= left and not self._settled:
            following, _ = backed_up(
                self._problem, self._prices, self._costs[0], self._costs[-1], self._combine
            )
            self._settled = following == self._costs[-1]  # then nothing changes any more
            if not self._settled:
                self._costs.append(following)


def backed_up(
    problem: PlanningProblem,
    prices: Values,
    state_costs: Values,
    following: Values,
    combine: Combine | None = None,
) -> tuple[Values, list[int | None]]:
    """Return V_k and the choices that attain it, from V_(k-1): one step of the recursion."""
    combine = _mean_of_successors if combine is None else combine
    costs: list[Any] = []
    choices: list[int | None] = []
    for state, stop in enumerate(state_costs):
        best, choice = stop, None
        for number, price in enumerate(prices):
            cost = price + combine(problem.successors(number, state), following)
            if cost < best:
                best, choice = cost, number
        costs.append(best)
        choices.append(choice)
    return tuple(costs), choices


def mean(hyperstate: Any, costs: Values) -> Any:
    """Return sum lambda_i C_i with 0 * infinity = 0.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> mean((mpq(1, 2), mpq(1, 2), mpq(0)), (mpq(1), mpq(2), INFINITE))
    mpq(3,2)
    """
    if isinstance(hyperstate, np.ndarray):
        array = np.asarray(costs)
        endless = np.isinf(array)
        if (hyperstate[endless] > 0).any():
            return math.inf
        return float(hyperstate @ np.where(endless, 0.0, array))
    total = hyperstate[0] * 0
    for share, cost in zip(hyperstate, costs, strict=True):
        if share:
            if cost is INFINITE:
                return INFINITE
            if cost:
                total += share * cost
    return total


def enclosed_mean(hyperstate: Sequence[Any], costs: Values) -> Any:
    """Return sum lambda_i C_i of angle sums by angle sums, as `Enclosed`; see `mean`."""
    total = Enclosed([])
    for share, cost in zip(hyperstate, costs, strict=True):
        if share:
            if cost is INFINITE:
                return INFINITE
            total += product(share, cost)
    return total


def _mean_of_successors(entries: Sequence[tuple[int, Any]], costs: Values) -> Any:
    total: Any = 0
    for j, p in entries:
        total = total + (costs[j] if p == 1 else p * costs[j])
    return total


def _worst(entries: Sequence[tuple[int, Any]], costs: Values) -> Any:
    return max(costs[j] for j, _ in entries)
