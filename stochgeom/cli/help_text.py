"""How the help of a command is broken into lines."""

from __future__ import annotations

import argparse
import re
from typing import Final

_INDENTED: Final = re.compile(r"^ ", re.MULTILINE)


class HelpFormatter(argparse.HelpFormatter):
    """Fills paragraphs to the width of the terminal; indented ones, examples, stay as they are."""

    def add_argument(self, action: argparse.Action) -> None:
        """Count the indent of subcommands, too: the longest one keeps its help on its line."""
        super().add_argument(action)
        if isinstance(action, argparse._SubParsersAction):
            self._action_max_length += self._indent_increment

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        from textwrap import fill  # only help needs it, and a start is half imports

        paragraphs = [part.strip("\n") for part in text.split("\n\n")]
        return "\n\n".join(
            part
            if _INDENTED.search(part)
            else fill(part, width, initial_indent=indent, subsequent_indent=indent)
            for part in paragraphs
        )
