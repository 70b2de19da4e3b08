"""Growth with the number of vertices: time, fitted exponents, and memory.

Near-circles of 10^3 to 10^6 vertices with coordinates up to 2^50 (10^6 vertices of radius 2^40
would not stay convex when rounded). Expected: outline to squeeze function O(n log n), nearly
linear in practice since two sorted lists of edges are merged; a step of phase I O(n). Fixed costs
of some 0.5 ms flatten the fit at 10^3 vertices, so the fit from 10^4 on is given as well. The chain
of preimages of a near-circle has about n / 3 steps, so all of phase I is O(n^2) there.

Peak memory is the largest resident set of a fresh process. Expected: O(n), a few hundred bytes for
each vertex with arrays, and below 1 GB for 10^5 vertices on all roads.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from benchmarks.harness import Clock, Samples, growth_exponent, measure_rounds
from benchmarks.outlines import Outline, near_circle
from benchmarks.report import BYTES, Report
from stochgeom import Part, StepFunction, preimages, squeeze_function

ROOT = Path(__file__).resolve().parents[1]
RADIUS = 2**50
STEPS = 6
MEMORY_TARGET = 1e9
SIZES = (1_000, 3_162, 10_000, 31_623, 100_000, 316_228, 1_000_000)
CHAINS = (1_000, 2_154, 4_642, 10_000)

ROADS = {
    "start, numpy and stochgeom imported": "",
    "convex outline to squeeze function and 10 preimages": """
transfer = squeeze_function(Part(near_circle({n}, seed=1)))
preimages(transfer).of_steps(10)
""",
    "  and all its angles as objects": """
transfer = squeeze_function(Part(near_circle({n}, seed=1)))
preimages(transfer).of_steps(10)
transfer.breaks.angles, transfer.values.angles
""",
    "convex outline as a list of pairs of int": """
transfer = squeeze_function(Part(near_circle({n}, seed=1).tolist()))
preimages(transfer).of_steps(10)
""",
    "star-shaped outline to squeeze function": """
squeeze_function(Part(star({n}, seed=1)))
""",
}

SCRIPT = """
from benchmarks.growth import peak_memory
from benchmarks.outlines import near_circle, star
from stochgeom import Part, preimages, squeeze_function
{road}
print(peak_memory())
"""


def run(*, quick: bool = False) -> Report:
    report = Report("growth", "time and memory against the number of vertices, near-circles")
    _times(report, SIZES[:3] if quick else SIZES, 3 if quick else 9)
    _chains(report, (100, 300) if quick else CHAINS, 1 if quick else 3)
    _memory(report, 1_000 if quick else 100_000)
    return report


def _times(report: Report, sizes: tuple[int, ...], rounds: int) -> None:
    squeezes, steps = [], []
    for n in sizes:
        outline = near_circle(n, seed=4, radius=RADIUS)
        found = measure_rounds(lambda clock, outline=outline: _one_round(clock, outline), rounds)
        squeezes.append(found["squeeze"])
        steps.append(found["steps"].per(STEPS - 1))
    for label, samples in (
        ("outline to squeeze function", squeezes),
        ("a step of phase I (mean of steps 2 to 6)", steps),
    ):
        report.section(label)
        for n, one in zip(sizes, samples, strict=True):
            report.time(f"{n} vertices", one)
        _fits(report, sizes, samples)


def _fits(report: Report, sizes: tuple[int, ...], samples: list[Samples]) -> None:
    medians = [one.median for one in samples]
    report.figure("  exponent fitted to all sizes", growth_exponent(sizes, medians))
    late = [k for k, n in enumerate(sizes) if n >= 10_000]
    if len(late) > 1:
        fit = growth_exponent([sizes[k] for k in late], [medians[k] for k in late])
        report.figure("  exponent fitted from 10000 vertices on", fit)


def _one_round(clock: Clock, outline: Outline) -> None:
    transfer = clock.time("squeeze", lambda: squeeze_function(Part(outline)))
    chain = preimages(transfer)
    chain.of_steps(1)  # makes what later steps share
    clock.time("steps", lambda: chain.of_steps(STEPS))


def _chains(report: Report, sizes: tuple[int, ...], rounds: int) -> None:
    report.section("all of phase I, to the period")
    samples = []
    for n in sizes:
        outline = near_circle(n, seed=4, radius=RADIUS)
        lengths: list[int] = []

        def one_round(
            clock: Clock, outline: Outline = outline, lengths: list[int] = lengths
        ) -> None:
            transfer = squeeze_function(Part(outline))
            lengths.append(clock.time("chain", lambda: _chain_length(transfer)))

        samples.append(measure_rounds(one_round, rounds, warm_up=0)["chain"])
        report.time(f"{n} vertices, {lengths[-1]} steps", samples[-1])
    fit = growth_exponent(sizes, [one.median for one in samples])
    report.figure("  exponent fitted to all sizes", fit)


def _chain_length(transfer: StepFunction) -> int:
    return sum(1 for _ in preimages(transfer))


def _memory(report: Report, n: int) -> None:
    report.section(f"peak resident memory of a fresh process, {n} vertices")
    for label, road in ROADS.items():
        script = SCRIPT.format(road=road.format(n=n))
        done = subprocess.run(
            [sys.executable, "-c", script], cwd=ROOT, check=True, capture_output=True, text=True
        )
        report.figure(label, float(done.stdout), BYTES, MEMORY_TARGET)


def peak_memory() -> int:
    """Return the largest resident set of this process so far, in bytes.

    Linux hands the `ru_maxrss` of a parent on to its children, so its own record comes first.
    """
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text(encoding="ascii").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024
