"""Piecewise linear functions of the friction angle, with exact breakpoints.

The ends of the intervals that guarantee a stable grasp either stand still as friction grows or
move by just the friction angle. So each is piecewise a + k alpha with an exact angle a and a small
whole k, and so are the smaller of two, and the width between two. Two moving ends meet at *half* an
angle: breakpoints are kept doubled, delta = 2 alpha, in [0, 180) degrees.

A `Piece` holds for delta above its `start`, up to the next piece's start, which belongs to it: what
friction makes possible needs more than the friction at the breakpoint.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias, final

from stochgeom.exact.angles import HALF_TURN, ZERO, Angle

LARGEST: Final = HALF_TURN
"""Twice the friction angle of endless friction."""


@final
@dataclass(frozen=True, slots=True)
class Piece:
    """a + k alpha, for delta = 2 alpha in (start, start of the next piece].

    Attributes
    ----------
    start : Angle
        Twice the friction angle that the piece begins above.
    anchor : Angle
        a.
    slope : int
        k.
    """

    start: Angle
    anchor: Angle
    slope: int

    def doubled(self, delta: Angle) -> Angle:
        """Return twice the value at delta."""
        return self.anchor + self.anchor + delta * self.slope


MovingEnd: TypeAlias = "Sequence[Piece]"
"""Pieces by increasing start, the first one from 0."""


def shift(end: MovingEnd, angle: Angle) -> list[Piece]:
    """Return a moving end turned by an angle."""
    return [Piece(piece.start, piece.anchor + angle, piece.slope) for piece in end]


def common_pieces(first: MovingEnd, second: MovingEnd) -> Iterator[tuple[Angle, Angle, int, int]]:
    """Yield (start, end, i, j): where piece i of one and piece j of the other hold together."""
    i = j = 0
    start = ZERO
    while True:
        ends = (
            first[i + 1].start if i + 1 < len(first) else LARGEST,
            second[j + 1].start if j + 1 < len(second) else LARGEST,
        )
        order = ends[0].compare(ends[1])
        end = ends[0] if order <= 0 else ends[1]
        yield start, end, i, j
        if end == LARGEST:
            return
        start, i, j = end, i + (order <= 0), j + (order >= 0)


def lesser(first: MovingEnd, second: MovingEnd, sign: int = 1) -> list[Piece]:
    """Return the smaller of two moving ends, or with sign -1 the larger one."""
    found: list[Piece] = []
    for start, end, i, j in common_pieces(first, second):
        a, b = first[i], second[j]
        order = sign * a.doubled(start).compare(b.doubled(start)) or sign * (a.slope - b.slope)
        now, then = (a, b) if order <= 0 else (b, a)
        _append(found, Piece(start, now.anchor, now.slope))
        gain = sign * (now.slope - then.slope)
        if gain > 0:
            # They meet where now.anchor + now.slope alpha = then.anchor + then.slope alpha.
            meeting = _meeting(now, then)
            if start < meeting < end:
                _append(found, Piece(meeting, then.anchor, then.slope))
    return found


def _meeting(a: Piece, b: Piece) -> Angle:
    """Return delta where two pieces of different slope meet; slopes differ by 1 or 2."""
    apart = b.anchor - a.anchor
    rate = a.slope - b.slope
    if rate < 0:
        apart, rate = -apart, -rate
    return apart if rate == 2 else apart + apart


def _append(pieces: list[Piece], piece: Piece) -> None:
    last = pieces[-1] if pieces else None
    if last is None or (last.anchor, last.slope) != (piece.anchor, piece.slope):
        pieces.append(piece)


@final
@dataclass(frozen=True, slots=True)
class Gap:
    """The width (high - low) + slope alpha from `start` on; None instead of ends if it is 0."""

    start: Angle
    ends: tuple[Angle, Angle] | None
    slope: int


def gap_between(low: MovingEnd, high: MovingEnd) -> list[Gap]:
    """Return the width from a rising low end to a falling high end, 0 once they have met."""
    found: list[Gap] = []
    for start, end, i, j in common_pieces(low, high):
        a, b = low[i], high[j]
        if b.doubled(start) <= a.doubled(start):
            found.append(Gap(start, None, 0))
            return found
        found.append(Gap(start, (a.anchor, b.anchor), b.slope - a.slope))
        if a.slope != b.slope:
            meeting = _meeting(a, b)
            if meeting < end:
                found.append(Gap(meeting, None, 0))
                return found
    return found
