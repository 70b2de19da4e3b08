"""Periodic increasing sequences of angles, and what planners ask of them, array by array.

A `LiftedAngles` stands for the bi-infinite sequence a_k with a_{k+m} = a_k + T, given by one
period a_0 < ... < a_{m-1} and T. It owns the float64 shadow, its error bound and the exact
fallback: callers never see a float. `exact_decisions` counts the decisions that the shadow left
open, so that tests can force either road.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.angles import Angle
from stochgeom.exact.vectors import ERROR_PER_TURN, AngleVector, FloatArray

Indices = NDArray[np.intp]


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
        # Two periods hold every index asked for. For T of t whole turns and a rest, the floats of
        # T and 2 T and the rounding of a sum are off by 3 (t + 1) 2**-49 and an eighth of the
        # base's bound at most: below that bound, which is 2**-46 or more, and 4 t 2**-47.
        self._turns = int(period.turn_part)
        proven = 2 * base.error + 4 * self._turns * ERROR_PER_TURN
        self.error = proven if error is None else error
        self.exact_decisions = 0

    def __len__(self) -> int:
        """Return m, the number of entries in one period."""
        return len(self.base)

    def __getitem__(self, k: int) -> Angle:
        turn, place = divmod(int(k), len(self.base))
        angle = self.base[place]
        if turn == 0:
            return angle
        return angle + (self.period if turn == 1 else self.period * turn)

    @cached_property
    def _shadow(self) -> FloatArray:
        """Shadows of a_0 .. a_{2m}, made monotone."""
        base, period = self.base.shadow, self.period.to_float()
        values = np.concatenate((base, base + period, base[:1] + 2 * period))
        if (values[1:] < values[:-1]).any():
            # A running maximum keeps the bound: no earlier entry exceeds a later one in truth.
            values = np.maximum.accumulate(values)
        return values

    # --- comparisons -----------------------------------------------------------------------------

    def last_below(self, offset: Angle) -> Indices:
        """Return for each i in [0, m) the last k with a_k < a_i + offset.

        `offset` is positive and at most the period.  O(m) after the shadow, and O(log m) exact
        comparisons for each entry that the shadow leaves open.
        """
        m, shadow = len(self), self._shadow
        targets = shadow[:m] + offset.to_float()
        after = np.searchsorted(shadow[: 2 * m], targets)
        # The target carries the error of a_i and of the offset (below 2**-49), a_k its own.
        margin = 2 * self.error + 2.0**-48
        unclear = (targets - shadow[after - 1] <= margin) | (shadow[after] - targets <= margin)
        last = after - 1
        for i in np.nonzero(unclear)[0].tolist():
            last[i] = self._exact_last_below(i, offset, targets[i], margin)
        return last

    def _exact_last_below(self, i: int, offset: Angle, target: float, margin: float) -> int:
        self.exact_decisions += 1
        bound = self[i] + offset
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
        return self._largest(slice(len(self)), last + 1)

    def largest_steps(self) -> Indices:
        """Return every i in [0, m) for which a_{i+1} - a_i is largest, in order."""
        return self._largest(slice(len(self)), slice(1, len(self) + 1))

    def widest(self, starts: Indices, ends: Indices) -> Indices:
        """Return every place p for which a_{ends[p]} - a_{starts[p]} is largest, in order.

        All indices are in [0, 2 m].
        """
        return self._largest(starts, ends)

    def _largest(self, starts: Indices | slice, ends: Indices | slice) -> Indices:
        if len(self) == 1 and isinstance(starts, slice):
            return np.zeros(1, dtype=np.intp)
        widths = self._shadow[ends] - self._shadow[starts]
        # Each width is within 2 error and one rounding of the truth; so is the largest.
        margin = 4 * self.error + 2.0**-48
        (near,) = np.nonzero(widths >= widths.max() - margin)
        if len(near) == 1:
            return near
        self.exact_decisions += len(near)
        every = np.arange(2 * len(self) + 1)
        first, after = every[starts], every[ends]
        exact = [self[int(after[p])] - self[int(first[p])] for p in near]
        best = max(exact)
        chosen: Any = [p for p, width in zip(near, exact, strict=True) if width == best]
        return np.array(chosen, dtype=np.intp)

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
        found = np.searchsorted(self._shadow[: 2 * m], rests, "right") - 1
        # With n periods, the products n * period are off by n (2**-50 + 2**-51 * 2 pi) at most
        # (the float period, one rounding), and so is each of the four sums: below 8 n 2**-48.
        largest = max(float(np.abs(turns).max(initial=0)), float(np.abs(laps).max(initial=0)))
        margin = self.error + other.error + (1 + self._turns) * (8 + 8 * largest) * 2.0**-48
        unclear = (found < 0) | (rests - self._shadow[found] <= margin)
        unclear |= self._shadow[found + 1] - rests <= margin
        result: Indices = found + m * turns.astype(np.intp)
        for p in np.flatnonzero(unclear).tolist():
            self.exact_decisions += 1
            result[p] = self.position(other[int(indices[p])] + offset)
        return result
