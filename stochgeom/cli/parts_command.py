"""``stochgeom parts``: the catalogue."""

from __future__ import annotations

import argparse
from typing import Any

from stochgeom.cli.layout import table
from stochgeom.cli.options import add_json
from stochgeom.cli.output import write, write_json
from stochgeom.exact.scalars import rational_text
from stochgeom.geometry.points import Point
from stochgeom.io.plan_json import part_json
from stochgeom.thesis.parts import catalogue_entry, catalogue_names


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "parts",
        help="list the parts of the catalogue",
        description="List the parts of Goldberg (1990), rebuilt from its printed numbers.",
    )
    add_json(parser, "print vertices as well, as JSON")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the catalogue."""
    entries = [catalogue_entry(name) for name in catalogue_names()]
    if arguments.json:
        document = {
            "schema": "stochgeom/parts/1",
            "parts": [part_json(entry.part) for entry in entries],
        }
        write_json(document)
        return 0
    rows = [
        [
            entry.part.name or "",
            str(len(entry.part)),
            str(len(entry.part.hull)),
            _text(entry.part.center_of_mass),
            entry.center_of_mass_is,
        ]
        for entry in entries
    ]
    write(
        table(["part", "vertices", "on hull", "centre of mass", "chosen as"], rows, left=[0, 3, 4])
    )
    return 0


def _text(point: Point) -> str:
    return f"({rational_text(point[0])}, {rational_text(point[1])})"
