"""Tables 3.1 and C.1: lower bounds on the probability of a stable grasp, for three frictions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Final, final

from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import pushing_bound
from stochgeom.thesis.errata import GRASP_TABLE_SIDES, TABLE_C_1, Erratum
from stochgeom.thesis.parts import catalogue_entry, catalogue_names
from stochgeom.thesis.tables import Cell, Shown

FRICTIONS: Final = ("0.25", "0.1", "0.05")
"""The coefficients of friction of both tables, as the catalogue's cells name them."""


@final
@dataclass(frozen=True, slots=True)
class GraspRow:
    """The bounds of one part.

    Attributes
    ----------
    name : str
        The part.
    sides : int
        Its number of sides.
    sides_erratum : Erratum or None
        Where the source prints another number.
    cells : tuple of Cell
        One for each of `FRICTIONS`.
    """

    name: str
    sides: int
    sides_erratum: Erratum | None
    cells: tuple[Cell, ...]


def table_3_1() -> tuple[GraspRow, ...]:
    """Recompute Table 3.1: the bound of Eq. 3.13.

    Examples
    --------
    >>> [cell.computed.decimal(2) for cell in table_3_1()[2].cells]
    ['0.34', '0.44', '0.47']
    """
    return _rows("T3.1", lambda diagram: diagram.bound, {})


def table_c_1() -> tuple[GraspRow, ...]:
    """Recompute Table C.1: the bound of the uniform pushing model.

    Examples
    --------
    >>> [cell.computed.decimal(2) for cell in table_c_1()[0].cells]
    ['0.59', '0.85', '0.93']
    """
    return _rows("C.1", pushing_bound, TABLE_C_1)


def _rows(
    table: str,
    bound: Callable[[GraspDiagram], Shown],
    errata: Mapping[tuple[str, str], Erratum],
) -> tuple[GraspRow, ...]:
    rows = []
    for name in catalogue_names():
        entry = catalogue_entry(name)
        cells = tuple(
            Cell(
                bound(GraspDiagram(entry.part, mu)),
                _two_decimals(entry.printed[f"{table} mu={mu}"]),
                errata.get((name, mu)),
            )
            for mu in FRICTIONS
        )
        # The catalogue's number of sides is that of Table 4.1.
        erratum = GRASP_TABLE_SIDES if name == "rectangle" else None
        rows.append(GraspRow(name, entry.sides_printed, erratum, cells))
    return tuple(rows)


def _two_decimals(printed: str) -> str:
    """Return a cell as the source prints it: the catalogue leaves final zeros out."""
    return f"{Decimal(printed):.2f}"
