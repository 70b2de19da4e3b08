"""The signs everything else is decided by, for one pair of vectors or for arrays of them.

Nothing outside this module decides a sign, but `stochgeom.exact.forms` for sums of angles and
`stochgeom.geometry.sweep_order` for the side of a line it has stored.

Scalar predicates compute with unbounded integers. The array predicates take int64 or object
arrays; on int64 arrays with entries below 2**53 they are exact without any unbounded integer:

    Let p = fl(a d) and q = fl(b c) be the correctly rounded float64 products of integers that
    float64 holds exactly. Rounding is monotone, so p > q implies a d > b c. If p = q, the exact
    products both round to p, so they differ by at most one unit in the last place of p; entries
    below 2**53 give |p| <= 2**106, whose last place is at most 2**54. A difference that small is
    exact in wrapping 64-bit arithmetic, where only the final value must fit.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any, Final, TypeAlias

import numpy as np
from gmpy2 import mpz
from numpy.typing import NDArray

IntArray: TypeAlias = "NDArray[Any]"
"""An int64 array, or an object array of unbounded integers."""

Signs: TypeAlias = NDArray[np.int8]
"""An array of -1, 0 and 1."""

HomogeneousPoint: TypeAlias = "tuple[mpz, mpz, mpz]"
"""(X, Y, W) with W > 0 stands for the point (X / W, Y / W)."""

EXACT_FLOAT_LIMIT: Final = 2**53
"""Integers below this in absolute value are exact in float64."""

_INT64: Final = np.dtype(np.int64)
_SHORT: Final = 256


class Turn(IntEnum):
    """Which way a path p -> q -> r turns at q."""

    RIGHT = -1
    STRAIGHT = 0
    LEFT = 1


_TURNS = (Turn.STRAIGHT, Turn.LEFT, Turn.RIGHT)  # by sign; -1 is the last


def sign(value: Any) -> int:
    """Return -1, 0 or 1 for an exact number.

    Examples
    --------
    >>> sign(-7), sign(0), sign(3)
    (-1, 0, 1)
    """
    return bool(value > 0) - bool(value < 0)


def cross_sign(ax: Any, ay: Any, bx: Any, by: Any) -> int:
    """Return the sign of ``ax by - ay bx``: 1 when b lies counter-clockwise of a.

    Examples
    --------
    >>> cross_sign(1, 0, 0, 1), cross_sign(1, 2, 2, 4)
    (1, 0)
    """
    left, right = ax * by, ay * bx
    return bool(left > right) - bool(left < right)


def dot_sign(ax: Any, ay: Any, bx: Any, by: Any) -> int:
    """Return the sign of ``ax bx + ay by``: 0 when a and b are perpendicular.

    Examples
    --------
    >>> dot_sign(1, 0, 0, 1), dot_sign(1, 2, -1, 0)
    (0, -1)
    """
    left, right = ax * bx, -ay * by
    return bool(left > right) - bool(left < right)


def half_plane(x: Any, y: Any) -> int:
    """Return 0 for directions with argument in [0, 180) degrees and 1 for the rest.

    Examples
    --------
    >>> half_plane(1, 0), half_plane(-1, 0)
    (0, 1)
    """
    return 0 if y > 0 or (y == 0 and x > 0) else 1


def compare_arguments(ax: Any, ay: Any, bx: Any, by: Any) -> int:
    """Compare arg(a) with arg(b), both in [0, 360) degrees: -1 less, 0 equal, 1 greater.

    Examples
    --------
    >>> compare_arguments(1, 0, 0, -1), compare_arguments(2, 2, 1, 1)
    (-1, 0)
    """
    difference = half_plane(ax, ay) - half_plane(bx, by)
    return difference or -cross_sign(ax, ay, bx, by)


def orientation(p: HomogeneousPoint, q: HomogeneousPoint, r: HomogeneousPoint) -> Turn:
    """Return which way p -> q -> r turns; homogeneous points, one denominator each.

    Examples
    --------
    >>> orientation((0, 0, 1), (1, 0, 1), (1, 1, 2))
    <Turn.LEFT: 1>
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    return _TURNS[
        cross_sign(qx * pw - px * qw, qy * pw - py * qw, rx * pw - px * rw, ry * pw - py * rw)
    ]


def compare_points(p: HomogeneousPoint, q: HomogeneousPoint) -> int:
    """Compare by x, then by y: -1 less, 0 equal, 1 greater.

    Examples
    --------
    >>> compare_points((1, 0, 2), (1, 0, 3)), compare_points((1, 1, 1), (2, 2, 2))
    (1, 0)
    """
    return cross_sign(p[0], p[2], q[0], q[2]) or cross_sign(p[1], p[2], q[1], q[2])


# --- arrays --------------------------------------------------------------------------------------


def fits_float(*arrays: IntArray) -> bool:
    """Tell whether all entries are int64 and below 2**53 in absolute value."""
    if any(array.dtype != _INT64 for array in arrays):
        return False
    if arrays[0].size < _SHORT:
        arrays = (np.concatenate(arrays),)  # one look at all of them, where calls cost most
    return all(
        array.size == 0
        or (int(array.max()) < EXACT_FLOAT_LIMIT and int(array.min()) > -EXACT_FLOAT_LIMIT)
        for array in arrays
    )


def cross_signs(ax: IntArray, ay: IntArray, bx: IntArray, by: IntArray) -> Signs:
    """Return the sign of ``ax by - ay bx`` entry by entry.

    Examples
    --------
    >>> import numpy as np
    >>> cross_signs(*np.array([[1, 2], [0, 1], [0, 4], [1, 2]]))
    array([1, 0], dtype=int8)
    """
    if fits_float(ax, ay, bx, by):
        return _signs_of_differences(ax, by, ay, bx)
    ax, ay, bx, by = map(as_objects, (ax, ay, bx, by))
    return _signs_of_objects(ax * by - ay * bx)


def dot_signs(ax: IntArray, ay: IntArray, bx: IntArray, by: IntArray) -> Signs:
    """Return the sign of ``ax bx + ay by`` entry by entry.

    Examples
    --------
    >>> import numpy as np
    >>> dot_signs(*np.array([[1, 1], [0, 2], [0, 4], [1, -2]]))
    array([0, 0], dtype=int8)
    """
    if fits_float(ax, ay, bx, by):
        return _signs_of_differences(ax, bx, -ay, by)
    ax, ay, bx, by = map(as_objects, (ax, ay, bx, by))
    return _signs_of_objects(ax * bx + ay * by)


def _signs_of_differences(a: IntArray, b: IntArray, c: IntArray, d: IntArray) -> Signs:
    """Return the signs of ``a b - c d`` for entries that `fits_float` lets pass."""
    signs: Signs = np.sign(a.astype(np.float64) * b - c.astype(np.float64) * d).astype(np.int8)
    # The float products decide wherever they differ; see the proof in the module docstring.
    (tied,) = np.nonzero(signs == 0)
    if tied.size:
        signs[tied] = np.sign(a[tied] * b[tied] - c[tied] * d[tied])
    return signs


def _signs_of_objects(values: IntArray) -> Signs:
    return (values > 0).astype(np.int8) - (values < 0).astype(np.int8)


def half_planes(x: IntArray, y: IntArray) -> NDArray[np.bool_]:
    """Return False for arguments in [0, 180) degrees and True for the rest, entry by entry."""
    lower: NDArray[np.bool_] = (y < 0) | ((y == 0) & (x < 0))
    return lower.astype(np.bool_)


def as_objects(array: IntArray) -> IntArray:
    """Return the array with unbounded integers (`mpz`) as entries."""
    if array.dtype == object:
        return array
    result = np.empty(array.shape, dtype=object)
    result[:] = [mpz(value) for value in array.tolist()]
    return result
