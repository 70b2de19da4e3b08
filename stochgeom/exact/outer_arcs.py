"""Unions of closed arcs on a circle, their ends rounded outwards to 2**-96 of a full turn.

For claims in one direction: a set that holds *at least* all orientations where something may
happen. An orientation is a whole number of units, a full turn is `TURN` of them; whatever is
irrational is enclosed by ball arithmetic and rounded away from the arc. So everything after that
is arithmetic of whole numbers, and an arc may be too large by a unit or two and is never too small.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator
from typing import Final, TypeAlias, final

from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import Ball, working_precision

UNIT_BITS: Final = 96
TURN: Final = 1 << UNIT_BITS
"""Units in a full turn."""

BALL_BITS: Final = UNIT_BITS + 64
"""Arb precision with which turns become units: the roundings stay far below a unit."""

Units: TypeAlias = "tuple[int, int]"
"""A closed arc [start, end] of lifted units, start <= end."""


def units_below(turns: Ball) -> int:
    """Return the largest number of units at or below every number of turns in the ball.

    To be called at `BALL_BITS` of working precision or more.
    """
    return int((turns * TURN).lower().floor().unique_fmpz())


def units_above(turns: Ball) -> int:
    """Return the smallest number of units at or above every number of turns in the ball."""
    return int((turns * TURN).upper().ceil().unique_fmpz())


def units_around(angle: Angle) -> Units:
    """Return the narrowest arc of units that holds an exact angle; at most two units wide.

    Examples
    --------
    >>> units_around(Angle.from_degrees(90)) == (TURN // 4, TURN // 4)
    True
    >>> low, high = units_around(Angle(0, (3, 2)))
    >>> high - low
    1
    """
    turns = angle.rational_turns
    if turns is not None:
        scaled = turns * TURN
        return int(scaled.__floor__()), int(scaled.__ceil__())
    with working_precision(BALL_BITS + int(abs(angle.turn_part)).bit_length()):
        ball = angle.ball()
        return units_below(ball), units_above(ball)


@final
class OuterArcs:
    """A union of closed arcs on the circle of `period` units, asked for by lifted units.

    Parameters
    ----------
    arcs : iterable of (int, int)
        Lifted, start <= end; arcs that overlap are joined.
    period : int, default `TURN`
        Of the circle, in units.

    Examples
    --------
    >>> arcs = OuterArcs([(90, 105), (20, 30)], period=100)
    >>> arcs.around(202), arcs.around(10)
    ((190, 205), None)
    >>> arcs.first_from(6), arcs.last_to(119)
    (20, 105)
    """

    def __init__(self, arcs: Iterable[Units], period: int = TURN) -> None:
        self.period = period
        joined: list[list[int]] = []
        for start, end in sorted((s % period, s % period + e - s) for s, e in arcs):
            if joined and start <= joined[-1][1]:
                joined[-1][1] = max(joined[-1][1], end)
            else:
                joined.append([start, end])
        # The last arcs may run over the first ones of the next period.
        while len(joined) > 1 and joined[-1][1] >= joined[0][0] + period:
            joined[-1][1] = max(joined[-1][1], joined[0][1] + period)
            joined.pop(0)
        self.is_whole = len(joined) == 1 and joined[0][1] - joined[0][0] >= period
        self._starts = [start for start, _ in joined]
        self._ends = [end for _, end in joined]

    def __iter__(self) -> Iterator[Units]:
        return zip(self._starts, self._ends, strict=True)

    def __bool__(self) -> bool:
        """Tell whether there is any arc."""
        return bool(self._starts)

    def _before(self, x: int) -> Units:
        """Return the last arc that starts at or before x, lifted.  O(log k)."""
        laps, rest = divmod(x, self.period)
        place = bisect_right(self._starts, rest) - 1
        lift = (laps if place >= 0 else laps - 1) * self.period
        return self._starts[place] + lift, self._ends[place] + lift

    def around(self, x: int) -> Units | None:
        """Return the arc that holds x, lifted; None if none does.  O(log k).

        Of the whole circle, an arc of a period or more.
        """
        if not self._starts:
            return None
        arc = self._before(x)
        return arc if x <= arc[1] else None

    def first_from(self, x: int) -> int:
        """Return the first unit of the union at or after x; there must be an arc.  O(log k)."""
        arc = self._before(x)
        if x <= arc[1]:
            return x
        laps, rest = divmod(x, self.period)
        place = bisect_right(self._starts, rest)
        if place == len(self._starts):
            return self._starts[0] + (laps + 1) * self.period
        return self._starts[place] + laps * self.period

    def last_to(self, x: int) -> int:
        """Return the last unit of the union at or before x; there must be an arc.  O(log k)."""
        return min(x, self._before(x)[1])

    def parts_in(self, arc: Units) -> Iterator[Units]:
        """Yield what the union has in common with one lifted arc, in order."""
        x, end = arc
        while self._starts and (x := self.first_from(x)) <= end:
            last = end if self.is_whole else min(self._before(x)[1], end)
            yield x, last
            x = last + 1

    def intersection(self, other: OuterArcs) -> OuterArcs:
        """Return the common part of two unions on the same circle."""
        return OuterArcs((part for arc in self for part in other.parts_in(arc)), self.period)
