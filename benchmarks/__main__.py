"""Run benchmarks: ``python -m benchmarks [NAME ...|all] [--quick] [--json] [--list]``.

Without a name all of them run in their quick form.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from importlib import import_module
from types import ModuleType

from benchmarks.report import machine

NAMES = (
    "small_part",
    "large_outline",
    "growth",
    "predicates",
    "nonconvex",
    "start_up",
    "exhaustive",
    "actions_and_priors",
    "html_report",
    "pictures",
    "over_fields",
    "grasping",
    "decision",
    "sensor_trees",
    "tilting",
    "field_certificates",
    "reproduction",
)


def load(name: str) -> ModuleType:
    """Return the module of a benchmark: its docstring says what is measured, `run` measures."""
    return import_module(f"benchmarks.{name}")


def title(module: ModuleType) -> str:
    """Return the first line of a benchmark's docstring."""
    return (module.__doc__ or "").splitlines()[0]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="what to run, or all")
    parser.add_argument("--quick", action="store_true", help="smaller sizes, fewer rounds")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--list", action="store_true", help="name the benchmarks and stop")
    options = parser.parse_args(arguments)
    if options.list:
        for name in NAMES:
            print(f"{name:<20}{title(load(name))}")
        return 0
    names = list(options.names) or ["all"]
    unknown = [name for name in names if name not in (*NAMES, "all")]
    if unknown:
        parser.error(f"no benchmark {unknown[0]!r}; accepted: all, {', '.join(NAMES)}")
    chosen = NAMES if "all" in names else tuple(dict.fromkeys(names))
    _run(chosen, quick=options.quick or not options.names, as_json=options.json)
    return 0


def _run(names: Sequence[str], *, quick: bool, as_json: bool) -> None:
    if as_json:
        reports = [load(name).run(quick=quick).as_json() for name in names]
        print(json.dumps({"machine": machine(), "quick": quick, "benchmarks": reports}, indent=1))
        return
    print("; ".join(f"{key}: {value}" for key, value in machine().items()))
    for name in names:
        print()
        print(load(name).run(quick=quick).text(), flush=True)


if __name__ == "__main__":
    sys.exit(main())
