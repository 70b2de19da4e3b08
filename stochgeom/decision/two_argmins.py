"""Decision theory and manipulation planning side by side (Eq. 2.6 to 2.8).

A decision leaves the state as it is: its expected cost weighs C(a, theta) by what is known of the
state, a posterior given data,

    a* = argmin over a of sum over theta of C(a, theta) lambda(theta | x)            (Eq. 2.6)

A manipulation changes the state, and what counts is where the action leads:

    a* = argmin over a of sum over theta of C(a, theta) lambda(theta | a)            (Eq. 2.8)

with lambda(. | a) = lambda P_a. The two are equal for all costs only if no action moves anything.
(The source says "maximize expected cost" before Eq. 2.6; it is the minimum.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, final

from stochgeom.arguments import as_list, expect
from stochgeom.decision.costs_to_go import mean
from stochgeom.decision.number_kinds import NumberKind, read_number
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class TwoArgmins:
    """The best actions by both formulas.

    Attributes
    ----------
    decision_costs, manipulation_costs : dict from actions to numbers
        The expected cost of each action if the state stays, and if the action moves it.
    """

    decision_costs: dict[Any, Any]
    manipulation_costs: dict[Any, Any]

    @property
    def decisions(self) -> tuple[Any, ...]:
        """The actions that attain the minimum of Eq. 2.6."""
        return _least(self.decision_costs)

    @property
    def manipulations(self) -> tuple[Any, ...]:
        """The actions that attain the minimum of Eq. 2.8."""
        return _least(self.manipulation_costs)


def two_argmins(
    problem: PlanningProblem,
    loss: Callable[[Any, Any], Any],
    hyperstate: Vector | None = None,
) -> TwoArgmins:
    """Return the best decision and the best manipulation for one cost of actions and states.

    Parameters
    ----------
    problem : PlanningProblem
        States, actions, matrices.
    loss : callable
        ``loss(action, state)`` is C(a, theta), of the problem's kind of numbers.
    hyperstate : vector, optional
        What is known of the state, such as a posterior; default: the prior.

    Examples
    --------
    A switch is on with probability 1/4, and it should be on. As a guess about the switch, "off" is
    better; as something done to it, to press "on" is:

    >>> switch = PlanningProblem(
    ...     ["on", "off"], ["1/4", "3/4"], ["on", "off"],
    ...     {"on": [[1, 0], [1, 0]], "off": [[0, 1], [0, 1]]},
    ... )
    >>> right = lambda action, state: 0 if action == state else 1
    >>> two_argmins(switch, right).decisions
    ('off',)
    >>> on = lambda action, state: 0 if state == "on" else 1
    >>> two_argmins(switch, on).decisions, two_argmins(switch, on).manipulations
    (('on', 'off'), ('on',))
    """
    check_problem(problem)
    expect(loss, Callable, "a function of an action and a state", "loss")
    if hyperstate is not None:
        hyperstate = tuple(as_list(hyperstate, "a list of probabilities", "hyperstate"))
    known = problem.prior if hyperstate is None else hyperstate
    decision, manipulation = {}, {}
    for action in problem.actions:
        costs = _costs(problem, loss, action)
        decision[action] = mean(known, costs)
        manipulation[action] = mean(problem.after(known, action), costs)
    return TwoArgmins(decision, manipulation)


def _costs(
    problem: PlanningProblem, loss: Callable[[Any, Any], Any], action: Any
) -> tuple[Any, ...]:
    kind = NumberKind.RATIONAL if problem.exact else NumberKind.FLOAT
    return tuple(
        read_number(
            loss(action, state), kind, f"loss of action {action!r:.40} in state {state!r:.40}"
        )
        for state in problem.states
    )


def _least(costs: dict[Any, Any]) -> tuple[Any, ...]:
    least = min(costs.values())
    return tuple(action for action, cost in costs.items() if cost == least)
