"""How the shapes of a picture look, by name; the same on screen and in print.

What has to be told apart differs in lightness or in dashes, not in hue alone: all of it survives
grey print. In SVG every style is also a class, ``sg-`` and its name, that a page may restyle.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

INK: Final = "#1a1a1a"
PAPER: Final = "#ffffff"
FONT: Final = "DejaVu Sans, Verdana, Arial, sans-serif"


@final
@dataclass(frozen=True, slots=True)
class Style:
    """Fill, line colour, line width and dashes; widths are in points, None is nothing drawn."""

    fill: str | None = None
    stroke: str | None = None
    width: float = 1.0
    dash: tuple[float, ...] = ()


STYLES: Final[dict[str, Style]] = {
    # parts
    "part": Style("#d5dce6", INK, 1.3),
    "hole": Style(PAPER, INK, 1.0),
    "hull": Style(None, "#6b6b6b", 0.9, (4, 3)),
    "ghost": Style(None, "#8a8a8a", 0.9, (3, 2.5)),
    "faint": Style("#f1f3f6", "#9a9a9a", 0.8),
    "heading": Style(None, INK, 0.9),
    "vertex": Style(INK, INK, 0.6),
    "mass": Style(PAPER, INK, 1.0),
    "contact": Style("#d1495b", INK, 0.8),
    # grippers
    "jaw": Style("#8c8c8c", INK, 0.8),
    "pushing": Style(INK, INK, 0.8),
    "open": Style(PAPER, "#7a7a7a", 0.9),
    "palm": Style("#bdbdbd", INK, 0.8),
    "slide": Style("#5b7da8", INK, 0.8),
    "roller": Style(PAPER, INK, 0.8),
    "arrow": Style(None, INK, 1.1),
    "arrowhead": Style(INK, INK, 0.5),
    # graphs
    "curve": Style(None, "#23527c", 1.6),
    "step": Style(None, "#23527c", 2.0),
    "jump": Style(None, "#8fa6bf", 0.8, (2, 2)),
    "closed": Style("#23527c", "#23527c", 1.0),
    "hollow": Style(PAPER, "#23527c", 1.2),
    "diagonal": Style(None, "#a9a9a9", 0.8, (5, 3)),
    "drop": Style(None, "#b5b5b5", 0.7, (2, 2)),
    "frame": Style(None, "#4d4d4d", 0.8),
    "grid": Style(None, "#e3e3e3", 0.6),
    "bar": Style("#7d9cc0", INK, 0.8),
    "image": Style(INK, INK, 0.8),
    "funnel": Style("#dbe4ef", INK, 1.1),
    "density": Style("#e4e4e4", "#4d4d4d", 1.2),
    "caught": Style("#7d9cc0", "#23527c", 1.2),
    "leader": Style(None, "#6b6b6b", 0.6),
    "rule": Style(None, "#c4c4c4", 0.7),
    # trees
    "branch": Style(None, "#777777", 0.9),
    "best": Style(None, INK, 2.2),
    "both": Style(None, INK, 1.1),
    "act": Style("#eef3f9", INK, 0.9),
    "chosen": Style("#eef3f9", INK, 2.6),
    "sense": Style("#d9d2bd", INK, 0.9),
    "leaf": Style(PAPER, INK, 0.9),
    "probable": Style("#23527c", None),
    # trays
    "tray": Style(None, INK, 2.2),
    "tile": Style(None, INK, 1.1),
    "likely": Style("#7d9cc0", INK, 1.3),
    "unlikely": Style(None, "#8a8a8a", 0.9, (3, 2.5)),
}
