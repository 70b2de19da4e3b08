"""Push-grasp planning beside squeeze planning, and mouths placed under a discrete prior.

Part one, alternately for the same outline: from vertices to the optimal plan with its nominal
angles, for 10-vertex parts as a whole and for large outlines to the transfer function and ten
stages of phase I. Expected: a push-grasp takes a second, simpler function of the hull and a
composition, and its steps are counted over a full turn instead of half of one: O(n log n) like the
squeeze, in about twice the time. Target: at most 2.5 times.

Part two: a prior of 10^5 weighted points on a 1000-vertex part; the mouths of all plan lengths are
placed, each at O(a) array work for a points. Target: 2 s in total.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from benchmarks.harness import Clock, Samples, measure_rounds, measure_small
from benchmarks.outlines import Outline, near_circle, small_convex
from benchmarks.report import Report
from benchmarks.small_part import OVAL, pairs
from stochgeom import DiscretePrior, FeedingProblem, Part, plan_feeding

TARGET_RATIO = 2.5
TARGET_SECONDS = 2.0
ACTIONS = ("squeeze", "push-grasp")
STAGES = 10


def run(*, quick: bool = False) -> Report:
    report = Report("actions_and_priors", "push-grasps beside squeezes; mouths under a prior")
    _small(report, 3 if quick else 21, 3 if quick else 30)
    for n in (1_000,) if quick else (10_000, 100_000):
        _large(report, n, 3 if quick else 11)
    _prior(report, *((1_000, 100) if quick else (100_000, 1_000)))
    return report


def _small(report: Report, rounds: int, parts: int) -> None:
    report.section("10 vertices: vertices to plan with nominal angles")
    outlines = {"oval": OVAL}
    outlines |= {f"random {seed}": pairs(small_convex(10, seed)) for seed in range(parts)}
    ratios = []
    for label, vertices in outlines.items():
        found = measure_small({a: partial(_whole, vertices, a) for a in ACTIONS}, rounds)
        ratios.append(found["push-grasp"].over(found["squeeze"]))
        if label == "oval":
            for action in ACTIONS:
                report.time(f"{label}: {action}", found[action])
    median = float(np.median(ratios))
    report.ratio("push-grasp to squeeze, median of the parts", median, TARGET_RATIO)
    report.ratio("push-grasp to squeeze, largest", max(ratios))


def _whole(vertices: list[tuple[int, int]], action: str) -> object:
    return plan_feeding(vertices, action=action).angles


def _large(report: Report, n: int, rounds: int) -> None:
    outline = near_circle(n, seed=1)
    found = measure_rounds(lambda clock: _one_round(clock, outline), rounds)
    report.section(f"near-circle, {n} vertices")
    for what in ("transfer function", "ten stages"):
        samples = {action: found[f"{action}, {what}"] for action in ACTIONS}
        for action in ACTIONS:
            report.time(f"{what}: {action}", samples[action])
        report.ratio("  ratio", samples["push-grasp"].over(samples["squeeze"]), TARGET_RATIO)


def _one_round(clock: Clock, outline: Outline) -> None:
    for action in ACTIONS:
        problem = clock.time(
            f"{action}, transfer function", partial(_with_transfer, outline, action)
        )
        clock.time(f"{action}, ten stages", partial(problem.preimages.of_steps, STAGES))


def _with_transfer(outline: Outline, action: str) -> FeedingProblem:
    problem = FeedingProblem(Part(outline), action)
    assert len(problem.transfer)
    return problem


def _prior(report: Report, points: int, vertices: int) -> None:
    random = np.random.default_rng(7)
    degrees = random.integers(0, 360 * 10**9, points)
    counts = random.integers(1, 100, points)
    measured = [(f"{d}e-9", int(c)) for d, c in zip(degrees.tolist(), counts.tolist(), strict=True)]
    report.section(f"a prior of {points} points, a part of {vertices} vertices")
    seconds: dict[str, list[float]] = {"reading": [], "placing": []}
    for _ in range(3):
        clock = Clock()
        prior = clock.time("reading", lambda: DiscretePrior.from_counts(measured))
        problem = FeedingProblem(Part(near_circle(vertices, seed=1)), prior=prior)
        chain = list(problem.preimages)
        clock.time("placing", lambda p=problem, c=chain: [p.placement(i.steps) for i in c])
        for label, value in clock.seconds.items():
            seconds[label].append(value)
    report.time("making the prior of degrees and counts", Samples(tuple(seconds["reading"])))
    report.time(f"placing {len(chain)} mouths", Samples(tuple(seconds["placing"])), TARGET_SECONDS)
