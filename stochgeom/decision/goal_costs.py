"""Costs of missing a goal: one for each miss, or infinite (thesis 2.1, 2.5.3, 7.1.1).

On a problem both are additive, with the same cost for every state that is no goal. Infinite cost
off the goal makes guaranteed plans a special case: with 0 * infinity = 0, a plan has finite cost
exactly if it is certain to succeed, and the best one is the cheapest of these.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

from stochgeom.decision.additive_costs import AdditiveModel, goal_numbers
from stochgeom.decision.infinity import INFINITE
from stochgeom.decision.plan_costs import PlanCost, Prices, read_state_costs

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem


@final
@dataclass(frozen=True)
class GoalCost(PlanCost):
    """What the actions cost plus the probability of missing the goal.

    Parameters
    ----------
    goal : state, or list or set of states
        Where the plan should end.
    actions : number >= 0, or mapping, default 0
        What an action costs.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
    >>> GoalCost("1").on(turn).of_plan(["turn"])
    mpq(3,4)
    """

    goal: Hashable | Iterable[Hashable]
    actions: Prices = 0

    def on(self, problem: PlanningProblem) -> AdditiveModel:
        """Return the cost of the plans of a problem."""
        return _off_goal(problem, self.goal, 1, self.actions)

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions plus probability of missing the goal"


@final
@dataclass(frozen=True)
class GuaranteedCost(PlanCost):
    """What the actions cost if the plan is certain to end in the goal, else infinity.

    Parameters
    ----------
    goal : state, or list or set of states
        Where the plan must end.
    actions : number >= 0, or mapping, default 1
        What an action costs.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> turn = PlanningProblem.from_matrices(["0", "1"], {"turn": [[0, 1], [1, 0]]})
    >>> GuaranteedCost("0").on(turn).of_plan(["turn"])
    mpq(1,1)
    """

    goal: Hashable | Iterable[Hashable]
    actions: Prices = 1

    def on(self, problem: PlanningProblem) -> AdditiveModel:
        """Return the cost of the plans of a problem."""
        return _off_goal(problem, self.goal, INFINITE, self.actions)

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions if the goal is certain, else infinite"


def _off_goal(problem: PlanningProblem, goal: Any, cost: Any, actions: Prices) -> AdditiveModel:
    inside = goal_numbers(problem, goal)
    costs = {state: cost for k, state in enumerate(problem.states) if k not in inside}
    return AdditiveModel(problem, actions, read_state_costs(problem, costs))
