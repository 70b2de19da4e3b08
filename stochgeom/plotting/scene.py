"""Pictures as lists of shapes, for `stochgeom.plotting.svg` and for matplotlib alike.

A scene has its own units, x to the right and y upwards; line widths are points and do not scale,
text sizes are units and do. Floats throughout: a picture decides nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal, TypeAlias, final

XY: TypeAlias = "tuple[float, float]"
Anchor: TypeAlias = Literal["start", "middle", "end"]

MINUS: Final = "\N{MINUS SIGN}"

GLYPH_WIDTH: Final = 0.62
"""Width of an average character over the text size, a little more than fonts need."""


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Return an upper estimate of the width of text in letters of a size."""
    return GLYPH_WIDTH * (1.08 if bold else 1.0) * size * len(text)


def shortened(text: str, most: int) -> str:
    """Return text cut to at most so many characters, the last one three dots if some are left out.

    Examples
    --------
    >>> shortened("turn", 4), shortened("turn it", 4)
    ('turn', 'tur…')
    """
    return text if len(text) <= most else f"{text[: most - 1]}…"


@final
@dataclass(frozen=True, slots=True)
class Polygon:
    """A closed outline, filled."""

    points: tuple[XY, ...]
    style: str


@final
@dataclass(frozen=True, slots=True)
class Line:
    """An open chain of segments."""

    points: tuple[XY, ...]
    style: str


@final
@dataclass(frozen=True, slots=True)
class Disc:
    """A disc."""

    center: XY
    radius: float
    style: str


@final
@dataclass(frozen=True, slots=True)
class Label:
    """One line of text, centred vertically at its place.

    Attributes
    ----------
    anchor : str
        Which end of the text is at the place.
    size : float
        Of the letters, in units.
    bold : bool
        Whether the letters are heavy.
    """

    at: XY
    text: str
    size: float
    anchor: Anchor = "middle"
    bold: bool = False

    @property
    def width(self) -> float:
        """An upper estimate of the width of the text."""
        return text_width(self.text, self.size, bold=self.bold)


Shape: TypeAlias = Polygon | Line | Disc | Label


@final
@dataclass(slots=True)
class Scene:
    """Shapes, in the order in which they are drawn.

    Examples
    --------
    >>> scene = Scene()
    >>> scene.add(rectangle((0, 0), (3, 2), "part"))
    >>> scene.bounds()
    (0.0, 0.0, 3.0, 2.0)
    """

    shapes: list[Shape] = field(default_factory=list)

    def add(self, *shapes: Shape) -> None:
        """Draw shapes on top of the others."""
        self.shapes.extend(shapes)

    def place(
        self, shapes: Iterable[Shape], x: float = 0.0, y: float = 0.0, scale: float = 1.0
    ) -> None:
        """Draw shapes scaled about the origin and then moved by (x, y)."""
        self.shapes.extend(moved(shape, x, y, scale) for shape in shapes)

    def bounds(self) -> tuple[float, float, float, float]:
        """Return left, bottom, right and top of all that is drawn, text by an upper estimate."""
        xs, ys = zip(*(point for shape in self.shapes for point in _corners(shape)), strict=True)
        return float(min(xs)), float(min(ys)), float(max(xs)), float(max(ys))

    def labels(self) -> list[str]:
        """Return all text, in the order in which it is drawn."""
        return [shape.text for shape in self.shapes if isinstance(shape, Label)]

    def of_style(self, style: str) -> list[Shape]:
        """Return the shapes of a style."""
        return [s for s in self.shapes if not isinstance(s, Label) and s.style == style]


def _corners(shape: Shape) -> Iterator[XY]:
    if isinstance(shape, Polygon | Line):
        yield from shape.points
    elif isinstance(shape, Disc):
        (x, y), r = shape.center, shape.radius
        yield from ((x - r, y - r), (x + r, y + r))
    else:
        yield from box_of(shape)


def box_of(label: Label) -> tuple[XY, XY]:
    """Return the lower left and the upper right corner of the space that a label needs."""
    (x, y), w, h = label.at, label.width, 0.6 * label.size
    left = {"start": x, "middle": x - w / 2, "end": x - w}[label.anchor]
    return (left, y - h), (left + w, y + h)


def moved(shape: Shape, x: float, y: float, scale: float = 1.0) -> Shape:
    """Return a shape scaled about the origin and then moved by (x, y)."""

    def move(point: XY) -> XY:
        return scale * point[0] + x, scale * point[1] + y

    if isinstance(shape, Disc):
        return replace(shape, center=move(shape.center), radius=scale * shape.radius)
    if isinstance(shape, Label):
        return replace(shape, at=move(shape.at), size=scale * shape.size)
    return replace(shape, points=tuple(map(move, shape.points)))


def rectangle(low: XY, high: XY, style: str) -> Polygon:
    """Return the rectangle between two opposite corners."""
    (a, b), (c, d) = low, high
    return Polygon(((a, b), (c, b), (c, d), (a, d)), style)


def arrow(start: XY, end: XY, head: float, style: str = "arrow") -> tuple[Line, Polygon]:
    """Return an arrow; ``head`` is the length of its head.

    Examples
    --------
    >>> line, tip = arrow((0, 0), (2, 0), 0.5)
    >>> tip.points[0], line.points[-1]
    ((2, 0), (1.6, 0.0))
    """
    (x, y), (u, v) = start, end
    length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5 or 1.0
    c, s = (u - x) / length, (v - y) / length
    back = (u - head * c, v - head * s)
    w = 0.35 * head
    tip = Polygon((end, (back[0] - w * s, back[1] + w * c), (back[0] + w * s, back[1] - w * c)),
                  "arrowhead")  # fmt: skip
    return Line((start, (u - 0.8 * head * c, v - 0.8 * head * s)), style), tip


def shown_degrees(text: str) -> str:
    """Return a decimal as degrees, with a minus sign that is as wide as the digits.

    Examples
    --------
    >>> shown_degrees("-33.7")
    '−33.7°'
    """
    return f"{text.replace('-', MINUS)}°"


def points_of(pairs: Sequence[Sequence[float]]) -> tuple[XY, ...]:
    """Return rows of an array as points."""
    return tuple((float(x), float(y)) for x, y in pairs)
