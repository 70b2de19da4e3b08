"""Feeding plans: actions with exact tolerances, recovered from preimages, executed exactly.

Recovery. Let [u, v] be the image of the current preimage and [a, a + h) the next one. An action
at alpha turns a state theta to theta - alpha before the jaws close, so it works for every alpha
with a <= u - alpha and v - alpha < a + h: for low < alpha <= high, with

    low = v - (a + h),    high = u - a.

The ranges are independent: any choice of angles inside them works, because each range is computed
for the whole image of the preimage before it. None can be widened if the preimages are the widest:
at `low`, the plan fails whenever the actions before stand close enough above their own lower ends.
(At other angles the image may have become narrower than the preimage allows, and the plan may
survive. Preimages made for a gripper error may be narrower than what later actions would collapse.)

The source's Eq. 5.3 takes angles between left ends of preimages, turned by half a difference of
widths; that does not fit its own Eq. 4.2, see the errata. The first action of a plan under a
uniform prior is a random turn; its value is 0 and it has no range.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, final

from gmpy2 import mpq

from stochgeom.arguments import as_list, expect
from stochgeom.decision.costs import Number, expected_cost
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.display import Displayed, render
from stochgeom.errors import InputError, NoPlanError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.decimals import Rounding
from stochgeom.feeding.actions import Action
from stochgeom.feeding.certificates import certificate
from stochgeom.feeding.execution import check_plan, run_angle, run_arc
from stochgeom.feeding.gripper_error import ErrorBound, least_slack
from stochgeom.feeding.placement import Placement, place
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.feeding.propagation import Outcome, outcomes
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability
    from stochgeom.geometry.part import Part


@final
class FeedingPlan(Displayed):
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
    prior : Prior, optional
        Of the orientations before the first action; default: uniform.
    gripper_error : Angle
        delta: the nominal angles leave at least so much room in their ranges, either way.

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
        *,
        prior: Prior | None = None,
        gripper_error: Angle = ZERO,
    ) -> None:
        self.transfer = expect(
            transfer, StepFunction, "a StepFunction, such as squeeze_function(part)", "transfer"
        )
        self.preimages = tuple(as_list(chain, "a list of preimages", "chain"))
        self.cost_ratio = cost_ratio
        self.part = part
        self.action_name = action_name
        self.prior = prior
        self.gripper_error = gripper_error

    # --- what it does ----------------------------------------------------------------------------

    @property
    def steps(self) -> int:
        """k, the number of actions."""
        return len(self.preimages)

    @cached_property
    def placement(self) -> Placement:
        """The mouth in place, and the probability of what it catches.

        Raises
        ------
        NoPlanError
            If the gripper error leaves nothing that is caught for sure.
        """
        last = self.preimages[-1]
        placement = place(last, self.prior, self.gripper_error)
        if placement is None:
            raise NoPlanError(
                f"the widest arc of {self.steps} steps is {last.width} wide, and the first action "
                f"may miss it by {self.gripper_error}; accepted: less than half of that width"
            )
        return placement

    @property
    def mouth(self) -> Arc:
        """The orientations before the first action that the plan collapses into one.

        Under a uniform prior they start in [0, T); under another one where they catch most.
        """
        return self.placement.mouth

    def mouth_decimals(self, digits: int = 4) -> tuple[str, str, str]:
        """Return the first angle and the ends of the mouth in degrees, to be typed in as printed.

        The ends are those of the mouth that the *printed* angle makes, rounded inwards, with more
        digits than asked for if it would miss measured orientations that the exact one catches. A
        mouth that runs over 0 degrees begins below.

        Examples
        --------
        >>> from stochgeom.decision.discrete_prior import DiscretePrior
        >>> from stochgeom.feeding.planner import plan_feeding
        >>> prior = DiscretePrior.from_counts({"0": 50, "90": 30})
        >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)], prior=prior)
        >>> plan.mouth_decimals()
        ('-123.6901', '0.0000', '112.6198')
        """
        first, mouth = self.placement.first_angle, self.mouth
        # A mouth that begins at a point of the prior holds it if it is moved down, not up.
        points = self.prior is not None and self.prior.mass_at(mouth.start) > 0
        while True:
            angle = first.degrees(digits, Rounding.DOWN if points else Rounding.NEAREST)
            moved = mouth.rotate(Angle.from_degrees(angle) - first)
            if moved.end > FULL_TURN:
                moved = moved.rotate(-FULL_TURN)
            low = moved.start.degrees(digits, Rounding.UP)
            high = moved.end.degrees(digits, Rounding.DOWN)
            if mpq(low) < mpq(high) and self._catches_points(moved):
                return angle, low, high
            digits += 1

    def _catches_points(self, mouth: Arc) -> bool:
        """Tell whether a mouth that has moved a little lost no point of the prior.

        Of points only, none at all; of other priors, which always lose something, none that
        four decimals of the probability show.
        """
        if self.prior is None:
            return True
        mass = self.prior.mass(mouth)
        if self.prior.kind == "discrete":
            return mass.compare(self.probability) >= 0
        return bool(mpq(mass.decimal()) + mpq(1, 10_000) >= mpq(self.probability.decimal()))

    @property
    def final_orientation(self) -> Angle:
        """Where the mouth ends up, relative to the gripper after the last action."""
        return self.preimages[0].image.start

    @cached_property
    def actions(self) -> tuple[Action, ...]:
        """The k actions with their exact ranges, in order of execution."""
        breaks, values = self.transfer.lifted_breaks, self.transfer.lifted_values
        margin = self.gripper_error
        actions = [Action(None, None, free_angle=self.placement.first_angle)]
        for here, goal in pairwise(self.preimages[::-1]):
            low = values[here.last] - breaks[goal.last + 1]
            high = values[here.first] - breaks[goal.first]
            actions.append(Action(low, high, margin))
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
        return self.preimages[-1].is_period

    @property
    def error_bound(self) -> ErrorBound | None:
        """The gripper errors that the ranges have room for; None if there are no ranges.

        That is with the middles of the ranges as angles; `margin` tells of the nominal ones.
        """
        slack = least_slack(self.preimages)
        return None if slack is None else ErrorBound(slack)

    @property
    def margin(self) -> Angle | None:
        """The least distance of a nominal angle from an end of its range; None without ranges.

        Every error below it is borne, and itself as well unless it is a distance from a lower end.
        """
        distances = [
            distance
            for action in self.actions
            if action.low is not None and action.high is not None
            for distance in (action.angle - action.low, action.high - action.angle)
        ]
        return min(distances, default=None)

    # --- what it is worth ------------------------------------------------------------------------

    @property
    def probability(self) -> Probability:
        """Probability h / (2 pi) of *one* of the 2 pi / T equivalent final orientations.

        Under another prior than the uniform one: the mass of the mouth.
        """
        return self.placement.probability

    @property
    def probability_up_to_symmetry(self) -> Probability:
        """Probability h / T of any of the equivalent final orientations."""
        return self.placement.probability_up_to_symmetry

    @property
    def expected_cost(self) -> Number:
        """(k + c) 2 pi / h in units of one action, until one given orientation is accepted.

        Thesis Eq. 4.5: (k + c) over the probability.
        """
        return expected_cost(self.steps + self.cost_ratio, self.probability)

    @property
    def expected_cost_up_to_symmetry(self) -> Number:
        """(k + c) T / h: the cost when any of the equivalent orientations is accepted."""
        return expected_cost(self.steps + self.cost_ratio, self.probability_up_to_symmetry)

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
        if not isinstance(theta, Angle):
            raise InputError(f"{theta!r:.60} is no Angle; accepted: one", where="orientation")
        return run_angle(self.transfer, self.angles, theta)

    def execute_arc(self, arc: Arc | None = None) -> tuple[ClosedArc, ...]:
        """Return the closed arc that an arc (default: the mouth) has become after each action."""
        if not (arc is None or isinstance(arc, Arc)):
            raise InputError(f"{arc!r:.60} is no Arc; accepted: one", where="arc")
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
        *_, last = self._outcomes(self.angles[:count])
        return last.hyperstate()

    def outcomes(self) -> Iterator[Outcome]:
        """Yield the hyperstate after each action, in compact form."""
        return self._outcomes(self.angles)

    def _outcomes(self, angles: Sequence[Angle]) -> Iterator[Outcome]:
        return outcomes(self.transfer, angles, self.prior)

    def verify(self) -> bool:
        """Run the plan forward and return True, or raise what fails.

        The mouth is collapsed at the nominal angles, at the upper ends of all ranges and just
        above their lower ends, whatever the gripper error of a first action that is no random
        turn; each action at its lower end lets the plan fail, if the preimages are the widest
        (which those made for a gripper error need not be).

        Raises
        ------
        VerificationError
            Naming the first claim that does not hold.
        """
        free, *others = ((a.low, a.angle, a.high) for a in self.actions)
        # A random turn has no error, and a mouth of a full turn is not narrowed for one.
        narrowed = self.mouth.width != self.preimages[-1].width
        delta = self.gripper_error if narrowed else ZERO
        for error in (-delta, delta) if delta else (ZERO,):
            first = (free[0], free[1] + error, free[2])
            ranges = [first, *others]
            check_plan(self.transfer, self.mouth, ranges, widest=self._is_widest())
        return True

    def _is_widest(self) -> bool:
        """Tell whether no plan that ends alike collapses a wider arc, at any stage."""
        final_step = self.preimages[0].first % len(self.transfer)
        widest = Preimages(self.transfer, final_steps=(final_step,))
        return self.mouth.width == self.preimages[-1].width and all(
            widest.of_steps(preimage.steps).width == preimage.width for preimage in self.preimages
        )

    def certificate(self) -> dict[str, Any]:
        """Return the plan with its proof, a ``stochgeom/certificate/1`` document.

        Its schema is ``stochgeom/certificate/2`` for a part over a real algebraic field.

        Raises
        ------
        InputError
            If the action is neither a squeeze nor a push-grasp of a part, or the plan is not for a
            uniform prior, or a goal or gripper error makes it another one; see
            `stochgeom.feeding.certificates.certificate`.
        """
        return certificate(self)

    def to_html(self, path: str | os.PathLike[str], *, digits: int = 4) -> None:
        """Write the plan as one HTML page: pictures, an animation, tolerances, the certificate.

        The page asks for nothing from outside and needs no script; see
        `stochgeom.plotting.report`.

        Parameters
        ----------
        path : path
            The file to write; what stands there is replaced, or left as it is after an error.
        digits : int, default 4
            Decimals after the point.

        Raises
        ------
        WriteError
            If the folder is missing or not writable.
        InputError
            If `digits` is not acceptable.
        """
        render(self, "report", path, digits=digits)

    @property
    def counted_actions(self) -> str:
        """The number of actions in words, ``"3 squeeze actions"``; ``"1 action"`` of no name."""
        kind = "" if self.action_name == "action" else f"{self.action_name} "
        return f"{self.steps} {kind}action{'s' if self.steps != 1 else ''}"

    def __repr__(self) -> str:
        name = f" for {self.part.name}" if self.part is not None and self.part.name else ""
        return (
            f"<FeedingPlan{name}: {self.counted_actions}, expected cost {self.expected_cost}, "
            f"probability {self.probability}>"
        )
