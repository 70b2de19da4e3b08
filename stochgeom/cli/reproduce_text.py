"""Recomputed tables as text, as comma-separated values and as documents, and the summary."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import wrap
from typing import Any, Final, final

from stochgeom.cli.errata_text import notes_text
from stochgeom.cli.layout import count, table
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.number_tables import Entry, NumberTable, Verdict, verdict_of
from stochgeom.thesis.tables import Cell

WIDTH: Final = 100


@final
@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of one name.

    Attributes
    ----------
    name, title : str
        Such as ``"fig4.6"``, and what it shows.
    numbers : NumberTable or None
        The recomputed numbers, if it has any.
    picture : str
        What became of the picture: ``"drawn"``, why it is not, or empty if there is none.
    files : tuple of str
        The files that were written.
    """

    name: str
    title: str
    numbers: NumberTable | None
    picture: str
    files: tuple[str, ...]

    @property
    def verdicts(self) -> Counter[Verdict]:
        """How many printed numbers have each verdict."""
        return Counter() if self.numbers is None else self.numbers.verdicts


def heading(name: str) -> str:
    """Return how a name reads in a title.

    Examples
    --------
    >>> heading("4.1"), heading("figE.5"), heading("sec4.8")
    ('Table 4.1', 'Fig. E.5', 'Section 4.8')
    """
    for prefix, word in (("fig", "Fig. "), ("sec", "Section ")):
        if name.startswith(prefix):
            return word + name.removeprefix(prefix)
    return f"Table {name}"


def table_text(name: str, numbers: NumberTable, digits: int) -> str:
    """Return a table for people: computed, printed in brackets, and notes for what differs."""
    notes: list[Erratum | None] = []

    def shown(entry: Entry) -> str:
        if isinstance(entry, str):
            return entry
        if not isinstance(entry, Cell):
            return entry.decimal(digits)
        mark = ""
        if not entry.agrees:
            if entry.erratum not in notes:
                notes.append(entry.erratum)
            mark = f"({notes.index(entry.erratum) + 1})"
        return f"{entry.computed.decimal(digits)} [{entry.printed}]{mark}"

    rows = [list(map(shown, row)) for row in numbers.rows]
    lines = [f"{heading(name)}: {numbers.title}"]
    if any(True for _ in numbers.cells):
        lines.append("computed [printed]; a note tells why a printed value does not hold")
    lines += ["", table(numbers.header, rows, left=[0])]
    if numbers.notes:
        lines += ["", *(line for note in numbers.notes for line in wrap(note, WIDTH))]
    return "\n".join([*lines, *notes_text(notes)])


def table_csv(numbers: NumberTable, digits: int) -> str:
    """Return a table as comma-separated values, a line for each entry that is a number."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["row", "column", "computed", "printed", "verdict", "erratum"])
    for line in _entries(numbers, digits):
        writer.writerow([line[key] or "" for key in _KEYS])
    return out.getvalue()


_KEYS: Final = ("row", "column", "computed", "printed", "verdict", "erratum")


def _entries(numbers: NumberTable, digits: int) -> list[dict[str, str | None]]:
    found = []
    for row in numbers.rows:
        label = _decimal(row[0], digits)
        for column, entry in zip(numbers.header, row, strict=True):
            if isinstance(entry, str):
                continue
            line = dict.fromkeys(_KEYS) | {"row": label, "column": column}
            line["computed"] = _decimal(entry, digits)
            if isinstance(entry, Cell):
                line["printed"], line["verdict"] = entry.printed, verdict_of(entry).value
                if entry.erratum is not None and not entry.agrees:
                    line["erratum"] = entry.erratum.where
            found.append(line)
    return found


def _decimal(entry: Entry, digits: int) -> str:
    if isinstance(entry, str):
        return entry
    return (entry.computed if isinstance(entry, Cell) else entry).decimal(digits)


def table_document(name: str, numbers: NumberTable, digits: int) -> dict[str, Any]:
    """Return a table for machines: each row as its texts, and the numbers with verdicts."""
    return {
        "name": name,
        "title": numbers.title,
        "header": list(numbers.header),
        "rows": [
            [entry if isinstance(entry, str) else None for entry in row] for row in numbers.rows
        ],
        "numbers": _entries(numbers, digits),
        "notes": list(numbers.notes),
        **_counts(numbers.verdicts),
    }


def _counts(verdicts: Counter[Verdict]) -> dict[str, int]:
    return {verdict.value: verdicts[verdict] for verdict in Verdict}


def summary_text(outcomes: Sequence[Outcome], left_out: Sequence[str] = ()) -> str:
    """Return what was reproduced, explained, left open; and what was left out."""
    rows = [
        [
            heading(item.name),
            *(_number(item, verdict) for verdict in Verdict),
            item.picture,
            item.title,
        ]
        for item in outcomes
    ]
    total: Counter[Verdict] = Counter()
    for item in outcomes:
        total += item.verdicts
    header = ["", *(verdict.value for verdict in Verdict), "picture", "what"]
    drawn = sum(item.picture == "drawn" for item in outcomes)
    words = ", ".join(f"{total[verdict]} {verdict.value}" for verdict in Verdict)
    pictures = f"; {count(drawn, 'picture')} drawn" if drawn else ""
    return "\n".join(
        [
            "Summary",
            table(header, rows, left=[0, 4, 5]),
            "",
            f"{count(total.total(), 'printed number')}: {words}{pictures}",
            *([f"left out without --long: {', '.join(map(heading, left_out))}"] * bool(left_out)),
        ]
    )


def _number(item: Outcome, verdict: Verdict) -> str:
    return str(item.verdicts[verdict]) if item.verdicts else "-"


def summary_document(
    outcomes: Sequence[Outcome], digits: int, left_out: Sequence[str] = ()
) -> dict[str, Any]:
    """Return the summary and all numbers for machines."""
    total: Counter[Verdict] = Counter()
    for item in outcomes:
        total += item.verdicts
    return {
        "schema": "stochgeom/reproduction/1",
        **_counts(total),
        "left_out": list(left_out),
        "items": [
            {
                "name": item.name,
                "title": item.title,
                "picture": item.picture or None,
                "files": list(item.files),
                "numbers": None
                if item.numbers is None
                else table_document(item.name, item.numbers, digits),
            }
            for item in outcomes
        ],
    }
