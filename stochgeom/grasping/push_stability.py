"""The push-stability diagram: how a part turns while one jaw pushes it (thesis Fig. 3.5).

A pushed part turns so that its centre of mass comes closer to the jaw, whatever the pressure under
it (Mason): towards a minimum of the radius function, where an edge is *stable*, away from a
maximum, where a vertex is an *unstable* equilibrium. Friction at the jaw plays no part, as the jaw
moves along its normal.

How fast it turns and how far it is pushed nobody knows. So the push G_p (Eq. 3.1) is set valued: an
orientation may become any one from itself to the stable one ahead, both taken. At an unstable
equilibrium the part may rest, or leave either way.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Any, final

from numpy.typing import NDArray

from stochgeom.display import Displayed
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, Angle
from stochgeom.exact.arcs import ClosedArc
from stochgeom.exact.cells import CellSet, merge
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.geometry.radius import RadiusFunction


class Jaw(Enum):
    """The jaw that touches first."""

    LOWER = "lower"
    UPPER = "upper"


class Motion(Enum):
    """How a part that is touched turns relative to the gripper."""

    COUNTERCLOCKWISE = 1
    STABLE = 0
    CLOCKWISE = -1
    UNSTABLE = 2
    WEDGED = 3


@final
@dataclass(frozen=True, slots=True)
class Valley:
    """A stable orientation with the unstable ones on both sides of it, lifted.

    Attributes
    ----------
    low, stable, high : Angle
        low < stable < high; the stable one is in [0, 360) degrees.
    """

    low: Angle
    stable: Angle
    high: Angle


@final
class PushStability(Displayed):
    """The push-stability diagram of a part for one jaw.

    Parameters
    ----------
    part : Part, its radius function, or its vertices
        Only the hull and the centre of mass matter.
    jaw : Jaw, default the lower one
        The jaw that pushes.

    Attributes
    ----------
    valleys : tuple of Valley
        The stable orientations, increasing, each with its unstable neighbours.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> square = PushStability([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> [theta.degrees(0) for theta in square.stable], square.motion(Angle(0, (2, 1))).name
    (['0', '90', '180', '270'], 'CLOCKWISE')
    """

    def __init__(
        self,
        part: Part | RadiusFunction | Iterable[PointLike] | NDArray[Any],
        jaw: Jaw = Jaw.LOWER,
    ) -> None:
        radius = part if isinstance(part, RadiusFunction) else RadiusFunction(as_part(part))
        self.part, self.jaw = radius.part, jaw
        minima, maxima = radius.minima.angles, radius.maxima.angles
        if jaw is Jaw.UPPER:  # the lower jaw, half a turn on
            minima, maxima = _half_turn_on(minima), _half_turn_on(maxima)
        self.valleys = _valleys(minima, maxima)

    @property
    def stable(self) -> tuple[Angle, ...]:
        """The orientations in which an edge is stable under the push, in [0, 360) degrees."""
        return tuple(valley.stable for valley in self.valleys)

    @cached_property
    def unstable(self) -> tuple[Angle, ...]:
        """The unstable equilibria, vertex under centre of mass, increasing in [0, 360) degrees."""
        return tuple(sorted(valley.high.reduced() for valley in self.valleys))

    @cached_property
    def critical(self) -> tuple[Angle, ...]:
        """The stable and the unstable orientations, increasing in [0, 360) degrees."""
        return tuple(merge(self.stable, self.unstable))

    @cached_property
    def sides(self) -> tuple[tuple[Angle, Angle, int], ...]:
        """(stable, unstable, step) for both sides of each valley, step -1 downwards and 1 upwards.

        Both orientations are in [0, 360) degrees.
        """
        return tuple(
            (valley.stable, end.reduced(), step)
            for valley in self.valleys
            for end, step in ((valley.low, -1), (valley.high, 1))
        )

    def valley_of(self, theta: Angle) -> Valley:
        """Return the valley that holds an orientation, moved by full turns so that it does.

        Of an unstable equilibrium the one above it.  O(number of stable orientations).
        """
        for valley in self.valleys:
            turn = (theta - valley.low) // FULL_TURN
            lift = FULL_TURN * turn
            if theta < valley.high + lift:
                return Valley(valley.low + lift, valley.stable + lift, valley.high + lift)
        raise AssertionError("valleys cover the circle")  # pragma: no cover

    def motion(self, theta: Angle) -> Motion:
        """Return how the part turns in an orientation."""
        valley = self.valley_of(theta)
        if theta == valley.low:
            return Motion.UNSTABLE
        order = theta.compare(valley.stable)
        return (Motion.STABLE, Motion.CLOCKWISE, Motion.COUNTERCLOCKWISE)[order]

    def image(self, theta: Angle) -> ClosedArc:
        """Return G_p(theta): all orientations that the push may leave the part in.

        Examples
        --------
        >>> square = PushStability([(0, 0), (1, 0), (1, 1), (0, 1)])
        >>> arc = square.image(Angle.from_degrees(60))
        >>> arc.start.degrees(0), arc.end.degrees(0)
        ('60', '90')
        """
        valley = self.valley_of(theta)
        if theta != valley.low:
            first, last = sorted((theta, valley.stable))
            return ClosedArc(first, last - first)
        before = next(v for v in self.valleys if not (v.high - theta).reduced())
        low = before.stable + (theta - before.high)
        return ClosedArc(low, valley.stable - low)

    def weak_preimage(self, target: CellSet) -> CellSet:
        """Return the orientations that the push may bring into a set.  O(k).

        All of a valley from the first cell of the set on, counted from the stable orientation
        outwards.
        """
        angles = merge(self.critical, target.angles)
        place = {angle: k for k, angle in enumerate(angles)}
        return CellSet.unchecked(angles, *self.swept(place, *target.on(angles)))

    def swept(
        self, place: Mapping[Angle, int], points: list[bool], arcs: list[bool]
    ) -> tuple[list[bool], list[bool]]:
        """Return the cells of the weak preimage of a set given by its cells.  O(k).

        Parameters
        ----------
        place : mapping
            The number of each critical orientation of the cells, those of the diagram among them.
        points, arcs : lists of bool
            Which cells belong to the set.
        """
        sweep = _Sweep(points, arcs)
        for stable, unstable, step in self.sides:
            sweep.outwards(place[stable], place[unstable], step)
        return sweep.points, sweep.arcs

    def __repr__(self) -> str:
        return f"PushStability({self.part!r}, {self.jaw})"


class _Sweep:
    """Marks every cell from which the way to a stable orientation meets a set."""

    def __init__(self, points: list[bool], arcs: list[bool]) -> None:
        self._hit_points, self._hit_arcs = points, arcs
        self.points, self.arcs = points.copy(), arcs.copy()

    def outwards(self, stable: int, unstable: int, step: int) -> None:
        """Go from one critical orientation to another, up or down."""
        m, k = len(self.points), stable
        met = self._hit_points[k]
        while True:
            arc = k if step > 0 else k - 1  # arc k runs from orientation k to k + 1
            met |= self._hit_arcs[arc]
            self.arcs[arc] = met
            k = (k + step) % m
            met |= self._hit_points[k]
            self.points[k] |= met  # an unstable orientation is reached from both sides
            if k == unstable:
                return


def _half_turn_on(angles: tuple[Angle, ...]) -> tuple[Angle, ...]:
    return tuple(sorted((theta + HALF_TURN).reduced() for theta in angles))


def _valleys(minima: tuple[Angle, ...], maxima: tuple[Angle, ...]) -> tuple[Valley, ...]:
    """Pair alternating minima and maxima, both increasing in [0, 360) degrees."""
    highs = maxima if minima[0] < maxima[0] else (*maxima[1:], maxima[0] + FULL_TURN)
    lows = (highs[-1] - FULL_TURN, *highs[:-1])
    return tuple(map(Valley, lows, minima, highs))
