"""The squeeze function: where a part turns to when frictionless parallel jaws close on it.

While the jaws close, the part turns towards smaller diameters, so every orientation between two
neighbouring maxima of the diameter function goes to the minimum between them (thesis 4.4.2). At
a maximum itself the step to the right applies.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.angles import HALF_TURN
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.transfer.step_function import StepFunction


def squeeze_function(
    part: Part | DiameterFunction | Iterable[PointLike] | NDArray[Any],
) -> StepFunction:
    """Return the squeeze function of a part.  O(n log n); O(n) memory.

    Parameters
    ----------
    part : Part, DiameterFunction, or the vertices of a part
        Edges that are not stable have no step; parallel edges make one step.

    Returns
    -------
    StepFunction
        Of period 180 degrees or a whole share of it.

    Examples
    --------
    >>> s = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [b.degrees(2) for b in s.breaks], [v.degrees(0) for v in s.values]
    (['56.31', '123.69'], ['90', '180'])
    """
    diameter = part if isinstance(part, DiameterFunction) else DiameterFunction(as_part(part))
    return StepFunction(*squeeze_steps(diameter), HALF_TURN)


def squeeze_steps(diameter: DiameterFunction) -> tuple[AngleVector, AngleVector]:
    """Return the breaks of a squeeze in half a turn, and their values, as the part has them."""
    breaks, minima = diameter.maxima, diameter.minima
    # Maxima and minima alternate; the value of a break is the minimum that follows it. Half a
    # turn on, a direction is reversed.
    if minima[0] < breaks[0]:
        x, y = minima.x, minima.y
        x, y = np.append(x[1:], -x[0]), np.append(y[1:], -y[0])
        minima = AngleVector.from_directions(x, y)
    return breaks, minima
