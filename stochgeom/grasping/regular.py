"""Regular polygons in closed form (thesis Eq. 3.14, and where it holds)."""

from __future__ import annotations

from typing import Final

from stochgeom.arguments import as_count
from stochgeom.errors import TooFewVerticesError
from stochgeom.exact.sums import AngleSum
from stochgeom.grasping.friction import Friction, FrictionLike

LEAST_SIDES: Final = 3


def regular_bound(n: int, mu: FrictionLike) -> AngleSum:
    """Return the bound of Eq. 3.13 for a regular polygon of uniform density, in closed form.

    With alpha the friction angle it is

    - 1 without friction, where nothing wedges;
    - 0 with friction for odd n, as every edge faces a vertex;
    - 1 - n alpha / pi for even n while n alpha < pi, and 0 from there on: each of n / 2 pairs of
      opposite vertices wedges in 2 alpha of every half turn, of which a stable edge pair has pi / n
      on either side.

    The source sets the limit at n >= floor(pi / alpha) (Eq. 3.14), which is 0 too early: for n = 12
    and mu = 1/4 it has 0, and what holds is .0643.

    Parameters
    ----------
    n : int
        Number of sides, at least 3.
    mu : rational, Angle or Friction
        The coefficient of friction, 0 or more, or the friction angle.

    Raises
    ------
    TooFewVerticesError
        For n below 3.

    Examples
    --------
    >>> regular_bound(4, "1/4").decimal(), regular_bound(12, "1/4").decimal()
    ('0.6881', '0.0643')
    >>> regular_bound(13, "1/4").decimal(), regular_bound(14, "1/4").decimal()
    ('0.0000', '0.0000')
    """
    n = as_count(n, "sides", least=LEAST_SIDES, error=TooFewVerticesError)
    alpha = Friction.of(mu).angle
    if not alpha:
        return AngleSum(1)
    if n % 2:
        return AngleSum(0)
    bound = AngleSum(1, [(-2 * n, alpha)])
    return bound if bound.sign() > 0 else AngleSum(0)
