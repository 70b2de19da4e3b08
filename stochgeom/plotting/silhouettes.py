"""Parts in floats, for drawing: of radius 1 about the middle of their bounding box.

All orientations of a part fit in the same disc, so that pictures of different orientations have
the same scale, and so do parts whose coordinates no float can hold.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.surds import Scalar, scalar_to_float
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.points import Point, Points
from stochgeom.plotting.arguments import is_drawn
from stochgeom.plotting.scene import XY

FloatArray = NDArray[np.float64]

MOST_DRAWN: Final = 600
"""About so many vertices of an outline are drawn, those that a picture can show apart."""


FEW_DRAWN: Final = 150
"""The same where a part is drawn small, one of many."""


@final
@dataclass(frozen=True, slots=True)
class Silhouette:
    """A part's outline, holes, hull and centre of mass in floats.

    Attributes
    ----------
    outline, hull : float array of shape (n, 2)
        The vertices drawn.
    holes : tuple of arrays
        The same of each hole.
    mass : (float, float)
        The centre of mass.
    name : str
        The part's name, or ``"part"``.
    """

    outline: FloatArray
    hull: FloatArray
    holes: tuple[FloatArray, ...]
    mass: XY
    name: str

    def turned(self, angle: float) -> Silhouette:
        """Return the silhouette turned counter-clockwise by radians, about (0, 0)."""
        turn = rotation(angle)
        x, y = turn @ np.array(self.mass)
        return replace(
            self,
            outline=self.outline @ turn.T,
            hull=self.hull @ turn.T,
            holes=tuple(hole @ turn.T for hole in self.holes),
            mass=(float(x), float(y)),
        )

    @property
    def bottom(self) -> float:
        """Where the lower jaw touches."""
        return float(self.hull[:, 1].min())

    @property
    def top(self) -> float:
        """Where the upper jaw touches."""
        return float(self.hull[:, 1].max())


def rotation(angle: float) -> FloatArray:
    """Return the matrix that turns columns counter-clockwise by radians."""
    c, s = float(np.cos(angle)), float(np.sin(angle))
    return np.array([[c, -s], [s, c]])


def silhouette(part: PartLike, most: int = MOST_DRAWN) -> Silhouette:
    """Return a part in floats, of larger outlines about ``most`` vertices.  O(n).

    Examples
    --------
    >>> found = silhouette([(0, 0), (8, 0), (8, 6), (0, 6)])
    >>> found.outline.tolist()
    [[-0.8, -0.6], [0.8, -0.6], [0.8, 0.6], [-0.8, 0.6]]
    """
    part = as_part(part)
    hull = part.hull.points
    middle, unit = _box(hull)
    # Of field elements the difference alone is taken: a quotient would cost milliseconds.
    scale = mpq(1) if is_algebraic(unit) else 1 / mpq(unit)

    def floats(points: Iterable[Point]) -> FloatArray:
        rows = [
            (scalar_to_float((x - middle[0]) * scale), scalar_to_float((y - middle[1]) * scale))
            for x, y in points
        ]
        return np.array(rows, dtype=np.float64)

    def all_floats(points: Points) -> FloatArray:
        if points.w is not None or points.x.dtype == object:
            return floats(points.pairs())
        # Integers below 2**52: twice their distance from the middle is exact in int64.
        doubled = (2 * middle[0] * points.scale, 2 * middle[1] * points.scale)
        columns = [2 * v - int(m) for v, m in zip((points.x, points.y), doubled, strict=True)]
        return np.stack(columns, axis=1) / float(2 * unit * points.scale)

    corners = all_floats(hull)
    radius = float(np.hypot(corners[:, 0], corners[:, 1]).max())
    mass = floats([part.center_of_mass])[0] / radius
    return Silhouette(
        _visible(all_floats(part.points) / radius, most),
        _visible(corners / radius, most),
        tuple(_visible(floats(hole) / radius, most) for hole in part.holes),
        (float(mass[0]), float(mass[1])),
        part.name or "part",
    )


def size_is_drawn(part: PartLike) -> bool:
    """Tell whether floats hold the sizes of a part, so that functions of it can be drawn.

    Examples
    --------
    >>> size_is_drawn([(0, 0), (3, 0), (0, 2)]), size_is_drawn([(0, 0), (3, 0), (0, 10**400)])
    (True, False)
    """
    return is_drawn(_box(as_part(part).hull.points)[1])


def _box(points: Points) -> tuple[Point, Scalar]:
    """Return the middle of the bounding box of points, and half its longer side."""
    sides = []
    for values in (points.x, points.y):
        if points.w is None:
            low, high = min(values.tolist()), max(values.tolist())
            share: Any = 1 / mpq(2 * points.scale)
        else:
            ratios = [mpq(v, w) for v, w in zip(values, points.w, strict=True)]
            low, high, share = min(ratios), max(ratios), mpq(1, 2)
        sides.append(((low + high) * share, (high - low) * share))
    (x, width), (y, height) = sides
    return (x, y), max(width, height)


def _visible(points: FloatArray, most: int) -> FloatArray:
    """Return the vertices that stand apart from the one before, about ``most`` of them."""
    if len(points) <= most:
        return points
    kept = [0]
    for k in range(1, len(points)):
        if np.hypot(*(points[k] - points[kept[-1]])) >= 4 / most:
            kept.append(k)
    return points[kept]
