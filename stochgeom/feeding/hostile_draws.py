"""Reproducible draws for hostile parts: whole numbers, circle points, hulls.

The same family, size and seed give the same part on every machine and with every version of
Python: the only source is ``Random.random`` seeded by text, whose sequence Python guarantees, and
from there on all arithmetic is exact.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from random import Random
from typing import final

from gmpy2 import f_divmod, mpq, mpz

from stochgeom.errors import InvalidPartError
from stochgeom.geometry.hull import convex_hull
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Points

Point = tuple[mpq, mpq]

_BITS = 53
_DIGITS = 9


@final
class Draws:
    """Whole numbers drawn one after the other, the same for the same words.

    Examples
    --------
    >>> Draws("needles", 7, 0).whole(1, 6) == Draws("needles", 7, 0).whole(1, 6)
    True
    """

    def __init__(self, family: str, size: int, seed: int) -> None:
        self._random = Random(f"{family}, size {size}, seed {seed}")

    def whole(self, low: int, high: int) -> int:
        """Return a whole number from `low` to `high`, at most 2**53 of them."""
        fraction = int(self._random.random() * 2**_BITS)  # exact: random() is a multiple of 2**-53
        return low + (fraction * (high - low + 1) >> _BITS)

    def sign(self) -> int:
        """Return 1 or -1."""
        return 2 * self.whole(0, 1) - 1

    def long(self, digits: int) -> mpz:
        """Return a whole number of so many decimal digits."""
        text = str(self.whole(1, 9))
        while len(text) < digits:
            text += f"{self.whole(0, 10**_DIGITS - 1):0{_DIGITS}d}"
        return mpz(text[:digits])

    def around(self, count: int, grid: int = 1024) -> list[Point]:
        """Return `count` >= 3 points on the unit circle, counter-clockwise, the centre inside.

        One in each of `count` equal stretches of a parameter, never at its far end, so that no
        two neighbours are half a turn apart.
        """
        steps = [k * grid + self.whole(0, grid * 2 // 5) for k in range(count)]
        return [circle_point(mpq(4 * step, count * grid)) for step in steps]


def circle_point(u: mpq) -> Point:
    """Return a rational point of the unit circle; u = 0, 1, 2, 3 are the ends of the axes.

    Examples
    --------
    >>> circle_point(mpq(1, 2)), circle_point(mpq(3))
    ((mpq(3,5), mpq(4,5)), (mpq(0,1), mpq(-1,1)))
    """
    quarters, rest = f_divmod(u.numerator, u.denominator)
    t = mpq(rest, u.denominator)
    x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarters % 4):
        x, y = -y, x
    return x, y


def hull_part(points: Sequence[Point], name: str) -> Part:
    """Return the convex hull of some points as a part."""
    corners = convex_hull(Points.from_pairs(points)).indices
    return Part([points[int(k)] for k in corners], name=name)


def first_hull(draw: Callable[[], Sequence[Point]], name: str) -> Part:
    """Draw points until they are not all on one line, and return their hull."""
    while True:
        try:
            return hull_part(draw(), name)
        except InvalidPartError:
            continue


def multiplied(points: Iterable[Point], a: int, b: int, c: int, d: int) -> list[Point]:
    """Return points mapped by the matrix ((a, b), (c, d))."""
    return [(a * x + b * y, c * x + d * y) for x, y in points]
