"""Intervals of orientations whose ends are taken or left out, single orientations among them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from gmpy2 import mpq

from stochgeom.errors import InvalidArcError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.decimals import Rounding


@final
@dataclass(frozen=True, slots=True)
class Interval:
    """An interval of orientations whose ends each belong to it or not.

    Parameters
    ----------
    start : Angle
        The first orientation, lifted.
    width : Angle
        From 0, for a single orientation, to 360 degrees.
    includes_start, includes_end : bool
        Whether the ends belong to it. Both do for a single orientation.

    Raises
    ------
    InvalidArcError
        For another width, or width 0 without the ends.

    Examples
    --------
    >>> print(Interval(ZERO, Angle.from_degrees(90), True, False))
    [0.0000°, 90.0000°)
    """

    start: Angle
    width: Angle
    includes_start: bool
    includes_end: bool

    def __post_init__(self) -> None:
        ends: tuple[object, ...] = (self.start, self.width)
        if not all(isinstance(end, Angle) for end in ends):
            raise InvalidArcError(
                f"an interval from {self.start!r:.60}, {self.width!r:.60} wide; accepted: two "
                "Angles"
            )
        if not ZERO <= self.width <= FULL_TURN:
            raise InvalidArcError(f"interval width {self.width}; accepted: from 0 to 360°")
        if not self.width and not (self.includes_start and self.includes_end):
            raise InvalidArcError("an interval of width 0 without its ends is empty")

    @property
    def end(self) -> Angle:
        """The last orientation, which may not belong to it."""
        return self.start + self.width

    @property
    def is_closed(self) -> bool:
        """Whether both ends belong to the interval."""
        return self.includes_start and self.includes_end

    def shrunk(self, margin: Angle) -> Interval | None:
        """Return the orientations that have `margin` of the interval on either side, if any.

        Examples
        --------
        >>> quarter = Interval(ZERO, Angle.from_degrees(90), True, False)
        >>> print(quarter.shrunk(Angle.from_degrees(40)), quarter.shrunk(Angle.from_degrees(45)))
        [40.0000°, 50.0000°) None
        """
        width = self.width - 2 * margin
        if width < ZERO or (not width and not self.is_closed):
            return None
        return Interval(self.start + margin, width, self.includes_start, self.includes_end)

    def decimals(self, digits: int = 4) -> tuple[str, str]:
        """Return both ends in degrees, rounded inwards.

        What lies between the decimals belongs to the interval; with more digits than asked for if
        nothing would. A single orientation is rounded to the nearest decimal.

        Examples
        --------
        >>> Interval(Angle(0, (3, 2)), Angle(0, (1, 1)), True, True).decimals()
        ('33.6901', '78.6900')
        """
        if not self.width:
            return self.start.degrees(digits), self.end.degrees(digits)
        return inward_decimals(self.start, self.end, digits)

    def text(self, digits: int = 4, unit: str = "") -> str:
        """Return the interval in brackets: ``decimals`` and which of the ends belong to it."""
        left, right = "[" if self.includes_start else "(", "]" if self.includes_end else ")"
        start, end = self.decimals(digits)
        return f"{left}{start}{unit}, {end}{unit}{right}"

    def __str__(self) -> str:
        return self.text(unit="°")


def inward_decimals(start: Angle, end: Angle, digits: int = 4) -> tuple[str, str]:
    """Return two angles in degrees, the first rounded up and the second, which is larger, down.

    With so many digits more that the first decimal is the smaller one.

    Examples
    --------
    >>> inward_decimals(Angle(0, (1000, 1)), Angle(0, (999, 1)), 2)
    ('0.05730', '0.05735')
    """
    while True:
        low, high = start.degrees(digits, Rounding.UP), end.degrees(digits, Rounding.DOWN)
        if mpq(low) < mpq(high):
            return low, high
        digits += 1
