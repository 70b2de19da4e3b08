"""Convex outlines of 10^4 and 10^5 vertices, beside a plain float64 numpy program.

Integer coordinates up to 2^40, given as an int64 array. Measured are the road from the outline to
the squeeze function, and each of the first ten steps of phase I, alternately with a float program
for the same algorithm (`benchmarks.float_program`). Both give the same answer up to rounding; that
is measured too. Expected: O(n log n) for the squeeze function, at most 10 times the float program;
O(m) for each step of phase I, m the number of steps of the squeeze function, at most 2 times.

The outlines: a near-circle, where most edges are stable (m is about 3 n / 4); a 2:1 ellipse, whose
diameter has so large a slope that hardly any edge is stable (m is 1 or 2, and phase I is over at
once: what is timed there are the fixed costs of a step); and a curve of constant width that is no
circle, again with many stable edges. The first step of phase I also makes what the others share.

The straight road in exact Python objects (`benchmarks.naive_program`), O(n^2), is timed at 1000
vertices to show what the arrays are for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks import float_program, naive_program
from benchmarks.harness import Clock, Samples, measure_rounds
from benchmarks.outlines import Outline, constant_width, near_circle
from benchmarks.report import Report
from stochgeom import Part, Preimages, StepFunction, preimages, squeeze_function

STEPS = 10
TARGETS = (10.0, 2.0)
"""Most times the float program, for the squeeze function and for a step of phase I."""

AGREEMENT = 1e-9
"""Largest difference, in radians, at which the float program counts as agreeing."""

OUTLINES: dict[str, Callable[[int], Outline]] = {
    "near-circle": lambda n: near_circle(n, seed=1),
    "2:1 ellipse": lambda n: near_circle(n, seed=2, squash=0.5),
    "constant width": lambda n: constant_width(n, seed=3),
}


def run(*, quick: bool = False) -> Report:
    report = Report("large_outline", "exact against plain float64 numpy, timed alternately")
    for n in (1_000,) if quick else (10_000, 100_000):
        for name, make in OUTLINES.items():
            _compare(report, f"{name}, {n} vertices", make(n), 3 if quick else 21)
    _naive(report, near_circle(60 if quick else 1_000, seed=1), 1 if quick else 3)
    return report


def library_squeeze(outline: Outline) -> StepFunction:
    """Return the squeeze function, starting from the array of vertices."""
    return squeeze_function(Part(outline))


def _compare(report: Report, name: str, outline: Outline, rounds: int) -> None:
    transfer, steps = library_squeeze(outline), float_program.squeeze(outline)
    found = measure_rounds(lambda clock: _one_round(clock, outline), rounds)
    # The targets are meant for large outlines; fixed costs rule small ones.
    outline_target, step_target = TARGETS if len(outline) >= 10_000 else (None, None)
    report.section(f"{name}; steps of the squeeze function: {len(transfer)}")
    exact, plain = found["squeeze, library"], found["squeeze, float"]
    report.time("outline to squeeze function: library", exact)
    report.time("outline to squeeze function: float program", plain)
    report.ratio("  ratio", exact.over(plain), outline_target)
    count = sum(label.startswith("step") for label in found) // 2
    exact_steps, plain_steps = _steps(found, count, "")
    span = f"phase I, each of steps 1 to {count}" if count > 1 else "phase I, the only step"
    report.time(f"{span}: library", _pooled(exact_steps))
    report.time(f"{span}: float program", _pooled(plain_steps))
    ratios = [a.over(b) for a, b in zip(exact_steps, plain_steps, strict=True)]
    report.ratio("  ratio, median of the steps", float(np.median(ratios)), step_target)
    if count > 1:
        worst = int(np.argmax(ratios))
        report.ratio(f"  ratio, largest (step {worst + 1})", ratios[worst], step_target)
        report.ratio("  ratio, the steps together", _total(exact_steps) / _total(plain_steps))
    cold, plain_cold = _steps(found, count, "cold ")
    report.ratio("  ratio, the steps together, cold", _total(cold) / _total(plain_cold))
    report.figure("largest difference of an angle", disagreement(transfer, steps), "", AGREEMENT)


def _one_round(clock: Clock, outline: Outline) -> None:
    transfer = clock.time("squeeze, library", lambda: library_squeeze(outline))
    steps = clock.time("squeeze, float", lambda: float_program.squeeze(outline))
    # A step of a few microseconds just after an outline of millions of operations times the
    # processor's instruction cache. So both programs first run on functions of their own ("cold"),
    # then on the ones above, of which nothing is made yet.
    rehearsal = library_squeeze(outline), float_program.squeeze(outline)
    _phase_one(clock, *rehearsal, "cold ")
    _phase_one(clock, transfer, steps, "")


def _phase_one(clock: Clock, transfer: StepFunction, steps: float_program.Steps, how: str) -> None:
    exact, plain = preimages(transfer), float_program.PhaseOne(steps)
    for k in range(1, STEPS + 1):
        clock.time(f"{how}step {k}, library", lambda k=k: exact.of_steps(k))
        clock.time(f"{how}step {k}, float", plain.advance)
        if exact.complete:
            return


def _steps(found: dict[str, Samples], count: int, how: str) -> tuple[list[Samples], list[Samples]]:
    """Return the times of steps 1 to `count` of the library and of the float program."""
    exact, plain = (
        [found[f"{how}step {k}, {program}"] for k in range(1, count + 1)]
        for program in ("library", "float")
    )
    return exact, plain


def _total(samples: list[Samples]) -> float:
    return sum(one.median for one in samples)


def _pooled(samples: list[Samples]) -> Samples:
    return Samples(tuple(value for one in samples for value in one.seconds))


def disagreement(transfer: StepFunction, steps: float_program.Steps) -> float:
    """Return the largest difference of a break, a value or a width, infinity if counts differ."""
    if len(transfer) != len(steps.breaks) or len(transfer) != len(steps.values):
        return float("inf")
    exact, plain = preimages(transfer), float_program.PhaseOne(steps)
    differences = [
        np.abs(transfer.breaks.to_float() - steps.breaks).max(),
        np.abs(transfer.values.to_float() - steps.values).max(),
    ]
    for k in range(1, STEPS + 1):
        plain.advance()
        differences.append(abs(exact.of_steps(k).width.to_float() - plain.widths[-1]))
        if exact.complete or plain.complete:
            differences.append(0.0 if exact.complete == plain.complete else float("inf"))
            break
    return float(max(differences))


def _naive(report: Report, outline: Outline, rounds: int) -> None:
    def one_round(clock: Clock) -> None:
        transfer = clock.time("squeeze, library", lambda: library_squeeze(outline))
        breaks, values = clock.time("squeeze, naive", lambda: naive_program.squeeze(outline))
        clock.time("phase I, library", lambda: first_widths(preimages(transfer)))
        clock.time("phase I, naive", lambda: naive_program.widths(breaks, values, STEPS))

    found = measure_rounds(one_round, rounds, warm_up=0 if rounds == 1 else 1)
    report.section(f"near-circle, {len(outline)} vertices: exact objects in Python loops")
    for what in ("squeeze", "phase I"):
        exact, naive = found[f"{what}, library"], found[f"{what}, naive"]
        label = "outline to squeeze function" if what == "squeeze" else "phase I, ten steps"
        report.time(f"{label}: library", exact)
        report.time(f"{label}: naive", naive)
        report.ratio("  naive to library", naive.over(exact))


def first_widths(chain: Preimages) -> list[Any]:
    """Return the widths of the first ten preimages, or as many as there are."""
    widths = []
    for preimage in chain:
        widths.append(preimage.width)
        if len(widths) == STEPS:
            break
    return widths
