"""Rows of a diagram over all orientations: marks, ways that a part turns, sets of orientations.

The axis runs from 0 to 360 degrees. What stands at 0 is drawn at 360 again, and what runs over 360
in two pieces.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final, final

from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.graph import TEXT, Panel
from stochgeom.plotting.scene import XY, Disc, Label, Line, Polygon, Scene, rectangle

CROSS: Final = 4.5
"""Half the size of a mark, in pixels like everything here."""

_HEAD: Final = 4.0
_BAR: Final = 6.0
_LEAST_WAY: Final = 22.0
"""On a shorter way no arrowhead fits between the marks."""

_MOST_DOTTED: Final = 20

_TITLE_ABOVE: Final = 1.5 * TEXT


@final
@dataclass(frozen=True, slots=True)
class Row:
    """A row of a panel whose x runs from 0 to 360 degrees, at a height in pixels.

    Attributes
    ----------
    size : float
        Half the size of its marks.
    """

    panel: Panel
    y: float
    size: float = CROSS

    def at(self, degrees: float) -> XY:
        """Return where an orientation stands in the row."""
        return self.panel.at(degrees, 0.0)[0], self.y

    def places(self, theta: Angle) -> Iterator[XY]:
        """Yield where an orientation stands: twice if it is 0."""
        reduced = theta.reduced()
        yield self.at(in_degrees(reduced))
        if not reduced:
            yield self.at(360.0)

    def with_marks(self, count: int) -> Row:
        """Return the row with marks so small that so many of them stand apart."""
        return Row(self.panel, self.y, min(CROSS, 0.3 * self.panel.width / max(count, 1)))

    def title(self, text: str) -> Label:
        """Return the title of the row, above it on the left."""
        return Label((self.panel.left + 2, self.y + _TITLE_ABOVE), text, TEXT, "start")

    def axis(self) -> Line:
        """Return the line that marks stand on."""
        return Line((self.at(0.0), self.at(360.0)), "frame")


def cross(at: XY, r: float = CROSS) -> Line:
    """Return the mark of a stable orientation, of half the size r: one chain through its middle."""
    x, y = at
    return Line(((x - r, y - r), (x + r, y + r), (x, y), (x - r, y + r), (x + r, y - r)), "arrow")


def plus(at: XY, r: float = CROSS) -> Line:
    """Return the mark of a stable orientation that only friction holds."""
    x, y = at
    s = 1.3 * r
    return Line(((x - s, y), (x + s, y), (x, y), (x, y - s), (x, y + s)), "arrow")


def diamond(at: XY, r: float = CROSS) -> Polygon:
    """Return the mark of an unstable equilibrium."""
    x, y = at
    s = 1.25 * r
    return Polygon(((x - s, y), (x, y + s), (x + s, y), (x, y - s)), "mass")


def wedge_ends(low: XY, high: XY, r: float = CROSS) -> tuple[Line, Line]:
    """Return the marks < and > of the ends of a wedging interval, inside it."""
    (x, y), u = low, high[0]
    depth = min(r, abs(u - x) / 3)
    return (
        Line(((x + depth, y + r), (x, y), (x + depth, y - r)), "arrow"),
        Line(((u - depth, y + r), (u, y), (u - depth, y - r)), "arrow"),
    )


def add_way(scene: Scene, row: Row, start: Angle, end: Angle, step: int) -> None:
    """Draw an arrowhead on the way between two orientations, to the right if step is positive.

    None if the way is too short for one.
    """
    low = in_degrees(start.reduced())
    high = low + in_degrees((end - start).reduced() or FULL_TURN)
    length = row.at(high)[0] - row.at(low)[0]
    if length < _LEAST_WAY:
        return
    x, y = row.at((low + high) / 2 % 360.0)
    back = x - step * _HEAD
    scene.add(Polygon(((x + step * _HEAD, y), (back, y + 3.0), (back, y - 3.0)), "arrowhead"))


def pieces(interval: Interval) -> list[tuple[float, float]]:
    """Return an interval in degrees within [0, 360], in two pieces if it runs over 360.

    Examples
    --------
    >>> pieces(Interval(Angle.from_degrees(270), Angle.from_degrees(180), True, True))
    [(270.0, 360.0), (0.0, 90.0)]
    """
    low = in_degrees(interval.start.reduced())
    if interval.start.reduced() + interval.width <= FULL_TURN:
        return [(low, low + in_degrees(interval.width))]
    return [(low, 360.0), (0.0, low + in_degrees(interval.width) - 360.0)]


def add_bands(scene: Scene, row: Row, intervals: Iterable[Interval], style: str) -> None:
    """Draw intervals as bars across the row."""
    for interval in intervals:
        for low, high in pieces(interval):
            (x, y), (u, _) = row.at(low), row.at(high)
            scene.add(rectangle((x, y - _BAR), (u, y + _BAR), style))


def add_cells(scene: Scene, row: Row, cells: CellSet, style: str = "bar") -> None:
    """Draw a set of orientations: bars, with dots at ends that belong to it and circles at others.

    Of a set of many intervals the ends have no dots.
    """
    found = cells.intervals()
    add_bands(scene, row, (item for item in found if item.width), style)
    if len(found) > _MOST_DOTTED or cells.is_whole:
        return
    for item in found:
        for end, inside in ((item.start, item.includes_start), (item.end, item.includes_end)):
            style = "closed" if inside else "hollow"
            scene.add(*(Disc(place, 2.8, style) for place in row.places(end)))


def add_text(scene: Scene, row: Row, interval: Interval, text: str) -> None:
    """Write a text into the bar of an interval, if it fits the bar's longest piece."""
    low, high = max(pieces(interval), key=lambda piece: piece[1] - piece[0])
    (x, y), (u, _) = row.at(low), row.at(high)
    label = Label(((x + u) / 2, y), text, TEXT)
    if label.width + 2 <= u - x:
        scene.add(label)
