"""``stochgeom table``: the source's tables and figures of numbers, computed and printed."""

from __future__ import annotations

import argparse
from typing import Any

from stochgeom.cli.errata_text import notes_text
from stochgeom.cli.evolution_text import evolution_document, evolution_text
from stochgeom.cli.grasp_table_text import grasp_table_document, grasp_table_text
from stochgeom.cli.layout import table
from stochgeom.cli.options import add_digits, add_json, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.errors import UnknownReproductionError
from stochgeom.thesis.appendix_e import figure_e_5, figure_e_8
from stochgeom.thesis.figures_4 import figure_4_5, figure_4_6
from stochgeom.thesis.grasp_tables import table_3_1, table_c_1
from stochgeom.thesis.tables import STEPS, Cell, Row, table_4_1

_TABLES = {"4.1": table_4_1}
_GRASP_TABLES = {"3.1": table_3_1, "C.1": table_c_1}
_FIGURES = {"4.5": figure_4_5, "4.6": figure_4_6, "E.5": figure_e_5, "E.8": figure_e_8}
_NUMBERS = sorted({*_TABLES, *_GRASP_TABLES, *_FIGURES, "7.2"})


def _number(text: str) -> str:
    """Return a number as it stands in the source, from any spelling that `reproduce` knows."""
    from stochgeom.thesis.reproductions import canonical_name, number_of

    number = number_of(canonical_name(text))
    if number not in _NUMBERS:
        raise UnknownReproductionError(
            f"no table {text[:40]!r}; accepted: {', '.join(_NUMBERS)}", where="NUMBER"
        )
    return number


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "table",
        help="recompute a table of the source, or a figure of numbers",
        description="Print a table of Goldberg (1990), or a figure of numbers, computed and "
        "printed values side by side.",
    )
    parser.add_argument(
        "number", metavar="NUMBER", help=f"{', '.join(_NUMBERS)}; or such as fig4.6"
    )
    add_digits(parser)
    add_json(parser, "print a JSON document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the table; exit code 1 if a cell differs that no erratum explains."""
    digits, number = read_digits(arguments.digits), _number(arguments.number)
    cells: list[Cell] = []
    if number == "7.2":
        from stochgeom.cli.orders_text import orders_document, orders_text
        from stochgeom.thesis.sensor_orders import sensor_orders

        orders = sensor_orders()
        text, document = orders_text(orders, digits), orders_document(orders, digits)
    elif number in _FIGURES:
        evolution = _FIGURES[number]()
        text = evolution_text(evolution, digits)
        document = evolution_document(evolution, digits)
        cells = list(evolution.cells)
    elif number in _GRASP_TABLES:
        grasps = _GRASP_TABLES[number]()
        text = grasp_table_text(number, grasps, digits)
        document = grasp_table_document(number, grasps, digits)
        cells = [cell for row in grasps for cell in row.cells]
    else:
        rows = _TABLES[number]()
        text = table_text(number, rows, digits)
        document = table_document(number, rows, digits)
        cells = [cell for row in rows for cell in row.cells]
    if arguments.json:
        write_json(document)
    else:
        write(text)
    return 1 if any(not cell.agrees and cell.erratum is None for cell in cells) else 0


def table_text(number: str, rows: tuple[Row, ...], digits: int) -> str:
    """Return the table for people: computed value, printed value in brackets, marks."""
    lines, notes = [], []
    for row in rows:
        cells = []
        for steps, cell in zip(STEPS, row.cells, strict=True):
            mark = ""
            if not cell.agrees:
                notes.append(cell.erratum)
                mark = f"({len(notes)})"
            best = "*" if steps == row.best else " "
            cells.append(f"{cell.computed.decimal(digits)}{best} [{cell.printed:>4}]{mark:3}")
        lines.append([row.name, str(row.sides), *cells])
    header = ["part", "sides", *(f"{steps}-step" for steps in STEPS)]
    text = [
        f"Table {number}: expected cost of the best plans of 1 to 4 squeezes, filter cost 1",
        "computed [printed]; * is the least cost; a note tells why a printed value does not hold",
        "",
        table(header, lines, left=[0]),
    ]
    return "\n".join([*text, *notes_text(notes)])


def table_document(number: str, rows: tuple[Row, ...], digits: int) -> dict[str, Any]:
    """Return the table for machines."""
    return {
        "schema": "stochgeom/table/1",
        "table": number,
        "rows": [
            {
                "part": row.name,
                "sides": row.sides,
                "best_steps": row.best,
                "cells": [
                    {
                        "steps": steps,
                        "computed": cell.computed.decimal(digits),
                        "printed": cell.printed,
                        "agrees": cell.agrees,
                        "erratum": None if cell.erratum is None else cell.erratum.reason,
                    }
                    for steps, cell in zip(STEPS, row.cells, strict=True)
                ],
            }
            for row in rows
        ],
    }
