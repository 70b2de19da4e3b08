"""Tray tilting: trials a second, and planners beside each other on all 132 instances.

Trials: one process, processor time, as the machine may be shared. Expected: some 400 steps of the
engine for a trial, a few microseconds each. Target: 100 trials a second and core, so 10 ms each.

Planners, on the same model of 2000 trials: all plans of at most three tilts, O(n^2 m^k) for all
goals of a start at once; the same by a plain loop over plans of exact hyperstates, for one
instance; branch and bound; the shortest-path heuristic, O(m n^2) once and O(k n^2) for each
instance. The source took 62 s for each instance; its heuristic was nearly as good in polynomial
time.
"""

from __future__ import annotations

from functools import partial
from itertools import product
from time import process_time

import numpy as np

from benchmarks.harness import Clock, Samples, measure_rounds
from benchmarks.report import Report
from stochgeom import (
    SimulatedRobot,
    TiltPlan,
    TransitionModel,
    best_expected_tilt_plan,
    best_tilt_plans,
    bounded_tilt_search,
    evaluate_tilt_plan,
    likeliest_tilts,
    shortest_path_tilt_plan,
)

TARGET_SECONDS = 0.01
INSTANCES = [(i, j) for i in range(1, 13) for j in range(1, 13) if i != j]


def run(*, quick: bool = False) -> Report:
    report = Report("tilting", "trials of the simulated robot; planners on all instances")
    trials = 100 if quick else 2000
    start = process_time()
    counts = SimulatedRobot(seed=1).observe(trials)
    seconds = Samples(((process_time() - start) / trials,))
    report.section(f"the robot: {trials} trials, processor time")
    report.time("a trial", seconds, TARGET_SECONDS)
    report.figure("percent with another outcome", 100 * counts.others / trials)
    model = TransitionModel(counts)
    assert model.matrices is not None  # made once for all planners
    _planners(report, model, 2 if quick else 7)
    _quality(report, model)
    _naive(report, model, 2 if quick else 3)
    return report


def _planners(report: Report, model: TransitionModel, rounds: int) -> None:
    report.section("132 instances, at most three tilts")
    found = measure_rounds(lambda clock: _one_round(clock, model), rounds)
    for label, samples in found.items():
        report.time(label, samples)


def _one_round(clock: Clock, model: TransitionModel) -> None:
    clock.time("all plans", lambda: best_tilt_plans(model))
    clock.time("branch and bound", lambda: [bounded_tilt_search(model, *p) for p in INSTANCES])
    clock.time("shortest path", lambda: _heuristics(model))
    clock.time("expected probability, one", lambda: best_expected_tilt_plan(model, 1, 2))


def _heuristics(model: TransitionModel) -> dict[tuple[int, int], TiltPlan]:
    edges = likeliest_tilts(model, range(1, 13))
    return {pair: shortest_path_tilt_plan(model, *pair, 3, edges=edges) for pair in INSTANCES}


def _quality(report: Report, model: TransitionModel) -> None:
    report.section("quality")
    best = best_tilt_plans(model)
    paths = _heuristics(model)
    lost = [float(best[pair].probability - paths[pair].probability) for pair in INSTANCES]
    nodes = [bounded_tilt_search(model, *pair).nodes for pair in INSTANCES]
    report.figure("instances where the heuristic is best", sum(loss == 0 for loss in lost))
    report.figure("mean probability lost by the heuristic", float(np.mean(lost)))
    report.figure("most lost by it", max(lost), target=1.0)
    report.figure("median nodes of branch and bound, of 1885", float(np.median(nodes)))
    report.figure("mean tilts of the best plans", float(np.mean([p.steps for p in best.values()])))


def _naive(report: Report, model: TransitionModel, most: int) -> None:
    """One instance by a loop over plans, each multiplied out by itself."""
    report.section(f"one instance, at most {most} tilts, a loop over exact hyperstates")
    words = [w for k in range(most + 1) for w in product(range(1, 13), repeat=k)]
    clock = Clock()
    loop = partial(_loop, model, words)
    probability = clock.time("a loop over all plans", loop)
    assert probability == best_tilt_plans(model, most)[1, 2].probability
    report.time("a loop over all plans", Samples((clock.seconds["a loop over all plans"],)))


def _loop(model: TransitionModel, words: list[tuple[int, ...]]) -> object:
    return max(evaluate_tilt_plan(model, 1, 2, word).probability for word in words)
