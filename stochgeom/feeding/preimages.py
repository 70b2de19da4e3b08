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
from dataclasses import dataclass
from typing import final

import numpy as np

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.lifted import Indices
from stochgeom.transfer.step_function import StepFunction


@final
@dataclass(frozen=True, slots=True)
class Preimage:
    """The widest arc that a number of actions collapses into one orientation.

    Attributes
    ----------
    steps : int
        i, the number of actions, from 1.
    arc : Arc
        Theta_i = [a, a + h), with a in [0, T).
    image : ClosedArc
        What the next action makes of it: [s(a), s(just before a + h)].
    competitors : int
        How many maximal arcs were compared: one for each break of a period.
    ties : int
        How many of them are as wide.
    first, last : int
        Numbers of the first and the last step of the arc: it runs from break `first` to break
        `last` + 1, its image from value `first` to value `last`.
    """

    steps: int
    arc: Arc
    image: ClosedArc
    competitors: int
    ties: int
    first: int
    last: int

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
        return bool(self._found) and self._found[-1].width == self.transfer.period

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
        if self._found:
            last = transfer.lifted_values.last_below(self._found[-1].width)
            widest = transfer.lifted_breaks.largest_gaps(last)
        else:
            last = np.arange(len(transfer))  # an arc of one step has an image of width zero
            widest = transfer.lifted_breaks.largest_steps()
        first = self._narrowest_image(widest, last)
        breaks, values = transfer.lifted_breaks, transfer.lifted_values
        start, end = breaks[first], breaks[int(last[first]) + 1]
        low, high = values[first], values[int(last[first])]
        preimage = Preimage(
            steps=len(self._found) + 1,
            arc=Arc(start, end - start),
            image=ClosedArc(low, high - low),
            competitors=len(transfer),
            ties=len(widest),
            first=first,
            last=int(last[first]),
        )
        if self._found and preimage.width <= self._found[-1].width:
            raise AssertionError(  # pragma: no cover
                f"preimage {preimage.steps} is no wider than the one before: Theorem 5.3 fails"
            )
        return preimage

    def _narrowest_image(self, widest: Indices, last: Indices) -> int:
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
