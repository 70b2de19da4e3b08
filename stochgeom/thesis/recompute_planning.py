"""What settles the errata on planning with squeezes: Eq. 5.3, Figs. 5.1 and 5.8, the theorems."""

from __future__ import annotations

from typing import Final

from gmpy2 import mpq

from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.verification import verify_plan
from stochgeom.geometry.part import Part
from stochgeom.thesis.appendix_e import figure_e_8
from stochgeom.thesis.facts import Fact, Facts, equal, halves, middles
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

SIGNS: Final = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""The senses in which sigma and epsilon of Eq. 5.3 may be meant."""

ONE_SQUEEZE: Final = {
    "square": ((0, 0), (1, 0), (1, 1), (0, 1)),
    "right triangle": ((0, 0), (2, 0), (0, 1)),
    "obtuse triangle": ((0, 0), (5, 0), (1, 1)),
}


def angles_of_equation_5_3() -> Facts:
    """Show that printed angles are middles of ranges; those of Eq. 5.3 are others, and may fail."""
    house = FeedingProblem(catalogue_part("house"))
    by_middle = halves(middles(house.geometric_plan()))
    by_formula = {by_equation_5_3(house, *signs)[-1].degrees(0) for signs in SIGNS}
    printed = [row.angle.computed.decimal(0) for row in figure_e_8().rows if row.angle is not None]
    failing = [
        [
            f"{name}, {action}"
            for name in catalogue_names()
            for action in ("squeeze", "push-grasp")
            if not _orients(FeedingProblem(catalogue_part(name), action), signs)
        ]
        for signs in SIGNS
    ]
    worst = [len(names) for names in failing]
    return (
        equal(
            "second angle of the house by the middle of its range", by_middle[0].degrees(0), "45"
        ),
        Fact(
            "by Eq. 5.3, for each choice of signs",
            ", ".join(sorted(by_formula)),
            "45" not in by_formula,
        ),
        equal("angles of Fig. E.8 by middles", printed, ["72", "135"]),
        Fact(
            "plans for the eight parts, of 16, that Eq. 5.3 makes and do not orient up to symmetry,"
            " by choice of signs",
            ", ".join(map(str, worst)),
            min(worst) > 0,
        ),
    )


def by_equation_5_3(problem: FeedingProblem, sigma: int, epsilon: int) -> tuple[Angle, ...]:
    """Return the plan of Eq. 5.3 as printed: from left ends and widths of the preimages alone.

    ``sigma`` and ``epsilon`` are the signs with which its two terms are taken.
    """
    chain = list(problem.preimages)
    starts = [chain[0].image.start, *(preimage.arc.start for preimage in chain)]
    widths = [ZERO, *(preimage.width for preimage in chain)]
    doubled = [
        (starts[i] - starts[i - 1]) * (2 * sigma) + (widths[i] - widths[i - 1]) * epsilon
        for i in range(len(chain), 0, -1)
    ]
    return halves(doubled)


def _orients(problem: FeedingProblem, signs: tuple[int, int]) -> bool:
    report = verify_plan(problem.transfer, by_equation_5_3(problem, *signs))
    return bool(report.orients_up_to_symmetry)


def first_step_of_figure_5_1() -> Facts:
    """Show that one squeeze may collapse a period already: h_1 = T has to be asked first."""
    facts = []
    for name, corners in ONE_SQUEEZE.items():
        transfer = squeeze_function(corners)
        chain = list(preimages(transfer))
        facts.append(equal(f"h_1 = T for a {name}", chain[0].width, transfer.period))
        facts.append(equal("  so one step orients it; shortest plan", len(chain), 1))
        # From i = 2 on: one step of s has an image below h_1, two adjacent ones have not.
        first = chain[0].arc.start
        images = [transfer.image(Arc(first, transfer.period * k)).width for k in (1, 2)]
        facts.append(
            Fact(
                "  asked from i = 2 on, h_2 is T and the plan has two; images of one and two steps",
                ", ".join(image.degrees(0) for image in images),
                images[0] < chain[0].width <= images[1],
            )
        )
    return tuple(facts)


def cost_in_figure_5_8() -> Facts:
    """Show that phase II has to weigh (i + c): the best number of steps depends on c."""
    found = []
    for name in catalogue_names():
        problem = FeedingProblem(catalogue_part(name))
        found.append((name, [problem.optimal_plan(c).steps for c in ("0", 1, 3, 10)]))
    differing = [name for name, steps in found if len(set(steps)) > 1]
    house = dict(found)["house"]
    return (
        equal("steps of the best plan of the house for c = 0, 1, 3, 10", house, [1, 1, 2, 2]),
        Fact("parts whose best plan depends on c", ", ".join(differing), len(differing) > 0),
    )


def period_and_symmetry() -> Facts:
    """Show that the smallest period may be a proper divisor of T_r."""
    part = Part([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
    edges = [
        (part.vertices[k - 4][0] - part.vertices[k][0]) ** 2
        + (part.vertices[k - 4][1] - part.vertices[k][1]) ** 2
        for k in range(5)
    ]
    rotations = [k for k in range(5) if edges[k:] + edges[:k] == edges]
    period = squeeze_function(part).period
    t_r = HALF_TURN  # r = 1: 2 pi / (r (1 + r mod 2))
    rectangle = catalogue_part("rectangle")
    push = push_grasp_function(rectangle).period
    aside = push_grasp_function(Part(rectangle.vertices, ("1.9", 1))).period
    return (
        equal(
            "rotations of the edges of the part that leave their lengths as they are",
            len(rotations),
            1,
        ),
        equal("its period, in degrees", period.degrees(0), QUARTER_TURN.degrees(0)),
        Fact(
            "divides T_1 = 180 and is smaller",
            str(t_r // period),
            t_r % period == ZERO and period < t_r,
        ),
        equal(
            "period of the rectangle's push-grasps, r = 2, divides 2 pi / r", HALF_TURN % push, ZERO
        ),
        equal(
            "with the centre of mass aside, at (1.9, 1), r of part and centre is 1, the period",
            aside,
            FULL_TURN,
        ),
    )


def bound_of_theorem_4_1() -> Facts:
    """Show that k <= n (c + 1) - c holds for squeezes, sharper than 2 n (c + 1)."""
    plans = wide = 0
    for name in catalogue_names():
        problem = FeedingProblem(catalogue_part(name))
        for c in (mpq(0), mpq(1, 4), mpq(1), mpq(10)):
            n, plan = len(catalogue_part(name).hull), problem.optimal_plan(c)
            plans += plan.steps <= n * (c + 1) - c
            wide += plan.probability > mpq(1, 2)
    return (
        equal("optimal plans within n (c + 1) - c, of 32", plans, 32),
        equal("plans with a probability above 1/2", wide, 0),
    )


def length_of_plans() -> Facts:
    """Show plans up to symmetry of at most 2 n - 1 steps (Chen and Ierardi 1995).

    A theorem; here it is seen on the catalogue and on families of parts with long plans.
    """
    lengths = {
        name: len(list(FeedingProblem(catalogue_part(name)).preimages))
        for name in catalogue_names()
    }
    facts = [
        Fact(
            f"steps of the shortest plan, {name}",
            str(steps),
            steps <= 2 * len(catalogue_part(name).hull) - 1,
        )
        for name, steps in lengths.items()
    ]
    for n in (9, 27, 81):
        part = FAMILIES["long plans"](n, n)
        steps = len(list(preimages(squeeze_function(part))))
        facts.append(
            Fact(f"  of a part made for long plans, n = {n}", str(steps), n <= steps <= 2 * n - 1)
        )
    return tuple(facts)


def time_of_phase_one() -> Facts:
    """Show that phase I makes O(n^2) comparisons for every c, as its steps are at most 2 n - 1.

    Comparisons are counted, on a family whose shortest plans have n steps.
    """
    facts = []
    for n in (9, 27, 81):
        made = _comparisons(squeeze_function(FAMILIES["long plans"](n, n)))
        facts.append(
            Fact(
                f"comparisons of phase I up to symmetry, n = {n}, at most 4 n^2",
                str(made),
                made <= 4 * n * n,
            )
        )
    problem = FeedingProblem(FAMILIES["long plans"](9, 9))
    steps = [problem.optimal_plan(c).steps for c in (1, 100, 10**6)]
    return (
        *facts,
        Fact(
            "steps of optimal plans, n = 9, for c = 1, 100, 10^6",
            ", ".join(map(str, steps)),
            max(steps) <= 2 * 9 - 1,
        ),
    )


def _comparisons(transfer: StepFunction) -> int:
    """Return how many widths the plainest phase I compares until it has collapsed a period."""
    m = len(transfer)
    breaks, values = (
        [row[k] for k in range(2 * m + 1)]
        for row in (transfer.lifted_breaks, transfer.lifted_values)
    )
    width, made = max(transfer.widths), m
    while width != transfer.period:
        last, best = 0, ZERO
        for first in range(m):
            last = max(last, first)
            while values[last + 1] - values[first] < width:
                last, made = last + 1, made + 1
            best = max(best, breaks[last + 1] - breaks[first])
            made += 2
        width = best
    return made


def derivative_in_f_4() -> Facts:
    """Show that dp / dtheta = f(theta + h) - f(theta), with more than one zero on a circle."""
    prior = PiecewisePrior.from_histogram(["0", "90", "180", "270", "360"], [1, 2, 4, 1])
    h, step = Angle.from_degrees(90), Angle.from_degrees(1)
    starts = [Angle.from_degrees(k) for k in range(0, 360, 10)]
    masses = [prior.mass(Arc(start, h)) for start in starts]
    rises = []
    for start, mass in zip(starts, masses, strict=True):
        change = prior.mass(Arc(start + step, h)).compare(mass)
        f, ahead = (prior.mass(Arc(x % FULL_TURN, step)) for x in (start, start + h))
        rises.append((change, ahead.compare(f)))
    signs = [change for change, _ in rises]
    turns = sum(signs[k] != signs[k - 1] for k in range(len(signs)))
    return (
        equal(
            "starts, of 36, where p rises exactly as f(theta + h) exceeds f(theta)",
            sum(change == expected for change, expected in rises),
            36,
        ),
        Fact("changes of sign around the circle", str(turns), turns >= 2),
        Fact(
            "it is the opposite of the printed sign at",
            f"{sum(map(abs, signs))} starts",
            any(signs),
        ),
    )
