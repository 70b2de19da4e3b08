"""What a benchmark found: rows of figures, as a table for people or JSON for programs."""

from __future__ import annotations

import os
import platform
from dataclasses import asdict, dataclass, field
from importlib.metadata import version
from pathlib import Path
from typing import Any

from benchmarks.harness import Samples, measure_rounds

PACKAGES = ("numpy", "gmpy2", "python-flint", "sympy")
SECONDS = "s"
TIMES = "x"
BYTES = "B"


@dataclass(frozen=True)
class Row:
    """One figure, perhaps with its spread over the rounds and a target not to be exceeded."""

    label: str
    value: float
    unit: str
    least: float | None = None
    most: float | None = None
    target: float | None = None

    @property
    def met(self) -> bool | None:
        """Whether the target is kept; None without a target."""
        return None if self.target is None else self.value <= self.target


@dataclass
class Report:
    """The rows of one benchmark, in sections, with remarks."""

    name: str
    title: str
    rows: list[Row | str] = field(default_factory=list)

    def section(self, text: str) -> None:
        """Begin a section, or make a remark."""
        self.rows.append(text)

    def time(self, label: str, samples: Samples, target: float | None = None) -> None:
        """Add the median of timed samples."""
        row = Row(label, samples.median, SECONDS, samples.least, samples.most, target)
        self.rows.append(row)

    def ratio(self, label: str, value: float, target: float | None = None) -> None:
        """Add a ratio."""
        self.rows.append(Row(label, value, TIMES, target=target))

    def figure(self, label: str, value: float, unit: str = "", target: float | None = None) -> None:
        """Add any other figure."""
        self.rows.append(Row(label, value, unit, target=target))

    def text(self) -> str:
        """Return the rows as a table."""
        lines = [f"{self.name}: {self.title}"]
        lines += [f"  {row}" if isinstance(row, str) else _line(row) for row in self.rows]
        return "\n".join(lines)

    def as_json(self) -> dict[str, Any]:
        """Return the report as JSON values."""
        section, rows = "", []
        for row in self.rows:
            if isinstance(row, str):
                section = row
            else:
                rows.append({"section": section, **asdict(row), "met": row.met})
        return {"name": self.name, "title": self.title, "rows": rows}


def _line(row: Row) -> str:
    spread = ""
    if row.least is not None and row.most is not None:
        spread = f"{shown(row.least, row.unit)} .. {shown(row.most, row.unit)}"
    verdict = ""
    if row.target is not None:
        verdict = f"at most {shown(row.target, row.unit)}: {'met' if row.met else 'MISSED'}"
    line = f"    {row.label:<48}{shown(row.value, row.unit):>10}  {spread:<22}{verdict}"
    return line.rstrip()


def shown(value: float, unit: str) -> str:
    """Return a figure with its unit, three digits or so.

    Examples
    --------
    >>> shown(0.00123, "s"), shown(2.5, "x"), shown(3e8, "B"), shown(1.04, ""), shown(7432, "")
    ('1.23 ms', '2.50 x', '300 MB', '1.04', '7432')
    """
    if unit == SECONDS:
        for scale, name in ((1.0, "s"), (1e-3, "ms"), (1e-6, "us")):
            if value >= scale:
                return f"{_digits(value / scale)} {name}"
        return f"{_digits(value * 1e9)} ns"
    if unit == BYTES:
        return f"{value / 1e6:.0f} MB"
    return f"{_digits(value)} {unit}".rstrip()


def _digits(value: float) -> str:
    if value == int(value) and abs(value) < 1e9:
        return str(int(value))
    if abs(value) < 1e-2:
        return f"{value:.1e}"
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def machine() -> dict[str, str]:
    """Return what figures depend on: processor, Python, packages, and how busy the machine is.

    The pace, the time of a fixed loop in plain Python, tells a slow hour of a shared machine.
    """
    packages = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    return {
        "processor": f"{_processor()}, {os.cpu_count()} cores",
        "python": f"{platform.python_implementation()} {platform.python_version()}",
        "packages": packages,
        "load": f"{os.getloadavg()[0]:.2f}",
        "pace": f"{shown(_pace(), SECONDS)} for 10^6 additions",
    }


def _pace() -> float:
    return measure_rounds(lambda clock: clock.time("loop", _additions), rounds=5)["loop"].median


def _additions() -> int:
    total = 0
    for number in range(1_000_000):
        total += number
    return total


def _processor() -> str:
    listing = Path("/proc/cpuinfo")
    if listing.exists():
        for line in listing.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
