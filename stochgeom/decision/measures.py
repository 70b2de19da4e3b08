"""Points and step densities together: the exact measures, and the best window of each.

With points a_i and the breaks b_j of the density, the mass p of the window [theta, theta + h) is
linear in theta between the places a_i, a_i - h, b_j and b_j - h. Moving theta up past a_i loses
that point; moving it up past a_i - h gains it, and not before: p is continuous from the left. So
the largest mass, or its supremum, is found among

1. p(theta) at 0 and at every a_i, b_j and b_j - h: attained;
2. the limits of p from the right at every a_i - h: in general not attained.

If a limit exceeds all of 1, no window is best; one just above that limit's place is returned,
with the limit as the bound. Without points every answer is attained, without density too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.decision.atoms import WeightedPoints
from stochgeom.decision.priors import Window, check_width
from stochgeom.decision.step_density import StepDensity
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.directions import just_above
from stochgeom.exact.shadows import TWO_PI, shadow
from stochgeom.exact.sums import AngleSum
from stochgeom.exact.vectors import FloatArray

_NO_SUMS: Final = np.zeros(0, dtype=np.int64)


@dataclass(frozen=True)
class _Candidate:
    """A start, or a limit at it from the right, and the mass there."""

    start: Angle
    mass: AngleSum


@final
class StepMeasure:
    """A measure made of weighted points and a step density.

    Parameters
    ----------
    points : WeightedPoints
        Possibly none.
    density : StepDensity
        Possibly 0 everywhere. The weights and its integral sum to 1.
    """

    def __init__(self, points: WeightedPoints, density: StepDensity) -> None:
        self.points, self.density = points, density
        self._breaks = density.breaks if density.total else ()

    def mass(self, arc: Arc) -> AngleSum:
        """Return the measure of a half-open arc."""
        return self._points_in(arc) + self.density.mass(arc)

    def _points_in(self, arc: Arc) -> AngleSum:
        if not len(self.points):
            return AngleSum()
        start = arc.start.reduced()
        end = start + arc.width
        caught = self.points.numerator_below(end) - self.points.numerator_below(start)
        return AngleSum(mpq(caught, self.points.denominator))

    # --- the best window -------------------------------------------------------------------------

    def best_window(self, width: Angle) -> Window:
        """Return the window of largest mass, exactly; see the module for what is compared."""
        if check_width(width) == FULL_TURN:
            return Window(ZERO, AngleSum(1), exact=True)
        attained, limits = self._near_best(width)
        best, limit = _first_largest(attained), _first_largest(limits)
        if limit is not None and (best is None or limit.mass > best.mass):
            return self._just_above(limit, width, best)
        assert best is not None  # the largest float belongs to one or the other
        return Window(best.start, best.mass, exact=True)

    def _just_above(self, limit: _Candidate, width: Angle, best: _Candidate | None) -> Window:
        """Return a window just above a limit's place, or the best attained one if that has more."""
        angles = self.points.angles
        k = angles.count_at_most(limit.start)
        following = angles[k] if k < len(angles) else angles[0] + FULL_TURN
        start = just_above(limit.start, following).reduced()
        mass = self.mass(Arc(start, width))
        if best is not None and best.mass >= mass:
            start, mass = best.start, best.mass
        return Window(start, mass, exact=False, at_most=limit.mass)

    def _near_best(self, width: Angle) -> tuple[list[_Candidate], list[_Candidate]]:
        """Return the candidates that floats cannot rule out: attained ones, and limits."""
        h = shadow(width) / TWO_PI
        breaks = np.array([shadow(place) / TWO_PI for place in self._breaks])
        k, m = len(breaks), len(self.points)
        places = self.points.angles.shadow / TWO_PI if m else np.zeros(0)
        at_points, at_limits = self._sums_at_points(width)
        starts = np.concatenate((breaks, breaks - h, places, places - h))
        values = self.density.cumulative(starts + h) - self.density.cumulative(starts)
        if m:
            caught = (self._sums_at_breaks(width), at_points, at_limits)
            values += np.concatenate([self._shares(sums) for sums in caught])
        margin = self.density.margin + 2.0**-48
        (near,) = np.nonzero(values >= values.max() - 2 * margin)
        attained: dict[Angle, _Candidate] = {}
        if not k:  # 0 is a break of every density
            attained[ZERO] = _Candidate(ZERO, self.mass(Arc(ZERO, width)))
        limits: list[_Candidate] = []
        for index in near.tolist():
            if index < 2 * k:
                place = self._breaks[index % k]
                start = place if index < k else (place - width).reduced()
                if start not in attained:
                    attained[start] = _Candidate(start, self.mass(Arc(start, width)))
            elif index < 2 * k + m:
                start = self.points.angles[index - 2 * k]
                attained[start] = self._candidate(start, width, at_points[index - 2 * k])
            else:
                j = index - 2 * k - m
                start = (self.points.angles[j] - width).reduced()
                limits.append(self._candidate(start, width, at_limits[j]))
        return list(attained.values()), limits

    def _candidate(self, start: Angle, width: Angle, caught: Any) -> _Candidate:
        weight = AngleSum(mpq(int(caught), self.points.denominator))
        return _Candidate(start, weight + self.density.mass(Arc(start, width)))

    def _sums_at_points(self, width: Angle) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return for each point a the sums of numerators in [a, a + h) and in (a - h, a]."""
        m = len(self.points)
        if not m:
            return _NO_SUMS, _NO_SUMS
        last, sums = self.points.last_below(width), self.points.sums
        # Point i + h is above point k iff k <= last[i]; the sequence continues a turn before 0.
        extended = np.concatenate((last - m, last))
        numbers = np.arange(m)
        first = np.searchsorted(extended, numbers, "left")
        return sums[last + 1] - sums[:m], sums[numbers + m + 1] - sums[first]

    def _shares(self, sums: NDArray[Any]) -> FloatArray:
        """Return sums of numerators as floats, relatively within 2**-51."""
        whole = self.points.denominator
        if sums.dtype == object:  # perhaps beyond the largest float
            return np.array([float(mpq(int(n), whole)) for n in sums], dtype=np.float64)
        return sums / float(whole)

    def _sums_at_breaks(self, width: Angle) -> NDArray[Any]:
        """Return the sums of numerators in the windows at every b and every b - h."""
        breaks = self._breaks
        starts = [*breaks, *((place - width).reduced() for place in breaks)]
        below = self.points.numerator_below
        return np.array([below(s + width) - below(s) for s in starts], dtype=object)


def _first_largest(candidates: list[_Candidate]) -> _Candidate | None:
    """Return the candidate of largest mass, the smallest start among equals."""
    best: _Candidate | None = None
    for candidate in candidates:
        order = 1 if best is None else candidate.mass.compare(best.mass)
        if best is None or order > 0 or (order == 0 and candidate.start < best.start):
            best = candidate
    return best
