"""Densities that are constant on arcs, with rational values per full turn: exact distributions.

On the piece [b_j, b_{j+1}) the distribution is F(theta) = C_j + d_j theta, where C_j collects
the pieces before it, so that a mass is a difference of two `AngleSum`.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import final

import numpy as np
from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.shadows import TWO_PI, shadow
from stochgeom.exact.sums import AngleSum
from stochgeom.exact.vectors import FloatArray


@final
class StepDensity:
    """A step function on the circle, 0 or more, not necessarily of integral 1.

    Parameters
    ----------
    changes : iterable of (Angle, mpq)
        Where in [0, 360) degrees the density changes, and by how much, from 0 just before 0.
    total : mpq
        The integral, which the caller knows.

    Attributes
    ----------
    breaks : tuple of Angle
        Increasing from 0, where the density changes, and 0 itself.
    densities : tuple of mpq
        The density on [break j, break j + 1), per full turn.
    total : mpq
        The integral.
    """

    def __init__(self, changes: Iterable[tuple[Angle, mpq]], total: mpq) -> None:
        steps: dict[Angle, mpq] = {ZERO: mpq(0)}
        for place, change in changes:
            steps[place] = steps.get(place, mpq(0)) + change
        places = sorted(place for place, change in steps.items() if change or not place)
        densities, level = [], mpq(0)
        for place in places:
            level += steps[place]
            densities.append(level)
        self.breaks, self.densities, self.total = tuple(places), tuple(densities), total

    @classmethod
    def of_arcs(cls, pieces: Iterable[tuple[Arc, mpq]], total: mpq) -> StepDensity:
        """Return the density that is the sum of constants on arcs."""
        changes = []
        for arc, value in pieces:
            for part in arc.split():
                changes.append((part.start, value))
                if part.end < FULL_TURN:
                    changes.append((part.end, -value))
        return cls(changes, total)

    @classmethod
    def combine(cls, parts: Sequence[tuple[mpq, StepDensity]]) -> StepDensity:
        """Return a weighted sum."""
        changes: list[tuple[Angle, mpq]] = []
        for weight, density in parts:
            before = mpq(0)
            for place, level in zip(density.breaks, density.densities, strict=True):
                changes.append((place, weight * (level - before)))
                before = level
        return cls(changes, sum((weight * part.total for weight, part in parts), start=mpq(0)))

    # --- exact -----------------------------------------------------------------------------------

    def __call__(self, theta: Angle) -> mpq:
        """Return the density at theta, taken modulo a turn."""
        return self.densities[bisect_right(self.breaks, theta.reduced()) - 1]

    def mass(self, arc: Arc) -> AngleSum:
        """Return the integral over an arc.  O(log k)."""
        start = arc.start.reduced()
        return self._below(start + arc.width) - self._below(start)

    def _below(self, theta: Angle) -> AngleSum:
        """Return F(theta), theta in [0, 720) degrees."""
        over = theta >= FULL_TURN
        rest = theta - FULL_TURN if over else theta
        j = bisect_right(self.breaks, rest) - 1
        value = self._constants[j] + AngleSum(0, [(self.densities[j], rest)])
        return value + AngleSum(self.total) if over else value

    @cached_property
    def _constants(self) -> list[AngleSum]:
        """C_j = C_{j-1} - (d_j - d_{j-1}) b_j: the distribution is continuous at b_j."""
        constants = [AngleSum()]
        for j in range(1, len(self.breaks)):
            rise = self.densities[j] - self.densities[j - 1]
            constants.append(constants[-1] - AngleSum(0, [(rise, self.breaks[j])]))
        return constants

    # --- floats, to filter with ------------------------------------------------------------------

    @cached_property
    def _knots(self) -> tuple[FloatArray, FloatArray]:
        places = [shadow(place) / TWO_PI for place in self.breaks]
        values = [float(self._below(place)) for place in self.breaks]
        return (
            np.maximum.accumulate(np.array([*places, 1.0])),
            np.array([*values, float(self.total)]),
        )

    def cumulative(self, turns: FloatArray) -> FloatArray:
        """Return F at floats (in turns), continued beyond one turn."""
        whole = np.floor(turns)
        values: FloatArray = np.interp(turns - whole, *self._knots) + whole * float(self.total)
        return values

    @cached_property
    def margin(self) -> float:
        """A bound on the error of cumulative(s + h) - cumulative(s) for float starts.

        For s and h within 2**-43 turns of exact ones, |s| and |h| at most 1: the knots are off by
        2**-47 turns and their values by 2**-50 of at most `total`; the largest density D carries
        errors of places to values; where two knots nearly coincide, F differs by D times their
        distance at most. Five errors of places, twice, and all roundings are below
        (total + D) 2**-39.
        """
        return (float(self.total) + float(max(self.densities))) * 2.0**-39
