"""Figs. 4.5, 4.6, E.5 and E.8, for people and for machines: distributions under a plan."""

from __future__ import annotations

from typing import Any

from stochgeom.cli.layout import table
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.evolutions import Evolution
from stochgeom.thesis.tables import Cell, Shown


def evolution_text(evolution: Evolution, digits: int) -> str:
    """Return the figure's numbers: computed value, printed value in brackets, notes."""
    notes: list[Erratum | None] = []

    def shown(cell: Cell | Shown | None) -> str:
        if cell is None:
            return "random"
        if not isinstance(cell, Cell):
            return cell.decimal(digits)
        mark = ""
        if not cell.agrees:
            if cell.erratum not in notes:
                notes.append(cell.erratum)
            mark = f"({notes.index(cell.erratum) + 1})"
        return f"{cell.computed.decimal(digits)} [{cell.printed}]{mark}"

    rows = [[shown(row.angle), *map(shown, row.cells)] for row in evolution.rows]
    header = ["angle", *(state.degrees(digits) for state in evolution.orientations)]
    costs = [
        f"  {steps}-step plan: {shown(cost)}" for steps, cost in enumerate(evolution.costs, start=1)
    ]
    name = evolution.plan.part.name if evolution.plan.part is not None else ""
    what = f"{evolution.plan.action_name}s of the {name}"
    lines = [
        f"Fig. {evolution.figure}: {what}; gripper angles, middles of ranges",
        "computed [printed]; a note tells why a printed value does not hold",
        "",
        "Probability of each orientation after each action, in degrees:",
        table(header, rows),
        "",
        "Expected cost of the best plans, filter cost 1:",
        *costs,
    ]
    if evolution.rounds:
        lines += ["", "Mean number of rounds of these plans:"]
        lines += [
            f"  {steps}-step plan: {shown(mean)}"
            for steps, mean in enumerate(evolution.rounds, start=1)
        ]
    for place, note in enumerate(notes, start=1):
        if note is None:
            lines.append(f"\n({place}) differs, and no erratum explains it")
        else:
            lines.append(
                f"\n({place}) {note.where}: printed {note.printed}; what holds: {note.holds}; "
                f"{note.reason}."
            )
    return "\n".join(lines)


def evolution_document(evolution: Evolution, digits: int) -> dict[str, Any]:
    """Return the figure's numbers for machines."""

    def document(cell: Cell | Shown | None) -> dict[str, Any] | None:
        if cell is None:
            return None
        if not isinstance(cell, Cell):
            return {"computed": cell.decimal(digits), "printed": None}
        return {
            "computed": cell.computed.decimal(digits),
            "printed": cell.printed,
            "agrees": cell.agrees,
            "erratum": None if cell.erratum is None else cell.erratum.reason,
        }

    return {
        "schema": "stochgeom/evolution/1",
        "figure": evolution.figure,
        "part": None if evolution.plan.part is None else evolution.plan.part.name,
        "orientations": [state.degrees(digits) for state in evolution.orientations],
        "rows": [
            {"angle": document(row.angle), "cells": [document(cell) for cell in row.cells]}
            for row in evolution.rows
        ],
        "costs": [document(cost) for cost in evolution.costs],
        "rounds": [document(mean) for mean in evolution.rounds],
    }
