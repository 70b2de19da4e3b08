"""The same answer by the straight road: exact `Angle` objects and integers in Python loops.

For strictly convex outlines without parallel edges. O(n^2) for the squeeze function, and a double
loop over all arcs for each step of phase I.
"""

from __future__ import annotations

from typing import Any

from gmpy2 import mpz

from stochgeom.exact.angles import HALF_TURN, Angle

Vectors = list[tuple[Any, Any]]


def squeeze(vertices: Any) -> tuple[list[Angle], list[Angle]]:
    """Return breaks in [0, 180) degrees and the values that follow them.  O(n^2)."""
    points = [(mpz(x), mpz(y)) for x, y in vertices.tolist()]
    breaks, minima = sorted(_maxima(points)), sorted(_minima(points))
    if minima[0] < breaks[0]:
        minima = [*minima[1:], minima[0] + HALF_TURN]
    return breaks, minima


def _minima(points: Vectors) -> list[Angle]:
    """Return where an edge lies flush and the farthest vertex stands strictly over its inside."""
    found = []
    n = len(points)
    for k, (px, py) in enumerate(points):
        qx, qy = points[(k + 1) % n]
        ex, ey = qx - px, qy - py
        fx, fy = max(points, key=lambda r, ex=ex, ey=ey: ex * r[1] - ey * r[0])
        along = ex * (fx - px) + ey * (fy - py)
        if 0 < along < ex * ex + ey * ey:
            found.append(Angle(0, (ex, -ey)) % HALF_TURN)
    return found


def _maxima(points: Vectors) -> list[Angle]:
    """Return where two vertices are strictly highest and lowest with their chord upright."""
    found = []
    n = len(points)
    for i, (px, py) in enumerate(points):
        around_i = (points[i - 1], points[(i + 1) % n])
        for j in range(i):
            qx, qy = points[j]
            vx, vy = px - qx, py - qy
            if all(vx * (rx - px) + vy * (ry - py) < 0 for rx, ry in around_i) and all(
                vx * (rx - qx) + vy * (ry - qy) > 0
                for rx, ry in (points[j - 1], points[(j + 1) % n])
            ):
                found.append(Angle(0, (vy, vx)) % HALF_TURN)
    return found


def widths(breaks: list[Angle], values: list[Angle], steps: int) -> list[Angle]:
    """Return the widths of the preimages of 1, 2, ... steps, by comparing all arcs."""
    m = len(breaks)
    all_breaks = [b + HALF_TURN * turn for turn in range(3) for b in breaks]
    all_values = [v + HALF_TURN * turn for turn in range(2) for v in values]
    found = [max(all_breaks[i + 1] - all_breaks[i] for i in range(m))]
    while len(found) < steps and found[-1] != HALF_TURN:
        best = found[-1]
        for i in range(m):
            for j in range(i, i + m):
                if all_values[j] - all_values[i] >= found[-1]:
                    break
                best = max(best, all_breaks[j + 1] - all_breaks[i])
        found.append(best)
    return found
