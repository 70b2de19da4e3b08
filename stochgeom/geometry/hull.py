"""Convex hulls: recognised in O(n) when the outline is convex, else O(n log n)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cmp_to_key
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.exact.predicates import (
    HomogeneousPoint,
    IntArray,
    Turn,
    compare_points,
    cross_signs,
    dot_signs,
    half_planes,
    orientation,
)
from stochgeom.geometry.points import Points, homogeneous_point

Indices = NDArray[np.intp]


@final
@dataclass(frozen=True, slots=True, eq=False)
class ConvexHull:
    """A strictly convex polygon, counter-clockwise.

    Attributes
    ----------
    points : Points
        Its vertices; hull edge k runs from hull vertex k to hull vertex k + 1.
    indices : int array
        For each hull vertex its number in the outline.
    """

    points: Points
    indices: Indices

    def __len__(self) -> int:
        return len(self.indices)


def convex_outline(points: Points) -> ConvexHull | None:
    """Return the hull if the outline is a convex polygon in order, else None.  O(n).

    `points` holds no two equal neighbours. Vertices in the middle of straight runs are allowed.
    """
    n = len(points)
    here = np.arange(n)
    ex, ey = points.vectors(here, here - n + 1)  # negative indices count from the end
    before_x, before_y = ex[here - 1], ey[here - 1]
    turns = cross_signs(before_x, before_y, ex, ey)
    left, right = bool((turns > 0).any()), bool((turns < 0).any())
    if left == right:  # turns both ways, or never
        return None
    straight = turns == 0
    if straight.any() and (dot_signs(before_x, before_y, ex, ey)[straight] < 0).any():
        return None  # folds back on itself
    # Turning one way only, the edges pass each half plane once for each winding.
    lower = half_planes(ex, ey)
    if np.count_nonzero(lower != lower[here - 1]) != 2:
        return None
    corners = here[~straight]
    if right:
        corners = corners[::-1].copy()
    return ConvexHull(points.take(corners), corners)


def convex_hull(points: Points) -> ConvexHull:
    """Return the strictly convex hull of points that are not all collinear.  O(n log n).

    Andrew's monotone chain on exact coordinates. Of equal points the first is kept.

    Examples
    --------
    >>> points = Points.from_pairs([(0, 0), (4, 0), (2, 1), (4, 4), (2, 0)])
    >>> convex_hull(points).indices.tolist()
    [0, 1, 3]
    """
    expect(points, Points, "Points.from_pairs(vertices), or Part(vertices).hull", "points")
    homogeneous = points.homogeneous()
    order = _sorted_by_point(points, homogeneous)
    lower = _half_hull(order, homogeneous)
    upper = _half_hull(order[::-1], homogeneous)
    ring = lower[:-1] + upper[:-1]
    start = ring.index(min(ring))
    corners = np.array(ring[start:] + ring[:start], dtype=np.intp)
    return ConvexHull(points.take(corners), corners)


def _sorted_by_point(points: Points, homogeneous: list[HomogeneousPoint]) -> list[int]:
    """Sort by x, then y, and drop repeated points."""
    if points.w is None:
        order = sorted(range(len(points)), key=lambda k: (homogeneous[k][:2], k))
    else:
        by_point = cmp_to_key(compare_points)
        order = sorted(range(len(points)), key=lambda k: (by_point(homogeneous[k]), k))
    return [
        k
        for place, k in enumerate(order)
        if place == 0 or compare_points(homogeneous[order[place - 1]], homogeneous[k])
    ]


def _half_hull(order: list[int], points: list[HomogeneousPoint]) -> list[int]:
    chain: list[int] = []
    for k in order:
        # Invariant: the chain turns strictly left at every inner vertex.
        while len(chain) > 1:
            turn = orientation(points[chain[-2]], points[chain[-1]], points[k])
            if turn is Turn.LEFT:
                break
            chain.pop()
        chain.append(k)
    return chain


def hull_edges(hull: ConvexHull) -> tuple[IntArray, IntArray]:
    """Return the counter-clockwise edge vectors, each up to a positive factor."""
    here = np.arange(len(hull))
    return hull.points.vectors(here, here - len(hull) + 1)


def locate(hull: ConvexHull, point: tuple[Any, Any]) -> int:
    """Return 1 for a point strictly inside the hull, 0 on its boundary, -1 outside.  O(n)."""
    # The point as homogeneous numbers beside the hull's own.
    p = homogeneous_point(*point)
    corners = [(x, y, w * hull.points.scale) for x, y, w in hull.points.homogeneous()]
    turns = {
        int(orientation(corners[k], corners[(k + 1) % len(corners)], p))
        for k in range(len(corners))
    }
    return min(turns)
