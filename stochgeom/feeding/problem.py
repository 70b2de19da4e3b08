"""Phase II: the plan of least expected cost, and the shortest plan that orients a part.

Phase I gives the widest preimage h_i for every number of steps i. An i-step plan catches the mass
p_i of its mouth, h_i / (2 pi) under a uniform prior; its expected cost is (i + c) / p_i, and the
optimal plan takes the least of these (thesis 5.5, App. F). No mouth is wider than the period T, so
once (i + c) / p is no better than the best cost found, with p the mass of the best window of width
T, no longer plan is: that bound is sharper than the source's N and applies to every c. Costs are
compared exactly (or by certified enclosures, for priors that have no better); of equal costs the
fewest steps win.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Final, final

from gmpy2 import mpq

from stochgeom.arguments import as_count, shown
from stochgeom.decision.costs import Number, as_cost_ratio, expected_cost
from stochgeom.display import Displayed
from stochgeom.errors import InputError, NoPlanError, PriorError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.goals import Goal, final_steps
from stochgeom.feeding.gripper_error import (
    ErrorBound,
    GripperError,
    as_gripper_error,
    largest_gripper_error,
    most_tolerant_chain,
)
from stochgeom.feeding.placement import Placement, place
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.geometry.part import Part, PartLike, as_part
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability

TRANSFER_FUNCTIONS: Final[dict[str, Callable[[Part], StepFunction]]] = {
    "squeeze": squeeze_function,
    "push-grasp": push_grasp_function,
}
"""The actions that can be planned with, by name."""


@final
class FeedingProblem(Displayed):
    """A part and an action: one transfer function, one chain of preimages, many plans.

    Parameters
    ----------
    part : Part, or its vertices
        What is fed.
    action : str, default "squeeze"
        What the gripper does: ``"squeeze"`` or ``"push-grasp"``.
    prior : Prior, optional
        Of the orientations before the first action; default: uniform.
    gripper_error : Angle, or degrees as text, optional
        delta: every action may be off by up to delta either way, and plans must still work;
        default: none.
    goal : Angle, degrees as text, or "most stable", optional
        The final orientation; default: any. See `stochgeom.feeding.goals`.

    Examples
    --------
    >>> problem = FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [problem.expected_cost(i, 1).decimal(1) for i in (1, 2, 3, 4)]
    ['6.4', '6.0', '8.0', '10.0']
    """

    def __init__(
        self,
        part: PartLike,
        action: str = "squeeze",
        *,
        prior: Prior | None = None,
        gripper_error: GripperError | None = None,
        goal: Goal | None = None,
    ) -> None:
        accepted = sorted(TRANSFER_FUNCTIONS)
        if action not in accepted:
            raise InputError(f"action {action!r:.60}; accepted: {', '.join(accepted)}")
        self.part: Part | None = as_part(part)
        self.action = action
        self._set(prior, gripper_error, goal)

    @classmethod
    def of_transfer(
        cls,
        transfer: StepFunction,
        action: str = "action",
        *,
        prior: Prior | None = None,
        gripper_error: GripperError | None = None,
        goal: Goal | None = None,
    ) -> FeedingProblem:
        """Return the problem of any action whose transfer function is a monotone step map.

        Nothing else is asked of actions (thesis 5.10). ``action`` is what reports call it.

        Examples
        --------
        >>> from stochgeom.exact.angles import Angle
        >>> s = StepFunction([Angle.from_degrees(d) for d in (0, 100)], [Angle(), Angle(0, (0, 1))])
        >>> FeedingProblem.of_transfer(s).optimal_plan().steps
        1
        """
        if not isinstance(transfer, StepFunction):
            raise InputError(
                f"{transfer!r:.60} is no StepFunction; accepted: one, such as "
                "squeeze_function(part)"
            )
        problem = object.__new__(cls)
        problem.part, problem.action = None, action
        problem.__dict__["transfer"] = transfer
        problem._set(prior, gripper_error, goal)
        return problem

    def _set(
        self, prior: Prior | None, gripper_error: GripperError | None, goal: Goal | None
    ) -> None:
        self.prior = None if prior is None else _informative(prior)
        self.gripper_error = None if gripper_error is None else as_gripper_error(gripper_error)
        self.goal = goal

    @property
    def _delta(self) -> Angle:
        return ZERO if self.gripper_error is None else self.gripper_error

    @cached_property
    def transfer(self) -> StepFunction:
        """The transfer function of the action."""
        assert self.part is not None
        return TRANSFER_FUNCTIONS[self.action](self.part)

    @cached_property
    def final_steps(self) -> Sequence[int] | None:
        """The steps that the last action may end with, None for all."""
        return None if self.goal is None else final_steps(self.goal, self.transfer, self.part)

    @cached_property
    def preimages(self) -> Preimages:
        """Phase I, lazily."""
        return Preimages(self.transfer, 2 * self._delta, self.final_steps)

    @cached_property
    def _placements(self) -> dict[int, Placement | None]:
        return {}

    def placement(self, steps: int) -> Placement | None:
        """Return where the mouth of the best plan of `steps` steps is put; None if nowhere.

        There is no place where the gripper error may make it miss everything.
        """
        preimage = self.preimages.of_steps(steps)
        if preimage.steps not in self._placements:
            found = place(preimage, self.prior, self._delta)
            self._placements[preimage.steps] = found
        return self._placements[preimage.steps]

    def expected_cost(self, steps: int, cost_ratio: RationalLike = 1) -> Number:
        """Return the expected cost (i + c) / p of the best plan of `steps` steps.

        With c the cost ratio and p that of `probability`.

        Raises
        ------
        NoPlanError
            If there is no such plan, see `placement`.
        """
        return expected_cost(steps + as_cost_ratio(cost_ratio), self.probability(steps))

    def probability(self, steps: int) -> Probability:
        """Return the probability that the best plan of `steps` steps succeeds.

        Raises
        ------
        NoPlanError
            If there is no such plan, see `placement`.
        """
        placement = self.placement(steps)
        if placement is None:
            raise NoPlanError(
                f"no plan of {steps} steps is sure to catch anything with a gripper error of "
                f"{self._delta}"
            )
        return placement.probability

    def __repr__(self) -> str:
        name = f" for {self.part.name}" if self.part is not None and self.part.name else ""
        words = [self.action, "uniform prior" if self.prior is None else self.prior.describe()]
        if self._delta:
            words.append(f"gripper error {self._delta}")
        if self.goal is not None:
            words.append(f"goal {self.goal}")
        return f"<FeedingProblem{name}: {', '.join(words)}>"

    def plan_of(self, steps: int, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the plan of `steps` steps that collapses the widest arc.

        Raises
        ------
        InputError
            If `steps` is below 1, or so many steps do no better than fewer.
        """
        try:
            count = as_count(steps, "steps")
        except InputError:  # what is accepted depends on the part
            count = 0
        if not count or self.preimages.of_steps(count).steps < count:
            longest = max(preimage.steps for preimage in self.preimages)
            raise InputError(f"{shown(steps)} steps; accepted: 1 to {longest} for this part")
        return self._plan(self.preimages.found()[:count], cost_ratio)

    def _plan(self, chain: Sequence[Preimage], cost_ratio: RationalLike) -> FeedingPlan:
        return FeedingPlan(
            self.transfer,
            chain,
            as_cost_ratio(cost_ratio),
            self.part,
            self.action,
            prior=self.prior,
            gripper_error=self._delta,
        )

    def optimal_plan(self, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the stochastically optimal plan (phase II).

        Raises
        ------
        NoPlanError
            If the gripper error is so large that no plan of any length is sure to catch anything.
        """
        c = as_cost_ratio(cost_ratio)
        best: tuple[Number, int] | None = None
        for preimage in self.preimages:
            if self.placement(preimage.steps) is None:
                continue
            cost = self.expected_cost(preimage.steps, c)
            if best is None or cost < best[0]:
                best = cost, preimage.steps
            elif not self._least_cost(preimage.steps + 1, c) < best[0]:
                break  # no longer plan beats the best, however wide its preimage
        if best is None:
            widest = self.preimages.found()[-1].width
            raise NoPlanError(
                f"no plan is sure to catch anything with a gripper error of {self._delta}; "
                f"accepted: less than {ErrorBound(widest)}"
            )
        return self.plan_of(best[1], c)

    def _least_cost(self, steps: int, cost_ratio: mpq) -> Number:
        """Return what plans of so many steps or more cost at least."""
        return expected_cost(steps + cost_ratio, self._largest_probability)

    @cached_property
    def _largest_probability(self) -> Probability:
        """What no mouth exceeds: the mass of the best window as wide as the period."""
        if self.prior is None:
            return TurnRatio(mpq(1), self.transfer.period)
        window = self.prior.best_window(self.transfer.period)
        return window.mass if window.at_most is None else window.at_most

    def geometric_plan(self, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the shortest plan that orients the part up to symmetry (Cor. 5.1.1).

        Raises
        ------
        NoPlanError
            If the gripper error is too large for any such plan, saying how large it may be.
        """
        chain = list(self.preimages)
        if not chain[-1].is_period:
            raise NoPlanError(
                f"no plan orients the part up to symmetry with a gripper error of "
                f"{self._delta}; accepted: less than {self.largest_gripper_error()}"
            )
        return self._plan(chain, cost_ratio)

    def largest_gripper_error(self) -> ErrorBound | None:
        """Return the bound of the errors with which a plan up to symmetry exists; None for any."""
        return largest_gripper_error(self.transfer, self.final_steps)

    def most_tolerant(self, steps: int, cost_ratio: RationalLike = 1) -> FeedingPlan:
        """Return the plan of `steps` steps that bears most gripper error, its mouth the widest.

        As wide as without any error, that is; `FeedingPlan.error_bound` tells how much it bears.

        Raises
        ------
        InputError
            If so many steps do no better than fewer.
        NoPlanError
            If even this plan does not bear the gripper error of the problem.
        """
        chain = most_tolerant_chain(self.transfer, steps, self.final_steps)
        plan = self._plan(chain, cost_ratio)
        bound = plan.error_bound
        if bound is not None and not bound.allows(self._delta):
            raise NoPlanError(
                f"no plan of {steps} steps has its widest mouth with a gripper error of "
                f"{self._delta}; accepted: less than {bound}"
            )
        return plan


def _informative(prior: Prior) -> Prior | None:
    """Return a prior as it is, None for the uniform one."""
    from stochgeom.decision.priors import Prior  # loaded for those who use one

    if not isinstance(prior, Prior):
        raise PriorError(
            f"{prior!r:.60} is no prior; accepted: one, such as WrappedNormal('30', '12'), or "
            "CallablePrior of a function",
            where="prior",
        )
    return None if prior.kind == "uniform" else prior
