"""Where the numbers of bars stand: over their own bars, apart from each other.

A number that does not fit right above its bar stands higher or to a side, but never so far that
a line straight up from the bar misses it; that line is drawn, and no other number stands on it.
So it is plain which number belongs to which bar. Numbers without such a place are left out, those
of low bars first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final, final

from stochgeom.plotting.scene import XY

_SHIFTS: Final = (0.0, -0.25, 0.25, -0.5, 0.5)
"""How far a number may stand from the middle of its bar, in widths of the number."""

_CLOSE: Final = 1e-9


@final
@dataclass(frozen=True, slots=True)
class Room:
    """What numbers over bars may use, in the units of the picture.

    Attributes
    ----------
    left, right, ceiling : float
        No number reaches beyond.
    half : float
        Half the width of a bar.
    height : float
        Of a number.
    pad : float
        Free space on either side of a number, a part of its width.
    """

    left: float
    right: float
    ceiling: float
    half: float
    height: float
    pad: float


@final
@dataclass(slots=True)
class _Numbers:
    """Numbers placed so far, over all bars."""

    centers: Sequence[float]
    tops: Sequence[float]
    widths: Sequence[float]
    room: Room
    found: dict[int, XY] = field(default_factory=dict)

    def add(self, k: int) -> None:
        """Place number k where it is nearest to its bar, or nowhere."""
        places = [place for shift in _SHIFTS if (place := self._place(k, shift)) is not None]
        if places:
            self.found[k] = min(places, key=lambda place: self._distance(k, place))

    def _distance(self, k: int, place: XY) -> float:
        """Return how bad a place is: far from its bar, or above other bars, whose lines end there.

        In lines of text.
        """
        x, y = place
        rise, shift = y - self.tops[k], abs(x - self.centers[k])
        inner = self.widths[k] / 2 - self.room.pad
        covered = sum(abs(c - x) < inner for j, c in enumerate(self.centers) if j != k)
        return rise / self.room.height + 0.5 * shift / self.widths[k] + 1.5 * covered

    def _place(self, k: int, shift: float) -> XY | None:
        """Return the middle of the lower side of number k, shifted; None if there is no room."""
        room, width, center = self.room, self.widths[k], self.centers[k]
        x = min(max(center + shift * width, room.left + width / 2), room.right - width / 2)
        y = self.tops[k]
        for low, high in sorted(self._under(k, x)):
            if high > y + _CLOSE and low < y + room.height - _CLOSE:
                y = high
        if y + room.height > room.ceiling or self._crosses(center, self.tops[k], y):
            return None
        return x, y

    def _under(self, k: int, x: float) -> Iterator[XY]:
        """Yield from where to where something stands between the sides of number k, placed at x."""
        inner = self.widths[k] / 2 - self.room.pad
        for j, (center, top) in enumerate(zip(self.centers, self.tops, strict=True)):
            if j != k and abs(center - x) < inner + self.room.half:
                yield 0.0, top
        for j, (other, y) in self.found.items():
            if abs(other - x) < (self.widths[j] + self.widths[k]) / 2 - _CLOSE:
                yield y, y + self.room.height
            if abs(self.centers[j] - x) < inner:
                yield self.tops[j], y

    def _crosses(self, center: float, low: float, high: float) -> bool:
        """Tell whether a line straight up crosses a number."""
        return any(
            low < y + self.room.height - _CLOSE
            and high > y + _CLOSE
            and abs(x - center) < self.widths[j] / 2 - self.room.pad
            for j, (x, y) in self.found.items()
        )

    def worth(self) -> tuple[float, int, float]:
        """Return what makes one choice of places better than another."""
        told = round(sum(self.tops[k] for k in self.found), 6)
        distance = sum(self._distance(k, place) for k, place in self.found.items())
        return told, len(self.found), -round(distance, 6)


def numbers_over_bars(
    centers: Sequence[float], tops: Sequence[float], widths: Sequence[float], room: Room
) -> dict[int, XY]:
    """Return for the numbers that have room the middles of their lower sides.  O(n^2 log n).

    Parameters
    ----------
    centers : sequence of float
        The middles of the bars, increasing, between the ends of the room.
    tops : sequence of float
        Their heights.
    widths : sequence of float
        Of the numbers.
    room : Room
        What they may use.

    Examples
    --------
    >>> room = Room(0.0, 10.0, 5.0, half=0.1, height=1.0, pad=0.1)
    >>> numbers_over_bars([2.0, 5.0], [1.0, 2.0], [1.0, 1.0], room)
    {0: (2.0, 1.0), 1: (5.0, 2.0)}

    Of two bars side by side one has its number on the left, the other one on the right:

    >>> numbers_over_bars([5.0, 5.2], [1.0, 2.0], [1.0, 1.0], room)
    {0: (4.5, 1.0), 1: (5.45, 2.0)}
    """
    numbers = range(len(centers))
    orders = (sorted(numbers, key=lambda k: (-tops[k], k)), numbers, numbers[::-1])
    tried = []
    for order in orders:
        placing = _Numbers(centers, tops, widths, room)
        for k in order:
            placing.add(k)
        tried.append(placing)
    best = max(tried, key=_Numbers.worth)
    return dict(sorted(best.found.items()))


def has_line(center: float, top: float, place: XY, room: Room) -> bool:
    """Tell whether a number stands so far from its bar that a line has to join them."""
    x, y = place
    return y > top + 0.2 * room.height or abs(x - center) > room.half + room.pad


def bar_half(places: Sequence[float], widest: float, narrowest: float) -> float:
    """Return half the width of bars that do not cover each other, within bounds.

    Examples
    --------
    >>> bar_half([10.0, 12.0, 90.0], 3.0, 0.2), bar_half([10.0], 3.0, 0.2)
    (0.9, 3.0)
    """
    gaps = [b - a for a, b in pairwise(places)]
    return max(narrowest, min([widest, *(0.45 * gap for gap in gaps)]))
