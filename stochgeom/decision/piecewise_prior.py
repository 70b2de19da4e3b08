"""Priors with a constant density on arcs: histograms with exact bins.

The mass of a window is continuous and piecewise linear in its start, so some best window has an
end on a boundary of the pieces; masses are exact sums of angles and are compared exactly.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any, Final, final

from gmpy2 import mpq

from stochgeom.arguments import as_count, as_list
from stochgeom.decision.atoms import WeightedPoints
from stochgeom.decision.measures import StepMeasure
from stochgeom.decision.priors import Prior, Window, as_orientation, as_pairs, as_share, normalise
from stochgeom.decision.step_density import StepDensity
from stochgeom.errors import PriorError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.exact.sums import AngleSum

MAX_BINS: Final = 100_000


@final
class PiecewisePrior(Prior):
    """A distribution with a constant density on each of some arcs, and 0 elsewhere.

    Parameters
    ----------
    pieces : iterable of (Arc, rational)
        Arcs that do not overlap, and their densities per full turn, 0 or more. The integral is
        exactly 1.

    Raises
    ------
    PriorError
        If there are no arcs, two overlap, a density is negative, or the integral is not 1.

    Examples
    --------
    >>> half = Arc(Angle.from_degrees(300), Angle.from_degrees(180))
    >>> prior = PiecewisePrior([(half, 2)])
    >>> window = prior.best_window(Angle.from_degrees(90))
    >>> window.start.degrees(0), window.mass.rational
    ('0', mpq(1,2))
    >>> prior.best_window(Angle(0, (-3, 2))).mass.decimal()
    '0.8128'
    """

    kind = "piecewise"

    def __init__(self, pieces: Iterable[tuple[Arc, RationalLike]]) -> None:
        listed = [
            (arc, as_share(value, where=f"piece {k}", what="density"))
            for k, (arc, value) in enumerate(_as_pieces(pieces, "density"))
        ]
        if not listed:
            raise PriorError("no pieces; accepted: one or more arcs with densities")
        _refuse_overlaps([arc for arc, _ in listed])
        total = AngleSum(0, [(value, arc.width) for arc, value in listed])
        if total.compare(1) != 0:
            exact = total.rational
            shown = total.decimal(6) if exact is None else rational_text(exact)
            raise PriorError(
                f"{len(listed)} densities integrate to {shown} over their arcs; "
                "accepted: densities per full turn of integral 1, or from_masses"
            )
        self.density = StepDensity.of_arcs(listed, mpq(1))
        self._measure = StepMeasure(WeightedPoints([]), self.density)

    @classmethod
    def from_masses(cls, pieces: Iterable[tuple[Arc, RationalLike]]) -> PiecewisePrior:
        """Return the prior that spreads a rational mass evenly over each arc.

        The widths must be rational in degrees: on other arcs the density would not be rational.

        Examples
        --------
        >>> quarter = Arc(Angle(), Angle.from_degrees(90))
        >>> prior = PiecewisePrior.from_masses([(quarter, "1/3"), (quarter.rotate(
        ...     Angle.from_degrees(90)), "2/3")])
        >>> prior.best_window(Angle.from_degrees(135)).mass.rational
        mpq(5,6)
        """
        listed = []
        for k, (arc, value) in enumerate(_as_pieces(pieces, "mass")):
            mass, turns = as_share(value, where=f"piece {k}", what="mass"), arc.width.rational_turns
            if turns is None:
                raise PriorError(
                    f"an arc of {arc.width} has no rational density; "
                    "accepted: widths that are rational in degrees, or densities",
                    where=f"piece {k}",
                )
            listed.append((arc, mass, turns))
        total = sum((mass for _, mass, _ in listed), start=mpq(0))
        if listed and total != 1:
            raise PriorError(f"{len(listed)} masses sum to {total}; accepted: masses of sum 1")
        return cls([(arc, mass / turns) for arc, mass, turns in listed])

    @classmethod
    def from_histogram(
        cls, edges: Sequence[RationalLike], counts: Sequence[RationalLike]
    ) -> PiecewisePrior:
        """Return the prior of a histogram of orientations.

        Parameters
        ----------
        edges : sequence of degrees as text or rational numbers
            One more than counts, strictly increasing, over at most 360 degrees.
        counts : sequence of rational
            0 or more, in proportion to the masses.

        Raises
        ------
        PriorError
            If the edges are not sorted or too far apart, or the counts do not fit.

        Examples
        --------
        >>> prior = PiecewisePrior.from_histogram(["0", "90", "180"], [1, 3])
        >>> prior.mass(Arc(Angle(), Angle.from_degrees(120))).rational
        mpq(1,2)
        """
        edges = as_list(edges, "a list of degrees", "edges", PriorError)
        counts = as_list(counts, "a list of counts", "counts", PriorError)
        ends = [rational(edge, where=f"edge {k}") for k, edge in enumerate(edges)]
        if len(ends) != len(counts) + 1:
            raise PriorError(
                f"{len(ends)} edges and {len(counts)} counts; accepted: one more edge than counts"
            )
        for k in range(1, len(ends)):
            if ends[k] <= ends[k - 1]:
                raise PriorError(
                    f"bin edges {ends[k - 1]} and {ends[k]} are not in increasing order; "
                    "accepted: strictly increasing degrees",
                    where=f"edge {k}",
                )
        if ends[-1] - ends[0] > 360:
            raise PriorError(
                f"bins span {ends[-1] - ends[0]} degrees; accepted: at most 360",
                where=f"edge {len(ends) - 1}",
            )
        shares = normalise(counts)
        places = [Angle.from_degrees(end) for end in ends]
        arcs = [Arc(a, b - a) for a, b in pairwise(places)]
        return cls.from_masses(zip(arcs, shares, strict=True))

    @classmethod
    def from_measurements(
        cls, degrees: Iterable[Angle | RationalLike], bins: int = 36
    ) -> PiecewisePrior:
        """Return the histogram of measured orientations, in bins of one width from 0 on.

        Parameters
        ----------
        degrees : iterable of text, rational numbers or Angle
            Orientations in degrees, taken modulo 360. One on an edge is in the bin above it.
        bins : int, default 36
            How many there are, from 1 to `MAX_BINS`.

        Raises
        ------
        PriorError
            If there are no measurements, or the number of bins is not acceptable.

        Examples
        --------
        >>> prior = PiecewisePrior.from_measurements(["12.5", "359", "-0.5", "90"], bins=4)
        >>> prior.mass(Arc(Angle.from_degrees(270), Angle.from_degrees(180))).rational
        mpq(3,4)
        """
        bins = as_count(bins, "bins", most=MAX_BINS, error=PriorError)
        degrees = as_list(degrees, "a list of orientations", "measurements", PriorError)
        width = Angle.from_turns(mpq(1, bins))
        counts = [0] * bins
        for k, value in enumerate(degrees):
            counts[as_orientation(value, where=f"measurement {k}") // width] += 1
        return cls.from_histogram([mpq(360 * k, bins) for k in range(bins + 1)], counts)

    def density_at(self, theta: Angle) -> mpq:
        """Return the density at theta, per full turn."""
        return self.density(theta)

    def describe(self) -> str:
        """Return one line for people."""
        count = len(self.density.breaks)
        return f"piecewise constant, {count} piece{'s' if count > 1 else ''}"

    def mass(self, arc: Arc) -> AngleSum:
        """Return the exact mass of an arc.  O(log k)."""
        return self.density.mass(arc)

    def best_window(self, width: Angle) -> Window:
        """Return the best window; among equals the one of smallest start in [0, 360) degrees.

        O(k log k) floats, and exact comparison of what they cannot tell apart.
        """
        return self._measure.best_window(width)

    def __repr__(self) -> str:
        breaks, values = self.density.breaks, self.density.densities
        ends = (*breaks[1:], FULL_TURN)
        pieces = ", ".join(
            f"({Arc(a, b - a)!r}, {rational_text(value)!r})"
            for a, b, value in zip(breaks, ends, values, strict=True)
            if value
        )
        return f"PiecewisePrior([{pieces}])"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, PiecewisePrior):
            return NotImplemented
        mine, theirs = self.density, other.density
        return mine.breaks == theirs.breaks and mine.densities == theirs.densities

    def __hash__(self) -> int:
        return hash((self.density.breaks, self.density.densities))


def _as_pieces(pieces: object, what: str) -> list[tuple[Arc, Any]]:
    pairs = as_pairs(pieces, what="piece", accepted=f"an Arc and its {what}")
    for k, (arc, _) in enumerate(pairs):
        if not isinstance(arc, Arc):
            raise PriorError(f"{arc!r:.60} is no Arc; accepted: one", where=f"piece {k}")
    return pairs


def _refuse_overlaps(arcs: list[Arc]) -> None:
    pieces = sorted(
        ((part, k) for k, arc in enumerate(arcs) for part in arc.split()),
        key=lambda pair: pair[0].start,
    )
    for (before, j), (after, k) in pairwise(pieces):
        if after.start < before.end:
            raise PriorError(
                f"pieces {min(j, k)} and {max(j, k)} overlap at {after.start}; "
                "accepted: arcs that do not overlap",
                where=f"piece {max(j, k)}",
            )
