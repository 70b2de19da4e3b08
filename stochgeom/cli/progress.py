"""A progress line on stderr for work that turns out to take more than two seconds."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Final

DELAY: Final = 2.0
"""Seconds before anything is shown."""

INTERVAL: Final = 0.2
"""Seconds between updates."""

_WIDTH: Final = 30


class Progress:
    """Shows a share of work done; silent when stderr is no terminal.

    Parameters
    ----------
    label : str
        What is going on.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._enabled = sys.stderr is not None and sys.stderr.isatty()
        self._next = time.monotonic() + DELAY
        self._shown = False

    def __enter__(self) -> Progress:
        return self

    def show(self, share: float) -> None:
        """Draw the line if it is due; `share` is in [0, 1]."""
        now = time.monotonic()
        if not self._enabled or now < self._next:
            return
        done = min(1.0, max(0.0, share))
        bar = "#" * int(done * _WIDTH)
        print(f"\r{self._label} [{bar:<{_WIDTH}}] {done:6.1%}", end="", file=sys.stderr, flush=True)
        self._next = now + INTERVAL
        self._shown = True

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._shown:  # wipe the line
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
