"""The command `stochgeom`, called in this process and in one of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from typing import Any

import pytest

from stochgeom.cli.main import main
from tests.repo.sources import ROOT


@dataclass(frozen=True)
class Result:
    """What a call left behind."""

    code: int
    out: str
    err: str

    @property
    def document(self) -> dict[str, Any]:
        """Standard output as JSON; numbers with a point or NaN have no place in our files."""
        return json.loads(self.out, parse_float=_refuse, parse_constant=_refuse)


def _refuse(text: str) -> None:
    raise AssertionError(f"{text} is a number with a point")


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> Result:
    """Call `main` and return its exit code and output."""
    capsys.readouterr()
    code = main(arguments)
    captured = capsys.readouterr()
    return Result(code, captured.out, captured.err)


def start(*arguments: str | bytes, **settings: Any) -> subprocess.CompletedProcess[bytes]:
    """Run ``python -m stochgeom`` as a process of its own; output is captured as bytes."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **settings.pop("environment", {})}
    settings.setdefault("stdin", subprocess.DEVNULL if "input" not in settings else None)
    if settings["stdin"] is None:
        del settings["stdin"]
    settings.setdefault("stdout", subprocess.PIPE)
    settings.setdefault("stderr", subprocess.PIPE)
    return subprocess.run(
        [sys.executable, "-m", "stochgeom", *arguments],
        env=environment,
        timeout=60,
        check=False,
        **settings,
    )
