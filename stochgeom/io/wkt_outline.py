"""Outlines as well-known text: ``POLYGON ((0 0, 3 0, 3 2, 0 0), (hole ...))``.

Letters of either case, an ``SRID=...;`` before the word, and rings that are not closed are
accepted. Coordinates are pairs: Z and M are refused, for a part is flat.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from typing import Final, NamedTuple

from stochgeom.errors import FormatError, TooFewVerticesError
from stochgeom.io.rings import Outline, Point, read_pair, shown, without_closing_vertex

ACCEPTED: Final = "accepted: one POLYGON ((0 0, 3 0, 3 2, 0 0)), holes as further rings"

_OTHER_TYPES: Final = frozenset(
    {
        "CIRCULARSTRING",
        "COMPOUNDCURVE",
        "CURVE",
        "CURVEPOLYGON",
        "GEOMETRY",
        "GEOMETRYCOLLECTION",
        "LINEARRING",
        "LINESTRING",
        "MULTICURVE",
        "MULTILINESTRING",
        "MULTIPOINT",
        "MULTIPOLYGON",
        "MULTISURFACE",
        "POINT",
        "POLYHEDRALSURFACE",
        "SURFACE",
        "TIN",
        "TRIANGLE",
    }
)
_WORD: Final = re.compile(r"\s*([A-Za-z]+)")
_WORD_AND_BRACKET: Final = re.compile(r"\s*[A-Za-z]{2,}\s*(?:ZM?|M)?\s*\(", re.IGNORECASE)
_SRID: Final = re.compile(r"\s*SRID\s*=\s*[0-9]+\s*;", re.IGNORECASE)
_DIMENSION: Final = re.compile(r"(?:Z|M|ZM)\Z")
_BLANK: Final = re.compile(r"\s*")
_BRACKET: Final = re.compile(r"[()]")


class _Ring(NamedTuple):
    """A ring's text and where it begins in the source."""

    body: str
    start: int


class _Source:
    """The text, and the place of each of its positions."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._line_starts = [0, *(match.end() for match in re.finditer("\n", text))]

    def place(self, position: int) -> str:
        line = bisect_right(self._line_starts, position)
        return f"line {line}, column {position - self._line_starts[line - 1] + 1}"

    def error(self, fact: str, position: int) -> FormatError:
        return FormatError(f"{fact}; {ACCEPTED}", where=self.place(position))

    def skip_blanks(self, position: int) -> int:
        match = _BLANK.match(self.text, position)
        return match.end() if match else position

    def expect(self, mark: str, position: int) -> int:
        """Return the position after `mark`, which must be the next thing in the text."""
        position = self.skip_blanks(position)
        if self.text.startswith(mark, position):
            return position + 1
        raise self.error(f"{self.found(position)} where '{mark}' was expected", position)

    def found(self, position: int) -> str:
        rest = self.text[position : position + 20].split()
        return shown(rest[0]) if rest else "the end of the text"


def looks_like_wkt(text: str) -> bool:
    """Whether `text` begins as well-known text does, be its geometry accepted or not.

    Examples
    --------
    >>> looks_like_wkt("multipolygon (((0 0, ..."), looks_like_wkt("nan 3")
    (True, False)
    """
    match = _WORD.match(text)
    if match is None:
        return False
    word = _plain_word(match[1])
    if word in _OTHER_TYPES or word in {"POLYGON", "SRID"}:
        return True
    return _WORD_AND_BRACKET.match(text) is not None  # such as POLYGO ((


def parse_wkt(text: str) -> Outline:
    """Read an outline from a ``POLYGON``.

    Raises
    ------
    FormatError
        For another geometry, for Z or M, and for brackets and commas out of place.
    TooFewVerticesError
        For ``POLYGON EMPTY``.
    NumberError
        If a coordinate is not a number.

    Examples
    --------
    >>> outline = parse_wkt("POLYGON ((0 0, 0.1 0, 0 2, 0 0))")
    >>> outline.vertices
    ((mpq(0,1), mpq(0,1)), (mpq(1,10), mpq(0,1)), (mpq(0,1), mpq(2,1)))
    >>> outline.places[1]
    'line 1, column 16'
    """
    source = _Source(text)
    outer, *inner = _split_rings(source, _skip_header(source))
    points, places = _parse_ring(source, outer, "")
    vertices = without_closing_vertex(points)
    holes = tuple(
        without_closing_vertex(_parse_ring(source, ring, f"hole {index}, ")[0])
        for index, ring in enumerate(inner)
    )
    return Outline(vertices, holes, places=tuple(places[: len(vertices)]))


def _plain_word(word: str) -> str:
    """Return the geometry word in capitals, without a Z or M written on to it."""
    capitals = word.upper()
    bare = _DIMENSION.sub("", capitals)
    return bare if bare == "POLYGON" or bare in _OTHER_TYPES else capitals


def _skip_header(source: _Source) -> int:
    """Return the position after ``POLYGON``; refuse other words, dimensions and ``EMPTY``."""
    prefix = _SRID.match(source.text)
    start = source.skip_blanks(prefix.end() if prefix else 0)
    match = _WORD.match(source.text, start)
    word = match[1].upper() if match else ""
    if match is None or _plain_word(word) != "POLYGON":
        fact = f"{shown(word) if word else source.found(start)} is not read"
        raise source.error(fact, start)
    following = _WORD.match(source.text, match.end())
    suffix = word.removeprefix("POLYGON") or (following[1].upper() if following else "")
    if suffix == "EMPTY":
        raise TooFewVerticesError(
            "POLYGON EMPTY has no vertices; accepted: at least 3", where=source.place(start)
        )
    if _DIMENSION.match(suffix):
        raise source.error(f"POLYGON {suffix} has more than x and y", start)
    return match.end()


def _split_rings(source: _Source, position: int) -> list[_Ring]:
    """Return the rings between the outer brackets, which must end the text."""
    position = source.expect("(", position)
    rings: list[_Ring] = []
    while True:
        start = source.expect("(", position)
        bracket = _BRACKET.search(source.text, start)
        end = bracket.start() if bracket else len(source.text)
        if bracket is None or bracket[0] != ")":
            raise source.error(
                f"{source.found(end)} inside the ring opened at {source.place(start - 1)}", end
            )
        rings.append(_Ring(source.text[start:end], start))
        position = source.skip_blanks(end + 1)
        if not source.text.startswith(",", position):
            break
        position += 1
    position = source.skip_blanks(source.expect(")", position))
    if position < len(source.text):
        raise source.error(f"{source.found(position)} after the polygon", position)
    return rings


def _parse_ring(source: _Source, ring: _Ring, prefix: str) -> tuple[list[Point], list[str]]:
    points: list[Point] = []
    places: list[str] = []
    position = ring.start
    for index, piece in enumerate(ring.body.split(",")):
        fields = piece.split()
        where = f"{prefix}vertex {index}"
        if len(fields) != 2:
            numbers = "1 number" if len(fields) == 1 else f"{len(fields)} numbers"
            raise FormatError(
                f"{shown(piece.strip())} has {numbers}; accepted: x and y", where=where
            )
        points.append(read_pair(fields[0], fields[1], where))
        places.append(source.place(source.skip_blanks(position)))
        position += len(piece) + 1
    return points, places
