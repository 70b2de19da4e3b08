"""Hostile parts that are close to something: to equality, to parallel edges, to symmetry.

What a float planner decides here is decided by rounding. See `stochgeom.feeding.adversarial`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import flint
from gmpy2 import mpq

from stochgeom.exact.balls import Ball, rational_ball
from stochgeom.exact.decimals import certified_decimal
from stochgeom.feeding.hostile_draws import Draws, Point
from stochgeom.geometry.part import Part

_DECIMALS = 6
"""Decimals of the vertices of near-regular polygons."""

_TIED: Final = ((-714, 606), (-230, -909), (948, 559), (470, 835))
"""Of this quadrilateral two actions collapse the arc between the diameters along edges 1 and 0.

The image of a whole period, from edge 1 flush to edge 0 flush, is the angle between the same two
edges: exactly as wide, so it does not fit, and the shortest plan has 4 steps. A planner that lets
it fit finds a plan of 3 steps, which fails. The tie stays when the vertices are moved a little.
"""

_SHIFT = 10


def long_plans(size: int, seed: int) -> Part:
    """Return a regular polygon of n vertices, one slid along its circle: its plan has n steps.

    n is the size, or one more if that is even. One vertex is slid by 0.001 to 0.01 rad, either
    way, and all are rounded to 6 decimals. The steps of the squeeze function are almost equal, so
    each preimage is wider than the one before by a little more than one of them; no shorter plan
    orients the part.

    Examples
    --------
    >>> from stochgeom.feeding.planner import orient_up_to_symmetry
    >>> orient_up_to_symmetry(long_plans(9, 0)).steps
    9
    """
    n, draws = size | 1, Draws("long plans", size, seed)
    moved, slide = draws.whole(0, n - 1), mpq(draws.whole(1000, 10_000) * draws.sign(), 10**6)
    return Part(
        [_on_circle(mpq(k, n), slide if k == moved else mpq(0)) for k in range(n)],
        name=f"long plan {n}, seed {seed}",
    )


def _on_circle(turns: mpq, slide: mpq) -> tuple[str, str]:
    """Return a point of the unit circle, correctly rounded; the angle in turns and radians."""
    if not turns and not slide:
        return "1", "0"  # the one rational point: certified decimals are for irrational ones

    def enclose(function: Callable[[Ball], Ball]) -> Callable[[], Ball]:
        return lambda: function(2 * flint.arb.pi() * rational_ball(turns) + rational_ball(slide))

    x, y = (
        certified_decimal(enclose(function), _DECIMALS)
        for function in (flint.arb.cos, flint.arb.sin)
    )
    return x, y


def structural_ties(size: int, seed: int) -> Part:
    """Return a part of `size` vertices with an image exactly as wide as the preimage before.

    A generic quadrilateral, in which both are the angle between the same two edges: one of them
    as two diameters along edges, the other as the same edges lying flush. No coordinate tells that
    they are equal. The other vertices make an edge that has no part in it slightly round. The tie
    decides the plan: 4 steps orient the part, and 3 would if the image were any narrower.
    """
    draws = Draws("structural ties", size, seed)
    corners = _tied_corners(draws)
    end, start = corners[0], corners[3]
    round_edge = [
        _beside(start, end, mpq(k, size - 3), mpq(k * (size - 3 - k), 1000 * (size - 3) ** 2))
        for k in range(1, size - 3)
    ]
    return Part([*corners, *round_edge], name=f"structural tie {size}, seed {seed}")


def near_ties(size: int, seed: int) -> Part:
    """Return a part with an image that differs by about 2**-size from the preimage before.

    A structural tie, broken: one more vertex stands 2**-size beside one of the two edges, left or
    right of the place where the jaw presses against it. The seed decides which, so whether the
    image is the wider one, and a plan of 4 steps the shortest, or the narrower one, and 3 steps
    are enough.
    """
    draws = Draws("near ties", size, seed)
    corners = _tied_corners(draws)
    place = mpq(draws.whole(280, 350) if draws.sign() > 0 else draws.whole(600, 670), 1000)
    corners.insert(2, _beside(corners[1], corners[2], place, mpq(1, 2**size)))
    return Part(corners, name=f"near tie {size}, seed {seed}")


def _tied_corners(draws: Draws) -> list[Point]:
    return [
        (mpq(x + draws.whole(-_SHIFT, _SHIFT)), mpq(y + draws.whole(-_SHIFT, _SHIFT)))
        for x, y in _TIED
    ]


def _beside(start: Point, end: Point, along: mpq, out: mpq) -> Point:
    """Return the point at shares `along` and `out` of an edge, to its right: outside."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    return start[0] + along * dx + out * dy, start[1] + along * dy - out * dx


def near_parallel(size: int, seed: int) -> Part:
    """Return a rectangle without one corner, each side bent outwards by 2**-size.

    So each of its four sides is two edges that lie on one line but for about 2**-size, and are
    parallel to two others but for as much. One or two of those four are stable, and which depends
    on their order: a planner that joins edges, or takes a pair for parallel, loses a step about
    2**-size wide, or finds the wrong edge.
    """
    draws = Draws("near-parallel edges", size, seed)
    bend = mpq(1, 2**size)
    w, h, cut_x, cut_y = (draws.whole(20, 60) for _ in range(4))
    w, h = w + cut_x, h + cut_y
    x, y = (mpq(draws.whole(1, 9)) for _ in range(2))  # so that no two edges are parallel
    return Part(
        [
            (mpq(0), mpq(0)),
            (x + draws.whole(0, 1), -bend),
            (mpq(w), mpq(0)),
            (w + bend, y),
            (mpq(w), mpq(h - cut_y)),
            (mpq(w - cut_x), mpq(h)),
            (x, h + bend),
            (mpq(0), mpq(h)),
            (-bend, y + draws.whole(0, 1)),
        ],
        name=f"near-parallel edges {size}, seed {seed}",
    )


def near_symmetric(size: int, seed: int) -> Part:
    """Return a part that four quarter turns carry to itself, but for 10**-60 at one vertex.

    `size` is rounded up to a multiple of 4. The vertices stand on a circle, so every other pair of
    them is a longest diameter; the moved vertex is the end of one. The squeeze function has the
    period 180 degrees, and 90 degrees for a planner that rounds. Up to the last moment two arcs
    half a period apart look equally wide.
    """
    draws = Draws("near-symmetric parts", size, seed)
    quarter = -(-size // 4)
    corners = draws.around(4 * quarter)[:quarter]
    ring = list(corners)
    for _ in range(3):
        corners = [(-y, x) for x, y in corners]
        ring += corners
    moved = draws.whole(0, len(ring) - 1)
    x, y = ring[moved]
    slight = mpq(draws.sign(), 10**60)
    ring[moved] = x - slight * y, y + slight * x  # along the tangent
    return Part(ring, name=f"near-symmetric part {4 * quarter}, seed {seed}")
