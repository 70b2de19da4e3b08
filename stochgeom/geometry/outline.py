"""What makes an outline acceptable, and the mass it encloses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from gmpy2 import mpq, mpz
from numpy.typing import NDArray

from stochgeom.errors import (
    CollinearOutlineError,
    InvalidHoleError,
    SelfIntersectionError,
    TooFewVerticesError,
)
from stochgeom.exact.algebraic import simplified
from stochgeom.exact.predicates import HomogeneousPoint, Turn, as_objects, orientation
from stochgeom.geometry.moments import ring_sums
from stochgeom.geometry.points import Point, Points
from stochgeom.geometry.segments import ConflictKind, contains
from stochgeom.geometry.simplicity import Conflict, find_conflict

Indices = NDArray[np.intp]

_LONG = 128
"""Outlines of at least so many vertices are summed on arrays."""

_WORDS = {
    ConflictKind.CROSSING: "cross",
    ConflictKind.TOUCHING: "touch",
    ConflictKind.OVERLAPPING: "overlap",
}


def without_repeats(points: Points) -> Indices:
    """Return the indices of vertices that differ from the vertex before, in cyclic order."""
    here = np.arange(len(points))
    dx, dy = points.vectors(here - 1, here)
    kept: Indices = here[((dx != 0) | (dy != 0)).astype(np.bool_)]
    return kept if len(kept) or not len(here) else here[:1]


def check_outline(points: Points, holes: tuple[Points, ...]) -> None:
    """Raise unless the outline is a simple polygon and the holes lie properly inside it."""
    rings, numbers = [], []
    for place, ring in enumerate((points, *holes)):
        kept = without_repeats(ring)
        homogeneous = ring.homogeneous()
        corners = [homogeneous[k] for k in kept.tolist()]
        _check_ring(corners, "outline" if place == 0 else f"hole {place - 1}")
        # Rings must share a scale to be compared with each other.
        rings.append([(x, y, w * ring.scale) for x, y, w in corners])
        numbers.append(kept)
    conflict = find_conflict(rings)
    if conflict is not None:
        raise _conflict_error(conflict, numbers, (points, *holes))
    _check_nesting(rings)


def _check_ring(corners: list[HomogeneousPoint], where: str) -> None:
    # Two neighbours differ, so a third distinct corner shows up before long.
    distinct: set[Point] = set()
    for x, y, w in corners:
        distinct.add((x * mpq(1, w), y * mpq(1, w)))
        if len(distinct) == 3:
            break
    else:
        raise TooFewVerticesError(
            f"no 3 distinct vertices, only {len(distinct)}; accepted: at least 3", where=where
        )
    # Neighbours differ, so the first two corners span the only line all of them could lie on.
    if all(orientation(corners[0], corners[1], p) is Turn.STRAIGHT for p in corners):
        raise CollinearOutlineError(
            f"all {len(corners)} vertices lie on one line; "
            "accepted: an outline that encloses an area",
            where=where,
        )


def _conflict_error(
    conflict: Conflict, numbers: list[Indices], rings: tuple[Points, ...]
) -> SelfIntersectionError | InvalidHoleError:
    def number(ring: int, edge: int) -> int:
        """Of repeated vertices the last begins the edge."""
        kept = numbers[ring]
        return (int(kept[(edge + 1) % len(kept)]) - 1) % len(rings[ring])

    def name(ring: int, edge: int) -> str:
        points, k = rings[ring], number(ring, edge)
        owner = "" if ring == 0 else f" of hole {ring - 1}"
        ends = points.point(k), points.point((k + 1) % len(points))
        return f"edge {k}{owner} from {_text(ends[0])} to {_text(ends[1])}"

    first, second = sorted(
        (conflict.first, conflict.second), key=lambda place: (place[0], number(*place))
    )
    message = f"{name(*first)} and {name(*second)} {_WORDS[conflict.kind]}; "
    edges = number(*first), number(*second)
    if first[0] == second[0] == 0:
        return SelfIntersectionError(
            message + "accepted: an outline that does not meet itself",
            edges=edges,
            where=f"edges {edges[0]} and {edges[1]}",
        )
    return InvalidHoleError(
        message + "accepted: holes that meet neither themselves, each other nor the outline",
        where=f"hole {second[0] - 1}",
    )


def _check_nesting(rings: list[list[HomogeneousPoint]]) -> None:
    """With no two edges in contact, one vertex of a ring tells for all of it."""
    outline, *holes = rings
    for place, hole in enumerate(holes):
        if contains(outline, hole[0]) != 1:
            raise InvalidHoleError(
                "it lies outside the outline; accepted: holes inside it", where=f"hole {place}"
            )
        for other, ring in enumerate(holes):
            if other != place and contains(ring, hole[0]) == 1:
                raise InvalidHoleError(
                    f"it lies inside hole {other}; accepted: holes beside each other",
                    where=f"hole {place}",
                )


@dataclass(frozen=True, slots=True)
class Mass:
    """Area and uniform centroid."""

    area: Any
    centroid: Point


def mass_of(outline: Points, holes: tuple[Points, ...]) -> Mass:
    """Return area and centroid of an outline less its holes.  O(n) exact operations."""
    area, mx, my = _moments(outline)
    for hole in holes:
        hole_area, hole_x, hole_y = _moments(hole)
        area, mx, my = area - hole_area, mx - hole_x, my - hole_y
    return Mass(area, (simplified(mx / area), simplified(my / area)))


def _moments(points: Points) -> tuple[Any, Any, Any]:
    """Return area and first moments of one simple ring, with positive area."""
    if points.w is None:
        scale = points.scale
        if points.x.dtype != object and len(points) >= _LONG:
            return _scaled(*ring_sums(points.x, points.y), scale)
        xs, ys = (as_objects(values).tolist() for values in (points.x, points.y))
    else:
        pairs = points.pairs()
        xs, ys = [x for x, _ in pairs], [y for _, y in pairs]
        scale = mpz(1)
    twice = mx = my = mpz(0)
    for k in range(len(xs)):
        ax, ay, bx, by = xs[k - 1], ys[k - 1], xs[k], ys[k]
        cross = ax * by - ay * bx
        twice += cross
        mx += cross * (ax + bx)
        my += cross * (ay + by)
    return _scaled(twice, mx, my, scale)


def _scaled(twice: Any, mx: Any, my: Any, scale: mpz) -> tuple[Any, Any, Any]:
    """Return area and first moments from the sums over an outline in units of 1 / scale."""
    sign = -1 if twice < 0 else 1
    square, cube = mpq(sign, 2 * scale**2), mpq(sign, 6 * scale**3)
    return simplified(twice * square), simplified(mx * cube), simplified(my * cube)


def _text(point: Point) -> str:
    return f"({point[0]!s:.40}, {point[1]!s:.40})"
