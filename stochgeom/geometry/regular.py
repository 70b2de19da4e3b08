"""Regular polygons with exact coordinates in a real algebraic field."""

from __future__ import annotations

import operator
from typing import SupportsIndex

from gmpy2 import mpq

from stochgeom.errors import InputError, TooFewVerticesError
from stochgeom.exact.algebraic import make_algebraic, simplified
from stochgeom.exact.fields import regular_polygon_field
from stochgeom.geometry.points import Point


def regular_polygon(n: SupportsIndex) -> list[Point]:
    """Return (cos(2 pi k / n), sin(2 pi k / n)) for k = 0, ..., n - 1.

    Raises
    ------
    TooFewVerticesError
        If n is below 3.

    Examples
    --------
    >>> [(str(x), str(y)) for x, y in regular_polygon(3)][1]
    ('-1/2', '1/2*sqrt(3)')
    """
    try:
        count = operator.index(n)
    except TypeError:
        raise InputError(
            f"a regular polygon of {n!r:.40} vertices; accepted: whole numbers"
        ) from None
    if count < 3:
        raise TooFewVerticesError(f"a regular polygon of {count} vertices; accepted: 3 or more")
    field = regular_polygon_field(count)
    if field is None:
        return [(mpq(x), mpq(y)) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    # The n-gon's turns are among those of L(i)'s roots of unity, of which there are w.
    step = field.unity // count
    parts = [field.unity_parts(k * step) for k in range(count)]
    return [
        (simplified(make_algebraic(field, *x)), simplified(make_algebraic(field, *y)))
        for x, y in parts
    ]
