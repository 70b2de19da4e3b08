"""Cells that mouths do not cut, estimated weights of cells, and the prior they make."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import MAX_BINS, PiecewisePrior
from stochgeom.errors import PriorError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc

DECIMALS: Final = 9
"""Numerical weights, and ends of arcs in degrees, are rounded to so many decimals."""


@final
@dataclass(frozen=True)
class PriorEstimate:
    """Estimated weights of the cells.

    Attributes
    ----------
    cells : tuple of Angle or Arc
        The cells.
    weights : tuple of mpq
        Of sum exactly 1.
    method : str
        How they were found.
    exact : bool
        Whether they are the exact answer of the method.
    standard_errors : tuple of float
        Of sampling, not of the data; empty where nothing was sampled.
    gap : float or None
        For the maximum likelihood, by how much log L may still grow.
    iterations : int
        Rounds done.
    """

    cells: tuple[Angle | Arc, ...]
    weights: tuple[mpq, ...]
    method: str
    exact: bool
    standard_errors: tuple[float, ...] = ()
    gap: float | None = None
    iterations: int = 0

    def to_prior(self) -> DiscretePrior | PiecewisePrior:
        """Return the estimate as a prior, to plan with again.

        A cell keeps its weight. Ends of arcs that are not rational in degrees, as those of mouths
        are, move to the nearest `DECIMALS` decimals (more, if arcs are as narrow as that): between
        others a rational mass makes no rational density.
        """
        arcs = [cell for cell in self.cells if isinstance(cell, Arc)]
        if arcs:
            return PiecewisePrior.from_masses(
                zip(_at_rational_degrees(arcs), self.weights, strict=True)
            )
        pairs = zip(self.cells, self.weights, strict=True)
        return DiscretePrior([(cell, w) for cell, w in pairs if isinstance(cell, Angle)])


def cells_between(mouths: Iterable[Arc], bins: int = 1) -> tuple[Arc, ...]:
    """Return the arcs into which the ends of mouths, and equal bins, cut the circle.

    Each of them lies inside or outside every mouth, as `stochgeom.decision.rejections` asks.

    Parameters
    ----------
    mouths : iterable of Arc
        Of the plans whose successes were counted, with their first angles.
    bins : int, default 1
        How many equal arcs from 0 on are cut as well, 1 or more.

    Raises
    ------
    PriorError
        If the number of bins is not acceptable.

    Examples
    --------
    >>> cells = cells_between([Arc(Angle.from_degrees(10), Angle.from_degrees(40))])
    >>> [(cell.start.degrees(0), cell.width.degrees(0)) for cell in cells]
    [('0', '10'), ('10', '40'), ('50', '310')]
    """
    bins = as_count(bins, "bins", most=MAX_BINS, error=PriorError)
    mouths = as_list(mouths, "a list of arcs", "mouths")
    for k, mouth in enumerate(mouths):
        expect(mouth, Arc, "an Arc", f"mouth {k}")
    ends = {Angle.from_turns(mpq(k, bins)) for k in range(bins)}
    for mouth in mouths:
        if mouth.width != FULL_TURN:
            ends |= {mouth.start.reduced(), mouth.end.reduced()}
    places = sorted(ends)
    return tuple(Arc(a, b - a) for a, b in pairwise((*places, places[0] + FULL_TURN)))


def _at_rational_degrees(arcs: Sequence[Arc]) -> list[Arc]:
    """Return arcs with their ends moved to rational degrees, and none of them vanished."""
    digits = DECIMALS
    while True:
        ends = [(_degrees(arc.start, digits), _degrees(arc.end, digits)) for arc in arcs]
        if all(low < high for low, high in ends):
            return [
                Arc(Angle.from_turns(low / 360), Angle.from_turns((high - low) / 360))
                for low, high in ends
            ]
        digits *= 2


def _degrees(angle: Angle, digits: int) -> mpq:
    exact = angle.rational_turns
    return mpq(angle.degrees(digits)) if exact is None else exact * 360


def round_to_sum_one(weights: NDArray[np.float64]) -> tuple[mpq, ...]:
    """Round to `DECIMALS` decimals; the largest weight takes what is missing to 1.

    Examples
    --------
    >>> round_to_sum_one(np.array([1 / 3, 2 / 3]))
    (mpq(333333333,1000000000), mpq(666666667,1000000000))
    """
    units = [round(float(weight) * 10**DECIMALS) for weight in weights]
    units[int(np.argmax(weights))] += 10**DECIMALS - sum(units)
    return tuple(mpq(unit, 10**DECIMALS) for unit in units)
