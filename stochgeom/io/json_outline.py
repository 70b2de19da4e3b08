"""Outlines as JSON: a list of pairs, an object, a plan document or GeoJSON.

- ``[[0, 0], [3, 0], [3, 2]]``;
- an object with ``vertices`` and, if wanted, ``name``, ``center_of_mass`` and ``holes``;
- a document of schema ``stochgeom/plan/1``, whose ``part`` is such an object;
- a GeoJSON ``Polygon``, with ``name`` and ``center_of_mass`` if wanted, or a ``Feature`` that has
  one (its properties are not read).

Coordinates are JSON numbers or text (``"1/3"``); both are read from their digits. Keys that are
not known are passed over, for files come from elsewhere, unless they look like a misspelling of
a known one: a centre of mass must not get lost over a letter. Keys that make edges arcs are
refused: chords in the place of arcs would be another part.
"""

from __future__ import annotations

import difflib
from typing import Any, Final, NoReturn, TypeAlias

from stochgeom.errors import FormatError, NumberError
from stochgeom.exact import scalars
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.fields import regular_polygon_field
from stochgeom.exact.surds import field_symbols
from stochgeom.io.exact_json import NumberText, kind_of, load_json
from stochgeom.io.rings import (
    Outline,
    Point,
    Ring,
    is_showable,
    read_pair,
    require_some_vertices,
    shown,
    without_closing_vertex,
)

ACCEPTED: Final = (
    'accepted: a list of [x, y] pairs, an object with "vertices" (and "name", "center_of_mass", '
    '"holes"), a stochgeom/plan/1 document or a GeoJSON Polygon'
)

SCHEMAS: Final = ("stochgeom/plan/1",)
"""Schemas of the documents whose `part` is read."""

_PART_KEYS: Final = ("vertices", "name", "center_of_mass", "holes", "field")

_CURVE_KEYS: Final = frozenset({"arc", "arcs", "bulge", "bulges", "curve", "curves"})
"""With these, DXF exports and the like say that edges are no straight lines."""

# From 0.7 on "vertexes", "centreOfMass" and "center_of_gravity" count as misspelt; "filename",
# "label" and "description" do not.
_LIKENESS: Final = 0.7

_Object: TypeAlias = dict[str, Any]
_Symbols: TypeAlias = "dict[str, Algebraic] | None"


def parse_json(text: str) -> Outline:
    """Read an outline from JSON.

    Raises
    ------
    FormatError
        For broken JSON, repeated or misspelt keys, curved edges, and values of another shape.
    TooFewVerticesError
        For a ring without any vertex.
    NumberError
        If a coordinate is not a number, NaN and infinity among them.

    Examples
    --------
    >>> parse_json('[[0, 0], [0.1, 0], ["1/3", 2e1]]').vertices
    ((mpq(0,1), mpq(0,1)), (mpq(1,10), mpq(0,1)), (mpq(1,3), mpq(20,1)))
    >>> parse_json('{"vertices": [[0, 0], [1, 0], [0, 1]], "name": "wedge"}').name
    'wedge'
    """
    document = load_json(text, ACCEPTED)
    if isinstance(document, list):
        return Outline(_ring(document, "", "vertices"))
    if isinstance(document, dict):
        return _from_object(document)
    raise FormatError(f"{kind_of(document)} is not an outline; {ACCEPTED}")


def _from_object(document: _Object) -> Outline:
    if "vertices" in document:
        return _from_part(document)
    if "part" in document:
        return _from_plan(document)
    if "type" in document:
        return _from_geojson(document)
    return _from_part(document)


def _from_plan(document: _Object) -> Outline:
    schema = document.get("schema", SCHEMAS[0])
    if schema not in SCHEMAS:
        raise FormatError(
            f"{kind_of(schema)} is not a schema that is read; accepted: {', '.join(SCHEMAS)}",
            where="schema",
        )
    part = document["part"]
    if not isinstance(part, dict):
        raise FormatError(
            f'{kind_of(part)} is not a part; accepted: an object with "vertices"', where="part"
        )
    return _from_part(part)


def _from_part(part: _Object) -> Outline:
    _refuse_keys(part)
    if "vertices" not in part:
        keys = shown(", ".join(part)) if part else "none"
        raise FormatError(f'no key "vertices" (keys found: {keys}); {ACCEPTED}')
    symbols = _field_symbols(part.get("field"))
    return Outline(
        _ring(part["vertices"], "", "vertices", symbols),
        _holes(part.get("holes"), symbols),
        _center_of_mass(part.get("center_of_mass"), symbols),
        _name(part.get("name")),
    )


def _field_symbols(value: Any) -> _Symbols:
    """Return what letters in coordinates stand for, given the field that a document names."""
    if value is None:
        return None
    order = value.get("regular polygon") if isinstance(value, dict) else None
    if isinstance(order, NumberText) and order.isdecimal() and len(order) < 6 and int(order) > 2:
        field = regular_polygon_field(int(order))
        return None if field is None else field_symbols(field)
    root = value.get("square root of") if isinstance(value, dict) else None
    if isinstance(root, NumberText) and root.isdecimal():
        return None  # the coordinates spell their roots out
    raise FormatError(
        f'{kind_of(value)} is not a field; accepted: {{"regular polygon": n}}, in whose text g is '
        '2 cos(2 pi/n) and s is 2 sin(2 pi/n), or {"square root of": d}',
        where="field",
    )


def _from_geojson(document: _Object) -> Outline:
    geometry: Any = document
    if document["type"] == "Feature":
        geometry = document.get("geometry")
        if not isinstance(geometry, dict):
            raise FormatError(
                f"{kind_of(geometry)} is not a geometry; accepted: a GeoJSON Polygon",
                where="geometry",
            )
    if geometry.get("type") != "Polygon":
        raise FormatError(
            f"{kind_of(geometry.get('type'))} is not a geometry that is read; {ACCEPTED}",
            where="type",
        )
    _refuse_keys(geometry)
    rings = geometry.get("coordinates")
    if not isinstance(rings, list):
        _refuse_ring_list(rings, "coordinates")
    require_some_vertices(rings, "coordinates")
    return Outline(
        _ring(rings[0], "", "coordinates"),
        _holes(rings[1:]),
        _center_of_mass(geometry.get("center_of_mass")),
        _name(geometry.get("name")),
    )


def _refuse_keys(part: _Object) -> None:
    for key in part:
        if key in _PART_KEYS:
            continue
        if key.lower() in _CURVE_KEYS:
            raise FormatError(
                "curved edges are not read; accepted: straight edges from vertex to vertex",
                where=f"key {shown(key)}",
            )
        likely = difflib.get_close_matches(key.lower(), _PART_KEYS, n=1, cutoff=_LIKENESS)
        if likely:
            raise FormatError(
                f'not a known key, but close to "{likely[0]}"; '
                f"accepted: {', '.join(_PART_KEYS)}, and keys unlike these",
                where=f"key {shown(key)}",
            )


def _holes(value: Any, symbols: _Symbols = None) -> tuple[Ring, ...]:
    if value is None:
        return ()
    if not isinstance(value, list):
        _refuse_ring_list(value, "holes")
    return tuple(
        _ring(ring, f"hole {index}, ", f"hole {index}", symbols) for index, ring in enumerate(value)
    )


def _refuse_ring_list(value: Any, where: str) -> NoReturn:
    raise FormatError(
        f"{kind_of(value)} is not a list of rings; accepted: [[[x, y], ...], ...]", where=where
    )


def _ring(value: Any, prefix: str, where: str, symbols: _Symbols = None) -> Ring:
    """Read a list of pairs; `prefix` leads to a vertex of it, `where` names the list itself."""
    if not isinstance(value, list):
        raise FormatError(
            f"{kind_of(value)} is not a list of vertices; accepted: [[x, y], ...]", where=where
        )
    require_some_vertices(value, where)
    return without_closing_vertex(
        [_point(pair, f"{prefix}vertex {index}", symbols) for index, pair in enumerate(value)]
    )


def _point(value: Any, where: str, symbols: _Symbols = None) -> Point:
    if not isinstance(value, list) or len(value) != 2:
        raise FormatError(f"{kind_of(value)} is not a vertex; accepted: [x, y]", where=where)
    x, y = value
    if isinstance(x, str) and isinstance(y, str):
        return read_pair(x, y, where, symbols)
    axis, culprit = ("y", y) if isinstance(x, str) else ("x", x)
    raise NumberError(
        f"{kind_of(culprit)} is not a number; {scalars.ACCEPTED}", where=f"{where}, {axis}"
    )


def _center_of_mass(value: Any, symbols: _Symbols = None) -> Point | None:
    return None if value is None else _point(value, "center_of_mass", symbols)


def _name(value: Any) -> str | None:
    if value is None:
        return None
    if not isinstance(value, str) or isinstance(value, NumberText) or not is_showable(value):
        raise FormatError(
            f"{kind_of(value)} is not a name; accepted: text without control characters",
            where="name",
        )
    return value or None
