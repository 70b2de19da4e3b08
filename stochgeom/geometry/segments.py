"""Two edges, or an edge loop and a point: how they lie, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import TypeAlias

from stochgeom.exact.predicates import (
    HomogeneousPoint,
    Turn,
    compare_points,
    cross_sign,
    orientation,
)

Segment: TypeAlias = "tuple[HomogeneousPoint, HomogeneousPoint]"
"""An edge: its start and its end, two different points."""


class ConflictKind(Enum):
    """How two edges meet that should not."""

    CROSSING = "crossing"
    """They have one point in common, inside both, and pass from side to side."""

    TOUCHING = "touching"
    """They have one point in common, and it is an end of at least one of them."""

    OVERLAPPING = "overlapping"
    """They have a segment in common; also consecutive edges that fold back on each other."""


def pair_conflict(
    first: Segment, second: Segment, *, consecutive: bool = False
) -> ConflictKind | None:
    """Return how two edges meet that should not, or None.

    Parameters
    ----------
    first, second : pair of point
        Start and end of each edge.
    consecutive : bool
        The end of `first` is the start of `second`, by position in the ring; they may, and do,
        share this point.

    Examples
    --------
    >>> floor = (0, 0, 1), (4, 0, 1)
    >>> pair_conflict(floor, ((2, 3, 1), (2, 0, 1)))
    <ConflictKind.TOUCHING: 'touching'>
    >>> pair_conflict(floor, ((4, 0, 1), (9, 0, 1)), consecutive=True)
    >>> pair_conflict(floor, ((4, 0, 1), (3, 0, 1)), consecutive=True)
    <ConflictKind.OVERLAPPING: 'overlapping'>
    """
    (p, q), (r, s) = first, second
    r_side, s_side = orientation(p, q, r), orientation(p, q, s)
    if consecutive:
        folds_back = s_side is Turn.STRAIGHT and compare_points(p, q) == compare_points(s, q)
        return ConflictKind.OVERLAPPING if folds_back else None
    if r_side is s_side:  # all on one line, or one edge wholly on one side of the other's line
        return _collinear_conflict(first, second) if r_side is Turn.STRAIGHT else None
    p_side, q_side = orientation(r, s, p), orientation(r, s, q)
    if p_side is q_side:
        return None
    if Turn.STRAIGHT in (p_side, q_side, r_side, s_side):
        return ConflictKind.TOUCHING
    return ConflictKind.CROSSING


def _collinear_conflict(first: Segment, second: Segment) -> ConflictKind | None:
    """Return how two edges on one line meet: by the order of their ends."""
    (p, q), (r, s) = (_sorted_ends(edge) for edge in (first, second))
    last_left = p if compare_points(p, r) > 0 else r
    first_right = q if compare_points(q, s) < 0 else s
    gap = compare_points(last_left, first_right)
    if gap > 0:
        return None
    return ConflictKind.OVERLAPPING if gap < 0 else ConflictKind.TOUCHING


def _sorted_ends(edge: Segment) -> Segment:
    start, end = edge
    return edge if compare_points(start, end) < 0 else (end, start)


def contains(ring: Sequence[HomogeneousPoint], point: HomogeneousPoint) -> int:
    """Tell where a point lies: 1 strictly inside a simple ring, 0 on it, -1 outside.  O(n).

    Examples
    --------
    >>> triangle = [(0, 0, 1), (4, 0, 1), (0, 4, 1)]
    >>> [contains(triangle, point) for point in [(1, 1, 1), (2, 2, 1), (5, 0, 1), (7, 1, 2)]]
    [1, 0, -1, 0]
    """
    x, y, w = point
    inside = False
    start = ring[-1]
    start_side = cross_sign(w, y, start[2], start[1])
    for end in ring:
        # +1, 0, -1: the vertex is above, level with, below the point
        end_side = cross_sign(w, y, end[2], end[1])
        if end_side == 0 == start_side:
            before, after = cross_sign(w, x, start[2], start[0]), cross_sign(w, x, end[2], end[0])
            if before * after <= 0:
                return 0
        elif end_side == 0 and cross_sign(w, x, end[2], end[0]) == 0:
            return 0
        elif (start_side > 0) != (end_side > 0):
            # The ray to the right counts a vertex on it as below it; it meets the edge iff the
            # point is left of the edge going up, or right of the edge going down.
            turn = orientation(start, end, point)
            if turn is Turn.STRAIGHT:
                return 0
            inside ^= (turn is Turn.LEFT) == (end_side > 0)
        start, start_side = end, end_side
    return 1 if inside else -1
