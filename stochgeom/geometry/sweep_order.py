"""The order, from bottom to top, of the edges that a sweep line meets.

A sweep visits points in lexicographic order: by x, then by y. That is the order of a vertical
line, tilted counter-clockwise by an infinitesimal angle, that moves from left to right; so no
edge is parallel to the line, and a vertical edge is an edge like any other, with its lower end
as its left end. An edge is stored as the line from its left end to its right end, a triple
(a, b, c) with

    a X + b Y + c W > 0    iff    the point (X, Y, W) lies to the left of the line,

which for the tilted sweep line is the same as *above* the edge. The sign is that of
`stochgeom.exact.predicates.orientation`, at half the cost because the line is at hand.

The order is kept in a treap (a search tree on the order that is a heap on random priorities)
whose nodes are also linked to their neighbours. With m edges in it, `locate` takes O(log m)
comparisons in expectation, and insertion and removal O(1) rotations in expectation, for every
input, because nobody knows the priorities in advance. They come from a generator of this
module's own; they shape the tree, never the order, so no result depends on them.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Final, TypeAlias

if TYPE_CHECKING:
    from gmpy2 import mpz

    from stochgeom.exact.predicates import HomogeneousPoint

Line: TypeAlias = "tuple[mpz, mpz, mpz]"
"""(a, b, c), the points to the left of which have a X + b Y + c W > 0."""

_PRIORITY_BITS: Final = 30  # ties only cost balance; one CPython digit compares fastest
_random_bits = random.Random().getrandbits


def line_through(p: HomogeneousPoint, q: HomogeneousPoint) -> Line:
    """Return the line from p to q.

    Examples
    --------
    >>> line_through((0, 0, 1), (2, 0, 1))
    (0, 2, 0)
    """
    px, py, pw = p
    qx, qy, qw = q
    if pw == 1 == qw:
        return py - qy, qx - px, px * qy - py * qx
    return py * qw - pw * qy, pw * qx - px * qw, px * qy - py * qx


class Place:
    """The place of one edge in the order.

    Attributes
    ----------
    edge : int
        The caller's name for the edge.
    line : tuple of int
        The line through the edge, from its left to its right end.
    right : tuple of int
        The right end, a homogeneous point.
    leaves : int
        The number of the event at which the edge ends.
    below, above : Place or None
        The neighbours in the order.
    """

    __slots__ = (
        "_lower",
        "_parent",
        "_priority",
        "_upper",
        "above",
        "below",
        "edge",
        "leaves",
        "line",
        "right",
    )

    edge: int
    line: Line
    right: HomogeneousPoint
    leaves: int
    below: Place | None
    above: Place | None
    _parent: Place | None
    _lower: Place | None
    _upper: Place | None
    _priority: int

    def __init__(
        self, edge: int, left: HomogeneousPoint, right: HomogeneousPoint, leaves: int
    ) -> None:
        self.hold(edge, left, right, leaves)
        self.below = self.above = None
        self._parent = self._lower = self._upper = None
        self._priority = _random_bits(_PRIORITY_BITS)

    def hold(self, edge: int, left: HomogeneousPoint, right: HomogeneousPoint, leaves: int) -> None:
        """Put an edge here, in place of the one that was here before."""
        self.edge = edge
        self.line = line_through(left, right)
        self.right = right
        self.leaves = leaves

    def side(self, point: HomogeneousPoint) -> mpz:
        """Return a number with the sign of "the point is above the edge's line"."""
        a, b, c = self.line
        x, y, w = point
        return a * x + b * y + c * w


class SweepOrder:
    """The edges that meet the sweep line, from bottom to top.

    Examples
    --------
    >>> order = SweepOrder()
    >>> floor = Place(0, (0, 0, 1), (9, 0, 1), 8)
    >>> order.insert(floor, None, None)
    >>> below, above, hit = order.locate((1, 5, 1))
    >>> below is floor, above, hit
    (True, None, None)
    >>> roof = Place(1, (1, 5, 1), (9, 9, 1), 9)
    >>> order.insert(roof, below, above)
    >>> [place.edge for place in order.locate((2, 1, 1))[:2]]
    [0, 1]
    >>> order.remove(floor)
    >>> roof.below is None
    True
    """

    __slots__ = ("_root",)

    def __init__(self) -> None:
        self._root: Place | None = None

    def locate(self, point: HomogeneousPoint) -> tuple[Place | None, Place | None, Place | None]:
        """Return the edges just below and just above a point, and one that passes through it.

        The third is None if there is no such edge; otherwise the first two mean nothing.
        """
        x, y, w = point
        below = above = None
        place = self._root
        while place is not None:
            a, b, c = place.line
            height = a * x + b * y + c * w
            if height > 0:
                below, place = place, place._upper
            elif height < 0:
                above, place = place, place._lower
            else:
                return below, above, place
        return below, above, None

    def insert(self, place: Place, below: Place | None, above: Place | None) -> None:
        """Insert a place between two neighbours; None stands for the bottom and the top."""
        place.below, place.above = below, above
        if above is not None:
            above.below = place
        if below is not None:
            below.above = place
        # Of two neighbours one is an ancestor of the other, so one of these two seats is free.
        if below is not None and below._upper is None:
            below._upper = place
            place._parent = below
        elif above is not None:
            above._lower = place
            place._parent = above
        else:
            self._root = place
        parent = place._parent
        while parent is not None and parent._priority > place._priority:
            self._raise(place, parent)
            parent = place._parent

    def remove(self, place: Place) -> None:
        """Take a place out of the order."""
        lower, upper = place._lower, place._upper
        while lower is not None and upper is not None:
            self._raise(lower if lower._priority < upper._priority else upper, place)
            lower, upper = place._lower, place._upper
        child, parent = lower or upper, place._parent
        if child is not None:
            child._parent = parent
        self._reseat(place, child, parent)
        below, above = place.below, place.above
        if below is not None:
            below.above = above
        if above is not None:
            above.below = below

    def _raise(self, place: Place, parent: Place) -> None:
        """Rotate a place above its parent."""
        if parent._lower is place:
            orphan = parent._lower = place._upper
            place._upper = parent
        else:
            orphan = parent._upper = place._lower
            place._lower = parent
        if orphan is not None:
            orphan._parent = parent
        grandparent = parent._parent
        place._parent, parent._parent = grandparent, place
        self._reseat(parent, place, grandparent)

    def _reseat(self, old: Place, new: Place | None, parent: Place | None) -> None:
        """Give `new` the seat under `parent` that `old` had."""
        if parent is None:
            self._root = new
        elif parent._lower is old:
            parent._lower = new
        else:
            parent._upper = new
