"""The Beta density: a Dirichlet density of two outcomes (thesis appendix G)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import final

from gmpy2 import mpq

from stochgeom.errors import PriorError
from stochgeom.exact.scalars import RationalLike, rational, rational_text


@final
@dataclass(frozen=True, slots=True)
class BetaDensity:
    """The density of p_2 when (p_1, p_2) has a Dirichlet density (Eq. G.1).

    Parameters
    ----------
    alpha_1, alpha_2 : rational
        The parameters, positive.

    Raises
    ------
    PriorError
        If a parameter is not positive.

    Examples
    --------
    >>> skewed = BetaDensity(4, 1)
    >>> skewed.mean, skewed.variance, f"{skewed(0.0):.6f}"
    (mpq(1,5), mpq(2,75), '4.000000')
    """

    alpha_1: mpq
    alpha_2: mpq

    def __init__(self, alpha_1: RationalLike, alpha_2: RationalLike) -> None:
        for name, value in (("alpha_1", alpha_1), ("alpha_2", alpha_2)):
            number = rational(value, where=name)
            if number <= 0:
                raise PriorError(f"{rational_text(number)}; accepted: numbers above 0", where=name)
            object.__setattr__(self, name, number)

    @property
    def mean(self) -> mpq:
        """Mean of p_2."""
        return self.alpha_2 / (self.alpha_1 + self.alpha_2)

    @property
    def variance(self) -> mpq:
        """Variance of p_2, and of p_1."""
        return self.mean * (1 - self.mean) / (self.alpha_1 + self.alpha_2 + 1)

    def __call__(self, p: float) -> float:
        """Return the density at `p` in [0, 1], a float; infinite at an end where it has a pole."""
        if not 0 <= p <= 1:
            return 0.0
        a, b = float(self.alpha_1), float(self.alpha_2)
        if (p == 0 and b < 1) or (p == 1 and a < 1):
            return math.inf
        if (p == 0 and b > 1) or (p == 1 and a > 1):
            return 0.0
        log = math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b)
        log += (a - 1) * math.log1p(-p) if a != 1 else 0.0
        log += (b - 1) * math.log(p) if b != 1 else 0.0
        return math.exp(log)
