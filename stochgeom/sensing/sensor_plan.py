"""What a planner with sensors hands out: a tree, its cost, and what is proven of it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, final

from gmpy2 import mpq

from stochgeom.display import Displayed
from stochgeom.errors import PrecisionLimitError
from stochgeom.exact.quotients import number_decimal, quotient
from stochgeom.sensing.plan_tree import PlanTree


@final
@dataclass(frozen=True)
class SensorPlan(Displayed):
    """A plan with sensors, what it costs, and whether that is proven to be the least.

    Attributes
    ----------
    tree : PlanTree
        The plan.
    round_cost : number or None
        What a round costs besides the moves of the tree; None for a plan carried out once.
    proven : bool
        Whether no plan of the stages asked for costs less.
    lower_bound : number
        No such plan costs less than this.
    row_error : rational
        The largest rounding error of a row of the sensors' likelihoods.
    largest_gain : number
        The largest gain or loss of a decision in any state: 1 of acceptances.
    """

    tree: PlanTree
    round_cost: Any
    proven: bool
    lower_bound: Any
    row_error: mpq
    largest_gain: Any

    @property
    def success(self) -> Any:
        """The probability that a round succeeds, of a plan that accepts; else the mean gain."""
        return self.tree.gain

    @cached_property
    def cost_of_round(self) -> Any:
        """The expected cost of a round."""
        return self.tree.cost + (0 if self.round_cost is None else self.round_cost)

    @cached_property
    def expected_cost(self) -> Any:
        """The expected cost: of all rounds until one succeeds, or of the moves and the losses."""
        if self.round_cost is None:
            return self.tree.cost - self.tree.gain
        return quotient(self.cost_of_round, self.tree.gain)

    @cached_property
    def cost_bounds(self) -> tuple[Any, Any]:
        """Bounds on the cost of this plan for the likelihoods that are meant, unrounded.

        With k looks at sensors whose rows are off by at most e, summed over the readings, the
        distribution of what happens is off by at most k e: the mean of any quantity by at most k e
        times its largest value.
        """
        shift = self.row_error * self.tree.sensings
        if not shift:
            return self.expected_cost, self.expected_cost
        slack, drift = shift * self.tree.highest_cost, shift * self.largest_gain
        if self.round_cost is None:
            return self.expected_cost - slack - drift, self.expected_cost + slack + drift
        cost, gain = self.cost_of_round, self.tree.gain
        return quotient(cost - slack, gain + drift), quotient(cost + slack, gain - drift)

    def decimal(self, digits: int = 4) -> str:
        """Return the expected cost as a decimal, correctly rounded.

        Of a sensor with rounded likelihoods: the cost for the likelihoods that are meant.

        Raises
        ------
        PrecisionLimitError
            If the rounding of the likelihoods leaves the decimal open.
        """
        low, high = (number_decimal(bound, digits) for bound in self.cost_bounds)
        if low != high:
            raise PrecisionLimitError(
                f"the expected cost is {low} or {high}; accepted: likelihoods of more digits",
                where="expected cost",
            )
        return low

    def __repr__(self) -> str:
        kind = "" if self.proven else ", not proven optimal"
        return f"<SensorPlan: expected cost {float(self.expected_cost):.4f}{kind}, {self.tree!r}>"
