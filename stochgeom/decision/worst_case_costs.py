"""Minimax: plans ranked by the worst that can happen, whatever its probability (thesis 7.1.1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.decision.costs_to_go import CostsToGo, Values
from stochgeom.decision.plan_costs import CostModel, PlanCost, Prices, read_state_costs

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class MinimaxCost(PlanCost):
    """What the actions cost plus the cost of the worst final state that is possible.

    Parameters
    ----------
    actions : number >= 0, or mapping from actions to numbers, default 0
        What an action costs.
    states : number, or mapping from states to numbers, default 0
        What it costs to end in a state; infinite costs off a goal rank the guaranteed plans.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> fall = PlanningProblem(
    ...     ["up", "down"], ["1/4", "3/4"], ["wait", "tip"],
    ...     [[[1, 0], [0, 1]], [["1/10", "9/10"], [0, 1]]],
    ... )
    >>> cost = MinimaxCost(states={"up": 3, "down": 2}).on(fall)
    >>> cost.of_plan(["tip"]), cost.value(0, fall.vector(["0", "1"]))
    (mpq(3,1), mpq(2,1))
    """

    actions: Prices = 0
    states: Any = 0

    def on(self, problem: PlanningProblem) -> MinimaxModel:
        """Return the cost of the plans of a problem."""
        return MinimaxModel(problem, self.actions, read_state_costs(problem, self.states))

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions plus cost of the worst possible final state"


@final
class MinimaxModel(CostModel):
    """A minimax cost on a problem.

    The bound is spent + the largest W_k(i) over the possible states i, with W_k(i) the least cost
    from i when the state is seen and the next state is the worst possible one. Any sequence of k or
    fewer actions has a worst course from i that costs at least W_k(i), by induction over its
    length: its first action may lead to whichever next state is worst for the rest of it.
    """

    def __init__(self, problem: PlanningProblem, actions: Prices, state_costs: Values) -> None:
        super().__init__(problem, actions)
        self.state_costs = state_costs
        self._floor = min(state_costs)
        self._to_go = CostsToGo(problem, self.prices, state_costs, worst_case=True)

    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return spent + the largest C(i) of a possible state."""
        return spent + self._worst(hyperstate, self.state_costs)

    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return spent + the largest W_left(i) of a possible state."""
        costs = None if left is None else self._to_go.within(left)
        if costs is None:
            return self.floor(spent)
        return spent + self._worst(hyperstate, costs)

    @staticmethod
    def _worst(hyperstate: Vector, costs: Values) -> Any:
        return max(cost for share, cost in zip(hyperstate, costs, strict=True) if share)

    def floor(self, spent: Any) -> Any:
        """Return spent + the least C(i)."""
        return spent + self._floor

    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans at once."""
        costs = np.asarray(self.state_costs, dtype=np.float64)
        found: NDArray[np.float64] = spent + np.where(hyperstates > 0, costs, -np.inf).max(axis=1)
        return found
