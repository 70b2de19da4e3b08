"""Which way parts certainly turn, for all parts whose vertices lie near those of a part.

Closing jaws turn a part towards smaller diameters, a pushing jaw towards smaller radii. Both are,
at every orientation, the height of one point above another: of the upper contact above the lower
one, or of the centre of mass above the lower one. With v the vector between them the height is
|v| sin(theta + arg v) and its slope the x-extent of v at that orientation.

- *Slopes.* Let the two points stand up to a and b away from their places. Then the extent changes
  by a + b at most. Where the extents between all possible contacts
  (`stochgeom.geometry.near_contacts`) are above a + b, the height of every such part certainly
  rises with the orientation; where all are below -(a + b), it certainly falls.
- *Rests.* As long as heights are positive their pieces are concave. So a part can rest only where
  two vertices can touch the same jaw, and only where the height neither certainly rises nor
  certainly falls.

So the outline's combinatorics may change as they like: parallel edges need not stay parallel, nor
vertices on the hull. All sets are unions of closed arcs with ends rounded outwards.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import final

import flint
from gmpy2 import mpq

from stochgeom.exact.balls import working_precision
from stochgeom.exact.outer_arcs import (
    BALL_BITS,
    TURN,
    OuterArcs,
    Units,
    units_above,
    units_below,
)
from stochgeom.geometry.near_contacts import (
    CENTER,
    HALF,
    LOWER,
    NearbyParts,
    arcsine,
    meetings,
)


@final
@dataclass(frozen=True, slots=True)
class Rest:
    """A possible place of rest: an arc of units, and the two points that touch one jaw there."""

    arc: Units
    points: tuple[int, int]


@final
@dataclass(frozen=True, slots=True)
class ContactZones:
    """What is certain of the heights of all parts near one.

    Attributes
    ----------
    not_rising, not_falling : OuterArcs
        Outside of these the height certainly rises, or falls, with the orientation.
    uncertain : OuterArcs
        Their common part.
    rests : tuple of Rest
        Every stable orientation of every such part lies in one of them.
    rest_arcs : OuterArcs
        Their union.
    """

    not_rising: OuterArcs
    not_falling: OuterArcs
    uncertain: OuterArcs
    rests: tuple[Rest, ...]
    rest_arcs: OuterArcs

    @property
    def period(self) -> int:
        """Units after which all of it repeats."""
        return self.uncertain.period

    def image(self, arc: Units) -> Units:
        """Return a lifted arc that holds where the parts come to rest from a lifted arc.

        A part turns downhill. So from theta it comes to rest not before the last orientation at
        or before theta where its height certainly falls, and not after the first one at or after
        theta where it certainly rises. Both bounds grow with theta.
        """
        low, high = arc
        before, after = self.not_falling.around(low), self.not_rising.around(high)
        return (
            self.rest_arcs.first_from(low if before is None else before[0]),
            self.rest_arcs.last_to(high if after is None else after[1]),
        )

    def rest_between(self, first: Units, second: Units) -> bool:
        """Tell whether a part may rest after the first arc and before the second."""
        return self.rest_arcs.first_from(first[1] + 1) < second[0]

    def resting_on(self, arc: Units) -> set[frozenset[int]]:
        """Return the pairs of points on which a part may rest in a lifted arc."""
        low, high = arc
        return {
            frozenset(rest.points)
            for rest in self.rests
            if OuterArcs([rest.arc], self.period).first_from(low) <= high
        }


def squeeze_zones(near: NearbyParts, epsilon: mpq) -> ContactZones | None:
    """Return what is certain of the diameter if all vertices move by `epsilon` > 0 at most.

    Modulo half a turn. None if it certainly rises, or certainly falls, nowhere.

    O(n log n + k) for k pairs of possible contacts at one orientation; k is O(n) while epsilon is
    small.

    Examples
    --------
    >>> from stochgeom.geometry.part import Part
    >>> near = NearbyParts(Part([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> zones = squeeze_zones(near, mpq(1, 100))
    >>> [round(360 * (end - start) / TURN, 2) for start, end in zones.uncertain]
    [0.64, 1.15, 0.64, 0.76]
    """
    c = 2 * epsilon
    not_rising: list[Units] = []
    not_falling: list[Units] = []
    pairs: list[Rest] = []
    for arc, first, second in meetings(near.contacts(epsilon)):
        if first[3] == second[3]:
            pairs.append(Rest(arc, (first[2], second[2])))
        else:
            lower, upper = (first, second) if first[3] == LOWER else (second, first)
            rising, falling = _undecided(near, (lower[2], upper[2]), c, arc)
            not_rising += rising
            not_falling += falling
    return _zones(not_rising, not_falling, pairs, HALF)


def push_zones(near: NearbyParts, epsilon: mpq, center_error: mpq) -> ContactZones | None:
    """Return what is certain of the radius if vertices move by `epsilon` > 0 at most.

    The centre of mass moves by `center_error` at most. Modulo a full turn; the lower jaw pushes.
    None if the radius certainly rises, or certainly falls, nowhere, or may be negative.
    """
    if near.center_clearance <= (epsilon + center_error) ** 2:
        return None
    c = epsilon + center_error
    not_rising: list[Units] = []
    not_falling: list[Units] = []
    contacts = near.contacts(epsilon)
    for start, end, k, _ in contacts:
        rising, falling = _undecided(near, (k, CENTER), c, (start, end))
        not_rising += rising
        not_falling += falling
    pairs = [
        Rest(arc, (first[2], second[2]))
        for arc, first, second in meetings(contacts)
        if first[3] == second[3]
    ]
    return _zones(not_rising, not_falling, pairs, TURN)


def _zones(
    not_rising: Iterable[Units], not_falling: Iterable[Units], pairs: list[Rest], period: int
) -> ContactZones | None:
    low, high = OuterArcs(not_rising, period), OuterArcs(not_falling, period)
    if low.is_whole or high.is_whole:
        return None
    uncertain = low.intersection(high)
    rests = tuple(
        Rest(piece, pair.points) for pair in pairs for piece in uncertain.parts_in(pair.arc)
    )
    return ContactZones(
        low, high, uncertain, rests, OuterArcs((rest.arc for rest in rests), period)
    )


def _undecided(
    near: NearbyParts, points: tuple[int, int], c: mpq, arc: Units
) -> tuple[list[Units], list[Units]]:
    """Return where in an arc the x-extent of a chord is at most c, and where at least -c."""
    if points[0] == points[1]:
        return [arc], [arc]
    with working_precision(BALL_BITS):
        squared, length, turns = near.span(*points)
        if squared <= c * c:
            return [arc], [arc]
        # The extent is |v| cos(theta + arg v): at least -c within a quarter turn and the arc sine
        # of c / |v| of its greatest, which is at -arg v.
        reach = arcsine(squared, length, c) + flint.arb(1) / 4
        start, end = units_below(-turns - reach), units_above(reach - turns)
    return _common(arc, (start + HALF, end + HALF)), _common(arc, (start, end))


def _common(arc: Units, other: Units) -> list[Units]:
    """Return what a lifted arc has in common with an arc on the circle."""
    start, end = arc
    low, high = other
    first, last = -((high - start) // TURN), (end - low) // TURN
    return [
        (max(start, low + lap * TURN), min(end, high + lap * TURN))
        for lap in range(first, last + 1)
    ]
