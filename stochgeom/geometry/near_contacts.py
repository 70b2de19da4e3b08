"""Which vertices can touch a jaw, for all parts whose vertices lie near those of a part.

Every vertex may stand up to epsilon away from its place. Write c = 2 epsilon. At an orientation
only a vertex no more than c above the lowest one can touch the lower jaw: with p' the vertex p
moved, and q the lowest of all,

    y(p) <= y(p') + epsilon <= y(q') + epsilon <= y(q) + c.

So a vertex is a *possible contact* where its height above the jaw line is at most c. On a piece
where q touches, that height is |e| sin(theta + arg e) with e = p - q: never negative, so concave,
and it suffices to look at the ends of the pieces, where an edge is flush and the height a quotient
of rationals. The orientation where it crosses c inside a piece is rounded outwards.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any, Final, TypeAlias, final

import flint
from gmpy2 import mpq

from stochgeom.exact.balls import Ball, argument_ball, number_ball, working_precision
from stochgeom.exact.outer_arcs import BALL_BITS, TURN, Units, units_above, units_below
from stochgeom.exact.surds import Scalar
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Point

HALF: Final = TURN // 2
"""Units in half a turn."""

CENTER: Final = -1
"""In place of the number of a point: the centre of mass."""

LOWER: Final = 0
UPPER: Final = 1

Contact: TypeAlias = "tuple[int, int, int, int]"
"""Start and end in units, number of the point, jaw: where a point may touch a jaw."""

Span: TypeAlias = "tuple[Scalar, Ball, Ball]"
"""Squared length, length, and argument in turns of a vector."""


@final
class NearbyParts:
    """All parts whose vertices lie near those of a part.

    Parameters
    ----------
    part : Part
        Equal vertices count as one and move together; holes never touch a jaw.

    Attributes
    ----------
    part : Part
        The part as it should be.
    points : list of (mpq, mpq)
        Its different vertices; everything here speaks of their numbers in this list.

    Examples
    --------
    >>> near = NearbyParts(Part([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [len(jaw) for jaw in near.on_jaws((1, 0))]
    [2, 2]
    """

    def __init__(self, part: Part) -> None:
        self.part = part
        self.points: list[Point] = list(dict.fromkeys(part.vertices))
        number = {point: k for k, point in enumerate(self.points)}
        self._ring = [number[point] for point in part.hull.points.pairs()]
        self._spans: dict[tuple[int, int], Span] = {}

    # --- one orientation -------------------------------------------------------------------------

    def on_jaws(self, direction: tuple[Any, Any]) -> tuple[frozenset[int], frozenset[int]]:
        """Return the points on the lower and the upper jaw, the part turned by arg(direction)."""
        heights = self._heights(direction)
        low, high = (
            frozenset(k for k, height in enumerate(heights) if height == end)
            for end in (min(heights), max(heights))
        )
        return low, high

    def least_clearance(self, direction: tuple[Any, Any]) -> Scalar:
        """Return the square of the least positive distance of a point from a jaw's line."""
        heights = self._heights(direction)
        low, high = min(heights), max(heights)
        c, s = direction
        return min(gap for h in heights for gap in (h - low, high - h) if gap) ** 2 / (
            c * c + s * s
        )

    def _heights(self, direction: tuple[Any, Any]) -> list[Scalar]:
        """Return the points' heights times the length of the direction."""
        c, s = direction
        return [s * x + c * y for x, y in self.points]

    def span(self, i: int, j: int) -> Span:
        """Return the vector from point i to point j, to the centre of mass if j is `CENTER`.

        To be called at `BALL_BITS` of working precision.
        """
        found = self._spans.get((i, j))
        if found is None:
            ax, ay = self.points[i]
            bx, by = self.part.center_of_mass if j == CENTER else self.points[j]
            found = self._spans[i, j] = _span_of((bx - ax, by - ay))
        return found

    # --- all orientations ------------------------------------------------------------------------

    @cached_property
    def _edges(self) -> list[tuple[Point, Point, Scalar]]:
        """For each hull edge its start, its vector and its squared length."""
        edges = []
        for t, k in enumerate(self._ring):
            (ax, ay), (bx, by) = self.points[k], self.points[self._ring[t + 1 - len(self._ring)]]
            x, y = bx - ax, by - ay
            edges.append(((ax, ay), (x, y), x * x + y * y))
        return edges

    @cached_property
    def _inner(self) -> list[tuple[int, list[Scalar], Scalar]]:
        """Points that are no hull vertices: squared heights above all hull edges, the least."""
        ring = set(self._ring)
        found = []
        for k in range(len(self.points)):
            if k not in ring:
                heights = [self._squared_height(t, k) for t in range(len(self._ring))]
                found.append((k, heights, min(heights)))
        return found

    def _squared_height(self, t: int, k: int) -> Scalar:
        """Return the squared height of point k with hull edge t on the lower jaw."""
        (ax, ay), (x, y), squared = self._edges[t]
        px, py = self.points[k]
        cross = x * (py - ay) - y * (px - ax)
        return cross * cross / squared

    def _near_edges(self, limit: mpq) -> Iterator[tuple[int, set[int]]]:
        """Yield each point with the hull edges above which its squared height is within `limit`.

        Along a convex outline heights above an edge rise, then fall; so the outline is walked
        from both ends of the edge until a vertex is too high.
        """
        n = len(self._ring)
        near: dict[int, set[int]] = {k: set() for k in self._ring}
        for t in range(n):
            for place, step in ((t + 1, 1), (t, -1)):
                for distance in range(n):
                    k = self._ring[(place + step * distance) % n]
                    if self._squared_height(t, k) > limit:
                        break
                    near[k].add(t)
        yield from near.items()
        for k, heights, least in self._inner:
            if least <= limit:
                yield k, {t for t in range(n) if heights[t] <= limit}

    @cached_property
    def center_clearance(self) -> Scalar:
        """The square of the least height of the centre of mass above the jaw, in the hull."""
        px, py = self.part.center_of_mass
        return min(
            (x * (py - ay) - y * (px - ax)) ** 2 / squared
            for (ax, ay), (x, y), squared in self._edges
        )

    def contacts(self, epsilon: mpq) -> list[Contact]:
        """Return where points may touch the lower jaw, starts in [0, TURN).

        O(n + k) for k contacts at the n orientations where hull edges are flush.
        """
        found: list[Contact] = []
        n, c = len(self._ring), 2 * epsilon
        with working_precision(BALL_BITS):
            for k, edges in self._near_edges(c * c):
                if len(edges) == n:
                    found.append((0, TURN, k, LOWER))
                    continue
                # As theta grows edges become flush with falling numbers, and after edge t its
                # start, hull vertex t, touches.
                for first in edges:
                    if (first + 1) % n not in edges:
                        last = first
                        while (last - 1) % n in edges:
                            last = (last - 1) % n
                        ends = self._ring[(first + 1) % n], self._ring[last]
                        found.append(self._contact(k, *ends, c))
        return found

    def _contact(self, k: int, before: int, after: int, c: mpq) -> Contact:
        """Return where point k may touch.

        It comes down to the height c while one point touches, and leaves it while another does.
        """
        squared, length, turns = self.span(before, k)
        start = units_below(flint.arb(1) / 2 - arcsine(squared, length, c) - turns) % TURN
        squared, length, turns = self.span(after, k)
        width = (units_above(arcsine(squared, length, c) - turns) - start) % TURN
        if width <= 4:  # rounding may have closed a gap of some units: then take the whole circle
            return 0, TURN, k, LOWER
        return start, start + width, k, LOWER


def _span_of(vector: Point) -> Span:
    """Return squared length, length and argument of a vector other than zero."""
    x, y = vector
    squared = x * x + y * y
    return squared, number_ball(squared).sqrt(), argument_ball(x, y)


def arcsine(squared: Scalar, length: Ball, c: mpq) -> Ball:
    """Enclose the arc sine of c / length in turns, or return a quarter turn, which is no less."""
    quarter = flint.arb(1) / 4
    if squared <= c * c:
        return quarter
    share = (number_ball(c) / length).asin() / (2 * flint.arb.pi())
    return share if share.is_finite() else quarter


def meetings(contacts: list[Contact]) -> Iterator[tuple[Units, Contact, Contact]]:
    """Yield pairs of contacts that are possible at one orientation, and the arc where they are.

    A sweep over two turns: a pair is met where the later of the two begins, in the second turn.
    All pairs on the lower jaw; of the pairs on both jaws those met in half a turn, for half a turn
    on the jaws are exchanged.
    """
    events: list[Contact] = []
    for start, end, k, _ in contacts:
        for jaw, shift in ((LOWER, 0), (UPPER, HALF)):
            begin = (start + shift) % TURN
            events.append((begin, begin + end - start, k, jaw))
            events.append((begin + TURN, begin + TURN + end - start, k, jaw))
    events.sort()
    open_: list[Contact] = []
    for event in events:
        begin, end, k, jaw = event
        open_ = [other for other in open_ if other[1] >= begin]
        if begin >= TURN:
            for other in open_:
                crossed = jaw != other[3]
                if begin < TURN + HALF if crossed else jaw == LOWER and k != other[2]:
                    yield (begin, min(end, other[1])), other, event
        open_.append(event)
