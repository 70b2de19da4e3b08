"""How stable a grasp is, by how far it may be disturbed.

The stability Psi of a stable orientation is the smallest turn that takes the part to a neighbouring
one: the distance to the nearer of the two maxima of the diameter that enclose it (thesis Eq. D.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

from stochgeom.exact.angles import Angle
from stochgeom.geometry.part import Part, PartLike
from stochgeom.transfer.squeeze import squeeze_function


@final
@dataclass(frozen=True, slots=True)
class StableGrasp:
    """A stable orientation between the jaws, and its stability.

    Attributes
    ----------
    orientation : Angle
        A strict local minimum of the diameter, in [0, T) for the period T of the squeeze function.
    stability : Angle
        Psi, at most half of T.
    """

    orientation: Angle
    stability: Angle


def stable_grasps(part: PartLike) -> tuple[StableGrasp, ...]:
    """Return the stable grasps of one period of the squeeze function, by orientation.

    O(n log n), and an exact angle for each.

    Examples
    --------
    >>> [(g.orientation.degrees(1), g.stability.degrees(1))
    ...  for g in stable_grasps([(0, 0), (3, 0), (3, 2), (0, 2)])]
    [('0.0', '56.3'), ('90.0', '33.7')]
    """
    squeeze = squeeze_function(part)
    breaks, values = squeeze.lifted_breaks, squeeze.lifted_values
    grasps = []
    for k in range(len(squeeze)):
        value = values[k]
        stability = min(value - breaks[k], breaks[k + 1] - value)
        grasps.append(StableGrasp(value % squeeze.period, stability))
    return tuple(sorted(grasps, key=lambda grasp: grasp.orientation))


def stabilities(part: Part, orientations: Sequence[Angle]) -> tuple[Angle, ...]:
    """Return Psi of stable orientations, each modulo the period of the squeeze function.

    Final orientations of push-grasps are such, too.

    Examples
    --------
    >>> from stochgeom.geometry.part import as_part
    >>> rectangle = as_part([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [psi.degrees(1) for psi in stabilities(rectangle, [Angle.from_degrees(270)])]
    ['33.7']
    """
    period = squeeze_function(part).period
    known = {grasp.orientation: grasp.stability for grasp in stable_grasps(part)}
    return tuple(known[angle % period] for angle in orientations)


def most_stable_grasps(part: PartLike) -> tuple[StableGrasp, ...]:
    """Return the grasps of largest stability (thesis Eq. D.5): one, or several equal ones.

    Examples
    --------
    >>> [g.orientation.degrees(0) for g in most_stable_grasps([(0, 0), (3, 0), (3, 2), (0, 2)])]
    ['0']
    """
    grasps = stable_grasps(part)
    best = max(grasp.stability for grasp in grasps)
    return tuple(grasp for grasp in grasps if grasp.stability == best)
