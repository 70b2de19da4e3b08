"""The bound on P(stable) as a function of the friction (thesis Eq. 3.13 for every mu at once).

About each orientation that is stable under a push lies one interval that the push alone cannot
bring to a wedged one: it reaches to the first orientation, on either side, that is wedged. What
both jaws guarantee is where such an interval of one overlaps such an interval of the other.

With alpha the friction angle, piece p of the contacts wedges in (normal - alpha, normal + alpha),
clipped to the piece, as soon as alpha exceeds the angle from its normal orientation to the piece.
So going outwards from a stable orientation the end of its interval is given by the nearest piece
that wedges: piecewise constant or moving by alpha. The bound is a sum of such widths: piecewise
linear in alpha. It falls as friction grows, jumps down where a piece begins to wedge, and at such a
breakpoint keeps its value from before, as wedging is strict. At mu = 0 nothing wedges and it is 1;
just above it has another value, the limit, which depends on the part.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from typing import Final, final

from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.halves import HalfAngle
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import AngleSum
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.grasping.contacts import Contacts, contacts_of
from stochgeom.grasping.friction import Friction, FrictionLike
from stochgeom.grasping.friction_limits import FrictionLimit, as_probability
from stochgeom.grasping.moving_ends import Gap, Piece, gap_between, lesser, shift
from stochgeom.grasping.push_stability import Jaw, PushStability, Valley
from stochgeom.grasping.running_sums import RunningSums

KEPT_FORMS: Final = 64
"""Sums of O(n) terms that are kept when asked for."""


@final
class GuaranteedBound:
    """The lower bound of Eq. 3.13 on P(stable), for every coefficient of friction.

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
    Made in about 2 ms for each vertex; each value costs O(log n) comparisons and its decimal O(n).

    Examples
    --------
    >>> bound = GuaranteedBound([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> bound("0.25").decimal(), bound(0).decimal(), bound.limit.decimal()
    ('0.6881', '1.0000', '1.0000')
    >>> bound.largest_friction("1/2").decimal(6)
    '0.414213'
    """

    def __init__(self, part: PartLike) -> None:
        self.part = as_part(part)
        radius = RadiusFunction(self.part)
        contacts = contacts_of(DiameterFunction(self.part))
        lower = _Jaw(PushStability(radius, Jaw.LOWER), contacts)
        upper = _Jaw(PushStability(radius, Jaw.UPPER), contacts)
        self._sums = RunningSums(_changes(_overlaps(lower, upper)))
        self._starts = self._sums.starts
        self._forms: dict[int, tuple[AngleSum, int]] = {}  # asked for lately

    @property
    def breakpoints(self) -> tuple[HalfAngle, ...]:
        """The friction angles at which the form changes, increasing, above 0 degrees."""
        return tuple(HalfAngle(delta) for delta in self._starts[1:])

    @property
    def limit(self) -> AngleSum:
        """The bound as mu goes to 0, which is not its value at 0."""
        return self._form(0)[0]

    def __call__(self, mu: FrictionLike) -> AngleSum:
        """Return the exact bound for a coefficient of friction or a friction angle."""
        alpha = Friction.of(mu).angle
        if not alpha:
            return AngleSum(1)
        k = bisect_left(self._starts, alpha + alpha) - 1
        constant, slope = self._form(k)
        return constant + AngleSum(0, [(slope, alpha)])

    def _form(self, k: int) -> tuple[AngleSum, int]:
        """Return constant and slope between breakpoint k and the next."""
        found = self._forms.get(k)
        if found is None:
            weights = self._sums.at(k)
            slope = weights.pop(None, 0)
            terms = [(weight, angle) for angle, weight in weights.items() if angle is not None]
            if len(self._forms) >= KEPT_FORMS:
                self._forms.clear()
            found = self._forms[k] = AngleSum(0, terms), slope
        return found

    def largest_friction(self, probability: RationalLike) -> FrictionLimit | None:
        """Return the largest friction for which a stable grasp has at least a given probability.

        It is attained; None if any friction will do.

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
        # Invariant: just above the start of each piece before `low`, the bound is high enough.
        low, high = 0, len(self._starts)
        while low < high:
            middle = (low + high) // 2
            order = self._just_above(middle).compare(least)
            if order > 0 or (order == 0 and self._form(middle)[1] == 0):
                low = middle + 1
            else:
                high = middle
        if low == 0:
            return FrictionLimit(AngleSum(0))
        k = low - 1
        if low < len(self._starts):
            end = AngleSum(0, [("1/2", self._starts[low])])
            if self._value(k, end).compare(least) >= 0:
                return FrictionLimit(end)
        elif self._value(k, AngleSum("1/4")).compare(least) >= 0:
            return None
        constant, slope = self._form(k)
        return FrictionLimit((constant - AngleSum(least)).scaled(mpq(-1, slope)))

    def _just_above(self, k: int) -> AngleSum:
        return self._value(k, AngleSum(0, [("1/2", self._starts[k])]))

    def _value(self, k: int, turns: AngleSum) -> AngleSum:
        constant, slope = self._form(k)
        return constant + turns.scaled(slope)

    def __repr__(self) -> str:
        return f"GuaranteedBound({self.part!r})"


@final
class _Jaw:
    """The valleys of one jaw, and how the intervals about their stable orientations end."""

    def __init__(self, push: PushStability, contacts: Contacts) -> None:
        self.valleys, self._contacts = push.valleys, contacts
        places = {theta: p for p, theta in enumerate(contacts.starts)}
        # An edge that is stable under a push lies flush, so a transition is there.
        self.ends = [
            (self._below(valley, places[valley.stable]), self._above(valley, places[valley.stable]))
            for valley in push.valleys
        ]

    def __len__(self) -> int:
        return len(self.valleys)

    def _above(self, valley: Valley, first: int) -> list[Piece]:
        found = _NearestWedge(valley.high, 1)
        for low, high, normal in self._contacts.upwards(first, valley.high):
            found.pass_piece(low, high, normal)
        return found.end()

    def _below(self, valley: Valley, first: int) -> list[Piece]:
        found = _NearestWedge(valley.low, -1)
        for low, high, normal in self._contacts.downwards(first, valley.low):
            found.pass_piece(low, high, normal)
        return found.end()


class _NearestWedge:
    """Where a way outwards first meets a wedged orientation, for every friction.

    Piece by piece, the nearest first. A piece counts if it wedges under less friction than all
    nearer ones; what its end is under more friction, a nearer one tells.
    """

    def __init__(self, last: Angle, step: int) -> None:
        self._last, self._step = last, step
        self._found: list[Piece] = []  # by falling friction
        self._least: Angle | None = None

    def pass_piece(self, low: Angle, high: Angle, normal: Angle) -> None:
        """Take note of the next piece, clipped to the way: [low, high]."""
        threshold, nearer = max(normal - high, low - normal, ZERO), self._least
        if nearer is not None and threshold >= nearer:
            return
        self._least = threshold
        near, settled = (low, normal - low) if self._step > 0 else (high, high - normal)
        # The end of the wedging interval moves towards `near` and is clipped there.
        if settled <= threshold:
            self._found.append(Piece(_twice(threshold), near, 0))
            return
        if nearer is None or settled < nearer:
            self._found.append(Piece(_twice(settled), near, 0))
        self._found.append(Piece(_twice(threshold), normal, -self._step))

    def end(self) -> list[Piece]:
        """Return the moving end: where nothing wedges, the end of the way."""
        found = self._found[::-1]
        if not found or found[0].start:
            found.insert(0, Piece(ZERO, self._last, 0))
        return found


def _twice(angle: Angle) -> Angle:
    return angle + angle


def _overlaps(lower: _Jaw, upper: _Jaw) -> Iterator[list[Gap]]:
    """Yield the width that each pair of overlapping valleys of two jaws guarantees."""
    count = len(upper)

    def lifted(k: int) -> tuple[Valley, Angle]:
        turn, place = divmod(k, count)
        return upper.valleys[place], FULL_TURN * turn

    k = -count
    for valley, (below, above) in zip(lower.valleys, lower.ends, strict=True):
        # Valleys of one jaw follow each other without a gap.
        while _end_of(*lifted(k)) <= valley.low:
            k += 1
        j = k
        while True:
            other, turn = lifted(j)
            if other.low + turn >= valley.high:
                break
            other_below, other_above = upper.ends[j % count]
            low = lesser(below, shift(other_below, turn), -1)
            high = lesser(above, shift(other_above, turn))
            yield gap_between(low, high)
            j += 1


def _end_of(valley: Valley, turn: Angle) -> Angle:
    return valley.high + turn


def _changes(widths: Iterable[list[Gap]]) -> Iterator[tuple[Angle, Angle | None, int]]:
    """Yield (delta, term, weight): how a sum of widths changes above delta; None is the slope."""
    for gaps in widths:
        before = Gap(ZERO, None, 0)
        for gap in gaps:
            for ends, sign in ((gap.ends, 1), (before.ends, -1)):
                if ends is not None:
                    yield gap.start, ends[1], sign
                    yield gap.start, ends[0], -sign
            yield gap.start, None, gap.slope - before.slope
            before = gap
