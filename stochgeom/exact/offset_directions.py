"""Directions between whole points and one rational point, kept short.

The directions from a point with a long denominator to many whole points are whole vectors plus one
common small remainder. Written out they would be long integers, all of them; kept apart they stay
in int64, and the few that a decision needs are written out one by one.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, final, overload

import numpy as np
from gmpy2 import mpz
from numpy.typing import NDArray

from stochgeom.exact.angles import Angle, make_angle
from stochgeom.exact.predicates import IntArray, Signs, as_objects, dot_signs, sign
from stochgeom.exact.shadows import TWO_PI
from stochgeom.exact.vectors import AngleVector, FloatArray


@final
class OffsetDirections(AngleVector):
    """The arguments of the vectors (scale x_k + a, scale y_k + b).

    Parameters
    ----------
    whole_x, whole_y : int64 arrays
        The x_k and y_k, below 2**53, one of the two at least 2, all in absolute value.
    offset : (mpz, mpz)
        (a, b), at most scale / 2 in absolute value.
    scale : mpz
        Positive; any length.

    Notes
    -----
    The shadow keeps the bound that `stochgeom.exact.shadows` proves for other vectors: rounding
    a / scale moves a component by 2**-54 at most and the sum by 2**-53 of its size, so that a
    vector of length 3/2 or more turns by less than 2**-52.

    Examples
    --------
    >>> ahead = OffsetDirections(np.array([3]), np.array([4]), (mpz(-1), mpz(2)), mpz(10))
    >>> ahead[0]
    Angle(0, (29, 42))
    """

    def __init__(
        self, whole_x: IntArray, whole_y: IntArray, offset: tuple[mpz, mpz], scale: mpz
    ) -> None:
        self._whole, self._offset, self._scale = (whole_x, whole_y), offset, scale
        self.turn_parts = np.zeros(len(whole_x), dtype=np.int64)
        self._made: dict[int, Angle] = {}

    @cached_property
    def x(self) -> IntArray:  # type: ignore[override]
        """The first components written out; made only if somebody asks for all of them."""
        return self._written_out(0)

    @cached_property
    def y(self) -> IntArray:  # type: ignore[override]
        """The second components written out."""
        return self._written_out(1)

    @property
    def over_field(self) -> bool:
        """Whether some of the directions are irrational: no, and nothing is written out for it."""
        return False

    def _written_out(self, axis: int) -> IntArray:
        values: IntArray = as_objects(self._whole[axis]) * self._scale + self._offset[axis]
        return values

    def __len__(self) -> int:
        return len(self._whole[0])

    @overload
    def __getitem__(self, key: int) -> Angle: ...
    @overload
    def __getitem__(self, key: slice) -> AngleVector: ...
    def __getitem__(self, key: int | slice) -> Angle | AngleVector:
        if isinstance(key, slice):
            return self.take(key)
        angle = self._made.get(key)
        if angle is None:
            x, y = (
                self._scale * int(whole[key]) + offset
                for whole, offset in zip(self._whole, self._offset, strict=True)
            )
            angle = self._made[key] = make_angle(0, x, y)
        return angle

    def take(self, key: slice | NDArray[Any]) -> OffsetDirections:
        """Return the entries at a slice, a mask or an index array."""
        x, y = self._whole
        return OffsetDirections(x[key], y[key], self._offset, self._scale)

    @cached_property
    def _float_components(self) -> tuple[FloatArray, FloatArray]:
        x, y = (
            whole.astype(np.float64) + int(offset) / int(self._scale)
            for whole, offset in zip(self._whole, self._offset, strict=True)
        )
        return x, y

    @cached_property
    def shadow(self) -> FloatArray:
        """The values in radians, each within `error`; to filter with, never to choose."""
        x, y = self._float_components
        values: FloatArray = np.arctan2(y, x)
        # The offset is too small to change the sign of a whole component but zero.
        sign_x, sign_y = (
            np.where(whole == 0, sign(offset), np.sign(whole))
            for whole, offset in zip(self._whole, self._offset, strict=True)
        )
        lower = (sign_y < 0) | ((sign_y == 0) & (sign_x < 0))
        values[lower & (values <= 0)] += TWO_PI
        return values

    def dot_signs(self, ax: IntArray, ay: IntArray) -> Signs:
        """Return the sign of ``ax x + ay y`` entry by entry, for int64 arrays below 2**53."""
        x, y = self._float_components
        left, right = ax * x, ay * y
        values = left + right
        # Components are off by 2**-53 of their size and 2**-54; products and sum by 2**-53 each
        # of the sum of the sizes: less than half of this in all.
        margin = (np.abs(left) + np.abs(right) + np.abs(ax) + np.abs(ay)) * 2.0**-50
        signs: Signs = np.sign(values).astype(np.int8)
        (unclear,) = np.nonzero(np.abs(values) <= margin)
        if len(unclear):
            exact = self.take(unclear)
            signs[unclear] = dot_signs(ax[unclear], ay[unclear], exact.x, exact.y)
        return signs
