"""The difference of two independent angles is uniform if one of them is (thesis Thm 3.1).

That is why a random turn of the gripper makes the orientation of the part, as the gripper sees it,
uniform, whatever it was (Eq. 3.9 to 3.12). On the cyclic group of n equal turns the statement is
exact and finite: with X uniform on Z_n and Y independent of it,

    P(Y - X = k) = sum over j of P(Y = j) P(X = j - k) = sum over j of P(Y = j) / n = 1 / n

for each k. `cyclic_difference` computes the left-hand side for any two distributions, so that the
theorem can be checked, and so can its failure where neither is uniform. The continuous case is
looked at by simulation, in floats.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.decision.distributions import distribution
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.errors import ShapeMismatchError


def cyclic_difference(x: Sequence[Any], y: Sequence[Any]) -> tuple[Any, ...]:
    """Return the distribution of Y - X modulo n, of independent X and Y on Z_n.  O(n^2), exact.

    Parameters
    ----------
    x, y : sequence of rationals
        The probabilities of 0, 1, ..., n - 1.

    Raises
    ------
    ShapeMismatchError
        If the two differ in length.
    NotStochasticError
        If one is no distribution.

    Examples
    --------
    >>> cyclic_difference(["1/3"] * 3, ["1/2", "1/2", 0])
    (mpq(1,3), mpq(1,3), mpq(1,3))
    >>> cyclic_difference(["1/2", "1/2", 0], ["1/2", "1/2", 0])
    (mpq(1,2), mpq(1,4), mpq(1,4))
    """
    x, y = (as_list(p, "a list of probabilities") for p in (x, y))
    if len(x) != len(y):
        raise ShapeMismatchError(f"{len(x)} and {len(y)} probabilities; accepted: as many of each")
    p = distribution(list(x), NumberKind.RATIONAL, "x")
    q = distribution(list(y), NumberKind.RATIONAL, "y")
    n = len(p)
    return tuple(sum(q[j] * p[(j - k) % n] for j in range(n)) for k in range(n))


def simulated_difference(
    y: Callable[[np.random.Generator, int], NDArray[np.float64]], count: int, *, seed: int
) -> NDArray[np.float64]:
    """Return simulated values of Y - X modulo 2 pi, with X uniform on the circle.

    Parameters
    ----------
    y : callable
        ``y(generator, count)`` draws so many values of Y, in radians.
    count : int
        Number of draws.
    seed : int
        Of the random numbers.

    Raises
    ------
    InputError
        If the count is below 1.

    Examples
    --------
    >>> found = simulated_difference(lambda source, n: source.normal(1, 0.1, n), 4000, seed=1990)
    >>> bool(abs(np.exp(1j * found).mean()) < 0.05)  # no direction is preferred
    True
    """
    count = as_count(count, "draws")
    expect(y, Callable, "a function of a generator and a count", "y")
    source = np.random.default_rng(as_count(seed, "as a seed", least=0))
    turns: NDArray[np.float64] = source.uniform(0, 2 * np.pi, count)
    difference: NDArray[np.float64] = (y(source, count) - turns) % (2 * np.pi)
    return difference
