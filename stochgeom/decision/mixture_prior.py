"""Mixtures of priors: exact if all components are, else searched and bounded.

Points and step densities mix to points and a step density, whose best window is found exactly
(`stochgeom.decision.measures`). With a component of another kind the start is searched
numerically; the mass of the window found is as certified as the components allow, and no window
exceeds the weighted sum of what the components' own best windows catch.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.atoms import WeightedPoints
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.measures import StepMeasure
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import Prior, UniformPrior, Window, as_pairs, as_share, check_width
from stochgeom.decision.step_density import StepDensity
from stochgeom.errors import InputError, PriorError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import RationalLike, rational_text
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.exact.vectors import FloatArray

CELLS: Final = 720
"""Starts tried by a numerical search before it narrows down."""

_EVERYWHERE: Final = StepDensity([(ZERO, mpq(1))], mpq(1))


@final
class MixturePrior(Prior):
    """A weighted mixture of priors: with probability w_j the orientation comes from prior j.

    Parameters
    ----------
    components : iterable of (rational, Prior)
        Weights, 0 or more, of sum 1, and priors.

    Attributes
    ----------
    components : tuple of (mpq, Prior)
        Those of positive weight.

    Raises
    ------
    PriorError
        If there are none, a weight is negative, or the sum is not 1.

    Examples
    --------
    Half of the parts arrive at 90 degrees, half somewhere in [0, 90). A window of 90 degrees that
    catches the first must not begin at 0, and loses little by beginning just above it:

    >>> spread = PiecewisePrior([(Arc(ZERO, Angle.from_degrees(90)), 4)])
    >>> prior = MixturePrior([("1/2", DiscretePrior({"90": 1})), ("1/2", spread)])
    >>> window = prior.best_window(Angle.from_degrees(90))
    >>> window.exact, str(window.mass), window.at_most.rational
    (False, '1.0000', mpq(1,1))
    """

    kind = "mixture"

    def __init__(self, components: Iterable[tuple[RationalLike, Prior]]) -> None:
        listed = []
        pairs = as_pairs(components, what="component", accepted="a weight and a prior")
        for k, (value, prior) in enumerate(pairs):
            if not isinstance(prior, Prior):
                raise InputError(f"{prior!r}; accepted: priors", where=f"component {k}")
            listed.append((as_share(value, where=f"component {k}"), prior))
        total = sum((weight for weight, _ in listed), start=mpq(0))
        if total != 1:
            what = f"{len(listed)} weights sum to {total}" if listed else "no components"
            raise PriorError(f"{what}; accepted: weights of sum 1")
        self.components = tuple((weight, prior) for weight, prior in listed if weight)
        self._measure = _as_measure(self.components)

    def describe(self) -> str:
        """Return one line for people."""
        parts = [f"{rational_text(w)} of ({prior.describe()})" for w, prior in self.components]
        return "mixture: " + ", ".join(parts)

    def mass(self, arc: Arc) -> Probability:
        """Return the weighted sum of the components' masses, as exact as they are."""
        if arc.width == FULL_TURN:
            return AngleSum(1)
        if self._measure is not None:
            return self._measure.mass(arc)
        return _weighted([(w, prior.mass(arc)) for w, prior in self.components])

    def best_window(self, width: Angle) -> Window:
        """Return the best window, exactly if all components are exact; else the best one found."""
        if check_width(width) == FULL_TURN:
            return Window(ZERO, AngleSum(1), exact=True)
        if self._measure is not None:
            return self._measure.best_window(width)
        windows = [(w, prior.best_window(width)) for w, prior in self.components]
        starts = [window.start for _, window in windows]
        starts += [self._found(width, near) for near in (None, *starts)]
        best = self._largest(sorted(set(starts)), width)
        bounds = [(w, _bound(window)) for w, window in windows]
        known = [(w, bound) for w, bound in bounds if bound is not None]
        at_most = _weighted(known) if len(known) == len(bounds) else None
        return Window(best, self.mass(Arc(best, width)), exact=False, at_most=at_most)

    def _largest(self, starts: list[Angle], width: Angle) -> Angle:
        masses = [float(self.mass(Arc(start, width))) for start in starts]
        return starts[masses.index(max(masses))]

    def _found(self, width: Angle, near: Angle | None) -> Angle:
        """Return a start found by halving steps, from the best of a grid or from another one."""
        if near is None:
            h = float(AngleSum(0, [(1, width)]))
            grid = np.arange(CELLS) / CELLS
            gains = self._cumulative(grid + h) - self._cumulative(grid)
            start, step = Angle.from_turns(mpq(int(np.argmax(gains)), CELLS)), mpq(1, 2 * CELLS)
        else:
            start, step = near, mpq(1, 8 * CELLS)
        best = float(self.mass(Arc(start, width)))
        while step > mpq(1, 10**8):
            moves = [(start + Angle.from_turns(s * step)).reduced() for s in (-1, 1)]
            masses = [float(self.mass(Arc(move, width))) for move in moves]
            if max(masses) > best + 2.0**-40:  # less is not worth another step
                best = max(masses)
                start = moves[masses.index(best)]
            else:
                step /= 2
        return start

    @cached_property
    def _table(self) -> FloatArray:
        step = Angle.from_turns(mpq(1, CELLS))
        cells = [Arc(step * k, step) for k in range(CELLS)]
        masses = np.array([float(self.mass(cell)) for cell in cells])
        return np.concatenate(([0.0], np.cumsum(masses)))

    def _cumulative(self, turns: FloatArray) -> FloatArray:
        whole = np.floor(turns)
        places = np.arange(CELLS + 1) / CELLS
        values: FloatArray = np.interp(turns - whole, places, self._table) + whole
        return values

    def __repr__(self) -> str:
        parts = ", ".join(f"({rational_text(w)!r}, {prior!r})" for w, prior in self.components)
        return f"MixturePrior([{parts}])"


def _as_measure(components: Iterable[tuple[mpq, Prior]]) -> StepMeasure | None:
    """Return the mixture as one exact measure, None if a component is no exact prior."""
    points: list[tuple[Angle, mpq]] = []
    densities: list[tuple[mpq, StepDensity]] = []
    pending = list(components)
    while pending:
        weight, prior = pending.pop()
        if isinstance(prior, MixturePrior):
            pending += [(weight * w, inner) for w, inner in prior.components]
        elif isinstance(prior, DiscretePrior):
            points += [(angle, weight * w) for angle, w in prior]
        elif isinstance(prior, PiecewisePrior):
            densities.append((weight, prior.density))
        elif isinstance(prior, UniformPrior):
            densities.append((weight, _EVERYWHERE))
        else:
            return None
    return StepMeasure(WeightedPoints(points), StepDensity.combine(densities))


def _weighted(parts: list[tuple[mpq, Probability]]) -> Probability:
    total: Any = AngleSum()
    for weight, mass in parts:
        total = total + mass.scaled(weight)
    result: Probability = total
    return result


def _bound(window: Window) -> Probability | None:
    """Return what no window of that width exceeds, None if unknown."""
    return window.mass if window.exact else window.at_most
