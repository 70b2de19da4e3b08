"""Pictures: what a notebook shows, and the same trace on matplotlib axes.

Rich displays are SVG text made without matplotlib. Expected: milliseconds. They grow with poses and
labels, and hardly with the size of the part: large outlines are thinned to what a picture can show.
The naive road beside it is the same trace drawn by matplotlib and saved as SVG.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from benchmarks.harness import measure_small
from benchmarks.outlines import near_circle
from benchmarks.report import Report
from benchmarks.small_part import OVAL
from stochgeom import FeedingProblem, Part, catalogue_part, draw_trace, save_figure

SHOWN_TARGET = 0.1
LARGE = 100_000


def run(*, quick: bool = False) -> Report:
    report = Report("pictures", "what notebooks show, in a warm interpreter")
    problem = FeedingProblem(OVAL)
    long, traced = problem.geometric_plan(), FeedingProblem(catalogue_part("4gon")).geometric_plan()
    large = Part(near_circle(LARGE, seed=1, radius=10**9))
    _ = large.hull, large.center_of_mass  # planning needs them too: not part of the picture
    shown = {
        "oval: the part": problem.part._repr_svg_,
        "oval: the squeeze function": problem.transfer._repr_svg_,
        f"oval: a plan of {long.steps} actions, funnel and table": long._repr_html_,
        f"4gon: a plan of {traced.steps} actions, traces and table": traced._repr_html_,
        "oval: the problem, three graphs and table": problem._repr_html_,
    }
    rounds = 3 if quick else 11
    for label, samples in measure_small(shown, rounds).items():
        report.time(label, samples, SHOWN_TARGET)
    size = len(traced._repr_html_().encode()) / 1000
    report.figure("  size of the traces' HTML", size, "kB", 40.0)
    many = measure_small({f"{LARGE} vertices: the part": large._repr_svg_}, min(rounds, 3))
    for label, samples in many.items():
        report.time(label, samples)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "trace.svg"
        drawn = {"4gon: such traces by matplotlib": lambda: _by_matplotlib(traced, path)}
        for label, samples in measure_small(drawn, min(rounds, 5)).items():
            report.time(label, samples)
    return report


def _by_matplotlib(plan: object, path: Path) -> None:
    from matplotlib.figure import Figure

    save_figure(draw_trace(plan, Figure(figsize=(12, 6)).subplots()), path)
