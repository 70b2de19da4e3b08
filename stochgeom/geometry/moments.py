"""Area and first moments of a long outline of machine integers, exactly, on arrays.

The sums have up to 160 bits and more. Everything is cut into digits so short that float64 holds
each product and each sum of a block's products exactly, in any order of summation; Python's
integers put the few block sums together.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from gmpy2 import mpz

from stochgeom.exact.predicates import IntArray
from stochgeom.exact.vectors import FloatArray

_HALF: Final = 27
"""Bits of a digit of a coordinate, and of a cross product."""
_SHORT: Final = 14
"""Bits of a digit of a sum of two coordinates."""
_BLOCK: Final = 2**12
"""Vertices summed at a time: digits of 27 and 14 bits and 2**12 products make 2**53."""


def ring_sums(x: IntArray, y: IntArray) -> tuple[mpz, mpz, mpz]:
    """Return the sums of c_k, c_k (x_{k-1} + x_k) and c_k (y_{k-1} + y_k) over a closed outline.

    c_k is the cross product of vertices k - 1 and k. Coordinates are int64, below 2**52.  O(n).

    Examples
    --------
    >>> ring_sums(np.array([0, 3, 3, 0]), np.array([0, 0, 2, 2]))
    (mpz(12), mpz(54), mpz(36))
    """
    x, y = np.concatenate((x[-1:], x)), np.concatenate((y[-1:], y))
    total = [mpz(0)] * 3
    for start in range(0, len(x) - 1, _BLOCK):
        block = slice(start, start + _BLOCK + 1)
        for k, value in enumerate(_block_sums(x[block], y[block])):
            total[k] += value
    return total[0], total[1], total[2]


def _block_sums(x: IntArray, y: IntArray) -> tuple[mpz, mpz, mpz]:
    """Return the three sums over consecutive pairs of a stretch of vertices."""
    crosses = _cross_digits(x, y)
    factors = [np.ones((1, len(x) - 1)), *(_sum_digits(v[:-1] + v[1:]) for v in (x, y))]
    values = [crosses @ factor.T for factor in factors]
    first, second, third = (
        sum(
            (
                mpz(int(value)) << (_HALF * i + _SHORT * j)
                for i, row in enumerate(table.tolist())
                for j, value in enumerate(row)
            ),
            mpz(0),
        )
        for table in values
    )
    return first, second, third


def _cross_digits(x: IntArray, y: IntArray) -> FloatArray:
    """Return 4 digits of 27 bits of the cross products of neighbours; the last has the sign."""
    mask = 2**_HALF - 1
    x_low, x_high, y_low, y_high = x & mask, x >> _HALF, y & mask, y >> _HALF
    # The high parts have 25 bits and a sign: nothing here reaches 2**57.
    low = x_low[:-1] * y_low[1:] - x_low[1:] * y_low[:-1]
    middle = x_low[:-1] * y_high[1:] - x_low[1:] * y_high[:-1]
    middle += x_high[:-1] * y_low[1:] - x_high[1:] * y_low[:-1]
    high = x_high[:-1] * y_high[1:] - x_high[1:] * y_high[:-1]
    middle += low >> _HALF
    high += middle >> _HALF
    digits: FloatArray = np.empty((4, len(low)))
    digits[0], digits[1], digits[2], digits[3] = (
        low & mask,
        middle & mask,
        high & mask,
        high >> _HALF,
    )
    return digits


def _sum_digits(values: IntArray) -> FloatArray:
    """Return 4 digits of 14 bits of integers below 2**53; the last has the sign."""
    mask = 2**_SHORT - 1
    digits: FloatArray = np.empty((4, len(values)))
    for place in range(3):
        digits[place] = (values >> (_SHORT * place)) & mask
    digits[3] = values >> (_SHORT * 3)
    return digits
