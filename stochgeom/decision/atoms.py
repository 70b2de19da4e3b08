"""Points with weights on the circle, sorted, and the points inside arcs, counted exactly.

Two roads. Where every point is a rational number of turns with one denominator N below 2**60, as
points from degrees are, a point is an integer and a window's width w becomes the largest integer
below w N, found once by exact arithmetic: all else is integer arrays. Otherwise `LiftedAngles`
answers, whose float64 shadow filters and whose exact comparisons decide.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.lifted import Indices, LiftedAngles
from stochgeom.exact.scalars import common_denominator
from stochgeom.exact.vectors import AngleVector

MAX_GRID: Final = 1 << 60
MAX_WEIGHT: Final = 1 << 61
BLOCK: Final = 32


@final
class WeightedPoints:
    """Distinct orientations in [0, 360) degrees with positive weights, in increasing order.

    Parameters
    ----------
    points : iterable of (Angle, mpq)
        Orientations, reduced, and weights; equal orientations are merged, weights of 0 left out.

    Attributes
    ----------
    angles : AngleVector
        The orientations.
    denominator : mpz
        The common denominator of the weights.
    numerators : list of int
        The weights times it.
    """

    def __init__(self, points: Iterable[tuple[Angle, mpq]]) -> None:
        merged: dict[Angle, mpq] = {}
        for angle, weight in points:
            if weight:
                merged[angle] = merged[angle] + weight if angle in merged else weight
        listed = list(merged)
        self._grid = _common_grid(listed)
        order = _increasing_order(listed, self._grid)
        angles = [listed[k] for k in order]
        self.angles = AngleVector.from_angles(angles)
        if self._grid is not None:
            self._grid = (self._grid[0], self._grid[1][order])
        weights = [merged[angle] for angle in angles]
        self.denominator = common_denominator(weights)
        self.numerators = [int((w * self.denominator).numerator) for w in weights]

    def __len__(self) -> int:
        return len(self.numerators)

    @cached_property
    def lifted(self) -> LiftedAngles:
        """The points as a periodic sequence."""
        return LiftedAngles(self.angles, FULL_TURN)

    @cached_property
    def sums(self) -> NDArray[Any]:
        """Sums of the first k numerators over two turns: int64 where they fit, else objects."""
        total = sum(self.numerators)
        fits = 2 * total < MAX_WEIGHT
        numerators = np.array(self.numerators * 2, dtype=np.int64 if fits else object)
        start = numerators[:1] * 0
        return np.concatenate((start, np.cumsum(numerators)))

    # --- windows ---------------------------------------------------------------------------------

    def heaviest(self, width: Angle) -> tuple[int, int]:
        """Return the first point whose window has the largest sum, and the sum.

        O(a) on arrays at worst. A window that begins in a block of points reaches from its first
        point to the end of its last point's window at most: blocks that cannot hold the largest
        sum are left out, nearly all of them as a rule.
        """
        m, sums = len(self), self.sums
        starts = np.arange(m)
        if m > 4 * BLOCK:
            first = np.arange(0, m, BLOCK)
            last = np.minimum(first + BLOCK, m) - 1
            least = (sums[self.last_below(width, first) + 1] - sums[first]).max()
            most = sums[self.last_below(width, last) + 1] - sums[first]
            (kept,) = np.nonzero(most >= least)
            starts = (first[kept][:, None] + np.arange(BLOCK)).ravel()
            starts = starts[starts < m]
        caught = sums[self.last_below(width, starts) + 1] - sums[starts]
        best = int(np.argmax(caught))
        return int(starts[best]), int(caught[best])

    def last_below(self, width: Angle, at: Indices | None = None) -> Indices:
        """Return for each point k, or each of `at`, the last j with point j < point k + width.

        j counts on into a second turn.
        """
        if self._grid is None:
            return self.lifted.last_below(width, at)
        count, places = self._grid
        reach = _largest_below(width, count)
        targets = (places if at is None else places[at]) + reach
        after: Indices = np.searchsorted(self._places, targets, "right")
        return after - 1

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        assert self._grid is not None
        count, places = self._grid
        return np.concatenate((places, places + count))

    def numerator_below(self, theta: Angle) -> int:
        """Return the sum of the numerators of points in [0, theta), theta in [0, 720) degrees."""
        turns = int(theta >= FULL_TURN)
        rest = theta - FULL_TURN if turns else theta
        return int(self.sums[self.count_below(rest) + turns * len(self)])

    def count_below(self, theta: Angle) -> int:
        """Return how many points are below theta in [0, 360) degrees.  O(log a)."""
        count = self.angles.count_at_most(theta)
        return count - int(count > 0 and self.angles[count - 1] == theta)


def _common_grid(angles: list[Angle]) -> tuple[int, NDArray[np.int64]] | None:
    """Return N and the points times N if all are multiples of 1 / N turn, N below `MAX_GRID`."""
    denominators, turns = set(), []
    for angle in angles:
        exact = angle.rational_turns
        if exact is None:
            return None
        denominators.add(exact.denominator)
        turns.append(exact)
    count = common_denominator([mpq(1, d) for d in denominators])
    if count >= MAX_GRID:
        return None
    places = [int(t.numerator * (count // t.denominator)) for t in turns]
    return int(count), np.array(places, dtype=np.int64)


def _increasing_order(
    angles: list[Angle], grid: tuple[int, NDArray[np.int64]] | None
) -> NDArray[np.intp]:
    """Return the order of distinct angles: by integers, or by floats and exact comparison."""
    if grid is not None:
        return np.argsort(grid[1])
    vector = AngleVector.from_angles(angles)
    order = np.argsort(vector.shadow, kind="stable")
    # Runs of neighbours closer than the shadow's error are sorted exactly; different runs are
    # farther apart than that, so they never interleave.
    close = np.concatenate(([False], np.diff(vector.shadow[order]) <= 2 * vector.error, [False]))
    edges = np.diff(close.astype(np.int8))
    for first, last in zip(np.nonzero(edges == 1)[0], np.nonzero(edges == -1)[0], strict=True):
        run = order[first : last + 1].tolist()
        order[first : last + 1] = sorted(run, key=angles.__getitem__)
    return order


def _largest_below(width: Angle, count: int) -> int:
    """Return the largest integer below width * count, the width in turns.

    Examples
    --------
    >>> _largest_below(Angle.from_degrees(90), 360), _largest_below(Angle(0, (3, 2)), 360)
    (89, 33)
    """
    exact = width.rational_turns
    if exact is not None:
        scaled = exact * count
        return int(-(-scaled.numerator // scaled.denominator)) - 1
    return width // Angle.from_turns(mpq(1, count))
