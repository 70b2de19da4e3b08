"""Numbers printed in chapter 6: a transition matrix (Fig. 6.4), plans (Tables 6.1 and 6.2).

The printed matrix of tilt 1 is an estimate from counts that are not printed. Each entry is
(alpha + x) / (12 alpha + n) with alpha = .01, so for every total n each entry leaves one whole
number x, if any; the counts are those whose sum is n and that give the printed digits back. (Ten
times alpha and ten times the counts would print the same: that alpha is .01 is taken from 6.3.1.)

The text copy of the figure has 13 entries in each row where there are 12 states. With 13 columns
not even the first row is an estimate of that form: .9901 asks for 12. In each row the entries 4 to
11 are alike, so that it does not matter which of them is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, final

from gmpy2 import f_div, mpq

from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import parse_rational
from stochgeom.thesis.errata import Erratum
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.estimation import ALPHA, TransitionModel

FIGURE_6_4_COPY: Final = (
    "0.9901 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009",
    "0.0006 0.9932 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006",
    "0.0005 0.0005 0.9945 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005",
    "0.0020 0.9785 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020 0.0020",
    "0.0003 0.7394 0.2574 0.0003 0.0003 0.0003 0.0003 0.0003 0.0003 0.0003 0.0003 0.0003 0.0003",
    "0.0528 0.0005 0.9419 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005 0.0005",
    "0.7401 0.0012 0.1244 0.0012 0.0012 0.0012 0.0012 0.0012 0.0012 0.0012 0.0012 0.0012 0.1244",
    "0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.9214 0.0714",
    "0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.0006 0.9932",
    "0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.0009 0.9901 0.0009",
    "0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.0007 0.9922 0.0007",
    "0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.0008 0.9908",
)
"""The rows as the text copy has them, 13 entries each."""

SPARE_COLUMNS: Final = range(3, 11)
"""Columns of the copy, from 0, of which one is spare: alike in each row."""

FIGURE_6_4_ERRATA: Final = {
    (8, 12): Erratum(
        "Fig. 6.4, p(8, 12)",
        ".0714",
        ".0715",
        "1.01 / 14.12 = .07153; the rest of the row asks for 13 and 1 of 14 trials",
    ),
    (12, 12): Erratum(
        "Fig. 6.4, p(12, 12)",
        ".9908",
        ".9909",
        "12.01 / 12.12 = .99092; the .0008 of the row asks for 12 or 13 trials, and 13 of 13 give "
        ".9916",
    ),
}
"""The two entries that no counts with the rest of their row can give."""

MOST_TRIALS: Final = 400
"""Totals of a row that are tried; the source made 2000 trials with twelve tilts and states."""

_PLACES: Final = 4


@final
@dataclass(frozen=True, slots=True)
class RecoveredRow:
    """Counts that explain a printed row.

    Attributes
    ----------
    counts : tuple of int
        One for each column.
    misprints : tuple of int
        The columns, from 0, whose printed digits they do not give.
    """

    counts: tuple[int, ...]
    misprints: tuple[int, ...]


@final
@dataclass(frozen=True, slots=True)
class PrintedPlan:
    """A plan of Table 6.1 or 6.2.

    Attributes
    ----------
    start, goal : int
        States.
    actions : tuple of int
        Tilts.
    estimated : str
        The probability that the planner expected.
    measured : str or None
        The share of successes in 400 executions, where there were any.
    """

    start: int
    goal: int
    actions: tuple[int, ...]
    estimated: str
    measured: str | None = None


PRINTED_PLANS: Final = (
    PrintedPlan(1, 3, (4,), ".98"),
    PrintedPlan(1, 2, (9, 7, 3), ".97"),
    PrintedPlan(1, 4, (5,), ".97"),
    PrintedPlan(1, 5, (6, 2, 7), ".98"),
    PrintedPlan(1, 6, (4, 7, 4), ".98"),
    PrintedPlan(1, 7, (9, 6), ".97"),
    PrintedPlan(1, 9, (10, 10, 7), ".97"),
    PrintedPlan(1, 8, (9, 7), ".98"),
    PrintedPlan(1, 10, (9,), ".99"),
    PrintedPlan(1, 11, (9, 1), ".98"),
    PrintedPlan(1, 12, (10, 2, 10), ".97"),
    PrintedPlan(8, 1, (5, 11, 2), ".62"),
    PrintedPlan(2, 1, (10, 2, 3), ".67", ".85"),
    PrintedPlan(2, 3, (11, 4), ".98", ".99"),
)
"""Tables 6.1 and 6.2, in the order of the former."""

PRINTED_MEAN_TILTS: Final = "2.4"
PRINTED_SD_TILTS: Final = "0.75"
"""Tilts of the plans of all 132 instances with another goal than start (6.4)."""


def figure_6_4_printed() -> tuple[tuple[str, ...], ...]:
    """Return the printed matrix of tilt 1, 12 x 12, with the spare column of the copy left out."""
    spare = SPARE_COLUMNS[0]
    return tuple(
        tuple(entry for k, entry in enumerate(row.split()) if k != spare) for row in FIGURE_6_4_COPY
    )


def recover_counts(
    printed: Sequence[str], alpha: mpq = ALPHA, misprints: int = 1
) -> tuple[RecoveredRow, ...]:
    """Return all counts that give a printed row back, up to so many misprinted entries.

    Those with the fewest misprints first, then those that miss them by least. For each total an
    entry leaves at most one whole number, the nearest one, as long as a trial changes the printed
    digits.

    Examples
    --------
    >>> recover_counts(figure_6_4_printed()[6])[0].counts
    (6, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1)
    """
    values = [parse_rational(entry) for entry in printed]
    found: list[tuple[int, mpq, RecoveredRow]] = []
    for total in range(1, MOST_TRIALS + 1):
        whole = total + len(values) * alpha
        counts = tuple(max(0, _nearest(value * whole - alpha)) for value in values)
        if sum(counts) != total:
            continue
        wrong = tuple(
            k
            for k, (count, entry) in enumerate(zip(counts, values, strict=True))
            if parse_rational(rational_decimal((count + alpha) / whole, _PLACES)) != entry
        )
        if len(wrong) <= misprints:
            missed = sum(abs((counts[k] + alpha) / whole - values[k]) for k in wrong)
            found.append((len(wrong), mpq(missed), RecoveredRow(counts, wrong)))
    return tuple(row for *_, row in sorted(found, key=lambda item: item[:2]))


def figure_6_4_counts() -> TransitionCounts:
    """Return the counts behind the printed matrix: one tilt, twelve states.

    Examples
    --------
    >>> figure_6_4_counts().total, figure_6_4_model().row(1, 7)[0]
    (177, mpq(601,812))
    """
    rows = [recover_counts(row)[0].counts for row in figure_6_4_printed()]
    return TransitionCounts([rows])


def figure_6_4_model() -> TransitionModel:
    """Return the estimate of Fig. 6.4, from its recovered counts."""
    return TransitionModel(figure_6_4_counts(), ALPHA)


def unanimous_trials(printed: str) -> tuple[int, ...]:
    """Return how many trials with one outcome give an estimate of two decimals.

    With n trials it is (n + alpha) / (n + 12 alpha), for the twelve states and alpha = .01.

    Examples
    --------
    >>> unanimous_trials(".97"), unanimous_trials(".98"), unanimous_trials(".62")
    ((4,), (5, 6, 7), ())
    """
    states = len(figure_6_4_printed())
    return tuple(
        n
        for n in range(1, MOST_TRIALS + 1)
        if rational_decimal((n + ALPHA) / (n + states * ALPHA), 2) == f"0{printed}"
    )


def _nearest(value: mpq) -> int:
    shifted = value + mpq(1, 2)
    return int(f_div(shifted.numerator, shifted.denominator))
