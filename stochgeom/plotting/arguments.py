"""What drawing functions accept, with the errors of what they do not."""

from __future__ import annotations

from typing import Final

from stochgeom.arguments import as_count, expect

__all__ = ["MOST_TURNS", "as_count", "expect"]

MOST_TURNS: Final = 10
