"""Arrays of exact rational points.

Integers with one common denominator where that stays small, homogeneous coordinates with a
denominator per point where it would not: 99 rational points of a circle have a common
denominator of thousands of bits, while their own have a few dozen each.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final, TypeAlias, final

import numpy as np
from gmpy2 import mpq, mpz
from numpy.typing import NDArray

from stochgeom.errors import FloatRefusedError, InvalidPartError, NumberError
from stochgeom.exact.algebraic import Algebraic, is_algebraic, simplified
from stochgeom.exact.fields import RealField
from stochgeom.exact.predicates import HomogeneousPoint, IntArray, as_objects
from stochgeom.exact.scalars import common_denominator, is_pair
from stochgeom.exact.surds import ScalarLike, common_field, exact_scalar, scalar_to_float

Point: TypeAlias = "tuple[Any, Any]"
"""An exact point of the plane: rational coordinates, or irrational ones of one field."""

PointLike: TypeAlias = "Sequence[ScalarLike]"
"""A pair of anything `exact_scalar` takes."""

_INT64_LIMIT: Final = 2**52
"""Below this the difference of two coordinates is exact in float64 as well as in int64."""


@final
@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """The points (x_k / w_k, y_k / w_k), or (x_k / scale, y_k / scale) where w is None.

    Irrational coordinates are numbers of one field, with denominators of their own: then w is None
    and the scale 1.
    """

    x: IntArray
    y: IntArray
    w: IntArray | None
    scale: mpz

    @classmethod
    def from_pairs(cls, pairs: Iterable[PointLike] | NDArray[Any], what: str = "vertex") -> Points:
        """Read points exactly; an (n, 2) integer array is taken over without a Python loop.

        Raises
        ------
        NumberError
            For anything that is not a pair of exact numbers, naming ``what`` and its place.
        """
        if isinstance(pairs, np.ndarray):
            if np.issubdtype(pairs.dtype, np.floating):
                raise FloatRefusedError(
                    f"an array of {pairs.dtype} holds binary floats; accepted: an integer array, "
                    "or pairs of int, Fraction, Decimal or text",
                    where=f"{what} array",
                )
            if np.issubdtype(pairs.dtype, np.integer):
                return cls._from_array(pairs, what)
            pairs = pairs.tolist()
        values = [_pair(pair, f"{what} {k}") for k, pair in enumerate(_listed(pairs, what))]
        flat = [number for pair in values for number in pair]
        field = common_field(flat, lambda k: f"{what} {k // 2}, {'xy'[k % 2]}")
        return cls.from_rationals(values) if field is None else cls._from_field(values, field)

    @classmethod
    def _from_field(cls, values: Sequence[Point], field: RealField) -> Points:
        one = Algebraic(field, [1])
        xs, ys = ([pair[k] * one for pair in values] for k in (0, 1))
        return cls(_objects(xs), _objects(ys), None, mpz(1))

    @classmethod
    def from_rationals(cls, values: Sequence[Point]) -> Points:
        """Gather points of `mpq` coordinates."""
        denominators = [common_denominator([x, y]) for x, y in values]
        widest = max((d.bit_length() for d in denominators), default=1)
        shared = common_denominator([mpq(1, d) for d in set(denominators)])
        if shared.bit_length() <= max(64, 2 * widest):
            xs = [(x * shared).numerator for x, _ in values]
            ys = [(y * shared).numerator for _, y in values]
            return cls(*_int_arrays(xs, ys), None, shared)
        xs = [(x * d).numerator for (x, _), d in zip(values, denominators, strict=True)]
        ys = [(y * d).numerator for (_, y), d in zip(values, denominators, strict=True)]
        return cls(_objects(xs), _objects(ys), _objects(denominators), mpz(1))

    @classmethod
    def _from_array(cls, array: NDArray[Any], what: str) -> Points:
        if array.ndim != 2 or array.shape[1] != 2:
            raise InvalidPartError(
                f"an array of shape {array.shape}; accepted: shape (n, 2)", where=f"{what} array"
            )
        if array.size and (int(array.max()) >= _INT64_LIMIT or int(array.min()) <= -_INT64_LIMIT):
            xs, ys = ([mpz(v) for v in column.tolist()] for column in array.T)
            return cls(_objects(xs), _objects(ys), None, mpz(1))
        columns = array.astype(np.int64).T
        return cls(np.ascontiguousarray(columns[0]), np.ascontiguousarray(columns[1]), None, mpz(1))

    def __len__(self) -> int:
        return len(self.x)

    @property
    def over_field(self) -> bool:
        """Whether the coordinates are numbers of a field rather than integers."""
        return self.x.dtype == object and len(self.x) > 0 and is_algebraic(self.x[0])

    def take(self, indices: NDArray[Any]) -> Points:
        """Return the points at the given indices."""
        w = None if self.w is None else self.w[indices]
        return Points(self.x[indices], self.y[indices], w, self.scale)

    def point(self, k: int) -> Point:
        """Return point k as a pair of rationals."""
        if self.over_field:
            return simplified(self.x[k]), simplified(self.y[k])
        w = self.scale if self.w is None else self.w[k]
        return mpq(mpz(int(self.x[k])), w), mpq(mpz(int(self.y[k])), w)

    def pairs(self) -> tuple[Point, ...]:
        """Return all points as pairs of rationals."""
        return tuple(self.point(k) for k in range(len(self)))

    def homogeneous(self) -> list[HomogeneousPoint]:
        """Return (X, Y, W) for each point, up to one common scale."""
        xs, ys = (as_objects(values).tolist() for values in (self.x, self.y))
        ws = [mpz(1)] * len(xs) if self.w is None else self.w.tolist()
        return list(zip(xs, ys, ws, strict=True))

    def vectors(self, tails: NDArray[Any], heads: NDArray[Any]) -> tuple[IntArray, IntArray]:
        """Return head minus tail for pairs of points, each up to a positive factor.

        Signs of crosses and dots, and arguments, do not notice the factor.
        """
        if self.w is None:
            return self.x[heads] - self.x[tails], self.y[heads] - self.y[tails]
        x, y, w = self.x, self.y, self.w
        return (
            x[heads] * w[tails] - x[tails] * w[heads],
            y[heads] * w[tails] - y[tails] * w[heads],
        )

    def to_float(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return coordinates as floats, each correctly rounded, for plots."""
        if self.w is None and self.x.dtype != object and self.scale == 1:
            return self.x.astype(np.float64), self.y.astype(np.float64)
        pairs = self.pairs()
        return (
            np.array([scalar_to_float(x) for x, _ in pairs]),
            np.array([scalar_to_float(y) for _, y in pairs]),
        )


def homogeneous_point(x: Any, y: Any) -> HomogeneousPoint:
    """Return a point as (X, Y, W): integers over a denominator, or numbers of a field over 1."""
    if is_algebraic(x) or is_algebraic(y):
        return x, y, mpz(1)
    w = common_denominator([x, y])
    return (x * w).numerator, (y * w).numerator, w


def as_point(value: PointLike, where: str) -> Point:
    """Read one point exactly; `where` names it in errors."""
    return _pair(value, where)


def _listed(pairs: Iterable[PointLike], what: str) -> list[PointLike]:
    try:
        return list(pairs)
    except TypeError:
        raise NumberError(
            f"{pairs!r:.60} is not a list of points; accepted: pairs of exact numbers",
            where=f"{what} list",
        ) from None


def _pair(value: PointLike, where: str) -> Point:
    if not is_pair(value):
        raise NumberError(
            f"{value!r:.60} is not a pair of numbers; accepted: (x, y) with exact x and y",
            where=where,
        )
    x, y = value
    return exact_scalar(x, where=f"{where}, x"), exact_scalar(y, where=f"{where}, y")


def _int_arrays(xs: list[mpz], ys: list[mpz]) -> tuple[IntArray, IntArray]:
    if all(-_INT64_LIMIT < v < _INT64_LIMIT for values in (xs, ys) for v in values):
        return (
            np.array([int(v) for v in xs], dtype=np.int64),
            np.array([int(v) for v in ys], dtype=np.int64),
        )
    return _objects(xs), _objects(ys)


def _objects(values: Sequence[mpz]) -> IntArray:
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array
