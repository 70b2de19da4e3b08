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

    def possible(self) -> Hyperstate:
        """Return the distribution without the orientations whose probability is known to be 0.

        The widths are those of the orientations that remain; their sum may be less than a turn.

        Examples
        --------
        >>> from stochgeom.exact.sums import AngleSum
        >>> half = Angle.from_degrees(180)
        >>> state = Hyperstate((Angle(), half), (half, half), (AngleSum(1), AngleSum(0)))
        >>> len(state), len(state.possible())
        (2, 1)
        """
        if self.masses is None:
            return self
        kept = [k for k, mass in enumerate(self.masses) if not _is_zero(mass)]
        if len(kept) == len(self):
            return self
        return Hyperstate(
            tuple(self.orientations[k] for k in kept),
            tuple(self.widths[k] for k in kept),
            tuple(self.masses[k] for k in kept),
        )

    @property
    def total(self) -> Angle:
        """The sum of the widths: a full turn."""
        return sum(self.widths, start=ZERO)


def _is_zero(mass: Probability) -> bool:
    """Tell whether a probability is known to be 0; an enclosed or estimated one is not."""
    return bool(mass.exact) and mass.rational == 0
