"""The outlines that are measured, as (n, 2) arrays of int64; the same seed gives the same ones."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Outline = NDArray[np.int64]

LARGE = 2**40
"""Radius of the large outlines."""


def near_circle(n: int, seed: int, radius: int = LARGE, squash: float = 1.0) -> Outline:
    """Return n rounded points of a circle, or of an ellipse of half axes 1 and `squash`.

    The points stand at jittered angles, at least a fifth of 360/n degrees apart. For 10^5 vertices
    of radius 2^40 each still lies several units off the chord of its neighbours, so rounding
    leaves the outline strictly convex.
    """
    angles = _jittered(n, seed)
    return _rounded(radius * np.cos(angles), radius * squash * np.sin(angles))


def constant_width(n: int, seed: int, radius: int = LARGE) -> Outline:
    """Return n rounded points of a smooth curve of constant width that is no circle.

    Its support function is 1 + cos(3 t) / 16: the odd harmonic cancels in h(t) + h(t + pi), and
    the radius of curvature 1 - cos(3 t) / 2 stays positive.
    """
    t = _jittered(n, seed)
    h, slope = 1 + np.cos(3 * t) / 16, -3 * np.sin(3 * t) / 16
    return _rounded(
        radius * (h * np.cos(t) - slope * np.sin(t)), radius * (h * np.sin(t) + slope * np.cos(t))
    )


def star(n: int, seed: int, radius: int = LARGE) -> Outline:
    """Return a star-shaped outline: even vertices on a circle, odd ones pulled in at random.

    Its hull has the n / 2 even vertices, and nearly every other vertex is reflex.
    """
    angles = _jittered(n, seed)
    reach = np.ones(n)
    reach[1::2] = np.random.default_rng(seed + 1).uniform(0.5, 0.95, n // 2)
    return _rounded(radius * reach * np.cos(angles), radius * reach * np.sin(angles))


def small_convex(n: int, seed: int) -> Outline:
    """Return a strictly convex polygon of n vertices: random edge vectors, by direction."""
    random = np.random.default_rng(seed)
    while True:
        edges = random.integers(-100, 101, (n - 1, 2))
        edges = np.concatenate((edges, -edges.sum(axis=0, keepdims=True)))
        edges = edges[np.argsort(np.arctan2(edges[:, 1], edges[:, 0]))]
        x, y = edges.T
        if (x * np.roll(y, -1) - y * np.roll(x, -1) > 0).all():
            return np.cumsum(edges, axis=0)


def small_star(n: int, seed: int) -> Outline:
    """Return a star-shaped outline of n vertices at random radii, nearly always not convex."""
    angles = _jittered(n, seed)
    reach = np.random.default_rng(seed + 1).uniform(300, 1000, n)
    return _rounded(reach * np.cos(angles), reach * np.sin(angles))


def _jittered(n: int, seed: int) -> NDArray[np.float64]:
    jitter = np.random.default_rng(seed).uniform(-0.4, 0.4, n)
    return (np.arange(n) + jitter) * (2 * np.pi / n)


def _rounded(x: NDArray[np.float64], y: NDArray[np.float64]) -> Outline:
    return np.rint(np.stack((x, y), axis=1)).astype(np.int64)
