"""The infinite cost: larger than every number, exact or not.

A plan that may miss its goal has infinite cost in the search for guaranteed plans (thesis 2.5.3).
The convention is 0 * infinity = 0: a state that cannot occur costs nothing (the source leaves it
out, and without it every plan would have infinite cost).
"""

from __future__ import annotations

import math
from functools import total_ordering
from typing import Any, Final, final


@final
@total_ordering
class Infinite:
    """The type of `INFINITE`, which compares with and is added to numbers of every kind.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> mpq(10**9) < INFINITE, INFINITE + 1 == INFINITE, mpq(0) * INFINITE
    (True, True, 0)
    >>> str(INFINITE)
    'infinite'
    """

    rational = None
    """The value as a rational number: it has none."""

    def __add__(self, other: Any) -> Infinite:
        return self

    __radd__ = __add__

    def __mul__(self, other: Any) -> Any:
        """Return infinity times a probability, which is 0 or more."""
        return self if other else 0

    __rmul__ = __mul__

    def decimal(self, digits: int = 4) -> str:  # noqa: ARG002 - as every number has it
        """Return the word that stands for the number."""
        return "infinite"

    def compare(self, other: Any) -> int:
        """Return 0 for infinity, 1 for anything else."""
        return int(not is_infinite(other))

    def __eq__(self, other: object) -> bool:
        return is_infinite(other)

    def __lt__(self, other: object) -> bool:
        return False

    def __gt__(self, other: object) -> bool:
        return not is_infinite(other)

    def __hash__(self) -> int:
        return hash(math.inf)

    def __float__(self) -> float:
        return math.inf

    def __str__(self) -> str:
        return "infinite"

    def __repr__(self) -> str:
        return "INFINITE"

    def __reduce__(self) -> str:
        return "INFINITE"


INFINITE: Final = Infinite()
"""The infinite cost of exact problems; float problems have `math.inf`."""


def is_infinite(value: Any) -> bool:
    """Tell whether a cost is infinite, of an exact or a float problem."""
    return isinstance(value, Infinite) or (isinstance(value, float) and value == math.inf)
