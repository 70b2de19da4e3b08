"""Which initial orientations stand for a prior in pictures: some that really arrive.

A picture decides nothing: quantiles are found by floats.
"""

from __future__ import annotations

from typing import Final

from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.priors import Prior
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc

_GRID: Final = 36_000
"""Quantiles are multiples of a hundredth of a degree."""


def arriving_orientations(prior: Prior, most: int) -> tuple[Angle, ...]:
    """Return initial orientations that stand for a prior, increasing, at most so many.

    Of a prior of points the points, the heaviest of many; of another one those that part it into
    equal shares, each the middle of its share. Fewer where these coincide.

    Parameters
    ----------
    prior : Prior
        Of the orientations before the first action.
    most : int
        1 or more.

    Examples
    --------
    >>> from stochgeom.decision.density_priors import WrappedNormal
    >>> points = DiscretePrior.from_counts({"0": 50, "90": 30, "180": 0})
    >>> [theta.degrees(1) for theta in arriving_orientations(points, 4)]
    ['0.0', '90.0']
    >>> normal = WrappedNormal("30", "12")
    >>> [theta.degrees(1) for theta in arriving_orientations(normal, 3)]
    ['18.7', '30.2', '41.9']
    """
    if isinstance(prior, DiscretePrior):
        heavy = sorted((pair for pair in prior if pair[1]), key=lambda pair: -pair[1])[:most]
        return tuple(sorted(theta for theta, _ in heavy))
    places = {_quantile(prior, mpq(2 * k + 1, 2 * most)) for k in range(most)}
    return tuple(Angle.from_turns(mpq(place, _GRID)) for place in sorted(places))


def _quantile(prior: Prior, share: mpq) -> int:
    """Return the last place of the grid with no more than so much of the prior before it."""
    low, high = 0, _GRID
    while high - low > 1:
        middle = (low + high) // 2
        arc = Arc(ZERO, Angle.from_turns(mpq(middle, _GRID)))
        low, high = (low, middle) if float(prior.mass(arc)) > share else (middle, high)
    return low
