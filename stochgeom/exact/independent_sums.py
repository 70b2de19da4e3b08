"""Exact sums of logarithms and of square roots of whole numbers, with rational coefficients.

Both kinds are written over numbers that are linearly independent over the rational numbers, so a
sum is zero exactly if all its coefficients are; otherwise ball arithmetic tells its sign in the
end. Nothing is factored:

- Over a base of pairwise coprime whole numbers above 1, n = product of b**e has log n = sum of
  e log b; and sum of r log b is zero only if all r are, since a product of powers of pairwise
  coprime numbers is 1 only if every exponent is 0. With 2 in the base, logarithms to base 2 are
  rational exactly if nothing but powers of 2 is left.
- Square roots of whole numbers whose pairwise products are no squares are linearly independent
  (A. S. Besicovitch, 1940); if m n is a square, root n is the rational multiple root(m n) / m of
  root m.

Entropies of rational distributions are sums of the first kind; lengths of mean vectors of rational
directions, squared, of the second.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property, total_ordering
from operator import index
from typing import Any, Final, Self, final

import flint
from gmpy2 import gcd, is_square, isqrt, mpq, mpz

from stochgeom.errors import NumberError
from stochgeom.exact.balls import Ball, certified_float, rational_ball, sign_by_refinement
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import RationalLike, rational, rational_text

_RATIONAL_TYPES: Final = (int, Fraction, type(mpz()), type(mpq()))


@total_ordering
class IndependentSum(ABC):
    """An exact number constant + sum of q * f(n), for a function f of positive whole numbers.

    Parameters
    ----------
    constant : rational
        The constant.
    terms : iterable of (rational, int)
        The coefficients q and the whole numbers n > 0.

    Attributes
    ----------
    constant, terms :
        The number over independent f(n), all coefficients other than 0.

    Raises
    ------
    NumberError
        If an n is not positive.
    """

    exact = True
    """Whether the number is known exactly: yes."""

    constant: mpq
    terms: tuple[tuple[mpq, mpz], ...]

    def __init__(
        self, constant: RationalLike = 0, terms: Iterable[tuple[RationalLike, Any]] = ()
    ) -> None:
        gathered: dict[mpz, mpq] = {}
        try:
            for factor, number in terms:
                n = mpz(index(number))
                if n <= 0:
                    raise NumberError(f"{n} in a sum; accepted: whole numbers above 0")
                gathered[n] = gathered.get(n, mpq(0)) + rational(factor)
        except (TypeError, ValueError) as error:
            if isinstance(error, NumberError):
                raise
            raise NumberError(
                f"{terms!r:.60}; accepted: pairs, each a rational and a whole number above 0",
                where="terms",
            ) from error
        start = rational(constant, where="constant of a sum")
        self.constant, self.terms = self._independent(start, gathered)

    @abstractmethod
    def _independent(
        self, constant: mpq, terms: dict[mpz, mpq]
    ) -> tuple[mpq, tuple[tuple[mpq, mpz], ...]]:
        """Write the sum over independent numbers."""

    @abstractmethod
    def _ball_of(self, number: mpz) -> Ball:
        """Enclose f(n)."""

    @property
    def rational(self) -> mpq | None:
        """The exact value if it is rational, else None."""
        return None if self.terms else self.constant

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        total = rational_ball(self.constant)
        for q, n in self.terms:
            total += rational_ball(q) * self._ball_of(n)
        return total

    @cached_property
    def _sign(self) -> int:
        return sign_by_refinement(self.ball) if self.terms else sign(self.constant)

    def sign(self) -> int:
        """Return -1, 0 or 1, exactly."""
        return self._sign

    def scaled(self, q: RationalLike) -> Self:
        """Return the number times a rational number."""
        factor = rational(q)
        return type(self)(self.constant * factor, [(r * factor, n) for r, n in self.terms])

    def __add__(self, other: Any) -> Self:
        if isinstance(other, _RATIONAL_TYPES):
            return type(self)(self.constant + other, self.terms)
        if type(other) is not type(self):
            return NotImplemented
        return type(self)(self.constant + other.constant, (*self.terms, *other.terms))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Self:
        return self + other.scaled(-1) if isinstance(other, IndependentSum) else self + -other

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`, exactly."""
        return (self - (other if isinstance(other, type(self)) else rational(other))).sign()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (type(self), *_RATIONAL_TYPES)):
            return NotImplemented
        return self.compare(other) == 0

    def __lt__(self, other: Any) -> bool:
        if not isinstance(other, (type(self), *_RATIONAL_TYPES)):
            return NotImplemented
        return self.compare(other) < 0

    def __hash__(self) -> int:
        # Equal numbers may be written over different bases, so only the value can be hashed.
        return hash(self.decimal(12) if self.terms else self.constant)

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal (ties to even)."""
        if not self.terms:
            return rational_decimal(self.constant, digits)
        return certified_decimal(self.ball, digits)

    def __float__(self) -> float:
        return certified_float(self.ball) if self.terms else float(self.constant)

    def __str__(self) -> str:
        return self.decimal(4)

    def __repr__(self) -> str:
        terms = ", ".join(f"({rational_text(q)!r}, {int(n)})" for q, n in self.terms)
        return f"{type(self).__name__}({rational_text(self.constant)!r}, [{terms}])"


@final
class LogSum(IndependentSum):
    """The exact number constant + sum of q * log2(n).

    Examples
    --------
    >>> LogSum(0, [(1, 6), (-1, 3)]).rational
    mpq(1,1)
    >>> LogSum(0, [(2, 6)]) == LogSum(2, [(1, 9)])
    True
    >>> LogSum(0, [(1, 3)]).decimal(6)
    '1.584963'
    """

    def _independent(
        self, constant: mpq, terms: dict[mpz, mpq]
    ) -> tuple[mpq, tuple[tuple[mpq, mpz], ...]]:
        odd: dict[mpz, mpq] = {}
        for n, q in terms.items():
            twos = n.bit_scan1(0)
            constant += q * twos
            odd[n >> twos] = odd.get(n >> twos, mpq(0)) + q
        factors: dict[mpz, mpq] = {}
        base = _coprime_base(odd)
        for n, q in odd.items():
            for b in base:
                count, rest = 0, n
                while rest % b == 0:
                    count, rest = count + 1, rest // b
                if count:
                    factors[b] = factors.get(b, mpq(0)) + q * count
        return constant, tuple((q, b) for b, q in sorted(factors.items()) if q)

    def _ball_of(self, number: mpz) -> Ball:
        return flint.arb(int(number)).log() / flint.arb.const_log2()


@final
class RootSum(IndependentSum):
    """The exact number constant + sum of q * sqrt(n).

    Examples
    --------
    >>> RootSum(0, [(1, 8), (-2, 2)]).rational
    mpq(0,1)
    >>> RootSum(0, [(1, 2), (1, 3)]) < RootSum(0, [(1, 10)])
    True
    """

    def _independent(
        self, constant: mpq, terms: dict[mpz, mpq]
    ) -> tuple[mpq, tuple[tuple[mpq, mpz], ...]]:
        classes: dict[mpz, mpq] = {}
        for n, q in sorted(terms.items()):
            if is_square(n):
                constant += q * isqrt(n)
                continue
            like = next((m for m in classes if is_square(m * n)), n)
            classes[like] = classes.get(like, mpq(0)) + q * mpq(isqrt(like * n), like)
        return constant, tuple((q, n) for n, q in classes.items() if q)

    def _ball_of(self, number: mpz) -> Ball:
        return flint.arb(int(number)).sqrt()


def _coprime_base(numbers: Iterable[mpz]) -> list[mpz]:
    """Return pairwise coprime numbers above 1 that generate the given ones."""
    base: list[mpz] = []
    waiting = [n for n in numbers if n > 1]
    while waiting:
        # Invariant: base is pairwise coprime; base and waiting together generate the input.
        number = waiting.pop()
        for place, element in enumerate(base):
            common = gcd(number, element)
            if common == 1:
                continue
            del base[place]
            waiting.extend(n for n in (common, number // common, element // common) if n > 1)
            break
        else:
            base.append(number)
    return base
