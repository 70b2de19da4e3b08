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

from stochgeom.arguments import expect
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
    appendix_e : Part
        The part as Appendix E has it. The house has its centre of mass at the mean of its vertices
        there: the point of the other chapters does not give the printed distribution. All other
        parts are the same.
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
    appendix_e: Part
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
    part = Part(entry["vertices"], entry["center_of_mass"], name)
    other = entry.get("center_of_mass_appendix_E")
    return CataloguePart(
        part,
        part if other is None else Part(entry["vertices"], other, name),
        entry["center_of_mass_is"],
        entry["sides_printed"],
        {cell: value["printed"] for cell, value in entry["cells"].items()},
        {cell: value["reproduced"] for cell, value in entry["cells"].items()},
    )


def catalogue_part(name: str, *, appendix: str | None = None) -> Part:
    """Return a part of the source by name.

    Parameters
    ----------
    name : str
        One of `catalogue_names`.
    appendix : str, optional
        ``"E"`` for the centre of mass of that appendix, on push-grasps; it differs for the house.

    Raises
    ------
    UnknownPartError
        If there is no part of that name, or another appendix is asked for.

    Examples
    --------
    >>> catalogue_part("house").center_of_mass, catalogue_part("house", appendix="E").center_of_mass
    ((mpq(0,1), mpq(0,1)), (mpq(0,1), mpq(2,5)))
    """
    if appendix not in (None, "E"):
        raise UnknownPartError(f"appendix {appendix!r}; accepted: 'E', or none")
    entry = catalogue_entry(expect(name, str, "a name of the catalogue", "part"))
    return entry.part if appendix is None else entry.appendix_e
