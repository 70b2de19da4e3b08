"""How far the uniform centroid can move when the vertices do.

Let every vertex of a ring move by at most epsilon, along a straight line in unit time. Meanwhile an
edge of length L is never longer than L + 2 epsilon, moves at most at speed epsilon, and its points
stay within D + epsilon of a point c, with D the distance of its farther end. So the area changes by
at most

    a = epsilon sum (L + 2 epsilon),

and the first moment about c, which is zero for the centroid c, by at most

    m = epsilon sum (L + 2 epsilon) (D + epsilon),

sums over the edges of the outline and of all holes. The new centroid lies within m / (A - a) of c,
as long as no ring can turn inside out. That of a triangle is the mean of its vertices, so it moves
by epsilon at most.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import final

from gmpy2 import isqrt, mpq

from stochgeom.exact.surds import rational_bounds
from stochgeom.geometry.outline import mass_of
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Point, Points

_BITS = 32  # square roots are right to about one part in 2**_BITS


@final
@dataclass(frozen=True, slots=True)
class _Ring:
    """Area, rounded down; number of edges, and sums of upper bounds: L, D, and L D."""

    area: mpq
    count: int
    lengths: mpq
    distances: mpq
    products: mpq

    def area_change(self, epsilon: mpq) -> mpq:
        return epsilon * (self.lengths + 2 * self.count * epsilon)

    def moment_change(self, epsilon: mpq) -> mpq:
        more = self.lengths + 2 * self.distances + 2 * self.count * epsilon
        return epsilon * (self.products + epsilon * more)


@final
class CenterError:
    """How far the centre of mass of a part can move.

    Parameters
    ----------
    part : Part
        If its centre of mass was given, that stays where it is.

    Examples
    --------
    >>> square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> round(float(CenterError(square).bound(mpq(1, 1000))), 6)
    0.00285
    """

    def __init__(self, part: Part) -> None:
        self.part = part

    @cached_property
    def _rings(self) -> list[_Ring]:
        center = self.part.center_of_mass
        return [_ring(vertices, center) for vertices in (self.part.vertices, *self.part.holes)]

    def bound(self, epsilon: mpq) -> mpq | None:
        """Return how far it moves at most if no vertex moves farther than epsilon.

        None if there is no such bound.
        """
        if self.part.has_given_center:
            return mpq(0)
        if len(self.part) == 3 and not self.part.holes:
            return epsilon
        if any(ring.area_change(epsilon) >= ring.area for ring in self._rings):
            return None
        area = rational_bounds(self.part.area)[0] - sum(
            ring.area_change(epsilon) for ring in self._rings
        )
        if area <= 0:
            return None
        return mpq(sum(ring.moment_change(epsilon) for ring in self._rings)) / area


def _ring(vertices: Sequence[Point], center: Point) -> _Ring:
    lengths = [_distance(vertices[k - 1], vertices[k]) for k in range(len(vertices))]
    reaches = [_distance(vertex, center) for vertex in vertices]
    distances = [max(reaches[k - 1], reaches[k]) for k in range(len(vertices))]
    products = [a * b for a, b in zip(lengths, distances, strict=True)]
    area, _ = rational_bounds(mass_of(Points.from_pairs(vertices), ()).area)
    return _Ring(area, len(vertices), mpq(sum(lengths)), mpq(sum(distances)), mpq(sum(products)))


def _distance(a: Point, b: Point) -> mpq:
    """Return an upper bound of a distance."""
    _, squared = rational_bounds((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2)
    p, q = squared.numerator, squared.denominator
    return mpq(isqrt(p * q << (2 * _BITS)) + 1, q << _BITS) if p else mpq(0)
