"""Hyperstates: probability distributions over the orientations a part may be in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

from gmpy2 import mpq

from stochgeom.display import Displayed
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.ratios import TurnRatio

if TYPE_CHECKING:
    from stochgeom.exact.sums import Probability


@final
@dataclass(frozen=True, slots=True)
class Hyperstate(Displayed):
    """A distribution over finitely many orientations.

    Attributes
    ----------
    orientations : tuple of Angle
        The states in [0, 360) degrees, increasing.
    widths : tuple of Angle
        For each the measure of the initial orientations that end there; their sum is 360
        degrees, so under a uniform prior the probability is width / (2 pi).
    masses : tuple of Probability, optional
        The probabilities under another prior.

    Examples
    --------
    >>> half = Angle.from_degrees(180)
    >>> state = Hyperstate((Angle(), half), (half, half))
    >>> state.probability(0).rational
    mpq(1,2)
    """

    orientations: tuple[Angle, ...]
    widths: tuple[Angle, ...]
    masses: tuple[Probability, ...] | None = None

    def __len__(self) -> int:
        return len(self.orientations)

    def probability(self, k: int) -> Probability:
        """Return the probability of state k."""
        return self.masses[k] if self.masses is not None else TurnRatio(mpq(1), self.widths[k])

    def probabilities(self, digits: int = 4) -> tuple[str, ...]:
        """Return all probabilities as correctly rounded decimals."""
        return tuple(self.probability(k).decimal(digits) for k in range(len(self)))

    def most_likely(self) -> int:
        """Return the state of largest probability, the first of equal ones (Eq. 4.4)."""
        if self.masses is None:
            return max(range(len(self)), key=lambda k: (self.widths[k], -k))
        best = 0
        for k, mass in enumerate(self.masses):
            best = k if mass.compare(self.masses[best]) > 0 else best
        return best

    @property
    def total(self) -> Angle:
        """The sum of the widths: a full turn."""
        return sum(self.widths, start=ZERO)
