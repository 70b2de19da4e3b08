"""``stochgeom table 7.2``: what looking before acting costs, and acting before looking."""

from __future__ import annotations

from typing import Any

from stochgeom.cli.layout import table
from stochgeom.thesis.sensor_orders import OrderRow

_KEYS = ("blind", "sense_then_act", "act_then_sense", "mixed")


def orders_text(rows: tuple[OrderRow, ...], digits: int) -> str:
    """Return the table for people."""
    header = ["part", "sensor", "no look", "look, squeeze", "squeeze, look", "any two moves"]
    lines = [[row.name, _sensor(row), *row.decimals(digits)] for row in rows]
    return "\n".join(
        [
            "Section 7.2: expected cost of a squeeze, one look, and at most one more squeeze",
            "filter cost 1, looks free; the source asks for the better order and prints no numbers",
            "",
            table(header, lines, left=[0, 1]),
        ]
    )


def orders_document(rows: tuple[OrderRow, ...], digits: int) -> dict[str, Any]:
    """Return the table for machines."""
    return {
        "schema": "stochgeom/table/1",
        "table": "7.2",
        "rows": [
            {
                "part": row.name,
                "bits": row.bits,
                "noise": row.noise,
                **dict(zip(_KEYS, row.decimals(digits), strict=True)),
            }
            for row in rows
        ],
    }


def _sensor(row: OrderRow) -> str:
    if row.bits is None:
        return "exact"
    return f"{row.bits} bit{'s' * (row.bits != 1)}, noise {row.noise}"
