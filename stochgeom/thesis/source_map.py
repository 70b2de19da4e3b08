"""The map of the source: each numbered thing, where it is in the package, and the tests of it.

``python -m stochgeom.thesis.source_map`` prints the map as the document ``docs/thesis-map.md``.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from itertools import groupby
from typing import Final, final


@final
@dataclass(frozen=True, slots=True)
class MapRow:
    """One or more numbered things of the source.

    Attributes
    ----------
    chapter : str
        Number and title.
    source : str
        The numbers, such as ``"Eq. 3.1-3.3"``.
    says : str
        What they say.
    objects : tuple of str
        Public names, of the facade or dotted from the package on, or the path of a document.
    tests : tuple of str
        Files of tests, or tests in them, as pytest names them.
    open : str or None
        What is missing, if something is; such a row need not have objects and tests.
    """

    chapter: str
    source: str
    says: str
    objects: tuple[str, ...]
    tests: tuple[str, ...]
    open: str | None


@cache
def map_rows() -> tuple[MapRow, ...]:
    """Return the rows, in the order of the source.

    Examples
    --------
    >>> next(row for row in map_rows() if row.source == "Table 4.1").objects
    ('thesis.tables.table_4_1',)
    """
    text = files("stochgeom.thesis").joinpath("data/map.json").read_text(encoding="utf-8")
    return tuple(
        MapRow(
            row["chapter"],
            row["source"],
            row["says"],
            tuple(row["objects"]),
            tuple(row["tests"]),
            row.get("open"),
        )
        for row in json.loads(text)
    )


_HEAD: Final = """\
# Map of the thesis

Every numbered thing of Ken Goldberg's *Stochastic Plans for Robotic Manipulation* (1990): what it
says, the public object that does it, the tests that hold it. Of {rows} rows {open}.
`stochgeom reproduce` recomputes the tables and figures, `stochgeom errata` lists where the source
is wrong.

Made by `python -m stochgeom.thesis.source_map > docs/thesis-map.md`; a test holds it up to date."""


def map_markdown(rows: Iterable[MapRow]) -> str:
    """Return the map as a Markdown document."""
    listed = list(rows)
    missing = sum(row.open is not None for row in listed)
    lines = [
        _HEAD.format(
            rows=len(listed), open=f"{missing} are **open**" if missing else "none is open"
        )
    ]
    for chapter, group in groupby(listed, key=lambda row: row.chapter):
        lines += ["", f"## {chapter}", "", "| source | what it says | in code | tests |"]
        lines += ["|---|---|---|---|", *map(_line, group)]
    return "\n".join(lines) + "\n"


def _line(row: MapRow) -> str:
    code = ", ".join(f"`{name}`" for name in row.objects)
    if row.open is not None:
        code = f"{code}; **open**: {row.open}" if code else f"**open**: {row.open}"
    tests = ", ".join(f"`{_short(test)}`" for test in row.tests)
    return f"| {row.source} | {row.says} | {code} | {tests} |"


def _short(test: str) -> str:
    """Return a test without the folder, and without the class it stands in."""
    path, *names = test.split("::")
    file = path.rpartition("/")[2]
    return f"{file}::{names[-1]}" if names else file


if __name__ == "__main__":
    sys.stdout.write(map_markdown(map_rows()))
