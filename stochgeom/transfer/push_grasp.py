"""The push-grasp function: a push by one jaw, then a squeeze by both.

The push decides which way round the part ends up, which a squeeze alone cannot: the composite has
period 360 degrees for most parts (thesis App. E.1.3).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from numpy.typing import NDArray

from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction


def push_grasp_function(
    part: Part | Iterable[PointLike] | NDArray[Any], *, upper_jaw: bool = False
) -> StepFunction:
    """Return the push-grasp function of a part, squeeze after push.  O(n log n); O(n) memory.

    Parameters
    ----------
    part : Part, or the vertices of a part
        Its centre of mass decides the push, its outline both.
    upper_jaw : bool, default False
        Whether the upper jaw pushes instead of the lower one.

    Returns
    -------
    StepFunction
        Of period 360 degrees or a whole share of it. A value may lie outside its own step. No
        value of the push falls on a break of the squeeze: there an edge is flush, here none is.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> s = push_grasp_function([(0, 0), (4, 0), (0, 3)])
    >>> [b.degrees(2) for b in s.breaks], [v.degrees(2) for v in s.values]
    (['146.31', '290.56'], ['216.87', '396.87'])
    """
    part = as_part(part)
    return squeeze_function(part).compose(push_function(part, upper_jaw=upper_jaw))
