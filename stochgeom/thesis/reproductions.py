"""What can be recomputed as numbers: tables, figures of numbers and experiments, by name.

A table is named as the source numbers it (``4.1``), a figure ``fig4.6``, a section ``sec4.8``.
Long experiments take a minute or so, and some need the extra ``sim``.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Final, final

from stochgeom.thesis.appendix_e import figure_e_5, figure_e_8
from stochgeom.thesis.figures_4 import figure_4_5, figure_4_6
from stochgeom.thesis.grasp_tables import table_3_1, table_c_1
from stochgeom.thesis.number_tables import (
    NumberTable,
    cost_table,
    density_table,
    evolution_table,
    grasp_table,
    matrix_table,
    order_table,
)
from stochgeom.thesis.tables import table_4_1

Tell = Callable[[float], None]


@final
@dataclass(frozen=True, slots=True)
class Reproduction:
    """Numbers of the source that can be recomputed.

    Attributes
    ----------
    name, title : str
        Such as ``"4.1"``, and what it shows.
    make : callable
        Takes a function that is told the share of work done, and returns the table.
    long : bool
        Whether it takes more than a few seconds.
    extra : str or None
        The extra that it needs.
    """

    name: str
    title: str
    make: Callable[[Tell], NumberTable]
    long: bool = False
    extra: str | None = None


def canonical_name(text: str) -> str:
    """Return the name of a table, figure or section as it is known here.

    Examples
    --------
    >>> canonical_name("Table 4.1"), canonical_name("fig-e.5"), canonical_name("c.1")
    ('4.1', 'figE.5', 'C.1')
    """
    squeezed = re.sub(r"\s+", "", text).casefold()
    match = re.fullmatch(r"(table|tab|figure|fig|section|sec)?[.-]?([0-9a-z][0-9a-z.]*)", squeezed)
    if match is None:
        return text
    kind, number = match.groups()
    prefix = {"tab": "", "fig": "fig", "sec": "sec"}.get((kind or "tab")[:3], "")
    return prefix + number.upper()


def number_of(name: str) -> str:
    """Return the number in a name.

    Examples
    --------
    >>> number_of("fig4.6"), number_of("4.1")
    ('4.6', '4.1')
    """
    return name.removeprefix("fig").removeprefix("sec")


def place_of(name: str) -> tuple[int, int, int, str]:
    """Return what names are sorted by: chapter or appendix, number, kind.

    Examples
    --------
    >>> sorted(["figE.5", "C.1", "fig4.10", "fig4.9", "4.1"], key=place_of)
    ['4.1', 'fig4.9', 'fig4.10', 'C.1', 'figE.5']
    """
    chapter, _, rest = number_of(name).partition(".")
    appendix = not chapter.isdigit()
    order = 100 + ord(chapter[0]) if appendix else int(chapter)
    kind = name[:3] if name[:3] in ("fig", "sec") else ""
    return order, int(rest) if rest.isdigit() else 0, ("", "fig", "sec").index(kind), name


def _quick(name: str, title: str, make: Callable[[str], NumberTable]) -> Reproduction:
    return Reproduction(name, title, lambda _tell: make(title))


def _orders(title: str) -> NumberTable:
    return order_table(title)


def _searched(title: str, tell: Tell) -> NumberTable:
    from stochgeom.thesis.random_parts import searched_parts

    return searched_parts(title, tell=tell)


def _compared(title: str, tell: Tell) -> NumberTable:
    from stochgeom.thesis.random_parts import compared_parts

    return compared_parts(title, tell=tell)


def _tilted(title: str, tell: Tell) -> NumberTable:
    from stochgeom.thesis.simulated_tables import tilt_table

    return tilt_table(title, tell=tell)


def _gripped(title: str, tell: Tell) -> NumberTable:
    from stochgeom.thesis.simulated_tables import gripper_table

    return gripper_table(title, tell=tell)


def _long(
    name: str, title: str, make: Callable[[str, Tell], NumberTable], extra: str | None = None
) -> Reproduction:
    return Reproduction(name, title, partial(make, title), long=True, extra=extra)


_ALL: Final = (
    _quick(
        "3.1",
        "lower bounds on the probability of a stable grasp (Eq. 3.13)",
        lambda title: grasp_table(title, table_3_1()),
    ),
    _quick(
        "4.1",
        "expected cost of the best plans of 1 to 4 squeezes, filter cost 1",
        lambda title: cost_table(title, table_4_1()),
    ),
    _quick(
        "fig4.5",
        "the house under two squeezes",
        lambda title: evolution_table(title, figure_4_5()),
    ),
    _quick(
        "fig4.6",
        "the 4gon under four squeezes",
        lambda title: evolution_table(title, figure_4_6()),
    ),
    _quick("fig6.4", "transition matrix of tilt 1, from its recovered counts", matrix_table),
    _quick("sec7.2", "to look before or after squeezing", _orders),
    _quick(
        "C.1",
        "the bounds of Table 3.1, every length of the push equally likely",
        lambda title: grasp_table(title, table_c_1()),
    ),
    _quick(
        "figE.5",
        "the 4gon under push-grasps",
        lambda title: evolution_table(title, figure_e_5()),
    ),
    _quick(
        "figE.8",
        "the house under push-grasps",
        lambda title: evolution_table(title, figure_e_8()),
    ),
    *(
        _quick(
            f"figG.{k}",
            "moments of a Beta density",
            partial(lambda figure, title: density_table(title, figure), f"G.{k}"),
        )
        for k in range(1, 5)
    ),
    _long("sec4.8", "search for optimal plans of random parts", _searched),
    _long("sec5.9", "phase I against exhaustive search", _compared),
    _long("6.1", "plans for the tilted tray, on a simulated robot", _tilted, "sim"),
    _long("secB.2", "random grasps with and without a sliding jaw, simulated", _gripped, "sim"),
)

REPRODUCTIONS: Final = {item.name: item for item in _ALL}
"""By name, in the order of the source; long experiments last."""
