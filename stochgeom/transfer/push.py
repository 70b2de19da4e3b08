"""The push function: where a part turns to when one frictionless jaw pushes it far enough.

A pushed part turns so that its centre of mass comes closer to the jaw, until an edge lies flush.
So every orientation between two neighbouring maxima of the radius function goes to the minimum
between them (thesis App. E.1.2). At a maximum itself the step to the right applies.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.angles import HALF_TURN
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.step_function import StepFunction


def push_function(
    part: Part | RadiusFunction | Iterable[PointLike] | NDArray[Any],
    *,
    upper_jaw: bool = False,
) -> StepFunction:
    """Return the push function of a part.  O(n) after the hull.

    Parameters
    ----------
    part : Part, RadiusFunction, or the vertices of a part
        Edges that are not stable under a push have no step.
    upper_jaw : bool, default False
        Whether the upper jaw pushes, downwards, instead of the lower one: the same half a turn on.

    Returns
    -------
    StepFunction
        Of period 360 degrees or a whole share of it.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> s = push_function([(0, 0), (4, 0), (0, 3)])
    >>> [b.degrees(2) for b in s.breaks], [v.degrees(2) for v in s.values]
    (['53.13', '146.31', '290.56'], ['90.00', '216.87', '360.00'])
    """
    radius = part if isinstance(part, RadiusFunction) else RadiusFunction(as_part(part))
    lower = StepFunction(*push_steps(radius))
    return lower.rotate(-HALF_TURN) if upper_jaw else lower


def push_steps(radius: RadiusFunction) -> tuple[AngleVector, AngleVector]:
    """Return the breaks of a push by the lower jaw in a full turn, and their values."""
    breaks, minima = radius.maxima, radius.minima
    # Maxima and minima alternate; the value of a break is the minimum that follows it.
    if minima[0] < breaks[0]:
        x, y, turns = minima.x, minima.y, np.zeros(len(minima), dtype=np.int64)
        turns[-1] = 1
        minima = AngleVector(turns, np.append(x[1:], x[0]), np.append(y[1:], y[0]))
    return breaks, minima
