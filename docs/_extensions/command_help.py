"""The directive ``command-help``: every subcommand of `stochgeom` with the help it prints."""

from __future__ import annotations

import argparse
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unittest import mock

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

import stochgeom
from stochgeom.cli.main import build_parser

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sphinx.application import Sphinx

HERE = Path(stochgeom.__file__).parents[1]

PLAIN = {"COLUMNS": "80", "NO_COLOR": "1"}
"""What argparse looks at before it breaks lines and paints them."""


def parsers_within(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """Yield the parsers of the commands that have no further subcommands, in their order."""
    groups = [a for a in parser._actions if isinstance(a, argparse._SubParsersAction)]
    if not groups:
        yield parser
    for group in groups:
        for inner in group.choices.values():
            yield from parsers_within(inner)


class CommandHelp(SphinxDirective):
    """Show the help of every command."""

    def run(self) -> list[nodes.Node]:
        """Return a section for each command."""
        with mock.patch.dict(os.environ, PLAIN):
            return [self._section(parser) for parser in parsers_within(build_parser())]

    def _section(self, parser: argparse.ArgumentParser) -> nodes.Node:
        # Where the package happens to lie is nothing to the reader.
        text = parser.format_help().replace(f"{HERE}/", "")
        section = nodes.section(ids=[nodes.make_id(parser.prog)], names=[parser.prog])
        section += nodes.title("", "", nodes.literal(text=parser.prog))
        section += nodes.literal_block(text, re.sub(r"^usage: ", "", text), language="text")
        return section


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the directive known to Sphinx."""
    app.add_directive("command-help", CommandHelp)
    return {"version": "1", "parallel_read_safe": True}
