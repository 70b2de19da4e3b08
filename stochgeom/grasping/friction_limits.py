"""The largest friction that still guarantees something, as an exact or enclosed friction angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

import flint
from gmpy2 import mpq, mpz

from stochgeom.errors import PrecisionLimitError, PriorError
from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import START_BITS, Ball, full_turn_ball, working_precision
from stochgeom.exact.decimals import check_digits, rational_decimal
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.exact.sums import AngleSum, Probability

_TRIES: Final = 4


@final
@dataclass(frozen=True)
class FrictionLimit:
    """A coefficient of friction known by its friction angle.

    Attributes
    ----------
    turns : Probability
        The friction angle in full turns, from 0 to below 1/4: exact, or enclosed as tightly as
        asked.

    Examples
    --------
    >>> FrictionLimit(AngleSum("1/8")).decimal(), FrictionLimit(AngleSum("1/12")).decimal()
    ('1.0000', '0.5773')
    """

    turns: Probability

    def decimal(self, digits: int = 4) -> str:
        """Return mu rounded down: with what is printed the guarantee holds.

        Of an exact limit the digits are certain, ties and whole values too.
        """
        digits = check_digits(digits)
        scale = mpz(10) ** digits
        bits = START_BITS + 4 * digits
        for _ in range(_TRIES):
            with working_precision(bits):
                scaled = self._tangent() * int(scale)
                whole = scaled.floor().unique_fmpz()
                near = None if whole is not None else _nearest_whole(scaled)
            if whole is not None:
                return rational_decimal(mpq(int(whole), scale), digits)
            bits *= 2
        # Undecided as the number is close to a decimal, or one: that is compared exactly.
        if near is None:
            raise PrecisionLimitError(f"{digits} decimals of a friction are undecided")
        below = self.compare(mpq(near, scale)) < 0
        return rational_decimal(mpq(near - below, scale), digits)

    def compare(self, mu: RationalLike) -> int:
        """Return -1, 0 or 1 as the limit is smaller than, equal to or larger than mu.

        Examples
        --------
        >>> FrictionLimit(AngleSum("1/8")).compare(1)
        0
        """
        return int(self.turns.compare(AngleSum(0, [(1, Angle(0, (1, rational(mu))))])))

    def degrees(self, digits: int = 4) -> str:
        """Return the friction angle in degrees, to the nearest decimal."""
        return self.turns.scaled(360).decimal(digits)

    def _tangent(self) -> Ball:
        return (self.turns.ball() * full_turn_ball()).tan()

    def __str__(self) -> str:
        return self.decimal()


def _nearest_whole(ball: Ball) -> int | None:
    """Return the whole number in a narrow ball that holds one, None if the ball is wide."""
    if not ball.rad() < flint.arb(1) / 4:
        return None
    return int((ball.mid() + flint.arb(1) / 2).mid().floor().unique_fmpz())


def as_probability(value: RationalLike) -> mpq:
    """Return a probability as an exact number.

    Raises
    ------
    PriorError
        If it is not from 0 to 1.
    """
    number = rational(value, where="probability")
    if not 0 <= number <= 1:
        raise PriorError(
            f"probability {rational_text(number):.40}; accepted: from 0 to 1", where="probability"
        )
    return number
