"""Phase I of the backchaining planner: the widest preimages, one action after the other.

A preimage of i steps is an arc Theta_i of orientations that i actions collapse into one. Stage 1
takes the widest step of the transfer function. Stage i takes the widest arc whose image is
strictly narrower than Theta_{i-1}, since an image that fits inside the last preimage can be
turned into it. The widths h_i grow strictly until a period is reached (thesis Thm 5.3), and no
plan of i steps collapses a wider set (Thm 5.1).

The widest arc begins at a break: moving its start left to one leaves the image as it is. So each
stage compares one arc for each break of a period: for step i the last step k with v_k < v_i +
h_{i-1}, giving the arc [b_i, b_{k+1}). Of equally wide arcs the one of narrowest image wins (the
largest tolerance), then the one of smallest start. Each k is found by bisection, so that a stage
takes O(m log m) after the shadows are made, where two pointers would take O(m) (Thm 5.4).

The source tests h_i = T from the second stage on; it holds at the first for squares, right and
obtuse triangles, so it is tested from the first stage.

Two things may be asked beyond that:

- *Gripper error*: every action may be off by up to delta either way. An image of width w then
  needs w + 2 delta < h_{i-1} to be turned into Theta_{i-1} for sure: the limit is h_{i-1} - 2
  delta. The widths no longer need to grow; the chain ends where they stop growing, since the next
  limit would be the same.
- *Final orientations*: only some steps may be the last one. Theta_1 is the widest of those. The
  chain still reaches a period without gripper error: from the second stage on, every single step
  has an image narrow enough (of width zero), so h_2 is at least the widest step.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import final

import numpy as np

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.display import Displayed
from stochgeom.errors import InputError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.lifted import Gap, Indices
from stochgeom.transfer.step_function import StepFunction


@final
@dataclass(frozen=True)
class Preimage:
    """The widest arc that a number of actions collapses into one orientation.

    Angles are made when asked for: a stage of phase I makes none.

    Attributes
    ----------
    transfer : StepFunction
        What one action does.
    steps : int
        i, the number of actions, from 1.
    first, last : int
        Numbers of the first and the last step of the arc: it runs from break `first` to break
        `last` + 1, its image from value `first` to value `last`.
    ties : int
        How many of the arcs compared are as wide; one is compared for each break of a period.
    """

    transfer: StepFunction = field(repr=False)
    steps: int
    first: int
    last: int
    ties: int

    @cached_property
    def arc(self) -> Arc:
        """Theta_i = [a, a + h), with a in [0, T)."""
        breaks = self.transfer.lifted_breaks
        start = breaks[self.first]
        return Arc(start, self.transfer.period if self.is_period else self.gap.angle)

    @cached_property
    def image(self) -> ClosedArc:
        """What the next action makes of the arc: [s(a), s(just before a + h)]."""
        values = self.transfer.lifted_values
        low = values[self.first]
        return ClosedArc(low, values[self.last] - low)

    @cached_property
    def gap(self) -> Gap:
        """The width as a difference of two breaks."""
        return self.transfer.lifted_breaks.gap(self.first, self.last + 1)

    @property
    def is_period(self) -> bool:
        """Whether the arc is a period wide: breaks increase strictly, so the step numbers tell."""
        return self.last + 1 == self.first + len(self.transfer)

    @property
    def width(self) -> Angle:
        """h_i, the width of the arc."""
        return self.arc.width

    @property
    def image_width(self) -> Angle:
        """The width of the image, less than h_{i-1}."""
        return self.image.width


@final
class Preimages(Displayed):
    """The preimages of a transfer function, computed as they are asked for.

    Iterating gives `Preimage` objects for 1, 2, ... steps and ends with the first whose width is
    the period, or with the last that is wider than the one before. What was computed is kept.

    Parameters
    ----------
    transfer : StepFunction
        The transfer function of one action.
    spread : Angle
        2 delta >= 0, where every action but the first may be off by up to delta either way.
    final_steps : sequence of int, optional
        Numbers in [0, m) of the steps that the last action may end with; default: all.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> chain = Preimages(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [p.width.degrees(2) for p in chain]
    ['112.62', '180.00']
    """

    def __init__(
        self,
        transfer: StepFunction,
        spread: Angle = ZERO,
        final_steps: Sequence[int] | None = None,
    ) -> None:
        self.transfer = expect(
            transfer, StepFunction, "a StepFunction, such as squeeze_function(part)", "transfer"
        )
        self.spread = expect(spread, Angle, "an Angle", "spread")
        steps = "a list of numbers of steps"
        self.final_steps = None if final_steps is None else tuple(as_list(final_steps, steps))
        self._found: list[Preimage] = []
        self._stalled = False

    @property
    def complete(self) -> bool:
        """Whether the last preimage found is a period wide."""
        return bool(self._found) and self._found[-1].is_period

    @property
    def stalled(self) -> bool:
        """Whether more actions were tried and do not collapse a wider arc."""
        return self._stalled

    def __iter__(self) -> Iterator[Preimage]:
        steps = 1
        while True:
            preimage = self.of_steps(steps)
            if preimage.steps < steps:
                return
            yield preimage
            steps += 1

    def of_steps(self, steps: int) -> Preimage:
        """Return the preimage of the given number of steps.

        Beyond the step where the chain ends, the last preimage: more steps do no better.

        Raises
        ------
        InputError
            If `steps` is below 1.
        """
        steps = as_count(steps, "steps")
        while len(self._found) < steps and not (self._stalled or self.complete):
            self._extend()
        return self._found[min(steps, len(self._found)) - 1]

    def found(self) -> tuple[Preimage, ...]:
        """Return the preimages computed so far."""
        return tuple(self._found)

    def __repr__(self) -> str:
        known = f"{len(self._found)} known" + ", all" * (self.complete or self.stalled)
        return f"<Preimages under {len(self.transfer)} steps in {self.transfer.period}: {known}>"

    def _extend(self) -> None:
        """Find the next preimage, or that there is no wider one."""
        if not self._found:
            self._found.append(self._first())
            return
        before = self._found[-1]
        limit = self._limit(before)
        following = None if limit is None else self._widest(limit)
        # Without gripper error, widths grow by Theorem 5.3 (and see above, for final steps).
        if following is None or (self.spread and following.width <= before.width):
            self._stalled = True
        else:
            self._found.append(following)

    def _limit(self, before: Preimage) -> Angle | Gap | None:
        """Return what the next image has to be narrower than, None if nothing is."""
        if not self.spread:
            return before.gap
        limit = before.width - self.spread
        return limit if limit > ZERO else None

    def _first(self) -> Preimage:
        transfer, breaks = self.transfer, self.transfer.lifted_breaks
        if len(transfer) == 1:
            return Preimage(transfer, steps=1, first=0, last=0, ties=1)  # nothing to compare
        if self.final_steps is None:
            widest = breaks.largest_steps()
        else:
            allowed = np.array(sorted(self.final_steps), dtype=np.intp)
            widest = allowed[breaks.widest(allowed, allowed + 1)]
        first = int(widest[0])  # images of one step are all of width zero
        return Preimage(transfer, 1, first, first, len(widest))

    def _widest(self, limit: Angle | Gap) -> Preimage:
        transfer = self.transfer
        last, widest = transfer.lifted_breaks.widest_below(transfer.lifted_values, limit)
        first = self._narrowest_image(widest, last)
        return Preimage(transfer, len(self._found) + 1, first, int(last[first]), len(widest))

    def _narrowest_image(
        self, widest: Sequence[int] | Indices, last: Sequence[int] | Indices
    ) -> int:
        """Return the first of the widest arcs whose image is narrowest."""
        if len(widest) == 1:
            return int(widest[0])
        values = self.transfer.lifted_values
        return min((int(i) for i in widest), key=lambda i: (values[int(last[i])] - values[i], i))


def preimages(transfer: StepFunction) -> Preimages:
    """Return the preimages of phase I, lazily.

    Parameters
    ----------
    transfer : StepFunction
        Any monotone step map, such as `stochgeom.transfer.squeeze.squeeze_function` gives.

    Raises
    ------
    InputError
        If it is anything else.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> [p.steps for p in preimages(squeeze_function([(0, 0), (1, 0), (1, 1), (0, 1)]))]
    [1]
    """
    if not isinstance(transfer, StepFunction):
        raise InputError(
            f"{transfer!r:.60} is no StepFunction; accepted: one, such as squeeze_function(part)"
        )
    return Preimages(transfer)
