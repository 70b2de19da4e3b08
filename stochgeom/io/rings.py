"""What the outline readers share: the `Outline` they return, pairs of numbers, closed rings."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias, final

from stochgeom.errors import TooFewVerticesError
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.surds import Scalar, exact_scalar

Point: TypeAlias = tuple[Scalar, Scalar]
Ring: TypeAlias = tuple[Point, ...]

# Control characters, surrogates, line and paragraph separators: they would break the one line in
# which a name or a path is shown.
_UNSHOWABLE: Final = frozenset({"Cc", "Cs", "Zl", "Zp"})
_SHOWN_LENGTH: Final = 60


@final
@dataclass(frozen=True, slots=True)
class Outline:
    """A polygonal outline as it was written: exact numbers, geometry not checked.

    Attributes
    ----------
    vertices : tuple of pairs of exact numbers
        In the order of the source, without a closing repeat of the first vertex.
    holes : tuple of tuples of pairs
        Likewise, one entry per hole.
    center_of_mass : pair of exact numbers, or None
        None where the source gives none.
    name : str or None
        From the source, or the default the caller gave.
    places : tuple of str
        Where each vertex stands in the source, such as ``"line 3"``; empty where the format does
        not tell.
    """

    vertices: Ring
    holes: tuple[Ring, ...] = ()
    center_of_mass: Point | None = None
    name: str | None = None
    places: tuple[str, ...] = ()


def read_pair(
    x: str, y: str, where: str | None, symbols: Mapping[str, Algebraic] | None = None
) -> Point:
    """Return the point of two number texts; an error names `where` and the coordinate.

    The texts may hold square roots, and the letters of `symbols`.

    Examples
    --------
    >>> read_pair("0.1", "-2/3", "vertex 7")
    (mpq(1,10), mpq(-2,3))
    """
    prefix = "" if where is None else f"{where}, "
    return (
        exact_scalar(x, where=prefix + "x", symbols=symbols),
        exact_scalar(y, where=prefix + "y", symbols=symbols),
    )


def without_closing_vertex(points: Sequence[Point]) -> Ring:
    """Return the ring without a last vertex that repeats the first.

    Only one repeat is dropped: further ones are repeated vertices, which a part may have.
    """
    closed = len(points) > 1 and points[0] == points[-1]
    return tuple(points[:-1] if closed else points)


def require_some_vertices(ring: Sequence[object], where: str) -> None:
    """Refuse a ring without any vertex; the geometry layer counts the distinct ones.

    Raises
    ------
    TooFewVerticesError
        If `ring` is empty.
    """
    if not ring:
        raise TooFewVerticesError("no vertices; accepted: at least 3", where=where)


def shown(text: str) -> str:
    """Return `text` quoted on one line, cut to a length that fits a message.

    Examples
    --------
    >>> shown("a" * 100)
    "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa'..."
    """
    return repr(text[:_SHOWN_LENGTH]) + ("..." if len(text) > _SHOWN_LENGTH else "")


def is_showable(text: str) -> bool:
    r"""Whether `text` can stand in one line of output.

    Examples
    --------
    >>> is_showable("Gehäuse 7"), is_showable("two\nlines")
    (True, False)
    """
    return not any(unicodedata.category(character) in _UNSHOWABLE for character in text)


def showable(text: str) -> str:
    r"""Return `text` with every character that cannot stand in one line replaced by ``?``.

    Examples
    --------
    >>> showable("two\nlines")
    'two?lines'
    """
    return "".join(character if is_showable(character) else "?" for character in text)
