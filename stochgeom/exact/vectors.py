"""Arrays of exact angles, with a float64 shadow that may filter and never choose.

An `AngleVector` holds turns and directions as arrays (int64, or unbounded integers as objects),
not reduced; a canonical `Angle` is made only when an entry is asked for.

The shadow is the value in radians as float64; `stochgeom.exact.shadows` proves its error bound.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, overload

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.errors import FloatRefusedError, NumberError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import Angle, make_angle
from stochgeom.exact.predicates import (
    EXACT_FLOAT_LIMIT,
    IntArray,
    as_objects,
    cross_signs,
    fits_float,
    half_planes,
)
from stochgeom.exact.shadows import ERROR_PER_TURN, TWO_PI, float_direction

FloatArray = NDArray[np.float64]


class AngleVector(Sequence[Angle]):
    """A sequence of exact angles held in arrays.

    Parameters
    ----------
    turns : int64 array, or object array of rationals
        The turn parts.
    x, y : int64 arrays, or object arrays of integers or of numbers of one field
        The directions, none of them (0, 0).

    Raises
    ------
    FloatRefusedError
        For arrays of floats.

    Examples
    --------
    >>> vector = AngleVector.from_angles([Angle.from_degrees(45), Angle.from_degrees(370)])
    >>> vector[1]
    Angle('37/36', (1, 0))
    >>> vector.to_float().round(3).tolist()
    [0.785, 6.458]
    """

    def __init__(self, turns: IntArray, x: IntArray, y: IntArray) -> None:
        self.turn_parts, self.x, self.y = _exact(turns), _exact(x), _exact(y)
        self._made: dict[int, Angle] = {}  # entries asked for so far

    @classmethod
    def from_directions(cls, x: IntArray, y: IntArray) -> AngleVector:
        """Return the arguments of directions, in [0, 360) degrees."""
        return cls(np.zeros(len(x), dtype=np.int64), x, y)

    @classmethod
    def from_angles(cls, angles: Iterable[Angle]) -> AngleVector:
        """Gather angles; int64 where all numbers are small enough for it."""
        listed = list(angles)
        directions = [angle.direction for angle in listed]
        vector = cls(
            _int_array([angle.turn_part for angle in listed]),
            _int_array([x for x, _ in directions]),
            _int_array([y for _, y in directions]),
        )
        vector._made.update(enumerate(listed))
        return vector

    # --- as a sequence ---------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self.x)

    @overload
    def __getitem__(self, key: int) -> Angle: ...
    @overload
    def __getitem__(self, key: slice) -> AngleVector: ...
    def __getitem__(self, key: int | slice) -> Angle | AngleVector:
        if isinstance(key, slice):
            return self.take(key)
        cached = self._made.get(key)
        if cached is not None:
            return cached
        turn = self.turn_parts[key]
        t = int(turn) if self.turn_parts.dtype != object or turn.denominator == 1 else mpq(turn)
        x, y = self.x[key], self.y[key]
        if not (is_algebraic(x) or is_algebraic(y)):
            x, y = int(x), int(y)
        angle = self._made[key] = make_angle(t, x, y)
        return angle

    def __iter__(self) -> Iterator[Angle]:
        return iter(self.angles)

    @cached_property
    def angles(self) -> tuple[Angle, ...]:
        """All entries as canonical angles, made on first use."""
        return tuple(self[k] for k in range(len(self)))

    @property
    def over_field(self) -> bool:
        """Whether some of the directions are irrational."""
        return self.x.dtype == object and any(map(is_algebraic, (*self.x, *self.y)))

    def count_at_most(self, theta: Angle) -> int:
        """Return how many entries of an increasing vector are at most theta.  O(log n)."""
        low, high = 0, len(self)
        while low < high:
            middle = (low + high) // 2
            if self[middle] <= theta:
                low = middle + 1
            else:
                high = middle
        return low

    def take(self, key: slice | NDArray[Any]) -> AngleVector:
        """Return the entries at a slice, a mask or an index array."""
        return AngleVector(self.turn_parts[key], self.x[key], self.y[key])

    @staticmethod
    def concatenate(vectors: Sequence[AngleVector]) -> AngleVector:
        """Return the entries of all vectors, one after the other."""
        return AngleVector(
            _join([v.turn_parts for v in vectors]),
            _join([v.x for v in vectors]),
            _join([v.y for v in vectors]),
        )

    def __repr__(self) -> str:
        return f"AngleVector.from_angles({list(self.angles)!r})"

    # --- arithmetic ------------------------------------------------------------------------------

    def rotate(self, angle: Angle) -> AngleVector:
        """Return every entry plus `angle`.

        Examples
        --------
        >>> vector = AngleVector.from_angles([Angle(0, (0, -1))]).rotate(Angle(0, (0, 1)))
        >>> vector[0]
        Angle(1, (1, 0))
        """
        ax, ay = angle.direction
        x, y = _product(self.x, self.y, ax, ay)
        # The argument of a product passes a full turn exactly if it is smaller than a factor's:
        # by half a turn, or none, if the factor is in the lower half plane, or never.
        passes = (
            half_planes(self.x, self.y) & bool(ax < 0)
            if ay == 0
            else _arguments_below(x, y, self.x, self.y)
        )
        carry = passes.astype(np.int64)
        turn, old = angle.turn_part, self.turn_parts
        # Turns below 2**53 cannot overflow, and a sum beyond is unbounded from the next one on.
        if turn.denominator != 1 or abs(turn) >= EXACT_FLOAT_LIMIT or not fits_float(old):
            return AngleVector(as_objects(old) + turn + carry, x, y)
        return AngleVector(old + int(turn) + carry, x, y)

    def equals(self, other: AngleVector) -> bool:
        """Tell whether all entries are exactly equal.  O(n)."""
        if len(self) != len(other):
            return False
        if self.turn_parts.dtype == object or other.turn_parts.dtype == object:
            return self.angles == other.angles
        ax, ay, bx, by = self.x, self.y, other.x, other.y
        apart = _arguments_below(ax, ay, bx, by) | _arguments_below(bx, by, ax, ay)
        return not (apart | (self.turn_parts != other.turn_parts)).any()

    # --- floats ----------------------------------------------------------------------------------

    @cached_property
    def shadow(self) -> FloatArray:
        """The values in radians, each within `error`; to filter with, never to choose."""
        x, y = _float_directions(self.x, self.y)
        values: FloatArray = np.arctan2(y, x)
        values[half_planes(self.x, self.y) & (values < 0)] += TWO_PI
        if self.turn_parts.dtype == object or self.turn_parts.any():
            values += TWO_PI * self.turn_parts.astype(np.float64)
        return values

    @cached_property
    def error(self) -> float:
        """The proven bound on the shadow's error, see `stochgeom.exact.shadows`."""
        return (2 + self.largest_turn) * ERROR_PER_TURN

    @cached_property
    def largest_turn(self) -> int:
        """The largest absolute value of the turn parts, rounded towards zero."""
        return max((abs(int(t)) for t in _extremes(self.turn_parts)), default=0)

    def to_float(self) -> FloatArray:
        """Return radians as float64, for plots: each within `error`."""
        return self.shadow.copy()


# --- array helpers -------------------------------------------------------------------------------


def _exact(array: IntArray) -> IntArray:
    """Return integers as int64 or, where they may not fit, as objects; refuse anything else."""
    if array.dtype == np.int64 or array.dtype == object:
        return array
    if array.dtype.kind in "iu":
        return array.astype(np.int64) if array.dtype.kind == "i" else as_objects(array)
    error = FloatRefusedError if array.dtype.kind == "f" else NumberError
    raise error(f"an array of {array.dtype}; accepted: arrays of integers")


def _int_array(values: Sequence[Any]) -> IntArray:
    if not any(is_algebraic(v) for v in values) and all(
        v.denominator == 1 and -EXACT_FLOAT_LIMIT < v < EXACT_FLOAT_LIMIT for v in values
    ):
        return np.array([int(v) for v in values], dtype=np.int64)
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array


def _join(arrays: Sequence[IntArray]) -> IntArray:
    if any(array.dtype == object for array in arrays):
        arrays = [as_objects(array) for array in arrays]
    return np.concatenate(arrays)


def _extremes(array: IntArray) -> tuple[Any, ...]:
    return (array.max(), array.min()) if array.size else ()


def _product(x: IntArray, y: IntArray, ax: Any, ay: Any) -> tuple[IntArray, IntArray]:
    """Multiply the directions by ax + i ay, in int64 where nothing can overflow."""
    if not is_algebraic(ax) and max(abs(ax), abs(ay)) <= 1 and fits_float(x, y):
        ax, ay = int(ax), int(ay)  # entries at most double: 2**54 still fits int64
    else:
        x, y = as_objects(x), as_objects(y)
    return x * ax - y * ay, x * ay + y * ax


def _arguments_below(ax: IntArray, ay: IntArray, bx: IntArray, by: IntArray) -> NDArray[np.bool_]:
    """Tell entry by entry whether arg a < arg b, both in [0, 360) degrees."""
    half_a, half_b = half_planes(ax, ay), half_planes(bx, by)
    below: NDArray[np.bool_] = (half_a < half_b) | (
        (half_a == half_b) & (cross_signs(ax, ay, bx, by) > 0)
    )
    return below


def _float_directions(x: IntArray, y: IntArray) -> tuple[FloatArray, FloatArray]:
    if x.dtype != object and y.dtype != object:
        return x.astype(np.float64), y.astype(np.float64)
    floats = np.array([float_direction(a, b) for a, b in zip(x.tolist(), y.tolist(), strict=True)])
    return (floats[:, 0], floats[:, 1]) if len(floats) else (np.empty(0), np.empty(0))


def argsort_arguments(x: IntArray, y: IntArray) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """Sort directions by their argument in [0, 360) degrees, exactly; equal ones stay in order.

    Returns
    -------
    order : index array
        Positions in increasing order of argument.
    fresh : bool array
        For each place of `order`, whether its argument exceeds the one before it.

    Notes
    -----
    O(n log n). The shadow sorts; exact signs of neighbours find what it got wrong, equal ones out
    of order among it, and only runs of neighbours closer than its error are sorted again, exactly.

    Examples
    --------
    >>> order, fresh = argsort_arguments(np.array([0, 1, 2]), np.array([1, 1, 2]))
    >>> order.tolist(), fresh.tolist()
    ([1, 2, 0], [True, False, True])
    """
    vector = AngleVector.from_directions(x, y)
    order = np.argsort(vector.shadow, kind="stable")
    fresh = _exceeds_last(vector, order)
    # Where an argument does not exceed the last one, they have to be equal and in order.
    places = np.nonzero(~fresh[1:])[0]
    here, last = order[places + 1], order[places]
    x, y = vector.x, vector.y
    if (here < last).any() or _arguments_below(x[here], y[here], x[last], y[last]).any():
        order = _sort_close_runs(vector, order)
        fresh = _exceeds_last(vector, order)
    return order, fresh


def _exceeds_last(vector: AngleVector, order: NDArray[np.intp]) -> NDArray[np.bool_]:
    x, y = vector.x[order], vector.y[order]
    fresh = np.ones(len(order), dtype=np.bool_)
    fresh[1:] = _arguments_below(x[:-1], y[:-1], x[1:], y[1:])
    return fresh


def _sort_close_runs(vector: AngleVector, order: NDArray[np.intp]) -> NDArray[np.intp]:
    """Sort runs of neighbours whose shadows cannot tell them apart, by exact comparison."""
    order = order.copy()
    gaps = np.diff(vector.shadow[order])
    close = np.concatenate(([False], gaps <= 2 * vector.error, [False]))
    edges = np.diff(close.astype(np.int8))
    for first, last in zip(np.nonzero(edges == 1)[0], np.nonzero(edges == -1)[0], strict=True):
        # Shadows of different runs differ by more than both errors, so runs never interleave.
        run = sorted(order[first : last + 1].tolist(), key=lambda k: (vector[k], k))
        order[first : last + 1] = run
    return order
