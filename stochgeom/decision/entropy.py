"""Shannon entropy as a cost of hyperstates (thesis 7.3), and why it can mislead.

    H(lambda) = - sum lambda_i log2 lambda_i bits, with 0 log 0 = 0

Of a rational distribution it is an exact sum of logarithms, so that two entropies are compared for
certain; of angle sums it is enclosed as tightly as asked.

Entropy tells how sure the state is, not how good. With one desirable and one undesirable state:

>>> from stochgeom.decision.goal_costs import GoalCost
>>> from stochgeom.decision.planning_problem import PlanningProblem
>>> problem = PlanningProblem(
...     ["good", "bad"], ["1/2", "1/2"], ["wait", "spoil"],
...     [[[1, 0], [0, 1]], [["1/100", "99/100"], ["1/100", "99/100"]]],
... )
>>> [str(EntropyCost().on(problem).of_plan([action])) for action in problem.actions]
['1.0000', '0.0808']
>>> [str(GoalCost("good").on(problem).of_plan([a])) for a in problem.actions]
['1/2', '99/100']

By entropy the better plan is to spoil: then the state is almost certain, and bad.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

import flint
import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_list
from stochgeom.decision.distributions import distribution
from stochgeom.decision.number_kinds import NumberKind, common_kind, numbered
from stochgeom.decision.plan_costs import CostModel, PlanCost, Prices
from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.exact.balls import Ball
from stochgeom.exact.independent_sums import LogSum
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class EntropyCost(PlanCost):
    """What the actions cost plus the entropy of the final hyperstate, in bits.

    Parameters
    ----------
    actions : number >= 0, or mapping, default 0
        What an action costs, in bits.
    """

    actions: Prices = 0

    def on(self, problem: PlanningProblem) -> EntropyModel:
        """Return the cost of the plans of a problem."""
        return EntropyModel(problem, self.actions)

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions plus Shannon entropy of the final hyperstate, in bits"


@final
class EntropyModel(CostModel):
    """An entropy cost on a problem.

    The bound is what is spent: no entropy is below 0.
    """

    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return spent + H."""
        return entropy_of(hyperstate) + self.floor(spent)

    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return what is spent, or the cost of stopping here if nothing may follow."""
        return self.value(spent, hyperstate) if left == 0 else self.floor(spent)

    def floor(self, spent: Any) -> Any:
        """Return what is spent."""
        is_enclosed = self.problem.numbers is NumberKind.ANGLE_SUMS
        return Enclosed([], AngleSum(spent)) if is_enclosed else spent

    def as_cost(self, value: Any) -> Any:
        """Return a number in the form of this model's costs."""
        return self.floor(super().as_cost(value))

    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans at once."""
        safe = np.where(hyperstates > 0, hyperstates, 1.0)
        found: NDArray[np.float64] = spent - (safe * np.log2(safe)).sum(axis=1)
        return found


def entropy(probabilities: Iterable[Any]) -> Any:
    """Return the Shannon entropy of a distribution, in bits.

    Parameters
    ----------
    probabilities : iterable of numbers
        Exact ones, text such as ``"1/2"`` among them, or floats; of sum 1.

    Returns
    -------
    LogSum, Enclosed or float
        Exact for rational numbers; for angle sums enclosed (two distributions with the same
        probabilities in another order are known to be equal); for floats a float.

    Raises
    ------
    NotStochasticError
        If one is negative, or they do not sum to 1.
    MixedNumbersError, NumberError
        If floats and exact numbers are mixed, or one is no number.

    Examples
    --------
    >>> entropy(["1/2", "1/4", "1/4", 0]).rational
    mpq(3,2)
    >>> entropy(["1/3"] * 3) == LogSum(0, [(1, 3)])
    True
    """
    listed = as_list(probabilities, "a list of probabilities", "distribution")
    kind = common_kind(numbered(listed, "distribution"))
    return entropy_of(distribution(listed, kind, "distribution"))


def entropy_of(probabilities: Iterable[Any]) -> Any:
    """Return the entropy of numbers of one kind that are known to make a distribution."""
    shares = [p for p in probabilities if p]
    if any(isinstance(p, float) for p in shares):
        return float(-sum(p * np.log2(p) for p in shares))
    if not any(isinstance(p, AngleSum) for p in shares):
        terms = [(p, p.denominator) for p in shares] + [(-p, p.numerator) for p in shares]
        return LogSum(0, terms)
    atoms = [(count, Atom(("-p log2 p", p), _part(p))) for p, count in Counter(shares).items()]
    return Enclosed(atoms)


def _part(p: Any) -> Any:
    number = AngleSum.of(p)

    def enclose() -> Ball:
        ball = number.ball()
        return -ball * ball.log() / flint.arb.const_log2()

    return enclose


def information(before: Iterable[Any], after: Iterable[Any]) -> Any:
    """Return H(before) - H(after), how many bits of uncertainty were removed (thesis 7.3).

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> information([mpq(1, 2), mpq(1, 2)], [mpq(1), mpq(0)]).rational
    mpq(1,1)
    """
    less = entropy(after)
    return entropy(before) + (-less if isinstance(less, float) else less.scaled(-1))
