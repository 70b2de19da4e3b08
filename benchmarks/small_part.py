"""Whole plan of a part with 10 vertices.

From vertices (pairs of `int`) to `Part`, squeeze function, both phases and the nominal angles of
the stochastically optimal plan, in a warm interpreter. Expected: about 1 ms, spread over many small
calls; it grows with the number of plan lengths that are tried (one to three for most convex parts,
five or more for round ones), and outlines that are not convex are also searched for crossings.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from statistics import median

from benchmarks.harness import Samples, measure_small
from benchmarks.outlines import Outline, near_circle, small_convex, small_star
from benchmarks.report import Report
from stochgeom import plan_feeding

TARGET = 1e-3
OVAL = [(0, 0), (9, -2), (17, 1), (22, 6), (23, 12), (19, 19), (12, 23), (5, 22), (0, 17), (-2, 8)]
HOOK = [(0, 0), (12, 0), (12, 3), (7, 3), (7, 5), (10, 5), (10, 9), (3, 9), (3, 4), (0, 3)]
MAKERS: dict[str, Callable[[int, int], Outline]] = {
    "convex": small_convex,
    "round": lambda n, seed: near_circle(n, seed, radius=1000),
    "star": small_star,
}
Pairs = list[tuple[int, int]]


def whole_plan(vertices: Pairs) -> object:
    """Plan and make every nominal angle."""
    return plan_feeding(vertices).angles


def pairs(outline: Outline) -> Pairs:
    """Return the vertices as a user types them."""
    return [(x, y) for x, y in outline.tolist()]


def run(*, quick: bool = False) -> Report:
    report = Report("small_part", "vertices to plan with nominal angles, 10 vertices")
    rounds, parts = (3, 5) if quick else (21, 100)
    fixed = {"a convex part (oval)": OVAL, "a non-convex part (hook)": HOOK}
    found = measure_small({label: partial(whole_plan, v) for label, v in fixed.items()}, rounds)
    for label, samples in found.items():
        report.time(label, samples, TARGET)
    for label, make in MAKERS.items():
        medians = _medians(make, parts, max(3, rounds // 3))
        report.time(f"{parts} random {label} parts: median of medians", medians, TARGET)
        report.figure(f"  share of them above {TARGET * 1e3:.0f} ms", _share_above(medians))
    return report


def _medians(make: Callable[[int, int], Outline], parts: int, rounds: int) -> Samples:
    """Return a median for each of several random parts."""
    actions = {str(seed): partial(whole_plan, pairs(make(10, seed))) for seed in range(parts)}
    found = measure_small(actions, rounds)
    return Samples(tuple(median(samples.seconds) for samples in found.values()))


def _share_above(samples: Samples) -> float:
    return sum(value > TARGET for value in samples.seconds) / len(samples.seconds)
