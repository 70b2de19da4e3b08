"""The hull's vertices as seen from the centre of mass."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

import numpy as np
from gmpy2 import mpq, mpz
from numpy.typing import NDArray

from stochgeom.errors import CenterOfMassError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.offset_directions import OffsetDirections
from stochgeom.exact.predicates import (
    EXACT_FLOAT_LIMIT,
    IntArray,
    Signs,
    as_objects,
    dot_signs,
    fits_float,
)
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.hull import ConvexHull, hull_edges
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Point, homogeneous_point

Indices = NDArray[np.intp]

_WHERE: Final = {0: "on the boundary of", -1: "outside"}


@final
@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """The directions in which a part's hull lies about its centre of mass.

    Attributes
    ----------
    edge_x, edge_y : int arrays
        The hull's edges, counter-clockwise, each up to a positive factor.
    upright : AngleVector
        For each hull vertex the orientation in which it is straight below the centre of mass.
    before, after : int8 arrays
        For each hull edge, lying flush on the lower jaw, the sign of the radius's slope before
        that orientation, where the edge's end touches, and after it, where its start does.
    """

    edge_x: IntArray
    edge_y: IntArray
    upright: AngleVector
    before: Signs
    after: Signs


def look_around(part: Part) -> Sight:
    """Return how a part's hull lies about its centre of mass.  O(n) after the hull.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the hull.
    """
    hull, center = part.hull, part.center_of_mass
    ex, ey = hull_edges(hull)
    upright = _upright(hull, center)
    end = np.arange(len(hull)) - len(hull) + 1
    # With v the way from a vertex to the centre, `upright` holds (v_y, v_x). The centre is on the
    # left of an edge e where e x v is positive, and the slope of the radius is e . v.
    side = int(_dot_signs(upright, ex, -ey).min())
    if side != 1:
        raise CenterOfMassError(
            f"({_text(center[0])}, {_text(center[1])}) lies {_WHERE[side]} the convex hull; "
            "accepted: a point strictly inside the convex hull",
            where="center of mass",
        )
    return Sight(
        ex, ey, upright, _dot_signs(upright.take(end), ey, ex), _dot_signs(upright, ey, ex)
    )


def _text(value: mpq) -> str:
    return f"{value!s:.40}"


def _dot_signs(vector: AngleVector, ax: IntArray, ay: IntArray) -> Signs:
    if isinstance(vector, OffsetDirections):
        return vector.dot_signs(ax, ay)
    return dot_signs(ax, ay, vector.x, vector.y)


def _upright(hull: ConvexHull, center: Point) -> AngleVector:
    """Return the orientations in which each vertex is straight below the centre of mass.

    With (vx, vy) the way from the vertex to the centre, that is arg(vy + i vx).
    """
    points = hull.points
    # The centre is (px / w, py / w) in the units of the points' integers.
    px, py, w = homogeneous_point(center[0] * points.scale, center[1] * points.scale)
    if points.w is not None:
        x, y = px * points.w - points.x * w, py * points.w - points.y * w
        return AngleVector.from_directions(y, x)
    over_field = is_algebraic(px) or is_algebraic(py)
    if not over_field and fits_float(points.x, points.y):
        largest = max(int(np.abs(points.x).max()), int(np.abs(points.y).max()))
        if max(abs(px), abs(py)) + w * largest < EXACT_FLOAT_LIMIT:
            one = int(w)
            return AngleVector.from_directions(int(py) - points.y * one, int(px) - points.x * one)
        offset = _offset_upright(points.x, points.y, px, py, w)
        if offset is not None:
            return offset
    x, y = px - as_objects(points.x) * w, py - as_objects(points.y) * w
    return AngleVector.from_directions(y, x)


def _offset_upright(x: IntArray, y: IntArray, px: mpz, py: mpz, w: mpz) -> OffsetDirections | None:
    """Split off the whole parts, unless a vertex is too near or the centre too far."""
    whole_x, whole_y = (2 * px + w) // (2 * w), (2 * py + w) // (2 * w)
    if max(abs(whole_x), abs(whole_y)) >= EXACT_FLOAT_LIMIT // 2:
        return None
    dx, dy = int(whole_x) - x, int(whole_y) - y
    if int(np.maximum(np.abs(dx), np.abs(dy)).min()) < 2 or not fits_float(dx, dy):
        return None
    return OffsetDirections(dy, dx, (py - whole_y * w, px - whole_x * w), w)
