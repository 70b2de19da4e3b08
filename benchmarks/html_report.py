"""The report of a part with ten vertices: seconds and bytes.

From vertices to the HTML page of the plan of least expected cost, in a warm interpreter, and from
the command to the file, in a new one. Expected: well under a second and 500 kB; both grow with the
number of actions and with the certificate, which is why pages of large parts carry none. The plan
alone, without its page, is timed for comparison.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path
from statistics import median

from benchmarks.harness import Clock, measure_rounds, measure_small
from benchmarks.outlines import near_circle, small_convex
from benchmarks.report import Report
from benchmarks.small_part import HOOK, OVAL, pairs
from benchmarks.start_up import ROOT
from stochgeom import FeedingPlan, FeedingProblem, plan_feeding
from stochgeom.plotting.report import report_html

SECONDS_TARGET = 1.0
KILOBYTES_TARGET = 500.0
LARGE = 1000


def longest_plan(vertices: list[tuple[int, int]], action: str) -> FeedingPlan:
    """Return the shortest plan that orients the part up to symmetry: none has more actions."""
    return FeedingProblem(vertices, action).geometric_plan()


def run(*, quick: bool = False) -> Report:
    report = Report("html_report", "vertices to HTML page, 10 vertices")
    rounds, parts = (1, 2) if quick else (7, 40)
    actions = {
        "oval: the plan alone": lambda: plan_feeding(OVAL).angles,
        "oval: the plan and its page": lambda: report_html(plan_feeding(OVAL)),
        "hook: the plan and its page": lambda: report_html(plan_feeding(HOOK)),
        "oval, push-grasp, longest plan: page": lambda: report_html(
            longest_plan(OVAL, "push-grasp")
        ),
    }
    for label, samples in measure_small(actions, rounds).items():
        report.time(label, samples, None if "alone" in label else SECONDS_TARGET)
    _random_parts(report, parts)
    found = measure_rounds(_command, 1 if quick else 5, warm_up=0 if quick else 1)
    label = "python -m stochgeom report outline.txt"
    report.time(label, found[label], SECONDS_TARGET)
    part = near_circle(LARGE, seed=1)
    whole = measure_rounds(lambda clock: clock.time("", partial(_page, part)), 1, warm_up=0)
    report.time(f"{LARGE} vertices: plan of ten actions and its page", whole[""])
    return report


def _random_parts(report: Report, count: int) -> None:
    plans = [
        longest_plan(pairs(small_convex(10, seed)), action)
        for seed in range(count)
        for action in ("squeeze", "push-grasp")
    ]
    sizes = [len(report_html(plan).encode()) / 1000 for plan in plans]
    report.section(f"{2 * count} longest plans of random convex parts")
    report.figure("  size of the page: median", median(sizes), "kB", KILOBYTES_TARGET)
    report.figure("  size of the page: largest", max(sizes), "kB", KILOBYTES_TARGET)
    report.figure("  actions: most", max(plan.steps for plan in plans))


def _command(clock: Clock) -> None:
    with tempfile.TemporaryDirectory() as folder:
        outline = Path(folder) / "outline.txt"
        outline.write_text("\n".join(f"{x} {y}" for x, y in OVAL), encoding="utf-8")
        arguments = ["report", str(outline), "-o", str(Path(folder) / "report.html")]
        command = [sys.executable, "-m", "stochgeom", *arguments]
        clock.time(
            "python -m stochgeom report outline.txt",
            lambda: subprocess.run(command, cwd=ROOT, check=True, capture_output=True),
        )


def _page(part: object) -> str:
    return report_html(FeedingProblem(part).plan_of(10))
