"""Priors on finitely many orientations, with rational weights (thesis App. F).

Some best window begins at one of the points: moving a window's start up to its first point loses
nothing. So the a points are tried in turn; with them sorted once, a width costs O(a) additions and
one search each, on arrays.

Windows that begin a little below an angle catch what the window there does. So there is no smallest
best start, unless 0 is one: then it is taken, else the smallest at a point.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Final, final

from gmpy2 import mpq

from stochgeom.arguments import as_list
from stochgeom.decision.atoms import WeightedPoints
from stochgeom.decision.priors import (
    Prior,
    Window,
    as_orientation,
    as_pairs,
    as_share,
    check_width,
    normalise,
)
from stochgeom.errors import PriorError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import AngleSum

_POINT: Final = "an orientation and its weight"


@final
class DiscretePrior(Prior):
    """A distribution on finitely many orientations.

    Parameters
    ----------
    weights : mapping, or iterable of pairs
        From orientations (`Angle`, or degrees as text or a rational number) to rational weights,
        0 or more, of sum 1. Orientations that are equal modulo a turn are merged.

    Attributes
    ----------
    points : WeightedPoints
        The orientations of positive weight, in increasing order from 0.

    Raises
    ------
    PriorError
        If there are none, a weight is negative, or the sum is not 1.
    NumberError
        For an orientation or a weight that is no exact number; floats are refused.

    Examples
    --------
    >>> prior = DiscretePrior({"0": "1/2", "90": "1/4", "100.5": "1/4"})
    >>> window = prior.best_window(Angle.from_degrees(100))
    >>> window.start.degrees(0), str(window.mass)
    ('0', '0.7500')
    >>> prior.best_window(Angle.from_degrees(90)).mass.rational
    mpq(1,2)
    """

    kind = "discrete"

    def __init__(
        self,
        weights: Mapping[Angle | RationalLike, RationalLike]
        | Iterable[tuple[Angle | RationalLike, RationalLike]],
    ) -> None:
        pairs = as_pairs(weights, what="point", accepted=_POINT)
        listed = [
            (as_orientation(key, where=f"point {k}"), as_share(value, where=f"point {k}"))
            for k, (key, value) in enumerate(pairs)
        ]
        total = sum((weight for _, weight in listed), start=mpq(0))
        if total != 1:
            what = f"{len(listed)} weights sum to {total}" if listed else "no points"
            raise PriorError(f"{what}; accepted: weights of sum 1, or from_counts")
        self.points = WeightedPoints(listed)

    @classmethod
    def from_counts(
        cls,
        counts: Mapping[Angle | RationalLike, RationalLike]
        | Iterable[tuple[Angle | RationalLike, RationalLike]],
    ) -> DiscretePrior:
        """Return the prior whose weights are in proportion to counts.

        Examples
        --------
        >>> DiscretePrior.from_counts({"10": 3, "200": 1}).weights
        (mpq(3,4), mpq(1,4))
        """
        pairs = as_pairs(counts, what="point", accepted=_POINT)
        shares = normalise([count for _, count in pairs])
        return cls([(key, share) for (key, _), share in zip(pairs, shares, strict=True)])

    @classmethod
    def from_measurements(cls, degrees: Iterable[Angle | RationalLike]) -> DiscretePrior:
        """Return the prior that gives each measured orientation the same weight.

        Parameters
        ----------
        degrees : iterable of text, rational numbers or Angle
            Orientations in degrees; equal ones add up.

        Examples
        --------
        >>> prior = DiscretePrior.from_measurements(["12.5", "13", "-347.5", "200"])
        >>> [(angle.degrees(1), str(weight)) for angle, weight in prior]
        [('12.5', '1/2'), ('13.0', '1/4'), ('200.0', '1/4')]
        """
        listed = as_list(degrees, "a list of orientations", "measurements", PriorError)
        return cls.from_counts([(value, 1) for value in listed])

    @property
    def orientations(self) -> tuple[Angle, ...]:
        """The orientations of positive weight, increasing from 0."""
        return self.points.angles.angles

    @property
    def weights(self) -> tuple[mpq, ...]:
        """Their weights, in the same order."""
        return tuple(mpq(n, self.points.denominator) for n in self.points.numerators)

    def __iter__(self) -> Iterator[tuple[Angle, mpq]]:
        return iter(zip(self.orientations, self.weights, strict=True))

    def describe(self) -> str:
        """Return one line for people."""
        count = len(self.points)
        return f"discrete, {count} orientation{'s' if count > 1 else ''}"

    def mass(self, arc: Arc) -> AngleSum:
        """Return the sum of the weights in an arc.  O(log a)."""
        start = arc.start.reduced()
        end = start + arc.width
        caught = self.points.numerator_below(end) - self.points.numerator_below(start)
        return AngleSum(mpq(caught, self.points.denominator))

    def mass_at(self, theta: Angle) -> mpq:
        """Return the weight of an orientation, 0 if it is none of the points.  O(log a)."""
        place = theta.reduced()
        k = self.points.angles.count_at_most(place) - 1
        if k < 0 or self.points.angles[k] != place:
            return mpq(0)
        return mpq(self.points.numerators[k], self.points.denominator)

    def best_window(self, width: Angle) -> Window:
        """Return the window at 0 if it is a best one, else one at a point.  O(a) on arrays."""
        first, caught = self.points.heaviest(check_width(width))
        at_zero = self.points.numerator_below(width) == caught
        mass = AngleSum(mpq(caught, self.points.denominator))
        return Window(ZERO if at_zero else self.points.angles[first], mass, exact=True)

    def __repr__(self) -> str:
        pairs = ", ".join(f"({angle!r}, {str(weight)!r})" for angle, weight in self)
        return f"DiscretePrior([{pairs}])"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, DiscretePrior):
            return NotImplemented
        return self.orientations == other.orientations and self.weights == other.weights

    def __hash__(self) -> int:
        return hash((self.orientations, self.weights))
