"""Costs of plans that are tried until they succeed, and how long a plan can be worth its cost.

With c_a the cost of an action, c_f that of the filter and c = c_f / c_a, a round of an i-step plan
costs i + c in units of c_a. If it succeeds with probability p, the expected cost is (i + c) / p
(thesis Eq. 4.5).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import total_ordering
from typing import TYPE_CHECKING, Any, Protocol, final

from gmpy2 import mpq

from stochgeom.errors import CostError, InputError, NumberError
from stochgeom.exact.balls import Ball, certified_float
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    import sympy

    from stochgeom.exact.sums import Probability


class Number(Protocol):
    """What an expected cost can do, whatever the probability in it is made of."""

    @property
    def rational(self) -> mpq | None:
        """The exact value if it is known to be rational, else None."""

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal."""

    def to_sympy(self) -> sympy.Expr:
        """Return the number as an exact sympy expression."""

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1."""

    def __lt__(self, other: Any) -> bool: ...

    def __float__(self) -> float: ...


@final
@total_ordering
@dataclass(frozen=True, slots=True, eq=False)
class CostOverProbability:
    """The expected cost r / p of rounds that cost r and succeed with probability p > 0.

    Attributes
    ----------
    per_round : mpq
        r.
    probability : Probability
        p, of any kind.
    """

    per_round: mpq
    probability: Probability

    @property
    def rational(self) -> mpq | None:
        """The exact value if it is known to be rational, else None."""
        p = self.probability.rational
        return None if p is None else self.per_round / p

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        p = self.probability.ball()
        return int(self.per_round.numerator) / (p * int(self.per_round.denominator))

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal (ties to even)."""
        exact = self.rational
        if exact is not None:
            return rational_decimal(exact, digits)
        return certified_decimal(self.ball, digits)

    def to_sympy(self) -> sympy.Expr:
        """Return the number as an exact sympy expression, if the probability has one."""
        import sympy

        r = sympy.Rational(int(self.per_round.numerator), int(self.per_round.denominator))
        return r / self.probability.to_sympy()

    def compare(self, other: CostOverProbability | TurnRatio) -> int:
        """Return -1, 0 or 1: r / p < s / q iff r q < s p.

        Raises
        ------
        InputError
            If the other one is no cost.
        """
        theirs = _over_probability(other)
        mine = theirs.probability.scaled(self.per_round)
        return int(mine.compare(self.probability.scaled(theirs.per_round)))

    def __eq__(self, other: object) -> bool:
        try:
            return self.compare(_over_probability(other)) == 0
        except InputError:
            return NotImplemented

    def __hash__(self) -> int:
        # Equal costs may be of different kinds, so only the value can be hashed.
        exact = self.rational
        return hash(self.decimal(12)) if exact is None else hash(exact)

    def __lt__(self, other: CostOverProbability | TurnRatio) -> bool:
        return self.compare(other) < 0

    def __float__(self) -> float:
        return certified_float(self.ball)

    def __str__(self) -> str:
        return self.decimal(4)


def _over_probability(cost: object) -> CostOverProbability:
    """Return a cost under any prior, the uniform one included, as one of this kind."""
    if isinstance(cost, CostOverProbability):
        return cost
    if isinstance(cost, TurnRatio) and cost.inverse:
        return CostOverProbability(cost.coefficient, AngleSum(0, [(1, cost.angle)]))
    raise InputError(f"{cost!r:.60} is no expected cost; accepted: one")


def expected_cost(per_round: mpq, probability: Probability) -> Number:
    """Return r / p, the expected cost of rounds that cost r and succeed with probability p.

    Examples
    --------
    >>> from stochgeom.exact.angles import Angle
    >>> str(expected_cost(mpq(2), TurnRatio(mpq(1), Angle.from_degrees(90))))
    '8.0000'
    """
    if isinstance(probability, TurnRatio):
        return TurnRatio(per_round / probability.coefficient, probability.angle, inverse=True)
    return CostOverProbability(per_round, probability)


def as_cost_ratio(value: RationalLike) -> mpq:
    """Return c = c_f / c_a as an exact number.

    Raises
    ------
    CostError
        If the value is negative or not a rational number.

    Examples
    --------
    >>> as_cost_ratio("1.5")
    mpq(3,2)
    """
    try:
        c = rational(value, where="cost ratio")
    except NumberError as error:
        raise CostError(
            f"{error.message}; a cost ratio is 0 or more", where="cost ratio"
        ) from error
    if c < 0:
        raise CostError(f"{c} is negative; accepted: 0 or more", where="cost ratio")
    return c


def theorem_4_1_bound(edges: int, cost_ratio: RationalLike = 1) -> int:
    """Return the most steps of a stochastically optimal plan by thesis Thm 4.1: 2 n (c + 1).

    Examples
    --------
    >>> theorem_4_1_bound(5)
    20
    """
    return _whole(2 * _positive(edges, "edges") * (as_cost_ratio(cost_ratio) + 1))


def length_bound(states: int, cost_ratio: RationalLike = 1) -> int:
    """Return the most steps of an optimal plan, from m, the number of states modulo the period.

    With q equivalent orientations a random action succeeds with probability 1 / (q m) at least,
    and no plan does with more than 1 / q. So (k + c) q <= (1 + c) q m for an optimal plan of k
    steps: k <= m (c + 1) - c. A part of n edges has m <= n states, so this is sharper than
    Thm 4.1.

    Examples
    --------
    >>> length_bound(5)
    9
    """
    c = as_cost_ratio(cost_ratio)
    return _whole(_positive(states, "states") * (c + 1) - c)


def _positive(count: int, what: str) -> int:
    if count < 1:
        raise InputError(f"{count} {what}; accepted: 1 or more")
    return count


def _whole(value: mpq) -> int:
    return int(value.numerator // value.denominator)
