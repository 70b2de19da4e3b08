"""Arcs of orientations: half open for sets that a step function treats alike, closed for images.

Starts and ends are lifted angles, so an arc knows how often it passed a full turn; the questions
"contains" and "intersects" are asked on the circle.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import final

from stochgeom.arguments import as_list, expect
from stochgeom.errors import InvalidAngleError, InvalidArcError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle


@final
@dataclass(frozen=True, slots=True)
class Arc:
    """The half-open interval [start, start + width) of orientations.

    Parameters
    ----------
    start : Angle
        The first orientation, lifted.
    width : Angle
        More than 0 and at most 360 degrees.

    Examples
    --------
    >>> arc = Arc(Angle.from_degrees(350), Angle.from_degrees(20))
    >>> arc.contains(ZERO), arc.contains(Angle.from_degrees(10))
    (True, False)
    """

    start: Angle
    width: Angle

    def __post_init__(self) -> None:
        ends: tuple[object, ...] = (self.start, self.width)
        if not all(isinstance(end, Angle) for end in ends):
            raise InvalidArcError(
                f"an arc from {self.start!r:.60}, {self.width!r:.60} wide; accepted: two Angles"
            )
        if not ZERO < self.width <= FULL_TURN:
            raise InvalidArcError(f"arc width {self.width}; accepted: more than 0, at most 360°")

    @property
    def end(self) -> Angle:
        """The first orientation after the arc."""
        return self.start + self.width

    def contains(self, theta: Angle) -> bool:
        """Tell whether the orientation `theta`, taken modulo a full turn, lies in the arc."""
        return (theta - self.start).reduced() < self.width

    def intersects(self, other: Arc) -> bool:
        """Tell whether the two arcs share an orientation on the circle.

        Examples
        --------
        >>> quarter = Arc(ZERO, Angle.from_degrees(90))
        >>> quarter.intersects(quarter.rotate(Angle.from_degrees(90)))
        False
        """
        return self.contains(other.start) or other.contains(self.start)

    def rotate(self, angle: Angle) -> Arc:
        """Return the arc moved counter-clockwise by `angle`."""
        return Arc(self.start + angle, self.width)

    def split(self, period: Angle = FULL_TURN) -> tuple[Arc, ...]:
        """Return the arc on the circle of length `period` as pieces inside [0, period), in order.

        An arc at least as wide as the period covers the circle: one piece [0, period).

        Examples
        --------
        >>> arc = Arc(Angle.from_degrees(350), Angle.from_degrees(20))
        >>> [(p.start.degrees(0), p.width.degrees(0)) for p in arc.split()]
        [('0', '10'), ('350', '10')]
        """
        if self.width >= period:
            return (Arc(ZERO, period),)
        start = self.start % period
        end = start + self.width
        if end <= period:
            return (Arc(start, self.width),)
        return (Arc(ZERO, end - period), Arc(start, period - start))


@final
@dataclass(frozen=True, slots=True)
class ClosedArc:
    """The closed interval [start, start + width]: what an image of orientations spans.

    Parameters
    ----------
    start : Angle
        The first orientation, lifted.
    width : Angle
        At least 0: a single orientation has width 0.
    """

    start: Angle
    width: Angle

    def __post_init__(self) -> None:
        ends: tuple[object, ...] = (self.start, self.width)
        if not all(isinstance(end, Angle) for end in ends):
            raise InvalidArcError(
                f"an arc from {self.start!r:.60}, {self.width!r:.60} wide; accepted: two Angles"
            )
        if self.width < ZERO:
            raise InvalidArcError(f"width {self.width} of a closed arc; accepted: 0 or more")

    @property
    def end(self) -> Angle:
        """The last orientation of the arc."""
        return self.start + self.width

    def rotate(self, angle: Angle) -> ClosedArc:
        """Return the arc moved counter-clockwise by `angle`."""
        return ClosedArc(self.start + angle, self.width)


def union_arcs(arcs: Iterable[Arc], period: Angle = FULL_TURN) -> tuple[Arc, ...]:
    """Return the union on the circle of length `period` as disjoint arcs, cut at 0, in order.

    Arcs that touch are joined.  O(k log k) comparisons.
    """
    arcs = as_list(arcs, "a list of arcs", "arcs")
    for k, arc in enumerate(arcs):
        expect(arc, Arc, "an Arc", f"arc {k}")
    if not ZERO < expect(period, Angle, "an Angle", "period") <= FULL_TURN:
        raise InvalidAngleError(f"{period!r:.60}; accepted: above 0, up to 360°", where="period")
    pieces = sorted((p for arc in arcs for p in arc.split(period)), key=lambda piece: piece.start)
    joined: list[tuple[Angle, Angle]] = []
    for piece in pieces:
        if joined and piece.start <= joined[-1][1]:
            start, end = joined[-1]
            joined[-1] = (start, max(end, piece.end))
        else:
            joined.append((piece.start, piece.end))
    return tuple(Arc(start, end - start) for start, end in joined)


def union_measure(arcs: Iterable[Arc], period: Angle = FULL_TURN) -> Angle:
    """Return the exact measure of the union on the circle of length `period`.

    Examples
    --------
    >>> half = Arc(ZERO, Angle.from_degrees(180))
    >>> union_measure([half, half.rotate(Angle.from_degrees(270))]).degrees(0)
    '270'
    """
    total = ZERO
    for arc in union_arcs(arcs, period):
        total += arc.width
    return total
