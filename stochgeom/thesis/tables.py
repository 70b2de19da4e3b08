"""The source's tables, recomputed beside what is printed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Protocol, final

from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.errata import TABLE_4_1, Erratum
from stochgeom.thesis.parts import catalogue_entry, catalogue_names

STEPS: Final = (1, 2, 3, 4)


class Shown(Protocol):
    """A number that decimals can be had of: a probability, a cost, an angle in degrees."""

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal."""


@final
@dataclass(frozen=True, slots=True)
class Cell:
    """A number of a table: computed, printed, and why they differ if they do."""

    computed: Shown
    printed: str
    erratum: Erratum | None

    @property
    def agrees(self) -> bool:
        """Whether the computed number rounds to the printed one."""
        _, _, decimals = self.printed.partition(".")
        return self.computed.decimal(len(decimals)) == self.printed


@final
@dataclass(frozen=True, slots=True)
class Row:
    """Expected costs of the best 1- to 4-step plans of one part."""

    name: str
    sides: int
    cells: tuple[Cell, ...]
    best: int
    """Number of steps of the stochastically optimal plan."""


def table_4_1() -> tuple[Row, ...]:
    """Recompute Table 4.1: expected cost of the best plans of 1 to 4 squeezes, c = 1.

    Examples
    --------
    >>> rows = table_4_1()
    >>> [cell.computed.decimal(1) for cell in rows[1].cells], rows[1].best
    (['6.4', '6.0', '8.0', '10.0'], 2)
    """
    rows = []
    for name in catalogue_names():
        entry = catalogue_entry(name)
        problem = FeedingProblem(entry.part)
        cells = tuple(
            Cell(
                problem.expected_cost(steps),
                entry.printed[f"T4.1 {steps}-step"],
                TABLE_4_1.get((name, steps)),
            )
            for steps in STEPS
        )
        rows.append(Row(name, entry.sides_printed, cells, problem.optimal_plan().steps))
    return tuple(rows)
