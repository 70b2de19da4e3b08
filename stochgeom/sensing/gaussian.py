"""Probabilities that a reading with Gaussian noise falls between two edges, certified.

With true value d and standard deviation s, the reading lies in [a, b) with probability

    ( erf((b - d) / (s sqrt 2)) - erf((a - d) / (s sqrt 2)) ) / 2,

which Arb encloses as tightly as asked. The numbers are transcendental, so a sensor holds them
rounded: each to the nearest decimal of so many digits, except that the largest of a row takes up
what is missing from 1. Then a row of n entries is off by less than n units of the last digit, all
entries together, and that is proven.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import flint
from gmpy2 import mpq

from stochgeom.exact.balls import Ball, rational_ball
from stochgeom.exact.decimals import certified_decimal


def gaussian_bins(
    square: mpq, sd: mpq, edges: Sequence[mpq], digits: int
) -> tuple[tuple[mpq, ...], mpq]:
    """Return the probabilities of the bins between edges, rounded, and a bound on the error.

    Parameters
    ----------
    square : rational
        The square of the true value, which is 0 or more.
    sd : rational
        Standard deviation of the noise, more than 0.
    edges : sequence of rationals
        Increasing; the first bin begins at minus infinity, the last one has no end.
    digits : int
        Decimals of the probabilities.

    Returns
    -------
    tuple of mpq, mpq
        Probabilities of sum 1, one more than edges; and what the sum of their errors is less than.

    Examples
    --------
    >>> row, error = gaussian_bins(mpq(4), mpq(1), [mpq(1), mpq(2), mpq(3)], 4)
    >>> [str(p) for p in row], error
    (['1587/10000', '3413/10000', '3413/10000', '1587/10000'], mpq(1,2500))
    """
    if not edges:
        return (mpq(1),), mpq(0)
    tails = [_distribution(square, sd, edge) for edge in edges]
    row = [mpq(certified_decimal(tails[0], digits))]
    for low, high in pairwise(tails):
        row.append(mpq(certified_decimal(_between(low, high), digits)))
    row.append(mpq(certified_decimal(_rest(tails[-1]), digits)))
    largest = max(range(len(row)), key=row.__getitem__)
    row[largest] += 1 - sum(row, start=mpq(0))
    # Each of n entries is off by at most half a unit, and the largest by what all others are.
    return tuple(row), mpq(len(row), 10**digits)


def _distribution(square: mpq, sd: mpq, edge: mpq) -> Callable[[], Ball]:
    def enclose() -> Ball:
        deviations = (rational_ball(edge) - rational_ball(square).sqrt()) / rational_ball(sd)
        return (1 + (deviations / flint.arb(2).sqrt()).erf()) / 2

    return enclose


def _between(low: Callable[[], Ball], high: Callable[[], Ball]) -> Callable[[], Ball]:
    return lambda: high() - low()


def _rest(low: Callable[[], Ball]) -> Callable[[], Ball]:
    return lambda: 1 - low()
