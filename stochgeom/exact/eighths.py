"""Eighths of a turn: the only rational turns among directions over Q, folded in and out.

Pure integer arithmetic on directions (x, y); lengths may change, arguments may not.
"""

from __future__ import annotations

from typing import Any

from gmpy2 import mpq

from stochgeom.exact.predicates import compare_arguments, half_plane


def fold(t: Any, x: Any, y: Any) -> tuple[Any, Any, Any]:
    """Move the eighths of a turn to the side where the canonical form of an angle keeps them.

    Examples
    --------
    >>> fold(mpq(3, 8), 1, 0), fold(mpq(1, 3), 0, 1)
    ((0, -1, 1), (mpq(7,12), 1, 0))
    """
    t = mpq(t)
    if 8 % t.denominator == 0:
        eighths = int(t * 8)
        whole, quarter_eighths = divmod(eighths, 8)
        turned_x, turned_y = turn_eighths(x, y, quarter_eighths)
        whole += compare_arguments(turned_x, turned_y, x, y) < 0
        return whole, turned_x, turned_y
    folded, x, y = octant(x, y)
    return t + mpq(folded, 8), x, y


def turn_eighths(x: Any, y: Any, eighths: int) -> tuple[Any, Any]:
    """Turn a direction by 0 to 7 eighths of a turn (its length may change)."""
    if eighths & 4:
        x, y = -x, -y
    if eighths & 2:
        x, y = -y, x
    if eighths & 1:
        x, y = x - y, x + y
    return x, y


def divide_by_eighths(t: int, x: Any, y: Any, share: int) -> tuple[int, Any, Any]:
    """Return the quotient by 1, 2, 4 or 8 eighths of a turn, and the direction that is left.

    Examples
    --------
    >>> divide_by_eighths(1, 0, -1, 4)
    (3, 0, 1)
    """
    place = octant_of(x, y)
    return (8 * t + place) // share, *turn_eighths(x, y, -(place - place % share) % 8)


def octant(x: Any, y: Any) -> tuple[int, Any, Any]:
    """Return k and the direction turned back by k eighths so that its arg is in [0, 45)."""
    k = 0
    if half_plane(x, y):
        k, x, y = 4, -x, -y
    if x <= 0:
        k, x, y = k + 2, y, -x
    if y >= x:
        k, x, y = k + 1, x + y, y - x
    return k, x, y


def octant_of(x: Any, y: Any) -> int:
    """Return floor(arg(x + i y) / 45 degrees), 0 to 7.

    Examples
    --------
    >>> octant_of(3, 2), octant_of(1, 1), octant_of(1, -5)
    (0, 1, 6)
    """
    return octant(x, y)[0]


def eighths_of(x: Any, y: Any) -> int | None:
    """Return k if arg(x + i y) is k eighths of a turn, else None.

    Examples
    --------
    >>> eighths_of(-3, 3), eighths_of(3, 2)
    (3, None)
    """
    if x and y and abs(x) != abs(y):
        return None
    return octant(x, y)[0]
