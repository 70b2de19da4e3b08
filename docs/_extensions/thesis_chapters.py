"""The directives ``thesis-chapter`` and ``thesis-summary``: tables and figures, computed and drawn.

What there is comes from `stochgeom.thesis.reproductions` and `stochgeom.plotting.source_figures`
when the manual is built, so that a new figure, table or erratum is in the manual without being
written there. Long experiments are run only with ``-D thesis_long_experiments=1``.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective
from thesis_nodes import (
    Inline,
    entry,
    erratum_link,
    link_to,
    number_of,
    paragraph,
    section,
    table,
)
from thesis_results import (
    FITS_ANYWHERE,
    draw,
    errata_at,
    label_of,
    names_by_chapter,
    numbers_of,
    shown_width,
    title_of,
)

from stochgeom.cli.layout import count
from stochgeom.cli.reproduce_text import heading
from stochgeom.plotting.source_figures import SOURCE_FIGURES
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.number_tables import Entry, NumberTable, Verdict, verdict_of
from stochgeom.thesis.reproductions import REPRODUCTIONS
from stochgeom.thesis.tables import Cell

if TYPE_CHECKING:
    from sphinx.application import Sphinx

DIGITS = 4
"""Decimals of what is computed, as `stochgeom reproduce` shows them."""


# --- one table or figure --------------------------------------------------------------------------


def shown(item: Entry, notes: list[Erratum]) -> nodes.entry:
    """Return an entry: computed, printed in brackets, and a link to what explains a difference."""
    if isinstance(item, str):
        return entry(item)
    if not isinstance(item, Cell):
        return entry(item.decimal(DIGITS))
    children: list[Inline] = [
        nodes.inline("", item.computed.decimal(DIGITS)),
        " ",
        nodes.inline("", f"[{item.printed}]", classes=["printed"]),
    ]
    verdict = verdict_of(item)
    if verdict is Verdict.OPEN:
        children.append(" open")
    if verdict is Verdict.EXPLAINED and item.erratum is not None:
        if item.erratum not in notes:
            notes.append(item.erratum)
        children += [" ", erratum_link(item.erratum)]
    return entry(*children, classes=[verdict.value])


def verdict_words(verdicts: Counter[Verdict]) -> str:
    """Return how many printed numbers have each verdict.

    Examples
    --------
    >>> verdict_words(Counter({Verdict.REPRODUCED: 30, Verdict.EXPLAINED: 2}))
    '32 printed numbers: 30 reproduced, 2 explained, 0 open'
    """
    words = ", ".join(f"{verdicts[verdict]} {verdict.value}" for verdict in Verdict)
    return f"{count(verdicts.total(), 'printed number')}: {words}"


def number_nodes(numbers: NumberTable, others: Sequence[Erratum]) -> Iterator[nodes.Node]:
    """Yield the table, what became of the printed numbers, and why some of them do not hold.

    Of the notes those are left out that tell one of the other errata, which stand below.
    """
    notes: list[Erratum] = []
    rows = [[shown(item, notes) for item in row] for row in numbers.rows]
    yield table(numbers.header, rows, classes=["numbers"])
    if numbers.verdicts:
        yield paragraph(f"Computed [printed]. {verdict_words(numbers.verdicts)}.")
    for note in numbers.notes:
        if not any(note.startswith(f"{erratum.where}: ") for erratum in others):
            yield paragraph(note)
    for erratum in notes:
        yield paragraph(*erratum_words(erratum), classes=["erratum"])


def erratum_words(erratum: Erratum) -> Iterator[Inline]:
    """Yield an erratum in a paragraph, with the link to the page that settles it."""
    yield nodes.strong("", erratum.where)
    if number_of(erratum) is not None:
        yield " ("
        yield erratum_link(erratum)
        yield ")"
    yield f": printed {erratum.printed}; what holds: {erratum.holds}; {erratum.reason}."


def section_of(name: str, picture: Callable[[str], nodes.Node], *, long: bool) -> nodes.section:
    """Return the section of a table or figure.

    Parameters
    ----------
    name : str
        Such as ``"fig4.6"``.
    picture : callable
        Takes the name of a figure and returns the node that shows it.
    long : bool
        Whether long experiments are run.
    """
    found = section(label_of(name), title_of(name))
    if name in SOURCE_FIGURES:
        found += picture(name)
    numbers, others = numbers_of(name, long=long), errata_at(name)
    if numbers is not None:
        found += list(number_nodes(numbers, others))
    elif name in REPRODUCTIONS:
        found += paragraph("A long experiment, which is not run when the manual is built.")
    found += [paragraph(*erratum_words(erratum), classes=["erratum"]) for erratum in others]
    found += paragraph(nodes.literal(text=f"stochgeom reproduce {name}"))
    return found


class ThesisChapter(SphinxDirective):
    """Show the tables and figures of the chapter that is the argument."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return a section for each of them."""
        chapters = names_by_chapter()
        chapter = self.arguments[0]
        if chapter not in chapters:
            accepted = ", ".join(chapters)
            raise self.error(f"nothing of chapter {chapter!r}; accepted: {accepted}")
        long = bool(self.config.thesis_long_experiments)
        sections = [section_of(name, self._picture, long=long) for name in chapters[chapter]]
        for found in sections:
            self.state.document.note_explicit_target(found)
        return sections

    def _picture(self, name: str) -> nodes.container:
        folder = Path(self.env.doctreedir) / "thesis"
        folder.mkdir(exist_ok=True)
        path = draw(name, folder)
        # From the folder of the sources, which Sphinx writes as the root.
        place = Path(os.path.relpath(path, self.env.srcdir)).as_posix()
        width = shown_width(path.read_text(encoding="utf-8"))
        picture = nodes.image(uri=f"/{place}", alt=title_of(name), width=f"{width}px")
        wide = ["wide"] if width > FITS_ANYWHERE else []
        return nodes.container("", picture, classes=["drawing", *wide])


# --- all of them ----------------------------------------------------------------------------------


class ThesisSummary(SphinxDirective):
    """Tell of every table and figure what became of it."""

    def run(self) -> list[nodes.Node]:
        """Return the sum of it, and a table with a link to each."""
        long = bool(self.config.thesis_long_experiments)
        names = [name for chapter in names_by_chapter().values() for name in chapter]
        total: Counter[Verdict] = Counter()
        for name in names:
            numbers = numbers_of(name, long=long)
            total += Counter() if numbers is None else numbers.verdicts
        pictures = f"{count(len(SOURCE_FIGURES), 'picture')} drawn"
        header = ["", *(verdict.value for verdict in Verdict), "picture", "what"]
        rows = [self._row(name, numbers_of(name, long=long)) for name in names]
        return [
            paragraph(nodes.strong("", f"{verdict_words(total)}; {pictures}.")),
            table(header, rows, classes=["summary"]),
        ]

    def _row(self, name: str, numbers: NumberTable | None) -> list[nodes.entry]:
        verdicts = None if numbers is None else numbers.verdicts
        counts = [
            entry(str(verdicts[verdict]), classes=[verdict.value] if verdicts[verdict] else [])
            if verdicts
            else entry("")
            for verdict in Verdict
        ]
        picture = "drawn" if name in SOURCE_FIGURES else ""
        what = title_of(name).partition(": ")[2]
        if numbers is None and name in REPRODUCTIONS:
            what += " (a long experiment, not run here)"
        return [entry(link_to(label_of(name), heading(name))), *counts, entry(picture), entry(what)]


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the directives and the setting known to Sphinx."""
    app.add_directive("thesis-chapter", ThesisChapter)
    app.add_directive("thesis-summary", ThesisSummary)
    app.add_config_value("thesis_long_experiments", False, "env", bool)
    return {"version": "1", "parallel_read_safe": True}
