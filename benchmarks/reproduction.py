"""All tables and figures of the source, and all errata, as the command writes them.

Expected: a few seconds for everything but the long experiments, most of it in matplotlib; under a
second for the errata. The long experiments (random parts, simulated robot) take a minute.
"""

from __future__ import annotations

import io
import tempfile
from contextlib import redirect_stdout
from pathlib import Path
from time import perf_counter

from benchmarks.report import Report
from stochgeom.cli.main import main

TARGET = 300.0


def run(*, quick: bool = False) -> Report:
    report = Report("reproduction", "stochgeom reproduce and stochgeom errata")
    _time(report, "reproduce --all, numbers only", ["reproduce", "--all", "--no-pictures"])
    _time(report, "errata --check", ["errata", "--check"], folder=False)
    if not quick:
        _time(report, "reproduce --all", ["reproduce", "--all"])
        _time(report, "reproduce --all --long", ["reproduce", "--all", "--long"])
    return report


def _time(report: Report, label: str, arguments: list[str], *, folder: bool = True) -> None:
    with tempfile.TemporaryDirectory() as target, redirect_stdout(io.StringIO()):
        start = perf_counter()
        code = main([*arguments, *(["-o", target] if folder else [])])
        seconds = perf_counter() - start
        files = len(list(Path(target).iterdir()))
    report.figure(label, seconds, "s", TARGET)
    report.figure("  exit code", code, target=0)
    if folder:
        report.figure("  files", files)
