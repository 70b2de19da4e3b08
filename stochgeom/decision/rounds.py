"""The number of rounds until a plan succeeds: the geometric distribution (thesis 2.3)."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Final, final

from gmpy2 import mpq

from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.balls import MAX_BITS, START_BITS, Ball, rational_ball, working_precision
from stochgeom.exact.quotients import number_sign, quotient
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.sums import AngleSum

_LONGEST_POWER: Final = 1 << 26
"""Bits of the largest power that is computed exactly to decide a tie."""


@final
class Rounds:
    """The number N of independent rounds until the first that succeeds.

    Parameters
    ----------
    probability : mpq, AngleSum or float
        p, the probability that a round succeeds: more than 0, at most 1.

    Attributes
    ----------
    probability : mpq, AngleSum or float
        p, as a rational number if it is one.

    Raises
    ------
    InputError
        For any other p.

    Examples
    --------
    >>> rounds = Rounds(mpq(1, 6))
    >>> rounds.mean, rounds.variance, rounds.probability_of(2), rounds.probability_within(2)
    (mpq(6,1), mpq(30,1), mpq(5,36), mpq(11,36))
    >>> rounds.quantile("0.95")
    17
    """

    def __init__(self, probability: Any) -> None:
        if not isinstance(probability, AngleSum | float):
            probability = rational(probability, where="success probability")
        if number_sign(probability) <= 0 or probability > 1:
            raise InputError(f"success probability {probability}; accepted: more than 0, at most 1")
        irrational = isinstance(probability, AngleSum) and probability.rational is None
        exact = isinstance(probability, AngleSum) and not irrational
        self.probability = probability.rational if exact else probability
        self._irrational = irrational

    @property
    def mean(self) -> Any:
        """E N = 1 / p."""
        return quotient(mpq(1), self.probability) if self._irrational else 1 / self.probability

    @property
    def variance(self) -> Any:
        """Var N = (1 - p) / p^2."""
        if self._irrational:
            return self._enclosed(lambda p: (1 - p) / (p * p), "variance")
        return (1 - self.probability) / self.probability**2

    def probability_of(self, count: int) -> Any:
        """Return P(N = n) = p (1 - p)^(n - 1)."""
        n = _positive(count)
        if self._irrational:
            return self._enclosed(lambda p: p * (1 - p) ** (n - 1), ("of", n))
        return self.probability * (1 - self.probability) ** (n - 1)

    def probability_within(self, count: int) -> Any:
        """Return P(N <= n) = 1 - (1 - p)^n."""
        n = _positive(count)
        if self._irrational:
            return self._enclosed(lambda p: 1 - (1 - p) ** n, ("within", n))
        return 1 - (1 - self.probability) ** n

    def quantile(self, share: RationalLike) -> int:
        """Return the smallest n with P(N <= n) >= share, for a share in [0, 1).

        Exact: where the quotient of logarithms that tells n comes out whole, powers decide.

        Raises
        ------
        InputError
            If the share is not in [0, 1).
        PrecisionLimitError
            If a tie is too long to be decided.

        Examples
        --------
        >>> Rounds(mpq(1, 2)).quantile("3/4"), Rounds(mpq(1, 2)).quantile("0.751")
        (2, 3)
        """
        q = rational(share, where="share")
        if not 0 <= q < 1:
            raise InputError(f"share {q}; accepted: from 0 up to, not including, 1")
        if q == 0 or self.probability == 1:
            return 1
        bits = START_BITS
        while bits <= MAX_BITS:
            with working_precision(bits):
                exponent = rational_ball(1 - q).log() / (1 - self._ball).log()
                whole = exponent.ceil().unique_fmpz()
                near = exponent.mid().floor().unique_fmpz() if exponent.rad() < 0.25 else None
            if whole is not None:
                return max(1, int(whole))
            if near is not None and not self._irrational:
                for n in (max(1, int(near)), int(near) + 1):
                    if self._is_tie(n, 1 - q):
                        return n
            bits *= 2
        raise PrecisionLimitError(f"a number of rounds is still undecided at {MAX_BITS} bits")

    def _is_tie(self, n: int, rest: mpq) -> bool:
        """Tell whether (1 - p)^n is exactly `rest`; one that is too long to compute is not."""
        failure = 1 - _exact(self.probability)
        size = failure.denominator.bit_length()
        # The powers of a reduced fraction are reduced: the lengths must agree, nearly.
        if abs(n * (size - 1) - rest.denominator.bit_length()) > n + 1 or n * size > _LONGEST_POWER:
            return False
        return bool(failure**n == rest)

    @property
    def _ball(self) -> Ball:
        if self._irrational:
            return self.probability.ball()
        return rational_ball(_exact(self.probability))

    def _enclosed(self, function: Any, key: Any) -> Enclosed:
        p = self.probability
        return Enclosed.of(lambda: function(p.ball()), key=(p, key))

    @cached_property
    def _text(self) -> str:
        return str(self.probability)

    def __repr__(self) -> str:
        return f"<Rounds until success of probability {self._text}>"


def _exact(value: Any) -> mpq:
    return mpq(value)  # of a float: its binary value


def _positive(count: int) -> int:
    if count < 1:
        raise InputError(f"{count} rounds; accepted: 1 or more")
    return count
