"""Polygonal parts with exact rational outlines."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from typing import Any, TypeAlias, final

import gmpy2
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.display import Displayed
from stochgeom.errors import InputError, InvalidHoleError, InvalidPartError, NotRationalError
from stochgeom.exact.algebraic import is_algebraic, simplified
from stochgeom.exact.fields import RealField
from stochgeom.exact.surds import Scalar, ScalarLike, common_field, exact_scalar
from stochgeom.geometry.hull import ConvexHull, convex_hull, convex_outline, locate
from stochgeom.geometry.outline import Mass, check_outline, mass_of, without_repeats
from stochgeom.geometry.points import Point, PointLike, Points, as_point
from stochgeom.geometry.regular import regular_polygon


@final
class Part(Displayed):
    """A rigid planar part: a simple polygon, a centre of mass, a name.

    Parameters
    ----------
    vertices : sequence of (x, y), or an (n, 2) integer array
        The outline, in either orientation. Collinear vertices and repeated consecutive vertices
        are tolerated and kept as given. Numbers are exact: int, Fraction, Decimal, mpq or text;
        text may have square roots of one field, such as "1/2*sqrt(3)".
    center_of_mass : (x, y), optional
        Default: the centroid of the outline, less its holes, under uniform density.
    name : str, optional
        Shown in tables and files.
    holes : sequence of vertex lists, optional
        Only shift the uniform centroid: jaws touch the convex hull.

    Raises
    ------
    TooFewVerticesError, CollinearOutlineError, SelfIntersectionError, InvalidHoleError
        If the outline is no simple polygon; the message names vertices or edges.
    NumberError
        If a coordinate is not an exact number; the message names the vertex.

    Notes
    -----
    Construction costs O(n) for convex outlines (arrays of int64 are never turned into Python
    objects) and O(n log n) for others.

    Examples
    --------
    >>> part = Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="rectangle")
    >>> part.area, part.center_of_mass
    (mpq(6,1), (mpq(3,2), mpq(1,1)))
    """

    def __init__(
        self,
        vertices: Iterable[PointLike] | NDArray[Any],
        center_of_mass: PointLike | None = None,
        name: str | None = None,
        holes: Iterable[Iterable[PointLike]] = (),
    ) -> None:
        self._points = Points.from_pairs(vertices)
        self._holes = tuple(
            Points.from_pairs(ring, f"hole {k}, vertex") for k, ring in enumerate(_listed(holes))
        )
        self._given_center = (
            None if center_of_mass is None else as_point(center_of_mass, "center of mass")
        )
        self.name = name
        _ = self.field  # refuses mixed ones
        # A convex outline is recognised in O(n) and needs no search for crossings.
        kept = without_repeats(self._points)
        convex = convex_outline(self._points.take(kept)) if len(kept) > 2 else None
        if convex is None or self._holes:
            check_outline(self._points, self._holes)
        self._convex = None if convex is None else ConvexHull(convex.points, kept[convex.indices])

    @classmethod
    def regular(cls, n: int, name: str | None = None) -> Part:
        """Return the regular n-gon, its vertices (cos(2 pi k / n), sin(2 pi k / n)), exactly.

        Parameters
        ----------
        n : int
            3 to `stochgeom.exact.fields.MAX_ORDER`.
        name : str, optional
            Default: ``"regular 5-gon"``.

        Raises
        ------
        TooFewVerticesError
            If n is below 3.
        NumberLimitError
            If n is above the limit.

        Examples
        --------
        >>> hexagon = Part.regular(6)
        >>> [str(value) for value in hexagon.vertices[1]], str(hexagon.area)
        (['1/2', '1/2*sqrt(3)'], '3/2*sqrt(3)')
        """
        vertices = regular_polygon(n)
        return cls(vertices, name=f"regular {n}-gon" if name is None else name)

    @cached_property
    def field(self) -> RealField | None:
        """The field of the irrational coordinates, None if all are rational.

        Raises
        ------
        MixedFieldsError
            If rings, or the centre of mass, are of different fields.
        """
        rings = [("vertices", self._points)]
        rings += [(f"hole {k}", ring) for k, ring in enumerate(self._holes)]
        named = [(name, ring.x[0]) for name, ring in rings if ring.over_field]
        if self._given_center is not None:
            named += [("center of mass", value) for value in self._given_center]
        return common_field([value for _, value in named], lambda k: named[k][0])

    # --- the outline -----------------------------------------------------------------------------

    @property
    def points(self) -> Points:
        """The vertices as arrays."""
        return self._points

    @cached_property
    def vertices(self) -> tuple[Point, ...]:
        """The vertices as given, as pairs of `mpq`."""
        return self._points.pairs()

    @cached_property
    def holes(self) -> tuple[tuple[Point, ...], ...]:
        """The holes as given."""
        return tuple(ring.pairs() for ring in self._holes)

    def __len__(self) -> int:
        """Return the number of vertices as given."""
        return len(self._points)

    @cached_property
    def hull(self) -> ConvexHull:
        """The strictly convex hull, counter-clockwise."""
        return self._convex or convex_hull(self._points)

    # --- mass ------------------------------------------------------------------------------------

    @cached_property
    def _mass(self) -> Mass:
        return mass_of(self._points, self._holes)

    @property
    def area(self) -> Scalar:
        """Area of the outline less its holes, positive."""
        return self._mass.area

    @property
    def centroid(self) -> Point:
        """Centre of mass under uniform density."""
        return self._mass.centroid

    @property
    def center_of_mass(self) -> Point:
        """The centre of mass given, else the centroid."""
        return self._given_center or self.centroid

    @property
    def has_given_center(self) -> bool:
        """Whether the centre of mass was given rather than computed."""
        return self._given_center is not None

    @cached_property
    def center_of_mass_side(self) -> int:
        """Where the centre of mass lies: 1 strictly inside the hull, 0 on it, -1 outside.

        Squeezing does not depend on it; pushing needs it inside.
        """
        return locate(self.hull, self.center_of_mass)

    # --- similarity maps -------------------------------------------------------------------------

    def translate(self, dx: ScalarLike, dy: ScalarLike) -> Part:
        """Return the part moved by (dx, dy)."""
        a, b = exact_scalar(dx, where="dx"), exact_scalar(dy, where="dy")
        return self._mapped(lambda x, y: (x + a, y + b))

    def scale(self, factor: ScalarLike) -> Part:
        """Return the part scaled about the origin by a positive factor."""
        k = exact_scalar(factor, where="scale factor")
        if k <= 0:
            raise InputError(f"scale factor {k}; accepted: positive numbers")
        return self._mapped(lambda x, y: (k * x, k * y))

    def rotate(self, direction: tuple[ScalarLike, ScalarLike]) -> Part:
        """Return the part turned counter-clockwise about the origin by arg(direction).

        The length of the direction must be rational, such as (3, 4): otherwise the turned
        coordinates are not. `multiply` turns by any direction, scaling as well.

        Examples
        --------
        >>> Part([(0, 0), (5, 0), (0, 5)]).rotate((3, 4)).vertices[1]
        (mpq(3,1), mpq(4,1))
        """
        c, s = as_point(direction, "direction")
        squared = simplified(c * c + s * s)
        if (
            is_algebraic(squared)
            or not squared
            or not gmpy2.is_square(squared.numerator * squared.denominator)
        ):
            raise NotRationalError(
                f"direction ({c}, {s}) has the length sqrt({squared}); accepted: directions of "
                "rational length such as (3, 4), or Part.multiply, which also scales"
            )
        length = mpq(gmpy2.isqrt(squared.numerator), gmpy2.isqrt(squared.denominator))
        return self.multiply((c * (1 / length), s * (1 / length)))

    def multiply(self, number: tuple[ScalarLike, ScalarLike]) -> Part:
        """Return the part multiplied by the complex number c + i s: turned and scaled.

        Examples
        --------
        >>> Part([(0, 0), (1, 0), (0, 1)]).multiply((1, 1)).vertices[1]
        (mpq(1,1), mpq(1,1))
        """
        c, s = as_point(number, "complex number")
        if not c and not s:
            raise InputError("the complex number (0, 0) maps the part to a point")
        return self._mapped(lambda x, y: (c * x - s * y, s * x + c * y))

    def reflect(self) -> Part:
        """Return the mirror image in the x axis."""
        return self._mapped(lambda x, y: (x, -y))

    def _mapped(self, move: Callable[[Any, Any], Point]) -> Part:
        def ring(points: Sequence[Point]) -> list[Point]:
            return [move(x, y) for x, y in points]

        center = None if self._given_center is None else move(*self._given_center)
        holes: list[Iterable[PointLike]] = [ring(hole) for hole in self.holes]
        return Part(ring(self.vertices), center, self.name, holes)

    # --- value semantics -------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Part):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[object, ...]:
        return self.vertices, self.holes, self.center_of_mass, self.name

    def __repr__(self) -> str:
        if len(self) > 1000:
            return f"<Part {self.name or 'without name'} of {len(self)} vertices>"
        words = [_points_text(self.vertices)]
        if self._given_center is not None:
            words.append(f"center_of_mass={_points_text([self._given_center])[1:-1]}")
        if self.name is not None:
            words.append(f"name={self.name!r}")
        if self._holes:
            words.append(f"holes=[{', '.join(_points_text(hole) for hole in self.holes)}]")
        return f"Part({', '.join(words)})"


def _listed(holes: Iterable[Iterable[PointLike]]) -> list[Iterable[PointLike]]:
    try:
        return list(holes)
    except TypeError:
        raise InvalidHoleError(
            f"{holes!r:.60} is not a list of holes; accepted: lists of vertices", where="holes"
        ) from None


def _points_text(points: Iterable[Point]) -> str:
    """Return a literal that reads back exactly: whole numbers as such, fractions as text."""

    def literal(value: Scalar) -> str:
        if is_algebraic(value):
            return repr(str(value)) if "sqrt" in str(value) else repr(value)
        text = str(value)
        return text if value.denominator == 1 and len(text) <= 4000 else repr(text)

    return f"[{', '.join(f'({literal(x)}, {literal(y)})' for x, y in points)}]"


PartLike: TypeAlias = Part | Iterable[PointLike] | NDArray[Any]
"""A part, or its vertices."""


def as_part(part: PartLike) -> Part:
    """Return a part as it is, or make one of its vertices."""
    if isinstance(part, str):
        raise InvalidPartError(
            f"{part!r:.60} is text; accepted: a Part or vertices (load_part takes names and files)"
        )
    return part if isinstance(part, Part) else Part(part)
