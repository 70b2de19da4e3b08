"""The diameter function: distance between the jaws, for every orientation of the part.

d(theta) is the y-extent of the part turned counter-clockwise by theta (thesis Def. 4.1, App. D).
It has period 180 degrees, equals that of the convex hull, and is piecewise sinusoidal: between
two transitions the same two vertices touch the jaws, and with v the chord from the lower to the
upper one,

    d(theta) = |v| sin(theta + arg v).

At a transition the slope jumps up, so minima (stable orientations) lie at transitions where the
one-sided slopes are strictly - and +, and maxima lie strictly inside pieces. An orientation where
one one-sided slope is zero is no extremum of either kind.

The sweep printed in the source picks the longest chord of an interval; what holds is the
antipodal pair of that interval, which is what the calipers give.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.display import Displayed
from stochgeom.errors import NumberLimitError
from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.predicates import IntArray, dot_signs, half_planes, sign
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.surds import Scalar, scalar_to_float, scalar_to_sympy
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.calipers import Calipers, rotate_calipers
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.points import Point
from stochgeom.geometry.sinusoids import squared_height

if TYPE_CHECKING:
    import sympy

Indices = NDArray[np.intp]


@final
@dataclass(frozen=True, slots=True)
class Sinusoid:
    """One piece of the diameter function: d(theta) = amplitude * sin(theta + phase).

    Attributes
    ----------
    arc : Arc
        The orientations where the piece holds, starting in [0, 180) degrees.
    chord : pair of exact numbers
        From the vertex on the lower jaw to the one on the upper jaw, in the part's frame.
    phase : Angle
        arg(chord).
    squared_amplitude : exact number
        Squared length of the chord.
    vertices : (int, int)
        Outline numbers of the two vertices, lower first.
    """

    arc: Arc
    chord: Point
    phase: Angle
    squared_amplitude: Scalar
    vertices: tuple[int, int]


@final
@dataclass(frozen=True, slots=True, eq=False)
class Extrema:
    """Strict local extrema in one period, and what makes them so.

    Attributes
    ----------
    angles : AngleVector
        The orientations, increasing: in [0, 180) degrees for the diameter, [0, 360) for the radius.
    places : int array
        Of a diameter: for a minimum its transition, for a maximum its piece (which may end beyond
        180 degrees). Of a radius: the hull edge that lies flush, the hull vertex that touches.
    """

    angles: AngleVector
    places: Indices


@final
class DiameterFunction(Displayed):
    """The diameter function of a part.  O(n log n).

    Parameters
    ----------
    part : Part, or its vertices
        Any part; only its convex hull matters.

    Examples
    --------
    >>> d = DiameterFunction([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [angle.degrees(2) for angle in d.minima], [angle.degrees(2) for angle in d.maxima]
    (['0.00', '90.00'], ['56.31', '123.69'])
    >>> d.squared(Angle(0, (3, 4)))
    mpq(324,25)
    """

    def __init__(self, part: PartLike) -> None:
        self.part = as_part(part)
        self._hull = self.part.hull

    def __repr__(self) -> str:
        return f"DiameterFunction({self.part!r})"

    @cached_property
    def calipers(self) -> Calipers:
        """Transitions and jaw contacts, numbered by hull vertex."""
        return rotate_calipers(self._hull)

    @cached_property
    def transitions(self) -> AngleVector:
        """Orientations in [0, 180) degrees where an edge lies flush on a jaw, increasing."""
        return AngleVector.from_directions(self.calipers.x, self.calipers.y)

    @cached_property
    def pieces(self) -> tuple[Sinusoid, ...]:
        """The sinusoids, piece t from transition t to transition t + 1.  O(n) objects."""
        starts = LiftedAngles(self.transitions, HALF_TURN)
        return tuple(
            Sinusoid(
                Arc(starts[t], starts[t + 1] - starts[t]),
                chord := self._chord(t),
                Angle(0, chord),
                chord[0] ** 2 + chord[1] ** 2,
                (self._outline_vertex(lower), self._outline_vertex(upper)),
            )
            for t, (lower, upper) in enumerate(
                zip(self.calipers.lower, self.calipers.upper, strict=True)
            )
        )

    def _outline_vertex(self, hull_vertex: int) -> int:
        return int(self._hull.indices[hull_vertex])

    def _chord(self, piece: int) -> Point:
        lower = self._hull.points.point(int(self.calipers.lower[piece]))
        upper = self._hull.points.point(int(self.calipers.upper[piece]))
        return upper[0] - lower[0], upper[1] - lower[1]

    @cached_property
    def _chord_arrays(self) -> tuple[IntArray, IntArray]:
        """Chords of all pieces, each up to a positive factor."""
        return self._hull.points.vectors(self.calipers.lower, self.calipers.upper)

    # --- extrema ---------------------------------------------------------------------------------

    @cached_property
    def _slopes(self) -> tuple[NDArray[np.int8], NDArray[np.int8]]:
        """Signs of the slope before and after each transition.

        The slope of a piece with chord v at theta is the x-extent of the turned chord, the real
        part of v exp(i theta).
        """
        gx, gy = self.calipers.x, self.calipers.y
        vx, vy = self._chord_arrays
        # Before transition 0 runs the last piece, its contacts exchanged: its chord is -v.
        before_x = np.concatenate((-vx[-1:], vx[:-1]))
        before_y = np.concatenate((-vy[-1:], vy[:-1]))
        return dot_signs(before_x, before_y, gx, -gy), dot_signs(vx, vy, gx, -gy)

    @cached_property
    def minima(self) -> AngleVector:
        """Stable orientations in [0, 180) degrees: the strict local minima, increasing."""
        return self.stable.angles

    @cached_property
    def maxima(self) -> AngleVector:
        """Strict local maxima in [0, 180) degrees, increasing; as many as minima."""
        return self.unstable.angles

    @cached_property
    def stable(self) -> Extrema:
        """The strict local minima with their transitions."""
        before, after = self._slopes
        (places,) = np.nonzero((before < 0) & (after > 0))
        return Extrema(self.transitions.take(places), places)

    @cached_property
    def unstable(self) -> Extrema:
        """The strict local maxima with their pieces.

        A piece that starts rising and ends falling has its maximum where its chord is upright,
        at theta = 90 degrees - arg v.
        """
        before, after = self._slopes
        # The slope at the end of the last piece: half a turn on, transition 0 is passed with
        # both the chord and the direction reversed, so the sign is that before transition 0.
        at_end = np.concatenate((before[1:], before[:1]))
        (places,) = np.nonzero((after > 0) & (at_end < 0))
        vx, vy = self._chord_arrays
        x, y = vy[places], vx[places]
        # Only the maximum of the last piece can lie beyond 180 degrees; it comes first then.
        if len(places) and half_planes(x[-1:], y[-1:])[0]:
            x = np.concatenate((-x[-1:], x[:-1]))
            y = np.concatenate((-y[-1:], y[:-1]))
            places = np.roll(places, 1)
        return Extrema(AngleVector.from_directions(x, y), places)

    # --- values ----------------------------------------------------------------------------------

    def _piece_at(self, theta: Angle) -> int:
        """Return the piece whose arc holds theta modulo 180 degrees (a transition starts one)."""
        count = self.transitions.count_at_most(theta % HALF_TURN)
        return count - 1 if count else len(self.transitions) - 1

    def squared(self, theta: Angle) -> Scalar:
        """Return d(theta)**2 exactly, for a direction theta over the part's field.  O(log n).

        Raises
        ------
        NotRationalError
            If theta is no direction over the part's field, such as 71 degrees over Q.

        Examples
        --------
        >>> DiameterFunction([(0, 0), (1, 0), (0, 1)]).squared(Angle(0, (1, 1)))
        mpq(1,2)
        """
        return squared_height(
            self._chord(self._piece_at(theta)), theta, "diameter", self.part.field
        )

    def compare(self, first: Angle, second: Angle) -> int:
        """Return the sign of d(first) - d(second), exactly, as `squared` tells them."""
        return sign(self.squared(first) - self.squared(second))

    def potential(self, theta: Angle, stiffness: RationalLike = 1) -> Scalar:
        """Return the potential k d(theta)**2 / 2 of the spring-loaded gripper.

        Thesis App. D.1; Eqs. D.2 and D.3 print the opposite sign, under which the stable
        orientations would be maxima.

        Examples
        --------
        >>> DiameterFunction([(0, 0), (3, 0), (3, 2), (0, 2)]).potential(Angle())
        mpq(2,1)
        """
        return rational(stiffness, where="stiffness") * self.squared(theta) / 2

    @cached_property
    def _float_chords(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Chords of all pieces, each component the rounded exact difference."""
        chords = [self._chord(piece) for piece in range(len(self.transitions))]
        try:
            x, y = (np.array([scalar_to_float(c[k]) for c in chords]) for k in (0, 1))
        except (OverflowError, NumberLimitError):
            raise NumberLimitError(
                "a chord is too long for a float; accepted: parts below 1e308, or Part.scale"
            ) from None
        return x, y

    def evaluate(self, theta: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Return float diameters at float radians, for plots and float comparisons."""
        rest = np.mod(np.asarray(theta, dtype=np.float64), np.pi)
        piece = np.searchsorted(self.transitions.shadow, rest, side="right") - 1
        x, y = self._float_chords
        # Before transition 0 the last piece runs with its contacts exchanged: d = -(its formula).
        flip = np.where(piece < 0, -1.0, 1.0)
        value: NDArray[np.float64] = flip * (x[piece] * np.sin(rest) + y[piece] * np.cos(rest))
        return value

    def to_sympy(self, theta: Any = None) -> sympy.Expr:
        """Return d as a sympy `Piecewise` of theta in [0, pi).

        Examples
        --------
        >>> import sympy
        >>> d = DiameterFunction([(0, 0), (3, 0), (3, 2), (0, 2)])
        >>> d.to_sympy().subs("theta", sympy.pi / 4)
        5*sqrt(2)/2
        """
        import sympy

        symbol = sympy.Symbol("theta") if theta is None else theta
        branches = []
        for t, end in enumerate((*self.transitions, HALF_TURN)):
            if not end:
                continue  # nothing lies before a transition at 0
            sense, piece = (-1, len(self.transitions) - 1) if t == 0 else (1, t - 1)
            x, y = (sense * scalar_to_sympy(value) for value in self._chord(piece))
            formula = x * sympy.sin(symbol) + y * sympy.cos(symbol)
            branches.append((formula, symbol < end.to_sympy()))
        return sympy.Piecewise(*branches)
