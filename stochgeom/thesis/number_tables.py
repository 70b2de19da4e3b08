"""Tables and figures of numbers in one form: entries in rows, each with its verdict.

A cell is *reproduced* if the computed number rounds to the printed one, *explained* if it does not
and an erratum says why, and *open* otherwise. Numbers that the source does not print, and texts,
have no verdict.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Final, TypeAlias, final

from gmpy2 import mpq

from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.independent_sums import RootSum
from stochgeom.thesis.appendix_g import FIGURES_G
from stochgeom.thesis.chapter_6 import (
    FIGURE_6_4_ERRATA,
    figure_6_4_model,
    figure_6_4_printed,
)
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.evolutions import Evolution
from stochgeom.thesis.grasp_tables import FRICTIONS, GraspRow
from stochgeom.thesis.sensor_orders import sensor_orders
from stochgeom.thesis.tables import STEPS, Cell, Row, Shown

Entry: TypeAlias = str | Cell | Shown
Entries: TypeAlias = tuple[Entry, ...]


class Verdict(Enum):
    """What became of a printed number."""

    REPRODUCED = "reproduced"
    EXPLAINED = "explained"
    OPEN = "open"


def square_root(square: mpq) -> RootSum:
    """Return the root of a rational number from 0 on, such as a variance.

    Examples
    --------
    >>> square_root(mpq(2)).decimal(3), square_root(mpq(9, 16)).rational, square_root(mpq(0)) == 0
    ('1.414', mpq(3,4), True)
    """
    n, d = square.numerator, square.denominator
    return RootSum(0, [(mpq(1, d), n * d)] if n else [])


@final
@dataclass(frozen=True, slots=True)
class ExactNumber:
    """A rational number among the numbers of a table.

    Examples
    --------
    >>> ExactNumber(mpq(2, 3)).decimal(2)
    '0.67'
    """

    value: mpq

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal."""
        return rational_decimal(self.value, digits)


@final
@dataclass(frozen=True, slots=True)
class Count:
    """A whole number, shown without decimals.

    Examples
    --------
    >>> Count(4).decimal(2)
    '4'
    """

    value: int

    def decimal(self, digits: int = 4) -> str:  # noqa: ARG002 - as every number has it
        """Return the number."""
        return str(self.value)


def verdict_of(cell: Cell) -> Verdict:
    """Return what became of a printed number."""
    if cell.agrees:
        return Verdict.REPRODUCED
    return Verdict.OPEN if cell.erratum is None else Verdict.EXPLAINED


@final
@dataclass(frozen=True, slots=True)
class NumberTable:
    """A table, or a figure of numbers.

    Attributes
    ----------
    title : str
        What the numbers are.
    header : tuple of str
        A word for each column.
    rows : tuple of tuple of entries
        Texts, printed numbers with their recomputation, and numbers that are computed only.
    notes : tuple of str
        What a reader has to know.
    """

    title: str
    header: tuple[str, ...]
    rows: tuple[Entries, ...]
    notes: tuple[str, ...] = ()

    @property
    def cells(self) -> Iterator[Cell]:
        """The printed numbers."""
        return (entry for row in self.rows for entry in row if isinstance(entry, Cell))

    @property
    def verdicts(self) -> Counter[Verdict]:
        """How many printed numbers have each verdict."""
        return Counter(map(verdict_of, self.cells))

    @property
    def errata(self) -> tuple[Erratum, ...]:
        """The errata of the cells that are explained, each once."""
        found = [c.erratum for c in self.cells if c.erratum is not None and not c.agrees]
        return tuple(dict.fromkeys(found))


def cost_table(title: str, rows: tuple[Row, ...]) -> NumberTable:
    """Return Table 4.1."""
    header = ("part", "sides", *(f"{steps}-step" for steps in STEPS), "best")
    listed: list[Entries] = [(row.name, str(row.sides), *row.cells, str(row.best)) for row in rows]
    return NumberTable(title, header, tuple(listed))


def grasp_table(title: str, rows: tuple[GraspRow, ...]) -> NumberTable:
    """Return Table 3.1 or C.1."""
    header = ("part", "sides", *(f"mu = {mu}" for mu in FRICTIONS))
    listed: list[Entries] = [(row.name, _sides(row), *row.cells) for row in rows]
    return NumberTable(title, header, tuple(listed))


def _sides(row: GraspRow) -> Entry:
    if row.sides_erratum is None:
        return str(row.sides)
    return Cell(Count(row.sides), row.sides_erratum.printed, row.sides_erratum)


def evolution_table(title: str, evolution: Evolution) -> NumberTable:
    """Return a figure of distributions under a plan; its costs stand below."""
    states = [state.degrees(2) for state in evolution.orientations]
    rows: list[Entries] = [
        ("random" if row.angle is None else row.angle, *row.cells) for row in evolution.rows
    ]
    blank = ("",) * (len(states) - 1)
    rows += [
        (f"cost of {steps} step{'s' * (steps > 1)}", cost, *blank)
        for steps, cost in enumerate(evolution.costs, start=1)
    ]
    rows += [
        (f"rounds of {steps} step{'s' * (steps > 1)}", mean, *blank)
        for steps, mean in enumerate(evolution.rounds, start=1)
    ]
    return NumberTable(title, ("gripper angle", *states), tuple(rows))


def matrix_table(title: str) -> NumberTable:
    """Return Fig. 6.4: each entry from the counts that the printed digits give."""
    model, printed = figure_6_4_model(), figure_6_4_printed()
    rows: list[Entries] = [
        (
            str(state),
            *(
                Cell(ExactNumber(p), text, FIGURE_6_4_ERRATA.get((state, column)))
                for column, (p, text) in enumerate(
                    zip(model.row(1, state), printed[state - 1], strict=True), start=1
                )
            ),
        )
        for state in range(1, len(printed) + 1)
    ]
    header = ("from", *(f"to {column}" for column in range(1, len(printed) + 1)))
    return NumberTable(title, header, tuple(rows))


_MOMENTS: Final = ("alpha_1", "alpha_2", "mean", "variance")


def density_table(title: str, figure: str) -> NumberTable:
    """Return mean and variance of one of Figs. G.1 to G.4."""
    printed = next(item for item in FIGURES_G if item.figure == figure)
    density = printed.density
    row = (
        str(density.alpha_1),
        str(density.alpha_2),
        Cell(ExactNumber(density.mean), printed.mean, None),
        Cell(ExactNumber(density.variance), printed.variance, None),
    )
    erratum = printed.erratum
    notes = () if erratum is None else (f"{erratum.where}: {erratum.printed}; {erratum.reason}.",)
    return NumberTable(title, _MOMENTS, (row,), notes)


def order_table(title: str) -> NumberTable:
    """Return the costs of looking before and after squeezing (7.2.5)."""
    rows: list[Entries] = [
        (
            row.name,
            "exact" if row.bits is None else f"{row.bits} bit{'s' * (row.bits != 1)}",
            row.noise,
            *row.plans,
        )
        for row in sensor_orders()
    ]
    header = ("part", "sensor", "noise", "no look", "look first", "look last", "any two moves")
    return NumberTable(title, header, tuple(rows), ("The source prints no numbers.",))
