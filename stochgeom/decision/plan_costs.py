"""What plans are compared by: a cost of the actions and of the hyperstate they end in (Eq. 2.5).

A `PlanCost` is what a user writes down; `PlanCost.on` ties it to a problem and gives a `CostModel`,
which the searches ask three things:

- the *price* of each action, a number of 0 or more; a plan has *spent* the sum of its prices;
- the *value* of having spent so much and being left with a hyperstate: the cost C of the plan;
- a *bound*: a number that no plan undercuts which begins like this one and has at most so many
  actions more. Each kind of cost proves its bound in its docstring; branch and bound rests on it.

More spent never costs less. So of two beginnings that lead to one hyperstate, one that has spent no
more and has as many actions left is at least as good whatever follows.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stochgeom.decision.infinity import INFINITE, is_infinite
from stochgeom.decision.number_kinds import NumberKind, common_kind, read_number
from stochgeom.errors import CostError, StochgeomError
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector

Prices: TypeAlias = "Any | Mapping[Hashable, Any]"
"""One number for every action, or a mapping from actions to numbers; those left out are 0."""


class PlanCost(ABC):
    """A cost of plans, before it is tied to a problem.

    Attributes
    ----------
    actions : number >= 0, or mapping from actions to numbers
        What the actions cost.
    """

    actions: Prices

    @abstractmethod
    def on(self, problem: PlanningProblem) -> CostModel:
        """Return the cost of the plans of a problem.

        Raises
        ------
        CostError
            If an action costs less than 0, or a number is of another kind than the problem's.
        UnknownLabelError
            If a state or an action is named that the problem does not have.
        """

    @abstractmethod
    def describe(self) -> str:
        """Return one line for people."""


class CostModel(ABC):
    """The cost of the plans of one problem.

    Attributes
    ----------
    problem : PlanningProblem
        Whose plans.
    prices : tuple of numbers
        What each action costs, 0 or more.
    least_price : number
        The smallest of them.
    """

    def __init__(self, problem: PlanningProblem, actions: Prices) -> None:
        self.problem = problem
        self.prices = read_prices(problem, actions)
        self.least_price = min(self.prices)

    @abstractmethod
    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return the cost of a plan that has spent so much and ends in a hyperstate."""

    @abstractmethod
    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return a lower bound on the cost of this plan and all that go on from it.

        Parameters
        ----------
        spent : number
            What the beginning has spent.
        hyperstate : vector
            What it ends in.
        left : int or None
            Most actions that may follow; None: any number.
        """

    @abstractmethod
    def floor(self, spent: Any) -> Any:
        """Return a lower bound on the cost of all plans that spend so much or more."""

    def longest(self, cost: Any) -> int | None:
        """Return how many actions a plan can have that costs as little as this, None if no end.

        There is a bound where the actions' prices are bounded away from 0, and the cost is not
        infinite (thesis 2.4): k actions spend at least k times the least price.

        Examples
        --------
        >>> from gmpy2 import mpq
        >>> from stochgeom.decision.additive_costs import AdditiveCost
        >>> from stochgeom.decision.planning_problem import PlanningProblem
        >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
        >>> AdditiveCost(actions="1/8", states={"1": 1}).on(turn).longest(mpq(3, 4))
        6
        """
        if not self.least_price or is_infinite(cost):
            return None
        low, high = 0, 1
        while not cost < self.floor(high * self.least_price):
            low, high = high, 2 * high
        while high - low > 1:
            # Invariant: so many as `low` may be worth their cost, so many as `high` are not.
            middle = (low + high) // 2
            if cost < self.floor(middle * self.least_price):
                high = middle
            else:
                low = middle
        return low

    @abstractmethod
    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans of a float problem at once, a row for each."""

    def spent_on(self, plan: Iterable[Hashable]) -> Any:
        """Return what a plan spends."""
        total = self.nothing
        for action in plan:
            total = total + self.prices[self.problem.action_number(action)]
        return total

    def of_plan(self, plan: Iterable[Hashable]) -> Any:
        """Return the cost of a plan, from the prior on.

        Examples
        --------
        >>> from stochgeom.decision.additive_costs import AdditiveCost
        >>> from stochgeom.decision.planning_problem import PlanningProblem
        >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
        >>> AdditiveCost(actions="1/8", states={"1": 1}).on(turn).of_plan(["turn"])
        mpq(3,8)
        """
        actions = list(plan)
        return self.value(self.spent_on(actions), self.problem.run(actions))

    def as_cost(self, value: Any) -> Any:
        """Return a number in the form of this model's costs, so that the two compare.

        Raises
        ------
        CostError
            If it is of another kind than the problem's numbers.
        """
        return _read_cost(self.problem, value, "cost")

    @property
    def nothing(self) -> Any:
        """What the empty plan spends: 0, of the problem's kind."""
        return self.prices[0] * 0


def read_prices(problem: PlanningProblem, actions: Prices) -> tuple[Any, ...]:
    """Return what each action costs: one number of 0 or more for each.

    Raises
    ------
    CostError
        If one is negative, infinite, or of another kind than the problem's numbers.
    UnknownLabelError
        If a mapping names an action that does not exist.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> turn = PlanningProblem.from_matrices([1, 0], {"turn": [[0, 1], [1, 0]]})
    >>> read_prices(turn, "1/2"), read_prices(turn, {})
    ((mpq(1,2),), (mpq(0,1),))
    """
    prices = _read_each(problem, actions, problem.actions, problem.action_number, "action")
    for label, price in zip(problem.actions, prices, strict=True):
        if is_infinite(price) or isinstance(price, AngleSum) or price < 0:
            raise CostError(
                f"the cost is {price}; accepted: a rational number or a float, 0 or more",
                where=f"cost of action {label!r:.40}",
            )
    return prices


def read_state_costs(problem: PlanningProblem, states: Any) -> tuple[Any, ...]:
    """Return what each state costs: numbers of any sign, or infinity.

    Raises
    ------
    CostError
        If one is of another kind than the problem's numbers.
    UnknownLabelError
        If a mapping names a state that does not exist.
    """
    return _read_each(problem, states, problem.states, problem.state_number, "state")


def _read_each(
    problem: PlanningProblem,
    costs: Any,
    labels: tuple[Any, ...],
    number: Callable[..., int],
    what: str,
) -> tuple[Any, ...]:
    if not isinstance(costs, Mapping):
        value = _read_cost(problem, costs, f"cost of every {what}")
        return (value,) * len(labels)
    for label in costs:
        number(label, where=f"costs of the {what}s")
    return tuple(
        _read_cost(problem, costs.get(label, 0), f"cost of {what} {label!r:.40}")
        for label in labels
    )


def _read_cost(problem: PlanningProblem, value: Any, where: str) -> Any:
    if value is INFINITE or _is_word_infinity(value) or _is_float_infinity(value):
        return INFINITE if problem.exact else math.inf
    kind = NumberKind.FLOAT if problem.numbers is NumberKind.FLOAT else NumberKind.RATIONAL
    try:
        found = common_kind([(value, where)])
        if found is NumberKind.ANGLE_SUMS and problem.exact:
            kind = found
        number = read_number(value, kind, where)
    except StochgeomError as error:
        raise CostError(
            f"{error.message}; the numbers of the problem are {problem.numbers.value}",
            where=error.where,
        ) from error
    if isinstance(number, AngleSum) and number.rational is not None:
        return number.rational
    return number


def _is_float_infinity(value: Any) -> bool:
    return isinstance(value, float) and value == math.inf


def _is_word_infinity(value: Any) -> bool:
    return isinstance(value, str) and value in {"infinite", "infinity"}
