"""Coulomb friction between a part and the jaws, as an exact angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias, final

import flint
from gmpy2 import mpq

from stochgeom.errors import FrictionError
from stochgeom.exact.angles import QUARTER_TURN, ZERO, Angle
from stochgeom.exact.balls import Ball, full_turn_ball
from stochgeom.exact.decimals import Rounding, certified_decimal, rational_decimal
from stochgeom.exact.scalars import RationalLike, rational, rational_text

FrictionLike: TypeAlias = "Friction | Angle | RationalLike"
"""A `Friction`, a friction angle, or a coefficient of friction as an exact number."""


@final
@dataclass(frozen=True, slots=True)
class Friction:
    """Friction between a part and the jaws: forces lie within `angle` of the jaw's normal.

    Parameters
    ----------
    angle : Angle
        The friction angle arctan mu, in [0, 90) degrees.

    Raises
    ------
    FrictionError
        For any other angle.

    Examples
    --------
    >>> Friction.of("0.25").angle
    Angle(0, (4, 1))
    >>> Friction(Angle(0, (4, 1))).coefficient
    mpq(1,4)
    """

    angle: Angle

    def __post_init__(self) -> None:
        if not isinstance(self.angle, Angle):
            raise FrictionError(
                f"{self.angle!r:.60} is no angle; accepted: an Angle, or Friction.of(coefficient)",
                where="mu",
            )
        if not ZERO <= self.angle < QUARTER_TURN:
            raise FrictionError(
                f"friction angle {self.angle}; accepted: from 0 to below 90°", where="mu"
            )

    @classmethod
    def of(cls, value: FrictionLike) -> Friction:
        """Return the friction of a coefficient mu or of a friction angle.

        Parameters
        ----------
        value : rational, Angle or Friction
            mu, 0 or more, as an exact number or text; or the angle arctan mu.

        Raises
        ------
        FrictionError
            If mu is negative, or the angle outside [0, 90) degrees.
        NumberError
            If it is no exact number; floats are refused.

        Examples
        --------
        >>> Friction.of("-1/4")
        Traceback (most recent call last):
        ...
        stochgeom.errors.FrictionError: mu: the coefficient of friction -1/4 is negative; \
accepted: 0 or more
        """
        if isinstance(value, Friction):
            return value
        if isinstance(value, Angle):
            return cls(value)
        mu = rational(value, where="mu")
        if mu < 0:
            raise FrictionError(
                f"the coefficient of friction {rational_text(mu):.40} is negative; "
                "accepted: 0 or more",
                where="mu",
            )
        return cls(Angle(0, (1, mu)))

    @property
    def coefficient(self) -> mpq | None:
        """The coefficient of friction mu if it is rational, else None."""
        if self.angle.turn_part.denominator != 1:
            return None
        x, y = self.angle.direction
        return mpq(y, x)

    def decimal(self, digits: int = 4, rounding: Rounding = Rounding.NEAREST) -> str:
        """Return mu as a correctly rounded decimal.

        Examples
        --------
        >>> Friction(Angle.from_degrees(30)).decimal(6)
        '0.577350'
        """
        mu = self.coefficient
        if mu is not None:
            return rational_decimal(mu, digits, rounding)
        return certified_decimal(self._ball, digits, rounding)

    def _ball(self) -> Ball:
        angle: flint.arb = self.angle.ball() * full_turn_ball()
        return angle.tan()

    def __str__(self) -> str:
        mu = self.coefficient
        return self.decimal(4) if mu is None else rational_text(mu)
