"""Additive costs: what the actions cost plus the expected cost of the state at the end.

    C(plan, lambda) = c(a_1) + ... + c(a_k) + sum over i of lambda_i C(i)          (Eq. 2.5, 2.7)

The distance to a goal orientation is one of them; two more have names of their own in
`stochgeom.decision.goal_costs`.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.decision.costs_to_go import CostsToGo, Values, enclosed_mean, mean
from stochgeom.decision.infinity import is_infinite
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_costs import CostModel, PlanCost, Prices, read_state_costs
from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import CostError
from stochgeom.exact.angle_base import AngleBase
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class AdditiveCost(PlanCost):
    """What the actions cost plus the expected cost of the final state.

    Parameters
    ----------
    actions : number >= 0, or mapping from actions to numbers, default 0
        What an action costs.
    states : number, or mapping from states to numbers, default 0
        What it costs to end in a state: any sign, `math.inf` or ``"infinite"`` among them. States
        left out of a mapping cost 0. Sums of angles are accepted as well.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
    >>> AdditiveCost("1/8", {"1": 1}).on(turn).of_plan(["turn", "turn"])
    mpq(1,1)
    """

    actions: Prices = 0
    states: Any = 0

    def on(self, problem: PlanningProblem) -> AdditiveModel:
        """Return the cost of the plans of a problem."""
        return AdditiveModel(problem, self.actions, read_state_costs(problem, self.states))

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions plus expected cost of the final state"


@final
class AdditiveModel(CostModel):
    """An additive cost on a problem.

    The bound is spent + sum lambda_i V_k(i), with V_k(i) the least expected cost from state i with
    at most k actions when the state is seen (`stochgeom.decision.costs_to_go`). A sequence
    of k or fewer further actions costs, given that the state is i now, at least V_k(i), since the
    policy that goes through the same sequence is among those V_k is the least of; and its cost is
    the mean of these over lambda. Without a limit k, or if it is so large that V_k is not computed,
    V_k is replaced by the least C(i).

    Attributes
    ----------
    state_costs : tuple
        C(i), perhaps infinite.
    """

    def __init__(
        self, problem: PlanningProblem, actions: Prices, state_costs: tuple[Any, ...]
    ) -> None:
        super().__init__(problem, actions)
        self.state_costs = state_costs
        self._floor = min(state_costs)
        # A probability and a cost that are both sums of angles have no exact product.
        irrational = any(isinstance(cost, AngleSum) for cost in state_costs)
        self._enclosed = irrational and problem.numbers is NumberKind.ANGLE_SUMS
        finite = [cost for cost in state_costs if not is_infinite(cost)]
        factors = [*problem.prior, *finite] if self._enclosed else []
        self._base = AngleBase(map(AngleSum.of, factors))
        self._to_go = CostsToGo(problem, self.prices, state_costs)

    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return spent + sum lambda_i C(i)."""
        return self._mean(hyperstate, self.state_costs) + self._number(spent)

    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return spent + sum lambda_i V_left(i)."""
        costs = None if left is None else self._to_go.within(left)
        if costs is None:
            return self.floor(spent)
        return self._mean(hyperstate, costs) + self._number(spent)

    def floor(self, spent: Any) -> Any:
        """Return spent + the least C(i)."""
        return self._number(spent + self._floor)

    def as_cost(self, value: Any) -> Any:
        """Return a number in the form of this model's costs."""
        return self._number(super().as_cost(value))

    def _number(self, value: Any) -> Any:
        if not self._enclosed or is_infinite(value):
            return value
        return Enclosed([], AngleSum.of(value))

    def _mean(self, hyperstate: Any, costs: Values) -> Any:
        if not self._enclosed:
            return mean(hyperstate, costs)
        shares = [self._base.write(share) for share in hyperstate]
        return enclosed_mean(
            shares, tuple(c if is_infinite(c) else self._base.write(AngleSum.of(c)) for c in costs)
        )

    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans at once."""
        costs = np.asarray(self.state_costs, dtype=np.float64)
        endless = np.isinf(costs)
        found: NDArray[np.float64] = spent + hyperstates @ np.where(endless, 0.0, costs)
        if endless.any():
            found[(hyperstates[:, endless] > 0).any(axis=1)] = np.inf
        return found


def distance_cost(
    orientations: Mapping[Any, Angle], goal: Angle, actions: Prices = 0
) -> AdditiveCost:
    """Return the expected distance on the circle from a goal orientation, in degrees.

    Parameters
    ----------
    orientations : mapping from states to Angle
        Where each state is.
    goal : Angle
        Where it should be.
    actions : number, or mapping, default 0
        What the actions cost, in degrees.

    Raises
    ------
    CostError
        For an orientation that is no Angle.

    Notes
    -----
    A distance is rational where both orientations are multiples of an eighth of a turn, or 71
    degrees and 11; otherwise it is an angle sum. A rational prior makes an angle sum of these; a
    prior of angle sums makes an enclosed number, certified but not exact.

    Examples
    --------
    >>> cost = distance_cost({"a": Angle.from_degrees(350), "b": Angle(0, (0, 1))}, Angle())
    >>> [cost.states[state].decimal(1) for state in "ab"]
    ['10.0', '90.0']
    """
    distances = {}
    expect(orientations, Mapping, "a mapping from states to angles", "orientations")
    expect(goal, Angle, "an Angle", "goal")
    for state, angle in orientations.items():
        if not isinstance(angle, Angle):
            raise CostError(
                f"{angle!r:.60} is no orientation; accepted: an Angle",
                where=f"orientation of state {state!r:.40}",
            )
        way = (angle - goal) % FULL_TURN
        distances[state] = AngleSum(0, [(360, min(way, FULL_TURN - way))])
    return AdditiveCost(actions, distances)


def goal_numbers(problem: PlanningProblem, goal: Hashable | Iterable[Hashable]) -> frozenset[int]:
    """Return the places of the goal states: one state, or a list or set of some.

    Raises
    ------
    UnknownLabelError
        If one is no state of the problem.
    CostError
        If there is none.
    """
    if isinstance(goal, list | set | frozenset):
        found = frozenset(problem.state_number(state, where="goal") for state in goal)
    else:
        found = frozenset([problem.state_number(goal, where="goal")])  # type: ignore[arg-type]
    if not found:
        raise CostError("no goal state; accepted: at least one", where="goal")
    return found
