"""Exact values of the pieces of diameter and radius functions: |v| sin(theta + arg v)."""

from __future__ import annotations

from typing import Any

from stochgeom.errors import NotRationalError
from stochgeom.exact.algebraic import is_algebraic, simplified
from stochgeom.exact.algebraic_directions import direction_over
from stochgeom.exact.angles import Angle
from stochgeom.exact.fields import RealField
from stochgeom.exact.surds import Scalar
from stochgeom.geometry.points import Point


def squared_height(chord: Point, theta: Angle, what: str, field: RealField | None = None) -> Scalar:
    """Return the squared y-extent of a chord turned by theta.

    `field` is that of the part, of which the chord may show nothing.

    Raises
    ------
    NotRationalError
        If theta is no direction over the chord's field (such as 71 degrees over Q); `what` names
        the height.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> squared_height((mpq(1), mpq(0)), Angle(0, (1, 1)), "height")
    mpq(1,2)
    """
    direction = _direction(chord, theta, field)
    if direction is None:
        raise NotRationalError(
            f"the squared {what} at {theta} is no number of the part's field; accepted: "
            "directions over it"
        )
    (x, y), (vx, vy) = direction, chord
    return simplified((vx * y + vy * x) ** 2 / (x * x + y * y))


def _direction(chord: Point, theta: Angle, field: RealField | None) -> tuple[Any, Any] | None:
    x, y = theta.direction
    if theta.turn_part.denominator == 1:
        return x, y
    fields = [field, *(number.field for number in (*chord, x, y) if is_algebraic(number))]
    known = next((each for each in fields if each is not None), None)
    return None if known is None else direction_over(known, theta)
