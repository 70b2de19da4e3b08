"""Whether outlines are simple polygons: no two edges meet, but consecutive ones at their vertex.

`find_conflict` is the sweep of Shamos and Hoey: vertices are visited in lexicographic order, and
the edges that the sweep line meets are kept in their order from bottom to top
(`stochgeom.geometry.sweep_order` explains how the line is tilted). With n vertices it takes
O(n log n) comparisons of points, O(n log n) expected tests of a point against a line, and O(n)
memory. Which conflict it names is fixed by the input alone.

Why no conflict is missed, without assuming general position:

    Equal vertices are adjacent once sorted, and reported first. So now all vertices differ. Let
    q be the lexicographically first point of any conflict. Up to q the order is right, and the
    edges of the order that pass through q are consecutive in it.

    (1) Two edges of the order conflict at q. Then two *neighbours* do; they became neighbours
        at an event before q, and every pair was tested when it became one. One test settles a
        pair: the upper edge is above the lower one now, so they meet later iff the end that
        comes first is on or beyond the other edge.
    (2) Otherwise q is a vertex from which both edges go right, and that lies on one edge of the
        order, or whose edges fold onto each other. Searching the place of q meets the one, and
        comparing the two new edges meets the other.

    An edge that ends at q, and a new one that goes on from there, are covered by (1): the new
    edge takes the old one's place.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, final

from stochgeom.errors import InvalidPartError, TooFewVerticesError
from stochgeom.geometry.segments import ConflictKind, Segment, pair_conflict
from stochgeom.geometry.sweep_order import Place, SweepOrder

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from gmpy2 import mpz

    from stochgeom.exact.predicates import HomogeneousPoint


@final
@dataclass(frozen=True, slots=True)
class Conflict:
    """Two edges that meet where they should not, and how.

    An edge is (ring, index), counted from 0; edge i runs from vertex i to vertex i + 1.
    """

    kind: ConflictKind
    first: tuple[int, int]
    second: tuple[int, int]


def find_conflict(rings: Sequence[Sequence[HomogeneousPoint]]) -> Conflict | None:
    """Return two edges that keep the rings from being simple and apart, or None.  O(n log n).

    Nothing is said about how the rings lie inside one another:
    `stochgeom.geometry.segments.contains` tells that.

    Parameters
    ----------
    rings : sequence of sequence of point
        Cyclic lists of three or more points (X, Y, W) of `int` or `mpz` with W > 0, no two
        consecutive ones equal. Straight angles are fine.

    Raises
    ------
    TooFewVerticesError
        A ring has fewer than three points.
    InvalidPartError
        Two consecutive points of a ring are equal (not looked for once a conflict is found).

    Examples
    --------
    >>> square = [(0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]
    >>> find_conflict([square])
    >>> bow_tie = [square[i] for i in (0, 2, 1, 3)]
    >>> find_conflict([bow_tie])
    Conflict(kind=<ConflictKind.CROSSING: 'crossing'>, first=(0, 0), second=(0, 2))
    """
    for number, ring in enumerate(rings):
        if len(ring) < 3:
            raise TooFewVerticesError(
                f"{len(ring)} vertices; accepted: 3 or more", where=f"ring {number}"
            )
    return _Sweep(rings).run()


class _Sweep:
    """One run over all vertices. Vertices, and the edges that start at them, are numbered on."""

    def __init__(self, rings: Sequence[Sequence[HomogeneousPoint]]) -> None:
        self.points: list[HomogeneousPoint] = []
        self.next: list[int] = []
        self.previous: list[int] = []
        self.offsets: list[int] = []
        for ring in rings:
            low = len(self.points)
            high = low + len(ring)
            self.offsets.append(low)
            self.points += ring
            self.next += [*range(low + 1, high), low]
            self.previous += [high - 1, *range(low, high - 1)]
        self.event: list[int] = []  # when each vertex is visited
        self.status = SweepOrder()
        self.places: dict[int, Place] = {}  # by edge

    def run(self) -> Conflict | None:
        keys = _lexicographic_keys(self.points)
        order = sorted(range(len(keys)), key=keys.__getitem__)
        for one, other in pairwise(order):
            if keys[one] == keys[other]:
                return self._equal_vertices(*sorted((one, other)))
        self.event = [0] * len(order)
        for time, vertex in enumerate(order):
            self.event[vertex] = time
        for vertex in order:
            pairs = self._visit(vertex)
            if pairs:
                return self._conflict(pairs)
        return None

    def _visit(self, vertex: int) -> list[tuple[int, int]]:
        """Move the sweep line over a vertex; return pairs of edges found to conflict."""
        event, now = self.event, self.event[vertex]
        arriving, leaving = self.previous[vertex], vertex
        arrives_from_left = event[arriving] < now
        leaves_to_left = event[self.next[vertex]] < now
        if arrives_from_left and leaves_to_left:
            return self._end(arriving, leaving)
        if arrives_from_left:
            return self._pass(arriving, leaving, vertex, self.next[vertex])
        if leaves_to_left:
            return self._pass(leaving, arriving, vertex, arriving)
        return self._start(vertex)

    def _pass(self, old: int, new: int, left: int, right: int) -> list[tuple[int, int]]:
        """Go on from the right end of one edge with the next, in the same place."""
        place = self.places[new] = self.places.pop(old)
        place.hold(new, self.points[left], self.points[right], self.event[right])
        return _meeting(place.below, place) or _meeting(place, place.above)

    def _end(self, one: int, other: int) -> list[tuple[int, int]]:
        """Take out two neighbours whose common right end is reached."""
        lower, upper = self.places.pop(one), self.places.pop(other)
        if lower.above is not upper:
            lower, upper = upper, lower
        below, above = lower.below, upper.above
        self.status.remove(lower)
        self.status.remove(upper)
        return _meeting(below, above)

    def _start(self, vertex: int) -> list[tuple[int, int]]:
        """Put in the two edges that begin at a vertex and go right."""
        arriving, point = self.previous[vertex], self.points[vertex]
        below, above, hit = self.status.locate(point)
        if hit is not None:
            return [(hit.edge, arriving), (hit.edge, vertex)]
        lower = self._place(arriving, point, arriving)
        upper = self._place(vertex, point, self.next[vertex])
        side = lower.side(upper.right)
        if side == 0:
            return [(arriving, vertex)]
        if side < 0:
            lower, upper = upper, lower
        self.status.insert(lower, below, above)
        self.status.insert(upper, lower, above)
        return _meeting(below, lower) or _meeting(upper, above)

    def _place(self, edge: int, left: HomogeneousPoint, right: int) -> Place:
        place = self.places[edge] = Place(edge, left, self.points[right], self.event[right])
        return place

    def _equal_vertices(self, one: int, other: int) -> Conflict:
        if other in (self.next[one], self.previous[one]):
            ring, index = self._name(other)
            raise InvalidPartError(
                "equal to a neighbouring vertex; accepted: rings without repeated consecutive "
                "vertices",
                where=f"ring {ring}, vertex {index}",
            )
        edges, others = (self.previous[one], one), (self.previous[other], other)
        return self._conflict((first, second) for first in edges for second in others)

    def _conflict(self, pairs: Iterable[tuple[int, int]]) -> Conflict:
        """Name one of the pairs, all of which conflict: one that overlaps if there is one."""
        found: dict[ConflictKind, tuple[int, int]] = {}
        for pair in pairs:
            first, second = min(pair), max(pair)
            # Consecutive edges conflict only by overlapping, which needs no special care.
            kind = pair_conflict(self._segment(first), self._segment(second))
            if kind is not None:
                found.setdefault(kind, (first, second))
        kind = ConflictKind.OVERLAPPING if ConflictKind.OVERLAPPING in found else next(iter(found))
        first, second = found[kind]
        return Conflict(kind, self._name(first), self._name(second))

    def _segment(self, edge: int) -> Segment:
        return self.points[edge], self.points[self.next[edge]]

    def _name(self, vertex: int) -> tuple[int, int]:
        """Return ring and index of a vertex, or of the edge that starts there."""
        ring = bisect_right(self.offsets, vertex) - 1
        return ring, vertex - self.offsets[ring]


def _meeting(lower: Place | None, upper: Place | None) -> list[tuple[int, int]]:
    """Return two neighbours as a pair if they meet to the right of the sweep line."""
    if lower is None or upper is None or lower.leaves == upper.leaves:
        return []  # in the third case they end at a common vertex, and meet nowhere before
    if lower.leaves < upper.leaves:
        meet = upper.side(lower.right) >= 0
    else:
        meet = lower.side(upper.right) <= 0
    return [(lower.edge, upper.edge)] if meet else []


def _lexicographic_keys(points: Sequence[HomogeneousPoint]) -> list[tuple[mpz, mpz]]:
    """Return integer pairs that compare, and equal each other, exactly as the points do.

    Different fractions with denominators up to 2^k are at least 2^-2k apart: times 2^2k they
    are at least 1 apart, and so have different floors.
    """
    shift = 2 * max(((w - 1).bit_length() for _, _, w in points), default=0)
    if shift == 0:
        return [(x, y) for x, y, _ in points]
    return [((x << shift) // w, (y << shift) // w) for x, y, w in points]
