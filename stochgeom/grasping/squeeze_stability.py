"""The squeeze-stability diagram: what two closing jaws do with friction (thesis Fig. 3.6, Eq. 3.2).

With rho as in `stochgeom.grasping.contacts` and alpha the friction angle:

- between two vertices the part is *wedged* iff |rho| < alpha. Friction is exceeded at equality, so
  that nothing wedges without friction;
- an edge that lies flush *holds* iff some pair of points in contact is within the friction cone,
  or the edge is stable by itself: rho < alpha just before and rho > -alpha just after. Without
  friction these are the strict minima of the diameter; with it there are others, which only
  friction holds. All of them are stable orientations: an edge is aligned with a jaw;
- elsewhere the part turns, clockwise where rho > 0, until an edge that holds lies flush.

So the orientation at which the second jaw touches decides alone. A part that turns comes to the end
of a wedging interval only where an edge that friction holds lies flush, and stops there, stable.
`SqueezeStability.wedged_if_strict` is the set where it is counted as wedged instead.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final, TypeAlias, final

from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.display import Displayed
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.cells import CellSet, merge
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.grasping.contacts import Contacts, Pair, contacts_of
from stochgeom.grasping.friction import Friction, FrictionLike
from stochgeom.grasping.push_stability import Motion

WEDGED: Final = -1

Outcomes: TypeAlias = "tuple[int, ...]"
"""Where a squeeze may end: transitions, or `WEDGED`. Two at an unstable equilibrium, else one."""


@final
@dataclass(frozen=True, slots=True)
class WedgingInterval:
    """The orientations in which one pair of vertices is wedged: an open interval.

    Attributes
    ----------
    start, width : Angle
        Its start, in [0, 360) degrees, and its positive width; neither end belongs to it.
    vertices : (int, int)
        The outline's vertices on the lower and on the upper jaw.
    normal : Angle
        The orientation in which their chord is normal to the jaws: the middle, unless clipped.
    """

    start: Angle
    width: Angle
    vertices: Pair
    normal: Angle

    @property
    def arc(self) -> Arc:
        """The interval as a half-open arc, for output."""
        return Arc(self.start, self.width)


@final
@dataclass(frozen=True, slots=True)
class StableEdge:
    """An orientation in which a squeezed part rests with an edge flush.

    Attributes
    ----------
    orientation : Angle
        In [0, 360) degrees.
    lower_edge, upper_edge : (int, int) or None
        The ends of the hull's edge on that jaw, by their numbers in the outline; parallel edges
        lie flush together.
    by_friction : bool
        Whether only friction holds it: the diameter has no strict minimum there.
    """

    orientation: Angle
    lower_edge: Pair | None
    upper_edge: Pair | None
    by_friction: bool


@final
class SqueezeStability(Displayed):
    """The squeeze-stability diagram of a part.  O(n log n).

    Parameters
    ----------
    part : Part, its diameter function, or its vertices
        Only the hull matters.
    mu : rational, Angle or Friction
        The coefficient of friction, 0 or more, or the friction angle.

    Examples
    --------
    >>> square = SqueezeStability([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
    >>> [edge.orientation.degrees(0) for edge in square.stable]
    ['0', '90', '180', '270']
    >>> wedge = square.wedging[0]
    >>> wedge.normal.degrees(0), wedge.width == 2 * Angle(0, (4, 1)), wedge.vertices
    ('45', True, (0, 2))
    """

    angles: tuple[Angle, ...]
    _points: tuple[Outcomes, ...]
    _arcs: tuple[Outcomes, ...]

    def __init__(
        self,
        part: Part | DiameterFunction | Iterable[PointLike] | NDArray[Any],
        mu: FrictionLike,
        *,
        contacts: Contacts | None = None,
    ) -> None:
        self.friction = Friction.of(mu)
        diameter = part if isinstance(part, DiameterFunction) else DiameterFunction(as_part(part))
        self.part = diameter.part
        if contacts is not None:
            expect(contacts, Contacts, "the contacts of another one, for the same part", "contacts")
        self.contacts = contacts_of(diameter) if contacts is None else contacts
        alpha = self.friction.angle
        found, least = self.contacts, -alpha
        self._holds = tuple(
            a < alpha and b > least for a, b in zip(found.before, found.after, strict=True)
        )
        self._build()

    def _build(self) -> None:
        """List critical orientations and the outcomes of the cells that they make."""
        after_left, after_right = self._targets()
        angles: list[Angle] = []
        points: list[Outcomes] = []
        arcs: list[Outcomes] = []
        for p in range(len(self.contacts)):
            left, right = (after_left[p],), (after_right[p],)
            for angle, point, arc in self._cells_of(p, left, right):
                angles.append(angle)
                points.append(point)
                arcs.append(arc)
        beyond = sum(angle >= FULL_TURN for angle in angles)  # of the last piece: to the front
        order = [*range(len(angles) - beyond, len(angles)), *range(len(angles) - beyond)]
        self.angles = tuple(
            angles[k].reduced() if n < beyond else angles[k] for n, k in enumerate(order)
        )
        self._points = tuple(points[k] for k in order)
        self._arcs = tuple(arcs[k] for k in order)

    def _targets(self) -> tuple[list[int], list[int]]:
        """Return for each piece where a part stops that turns clockwise, or the other way."""
        m, holds = len(self.contacts), self._holds
        first = holds.index(True)  # a strict minimum of the diameter always holds
        left, right = [0] * m, [0] * m
        for k in range(first, first + m):
            p = k % m
            left[p] = p if holds[p] else left[p - 1]
        for k in range(first - 1, first - 1 - m, -1):
            after = (k + 1) % m
            right[k % m] = after if holds[after] else right[after]
        return left, right

    def _cells_of(
        self, p: int, left: Outcomes, right: Outcomes
    ) -> Iterator[tuple[Angle, Outcomes, Outcomes]]:
        """Yield the critical orientations of a piece, the outcomes there and of the arc after."""
        contacts, alpha = self.contacts, self.friction.angle
        m = len(contacts)
        start, after = contacts.starts[p], contacts.after[p]
        at_end = contacts.before[(p + 1) % m]
        if self._holds[p]:
            here: Outcomes = (p,)
        else:  # rho has one sign and is outside the friction cone on both sides
            here = left if after > ZERO else right
        # rho falls from `after` to `at_end`: clockwise, then wedged, then counter-clockwise.
        is_wedged = after > -alpha and at_end < alpha and bool(alpha)
        turns_left, turns_right = after > alpha, at_end < -alpha
        first = left if turns_left else (WEDGED,) if is_wedged else right
        yield start, here, first
        if turns_left and at_end < alpha:
            normal = contacts.normals[p]
            if not alpha:
                yield normal, tuple(dict.fromkeys((*left, *right))), right
                return
            yield normal - alpha, left, (WEDGED,)
        if turns_right and is_wedged:
            yield contacts.normals[p] + alpha, right, right

    # --- the diagram -----------------------------------------------------------------------------

    @cached_property
    def stable(self) -> tuple[StableEdge, ...]:
        """The stable orientations, increasing in [0, 360) degrees."""
        found = self.contacts
        return tuple(
            StableEdge(
                found.starts[p], found.lower_edges[p], found.upper_edges[p], self._by_friction(p)
            )
            for p in range(len(found))
            if self._holds[p]
        )

    def _by_friction(self, p: int) -> bool:
        return not self.contacts.before[p] < ZERO < self.contacts.after[p]

    @cached_property
    def stable_set(self) -> CellSet:
        """The stable orientations as a set, Theta_s."""
        return CellSet.at(edge.orientation for edge in self.stable)

    @cached_property
    def wedging(self) -> tuple[WedgingInterval, ...]:
        """The wedging intervals by increasing piece, each clipped to the piece of its pair."""
        found, alpha = self.contacts, self.friction.angle
        intervals = []
        for p in range(len(found) if alpha else 0):
            after, at_end = found.after[p], found.before[(p + 1) % len(found)]
            if not (after > -alpha and at_end < alpha):
                continue
            normal = found.normals[p]
            start = normal - alpha if after > alpha else found.starts[p]
            end = normal + alpha if at_end < -alpha else found.start(p + 1)
            lift = start - start.reduced()
            intervals.append(
                WedgingInterval(start - lift, end - start, found.pairs[p], normal - lift)
            )
        return tuple(intervals)

    @cached_property
    def wedged(self) -> CellSet:
        """The wedged orientations, Theta_w: a union of open intervals."""
        return self._where(lambda outcomes, _: WEDGED in outcomes)

    @cached_property
    def wedged_if_strict(self) -> CellSet:
        """Those, and the ones from which the part turns into the end of a wedging interval."""
        return self._where(
            lambda outcomes, here: any(
                k == WEDGED or (self._by_friction(k) and self.contacts.starts[k] != here)
                for k in outcomes
            )
        )

    def _where(self, holds: Callable[[Outcomes, Angle | None], bool]) -> CellSet:
        points = [holds(o, angle) for angle, o in zip(self.angles, self._points, strict=True)]
        arcs = [holds(outcomes, None) for outcomes in self._arcs]
        return CellSet.unchecked(self.angles, points, arcs)

    # --- questions about one orientation ---------------------------------------------------------

    def outcomes(self, theta: Angle) -> tuple[Angle | None, ...]:
        """Return the stable orientation that a squeeze from theta ends in, or None if wedged.

        Two where theta is an unstable equilibrium, which only a frictionless gripper has.

        Examples
        --------
        >>> square = SqueezeStability([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
        >>> square.outcomes(Angle.from_degrees(45)), square.outcomes(Angle.from_degrees(60))
        ((None,), (Angle(0, (0, 1)),))
        """
        found = self.outcomes_at(theta.reduced())
        return tuple(None if k == WEDGED else self.contacts.starts[k] for k in found)

    def outcomes_at(self, theta: Angle) -> Outcomes:
        """Return the outcomes of an orientation in [0, 360) degrees, by numbers."""
        k = bisect_right(self.angles, theta) - 1
        return self._points[k] if k >= 0 and self.angles[k] == theta else self._arcs[k]

    def motion(self, theta: Angle) -> Motion:
        """Return how a part turns that both jaws touch in an orientation."""
        place = theta.reduced()
        found = self.outcomes_at(place)
        if len(found) == 2:
            return Motion.UNSTABLE
        if found == (WEDGED,):
            return Motion.WEDGED
        target = self.contacts.starts[found[0]]
        if target == place:
            return Motion.STABLE
        # The way to the target is less than half a turn.
        ahead = (target - place).reduced()
        return Motion.COUNTERCLOCKWISE if ahead < FULL_TURN - ahead else Motion.CLOCKWISE

    def outcome_numbers(self, angles: Sequence[Angle]) -> list[Outcomes]:
        """Return the outcomes of the arcs after finer critical orientations, by numbers.  O(k).

        Parameters
        ----------
        angles : sequence of Angle
            Increasing in [0, 360) degrees, `angles` of the diagram among them.
        """
        found, k = [], -1  # before the first critical orientation runs the last arc
        for angle in angles:
            if k + 1 < len(self.angles) and self.angles[k + 1] == angle:
                k += 1
            found.append(self._arcs[k])
        return found

    # --- images and preimages --------------------------------------------------------------------

    def image(self, orientations: CellSet) -> CellSet:
        """Return all final orientations that a squeeze from a set may end in.  O(k)."""
        angles = merge(self.angles, orientations.angles)
        reached: set[int] = set()
        found = zip(angles, *orientations.on(angles), self.outcome_numbers(angles), strict=True)
        for angle, point, arc, after in found:
            reached.update(self.outcomes_at(angle) if point else (), after if arc else ())
        reached.discard(WEDGED)
        resting = CellSet.at(self.contacts.starts[p] for p in reached)
        return resting | (self.wedged & orientations)

    def weak_preimage(self, target: CellSet) -> CellSet:
        """Return the orientations that a squeeze may bring into a set of final ones.  O(k)."""
        kept = {p for p, holds in enumerate(self._holds) if holds}
        kept = {p for p in kept if self.contacts.starts[p] in target}
        resting = self._where(lambda outcomes, _: any(k in kept for k in outcomes))
        return resting | (self.wedged & target)

    def strong_preimage(self, target: CellSet) -> CellSet:
        """Return the orientations that a squeeze must bring into a set of final ones.  O(k)."""
        return ~self.weak_preimage(~target)

    def __repr__(self) -> str:
        return f"SqueezeStability({self.part!r}, {self.friction.angle!r})"
