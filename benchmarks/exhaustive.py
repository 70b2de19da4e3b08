"""Random hulls: exhaustive search, and its agreement with phase I and with Eppstein's algorithm.

The experiments of the source's sections 4.8 and 5.9: 10 random points of a square, their convex
hull, all plans by breadth-first search. Expected: hulls of 5.9 sides on average and, if every
different hyperstate counts once, 99 % of the parts solved within 1000 nodes, as the source reports;
not one disagreement, ever. The branching factor is O(n^2) and the depth O(n), so the time of a part
is exponential in the worst case and a few milliseconds in nearly every one.

A part depends on the seed and its own number only, so the figures do not depend on the number of
processes, which is one in the quick form and one for each core otherwise.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from multiprocessing import get_context
from statistics import fmean, median
from time import perf_counter
from typing import TypeVar

from benchmarks.report import Report
from stochgeom.cli.progress import Progress
from stochgeom.feeding.exhaustive import NODE_LIMIT
from stochgeom.thesis.random_parts import (
    COMPARISON_LIMIT,
    SEED,
    SOURCE_COMPARED,
    SOURCE_PARTS,
    comparison,
    search_trial,
)

Result = TypeVar("Result")

TARGET = 300.0
"""Seconds for the 2000 parts on two cores."""


def run(*, quick: bool = False) -> Report:
    report = Report("exhaustive", "breadth-first search over all plans of random hulls")
    workers = 1 if quick else os.cpu_count() or 1
    _search(report, 100 if quick else SOURCE_PARTS, workers)
    _compare(report, 50 if quick else SOURCE_COMPARED, workers)
    return report


def _search(report: Report, count: int, workers: int) -> None:
    report.section(f"section 4.8: {count} parts, seed {SEED}, {NODE_LIMIT} nodes, c = 1")
    start = perf_counter()
    trials = list(in_parallel(search_trial, count, workers, "4.8"))
    seconds = perf_counter() - start
    report.figure("mean number of sides (source: 5.9)", fmean(t.sides for t in trials))
    report.figure("mean number of states in a period", fmean(t.states for t in trials))
    report.figure("percent solved (source: 99)", 100 * fmean(t.solved for t in trials))
    counted = fmean(t.solved and t.generated <= NODE_LIMIT for t in trials)
    report.figure("percent solved if duplicates count", 100 * counted)
    expanded = fmean(t.solved and t.in_tree <= NODE_LIMIT for t in trials)
    report.figure("percent solved if they are expanded again, too", 100 * expanded)
    report.figure("median of nodes, duplicates counted", median(t.generated for t in trials))
    report.figure("median of different nodes", median(t.distinct for t in trials))
    for steps in range(1, 1 + max(t.steps for t in trials)):
        share = fmean(t.solved and t.steps == steps for t in trials)
        report.figure(
            f"percent with an optimal plan of {steps} step{'s'[: steps > 1]}", 100 * share
        )
    report.figure("time", seconds, "s", TARGET)
    report.figure("  for a part and process", seconds * workers / count, "s")


def _compare(report: Report, count: int, workers: int) -> None:
    report.section(f"section 5.9: {count} parts compared, {COMPARISON_LIMIT} nodes")
    start = perf_counter()
    found = list(in_parallel(comparison, count, workers, "5.9"))
    seconds = perf_counter() - start
    report.figure("disagreements", sum(not c.agrees for c in found), target=0)
    report.figure("percent searched to the end", 100 * fmean(c.solved for c in found))
    report.figure("plan lengths compared", sum(c.lengths for c in found))
    report.figure("mean steps of the shortest plan", fmean(c.shortest for c in found))
    report.figure("most steps of a shortest plan", max(c.shortest for c in found))
    report.figure("time", seconds, "s")


def in_parallel(
    trial: Callable[[int], Result], count: int, workers: int, label: str
) -> Iterator[Result]:
    """Yield the trials of parts 0, 1, ... in order, with a progress line on stderr."""
    with ExitStack() as stack:
        progress = stack.enter_context(Progress(f"{label}, {count} parts"))
        results: Iterable[Result] = map(trial, range(count))
        if workers > 1:
            pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
            results = stack.enter_context(pool).map(trial, range(count), chunksize=20)
        for done, result in enumerate(results, 1):
            progress.show(done / count)
            yield result
