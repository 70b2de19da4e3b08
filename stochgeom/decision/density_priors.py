"""Normal and von Mises priors on the circle: masses certified by ball arithmetic.

Both densities are symmetric about their mean and fall from it to its opposite, so the best window
is centred on the mean (thesis App. F, on the normal). Its start, mean - width / 2, is in general
no `Angle`; the window placed begins within a 2**-20th of the width from there (see
`stochgeom.exact.halves`). The mass of the window placed and that of the centred one are both
certified. They differ by the square of the shift times the slope of the density at the ends, as
the two ends have the same density (Eq. F.5).
"""

from __future__ import annotations

from abc import abstractmethod
from math import ceil, sqrt
from typing import Final, final

import flint

from stochgeom.decision.priors import Prior, Window, as_orientation, check_width
from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import PriorError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.balls import Ball, full_turn_ball, rational_ball
from stochgeom.exact.halves import near_half
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.exact.sums import AngleSum, Probability

MAX_SD: Final = 3600
"""A wider normal is uniform to hundreds of digits: comparing masses would need as many."""

MAX_KAPPA: Final = 10**9
"""Integrals of sharper peaks take long; this one is as sharp as a normal of sd 0.002 degrees."""


class SymmetricPrior(Prior):
    """A continuous distribution, symmetric about its mean and falling from it to its opposite.

    Attributes
    ----------
    mean : Angle
        In [0, 360) degrees.
    """

    mean: Angle

    def mass(self, arc: Arc) -> Probability:
        """Return the certified mass of an arc; mirror images about the mean are equal."""
        if arc.width == FULL_TURN:
            return AngleSum(1)
        offset = (arc.start - self.mean).reduced()
        mirrored = (self.mean - arc.end).reduced()
        start, width = min(offset, mirrored), arc.width
        return Enclosed.of(
            lambda: self._between(start.ball(), (start + width).ball()), (self, start, width)
        )

    def best_window(self, width: Angle) -> Window:
        """Return the window centred on the mean, or one close to it and its mass as a bound."""
        if check_width(width) == FULL_TURN:
            return Window(ZERO, AngleSum(1), exact=True)
        half, exact = near_half(width)
        start = (self.mean - half).reduced()
        mass = self.mass(Arc(start, width))
        return Window(start, mass, exact, None if exact else self._centred(width))

    def _centred(self, width: Angle) -> Enclosed:
        def enclose() -> Ball:
            half = width.ball() / 2
            return self._between(-half, half)

        return Enclosed.of(enclose, (self, "centred", width))

    def density_at(self, theta: Angle) -> Enclosed:
        """Return the certified density at theta, per full turn."""
        offset = (theta - self.mean).reduced()
        offset = min(offset, (-offset).reduced())
        return Enclosed.of(lambda: self._density(offset.ball()), (self, "density", offset))

    @abstractmethod
    def _between(self, start: Ball, end: Ball) -> Ball:
        """Enclose the mass between two offsets from the mean, in turns: -1/2 <= start < end <= 2.

        They are less than a turn apart.
        """

    @abstractmethod
    def _density(self, offset: Ball) -> Ball:
        """Enclose the density at an offset from the mean in [0, 1/2] turns."""


@final
class WrappedNormal(SymmetricPrior):
    """The normal distribution, wrapped around the circle.

    Parameters
    ----------
    mean : Angle, or degrees as text or a rational number
        The centre.
    sd : rational, or degrees as text
        The standard deviation before wrapping, in degrees, more than 0 and at most `MAX_SD`.

    Raises
    ------
    PriorError
        If sd is not positive, or too large.

    Notes
    -----
    Up to a standard deviation of 90 degrees a mass is a sum over the copies of the line's normal
    distribution, by Arb's error function; what lies outside the copies summed is below an erfc
    that Arb encloses too. Beyond, the Fourier series is summed; with q = exp(-sd^2 / 2), sd in
    radians, terms from N + 1 on are below q^((N + 1)^2) / (1 - q) together.

    Examples
    --------
    >>> prior = WrappedNormal("10", "5")
    >>> window = prior.best_window(Angle.from_degrees(20))
    >>> window.start.degrees(0), window.mass.decimal(6), window.exact
    ('0', '0.954500', True)
    """

    kind = "normal"

    def __init__(self, mean: Angle | RationalLike, sd: RationalLike) -> None:
        self.mean = as_orientation(mean, where="mean")
        self.sd = rational(sd, where="standard deviation")
        if not 0 < self.sd <= MAX_SD:
            raise PriorError(
                f"standard deviation {self.sd}; accepted: more than 0 and at most {MAX_SD} degrees "
                "(beyond, the uniform distribution is the same to all digits shown)"
            )

    def describe(self) -> str:
        """Return one line for people."""
        sd = Angle.from_degrees(self.sd)
        return f"normal, mean {self.mean}, standard deviation {sd}"

    def _between(self, start: Ball, end: Ball) -> Ball:
        if self.sd > 90:
            rise = flint.arb(0)
            for n in range(1, self._terms() + 1):
                angle = full_turn_ball() * n
                rise += self._damping(n * n) * ((end * angle).sin() - (start * angle).sin()) / n
            rise += _plus_minus(self._series_tail())
            return end - start + rise / flint.arb.pi()
        scale = rational_ball(self.sd / 360) * flint.arb(2).sqrt()
        copies = self._copies()
        total = flint.arb(0)
        # The copies of the arc left out are disjoint, and below -copies or above copies turns.
        for k in range(1 - copies, copies + 2):
            total += _normal_between((start - k) / scale, (end - k) / scale)
        return total + _up_to((flint.arb(copies) / scale).erfc())

    def _density(self, offset: Ball) -> Ball:
        if self.sd > 90:
            total = flint.arb(1)
            for n in range(1, self._terms() + 1):
                total += 2 * self._damping(n * n) * (full_turn_ball() * offset * n).cos()
            return total + _plus_minus(2 * self._series_tail())
        copies = self._copies()
        twice = 2 * rational_ball(self.sd / 360) ** 2
        total = flint.arb(0)
        for k in range(1 - copies, copies + 1):
            total += (-((offset - k) ** 2) / twice).exp()
        # Terms left out have |offset - k| >= copies; each next one is smaller by this factor.
        factor = (-flint.arb(2 * copies) / twice).exp()
        tail = 2 * (-flint.arb(copies * copies) / twice).exp() / (1 - factor)
        return (total + _up_to(tail)) / (twice * flint.arb.pi()).sqrt()

    def _copies(self) -> int:
        """Return how many turns to sum to either side, so that the tail is below the precision.

        A mass half a turn off the mean is about exp(-1 / (8 s^2)), s = sd in turns; the tail at
        c turns is about exp(-c^2 / (2 s^2)). A number too small would widen the ball, not more.
        """
        s = float(self.sd / 360)
        return 1 + ceil(sqrt(0.25 + 1.4 * flint.ctx.prec * s * s))

    def _terms(self) -> int:
        s = float(self.sd) / 57.3
        return 1 + ceil(sqrt(1.4 * flint.ctx.prec) / s)

    def _damping(self, n_squared: int) -> Ball:
        """Return exp(-n^2 sd^2 / 2), sd in radians."""
        sd = rational_ball(self.sd / 360) * full_turn_ball()
        return (-(sd**2) * n_squared / 2).exp()

    def _series_tail(self) -> Ball:
        first = self._terms() + 1
        return self._damping(first * first) / (1 - self._damping(1))

    def __repr__(self) -> str:
        return f"WrappedNormal({self.mean!r}, {rational_text(self.sd)!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, WrappedNormal):
            return NotImplemented
        return self.mean == other.mean and self.sd == other.sd

    def __hash__(self) -> int:
        return hash((WrappedNormal, self.mean, self.sd))


@final
class VonMises(SymmetricPrior):
    """The von Mises distribution, of density exp(kappa cos(theta - mean)) / (2 pi I_0(kappa)).

    Parameters
    ----------
    mean : Angle, or degrees as text or a rational number
        The centre.
    kappa : rational
        The concentration, from 0, which is the uniform distribution, to `MAX_KAPPA`.

    Raises
    ------
    PriorError
        If kappa is negative or too large.

    Notes
    -----
    Masses are integrals certified by Arb, and I_0 is Arb's Bessel function.

    Examples
    --------
    >>> prior = VonMises("10", 4)
    >>> prior.best_window(Angle.from_degrees(60)).mass.decimal(6)
    '0.680713'
    """

    kind = "von Mises"

    def __init__(self, mean: Angle | RationalLike, kappa: RationalLike) -> None:
        self.mean = as_orientation(mean, where="mean")
        self.kappa = rational(kappa, where="kappa")
        if not 0 <= self.kappa <= MAX_KAPPA:
            raise PriorError(
                f"concentration kappa {self.kappa}; accepted: 0 to {MAX_KAPPA} "
                "(beyond, a normal distribution is the same to all digits shown)"
            )

    def describe(self) -> str:
        """Return one line for people."""
        return f"von Mises, mean {self.mean}, concentration {rational_text(self.kappa)}"

    def mass(self, arc: Arc) -> Probability:
        """Return the certified mass of an arc, exact if kappa is 0."""
        return super().mass(arc) if self.kappa else AngleSum(0, [(1, arc.width)])

    def best_window(self, width: Angle) -> Window:
        """Return the window centred on the mean, or one close to it and its mass as a bound."""
        if self.kappa:
            return super().best_window(width)
        return Window(ZERO, self.mass(Arc(ZERO, width)), exact=True)

    def _between(self, start: Ball, end: Ball) -> Ball:
        # Scaled by the value of one end or of the mean, so that far from it nothing underflows.
        kappa, turn = rational_ball(self.kappa), full_turn_ball()
        peak = max(float((start * turn).cos()), float((end * turn).cos()))
        for k in (0, 1):
            peak = 1.0 if start <= k <= end else peak
        scale = flint.arb(peak)

        def integrand(x: Ball, _analytic: bool) -> Ball:
            return (kappa * ((x * turn).cos() - scale)).exp()

        found = flint.acb.integral(integrand, start, end).real
        return found * (kappa * (scale - 1)).exp() / kappa.bessel_i(0, scaled=True)

    def _density(self, offset: Ball) -> Ball:
        kappa = rational_ball(self.kappa)
        value = (kappa * ((offset * full_turn_ball()).cos() - 1)).exp()
        return value / kappa.bessel_i(0, scaled=True)

    def __repr__(self) -> str:
        return f"VonMises({self.mean!r}, {rational_text(self.kappa)!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, VonMises):
            return NotImplemented
        return self.mean == other.mean and self.kappa == other.kappa

    def __hash__(self) -> int:
        return hash((VonMises, self.mean, self.kappa))


# --- balls ---------------------------------------------------------------------------------------


def _normal_between(start: Ball, end: Ball) -> Ball:
    """Enclose (erf(end) - erf(start)) / 2 without cancellation in the tails."""
    if start > 0:
        return (start.erfc() - end.erfc()) / 2
    if end < 0:
        return ((-end).erfc() - (-start).erfc()) / 2
    return (end.erf() - start.erf()) / 2


def _up_to(bound: Ball) -> Ball:
    """Return a ball around [0, bound]."""
    return flint.arb(0).union(bound.upper())


def _plus_minus(bound: Ball) -> Ball:
    """Return a ball around [-bound, bound]."""
    end = bound.upper()
    return (-end).union(end)
