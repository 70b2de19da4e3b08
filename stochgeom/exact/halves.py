"""Half of an angle: exactly where that is an `Angle`, else a simple direction close to it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import total_ordering
from typing import Any, Final, final

from gmpy2 import isqrt, mpq, mpz

from stochgeom.arguments import expect
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import Angle, make_angle
from stochgeom.exact.balls import START_BITS, Ball, exact_value, working_precision
from stochgeom.exact.decimals import Rounding, certified_decimal, rational_decimal
from stochgeom.exact.directions import simplest_between, simplest_fraction

HALF_BITS: Final = 20
"""A half that is not exact is within a 2**-20th of itself."""


def near_half(angle: Angle) -> tuple[Angle, bool]:
    """Return half of an angle, 0 or more, and whether it is exactly that.

    Half of 2 pi t + arg(x + i y) is exact if the angle is a rational number of turns or the
    length n of (x, y) is whole, as (n + x, y) has half the argument. Otherwise n is enclosed
    between two whole numbers, at a scale of 2**20 or more: the slope y / (n + x), and with it
    the half, is within a 2**-20th of the truth, and the simplest direction of that range is taken.
    Of an angle over a field, a rational number of turns that close is taken.

    Examples
    --------
    >>> near_half(Angle(0, (3, 4)))
    (Angle(0, (2, 1)), True)
    >>> half, exact = near_half(Angle(0, (3, 2)))
    >>> half.degrees(3), exact
    ('16.845', False)
    """
    turns = angle.rational_turns
    if turns is not None:
        return Angle.from_turns(turns / 2), True
    x, y = angle.direction
    if is_algebraic(x):
        return _near_half_turns(angle), False
    start = Angle.from_turns(mpq(angle.turn_part) / 2)
    square = x * x + y * y
    n = isqrt(square)
    if n * n == square:
        return start + _half_direction(n, x, y), True
    n = isqrt(square << (2 * HALF_BITS))
    x, y = x << HALF_BITS, y << HALF_BITS
    first, last = sorted([_half_direction(n, x, y), _half_direction(n + 1, x, y)])
    return start + simplest_between(first, last), False


def _half_direction(n: mpz, x: Any, y: Any) -> Angle:
    """Return half of arg(x + i y) in (0, 360) degrees, n its length, without cancellation."""
    if x < 0:
        return make_angle(0, y, n - x)
    return make_angle(0, n + x, y) if y > 0 else make_angle(0, -n - x, -y)


def _near_half_turns(angle: Angle) -> Angle:
    """Return a rational number of turns within a 2**-20th of half of a positive angle."""
    bits = START_BITS
    while True:
        with working_precision(bits):
            ball = angle.ball() / 2
            if ball.rel_accuracy_bits() > HALF_BITS + 2:
                turns = exact_value(ball.mid())
                break
        bits *= 2
    least = turns - turns / 2 ** (HALF_BITS + 2)
    return Angle.from_turns(simplest_fraction(least, turns + turns / 2 ** (HALF_BITS + 2)))


@final
@total_ordering
@dataclass(frozen=True, slots=True)
class HalfAngle:
    """Exactly half of an angle, which in general is no `Angle`: it is kept doubled.

    Attributes
    ----------
    doubled : Angle
        Twice the angle.

    Examples
    --------
    >>> third = HalfAngle(Angle(0, (3, 2)))
    >>> third.degrees(), third < HalfAngle.of(Angle(0, (3, 1))), third.angle is None
    ('16.8450', True, True)
    >>> HalfAngle(Angle(0, (3, 4))).angle
    Angle(0, (2, 1))
    """

    doubled: Angle

    @classmethod
    def of(cls, angle: Angle) -> HalfAngle:
        """Return an angle as the half of its double."""
        expect(angle, Angle, "an Angle")
        return cls(angle + angle)

    @property
    def angle(self) -> Angle | None:
        """The angle if the half is one, else None."""
        if self.doubled < _ZERO:
            positive = HalfAngle(-self.doubled).angle
            return None if positive is None else -positive
        half, exact = near_half(self.doubled)
        return half if exact else None

    @property
    def nearby(self) -> Angle:
        """The angle, or a simple direction within a 2**-20th of it."""
        half, _ = near_half(self.doubled)
        return half

    def compare(self, other: HalfAngle) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`."""
        return self.doubled.compare(other.doubled)

    def __lt__(self, other: HalfAngle) -> bool:
        return self.compare(other) < 0

    def ball(self) -> Ball:
        """Return an Arb ball around the number of turns, at the working precision."""
        return self.doubled.ball() / 2

    def degrees(self, digits: int = 4, rounding: Rounding = Rounding.NEAREST) -> str:
        """Return degrees as a correctly rounded decimal (ties to even, unless told otherwise)."""
        exact = self.doubled.rational_turns
        if exact is not None:
            return rational_decimal(exact * 180, digits, rounding)
        return certified_decimal(lambda: self.doubled.ball() * 180, digits, rounding)

    def to_float(self) -> float:
        """Return the angle in radians as a float, within two units in the last place."""
        return self.doubled.to_float() / 2

    def __str__(self) -> str:
        return f"{self.degrees()}°"


_ZERO: Final = Angle()
