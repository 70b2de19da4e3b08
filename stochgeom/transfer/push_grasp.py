"""The push-grasp function: a push by one jaw, then a squeeze by both.

The push decides which way round the part ends up, which a squeeze alone cannot: the composite has
period 360 degrees for most parts (thesis App. E.1.3).
"""

from __future__ import annotations

from stochgeom.exact.angles import FULL_TURN, HALF_TURN
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.composition import composed_steps
from stochgeom.transfer.push import push_steps
from stochgeom.transfer.squeeze import squeeze_steps
from stochgeom.transfer.step_function import StepFunction


def push_grasp_function(part: PartLike, *, upper_jaw: bool = False) -> StepFunction:
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
    squeeze = [LiftedAngles(a, HALF_TURN) for a in squeeze_steps(DiameterFunction(part))]
    push = [LiftedAngles(a, FULL_TURN) for a in push_steps(RadiusFunction(part))]
    # Neither map is brought into canonical form by itself: that takes as long as the rest.
    breaks, values = composed_steps(
        (squeeze[0], squeeze[1]), (push[0], push[1]), copies=1, rise=2 * len(squeeze[0])
    )
    lower = StepFunction(breaks, values)
    # Half a turn on, the squeeze is the same, and the push that of the upper jaw.
    return lower.rotate(-HALF_TURN) if upper_jaw else lower
