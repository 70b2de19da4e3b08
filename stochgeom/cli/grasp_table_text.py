"""Tables 3.1 and C.1 in words and as documents."""

from __future__ import annotations

from typing import Any, Final

from stochgeom.cli.errata_text import notes_text
from stochgeom.cli.layout import table
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.grasp_tables import FRICTIONS, GraspRow

_TITLES: Final = {
    "3.1": "lower bound on the probability of a stable grasp (Eq. 3.13)",
    "C.1": "the same, every length of the push equally likely (Eq. C.7)",
}


def grasp_table_text(number: str, rows: tuple[GraspRow, ...], digits: int) -> str:
    """Return the table for people: computed value, printed value in brackets, marks."""
    lines: list[list[str]] = []
    notes: list[Erratum | None] = []
    for row in rows:
        sides = str(row.sides)
        if row.sides_erratum is not None:
            notes.append(row.sides_erratum)
            sides += f" [{row.sides_erratum.printed}]({len(notes)})"
        cells = []
        for cell in row.cells:
            mark = ""
            if not cell.agrees:
                notes.append(cell.erratum)
                mark = f"({len(notes)})"
            cells.append(f"{cell.computed.decimal(digits)} [{cell.printed}]{mark:3}")
        lines.append([row.name, sides, *cells])
    header = ["part", "sides", *(f"mu = {mu}" for mu in FRICTIONS)]
    text = [
        f"Table {number}: {_TITLES[number]}",
        "computed [printed]; a note tells why a printed value does not hold",
        "",
        table(header, lines, left=[0, 1]),
    ]
    return "\n".join([*text, *notes_text(notes)])


def grasp_table_document(number: str, rows: tuple[GraspRow, ...], digits: int) -> dict[str, Any]:
    """Return the table for machines."""
    return {
        "schema": "stochgeom/table/1",
        "table": number,
        "rows": [
            {
                "part": row.name,
                "sides": row.sides,
                "cells": [
                    {
                        "mu": mu,
                        "computed": cell.computed.decimal(digits),
                        "printed": cell.printed,
                        "agrees": cell.agrees,
                        "erratum": None if cell.erratum is None else cell.erratum.reason,
                    }
                    for mu, cell in zip(FRICTIONS, row.cells, strict=True)
                ],
            }
            for row in rows
        ],
    }
