"""Estimated weights of cells, and the prior they make."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc

DECIMALS: Final = 9
"""Numerical weights are rounded to so many decimals, with a sum of exactly 1."""


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

        Raises
        ------
        PriorError
            If a cell is an arc whose width is not rational in degrees.
        """
        pairs = list(zip(self.cells, self.weights, strict=True))
        arcs = [(cell, weight) for cell, weight in pairs if isinstance(cell, Arc)]
        if arcs:
            return PiecewisePrior.from_masses(arcs)
        return DiscretePrior([(cell, w) for cell, w in pairs if isinstance(cell, Angle)])


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
