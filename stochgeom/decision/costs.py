"""Costs of plans that are tried until they succeed, and how long a plan can be worth its cost.

With c_a the cost of an action, c_f that of the filter and c = c_f / c_a, a round of an i-step plan
costs i + c in units of c_a. If it succeeds with probability p, the expected cost is (i + c) / p
(thesis Eq. 4.5).
"""

from __future__ import annotations

from gmpy2 import mpq

from stochgeom.errors import CostError, InputError, NumberError
from stochgeom.exact.scalars import RationalLike, rational


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
