"""Which vertices the two jaws touch, over a full turn, seen from the normal of the jaws.

Between two transitions the same two vertices touch the jaws: a *piece*. Its *normal orientation*
is the one in which the chord of the two is normal to the jaws; it may lie outside the piece. The
signed angle from an orientation theta to the normal orientation of its piece,

    rho(theta) = normal - theta,  in (-90, 90) degrees,

says everything about the squeeze: the pair is wedged iff |rho| is less than the friction angle, and
otherwise the part turns clockwise where rho > 0 (the diameter grows with theta) and
counter-clockwise where rho < 0. Along a piece rho falls; at a transition it jumps up.

Nothing here depends on the friction.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias, final

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, Angle
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.calipers import NO_EDGE
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.hull import ConvexHull

Pair: TypeAlias = "tuple[int, int]"
"""Two vertices, by their numbers in the outline."""


@final
@dataclass(frozen=True, slots=True, eq=False)
class Contacts:
    """The pieces of a full turn; piece p runs from transition p to transition p + 1.

    Attributes
    ----------
    starts : tuple of Angle
        The transitions in [0, 360) degrees, increasing; an even number of them.
    normals : tuple of Angle
        For each piece its normal orientation, lifted so that it is within 90 degrees of the piece.
    before, after : tuples of Angle
        rho at transition p, of the piece that ends there and of the one that begins there.
    pairs : tuple of (int, int)
        For each piece the outline's vertices on the lower and on the upper jaw.
    lower_edges, upper_edges : tuples of (int, int) or None
        For each transition the two ends of the hull's edge that lies flush on that jaw.
    """

    starts: tuple[Angle, ...]
    normals: tuple[Angle, ...]
    before: tuple[Angle, ...]
    after: tuple[Angle, ...]
    pairs: tuple[Pair, ...]
    lower_edges: tuple[Pair | None, ...]
    upper_edges: tuple[Pair | None, ...]

    def __len__(self) -> int:
        return len(self.starts)

    def start(self, p: int) -> Angle:
        """Return transition p, lifted to every whole p."""
        turn, place = divmod(p, len(self.starts))
        return self.starts[place] + FULL_TURN * turn if turn else self.starts[place]

    def normal(self, p: int) -> Angle:
        """Return the normal orientation of piece p, lifted to every whole p."""
        turn, place = divmod(p, len(self.starts))
        return self.normals[place] + FULL_TURN * turn if turn else self.normals[place]

    def upwards(self, p: int, end: Angle) -> Iterator[tuple[Angle, Angle, Angle]]:
        """Yield (low, high, normal) of the clipped pieces from transition p up to an end."""
        while (low := self.start(p)) < end:
            yield low, min(self.start(p + 1), end), self.normal(p)
            p += 1

    def downwards(self, p: int, end: Angle) -> Iterator[tuple[Angle, Angle, Angle]]:
        """Yield (low, high, normal) of the clipped pieces from transition p down to an end."""
        while (high := self.start(p)) > end:
            yield max(self.start(p - 1), end), high, self.normal(p - 1)
            p -= 1


def contacts_of(diameter: DiameterFunction) -> Contacts:
    """Return the contacts of a part over a full turn.  O(n) after the diameter function.

    Half a turn on the jaws are exchanged, so half a turn is computed.

    Examples
    --------
    >>> found = contacts_of(DiameterFunction([(0, 0), (1, 0), (1, 1), (0, 1)]))
    >>> [theta.degrees(0) for theta in found.normals], found.pairs[0], found.lower_edges[0]
    (['45', '135', '225', '315'], (0, 2), (0, 1))
    """
    hull, calipers = diameter.part.hull, diameter.calipers
    half = diameter.transitions.angles
    chords = AngleVector.from_directions(*hull.points.vectors(calipers.lower, calipers.upper))
    after = [
        _signed(QUARTER_TURN - phase - start) for phase, start in zip(chords, half, strict=True)
    ]
    normals = [start + rho for start, rho in zip(half, after, strict=True)]
    # Before transition 0 runs the last piece of the half turn before, its contacts exchanged.
    ends = [normals[-1] - HALF_TURN, *normals[:-1]]
    before = [normal - start for normal, start in zip(ends, half, strict=True)]
    lower, upper = hull.indices[calipers.lower].tolist(), hull.indices[calipers.upper].tolist()
    on_lower = [_edge(hull, edge) for edge in calipers.lower_edge.tolist()]
    on_upper = [_edge(hull, edge) for edge in calipers.upper_edge.tolist()]
    return Contacts(
        (*half, *(start + HALF_TURN for start in half)),
        (*normals, *(normal + HALF_TURN for normal in normals)),
        (*before, *before),
        (*after, *after),
        (*zip(lower, upper, strict=True), *zip(upper, lower, strict=True)),
        (*on_lower, *on_upper),
        (*on_upper, *on_lower),
    )


def _signed(angle: Angle) -> Angle:
    """Return an angle modulo a full turn, in (-180, 180] degrees."""
    rest = angle.reduced()
    return rest - FULL_TURN if rest > HALF_TURN else rest


def _edge(hull: ConvexHull, edge: int) -> Pair | None:
    if edge == NO_EDGE:
        return None
    return int(hull.indices[edge]), int(hull.indices[(edge + 1) % len(hull)])
