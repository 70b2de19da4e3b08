"""Scenes as SVG text: no other package, no script, no reference to anything outside.

Every shape carries its look as attributes and its style's name as a class, so that the text is a
picture by itself and a page can restyle it. Numbers are rounded to hundredths of a pixel; the same
scene gives the same bytes.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, final
from xml.sax.saxutils import escape, quoteattr

from stochgeom.plotting.scene import XY, Disc, Label, Polygon, Scene, Shape
from stochgeom.plotting.styles import FONT, INK, PAPER, STYLES

_NOT_XML: Final = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def text_of(text: str) -> str:
    r"""Return text as SVG and HTML hold it: escaped, characters that XML has not replaced.

    Examples
    --------
    >>> text_of('a < b & "c"')
    'a &lt; b &amp; &quot;c&quot;'
    """
    return escape(_NOT_XML.sub("\ufffd", text), {'"': "&quot;"})


def number(value: float) -> str:
    """Return a coordinate in hundredths, without what is superfluous.

    Examples
    --------
    >>> number(3.0), number(-0.001), number(2.504)
    ('3', '0', '2.5')
    """
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


@final
@dataclass(frozen=True, slots=True)
class Frame:
    """Where a scene's units lie in pixels: the picture's left and top, and pixels per unit."""

    left: float
    top: float
    scale: float

    @classmethod
    def around(cls, scene: Scene, scale: float, margin: float) -> tuple[Frame, float, float]:
        """Return the frame of a whole scene, and the picture's width and height in pixels."""
        left, bottom, right, top = scene.bounds()
        pad = margin / scale
        size = (right - left + 2 * pad) * scale, (top - bottom + 2 * pad) * scale
        return cls(left - pad, top + pad, scale), *size

    def pixel(self, point: XY) -> XY:
        """Return a point in pixels, y downwards."""
        return (point[0] - self.left) * self.scale, (self.top - point[1]) * self.scale


def svg_document(
    scene: Scene,
    *,
    title: str,
    description: str = "",
    scale: float = 40.0,
    margin: float = 8.0,
    background: bool = True,
) -> str:
    """Return a scene as an SVG document that can also stand inside an HTML page.

    Parameters
    ----------
    scene : Scene
        What is drawn; it decides the size.
    title, description : str
        What readers who do not see the picture are told.
    scale : float
        Pixels per unit.
    margin : float
        Pixels left free around the scene.
    background : bool
        Whether white paper is drawn under it, for pages of any colour.

    Examples
    --------
    >>> from stochgeom.plotting.scene import rectangle
    >>> print(svg_document(Scene([rectangle((0, 0), (1, 1), "hull")]), title="a square"))
    <svg xmlns="http://www.w3.org/2000/svg" ... viewBox="0 0 56 56" role="img">
    <title>a square</title>
    <rect class="sg-paper" width="56" height="56" fill="#ffffff"/>
    <polygon class="sg-hull" ... points="8,48 48,48 48,8 8,8"/>
    </svg>
    """
    frame, width, height = Frame.around(scene, scale, margin)
    w, h = number(width), number(height)
    size = f'width="{w}" height="{h}" viewBox="0 0 {w} {h}"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img">',
        f"<title>{text_of(title)}</title>",
    ]
    if description:
        lines.append(f"<desc>{text_of(description)}</desc>")
    if background:
        lines.append(f'<rect class="sg-paper" width="{w}" height="{h}" fill="{PAPER}"/>')
    lines.extend(svg_elements(scene.shapes, frame))
    lines.append("</svg>")
    return "\n".join(lines)


def svg_elements(shapes: Iterable[Shape], frame: Frame) -> list[str]:
    """Return one SVG element for each shape, in pixels of the frame."""
    return [_element(shape, frame) for shape in shapes]


def _element(shape: Shape, frame: Frame) -> str:
    if isinstance(shape, Label):
        return _text(shape, frame)
    look = _look(shape.style)
    if isinstance(shape, Disc):
        x, y = map(number, frame.pixel(shape.center))
        return f'<circle {look} cx="{x}" cy="{y}" r="{number(shape.radius * frame.scale)}"/>'
    tag = "polygon" if isinstance(shape, Polygon) else "polyline"
    pairs = " ".join(",".join(map(number, frame.pixel(point))) for point in shape.points)
    return f'<{tag} {look} points="{pairs}"/>'


def _look(name: str) -> str:
    style = STYLES[name]
    words = [f'class="sg-{name}"', f'fill="{style.fill or "none"}"']
    if style.stroke is not None:
        words.append(f'stroke="{style.stroke}" stroke-width="{number(style.width)}"')
        words.append('stroke-linejoin="round"')
    if style.dash:
        words.append(f'stroke-dasharray="{" ".join(map(number, style.dash))}"')
    return " ".join(words)


def _text(label: Label, frame: Frame) -> str:
    x, y = frame.pixel(label.at)
    size = label.size * frame.scale
    weight = ' font-weight="bold"' if label.bold else ""
    # A third of the size below the middle is where the letters stand.
    return (
        f'<text class="sg-text" x="{number(x)}" y="{number(y + 0.35 * size)}" '
        f'font-family={quoteattr(FONT)} font-size="{number(size)}"{weight} '
        f'text-anchor="{label.anchor}" fill="{INK}">{text_of(label.text)}</text>'
    )
