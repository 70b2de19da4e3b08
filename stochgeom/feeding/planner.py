"""Phase II: the plan of least expected cost, and the shortest plan that orients a part.

Phase I gives the widest preimage h_i for every number of steps i; under a uniform prior the
expected cost of the best i-step plan is (i + c) 2 pi / h_i, so the optimal plan takes the least
of these (thesis 5.5). No preimage is wider than the period T, so once (i + c) / T is no better
than the best cost found, no longer plan is: that bound is sharper than the source's N and
applies to every c. Costs are compared exactly; of equal costs the fewest steps win.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import Any, Final, final

from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.decision.costs import as_cost_ratio
from stochgeom.errors import InputError
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimages, preimages
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

TRANSFER_FUNCTIONS: Final = {"squeeze": squeeze_function}
"""The actions that can be planned with, by name."""

PartLike = Part | Iterable[PointLike] | NDArray[Any]


@final
class FeedingProblem:
    """A part and an action: one transfer function, one chain of preimages, many plans.

    Parameters
    ----------
    part : Part, or its vertices
        What is fed.
    action : str, default "squeeze"
        What the gripper does.

    Examples
    --------
    >>> problem = FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [problem.expected_cost(i, 1).decimal(1) for i in (1, 2, 3, 4)]
    ['6.4', '6.0', '8.0', '10.0']
    """

    def __init__(self, part: PartLike, action: str = "squeeze") -> None:
        accepted = sorted(TRANSFER_FUNCTIONS)
        if action not in accepted:
            raise InputError(f"action {action!r}; accepted: {', '.join(accepted)}")
        self.part = as_part(part)
        self.action = action

    @cached_property
    def transfer(self) -> StepFunction:
        """The transfer function of the action."""
        return TRANSFER_FUNCTIONS[self.action](self.part)

    @cached_property
    def preimages(self) -> Preimages:
        """Phase I, lazily."""
        return preimages(self.transfer)

    def expected_cost(self, steps: int, cost_ratio: RationalLike = 1) -> TurnRatio:
        """Return the expected cost (i + c) 2 pi / h_i of the best plan of `steps` steps."""
        width = self.preimages.of_steps(steps).width
        return TurnRatio(steps + as_cost_ratio(cost_ratio), width, inverse=True)

    def probability(self, steps: int) -> TurnRatio:
        """Return the probability h_i / (2 pi) that the best plan of `steps` steps succeeds."""
        return TurnRatio(mpq(1), self.preimages.of_steps(steps).width)

    def plan_of(self, steps: int, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the plan of `steps` steps that collapses the widest arc.

        Raises
        ------
        InputError
            If `steps` is below 1, or beyond the shortest plan that orients up to symmetry.
        """
        if steps < 1 or self.preimages.of_steps(steps).steps < steps:
            longest = max(preimage.steps for preimage in self.preimages)
            raise InputError(f"{steps} steps; accepted: 1 to {longest} for this part")
        chain = self.preimages.found()[:steps]
        return FeedingPlan(self.transfer, chain, as_cost_ratio(cost_ratio), self.part, self.action)

    def optimal_plan(self, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the stochastically optimal plan (phase II)."""
        c = as_cost_ratio(cost_ratio)
        best = self.expected_cost(1, c)
        steps = length = 1
        while not self._is_last(length):
            length += 1
            cost = self.expected_cost(length, c)
            if cost < best:
                best, steps = cost, length
            elif TurnRatio(length + 1 + c, self.transfer.period, inverse=True) >= best:
                break  # no longer plan beats the best, however wide its preimage
        return self.plan_of(steps, c)

    def _is_last(self, steps: int) -> bool:
        return self.preimages.of_steps(steps).is_period

    def geometric_plan(self, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the shortest plan that orients the part up to symmetry (Cor. 5.1.1)."""
        last = max(preimage.steps for preimage in self.preimages)
        return self.plan_of(last, cost_ratio)


def plan_feeding(
    part: PartLike, cost_ratio: RationalLike = 1, action: str = "squeeze"
) -> FeedingPlan:
    """Return the plan that feeds a part at least expected cost.

    Parameters
    ----------
    part : Part, or its vertices
        Any simple polygon.
    cost_ratio : rational >= 0, default 1
        c, the cost of the filter over the cost of one action.
    action : str, default "squeeze"
        What the gripper does.

    Returns
    -------
    FeedingPlan
        The stochastically optimal plan (thesis Def. 4.4, Figs. 5.1 and 5.8); of equal costs the
        one of fewest steps.

    Raises
    ------
    CostError
        If the cost ratio is negative or not a rational number.
    InvalidPartError
        If the vertices are no simple polygon.

    Notes
    -----
    O(n log n) for the transfer function and O(n) for each plan length tried.

    Examples
    --------
    >>> plan_feeding([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]).expected_cost.decimal(1)
    '5.0'
    """
    return FeedingProblem(part, action).optimal_plan(cost_ratio)


def orient_up_to_symmetry(
    part: PartLike, cost_ratio: RationalLike = 1, action: str = "squeeze"
) -> FeedingPlan:
    """Return the shortest plan that orients a part up to the symmetry of its transfer function.

    Such a plan always exists (thesis Thm 5.3); parameters as in `plan_feeding`.

    Examples
    --------
    >>> orient_up_to_symmetry([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]).steps
    2
    """
    return FeedingProblem(part, action).geometric_plan(cost_ratio)
