"""Priors from a Python function: numerical, with the errors that the quadrature reports.

Nothing here is certified: a quadrature rule sees a function at finitely many places. What is
returned says so (`Window.exact` is False, masses are `Estimated`).
"""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite, pi
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.priors import Prior, Window, check_width
from stochgeom.decision.probabilities import Estimated
from stochgeom.errors import MissingExtraError, PriorError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import from_float_exact
from stochgeom.exact.sums import AngleSum, Probability

CELLS: Final = 360
"""The circle is integrated in so many cells, each by adaptive quadrature."""

TWO_PI: Final = 2 * pi


@final
class CallablePrior(Prior):
    """A distribution given by its density, a Python function.

    Needs scipy, which the extra ``numeric`` brings.

    Parameters
    ----------
    density : callable
        From an orientation in radians, in [0, 2 pi), to the density per radian.
    tolerance : float, default 1e-6
        How far the integral may be from 1. Masses are divided by the integral.
    name : str, default "density function"
        What `describe` calls it.

    Attributes
    ----------
    integral : float
        The integral over the circle, as given.
    error : float
        The error of a mass, as the quadrature estimates it.

    Raises
    ------
    PriorError
        If the function returns NaN, infinity, something negative or no number, or its integral
        is not 1 within the tolerance.
    MissingExtraError
        If scipy is not installed.

    Notes
    -----
    The distribution is tabulated once, in `CELLS` cells; a mass takes two more quadratures. The
    best window comes from the table's best starts, refined by bounded minimisation (Brent) until
    both ends of the window have about the same density (Eq. F.5).

    Examples
    --------
    >>> from math import cos
    >>> prior = CallablePrior(lambda theta: (1 + cos(theta - 1)) / (2 * pi))
    >>> window = prior.best_window(Angle.from_degrees(90))
    >>> window.start.degrees(3), window.mass.decimal(6), window.exact
    ('12.296', '0.475079', False)
    """

    kind = "callable"

    def __init__(
        self,
        density: Callable[[float], float],
        *,
        tolerance: float = 1e-6,
        name: str = "density function",
    ) -> None:
        if not callable(density):
            raise PriorError(f"{density!r} is no function; accepted: a function of radians")
        self._quad, self._minimise = _scipy()
        self._function, self.name = density, name
        masses, errors = [], 0.0
        for k in range(CELLS):
            value, error = self._integrate(TWO_PI * k / CELLS, TWO_PI * (k + 1) / CELLS)
            masses.append(value)
            errors += error
        self.integral = float(sum(masses))
        if not abs(self.integral - 1) <= tolerance:
            raise PriorError(
                f"the density integrates to {self.integral:.9g} over [0, 2 pi); "
                f"accepted: 1 within {tolerance:g}"
            )
        self._table = np.concatenate(([0.0], np.cumsum(masses))) / self.integral
        self.error = 2 * errors + 2.0**-44

    def _value(self, x: float) -> float:
        """Return the density at x radians, checked."""
        where = f"theta = {x:.9g}"
        try:
            value = float(self._function(x % TWO_PI))
        except (TypeError, ValueError, ArithmeticError) as error:
            raise PriorError(
                f"the density fails: {error}; accepted: numbers", where=where
            ) from error
        if not isfinite(value) or value < 0:
            raise PriorError(f"the density is {value}; accepted: finite, 0 or more", where=where)
        return value

    def _integrate(self, start: float, end: float) -> tuple[float, float]:
        found = self._quad(self._value, start, end, epsabs=1e-13, epsrel=1e-11, full_output=1)
        return float(found[0]), float(found[1])

    # --- masses ----------------------------------------------------------------------------------

    def describe(self) -> str:
        """Return one line for people."""
        return f"{self.name}, numerical, error about {self.error:.0e}"

    def density_at(self, theta: Angle) -> float:
        """Return the density at theta, per full turn as in other priors, scaled to integral 1."""
        return self._value(theta.reduced().to_float()) * TWO_PI / self.integral

    def mass(self, arc: Arc) -> Probability:
        """Return the mass of an arc, with the error that the quadrature reports."""
        if arc.width == FULL_TURN:
            return AngleSum(1)
        start = arc.start.reduced().to_float()
        return Estimated(self._between(start, start + arc.width.to_float()), self.error)

    def _between(self, start: float, end: float) -> float:
        return min(1.0, max(0.0, self._below(end) - self._below(start)))

    def _below(self, x: float) -> float:
        """Return the distribution at x radians in [0, 4 pi)."""
        turn, rest = divmod(x, TWO_PI)
        cell = min(int(rest / TWO_PI * CELLS), CELLS - 1)
        part, _ = self._integrate(TWO_PI * cell / CELLS, rest)
        return float(turn + self._table[cell] + part / self.integral)

    # --- the best window -------------------------------------------------------------------------

    def best_window(self, width: Angle) -> Window:
        """Return the best window found, not proven; its mass with the error achieved."""
        if check_width(width) == FULL_TURN:
            return Window(ZERO, AngleSum(1), exact=True)
        h = width.to_float()
        starts = self._refined(h)
        masses = [self._between(start, start + h) for start in starts]
        largest = max(masses)
        # Starts that the error does not tell apart are equally good: the smallest is taken.
        good = [s for s, mass in zip(starts, masses, strict=True) if mass >= largest - self.error]
        # A start of nine decimals of a degree: exact as an angle, and readable.
        degrees = mpq(round(from_float_exact(min(good)) * 180 / from_float_exact(pi) * 10**9))
        start = Angle.from_turns(degrees / 10**9 / 360).reduced()
        return Window(start, self.mass(Arc(start, width)), exact=False)

    def _refined(self, h: float) -> list[float]:
        """Return 0 and the local maxima of the table, each refined within its cells."""
        grid = np.arange(CELLS) * (TWO_PI / CELLS)
        ends = (grid + h) / TWO_PI
        whole = np.floor(ends)
        places = np.arange(CELLS + 1) / CELLS
        gains = np.interp(ends - whole, places, self._table) + whole - self._table[:-1]
        peaks = (gains >= np.roll(gains, 1)) & (gains >= np.roll(gains, -1))
        order = np.argsort(-gains, kind="stable")
        found = [0.0]
        for k in [int(k) for k in order if peaks[k]][:8]:
            cell = TWO_PI / CELLS
            refined = self._minimise(
                lambda x: -self._between(x % TWO_PI, x % TWO_PI + h),
                bounds=(grid[k] - cell, grid[k] + cell),
                method="bounded",
                options={"xatol": 1e-9},
            )
            found += [float(grid[k]), float(refined.x) % TWO_PI]
        return found


def _scipy() -> tuple[Any, Any]:
    try:
        from scipy.integrate import quad
        from scipy.optimize import minimize_scalar
    except ImportError as error:
        raise MissingExtraError.of("densities given as functions", "scipy", "numeric") from error
    return quad, minimize_scalar
