"""Hostile parts of extreme form: huge and tiny, thin, round, random, collinear, not convex.

See `stochgeom.feeding.adversarial`.
"""

from __future__ import annotations

from gmpy2 import mpq, mpz

from stochgeom.feeding.hostile_draws import (
    Draws,
    Point,
    circle_point,
    first_hull,
    hull_part,
    multiplied,
)
from stochgeom.geometry.part import Part

_FINE = 10**6


def random_hulls(size: int, seed: int) -> Part:
    """Return the hull of `size` random points in the unit square, with 6 decimals.

    With 10 points the parts that the source's experiments are about (4.8, 5.9): 5.9 sides on
    average.
    """
    draws = Draws("random hulls", size, seed)
    return first_hull(
        lambda: [(_share(draws), _share(draws)) for _ in range(size)],
        f"random hull {size}, seed {seed}",
    )


def _share(draws: Draws) -> mpq:
    """Return a number from 0 to 1 with 6 decimals."""
    return mpq(draws.whole(0, _FINE), _FINE)


def huge_coordinates(size: int, seed: int) -> Part:
    """Return the hull of 8 points that differ in the last `size` of twice as many digits.

    Where the first half fills a float, from size 17 on, all points are one to a planner that
    rounds; from size 155 on, no float holds a coordinate.
    """
    draws = Draws("huge coordinates", size, seed)
    x, y = (draws.sign() * draws.long(2 * size) for _ in range(2))
    return first_hull(
        lambda: [(mpq(x + draws.long(size)), mpq(y + draws.long(size))) for _ in range(8)],
        f"huge coordinates {size}, seed {seed}",
    )


def tiny_coordinates(size: int, seed: int) -> Part:
    """Return the hull of 8 points close to the origin, their denominators of `size` digits.

    No two coordinates share a denominator: a common one has up to 16 times as many digits. From
    some 150 digits on, products of coordinates vanish in floats.
    """
    draws = Draws("tiny coordinates", size, seed)
    return first_hull(
        lambda: [
            (_signed(draws, draws.long(size)), _signed(draws, draws.long(size))) for _ in range(8)
        ],
        f"tiny coordinates {size}, seed {seed}",
    )


def _signed(draws: Draws, denominator: mpz) -> mpq:
    return mpq(draws.whole(-999, 999), denominator)


def collinear_points(size: int, seed: int) -> Part:
    """Return a quadrilateral with `size` vertices, all but 4 in the middle of its edges.

    They stand at random thirds, sevenths, ... of the edges, some two of them on one point. Only
    exact arithmetic sees that they are no corners; a corner too many is an edge too many, and
    edges on one line are stable together or not at all.
    """
    draws = Draws("collinear points", size, seed)
    corners = multiplied(
        [(mpq(x), mpq(y)) for x, y in ((0, 0), (60, -7), (70, 50), (-9, 41))],
        draws.whole(20, 99),
        draws.whole(-9, 9),
        draws.whole(-9, 9),
        draws.whole(20, 99),
    )
    extra: list[list[mpq]] = [[], [], [], []]
    for _ in range(size - 4):
        bottom = draws.whole(3, 9)
        extra[draws.whole(0, 3)].append(mpq(draws.whole(1, bottom - 1), bottom))
    outline = []
    for k, shares in enumerate(extra):
        (ax, ay), (bx, by) = corners[k], corners[k - 3]
        outline += [(ax + t * (bx - ax), ay + t * (by - ay)) for t in (mpq(0), *sorted(shares))]
    return Part(outline, name=f"collinear points {size}, seed {seed}")


def slivers(size: int, seed: int) -> Part:
    """Return a rod about 2**size times as long as wide, with blunt ends, turned at random.

    Edges of its ends are stable, and nearly all maximal diameters join the ends: breaks and values
    crowd within 2**-size, and all steps but one or two are tiny beside these.
    """
    draws = Draws("slivers", size, seed)
    a, b = draws.whole(1, 99), draws.whole(1, 99)
    thin = mpq(1, 2**size)
    rod = [
        (end + thin * thin * mpq(draws.whole(0, 9), 10), thin * draws.whole(10 * k, 10 * k + 9))
        for end in (-100, 100)
        for k in range(4)
    ]
    return hull_part(multiplied(rod, a, -b, b, a), f"sliver {size}, seed {seed}")


def needles(size: int, seed: int) -> Part:
    """Return a sector of a circle with `size` vertices, a million times as long as wide.

    The tip is exactly as far from every other vertex, so all edges are stable, and all maxima of
    the diameter but one are equal. Two steps share half a turn but for a millionth; the others
    share that.
    """
    draws = Draws("needles", size, seed)
    tip = draws.whole(0, 99), draws.whole(0, 99)
    grid = 1000 * (size - 1)
    places = [1000 * k + draws.whole(-300, 300) for k in range(size - 1)]
    blunt_end = [circle_point(mpq(2000 * grid + place, 2_000_000 * grid)) for place in places]
    return Part(
        [(tip[0] + x, tip[1] + y) for x, y in ((mpq(0), mpq(0)), *blunt_end)],
        name=f"needle {size}, seed {seed}",
    )


def constant_width(size: int, seed: int) -> Part:
    """Return a part of `size` vertices like a Reuleaux triangle: nearly every edge is stable.

    Three arcs of rational circle points, each about the corner across. Between two points of an
    arc the diameter is smallest where their chord lies flush, across the corner, and exactly as
    large at one point as at the next: most maxima of the diameter are equal, and minima differ
    from them by little.
    """
    draws = Draws("Reuleaux-like parts", size, seed)
    # Tangents of a quarter and of half the angle at the first corner, of about 60 degrees. The
    # third corner is exactly at distance 1 from the first, and nearly so from the second.
    quarter = mpq(draws.whole(2_679_400, 2_679_600), 10**7)
    half = 2 * quarter / (1 - quarter * quarter)
    corners = [(mpq(0), mpq(0)), (mpq(1), mpq(0)), circle_point(half)]
    # Parameters of the directions from each corner to the two others.
    arcs = ((mpq(0), half), (1 + quarter, mpq(2)), (2 + half, 3 + quarter))
    outline: list[Point] = []
    for k, ((cx, cy), (low, high)) in enumerate(zip(corners, arcs, strict=True)):
        count = (size + 2 - k) // 3
        outline.append(corners[k - 2])
        for j in range(1, count):
            share = (j + mpq(draws.whole(-300, 300), 1000)) / count
            x, y = circle_point(low + share * (high - low))
            outline.append((cx + x, cy + y))
    return Part(outline, name=f"Reuleaux-like part {size}, seed {seed}")


def stars(size: int, seed: int) -> Part:
    """Return a star-shaped outline of `size` vertices at random distances from the origin.

    Nearly always not convex: hull vertices are numbered differently from those of the outline,
    and most vertices never touch a jaw.
    """
    draws = Draws("star-shaped outlines", size, seed)
    reach = [mpq(draws.whole(100, 1000)) for _ in range(size)]
    points = draws.around(size)
    return Part(
        [(r * x, r * y) for r, (x, y) in zip(reach, points, strict=True)],
        name=f"star {size}, seed {seed}",
    )


def spirals(size: int, seed: int) -> Part:
    """Return a spiral corridor of `size` vertices, or one less if that is odd, sheared at random.

    Few of its vertices are on the hull, and the outline winds around them many times: a hull in
    one pass over the outline, or a test for crossings that looks at neighbours, goes wrong.
    """
    draws = Draws("spirals", size, seed)
    arms = size // 2 - 1
    lengths = [20, 25]
    while len(lengths) < arms:
        lengths.append(lengths[-2] + draws.whole(5, 15))  # the corridor is 2 wide
    middle, ways = [(0, 0)], [((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4] for k in range(arms)]
    for (dx, dy), length in zip(ways, lengths, strict=False):
        middle.append((middle[-1][0] + length * dx, middle[-1][1] + length * dy))
    left: list[Point] = []
    right: list[Point] = []
    for k, (x, y) in enumerate(middle):
        # At a corner the sides are shifted along both arms, at an end along one.
        touching = ways[max(k - 1, 0) : k + 1]
        sx, sy = -sum(dy for _, dy in touching), sum(dx for dx, _ in touching)
        left.append((mpq(x + sx), mpq(y + sy)))
        right.append((mpq(x - sx), mpq(y - sy)))
    a, b, c = draws.whole(5, 20), draws.whole(-4, 4), draws.whole(-4, 4)
    outline = multiplied([*right, *left[::-1]], a, b, c, draws.whole(5, 20))
    return Part(outline, name=f"spiral {2 * arms + 2}, seed {seed}")
