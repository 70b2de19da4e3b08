"""Planning with perfect information: the state is seen before every action (thesis 2.4, 2.5.1).

Dynamic programming over the costs to go (`stochgeom.decision.costs_to_go`): what to do in each
state with each number of actions left. With a certain initial state and deterministic actions,
that is an ordinary shortest path.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, final

from stochgeom.decision.additive_costs import AdditiveModel
from stochgeom.decision.costs_to_go import Values, backed_up, mean
from stochgeom.decision.plan_results import model_of
from stochgeom.errors import InputError, ProblemError

if TYPE_CHECKING:
    from stochgeom.decision.plan_costs import PlanCost
    from stochgeom.decision.planning_problem import PlanningProblem

_ADDITIVE: Final = "AdditiveCost, GoalCost, GuaranteedCost"


@final
@dataclass(frozen=True)
class ObservedPolicy:
    """What to do in each state when every state is seen.

    Attributes
    ----------
    problem : PlanningProblem
        Whose states and actions.
    horizon : int
        Most actions.
    costs : tuple of tuple
        ``costs[k][i]`` is V_k(i), the least expected cost from state i with at most k actions left.
    choices : tuple of tuple
        ``choices[k][i]`` is the action that attains it, the first of equal ones; None: stop. Of
        stopping and an action that are equally good, stop.
    expected_cost : number
        The least expected cost from the prior.
    """

    problem: PlanningProblem
    horizon: int
    costs: tuple[Values, ...]
    choices: tuple[tuple[Any, ...], ...]

    @property
    def expected_cost(self) -> Any:
        """The least expected cost from the prior."""
        return mean(self.problem.prior, self.costs[self.horizon])

    def action(self, state: Any, left: int) -> Any:
        """Return what to do in a state with so many actions left; None: stop.

        Raises
        ------
        InputError
            If `left` is not from 0 to the horizon.
        """
        if not 0 <= left <= self.horizon:
            raise InputError(f"{left} actions left; accepted: 0 to {self.horizon}")
        return self.choices[left][self.problem.state_number(state)]


def observed_policy(
    problem: PlanningProblem, horizon: int, cost: PlanCost | None = None
) -> ObservedPolicy:
    """Return the best policy of at most so many actions if the state is seen each time.

    Parameters
    ----------
    problem : PlanningProblem
        States, actions, matrices, prior.
    horizon : int
        Most actions.
    cost : AdditiveCost, GoalCost or GuaranteedCost, optional
        Default: the problem's own. It must be additive: of other costs the best action in a state
        depends on more than the state.

    Raises
    ------
    ProblemError
        If the cost is missing or not additive.
    InputError
        If the horizon is negative.

    Examples
    --------
    A walk on three places that fails to move one time in four; the goal is at the right end.

    >>> from gmpy2 import mpq
    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> def walk(place, action):
    ...     to = min(max(place + (1 if action == "right" else -1), 0), 2)
    ...     return {to: 1} if to == place else {to: mpq(3, 4), place: mpq(1, 4)}
    >>> problem = PlanningProblem.from_function(range(3), {0: 1}, ["left", "right"], walk)
    >>> seen = observed_policy(problem, 3, AdditiveCost(actions="1/10", states={0: 1, 1: 1}))
    >>> seen.expected_cost, seen.action(1, 3), seen.action(2, 3)
    (mpq(63,160), 'right', None)
    """
    model = model_of(problem, cost)
    if not isinstance(model, AdditiveModel):
        raise ProblemError(f"{model.__class__.__name__} is not additive; accepted: {_ADDITIVE}")
    if horizon < 0:
        raise InputError(f"horizon {horizon}; accepted: 0 or more")
    costs = [model.state_costs]
    choices: list[tuple[Any, ...]] = [(None,) * len(problem.states)]
    for _ in range(horizon):
        following, best = backed_up(problem, model.prices, model.state_costs, costs[-1])
        costs.append(following)
        choices.append(tuple(None if k is None else problem.actions[k] for k in best))
    return ObservedPolicy(problem, horizon, tuple(costs), tuple(choices))
