"""Star-shaped outlines that are not convex: sweep for crossings, hull, squeeze function.

Every other vertex lies on a near-circle, the ones between are pulled in at random, coordinates up
to 2^40. Expected: O(n log n) each. The sweep and the hull are loops over exact Python objects, some
ten microseconds for each vertex; the squeeze function of the hull, half as many vertices, is array
work and hardly counts.
"""

from __future__ import annotations

from benchmarks.harness import Clock, growth_exponent, measure_rounds
from benchmarks.outlines import Outline, star
from benchmarks.report import Report
from stochgeom import Part, convex_hull, squeeze_function
from stochgeom.geometry.points import Points
from stochgeom.geometry.simplicity import find_conflict

PHASES = {
    "simplicity sweep": "sweep",
    "convex hull": "hull",
    "squeeze function of the hull": "squeeze",
    "all: array to squeeze function": "all",
}


def run(*, quick: bool = False) -> Report:
    report = Report("nonconvex", "star-shaped outlines, by phases")
    sizes = (300, 1_000) if quick else (1_000, 10_000, 100_000)
    medians: dict[str, list[float]] = {label: [] for label in PHASES}
    for n in sizes:
        outline = star(n, seed=5)
        rounds = 2 if quick else 9 if n < 100_000 else 5
        found = measure_rounds(lambda clock, outline=outline: _one_round(clock, outline), rounds)
        report.section(f"{n} vertices")
        for label, key in PHASES.items():
            report.time(label, found[key])
            medians[label].append(found[key].median)
    report.section("exponents fitted")
    for label, seconds in medians.items():
        report.figure(label, growth_exponent(sizes, seconds))
    return report


def _one_round(clock: Clock, outline: Outline) -> None:
    points = Points.from_pairs(outline)
    conflict = clock.time("sweep", lambda: find_conflict([points.homogeneous()]))
    assert conflict is None
    clock.time("hull", lambda: convex_hull(points))
    part = clock.time("all", lambda: Part(outline))
    clock.time("all", lambda: part.hull)
    clock.time("squeeze", lambda: squeeze_function(part))
    clock.seconds["all"] += clock.seconds["squeeze"]
