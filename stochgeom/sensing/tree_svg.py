"""Plan trees as drawings: SVG, written as text.

From left to right: boxes are actions, diamonds sensings, round boxes ends. An arc across the
branches of a sensing says that all of them belong to the plan, the convention of AND/OR trees.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final
from xml.sax.saxutils import escape

from stochgeom.sensing.tree_nodes import Act, Leaf, Node, Sense, Wording, children_of
from stochgeom.sensing.tree_text import move_text, reading_text

ROW: Final = 34
"""Pixels from one leaf to the next."""

LETTER: Final = 6.8
"""Pixels of one letter, about, at the size of `_STYLE`."""

GAP: Final = 34
"""Pixels between the text on an edge and the boxes at its ends."""

BOX_HEIGHT: Final = 22

_STYLE: Final = (
    "text{font:12px monospace;fill:#222}"
    "path{fill:none;stroke:#777}"
    ".act{fill:#e8f0fa;stroke:#36c}.sense{fill:#fdf3dc;stroke:#b80}.leaf{fill:#eaf6ea;stroke:#383}"
)


@dataclass
class _Placed:
    """A node with its text and the middle of its left side."""

    node: Node
    text: str
    edge: str
    depth: int
    y: float
    children: list[_Placed]

    @property
    def width(self) -> float:
        return LETTER * len(self.text) + 16


def tree_svg(root: Node, words: Wording, digits: int = 4) -> str:
    """Return a drawing of a tree.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> leaf = Leaf((mpq(1),), "up", mpq(1))
    >>> picture = tree_svg(Act((mpq(1),), "turn", mpq(1), leaf), Wording())
    >>> picture[:28], picture.count("<rect")
    ('<svg xmlns="http://www.w3.or', 2)
    """
    top, rows = _place(root, words, digits, "", 0, 0)
    columns = _columns(top)
    width = columns[-1] + 8
    height = rows * ROW + 8
    body = "".join(_edges(top, columns)) + "".join(_boxes(top, columns))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.0f} {height:.0f}"><style>{_STYLE}</style>{body}</svg>'
    )


def _place(
    node: Node, words: Wording, digits: int, edge: str, depth: int, row: int
) -> tuple[_Placed, int]:
    """Place a subtree from a row on; return it and the first row after it."""
    placed = _Placed(node, move_text(node, words, digits), edge, depth, 0.0, [])
    texts = [""] * len(children_of(node))
    if isinstance(node, Sense):
        texts = [reading_text(reading, child, node, digits) for reading, child in node.branches]
    for child, text in zip(children_of(node), texts, strict=True):
        below, row = _place(child, words, digits, text, depth + 1, row)
        placed.children.append(below)
    if placed.children:
        placed.y = (placed.children[0].y + placed.children[-1].y) / 2
    else:
        placed.y, row = row * ROW + ROW / 2 + 4, row + 1
    return placed, row


def _all(placed: _Placed) -> list[_Placed]:
    found = [placed]
    for child in placed.children:
        found += _all(child)
    return found


def _columns(root: _Placed) -> list[float]:
    """Return where the nodes of each depth begin, and where the last ones end."""
    nodes = _all(root)
    depth = max(placed.depth for placed in nodes)
    columns = [8.0]
    for level in range(depth + 1):
        boxes = max(placed.width for placed in nodes if placed.depth == level)
        texts = [LETTER * len(placed.edge) for placed in nodes if placed.depth == level + 1]
        columns.append(columns[-1] + boxes + (GAP + max(texts) if texts else 0))
    return columns


def _edges(placed: _Placed, columns: list[float]) -> list[str]:
    start, end = columns[placed.depth] + placed.width, columns[placed.depth + 1]
    drawn = []
    for child in placed.children:
        bend = start + GAP / 2
        drawn.append(
            f'<path d="M{start:.1f} {placed.y:.1f} L{bend:.1f} {child.y:.1f} '
            f'L{end:.1f} {child.y:.1f}"/>'
        )
        if child.edge:
            drawn.append(
                f'<text x="{bend + 4:.1f}" y="{child.y - 4:.1f}">{escape(child.edge)}</text>'
            )
        drawn += _edges(child, columns)
    if isinstance(placed.node, Sense) and len(placed.children) > 1:
        first, last = placed.children[0], placed.children[-1]
        x = start + GAP / 4
        top, bottom = (placed.y + first.y) / 2, (placed.y + last.y) / 2
        drawn.append(
            f'<path class="and" d="M{x:.1f} {top:.1f} Q{x + 8:.1f} {placed.y:.1f} '
            f'{x:.1f} {bottom:.1f}"/>'
        )
    return drawn


_CLASSES: Final = {Act: "act", Sense: "sense", Leaf: "leaf"}


def _boxes(root: _Placed, columns: list[float]) -> list[str]:
    drawn = []
    for placed in _all(root):
        x, top = columns[placed.depth], placed.y - BOX_HEIGHT / 2
        kind = _CLASSES[type(placed.node)]
        if kind == "sense":
            right, middle, tip = x + placed.width, placed.y, 8
            points = (
                f"{x:.1f},{middle:.1f} {x + tip:.1f},{top:.1f} {right - tip:.1f},{top:.1f} "
                f"{right:.1f},{middle:.1f} {right - tip:.1f},{top + BOX_HEIGHT:.1f} "
                f"{x + tip:.1f},{top + BOX_HEIGHT:.1f}"
            )
            drawn.append(f'<polygon class="sense" points="{points}"/>')
        else:
            corner = BOX_HEIGHT / 2 if kind == "leaf" else 2
            drawn.append(
                f'<rect class="{kind}" x="{x:.1f}" y="{top:.1f}" width="{placed.width:.1f}" '
                f'height="{BOX_HEIGHT}" rx="{corner}"/>'
            )
        drawn.append(f'<text x="{x + 8:.1f}" y="{placed.y + 4:.1f}">{escape(placed.text)}</text>')
    return drawn
