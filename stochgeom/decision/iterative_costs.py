"""Plans that are tried until they succeed: their expected cost (thesis 2.3, Eq. 4.5).

A round spends the actions of the plan and one test of success. Rounds are independent, because the
state is randomised between them; so with success probability p the number N of rounds is geometric,
of mean 1 / p, and the expected cost is (cost of a round) / p.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.decision.additive_costs import goal_numbers
from stochgeom.decision.costs import CostOverProbability
from stochgeom.decision.costs_to_go import CostsToGo, Values, mean
from stochgeom.decision.infinity import INFINITE, is_infinite
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_costs import CostModel, PlanCost, Prices, read_prices
from stochgeom.decision.rounds import Rounds

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class IterativeCost(PlanCost):
    """Expected cost of a plan that is repeated until it ends in a goal state.

    Parameters
    ----------
    goal : state, or list or set of states, optional
        Where a round succeeds. Default: in the most likely final state, whichever that is
        (Eq. 4.4).
    actions : number >= 0, or mapping, default 1
        What an action costs.
    test : number >= 0, default 1
        What the test of success costs, once in each round: the filter of a part feeder.

    Examples
    --------
    A die is thrown until it shows a three (thesis 2.3):

    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> throw = [["1/6"] * 6] * 6
    >>> die = PlanningProblem(range(1, 7), {1: 1}, ["throw"], [throw])
    >>> IterativeCost(goal=3, test=0).on(die).of_plan(["throw"])
    mpq(6,1)
    """

    goal: Hashable | Iterable[Hashable] | None = None
    actions: Prices = 1
    test: Any = 1

    def on(self, problem: PlanningProblem) -> IterativeModel:
        """Return the cost of the plans of a problem."""
        goals = None if self.goal is None else goal_numbers(problem, self.goal)
        return IterativeModel(problem, self.actions, goals, self.test)

    def describe(self) -> str:
        """Return one line for people."""
        where = "its most likely state" if self.goal is None else "the goal"
        return f"expected cost of rounds until the plan ends in {where}"


@final
class IterativeModel(CostModel):
    """The expected cost of rounds, on a problem.

    The bound. With j more actions a plan has spent at least j times the least price more, and it
    succeeds at most with the probability that a policy attains which sees the state: sum of
    lambda_i U_j(i), with U_j(i) the largest probability to reach the goal from i with j or fewer
    observed actions. The least quotient for j = 0 to k is a bound; without a limit k, or for a j so
    large that U_j is not computed, U_j is replaced by 1. If every final state may be the goal, the
    goal of the largest sum counts.
    """

    def __init__(
        self,
        problem: PlanningProblem,
        actions: Prices,
        goals: frozenset[int] | None,
        test: Any,
    ) -> None:
        super().__init__(problem, actions)
        self.test = read_prices(problem, test)[0]
        n = len(problem.states)
        self._goals = [frozenset([g]) for g in range(n)] if goals is None else [goals]
        free = tuple(price * 0 for price in self.prices)
        one = free[0] + 1
        self._misses = [
            CostsToGo(problem, free, tuple(one * (i not in goal) for i in range(n)))
            for goal in self._goals
        ]
        self._reach: dict[int, list[Values] | None] = {}

    def success(self, hyperstate: Vector) -> Any:
        """Return the probability that a round which ends in a hyperstate succeeds."""
        return max(sum(hyperstate[i] for i in sorted(goal)) for goal in self._goals)

    def rounds(self, hyperstate: Vector) -> Rounds:
        """Return the number of rounds of a plan that ends in a hyperstate.

        Raises
        ------
        InputError
            If it never succeeds.
        """
        return Rounds(self.success(hyperstate))

    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return (spent + test) / p."""
        return self._over(spent + self.test, self.success(hyperstate))

    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return the least of (spent + j * least price + test) / (bound on p), for all j."""
        best = self.value(spent, hyperstate)
        if left is None:
            return min(best, self.floor(spent + self.least_price))
        # Free actions only help: then the largest j alone gives the least quotient.
        first = 1 if self.least_price else max(left, 1)
        for j in range(first, left + 1):
            # No round of so many actions, or more, is cheaper than one that is sure to succeed.
            least = self.floor(spent + j * self.least_price)
            tables = self._reach_within(j)
            if tables is None or not least < best:
                return min(best, least)
            reach = max(mean(hyperstate, table) for table in tables)
            best = min(best, self._over(spent + j * self.least_price + self.test, reach))
        return best

    def floor(self, spent: Any) -> Any:
        """Return spent + test, the cost of one round."""
        return self._over(spent + self.test, self._certain)

    def as_cost(self, value: Any) -> Any:
        """Return a number in the form of this model's costs."""
        number = super().as_cost(value)
        return number if is_infinite(number) else self._over(number, self._certain)

    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans at once."""
        success = np.max([hyperstates[:, sorted(g)].sum(axis=1) for g in self._goals], axis=0)
        found = np.full(len(success), np.inf)
        np.divide(spent + self.test, success, out=found, where=success > 0)
        return found

    def _reach_within(self, actions: int) -> list[Values] | None:
        """Return for each goal U_j, None if j is so large that it is not computed."""
        if actions not in self._reach:
            misses = [miss.within(actions) for miss in self._misses]
            self._reach[actions] = (
                None
                if None in misses
                else [tuple(1 - v for v in miss) for miss in misses if miss is not None]
            )
        return self._reach[actions]

    @property
    def _certain(self) -> Any:
        return self.problem.prior[0] * 0 + 1

    def _over(self, per_round: Any, probability: Any) -> Any:
        if not probability:
            return INFINITE if self.problem.exact else math.inf
        if self.problem.numbers is NumberKind.ANGLE_SUMS:
            return CostOverProbability(mpq(per_round), probability)
        return per_round / probability
