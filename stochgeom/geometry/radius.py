"""The radius function: distance from the centre of mass to the pushing jaw, for every orientation.

r(theta) is the height of the centre of mass above the lower jaw when the part, turned
counter-clockwise by theta, touches it (thesis App. E.1.1, after Mason). It equals that of the
convex hull, has no period below 360 degrees in general, and is piecewise sinusoidal: between two
transitions the same vertex touches, and with v the chord from it to the centre of mass,

    r(theta) = |v| sin(theta + arg v).

At a transition an edge lies flush and the slope jumps up. So minima (orientations that are stable
under a push) lie at transitions where the one-sided slopes are strictly - and +: the foot of the
centre of mass is strictly inside the edge. Maxima lie strictly inside pieces, where the centre of
mass is straight above the vertex. An orientation where one one-sided slope is zero, the centre of
mass over the end of an edge, is no extremum of either kind.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.display import Displayed
from stochgeom.errors import NumberLimitError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.predicates import half_planes, sign
from stochgeom.exact.surds import Scalar, scalar_to_float, scalar_to_sympy
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.diameter import Extrema
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.points import Point
from stochgeom.geometry.sight import look_around
from stochgeom.geometry.sinusoids import squared_height

if TYPE_CHECKING:
    import sympy

Indices = NDArray[np.intp]


@final
@dataclass(frozen=True, slots=True)
class RadiusPiece:
    """One piece of the radius function: r(theta) = amplitude * sin(theta + phase).

    Attributes
    ----------
    arc : Arc
        The orientations where the piece holds, starting in [0, 360) degrees.
    chord : pair of exact numbers
        From the vertex on the lower jaw to the centre of mass, in the part's frame.
    phase : Angle
        arg(chord).
    squared_amplitude : exact number
        Squared length of the chord.
    vertex : int
        Outline number of the vertex.
    """

    arc: Arc
    chord: Point
    phase: Angle
    squared_amplitude: Scalar
    vertex: int


@final
class RadiusFunction(Displayed):
    """The radius function of a part about its centre of mass.  O(n) after the hull.

    Parameters
    ----------
    part : Part, or its vertices
        Any part; only its convex hull and its centre of mass matter.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull: its height above the jaw
        would not be positive in every orientation.

    Examples
    --------
    >>> r = RadiusFunction([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [angle.degrees(2) for angle in r.minima]
    ['0.00', '90.00', '180.00', '270.00']
    >>> r.squared(r.minima[0]), r.squared(r.maxima[0])
    (mpq(1,1), mpq(13,4))
    """

    def __init__(self, part: PartLike) -> None:
        self.part = as_part(part)
        self._hull = self.part.hull
        self._sight = look_around(self.part)

    def __repr__(self) -> str:
        return f"RadiusFunction({self.part!r})"

    # --- transitions and pieces ------------------------------------------------------------------

    @cached_property
    def flush(self) -> Indices:
        """For each transition the hull edge that lies flush on the lower jaw.

        Hull edge k runs from hull vertex k to k + 1. After the transition its start, the hull
        vertex of the same number, is the contact.
        """
        n = len(self._hull)
        # Edge e is level after a turn by -arg(e). Going clockwise these angles grow and pass the
        # positive x axis once: start there, with the last edge in the first half turn.
        lower = half_planes(self._sight.edge_x, -self._sight.edge_y)
        (last,) = np.nonzero(~lower & lower[np.arange(n) - n + 1])
        return np.arange(int(last[0]), int(last[0]) - n, -1) % n

    @cached_property
    def transitions(self) -> AngleVector:
        """Orientations in [0, 360) degrees where an edge lies flush on the jaw, increasing."""
        return self._levels(self.flush)

    def _levels(self, edges: Indices) -> AngleVector:
        """Return the orientations in which hull edges lie flush."""
        return AngleVector.from_directions(self._sight.edge_x[edges], -self._sight.edge_y[edges])

    @cached_property
    def pieces(self) -> tuple[RadiusPiece, ...]:
        """The sinusoids, piece t from transition t to transition t + 1.  O(n) objects."""
        starts = LiftedAngles(self.transitions, FULL_TURN)
        return tuple(
            RadiusPiece(
                Arc(starts[t], starts[t + 1] - starts[t]),
                chord := self._chord(t),
                Angle(0, chord),
                chord[0] ** 2 + chord[1] ** 2,
                int(self._hull.indices[vertex]),
            )
            for t, vertex in enumerate(self.flush)
        )

    def _chord(self, piece: int) -> Point:
        x, y = self._hull.points.point(int(self.flush[piece]))
        center = self.part.center_of_mass
        return center[0] - x, center[1] - y

    # --- extrema ---------------------------------------------------------------------------------

    @property
    def minima(self) -> AngleVector:
        """Orientations stable under a push: the strict local minima in [0, 360), increasing."""
        return self.stable.angles

    @property
    def maxima(self) -> AngleVector:
        """Strict local maxima in [0, 360) degrees, increasing; as many as minima."""
        return self.unstable.angles

    @cached_property
    def stable(self) -> Extrema:
        """The strict local minima; their places are the hull edges that lie flush on the jaw."""
        falls_then_rises = (self._sight.before < 0) & (self._sight.after > 0)
        edges = self.flush[falls_then_rises[self.flush]]
        return Extrema(self._levels(edges), edges)

    @cached_property
    def unstable(self) -> Extrema:
        """The strict local maxima; their places are the hull vertices below the centre of mass."""
        # The piece of vertex k begins where edge k is flush and ends where edge k - 1 is.
        at_end = self._sight.before[np.arange(len(self._hull)) - 1]
        rises_then_falls = (self._sight.after > 0) & (at_end < 0)
        vertices = self.flush[rises_then_falls[self.flush]]
        angles = self._sight.upright.take(vertices)
        # Only the maximum of the last piece can lie beyond 360 degrees; it comes first then.
        if angles[len(angles) - 1] < self._levels(vertices[-1:])[0]:
            vertices = np.concatenate((vertices[-1:], vertices[:-1]))
            angles = self._sight.upright.take(vertices)
        return Extrema(angles, vertices)

    # --- values ----------------------------------------------------------------------------------

    def squared(self, theta: Angle) -> Scalar:
        """Return r(theta)**2 exactly, for a direction theta over the part's field.  O(log n).

        Raises
        ------
        NotRationalError
            If theta is no direction over the part's field, such as 71 degrees over Q.

        Examples
        --------
        >>> RadiusFunction([(0, 0), (4, 0), (0, 4)]).squared(Angle(0, (1, 1)))
        mpq(32,9)
        """
        # Before transition 0 runs the last piece, which is piece -1.
        piece = self.transitions.count_at_most(theta.reduced()) - 1
        return squared_height(self._chord(piece), theta, "radius", self.part.field)

    def compare(self, first: Angle, second: Angle) -> int:
        """Return the sign of r(first) - r(second), exactly, as `squared` tells them."""
        return sign(self.squared(first) - self.squared(second))

    @cached_property
    def _float_chords(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Chords of all pieces, each component the rounded exact difference."""
        chords = [self._chord(piece) for piece in range(len(self.flush))]
        try:
            x, y = (np.array([scalar_to_float(c[k]) for c in chords]) for k in (0, 1))
        except (OverflowError, NumberLimitError):
            raise NumberLimitError(
                "a chord is too long for a float; accepted: parts below 1e308, or Part.scale"
            ) from None
        return x, y

    def evaluate(self, theta: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Return float radii at float radians, for plots and float comparisons."""
        rest = np.mod(np.asarray(theta, dtype=np.float64), 2 * np.pi)
        piece = np.searchsorted(self.transitions.shadow, rest, side="right") - 1
        x, y = self._float_chords
        value: NDArray[np.float64] = x[piece] * np.sin(rest) + y[piece] * np.cos(rest)
        return value

    def to_sympy(self, theta: Any = None) -> sympy.Expr:
        """Return r as a sympy `Piecewise` of theta in [0, 2 pi).

        Examples
        --------
        >>> import sympy
        >>> r = RadiusFunction([(0, 0), (3, 0), (3, 2), (0, 2)])
        >>> r.to_sympy().subs("theta", sympy.pi / 4)
        5*sqrt(2)/4
        """
        import sympy

        symbol = sympy.Symbol("theta") if theta is None else theta
        branches = []
        for t, end in enumerate((*self.transitions, FULL_TURN)):
            if not end:
                continue  # nothing lies before a transition at 0
            x, y = (scalar_to_sympy(value) for value in self._chord(t - 1))
            branches.append(
                (x * sympy.sin(symbol) + y * sympy.cos(symbol), symbol < end.to_sympy())
            )
        return sympy.Piecewise(*branches)
