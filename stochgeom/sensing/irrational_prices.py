"""Values of plans at an irrational price, exact.

A plan with expected cost C and gain G has the value C - r G at the price r. Where r = N / D is a
quotient of angle sums, the value is no angle sum; but its sign is that of C D - N G, a difference
of two products. So a value is kept as the pair (C, G), which is linear in the plan, and only
comparisons look at the price.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, final

from stochgeom.exact.quotients import SumQuotient, number_sign, sign_of_products


@final
@dataclass(frozen=True, slots=True)
class PricedValue:
    """The number cost - price * gain.

    Parameters
    ----------
    cost, gain : AngleSum or rational
        C and G.
    price : SumQuotient
        r.

    Examples
    --------
    >>> from stochgeom.exact.angles import Angle
    >>> from stochgeom.exact.sums import AngleSum
    >>> width = AngleSum(0, [(1, Angle(0, (3, 2)))])
    >>> price = IrrationalPrice(SumQuotient(1, width))
    >>> (1 - width * price).sign(), (2 - width * price).sign()
    (0, 1)
    """

    cost: Any
    gain: Any
    price: SumQuotient

    def sign(self) -> int:
        """Return the sign, exactly."""
        if number_sign(self.gain) == 0:
            return number_sign(self.cost)
        return sign_of_products(self.cost, self.price.denominator, self.price.numerator, self.gain)

    def __add__(self, other: Any) -> PricedValue:
        if isinstance(other, PricedValue):
            return PricedValue(self.cost + other.cost, self.gain + other.gain, self.price)
        return PricedValue(self.cost + other, self.gain, self.price)

    __radd__ = __add__

    def __mul__(self, factor: Any) -> PricedValue:
        return PricedValue(self.cost * factor, self.gain * factor, self.price)

    __rmul__ = __mul__

    def __sub__(self, other: Any) -> PricedValue:
        return self.__add__(-1 * other)

    def __rsub__(self, other: Any) -> PricedValue:
        return PricedValue(other - self.cost, -1 * self.gain, self.price)

    def __lt__(self, other: Any) -> bool:
        return self.__sub__(other).sign() < 0

    def __gt__(self, other: Any) -> bool:
        return self.__sub__(other).sign() > 0


@final
@dataclass(frozen=True, slots=True)
class IrrationalPrice:
    """A price that is a quotient of angle sums; gains multiplied by it are values."""

    ratio: SumQuotient

    def __rmul__(self, gain: Any) -> PricedValue:
        return PricedValue(0 * gain, -1 * gain, self.ratio)
