"""What there is to see of the thesis: names by chapter, numbers, errata, pictures.

It comes from `stochgeom.thesis.reproductions`, `stochgeom.thesis.errata_register` and
`stochgeom.plotting.source_figures`, whatever they hold.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from stochgeom.cli.reproduce_command import file_stem
from stochgeom.cli.reproduce_text import heading
from stochgeom.plotting.axes import save_figure
from stochgeom.plotting.source_figures import SOURCE_FIGURES
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.errata_register import ERRATA
from stochgeom.thesis.number_tables import NumberTable
from stochgeom.thesis.reproductions import REPRODUCTIONS, place_of

FITS_ANYWHERE = 640
"""Pixels of a picture that stays legible as narrow as the page of a telephone."""

TEXT_WIDTH = 736
"""Pixels of a line of text of the theme."""

SMALLEST_SCALE = 0.72
"""Letters of 11 pixels become 8."""


def chapter_of(name: str) -> str:
    """Return the chapter or appendix of a table, figure or section.

    Examples
    --------
    >>> chapter_of("fig4.6"), chapter_of("C.1"), chapter_of("sec5.9")
    ('4', 'C', '5')
    """
    return name.removeprefix("fig").removeprefix("sec").partition(".")[0]


def names_by_chapter() -> dict[str, list[str]]:
    """Return all that can be recomputed or drawn, and all that is open, in the source's order."""
    found: dict[str, list[str]] = {}
    for name in sorted({*REPRODUCTIONS, *SOURCE_FIGURES}, key=place_of):
        found.setdefault(chapter_of(name), []).append(name)
    return found


def title_of(name: str) -> str:
    """Return what a table or figure is called, and what it shows if it is not open.

    Examples
    --------
    >>> title_of("fig4.6")
    'Fig. 4.6: four squeezes of the 4gon'
    """
    known = SOURCE_FIGURES.get(name) or REPRODUCTIONS.get(name)
    return heading(name) if known is None else f"{heading(name)}: {known.title}"


@cache
def numbers_of(name: str, *, long: bool) -> NumberTable | None:
    """Return recomputed numbers; None if there are none, or if they take too long."""
    item = REPRODUCTIONS.get(name)
    if item is None or (item.long and not long):
        return None
    return item.make(lambda _share: None)


def errata_at(name: str) -> list[Erratum]:
    """Return the errata of a whole table or figure, and not of a printed number in it.

    Examples
    --------
    >>> [erratum.where for erratum in errata_at("fig6.4")]
    ['Fig. 6.4, columns of the text copy']
    """
    numbers = numbers_of(name, long=False)
    of_cells = set() if numbers is None else {cell.erratum for cell in numbers.cells}
    place = re.compile(rf"{re.escape(heading(name))}(?![0-9])")
    return [e.erratum for e in ERRATA if place.match(e.erratum.where) and e.erratum not in of_cells]


def places_of(erratum: Erratum) -> list[str]:
    """Return the tables and figures in which an erratum explains something.

    Examples
    --------
    >>> places_of(next(entry.erratum for entry in ERRATA if entry.number == 4))
    ['3.1', 'C.1']
    """
    names = [name for chapter in names_by_chapter().values() for name in chapter]
    tables = {name: numbers_of(name, long=False) for name in names}
    return [
        name
        for name, numbers in tables.items()
        if (numbers is not None and erratum in numbers.errata) or erratum in errata_at(name)
    ]


def draw(name: str, folder: Path) -> Path:
    """Draw a figure into a folder and return its file."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    path = folder / f"{file_stem(name)}.svg"
    drawn = SOURCE_FIGURES[name].draw()
    if isinstance(drawn, str):
        path.write_text(drawn, encoding="utf-8")
    else:
        save_figure(drawn, path)
        plt.close(drawn.get_figure(root=True))
    return path


def shown_width(svg: str) -> int:
    """Return how wide a picture is shown, in pixels of a page.

    As it is; or as wide as the text; or, if its letters would then be too small, wider than that,
    in a box that scrolls.

    Examples
    --------
    >>> [shown_width(f'<svg width="{width}"') for width in ("300pt", "700", "900", "1500")]
    [400, 700, 736, 1080]
    """
    match = re.search(r'<svg[^>]*?\swidth="([0-9.]+)(pt)?"', svg)
    if match is None:
        return TEXT_WIDTH
    natural = round(float(match[1]) * (4 / 3 if match[2] else 1))
    return natural if natural <= TEXT_WIDTH else max(TEXT_WIDTH, round(SMALLEST_SCALE * natural))


def label_of(name: str) -> str:
    """Return the label of the section of a table or figure."""
    return f"thesis-{file_stem(name)}"
