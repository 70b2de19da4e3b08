"""The eight parts of the source, rebuilt from its printed numbers.

The drawings of Goldberg (1990) did not survive in the copies at hand, so each outline here was
found by search: one polygon and centre of mass that reproduces every printed cell that any
polygon can (the errata name the others). Only the rectangle (side ratio 1.472 to 1.522), the
house (walls as long as the base) and, up to small changes, the 4gon are pinned down by the
numbers; the others represent open sets of polygons.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, final

from stochgeom.errors import UnknownPartError
from stochgeom.geometry.part import Part


@final
@dataclass(frozen=True, slots=True)
class CataloguePart:
    """A part of the source with what is printed about it.

    Attributes
    ----------
    part : Part
        Outline, centre of mass and name.
    center_of_mass_is : str
        How the centre of mass was chosen.
    sides_printed : int
        The number of sides the source prints.
    printed : dict of str to str
        Printed numbers by table or figure cell, such as ``"T4.1 2-step"``, as text.
    reproduced : dict of str to bool
        Whether the rebuilt part yields the cell; where not, the errata say why.
    """

    part: Part
    center_of_mass_is: str
    sides_printed: int
    printed: dict[str, str]
    reproduced: dict[str, bool]


@cache
def _data() -> dict[str, Any]:
    text = files("stochgeom.thesis").joinpath("data/parts.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data


def catalogue_names() -> tuple[str, ...]:
    """Return the names of the parts, in the order of the source's tables.

    Examples
    --------
    >>> catalogue_names()[:3]
    ('triangle', 'rectangle', 'house')
    """
    return tuple(_data())


@cache
def catalogue_entry(name: str) -> CataloguePart:
    """Return a part with everything printed about it.

    Raises
    ------
    UnknownPartError
        If there is no part of that name.
    """
    entry = _data().get(name)
    if entry is None:
        raise UnknownPartError(f"no part {name!r}; accepted: {', '.join(catalogue_names())}")
    return CataloguePart(
        Part(entry["vertices"], entry["center_of_mass"], name),
        entry["center_of_mass_is"],
        entry["sides_printed"],
        {cell: value["printed"] for cell, value in entry["cells"].items()},
        {cell: value["reproduced"] for cell, value in entry["cells"].items()},
    )


def catalogue_part(name: str) -> Part:
    """Return a part of the source by name.

    Examples
    --------
    >>> len(catalogue_part("house"))
    5
    """
    return catalogue_entry(name).part
