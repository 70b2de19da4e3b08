"""Outlines as bare numbers: a vertex per line, or all of them on the command line.

A line holds ``x y``, ``x,y``, ``x;y`` or the two separated by a tab. What follows a ``#`` is a
comment; blank lines do not count. On the command line the vertices stand on one line, as
``0,0 3,0 3,2`` or ``0 0; 3 0; 3 2``.
"""

from __future__ import annotations

import re
from typing import Final

from stochgeom.errors import FormatError
from stochgeom.io.rings import Outline, Point, Ring, read_pair, shown, without_closing_vertex

ACCEPTED_LINE: Final = (
    "accepted: two numbers per line, such as 3 2 or 3,2 (with a decimal point, not a comma)"
)
ACCEPTED_VERTICES: Final = "accepted: vertices such as '0,0 3,0 3,2' or '0 0; 3 0; 3 2'"
ACCEPTED_POINT: Final = "accepted: two numbers such as '3,2'"

_SEPARATOR: Final = re.compile(r"\s*[,;]\s*|\s+")
_PAIR: Final = re.compile(r"([^\s,;]+)(?:\s*[,;]\s*|\s+)([^\s,;]+)\Z")
_AROUND_COMMA: Final = re.compile(r"\s*,\s*")


def looks_plain(line: str) -> bool:
    """Whether `line` has two fields, be they numbers or not, or is a comment.

    Examples
    --------
    >>> looks_plain("nan, 3  # corner"), looks_plain("<svg>")
    (True, False)
    """
    body = line.partition("#")[0].strip()
    return not body or _PAIR.match(body) is not None


def parse_plain(text: str) -> Outline:
    r"""Read an outline with one vertex per line.

    Parameters
    ----------
    text : str
        Lines that end in a line feed.

    Raises
    ------
    FormatError
        If a line does not hold two fields, or no line holds any.
    NumberError
        If a field is not a number.

    Examples
    --------
    >>> outline = parse_plain("0 0\n1/3,0\n# the top\n0;0.5\n")
    >>> outline.vertices[1:]
    ((mpq(1,3), mpq(0,1)), (mpq(0,1), mpq(1,2)))
    >>> outline.places
    ('line 1', 'line 2', 'line 4')
    """
    points: list[Point] = []
    places: list[str] = []
    for number, line in enumerate(text.split("\n"), start=1):
        body = line.partition("#")[0].strip()
        if body:
            place = f"line {number}"
            points.append(_pair(body, place, ACCEPTED_LINE))
            places.append(place)
    if not points:
        raise FormatError(f"no vertices, only blank lines and comments; {ACCEPTED_LINE}")
    vertices = without_closing_vertex(points)
    return Outline(vertices, places=tuple(places[: len(vertices)]))


def parse_vertices(text: str, *, where: str | None = None) -> Ring:
    """Read vertices that stand on one line.

    A comma joins x and y, and spaces part the vertices; or a semicolon parts the vertices, and a
    comma or a space parts x and y. A closing repeat of the first vertex is left out.

    Parameters
    ----------
    text : str
        Such as ``"0,0 3,0 3,2 0,2"`` or ``"0 0; 3 0; 3 2"``.
    where : str, optional
        The place named in an error, such as ``"--vertices"``.

    Raises
    ------
    FormatError
        If the text is empty or a vertex does not have two fields.
    NumberError
        If a field is not a number.

    Examples
    --------
    >>> parse_vertices("0,0 -3,0 1/2,0.2")
    ((mpq(0,1), mpq(0,1)), (mpq(-3,1), mpq(0,1)), (mpq(1,2), mpq(1,5)))
    >>> parse_vertices("0 0; -3 0; 1/2 0.2") == parse_vertices("0,0 -3,0 1/2,0.2")
    True
    """
    pieces = _vertex_pieces(text)
    if not pieces:
        raise FormatError(f"no vertices; {ACCEPTED_VERTICES}", where=where)
    prefix = "" if where is None else f"{where}, "
    points = [
        _pair(piece, f"{prefix}vertex {index}", ACCEPTED_VERTICES)
        for index, piece in enumerate(pieces)
    ]
    return without_closing_vertex(points)


def parse_point(text: str, *, where: str | None = None) -> Point:
    """Read one point, ``x,y``.

    Parameters
    ----------
    text : str
        Such as ``"3,2"``; a semicolon or a space may stand for the comma.
    where : str, optional
        The place named in an error, such as ``"--center-of-mass"``.

    Raises
    ------
    FormatError
        If the text does not have two fields.
    NumberError
        If a field is not a number.

    Examples
    --------
    >>> parse_point("-1.5,2/7")
    (mpq(-3,2), mpq(2,7))
    """
    return _pair(text.strip(), where, ACCEPTED_POINT)


def _vertex_pieces(text: str) -> list[str]:
    body = text.strip()
    if ";" not in body:
        return _AROUND_COMMA.sub(",", body).split()
    return [piece.strip() for piece in body.removesuffix(";").split(";")]


def _pair(body: str, where: str | None, accepted: str) -> Point:
    match = _PAIR.match(body)
    if match is None:
        count = len(_SEPARATOR.split(body)) if body else 0
        fields = "1 field" if count == 1 else f"{count} fields"
        raise FormatError(f"{shown(body)} has {fields}; {accepted}", where=where)
    return read_pair(match[1], match[2], where)
