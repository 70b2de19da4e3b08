"""The same algorithm in plain float64 numpy, for speed to be compared with.

Nothing here is exact and nothing is checked twice: signs are signs of rounded products, parallel
edges are found by chance, the period is taken to be half a turn, ties of widths go to whichever
rounds up. It is as well vectorised as the author could make it. On the outlines measured it gives
the breaks, values and widths of the library up to rounding, which the benchmark checks.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
Indices = NDArray[np.intp]
HALF = np.pi


class Steps(NamedTuple):
    """A step function of period pi: values[j] holds on [breaks[j], breaks[j + 1])."""

    breaks: FloatArray
    values: FloatArray


def squeeze(vertices: NDArray[np.int64]) -> Steps:
    """Return the squeeze function of a strictly convex, counter-clockwise polygon.  O(n log n)."""
    x, y = vertices[:, 0].astype(np.float64), vertices[:, 1].astype(np.float64)
    ex, ey = _differences(x), _differences(y)
    _check_convex(ex, ey)
    theta, edge, sense, lower, upper = _calipers(ex, ey)
    # The slope of the diameter is the x-extent of the turned chord, before and after transitions:
    # up to a positive factor its dot product with the edge that lies flush.
    gx, gy = ex[edge] * sense, ey[edge] * sense
    vx, vy = x[upper] - x[lower], y[upper] - y[lower]
    rising = vx * gx + vy * gy > 0
    before = np.empty_like(vx)
    before[1:] = vx[:-1] * gx[1:] + vy[:-1] * gy[1:]
    before[0] = -vx[-1] * gx[0] - vy[-1] * gy[0]
    falling = before < 0
    values = theta[falling & rising]
    places = np.flatnonzero(rising & np.append(falling[1:], falling[0]))
    breaks = np.arctan2(vx[places], vy[places])
    if breaks[-1] < 0 or breaks[-1] >= HALF:  # the last piece runs on beyond 180 degrees
        breaks = np.append(breaks[-1] % HALF, breaks[:-1])
    if values[0] < breaks[0]:
        values = np.append(values[1:], values[0] + HALF)
    return Steps(breaks, values)


def _differences(x: FloatArray) -> FloatArray:
    result = np.empty_like(x)
    np.subtract(x[1:], x[:-1], out=result[:-1])
    result[-1] = x[0] - x[-1]
    return result


def _check_convex(ex: FloatArray, ey: FloatArray) -> None:
    """Raise unless the edges turn left everywhere, once around."""
    turns = ex[:-1] * ey[1:] - ey[:-1] * ex[1:]
    below = ey < 0
    changes = np.count_nonzero(below[1:] != below[:-1]) + (below[0] != below[-1])
    if turns.min() <= 0 or ex[-1] * ey[0] <= ey[-1] * ex[0] or changes != 2:
        raise ValueError("not a strictly convex, counter-clockwise polygon")


def _calipers(
    ex: FloatArray, ey: FloatArray
) -> tuple[FloatArray, Indices, FloatArray, Indices, Indices]:
    """Return the transitions in [0, pi): angle, edge, jaw (1 lower, -1 upper), contacts after it.

    Two sorted lists of edge directions are merged.
    """
    n = len(ex)
    theta = -np.arctan2(ey, ex)[::-1]  # increasing, but for one jump
    start = (int(np.argmax(theta)) + 1) % n  # the jump from pi to -pi
    start = (start + int(np.count_nonzero(theta < 0))) % n
    turned = np.concatenate((np.arange(start, n), np.arange(start)))
    theta = theta[turned]
    on_lower = int(np.count_nonzero(theta >= 0))
    theta[on_lower:] += HALF
    order = np.argsort(theta, kind="stable")  # O(n) on two sorted runs
    is_lower = order < on_lower
    passed_lower = np.cumsum(is_lower)
    passed_upper = np.arange(1, n + 1) - passed_lower
    end = (n - turned) % n  # the vertex where edge n - 1 - turned ends
    end = np.append(end, end[0])
    return (
        theta[order],
        n - 1 - turned[order],
        np.where(is_lower, 1.0, -1.0),
        end[passed_lower],
        end[on_lower + passed_upper],
    )


class PhaseOne:
    """The widths of the preimages, one action after the other."""

    def __init__(self, steps: Steps) -> None:
        self._steps = steps
        self._breaks: FloatArray | None = None
        self._values: FloatArray | None = None
        self.widths: list[float] = []

    @property
    def complete(self) -> bool:
        """Whether a period is reached, up to rounding."""
        return bool(self.widths) and self.widths[-1] > HALF - 1e-12

    def advance(self) -> None:
        """Find the next width: the widest arc whose image is narrower than the last.  O(m)."""
        breaks, values = self._steps
        m = len(breaks)
        if self._breaks is None or self._values is None:
            self._breaks = np.concatenate((breaks, breaks + HALF, breaks[:1] + 2 * HALF))
            self._values = np.concatenate((values, values + HALF))
        if self.widths:
            after = np.searchsorted(self._values, values + self.widths[-1])
            widths = self._breaks[after] - breaks
        else:
            widths = self._breaks[1 : m + 1] - breaks
        self.widths.append(float(widths[np.argmax(widths)]))
