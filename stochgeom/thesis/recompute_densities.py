"""What settles the errata on uniform density: the captions of Tables 3.1 and C.1."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cmp_to_key
from itertools import pairwise, product
from typing import Any, Final

from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.balls import rational_ball, tangent_ball, working_precision
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import Probability
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.pushing_model import pushing_bound, sum_of_integrals
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.thesis import evolutions
from stochgeom.thesis.facts import Fact, Facts, equal, fraction, half_unit, places
from stochgeom.thesis.grasp_tables import FRICTIONS
from stochgeom.thesis.parts import catalogue_entry, catalogue_part

Point = tuple[mpq, mpq]
Box = tuple[tuple[mpq, mpq], tuple[mpq, mpq]]
"""Ranges of x and of y."""

E_8_BOX: Final[Box] = ((mpq(-46, 1000), mpq(46, 1000)), (mpq(2875, 10000), mpq(423, 1000)))
"""Holds every centre of mass that gives Fig. E.8 if the .20 is the base's; see below."""

CORNER_SLOPES: Final = (mpq(66, 100), mpq(78, 100))
CORNER_HEIGHT: Final = mpq(343, 1000)
"""Slopes and height of a triangle over a corner of the base, with all others."""

UNIFORM_OUTLINES: Final = {
    "key": (
        (0, 1), (4, 0), (14, 1), (2, 2), (14, 8), (1, 6), (13, 13), (3, 10), (12, 14), (4, 11),
        (1, 11),
    ),
}  # fmt: skip
"""Outlines that have the printed cells with their centre of mass at their centroid."""

FREE_CENTRES: Final = {"5gon": 0, "wrench": 0, "tuning-fork": 2, "key": 3}
"""Other parts that have their six cells away from the centroid, and how many they have there."""


def density_of_the_house() -> Facts:
    """Show that the house of the tables is not uniform, nor is its centre of mass that of Fig. E.8.

    For every centre of mass inside this outline: all corners of the triangle of base and apex are
    maxima of the radius, the base is stable under push and squeeze, and what comes to rest against
    an edge of one side is squeezed onto the wall of that side. So the three steps of a push-grasp
    are the angles under which the centre sees base, right and left chord (corner of the base to
    apex). A chord is seen under .395 of a turn or more only from a segment of a circle, whose
    height is half the chord times tan 18.9 degrees, and whose tangents at the ends make 37.8 with
    the chord.

    If the .20 of Fig. E.8 is the base's, the centre is below .423, as on the axis the base is seen
    under .195 there, and beside it under less. It is in both segments over the other chords, of
    length sqrt 10, so 2 - y + 3 |x| <= 5 tan 18.9 < 1.7125. Both together leave a small box. If the
    .20 is that of the right chord, the centre is in segments over base and left chord: seen from
    the left corner of the base between 33.7 and 37.8 degrees, in a small triangle. The left chord
    is a mirror image of that.

    Table C.1's bound falls as a way L from a stable to an unstable
    orientation grows, as of [a, b] on it min(b, L) (1 + ln(L / min(b, L))) less the same of a is
    wedged; L is an angle between a direction to a corner and a normal, extreme at corners of a box.
    """
    corners = catalogue_part("house").vertices
    below, above = (fraction("0.20") - half_unit("0.20"), fraction("0.40") - half_unit("0.40"))
    highest = 2 * Angle(0, (1 + E_8_BOX[1][1], 1))  # of the base's angle, at the top of the box
    with working_precision(64):
        lens = 5 * tangent_ball(mpq(Fraction(1, 2) - above) / 2)
        narrow = bool(lens < rational_ball(2 - E_8_BOX[1][0]))
        low = bool(lens < 5 * rational_ball(CORNER_HEIGHT))
    width = (E_8_BOX[1][1] - E_8_BOX[1][0]) / 3
    bound = most_after_push(corners, E_8_BOX, "0.1")
    aside = most_in_the_corner("0.25")
    cells = [
        fraction(catalogue_entry("house").printed[f"C.1 mu={mu}"]) - Fraction(1, 200)
        for mu in ("0.1", "0.25")
    ]
    tangent = HALF_TURN - Angle.from_turns(mpq(above))
    return (
        equal("cells of the house, of six, that hold at (0, 0)", _cells_of("house", (0, 0)), 6),
        equal("at the centroid of the uniform house, (0, 4/15)", _cells_of("house"), 1),
        equal("Fig. E.8 holds at (0, 2/5)", _gives_figure_e_8(Part(corners, (0, "2/5"))), True),
        equal("at the centroid of the uniform house", _gives_figure_e_8(Part(corners)), False),
        Fact(
            "from a height of .423 the base is seen under less than .195 of a turn",
            Angle.degrees(highest, 2),
            highest < Angle.from_turns(mpq(below)),
        ),
        Fact("5 tan 18.9 degrees is less than 1.7125", str(lens.str(5, radius=False)), narrow),
        Fact(
            "so |x| is less than .046 where Fig. E.8 holds",
            rational_decimal(width, 4),
            width < E_8_BOX[0][1] == -E_8_BOX[0][0],
        ),
        Fact(
            "and there the bound of Table C.1 at mu = .10, printed as 0.90, is at most",
            bound.decimal(),
            bound.compare(mpq(cells[0])) < 0,
        ),
        Fact(
            "if a side has the .20, slopes to the centre from the other corner are within",
            " and ".join(rational_decimal(slope, 2) for slope in CORNER_SLOPES),
            Angle(0, (1, CORNER_SLOPES[0])) < Angle(0, (1, 3)) - tangent
            and tangent < Angle(0, (1, CORNER_SLOPES[1])),
        ),
        Fact("  its height over the base is below", rational_decimal(CORNER_HEIGHT, 3), low),
        Fact(
            "  and there the bound of Table C.1 at mu = .25, printed as 0.72, is at most",
            aside.decimal(),
            aside.compare(mpq(cells[1])) < 0,
        ),
    )


def most_after_push(corners: Sequence[Point], box: Box, mu: str, cuts: int = 2) -> Probability:
    """Return no less than the bound of Table C.1 for any centre of mass in a box.

    The box is cut into cuts x cuts; the same edges have to be stable in all of it, which is seen at
    corners of the cut boxes: the condition on each edge is linear in the centre.

    Examples
    --------
    >>> house, point = catalogue_part("house").vertices, ((mpq(0), mpq(0)), (mpq(0), mpq(0)))
    >>> most_after_push(house, point, "0.25", 1).decimal(6) == _cell_c_1(house, (0, 0), "0.25")
    True
    """
    xs, ys = ([low + (high - low) * mpq(k, cuts) for k in range(cuts + 1)] for low, high in box)
    found = []
    for x_range, y_range in product(pairwise(xs), pairwise(ys)):
        sides = [PushStability(Part(corners, centre)).sides for centre in product(x_range, y_range)]
        if len({tuple((stable, step) for stable, _, step in row) for row in sides}) != 1:
            raise InputError("other edges are stable at another corner; accepted: a smaller box")
        ways = [
            (stable, step, min(((end - stable) * step) % FULL_TURN for _, end, _ in same))
            for same in zip(*sides, strict=True)
            for stable, _, step in same[:1]
        ]
        found.append(_share_of(ways, Part(corners, (x_range[0], y_range[0])), mu))
    return max(found, key=cmp_to_key(_order))


def most_in_the_corner(mu: str) -> Probability:
    """Return no less than the bound of Table C.1 for any centre of mass near a corner of the house.

    In the triangle over the left corner of the base, of slopes and height as given, no edge of the
    roof is stable. Directions to the right corner of the base and to the apex are extreme at the
    triangle's corners; that to the left corner of the base is the slope.
    """
    low, high = CORNER_SLOPES
    reach = [(CORNER_HEIGHT / slope, CORNER_HEIGHT) for slope in CORNER_SLOPES]
    triangle = [(mpq(0), mpq(0)), *reach]  # from the left corner of the base
    down = [Angle(0, (2 - x, y)) for x, y in triangle]  # to its right corner, below the horizontal
    apex = [Angle(0, (1 - x, 3 - y)) for x, y in triangle]
    base, right, left = ZERO, QUARTER_TURN, HALF_TURN + QUARTER_TURN
    ways = [
        (base, 1, QUARTER_TURN - max(down)),
        (base, -1, QUARTER_TURN - Angle(0, (1, high))),
        (right, -1, min(down)),
        (right, 1, min(apex)),
        (left, -1, HALF_TURN - max(apex)),
        (left, 1, Angle(0, (1, low))),
    ]
    return _share_of(ways, catalogue_part("house"), mu)


def _share_of(ways: Iterable[tuple[Angle, int, Angle]], part: Part, mu: str) -> Probability:
    """Return 1 less what is wedged on ways of (stable orientation, step, L) of a push."""
    ends, wedges = [], SqueezeStability(part, mu).wedging
    for stable, step, length in ways:
        for wedge in wedges:
            first = (wedge.start - stable) * step - (wedge.width if step < 0 else ZERO)
            for near, far in _within(first % FULL_TURN, wedge.width, length):
                ends += [(1, near, length), (-1, far, length)]
    return sum_of_integrals(1, ends)


def _order(one: Any, other: Any) -> int:
    return int(one.compare(other))


def _within(first: Angle, width: Angle, length: Angle) -> Iterator[tuple[Angle, Angle]]:
    """Yield what of an arc from `first` on lies between 0 and `length`, going round once."""
    for start in (first, first - FULL_TURN):
        near, far = max(start, ZERO), min(start + width, length)
        if near < far:
            yield near, far


def density_of_other_parts() -> Facts:
    """Show which of the other outlines need not be, and which are not, of uniform density.

    The 4gon has its six cells at its centroid too, but not the first row of Fig. E.5. The key has
    11 sides, of which 7 are on the hull: with other notches its centroid is where it has to be, so
    nothing contradicts the captions. The rest is an observation on the outlines of the catalogue,
    no theorem on all that have the printed numbers.
    """
    four = Part(catalogue_part("4gon").vertices)
    widths = FeedingProblem(four, "push-grasp").transfer.widths
    shares = sorted(evolutions.Probability(width).decimal(2) for width in widths)
    printed = sorted(catalogue_entry("4gon").printed[f"E.5 prior[{k}]"] for k in (1, 2, 3, 4))
    facts = [
        equal("cells of the 4gon, of six, at its centroid", _cells_of("4gon"), 6),
        Fact(
            f"prior of its push-grasps there, against {', '.join(printed)} in Fig. E.5",
            ", ".join(shares),
            shares != printed,
        ),
    ]
    for name, uniform in FREE_CENTRES.items():
        centre = catalogue_part(name).center_of_mass
        facts += [
            equal(f"cells of the {name} at its centre of mass", _cells_of(name, centre), 6),
            equal("  at the centroid of its outline", _cells_of(name), uniform),
        ]
    for name, outline in UNIFORM_OUTLINES.items():
        part = Part(outline)
        costs = FeedingProblem(part).expected_cost
        same = all(
            costs(k).decimal(1) == FeedingProblem(catalogue_part(name)).expected_cost(k).decimal(1)
            for k in (1, 2, 3, 4)
        )
        facts += [
            equal(f"cells of another {name}, uniform", _cells_that_hold(name, part), 6),
            equal(
                "  its sides as printed, its costs in Table 4.1 as those of the catalogue's",
                (len(part), same),
                (catalogue_entry(name).sides_printed, True),
            ),
        ]
    return tuple(facts)


def _cells_of(name: str, centre: Sequence[RationalLike] | None = None) -> int:
    """Return how many of its six cells of Tables 3.1 and C.1 a part has (default: uniform)."""
    return _cells_that_hold(name, Part(catalogue_part(name).vertices, centre))


def _cells_that_hold(name: str, part: Part) -> int:
    printed, held = catalogue_entry(name).printed, 0
    for mu in FRICTIONS:
        diagram = GraspDiagram(part, mu)
        for table, bound in (("T3.1", diagram.bound), ("C.1", pushing_bound(diagram))):
            held += bound.decimal(2) == places(fraction(printed[f"{table} mu={mu}"]), 2)
    return held


def _cell_c_1(corners: Sequence[Point], centre: Sequence[RationalLike], mu: str) -> str:
    return pushing_bound(GraspDiagram(Part(corners, centre), mu)).decimal(6)


def _gives_figure_e_8(part: Part) -> bool:
    widths = FeedingProblem(part, "push-grasp").transfer.widths
    shares = sorted(evolutions.Probability(width).decimal(2) for width in widths)
    return shares == ["0.20", "0.40", "0.40"]
