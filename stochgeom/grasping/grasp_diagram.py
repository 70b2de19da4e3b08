"""The squeeze-grasp diagram: from an initial orientation to all final ones (thesis Fig. 3.7).

A grasp is a push by the jaw that touches first, then a squeeze: G = G_q o G_p (Eq. 3.3). Either jaw
may be the first, and the push may be of any length, from none, so that both jaws touch at once, to
one that lays an edge flush. So G maps an orientation to a *set* of final ones, stable or wedged:

- the weak preimage of a set A holds the orientations that may end in it (Eq. 3.4),
  G^-1(A) = {theta : G(theta) meets A};
- the strong preimage holds those that must (Eq. 3.5, 3.6), Pi(A) = {theta : G(theta) in A}; it is
  the complement of the weak preimage of the complement of A.

Half a turn on the jaws are exchanged, so all sets here have a period of 180 degrees; they are given
on the full circle all the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import final

from stochgeom.decision.priors import Prior
from stochgeom.display import Displayed
from stochgeom.errors import InvalidAngleError, OutcomeError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet, merge
from stochgeom.exact.decimals import Rounding
from stochgeom.exact.halves import HalfAngle
from stochgeom.exact.intervals import Interval
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.grasping.friction import Friction, FrictionLike
from stochgeom.grasping.push_stability import Jaw, PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability, StableEdge, WedgingInterval


@final
@dataclass(frozen=True, slots=True)
class GraspTolerance:
    """The largest error of the orientation that a grasp bears for sure (thesis Eq. 3.7).

    Attributes
    ----------
    interval : Interval
        A widest interval of the strong preimage of the stable orientations.
    """

    interval: Interval

    @property
    def margin(self) -> HalfAngle:
        """Half of the interval's width: the tolerance, either way."""
        return HalfAngle(self.interval.width)

    @property
    def attained(self) -> bool:
        """Whether an error of just the margin is borne too: both ends belong to the interval."""
        return self.interval.is_closed

    @property
    def orientation(self) -> HalfAngle:
        """The middle of the interval: the part relative to the gripper, in [0, 360) degrees."""
        middle = self.interval.start + self.interval.end
        return HalfAngle(middle % (FULL_TURN + FULL_TURN))

    @property
    def grasp_angle(self) -> HalfAngle:
        """The gripper relative to the part's input pose, in [0, 360) degrees, that gives it."""
        return HalfAngle((-self.orientation.doubled) % (FULL_TURN + FULL_TURN))

    def decimals(self, digits: int = 4) -> tuple[str, str]:
        """Return grasp angle and margin in degrees, so that the decimals hold as they stand.

        The margin is the one that the *printed* angle leaves, rounded down, with more digits than
        asked for where it would be 0. That of a single orientation is 0 at the angle itself.

        Examples
        --------
        >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
        >>> square.largest_tolerances()[0].decimals()
        ('0.0000', '30.9637')
        """
        width = self.interval.width
        while True:
            angle = self.grasp_angle.degrees(digits)
            if not width:
                return angle, ZERO.degrees(digits)
            from_start = (-Angle.from_degrees(angle) - self.interval.start).reduced()
            margin = min(from_start, width - from_start).degrees(digits, Rounding.DOWN)
            if from_start < width and margin.strip("0."):
                return angle, margin
            digits += 1


@final
class GraspDiagram(Displayed):
    """What a grasp makes of every initial orientation of a part.

    Parameters
    ----------
    part : Part, or its vertices
        Only its hull and its centre of mass matter.
    mu : rational, Angle or Friction
        The coefficient of friction, 0 or more, or the friction angle.

    Attributes
    ----------
    lower, upper : PushStability
        The push-stability diagrams of the two jaws.
    squeeze : SqueezeStability
        The squeeze-stability diagram.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.
    FrictionError, NumberError
        If mu is negative or no exact number.

    Notes
    -----
    O(n log n) to make, O(n) for each preimage, with about 6 n critical orientations.

    Examples
    --------
    >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
    >>> print(square.strong_preimage(ZERO))
    {[329.0363°, 390.9637°]}
    """

    def __init__(self, part: PartLike, mu: FrictionLike) -> None:
        self.friction = Friction.of(mu)
        self.part = as_part(part)
        radius = RadiusFunction(self.part)
        self.lower = PushStability(radius, Jaw.LOWER)
        self.upper = PushStability(radius, Jaw.UPPER)
        self.squeeze = SqueezeStability(self.part, self.friction)

    @property
    def jaws(self) -> tuple[PushStability, PushStability]:
        """The push-stability diagrams of the lower and the upper jaw."""
        return self.lower, self.upper

    # --- final orientations ----------------------------------------------------------------------

    @property
    def stable(self) -> tuple[StableEdge, ...]:
        """The stable orientations, increasing in [0, 360) degrees."""
        return self.squeeze.stable

    @property
    def wedging(self) -> tuple[WedgingInterval, ...]:
        """The wedging intervals."""
        return self.squeeze.wedging

    @property
    def stable_set(self) -> CellSet:
        """Theta_s: the stable orientations as a set."""
        return self.squeeze.stable_set

    @property
    def wedged_set(self) -> CellSet:
        """Theta_w: the wedged orientations."""
        return self.squeeze.wedged

    # --- the map and its preimages ---------------------------------------------------------------

    def image(self, theta: Angle) -> CellSet:
        """Return G(theta): all orientations that a grasp of the part at theta may end in.

        Examples
        --------
        >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
        >>> print(square.image(Angle.from_degrees(20)), square.image(Angle.from_degrees(40)))
        {[0.0000°, 0.0000°]} {[0.0000°, 0.0000°], (30.9638°, 40.0000°]}
        """
        arcs = (push.image(theta) for push in self.jaws)
        pushed = CellSet.of(Interval(arc.start, arc.width, True, True) for arc in arcs)
        return self.squeeze.image(pushed)

    def weak_preimage(self, target: Angle | CellSet) -> CellSet:
        """Return the orientations that may end in one final orientation, or in a set (Eq. 3.4).

        Parameters
        ----------
        target : Angle or CellSet
            A stable or wedged orientation, or any set, such as `stable_set` and `wedged_set`.

        Raises
        ------
        OutcomeError
            If no grasp ends in the orientation.
        """
        return self._pushed_into(self.squeeze.weak_preimage(self._final(target)))

    def strong_preimage(self, target: Angle | CellSet) -> CellSet:
        """Return the orientations that must end in one final orientation, or in a set.

        Thesis Eq. 3.5 and 3.6. Parameters and errors as of `weak_preimage`.
        """
        return ~self._pushed_into(self.squeeze.weak_preimage(~self._final(target)))

    def _pushed_into(self, target: CellSet) -> CellSet:
        angles = merge(self._critical, target.angles)
        place = {angle: k for k, angle in enumerate(angles)}
        cells = target.on(angles)
        lower, upper = (push.swept(place, *cells) for push in self.jaws)
        points, arcs = (
            [a or b for a, b in zip(one, other, strict=True)]
            for one, other in zip(lower, upper, strict=True)
        )
        return CellSet.unchecked(angles, points, arcs)

    @cached_property
    def _critical(self) -> list[Angle]:
        """The critical orientations of all three diagrams, increasing."""
        pushes = merge(self.lower.critical, self.upper.critical)
        return merge(pushes, self.squeeze.angles)

    def _final(self, target: Angle | CellSet) -> CellSet:
        if isinstance(target, CellSet):
            return target
        if not isinstance(target, Angle):
            raise InvalidAngleError(f"{target!r:.60}; accepted: an Angle or a CellSet")
        if target not in self.wedged_set and target not in self.stable_set:
            known = ", ".join(str(edge.orientation) for edge in self.stable[:8])
            more = ", ..." if len(self.stable) > 8 else ""
            raise OutcomeError(
                f"no grasp ends at {target}; accepted: the stable orientations {known}{more}, "
                "or a wedged one"
            )
        return CellSet.at([target])

    # --- guarantees ------------------------------------------------------------------------------

    @cached_property
    def guaranteed(self) -> CellSet:
        """The strong preimage of the stable orientations, Pi(Theta_s).

        That is the complement of the weak preimage of the wedged ones.
        """
        return ~self._pushed_into(self.wedged_set)

    @cached_property
    def guaranteed_if_strict(self) -> CellSet:
        """The same if a part that turns into the end of a wedging interval counts as wedged."""
        return ~self._pushed_into(self.squeeze.wedged_if_strict)

    def largest_tolerances(self) -> tuple[GraspTolerance, ...]:
        """Return the grasps that bear the largest error of the orientation, all that tie.

        Half of the widest interval of `guaranteed` (Eq. 3.7); none if no orientation is guaranteed.

        Examples
        --------
        >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
        >>> best = square.largest_tolerances()[0]
        >>> best.margin.degrees(), best.grasp_angle.degrees(0), best.attained
        ('30.9638', '0', True)
        """
        if self.guaranteed.is_whole:  # any grasp does: gripper and part in line
            return (GraspTolerance(Interval(-HALF_TURN, FULL_TURN, True, True)),)
        found = [GraspTolerance(item) for item in self.guaranteed.widest()]
        return tuple(sorted(found, key=lambda item: item.grasp_angle))

    def grasps_bearing(self, tolerance: Angle) -> CellSet:
        """Return the orientations that end stable whatever error of at most `tolerance` they have.

        The gripper relative to the part's input pose is minus one of them.
        """
        if tolerance < ZERO:
            raise InvalidAngleError(f"tolerance {tolerance}; accepted: 0 or more")
        if tolerance >= HALF_TURN:  # an error of half a turn either way is any orientation
            return self.guaranteed if self.guaranteed.is_whole else CellSet.empty()
        return self.guaranteed.shrunk(tolerance)

    @cached_property
    def bound(self) -> AngleSum:
        """Lower bound on the probability that a random grasp ends stable (Eq. 3.13).

        Examples
        --------
        >>> GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25").bound.decimal()
        '0.6881'
        """
        return self.guaranteed.measure

    @cached_property
    def strict_bound(self) -> AngleSum:
        """The bound if a part that turns into the end of a wedging interval counts as wedged."""
        return self.guaranteed_if_strict.measure

    def bound_under(self, prior: Prior) -> Probability:
        """Return the lower bound under a prior of the initial orientation (Eq. 3.8).

        Examples
        --------
        >>> from stochgeom.decision.discrete_prior import DiscretePrior
        >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
        >>> square.bound_under(DiscretePrior({"10": "1/3", "45": "2/3"})).rational
        mpq(1,3)
        """
        return prior.mass_of(self.guaranteed)

    def __repr__(self) -> str:
        return f"GraspDiagram({self.part!r}, {self.friction.angle!r})"
