"""Rotating calipers: which vertices touch the two jaws, for all orientations in [0, 180) degrees.

The part is turned by theta between jaws parallel to the x axis. A hull edge e lies flush on the
lower jaw at theta = -arg(e), on the upper jaw half a turn later; both give a *transition*, taken
modulo 180 degrees. As theta grows the part turns counter-clockwise, so the contacts run through
the hull clockwise: passing the orientation of an edge, the lower contact moves from the edge's
end to its start. Between two transitions the contacts (lower, upper) stay the same: a *piece*.

Everything is a merge of two sorted lists of edge directions, done on arrays in O(n log n).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.exact.predicates import IntArray, half_planes
from stochgeom.exact.vectors import argsort_arguments
from stochgeom.geometry.hull import ConvexHull, hull_edges

Indices = NDArray[np.intp]

NO_EDGE = -1


@final
@dataclass(frozen=True, slots=True, eq=False)
class Calipers:
    """Transitions and contacts in [0, 180) degrees, by increasing orientation.

    Attributes
    ----------
    x, y : int arrays
        Direction whose argument is the orientation of transition t.
    lower, upper : int arrays
        Hull vertices on the lower and upper jaw between transition t and transition t + 1. The
        piece before transition 0 has the contacts of the last piece exchanged.
    lower_edge, upper_edge : int arrays
        Hull edge flush with the lower and upper jaw at transition t, or `NO_EDGE`. Parallel
        edges are flush together.
    """

    x: IntArray
    y: IntArray
    lower: Indices
    upper: Indices
    lower_edge: Indices
    upper_edge: Indices

    def __len__(self) -> int:
        return len(self.lower)

    @property
    def lower_before(self) -> Indices:
        """Lower contact on the piece before transition t."""
        return np.concatenate((self.upper[-1:], self.lower[:-1]))

    @property
    def upper_before(self) -> Indices:
        """Upper contact on the piece before transition t."""
        return np.concatenate((self.lower[-1:], self.upper[:-1]))


def rotate_calipers(hull: ConvexHull) -> Calipers:
    """Return all transitions and contacts of a convex polygon.  O(n log n)."""
    n = len(expect(hull, ConvexHull, "a ConvexHull, such as Part(vertices).hull", "hull"))
    # Clockwise, so that orientations grow: entry k stands for the edge that ends at `end[k]`.
    edge = np.arange(n)[::-1]
    ex, ey = hull_edges(hull)
    gx, gy = ex[edge], -ey[edge]
    upper_half = half_planes(gx, gy)
    # Convexity: the directions pass the positive x axis once; start there.
    start = int(np.flatnonzero(~upper_half & upper_half[np.arange(n) - 1])[0])
    turned = np.concatenate((np.arange(start, n), np.arange(start)))
    edge, gx, gy = edge[turned], gx[turned], gy[turned]
    on_lower = n - int(np.count_nonzero(upper_half))
    gx[on_lower:] = -gx[on_lower:]
    gy[on_lower:] = -gy[on_lower:]
    order, fresh = argsort_arguments(gx, gy)
    return _contacts(edge, order, fresh, on_lower, gx, gy)


def _contacts(
    edge: Indices,
    order: Indices,
    fresh: NDArray[np.bool_],
    on_lower: int,
    gx: IntArray,
    gy: IntArray,
) -> Calipers:
    """Follow both contacts through the merged transitions."""
    n = len(edge)
    end = (edge + 1) % n  # the contact before an edge is passed; its start comes after
    (first,) = np.nonzero(fresh)
    last = np.append(first[1:], n) - 1
    is_lower = order < on_lower
    passed_lower = np.cumsum(is_lower)[last]
    passed_upper = last + 1 - passed_lower
    transition = np.cumsum(fresh) - 1
    lower_edge = np.full(len(first), NO_EDGE, dtype=np.intp)
    upper_edge = np.full(len(first), NO_EDGE, dtype=np.intp)
    lower_edge[transition[is_lower]] = edge[order[is_lower]]
    upper_edge[transition[~is_lower]] = edge[order[~is_lower]]
    return Calipers(
        gx[order[first]],
        gy[order[first]],
        end[passed_lower % n],
        end[(on_lower + passed_upper) % n],
        lower_edge,
        upper_edge,
    )


def antipodal_pairs(hull: ConvexHull) -> list[tuple[int, int]]:
    """Return the vertex pairs that admit parallel supporting lines, at most 3 n / 2.

    Pairs (i, j) of hull vertices with i < j, sorted. Thesis App. D, after Preparata and Shamos
    (1985), section 4.2.3.

    Examples
    --------
    >>> from stochgeom.geometry.part import Part
    >>> antipodal_pairs(Part([(0, 0), (3, 0), (3, 2), (0, 2)]).hull)
    [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
    """
    calipers = rotate_calipers(hull)
    both = (calipers.lower_edge != NO_EDGE) & (calipers.upper_edge != NO_EDGE)
    # Between parallel flush edges every end sees every end: two pairs are pieces, two are not.
    lower = np.concatenate((calipers.lower, calipers.lower[both], calipers.lower_before[both]))
    upper = np.concatenate((calipers.upper, calipers.upper_before[both], calipers.upper[both]))
    pairs = np.sort(np.stack((lower, upper), axis=1), axis=1)
    return sorted({(int(i), int(j)) for i, j in pairs})
