"""Cold start: a new interpreter that imports stochgeom, and one that plans the house.

Wall time of a fresh process on compiled files (.pyc) and a warm disk cache. Expected: constant; an
empty interpreter is part of it and given for comparison. The facade imports what it names when it
is first used, so naming the planner costs more than importing stochgeom.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from benchmarks.harness import Clock, measure_rounds
from benchmarks.report import Report

ROOT = Path(__file__).resolve().parents[1]
COMMANDS: dict[str, tuple[list[str], float | None]] = {
    'python -c "pass"': (["-c", "pass"], None),
    'python -c "import numpy"': (["-c", "import numpy"], None),
    'python -c "import stochgeom"': (["-c", "import stochgeom"], 0.3),
    'python -c "from stochgeom import plan_feeding"': (
        ["-c", "from stochgeom import plan_feeding"],
        0.3,
    ),
    "python -m stochgeom --version": (["-m", "stochgeom", "--version"], None),
    "python -m stochgeom plan house": (["-m", "stochgeom", "plan", "house"], 0.5),
    "python -m stochgeom plan house --json": (["-m", "stochgeom", "plan", "house", "--json"], 0.5),
}


def run(*, quick: bool = False) -> Report:
    report = Report("start_up", "new processes")
    found = measure_rounds(_one_round, 1 if quick else 21, warm_up=0 if quick else 1)
    for label, (_, target) in COMMANDS.items():
        report.time(label, found[label], target)
    return report


def _one_round(clock: Clock) -> None:
    for label, (arguments, _) in COMMANDS.items():
        clock.time(label, lambda arguments=arguments: _start(arguments))


def _start(arguments: list[str]) -> None:
    subprocess.run([sys.executable, *arguments], cwd=ROOT, check=True, capture_output=True)
