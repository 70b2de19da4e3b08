"""Periodic increasing sequences of angles, and what planners ask of them, array by array.

A `LiftedAngles` stands for the bi-infinite sequence a_k with a_{k+m} = a_k + T, given by one
period a_0 < ... < a_{m-1} and T. It owns the float64 shadow, its error bound and the exact
fallback: callers never see a float. `exact_decisions` counts the decisions that the shadow left
open, so that tests can force either road.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from typing import Final, NamedTuple, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.angles import Angle
from stochgeom.exact.shadows import shadow, shadow_error
from stochgeom.exact.vectors import AngleVector, FloatArray

Indices = NDArray[np.intp]

FEW: Final = 48
"""Sequences of at most so many entries are searched by Python loops: cheaper than array calls."""


class Gap(NamedTuple):
    """The angle a_end - a_start of a sequence; exact only when asked for."""

    sequence: LiftedAngles
    start: int
    end: int

    @property
    def angle(self) -> Angle:
        """The exact difference."""
        return self.sequence[self.end] - self.sequence[self.start]


@final
class LiftedAngles:
    """The increasing sequence a_k with a_{k+m} = a_k + period.

    Parameters
    ----------
    base : AngleVector
        a_0 < ... < a_{m-1}, strictly increasing, less than one period long.
    period : Angle
        T > 0.
    error : float, optional
        A larger bound for the shadow than the proven one: with a huge one every decision is
        made by exact arithmetic.

    Examples
    --------
    >>> base = AngleVector.from_angles([Angle.from_degrees(d) for d in (0, 10, 90)])
    >>> sequence = LiftedAngles(base, Angle.from_degrees(180))
    >>> sequence[4].degrees(0)
    '190'
    >>> sequence.last_below(Angle.from_degrees(100)).tolist()
    [2, 2, 3]
    """

    def __init__(self, base: AngleVector, period: Angle, *, error: float | None = None) -> None:
        self.base, self.period = base, period
        # Two periods hold every index asked for: an entry of them is off by the base's bound and
        # twice the period's; what is left of both covers the rounding of the sum.
        proven = 2 * base.error + 3 * shadow_error(period)
        self.error = proven if error is None else error
        # A target carries the errors of a_i and of an offset, a_k its own; 2**-48 covers the
        # roundings, of values below 2**4 or of multiples of long periods. A width is within
        # 2 error + 2**-50 of the truth, so the largest of them may look smaller by twice that.
        self._margin = 2 * self.error + 2.0**-48
        self._width_margin = 4 * self.error + 2.0**-48
        self.exact_decisions = 0
        self._shadow = self._two_periods()
        self._few: list[float] | None = self._shadow.tolist() if len(base) <= FEW else None
        self._following: dict[int, Angle] = {}  # entries of the second period asked for so far

    def __len__(self) -> int:
        """Return m, the number of entries in one period."""
        return len(self.base)

    def __getitem__(self, k: int) -> Angle:
        turn, place = divmod(int(k), len(self.base))
        angle = self.base[place]
        if turn == 0:
            return angle
        if turn != 1:
            return angle + self.period * turn
        following = self._following.get(place)
        if following is None:
            following = self._following[place] = angle + self.period
        return following

    def gap(self, start: int, end: int) -> Gap:
        """Return a_end - a_start, with 0 <= start < end <= 2 m, to be made when asked for."""
        return Gap(self, start, end)

    def _two_periods(self) -> FloatArray:
        """Return shadows of a_0 .. a_{2m}, made monotone."""
        base, period = self.base.shadow, shadow(self.period)
        values = np.concatenate((base, base + period, base[:1] + 2 * period))
        if (values[1:] < values[:-1]).any():
            # A running maximum keeps the bound: no earlier entry exceeds a later one in truth.
            values = np.maximum.accumulate(values)
        return values

    # --- comparisons -----------------------------------------------------------------------------

    def last_below(self, offset: Angle | Gap, at: Indices | None = None) -> Indices:
        """Return for each i in [0, m), or each of `at`, the last k with a_k < a_i + offset.

        `offset` is positive and at most the period.  O(m log m) on floats after the shadow, and
        O(log m) exact comparisons for each entry that the shadow leaves open.
        """
        width, error = self._filter_of(offset)
        margin = self._margin + error
        if self._few is not None:
            every = np.array(self._last_below_few(self._few, offset, width, margin))
            return every if at is None else every[at]
        m, values = len(self), self._shadow
        targets = (values[:m] if at is None else values[at]) + width
        after = np.searchsorted(values[: 2 * m], targets)
        unclear = (targets - values[after - 1] <= margin) | (values[after] - targets <= margin)
        last = after - 1
        for p in np.nonzero(unclear)[0].tolist():
            i = p if at is None else int(at[p])
            last[p] = self._exact_last_below(i, offset, targets[p], margin)
        return last

    @staticmethod
    def _filter_of(offset: Angle | Gap) -> tuple[float, float]:
        """Return the float value of an offset and a bound on its error."""
        if isinstance(offset, Angle):
            return shadow(offset), shadow_error(offset)
        values = offset.sequence._few or offset.sequence._shadow
        return float(values[offset.end] - values[offset.start]), 2 * offset.sequence.error

    def _last_below_few(
        self, values: list[float], offset: Angle | Gap, width: float, margin: float
    ) -> list[int]:
        m = len(self)
        last = []
        for i in range(m):
            target = values[i] + width
            after = bisect_left(values, target, 0, 2 * m)
            if target - values[after - 1] > margin and values[after] - target > margin:
                last.append(after - 1)
            else:
                last.append(self._exact_last_below(i, offset, target, margin))
        return last

    def _exact_last_below(self, i: int, offset: Angle | Gap, target: float, margin: float) -> int:
        self.exact_decisions += 1
        bound = self[i] + (offset if isinstance(offset, Angle) else offset.angle)
        # Entries before `low` are certainly below, entries from `high` on certainly not. a_i is
        # below and a_{i+m} is not, whatever the shadow says.
        low = max(i + 1, int(np.searchsorted(self._shadow, target - margin)))
        high = min(i + len(self), int(np.searchsorted(self._shadow, target + margin, "right")))
        while low < high:
            middle = (low + high) // 2
            if self[middle] < bound:
                low = middle + 1
            else:
                high = middle
        return low - 1

    def largest_gaps(self, last: Indices) -> Indices:
        """Return every i in [0, m) for which a_{last[i]+1} - a_i is largest, in order."""
        if self._few is not None:
            return np.array(self._largest_few(self._few, last.tolist()))
        after = last + 1
        widths = self._shadow[after] - self._shadow[: len(self)]
        return self._largest(widths, np.arange(len(self)), after)

    def largest_steps(self) -> Indices:
        """Return every i in [0, m) for which a_{i+1} - a_i is largest, in order."""
        if self._few is not None:
            return np.array(self._largest_few(self._few, range(len(self))))
        m, base = len(self), self.base.shadow
        widths = np.append(base[1:], base[0] + shadow(self.period)) - base
        return self._largest(widths, np.arange(m), np.arange(1, m + 1))

    def _largest_few(self, values: list[float], last: Sequence[int]) -> list[int]:
        widths = [values[k + 1] - a for k, a in zip(last, values, strict=False)]
        least = max(widths) - self._width_margin
        near = [i for i, width in enumerate(widths) if width >= least]
        if len(near) > 1 and len(self) > 1:
            near = self._exactly_largest(near, near, [last[i] + 1 for i in near])
        return near

    def widest_below(
        self, images: LiftedAngles, offset: Angle | Gap
    ) -> tuple[Sequence[int] | Indices, Sequence[int] | Indices]:
        """Return `images.last_below(offset)` and the `largest_gaps` of that, in this sequence.

        A stage of phase I: between few entries arrays would cost more than the answers.
        """
        if self._few is None or images._few is None:
            last = images.last_below(offset)
            return last, self.largest_gaps(last)
        width, error = images._filter_of(offset)
        below = images._last_below_few(images._few, offset, width, images._margin + error)
        return below, self._largest_few(self._few, below)

    def widest(self, starts: Indices, ends: Indices) -> Indices:
        """Return every place p for which a_{ends[p]} - a_{starts[p]} is largest, in order.

        All indices are in [0, 2 m].
        """
        return self._largest(self._shadow[ends] - self._shadow[starts], starts, ends)

    def _largest(self, widths: FloatArray, starts: Indices, ends: Indices) -> Indices:
        (near,) = np.nonzero(widths >= widths.max() - self._width_margin)
        if len(near) == 1:
            return near
        first, after = starts[near].tolist(), ends[near].tolist()
        return np.array(self._exactly_largest(near.tolist(), first, after))

    def _exactly_largest(self, names: list[int], first: list[int], after: list[int]) -> list[int]:
        """Return the names of the exactly largest of some gaps."""
        self.exact_decisions += len(names)
        steps = [b - a for a, b in zip(first, after, strict=True)]
        if max(steps) == len(self):  # a period, which fewer steps do not reach
            return [name for name, count in zip(names, steps, strict=True) if count == len(self)]
        widths = [self[b] - self[a] for a, b in zip(first, after, strict=True)]
        best = max(widths)
        return [name for name, width in zip(names, widths, strict=True) if width == best]

    def position(self, theta: Angle) -> int:
        """Return the k with a_k <= theta < a_{k+1}, for a base in [0, period).  O(log m)."""
        periods, rest = divmod(theta, self.period)
        return periods * len(self) + self.base.count_at_most(rest) - 1

    def positions(self, other: LiftedAngles, indices: Indices, offset: Angle) -> Indices:
        """Return for each j of `indices` the k with a_k <= b_j + offset < a_{k+1}.

        The b_j are those of `other`, of the same period; the base of this sequence is in
        [0, period). O(log m) for each, on arrays; exact only where the shadow leaves it open.
        """
        m, period = len(self), self.period.to_float()
        laps, places = np.divmod(indices, len(other))
        targets = other._shadow[places] + period * laps + offset.to_float()
        turns = np.floor(targets / period)
        rests = targets - period * turns
        early = rests < self._shadow[0]  # these belong to the last step of the period before
        rests += period * early
        turns -= early
        found = np.searchsorted(self._shadow[: 2 * m], rests, "right") - 1
        # With n periods, the products n * period are off by n (2**-50 + 2**-51 * 2 pi) at most
        # (the float period, one rounding), and so is each of the five sums: below 8 n 2**-48.
        largest = max(float(np.abs(turns).max(initial=0)), float(np.abs(laps).max(initial=0)))
        turn = 1 + int(self.period.turn_part)
        margin = self.error + other.error + turn * (8 + 8 * largest) * 2.0**-48
        unclear = rests - self._shadow[found] <= margin
        unclear |= self._shadow[found + 1] - rests <= margin
        result: Indices = found + m * turns.astype(np.intp)
        for p in np.flatnonzero(unclear).tolist():
            self.exact_decisions += 1
            result[p] = self.position(other[int(indices[p])] + offset)
        return result
