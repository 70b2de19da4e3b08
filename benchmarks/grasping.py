"""Grasping with friction: diagrams and both bounds, and the bounds as functions of the friction.

Parts of 100 vertices: near-circles, an ellipse, a smooth outline of few stable edges. One mu:
vertices to diagrams, to the bound of Eq. 3.13, its strict form and that of App. C, with decimals.
Many: 1000 values of each bound, the making of the function included, for mu up to 1 and up to 1/20,
where few parts are wedged in all orientations yet; and beside it the naive road, a diagram for each
value, of which ten are timed. Expected: O(n log n) for one mu; a
value of a function is the search for its piece and a sum of O(n) terms.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from benchmarks.harness import Clock, measure_rounds
from benchmarks.outlines import Outline, near_circle
from benchmarks.report import Report
from stochgeom import GraspDiagram, GuaranteedBound, Part, PushingBound, pushing_bound

ONE_MU_SECONDS = 50e-3
MANY_MU_SECONDS = 2.0
VALUES = 1_000
NAIVE = 10


def smooth(n: int) -> Outline:
    """Return n rounded points of a smooth convex curve without symmetry."""
    t = np.arange(n) * (2 * np.pi / n)
    x = np.cos(t) + 0.09 * np.cos(2 * t) + 0.02 * np.sin(3 * t)
    y = np.sin(t) - 0.09 * np.sin(2 * t) + 0.02 * np.cos(5 * t)
    return np.rint(10**6 * np.stack((x, y), axis=1)).astype(np.int64)


def regular(n: int) -> Outline:
    """Return the rounded vertices of a regular polygon."""
    t = np.arange(n) * (2 * np.pi / n)
    return np.rint(10**6 * np.stack((np.cos(t), np.sin(t)), axis=1)).astype(np.int64)


OUTLINES = {
    "near-circle": lambda n: near_circle(n, seed=3, radius=10**6),
    "2:1 ellipse": lambda n: near_circle(n, seed=4, radius=10**6, squash=0.5),
    "nearly regular": regular,
    "nearly regular, odd": lambda n: regular(n + 1),
    "smooth": smooth,
}
FRICTIONS = ("1/4", "1/50", "1/1000")


def run(*, quick: bool = False) -> Report:
    report = Report("grasping", "grasps with friction, 100 vertices")
    for name, make in OUTLINES.items():
        outline = make(20 if quick else 100)
        report.section(f"{name}, {len(Part(outline).hull)} vertices on the hull")
        for mu in FRICTIONS:
            found = measure_rounds(
                lambda clock, o=outline, mu=mu: _one_mu(clock, o, mu), 2 if quick else 15
            )
            report.time(f"diagrams and both bounds, mu = {mu}", found["all"], ONE_MU_SECONDS)
        _functions(report, outline, quick=quick)
    return report


def _one_mu(clock: Clock, outline: Outline, mu: str) -> None:
    clock.time("all", lambda: _bounds(outline, mu))


def _bounds(outline: Outline, mu: str) -> tuple[str, str, str]:
    diagram = GraspDiagram(outline, mu)
    pushing = pushing_bound(diagram)
    return diagram.bound.decimal(), diagram.strict_bound.decimal(), pushing.decimal()


def _functions(report: Report, outline: Outline, *, quick: bool) -> None:
    count = 50 if quick else VALUES
    mus = [Fraction(k, count) for k in range(1, count + 1)]
    small = [mu / 20 for mu in mus]
    roads = {
        f"Eq. 3.13: {count} values": lambda: _values(GuaranteedBound, outline, mus),
        f"Eq. 3.13: {count} values, mu <= 1/20": lambda: _values(GuaranteedBound, outline, small),
        f"App. C: {count} values": lambda: _values(PushingBound, outline, mus),
        f"App. C: {count} values, mu <= 1/20": lambda: _values(PushingBound, outline, small),
        f"naive: {NAIVE} diagrams": lambda: [_bounds(outline, str(mu)) for mu in mus[:NAIVE]],
    }

    def one_round(clock: Clock) -> None:
        for label, road in roads.items():
            clock.time(label, road)

    found = measure_rounds(one_round, 1 if quick else 5)
    for label in roads:
        target = None if label.startswith("naive") else MANY_MU_SECONDS
        report.time(label, found[label], target)


def _values(make: type, outline: Outline, mus: list[Fraction]) -> list[str]:
    bound = make(Part(outline))
    return [bound(mu).decimal() for mu in mus]
