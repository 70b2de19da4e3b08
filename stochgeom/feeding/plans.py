"""Feeding plans: actions with exact tolerances, recovered from preimages, executed exactly.

Recovery. Let [u, v] be the image of the current preimage and [a, a + h) the next one. An action
at alpha turns a state theta to theta - alpha before the jaws close, so it works for every alpha
with a <= u - alpha and v - alpha < a + h: for low < alpha <= high, with

    low = v - (a + h),    high = u - a.

The ranges are independent: any choice of angles inside them works, because each range is computed
for the whole image of the preimage before it. None can be widened: at `low`, the plan fails
whenever the actions before stand close enough above their own lower ends. (At other angles the
image may have become narrower than the preimage allows, and the plan may survive.)

The source's Eq. 5.3 takes angles between left ends of preimages, turned by half a difference of
widths; that does not fit its own Eq. 4.2, see the errata. The first action of a plan under a
uniform prior is a random turn; its value is 0 and it has no range.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, final

from gmpy2 import mpq

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.errors import InputError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.actions import Action
from stochgeom.feeding.certificates import certificate
from stochgeom.feeding.execution import check_plan, run_angle, run_arc
from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.propagation import Outcome, outcomes
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.geometry.part import Part


@final
class FeedingPlan:
    """An open-loop plan and what it is worth.

    Made by `stochgeom.feeding.planner`; holds the preimages of 1, 2, ..., k steps.

    Parameters
    ----------
    transfer : StepFunction
        The transfer function of one action.
    chain : sequence of Preimage
        The preimages of 1 to k steps, in this order.
    cost_ratio : mpq
        c, the cost of the filter over the cost of an action.
    part : Part, optional
        What the plan is for.
    action_name : str
        The kind of action, such as ``"squeeze"``.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> plan.steps, plan.expected_cost.decimal(2), plan.orients_up_to_symmetry
    (2, '6.00', True)
    >>> [action.angle.degrees(2) for action in plan.actions]
    ['0.00', '-45.00']
    """

    def __init__(
        self,
        transfer: StepFunction,
        chain: Iterable[Preimage],
        cost_ratio: mpq,
        part: Part | None = None,
        action_name: str = "squeeze",
    ) -> None:
        self.transfer = transfer
        self.preimages = tuple(chain)
        self.cost_ratio = cost_ratio
        self.part = part
        self.action_name = action_name

    # --- what it does ----------------------------------------------------------------------------

    @property
    def steps(self) -> int:
        """k, the number of actions."""
        return len(self.preimages)

    @property
    def mouth(self) -> Arc:
        """The orientations before the first action that the plan collapses into one."""
        return self.preimages[-1].arc

    @property
    def final_orientation(self) -> Angle:
        """Where the mouth ends up, relative to the gripper after the last action."""
        return self.preimages[0].image.start

    @cached_property
    def actions(self) -> tuple[Action, ...]:
        """The k actions with their exact ranges, in order of execution."""
        breaks, values = self.transfer.lifted_breaks, self.transfer.lifted_values
        actions = [Action(None, None)]
        for here, goal in pairwise(self.preimages[::-1]):
            low = values[here.last] - breaks[goal.last + 1]
            high = values[here.first] - breaks[goal.first]
            actions.append(Action(low, high))
        return tuple(actions)

    @property
    def angles(self) -> tuple[Angle, ...]:
        """The nominal angles of the actions."""
        return tuple(action.angle for action in self.actions)

    @property
    def cumulative_angles(self) -> tuple[Angle, ...]:
        """Gripper angles relative to its pose at the first action, as the source prints them."""
        total, angles = ZERO, []
        for angle in self.angles:
            total += angle
            angles.append(total)
        return tuple(angles)

    @property
    def orients_up_to_symmetry(self) -> bool:
        """Whether the final orientations are exactly 2 pi / T equally spaced ones (Def. 4.3)."""
        return self.mouth.width == self.transfer.period

    # --- what it is worth ------------------------------------------------------------------------

    @property
    def probability(self) -> TurnRatio:
        """Probability h / (2 pi) of *one* of the 2 pi / T equivalent final orientations."""
        return TurnRatio(mpq(1), self.mouth.width)

    @property
    def probability_up_to_symmetry(self) -> TurnRatio:
        """Probability h / T of any of the equivalent final orientations."""
        return TurnRatio(mpq(self.transfer.order), self.mouth.width)

    @property
    def expected_cost(self) -> TurnRatio:
        """(k + c) 2 pi / h in units of one action, until one given orientation is accepted.

        Thesis Eq. 4.5 with a uniform prior.
        """
        return TurnRatio(self.steps + self.cost_ratio, self.mouth.width, inverse=True)

    @property
    def expected_cost_up_to_symmetry(self) -> TurnRatio:
        """(k + c) T / h: the cost when any of the equivalent orientations is accepted."""
        per_round = (self.steps + self.cost_ratio) / self.transfer.order
        return TurnRatio(per_round, self.mouth.width, inverse=True)

    # --- running it ------------------------------------------------------------------------------

    def execute(self, theta: Angle) -> tuple[Angle, ...]:
        """Return the orientation before the first action and after each one, lifted, exact.

        Examples
        --------
        >>> from stochgeom.feeding.planner import plan_feeding
        >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
        >>> [state.degrees(1) for state in plan.execute(Angle.from_degrees(100))]
        ['100.0', '90.0', '180.0']
        """
        return run_angle(self.transfer, self.angles, theta)

    def execute_arc(self, arc: Arc | None = None) -> tuple[ClosedArc, ...]:
        """Return the closed arc that an arc (default: the mouth) has become after each action."""
        return run_arc(self.transfer, self.angles, self.mouth if arc is None else arc)

    def distribution(self, step: int | None = None) -> Hyperstate:
        """Return the hyperstate after `step` actions (default: all), exact widths.

        Raises
        ------
        InputError
            If `step` is not in [1, k].
        """
        count = self.steps if step is None else step
        if not 1 <= count <= self.steps:
            raise InputError(f"step {step}; accepted: 1 to {self.steps}")
        *_, last = outcomes(self.transfer, self.angles[:count])
        return last.hyperstate()

    def outcomes(self) -> Iterator[Outcome]:
        """Yield the hyperstate after each action, in compact form."""
        return outcomes(self.transfer, self.angles)

    def verify(self) -> bool:
        """Run the plan forward and return True, or raise what fails.

        The mouth is collapsed at the nominal angles, at the upper ends of all ranges and just
        above their lower ends; each action at its lower end lets the plan fail.

        Raises
        ------
        VerificationError
            Naming the first claim that does not hold.
        """
        check_plan(self.transfer, self.mouth, [(a.low, a.angle, a.high) for a in self.actions])
        return True

    def certificate(self) -> dict[str, Any]:
        """Return the plan with its proof, a ``stochgeom/certificate/1`` document."""
        return certificate(self)

    def __repr__(self) -> str:
        name = f" for {self.part.name}" if self.part is not None and self.part.name else ""
        return (
            f"<FeedingPlan{name}: {self.steps} {self.action_name} action"
            f"{'s' if self.steps != 1 else ''}, expected cost {self.expected_cost}, "
            f"probability {self.probability}>"
        )
