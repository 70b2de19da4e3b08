"""Read a polygonal outline from a file or a text, in whichever accepted format it is.

The format is told by the content, not by the file's suffix: JSON begins with a bracket, a brace
or a quotation mark, well-known text with the word of a geometry, and anything else is a vertex
per line. See `json_outline`, `wkt_outline` and `plain_outline` for what each accepts. In all of
them a last vertex that repeats the first is left out.
"""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Final

from stochgeom.arguments import expect
from stochgeom.errors import FormatError
from stochgeom.io.files import MAX_BYTES, decode_text, naming, read_bytes
from stochgeom.io.json_outline import parse_json
from stochgeom.io.plain_outline import looks_plain, parse_plain, parse_point, parse_vertices
from stochgeom.io.rings import Outline, showable, shown
from stochgeom.io.wkt_outline import looks_like_wkt, parse_wkt

__all__ = [
    "MAX_BYTES",
    "Outline",
    "parse_outline",
    "parse_point",
    "parse_vertices",
    "read_outline",
]

ACCEPTED: Final = "accepted: JSON, WKT POLYGON, or a vertex per line such as 3 2 or 3,2"

_BYTE_ORDER_MARK: Final = "\ufeff"


def read_outline(path: str | os.PathLike[str]) -> Outline:
    """Read the outline in a file.

    Parameters
    ----------
    path : str or os.PathLike
        A UTF-8 text file. Its name without suffix names the outline if the content does not.

    Raises
    ------
    ReadError
        If the file is missing, unreadable or larger than `MAX_BYTES`.
    FormatError, NumberError, TooFewVerticesError
        If the content is not an outline, as for `parse_outline`; the place is the file, and the
        line or the vertex in it.

    Examples
    --------
    >>> read_outline("no/such/file.json")
    Traceback (most recent call last):
    ...
    stochgeom.errors.ReadError: no/such/file.json: cannot be read: No such file or directory; \
accepted: a readable text file
    """
    content = read_bytes(path)
    with naming(path):
        return parse_outline(decode_text(content), name=showable(Path(os.fsdecode(path)).stem))


def parse_outline(text: str, *, name: str | None = None) -> Outline:
    """Read an outline from its text: JSON, WKT POLYGON or a vertex per line.

    Parameters
    ----------
    text : str
        With or without byte order mark; lines may end as on any system.
    name : str, optional
        The outline's name if the text gives none.

    Raises
    ------
    FormatError
        If the text is empty, too long, or in no accepted format; the place is a line, a line and
        column, a vertex or a key.
    TooFewVerticesError
        For an outline or a hole without any vertex.
    NumberError
        If a coordinate is not a number.

    Examples
    --------
    >>> square = parse_outline("[[0, 0], [1, 0], [1, 1], [0, 1]]", name="square")
    >>> square.vertices == parse_outline("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))").vertices
    True
    >>> parse_outline("POLYGON ((0 0, 1 nan, 0 1))")
    Traceback (most recent call last):
    ...
    stochgeom.errors.NumberError: vertex 1, y: 'nan' is not a number; accepted: whole numbers, \
fractions and decimals such as 3, 2/7, -0.25, 1e-3
    """
    if len(expect(text, str, "text", "outline")) > MAX_BYTES:
        raise FormatError(f"text of {len(text)} characters; accepted: at most {MAX_BYTES}")
    lines = text.removeprefix(_BYTE_ORDER_MARK).replace("\r\n", "\n").replace("\r", "\n")
    outline = _parse_sniffed(lines)
    return outline if outline.name is not None else replace(outline, name=name)


def _parse_sniffed(text: str) -> Outline:
    body = text.lstrip()
    if not body:
        raise FormatError(f"the text is empty; {ACCEPTED}")
    if body[0] in '[{"':
        return parse_json(text)
    if looks_like_wkt(body):
        return parse_wkt(text)
    first_line = body.partition("\n")[0].rstrip()
    if body[0] in "+-.0123456789" or looks_plain(first_line):
        return parse_plain(text)
    number = text[: len(text) - len(body)].count("\n") + 1
    raise FormatError(f"{shown(first_line)} begins no outline; {ACCEPTED}", where=f"line {number}")
