"""What a report is about: a plan, and what several sections need to know of it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING, Final, final

from stochgeom.decision.costs import Number, expected_cost
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.placement import place
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.feeding.propagation import Outcome
from stochgeom.plotting.animation_motion import Trace
from stochgeom.plotting.animation_stage import shown_actions, traces

if TYPE_CHECKING:
    from stochgeom.exact.sums import Probability
    from stochgeom.feeding.plans import FeedingPlan

MOST_MORE: Final = 20
"""So many longer plans are compared with this one."""

MOST_ROWS: Final = 40
"""Longer tables are cut in the middle."""


@final
class Subject:
    """A plan and what is computed from it once.

    Parameters
    ----------
    plan : FeedingPlan
        What the report is about.
    digits : int
        Decimals after the point.
    """

    def __init__(self, plan: FeedingPlan, digits: int) -> None:
        self.plan, self.digits = plan, digits
        self.actions = shown_actions(plan)
        self._states: dict[int, Hyperstate] = {}

    @property
    def name(self) -> str:
        """What the part is called."""
        part = self.plan.part
        return (part.name if part is not None else None) or "this part"

    @property
    def action(self) -> str:
        """What an action is called."""
        return self.plan.action_name

    @cached_property
    def traces(self) -> tuple[Trace, ...]:
        """The parts on the stage; none if the plan is for no part."""
        return () if self.plan.part is None else traces(self.plan)

    @cached_property
    def outcomes(self) -> tuple[Outcome, ...]:
        """What is left after each action."""
        return tuple(self.plan.outcomes())

    def state(self, step: int) -> Hyperstate:
        """Return the distribution after so many actions, without what cannot occur."""
        if step not in self._states:
            self._states[step] = self.outcomes[step - 1].hyperstate().possible()
        return self._states[step]

    def left(self, step: int) -> int:
        """Return how many orientations are possible after so many actions."""
        return len(self.outcomes[step - 1]) if self.plan.prior is None else len(self.state(step))

    @cached_property
    def chain(self) -> tuple[Preimage, ...]:
        """The preimages of 1, 2, ... actions, some more than the plan has.

        Those of the plan and, where phase I can be taken up again, the next wider ones.
        """
        own = self.plan.preimages
        final_step = own[0].first % len(self.plan.transfer)
        for final_steps in (None, (final_step,)):
            spread = 2 * self.plan.gripper_error
            longer = Preimages(self.plan.transfer, spread, final_steps)
            if _steps(tuple(islice(longer, len(own)))) == _steps(own):
                return tuple(islice(longer, len(own) + MOST_MORE))
        return own

    def worth(self, preimage: Preimage) -> tuple[Probability, Number] | None:
        """Return probability and expected cost of the best plan of so many actions, if any."""
        placement = place(preimage, self.plan.prior, self.plan.gripper_error)
        if placement is None:
            return None
        cost = expected_cost(preimage.steps + self.plan.cost_ratio, placement.probability)
        return placement.probability, cost

    @property
    def price(self) -> str:
        """What a pass through the filter costs."""
        times = "time" if self.plan.cost_ratio == 1 else "times"
        return f"{rational_text(self.plan.cost_ratio)} {self.action} {times}"


def _steps(chain: Sequence[Preimage]) -> list[tuple[int, int]]:
    return [(preimage.first, preimage.last) for preimage in chain]


def shown_rows(count: int, *also: int) -> list[int | None]:
    """Return 0 to `count` - 1, or the first, the last and those in `also`, with None for gaps.

    Examples
    --------
    >>> [k for k in shown_rows(100, 50) if k is None or 18 < k < 82]
    [19, None, 50, None, 80, 81]
    """
    half = MOST_ROWS // 2
    if count <= MOST_ROWS:
        return [*range(count)]
    shown: list[int | None] = []
    last = -1
    for k in sorted({*range(half), *also, *range(count - half, count)}):
        if k > last + 1:
            shown.append(None)
        shown.append(k)
        last = k
    return shown
