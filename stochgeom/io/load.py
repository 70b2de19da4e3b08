"""From a source named on a command line to a part: catalogue name, file, or standard input."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from typing import Final

from stochgeom.arguments import expect
from stochgeom.errors import ReadError, SelfIntersectionError
from stochgeom.geometry.part import Part
from stochgeom.io.files import MAX_BYTES, decode_text, naming
from stochgeom.io.outlines import (
    Outline,
    parse_outline,
    parse_point,
    read_outline,
)
from stochgeom.thesis.parts import catalogue_names, catalogue_part

_STANDARD_INPUT: Final = "standard input"


def load_part(source: str, *, center_of_mass: str | None = None) -> Part:
    """Return the part that a source names.

    Parameters
    ----------
    source : str
        A name of the catalogue or ``regular-N`` for the regular N-gon, else the path of a file,
        else ``"-"`` for standard input. A file of such a name is reached as ``./name``.
    center_of_mass : str, optional
        ``"x,y"``, in place of the source's own.

    Raises
    ------
    ReadError
        If it is no catalogue name and no readable file.
    InputError
        If the content is no acceptable outline; the place is the file, or "standard input", and
        the line, vertex or edges in it.

    Examples
    --------
    >>> load_part("house").name
    'house'
    """
    expect(source, str, "a name of the catalogue, or a file's path as text", "source")
    if source in catalogue_names():
        return _with_center(catalogue_part(source), center_of_mass)
    regular = re.fullmatch("regular-([0-9]{1,18})", source)
    if regular:
        return _with_center(Part.regular(int(regular[1])), center_of_mass)
    if source == "-":
        content = _standard_input()
        with naming(_STANDARD_INPUT):
            outline = parse_outline(decode_text(content))
    else:
        outline = _read_file(source)
    if center_of_mass is not None:  # read here, as it does not stand in the file
        outline = replace(outline, center_of_mass=_center(center_of_mass))
    with naming(_STANDARD_INPUT if source == "-" else source):
        return part_of(outline)


def _with_center(part: Part, center_of_mass: str | None) -> Part:
    if center_of_mass is None:
        return part
    return Part(part.vertices, _center(center_of_mass), part.name)


def part_of(outline: Outline, center_of_mass: str | None = None) -> Part:
    """Return the part with an outline, checking its geometry.

    Raises
    ------
    InvalidPartError
        If it is no simple polygon; edges are named with the place in the source where they begin.
    """
    if center_of_mass is not None:
        outline = replace(outline, center_of_mass=_center(center_of_mass))
    try:
        return Part(outline.vertices, outline.center_of_mass, outline.name, outline.holes)
    except SelfIntersectionError as error:
        if not outline.places:
            raise
        first, second = (outline.places[edge] for edge in error.edges)
        where = f"{error.where} (which begin at {first} and {second})"
        raise SelfIntersectionError(error.message, edges=error.edges, where=where) from None


def _read_file(source: str) -> Outline:
    if not source:
        raise ReadError(f"the name is empty; {_accepted()}")
    try:
        return read_outline(source)
    except ReadError as error:
        if not isinstance(error.__cause__, FileNotFoundError):
            raise
        raise ReadError(
            f"neither a part of the catalogue nor a file; {_accepted()}", where=error.where
        ) from None


def _standard_input() -> bytes:
    if sys.stdin is None:  # closed by whoever started the program
        raise ReadError(f"closed; {_accepted()}", where=_STANDARD_INPUT)
    try:
        content = sys.stdin.buffer.read(MAX_BYTES + 1)
    except OSError as error:
        raise ReadError(
            f"cannot be read: {error.strerror or error}; {_accepted()}", where=_STANDARD_INPUT
        ) from error
    if len(content) > MAX_BYTES:
        raise ReadError(f"larger than accepted: at most {MAX_BYTES} bytes", where=_STANDARD_INPUT)
    return content


def _center(text: str) -> tuple[object, object]:
    expect(text, str, "text such as '1,2'", "center of mass")
    return parse_point(text, where="center of mass")


def _accepted() -> str:
    names = ", ".join(catalogue_names())
    return f"accepted: {names}, regular-N, a file, or - for standard input"
