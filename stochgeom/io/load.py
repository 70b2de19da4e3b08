"""From a source named on a command line to a part: catalogue name, file, or standard input."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

from stochgeom.errors import ReadError
from stochgeom.geometry.part import Part
from stochgeom.io.outlines import (
    MAX_BYTES,
    Outline,
    decode_outline,
    parse_outline,
    parse_point,
    read_outline,
)
from stochgeom.thesis.parts import catalogue_names, catalogue_part


def load_part(source: str, *, center_of_mass: str | None = None) -> Part:
    """Return the part that a source names.

    Parameters
    ----------
    source : str
        A name of the catalogue, else the path of a file, else ``"-"`` for standard input. A file
        with the name of a catalogue part is reached as ``./name``.
    center_of_mass : str, optional
        ``"x,y"``, in place of the source's own.

    Raises
    ------
    ReadError
        If it is no catalogue name and no readable file.
    InputError
        If the content is no acceptable outline.

    Examples
    --------
    >>> load_part("house").name
    'house'
    """
    if source in catalogue_names():
        part = catalogue_part(source)
        if center_of_mass is None:
            return part
        return Part(part.vertices, _center(center_of_mass), part.name)
    if source == "-":
        content = sys.stdin.buffer.read(MAX_BYTES + 1)
        if len(content) > MAX_BYTES:
            raise ReadError(f"more than {MAX_BYTES} bytes", where="standard input")
        return part_of(parse_outline(decode_outline(content)), center_of_mass)
    if not Path(source).exists():
        raise ReadError(
            f"no file and no catalogue part; accepted: {', '.join(catalogue_names())}, a file, "
            "or - for standard input",
            where=source,
        )
    return part_of(read_outline(source), center_of_mass)


def part_of(outline: Outline, center_of_mass: str | None = None) -> Part:
    """Return the part with an outline, checking its geometry."""
    if center_of_mass is not None:
        outline = replace(outline, center_of_mass=_center(center_of_mass))
    return Part(outline.vertices, outline.center_of_mass, outline.name, outline.holes)


def _center(text: str) -> tuple[object, object]:
    return parse_point(text, where="center of mass")
