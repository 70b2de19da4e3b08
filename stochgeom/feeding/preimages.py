"""Phase I of the backchaining planner: the widest preimages, one action after the other.

A preimage of i steps is an arc Theta_i of orientations that i actions collapse into one. Stage 1
takes the widest step of the transfer function. Stage i takes the widest arc whose image is
strictly narrower than Theta_{i-1}, since an image that fits inside the last preimage can be
turned into it. The widths h_i grow strictly until a period is reached (thesis Thm 5.3), and no
plan of i steps collapses a wider set (Thm 5.1).

The widest arc begins at a break: moving its start left to one leaves the image as it is. So each
stage compares one arc for each break of a period, in O(m) after the shadows are made: for step i
the last step k with v_k < v_i + h_{i-1}, giving the arc [b_i, b_{k+1}). Of equally wide arcs the
one of narrowest image wins (the largest tolerance), then the one of smallest start.

The source tests h_i = T from the second stage on; it holds at the first for squares, right and
obtuse triangles, so it is tested from the first stage.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import final

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
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
        How many of the arcs compared are as wide.
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
    def competitors(self) -> int:
        """How many maximal arcs were compared: one for each break of a period."""
        return len(self.transfer)

    @property
    def width(self) -> Angle:
        """h_i, the width of the arc."""
        return self.arc.width

    @property
    def image_width(self) -> Angle:
        """The width of the image, less than h_{i-1}."""
        return self.image.width


@final
class Preimages:
    """The preimages of a transfer function, computed as they are asked for.

    Iterating gives `Preimage` objects for 1, 2, ... steps and ends with the first whose width is
    the period. What was computed is kept.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> chain = Preimages(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [p.width.degrees(2) for p in chain]
    ['112.62', '180.00']
    """

    def __init__(self, transfer: StepFunction) -> None:
        self.transfer = transfer
        self._found: list[Preimage] = []

    @property
    def complete(self) -> bool:
        """Whether the last preimage found is a period wide."""
        return bool(self._found) and self._found[-1].is_period

    def __iter__(self) -> Iterator[Preimage]:
        steps = 1
        while True:
            yield self.of_steps(steps)
            if self.complete and steps >= len(self._found):
                return
            steps += 1

    def of_steps(self, steps: int) -> Preimage:
        """Return the preimage of the given number of steps.

        Beyond the step where a period is reached, the last preimage: more steps do no better.

        Raises
        ------
        InputError
            If `steps` is below 1.
        """
        if steps < 1:
            raise InputError(f"a preimage of {steps} steps; accepted: 1 or more")
        while len(self._found) < steps and not self.complete:
            self._found.append(self._next())
        return self._found[min(steps, len(self._found)) - 1]

    def found(self) -> tuple[Preimage, ...]:
        """Return the preimages computed so far."""
        return tuple(self._found)

    def _next(self) -> Preimage:
        transfer = self.transfer
        if len(transfer) == 1:
            return Preimage(transfer, steps=1, first=0, last=0, ties=1)  # nothing to compare
        last: Indices | range
        if self._found:
            last = transfer.lifted_values.last_below(self._found[-1].gap)
            widest = transfer.lifted_breaks.largest_gaps(last)
        else:
            last = range(len(transfer))  # an arc of one step has an image of width zero
            widest = transfer.lifted_breaks.largest_steps()
        first = self._narrowest_image(widest, last)
        steps = len(self._found) + 1
        return Preimage(transfer, steps, first, int(last[first]), len(widest))

    def _narrowest_image(self, widest: Indices, last: Indices | range) -> int:
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
