"""What settles the errata on friction, on the diameter function and on push-grasps."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from typing import Final

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, Angle
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.calipers import antipodal_pairs
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.grasping.friction import Friction
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.pushing_model import density_after_push, pushing_bound
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.grasping.regular import regular_bound
from stochgeom.thesis.appendix_e import figure_e_5
from stochgeom.thesis.evolutions import Evolution
from stochgeom.thesis.facts import Fact, Facts, equal, fraction, half_unit, places
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.thesis.tables import Cell

TINY: Final = "1e-9"
"""A friction at which both bounds are at their limits to five decimals."""

LIMITS: Final = {
    "triangle": "0.0000",
    "house": "0.5000",
    "4gon": "0.0000",
    "5gon": "0.7878",
    "wrench": "0.0704",
    "tuning-fork": "0.7578",
    "key": "0.0000",
}


def limit_of_the_bound() -> Facts:
    """Show that without friction Eq. 3.13 tends to a limit of each part, App. C to 1."""
    bounds = {name: GuaranteedBound(catalogue_part(name)) for name in LIMITS}
    facts = [
        equal(f"limit of Eq. 3.13, {name}", bound.limit.decimal(), LIMITS[name])
        for name, bound in bounds.items()
    ]
    at_zero = {str(bound(0).rational) for bound in bounds.values()}
    even = GuaranteedBound(Part.regular(6)).limit
    pushing = [PushingBound(catalogue_part(name))(TINY).decimal(4) for name in LIMITS]
    return (
        *facts,
        equal("at mu = 0 the bound of all seven", at_zero, {"1"}),
        equal("limit for a regular hexagon", even.decimal(), "1.0000"),
        equal(f"App. C's bound at mu = {TINY}", set(pushing), {"1.0000"}),
    )


def equation_3_14() -> Facts:
    """Show that the printed limit floor(pi / alpha) is 0 too early for even n."""
    alpha = Friction.of("0.25").angle
    diagram = GraspDiagram(Part.regular(12), "0.25")
    return (
        equal("floor(pi / alpha) at mu = .25", HALF_TURN // alpha, 12),
        Fact("n alpha for n = 12 in degrees", (alpha * 12).degrees(1), alpha * 12 < HALF_TURN),
        equal("the bound, from the diagram of a regular 12-gon", diagram.bound.decimal(), "0.0643"),
        equal("the same in closed form", diagram.bound == regular_bound(12, "0.25"), True),
        equal("n = 62 at mu = .05", regular_bound(62, "0.05").decimal(), "0.0141"),
        equal("a square at mu = 1, where n alpha = pi", regular_bound(4, 1).decimal(), "0.0000"),
        Fact(
            "a square at mu = .99",
            regular_bound(4, "0.99").decimal(),
            regular_bound(4, "0.99").sign() > 0,
        ),
    )


def text_of_appendix_c() -> Facts:
    """Show that both bounds are 1 without friction; with it App. C's is larger, by a logarithm."""
    square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    facts = []
    for name in ("rectangle", "tuning-fork"):
        part = catalogue_part(name)
        for mu in ("0", "0.01", "0.25"):
            diagram = GraspDiagram(part, mu)
            tight = pushing_bound(diagram)
            order = tight.compare(diagram.bound)
            shown = f"{diagram.bound.decimal()} and {tight.decimal()}"
            same = "equal" if mu == "0" else "different"
            facts.append(
                Fact(
                    f"the bounds at mu = {mu}, {name}: {same}",
                    shown,
                    (order == 0) is (mu == "0") and order >= 0,
                )
            )
    # ln(L / x) with L = 45 and x = 22.5 degrees.
    density = density_after_push(PushStability(square), Angle.from_degrees("22.5"))
    return (
        *facts,
        equal(
            "density halfway from a stable edge to the end of its step, ln 2 for a square",
            density.decimal(6),
            "0.693147",
        ),
    )


def sweep_of_appendix_d() -> Facts:
    """Show that the longest chord of the orthogonal interval need not touch the jaws."""
    wrong = {name: _pieces_the_sweep_misses(catalogue_part(name)) for name in catalogue_names()}
    parts = [name for name, (missed, _) in wrong.items() if missed]
    return (
        *(
            equal(
                f"pieces of the {name} that the printed sweep gets wrong, of {wrong[name][1]}",
                wrong[name][0],
                count,
            )
            for name, count in (("5gon", 2), ("wrench", 2), ("tuning-fork", 2), ("key", 3))
        ),
        Fact("parts with such a piece", ", ".join(parts), bool(parts)),
    )


def _pieces_the_sweep_misses(part: Part) -> tuple[int, int]:
    """Return how many pieces the printed rule gets wrong, of how many.

    On a piece the jaws' direction in the part's frame runs over an interval between edges; the
    rule takes the longest of the chords whose directions lie in the interval orthogonal to it.
    """
    corners = part.hull.points.pairs()
    chords = [
        (corners[j][0] - corners[i][0], corners[j][1] - corners[i][1])
        for i, j in antipodal_pairs(part.hull)
    ]
    missed, pieces = 0, DiameterFunction(part).pieces
    for piece in pieces:
        first = QUARTER_TURN - piece.arc.start - piece.arc.width
        inside = [
            x * x + y * y
            for x, y in chords
            if (Angle(0, (x, y)) - first) % HALF_TURN < piece.arc.width
        ]
        missed += max(inside, default=None) != piece.squared_amplitude
    return missed, len(pieces)


def _larger(turns: Iterable[Fraction], widest: Fraction) -> list[list[Fraction]]:
    """Return the turns that are larger, in degrees, counted one way and counted the other way."""
    listed = list(turns)
    return [[t for t in (sense * turn % 360 for turn in listed) if t > widest] for sense in (1, -1)]


def angles_of_figure_e_5() -> Facts:
    """Show that the printed angles cannot belong to the printed distributions.

    In the printed order, with y_k the distance from state k to the end of its step: the second
    action takes state 3 to 2, so its turn is in [y_3, y_4); the third takes 2 to 1 and 1 to 4, the
    fourth 1 to 4, and both leave 4. All turns are the same way, and less than the step of state 4.
    """
    evolution = figure_e_5()
    printed = [cell.printed for cell in _angles(evolution)]
    values = [fraction(text) for text in printed]
    error = half_unit(printed[0])
    turns = [after - before for before, after in pairwise([fraction("0"), *values])]
    widest = (fraction("0.28") + half_unit("0.28")) * 360
    too_wide, alone = _larger(turns, widest + 2 * error), _larger(values, widest + error)
    low, high = 2 * (values[0] + error), (values[1] - error) - (values[0] + error)
    ours = [
        a.low + a.high for a in evolution.plan.actions if a.low is not None and a.high is not None
    ]
    first, second = ((-doubled) % (2 * FULL_TURN) for doubled in ours[:2])
    return (
        Fact(
            "the widest step of the printed distribution, in degrees at most",
            places(widest, 1),
            widest == fraction("102.6"),
        ),
        Fact(
            "printed increments that are larger, counted one way",
            str([*map(str, too_wide[0])]),
            bool(too_wide[0]),
        ),
        Fact("and the other way", str([*map(str, too_wide[1])]), bool(too_wide[1])),
        *(
            Fact(
                f"printed angles that are larger, each a turn of its own, counted {way}",
                ", ".join(map(str, large)),
                bool(large),
            )
            for way, large in zip(("one way", "the other way"), alone, strict=True)
        ),
        Fact(
            "as middles the second increment is less than twice the first, at most",
            places(low, 1),
            second < 2 * first,
        ),
        Fact("printed is at least", places(high, 1), high > low),
        equal(
            "the rebuilt part has",
            [cell.computed.decimal(2) for cell in _angles(evolution)],
            ["-42.43", "-94.73", "-144.39"],
        ),
    )


def _angles(evolution: Evolution) -> list[Cell]:
    return [row.angle for row in evolution.rows if row.angle is not None]


def text_of_appendix_e() -> Facts:
    """Show that 3.7 pairs the probability of three steps with the cost of one."""
    problem = FeedingProblem(catalogue_part("4gon", appendix="E"), "push-grasp")
    costs = [problem.expected_cost(steps).decimal(1) for steps in (1, 2, 3, 4)]
    most = fraction("0.28") + half_unit("0.28")
    steps = {problem.optimal_plan(c).steps for c in (1, 2, 10)}
    return (
        Fact("2 over the printed .28, at least", places(2 / most, 2), 2 / most > 7),
        equal("2 over the printed .54 of the third step", places(2 / fraction("0.54"), 1), "3.7"),
        equal("costs of the rebuilt part for 1 to 4 steps", costs, ["7.1", "5.5", "5.3", "5.0"]),
        Fact(
            "steps of its optimal plans, filter cost 1, 2, 10", str(sorted(steps)), 1 not in steps
        ),
    )
