"""The bound of the uniform pushing model as a function of the friction (thesis App. C).

The bound is 1 less the mass of Eq. C.7 over the wedging intervals. The ends of each, clipped to a
piece of the contacts and to one side of a valley, stand still or move by the friction angle alpha;
so between breakpoints the bound is one formula, a sum of F(x) = x + x ln(L / x) with x fixed or
x = base + k alpha. It is continuous, falls from 1 at mu = 0 and comes to 0 where everything wedges.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final, final

import flint
from gmpy2 import mpq

from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.balls import Ball, ball_sign, rational_ball
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.grasping.contacts import Contacts, contacts_of
from stochgeom.grasping.friction import Friction, FrictionLike
from stochgeom.grasping.friction_limits import FrictionLimit, as_probability
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.pushing_model import sum_of_integrals
from stochgeom.grasping.running_sums import RunningSums


@final
@dataclass(frozen=True, slots=True)
class WedgeEnd:
    """x = base + slope alpha, the way from a stable orientation to an end of a wedging interval.

    Attributes
    ----------
    base : Angle
        The way where alpha is 0, or the way itself if the end stands still.
    slope : int
        -1, 0 or 1.
    length : Angle
        L, the way from the stable orientation to the unstable one behind.
    """

    base: Angle
    slope: int
    length: Angle

    def way(self, alpha: Angle) -> Angle:
        """Return x, in [0, L]."""
        return self.base + alpha * self.slope


@final
class _Formula:
    """The bound between two breakpoints: 1 less the sum of weight * F(x) over its ends."""

    def __init__(self, ends: Mapping[WedgeEnd, int]) -> None:
        self._ends = ends
        # F(x) = x where x is 0 or L; all others have a logarithm.
        self._logs = [
            (end, weight)
            for end, weight in ends.items()
            if end.slope or (end.base and end.base != end.length)
        ]
        self._constant = AngleSum(1, [(-weight, end.base) for end, weight in ends.items()])
        self._slope = -sum(weight * end.slope for end, weight in ends.items())
        self._balls: dict[int, tuple[Ball, list[tuple[int, int, Ball, Ball]]]] = {}
        self.moves = any(end.slope for end in ends)

    def at_breakpoint(self, alpha: Angle) -> Probability:
        """Return the value for any alpha, where ends may have come to 0 or L too."""
        ends = self._ends.items()
        return sum_of_integrals(1, ((-w, end.way(alpha), end.length) for end, w in ends))

    def between(self, alpha: Angle) -> Probability:
        """Return the value for an alpha between the breakpoints."""
        if not self._logs:  # then nothing moves
            return self._constant
        key = ("pushing bound", self, alpha if self.moves else None)
        return Enclosed([(1, Atom(key, lambda: self.ball(alpha.ball())))])

    def ball(self, alpha: Ball) -> Ball:
        """Return a ball around the value for alpha in full turns, between the breakpoints."""
        still, moving = self._balls_of(flint.ctx.prec)
        total = still + alpha * self._slope
        for weight, slope, base, length in moving:
            x = base + alpha * slope
            total += x * (length / x).log() * weight
        return total

    def _balls_of(self, bits: int) -> tuple[Ball, list[tuple[int, int, Ball, Ball]]]:
        """Return what does not depend on alpha, and the rest, at a working precision; kept."""
        found = self._balls.get(bits)
        if found is None:
            total, moving = self._constant.ball(), []
            for end, weight in self._logs:
                base, length = end.base.ball(), end.length.ball()
                if end.slope:
                    moving.append((-weight, end.slope, base, length))
                else:
                    total -= base * (length / base).log() * weight
            found = self._balls[bits] = total, moving
        return found


KEPT_FORMULAS: Final = 64
"""Formulas of O(n) terms that are kept when asked for."""

_Change = tuple[Angle, WedgeEnd, int]

_UNDECIDED: Final = 0


@final
class PushingBound:
    """The lower bound of App. C on P(stable), for every coefficient of friction.

    Parameters
    ----------
    part : Part, or its vertices
        Only its hull and its centre of mass matter.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Notes
    -----
    Half a turn on the jaws are exchanged, so the bound is that of the lower jaw.

    Examples
    --------
    >>> bound = PushingBound([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> bound("0.25").decimal(), bound(0).rational, bound.largest_friction("0.99").decimal()
    ('0.9453', mpq(1,1), '0.1088')
    """

    def __init__(self, part: PartLike) -> None:
        self.part = as_part(part)
        push = PushStability(RadiusFunction(self.part))
        contacts = contacts_of(DiameterFunction(self.part))
        self._ends = RunningSums(_changes(push, contacts))
        self._starts = self._ends.starts
        self._formulas: dict[int, _Formula] = {}  # asked for lately

    @property
    def breakpoints(self) -> tuple[Angle, ...]:
        """The friction angles at which the formula changes, increasing, above 0 degrees."""
        return tuple(self._starts[1:])

    def __call__(self, mu: FrictionLike) -> Probability:
        """Return the bound for a coefficient of friction or a friction angle."""
        return self._value(Friction.of(mu).angle)

    def _value(self, alpha: Angle) -> Probability:
        k = bisect_left(self._starts, alpha)
        if k < len(self._starts) and self._starts[k] == alpha:
            return self._formula(max(0, k - 1)).at_breakpoint(alpha)
        return self._formula(k - 1).between(alpha)

    def _formula(self, k: int) -> _Formula:
        if k not in self._formulas:
            if len(self._formulas) >= KEPT_FORMULAS:
                self._formulas.clear()
            self._formulas[k] = _Formula(self._ends.at(k))
        return self._formulas[k]

    def largest_friction(self, probability: RationalLike) -> FrictionLimit | None:
        """Return the largest friction for which the bound is at least a given probability.

        It is attained; None if any friction will do, for probability 0.

        Parameters
        ----------
        probability : rational
            From 0 to 1.

        Raises
        ------
        PriorError
            For any other number.
        """
        least = as_probability(probability)
        if least == 0:
            return None
        # Invariant: at breakpoint low - 1 the bound is high enough, at breakpoint high it is not.
        low, high = 1, len(self._starts)
        while low < high:
            middle = (low + high) // 2
            if self._value(self._starts[middle]).compare(least) >= 0:
                low = middle + 1
            else:
                high = middle
        k = low - 1
        start = self._starts[k]
        if self._value(start).compare(least) == 0:
            return FrictionLimit(AngleSum(0, [(1, start)]))
        return FrictionLimit(Enclosed.of(lambda: self._root(k, least), key=("root", self, least)))

    def _root(self, k: int, least: mpq) -> Ball:
        """Enclose the friction angle in piece k where the bound is `least`, by halving.

        As far as signs at the working precision tell.
        """
        low, high = self._starts[k].ball(), self._starts[k + 1].ball()
        below, above = _dyadic(low.upper()), _dyadic(high.lower())
        # Invariant: the angle is in the hull of the balls low and high.
        while below < above:
            middle = (below + above) / 2
            sign = self._sign(k, middle, least)
            if sign == _UNDECIDED or middle.denominator.bit_length() > 2 * flint.ctx.prec:
                break
            if sign > 0:
                below, low = middle, rational_ball(middle)
            else:
                above, high = middle, rational_ball(middle)
        return low.union(high)

    def _sign(self, k: int, turns: mpq, least: mpq) -> int:
        value = self._formula(k).ball(rational_ball(turns)) - rational_ball(least)
        return ball_sign(value) or _UNDECIDED

    def __repr__(self) -> str:
        return f"PushingBound({self.part!r})"


def _changes(push: PushStability, contacts: Contacts) -> Iterator[_Change]:
    """Yield (alpha, end, weight): an end that counts with a weight above a friction angle.

    F of the far end of each wedging interval counts, and F of the near one is taken off.
    """
    places = {theta: p for p, theta in enumerate(contacts.starts)}
    for valley in push.valleys:
        stable, first = valley.stable, places[valley.stable]
        length = valley.high - stable
        for low, high, normal in contacts.upwards(first, valley.high):
            yield from _ends_of(low - stable, high - stable, normal - stable, length)
        length = stable - valley.low
        for low, high, normal in contacts.downwards(first, valley.low):
            yield from _ends_of(stable - high, stable - low, stable - normal, length)


def _ends_of(near: Angle, far: Angle, normal: Angle, length: Angle) -> Iterator[_Change]:
    """Yield the changes of one piece, all counted as ways from the stable orientation."""
    threshold = max(normal - far, near - normal, ZERO)
    for clip, slope, weight in ((near, -1, -1), (far, 1, 1)):
        settled = (clip - normal) if slope > 0 else (normal - clip)
        fixed = WedgeEnd(clip, 0, length)
        if settled <= threshold:
            yield threshold, fixed, weight
            continue
        moving = WedgeEnd(normal, slope, length)
        yield threshold, moving, weight
        yield settled, moving, -weight
        yield settled, fixed, weight


def _dyadic(end: Ball) -> mpq:
    mantissa, exponent = end.man_exp()
    m, e = int(mantissa), int(exponent)
    return mpq(m << e) if e >= 0 else mpq(m, 1 << -e)
