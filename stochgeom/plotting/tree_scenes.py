"""Plans with sensors as trees (thesis Fig. 7.1).

From left to right: boxes are actions, hexagons sensings, round boxes ends. An arc across the
branches of a sensing says that all of them belong to the plan, the convention of AND/OR trees.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from stochgeom.plotting.graph import TEXT
from stochgeom.plotting.scene import XY, Label, Line, Polygon, Scene, rectangle, text_width
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.tree_nodes import Act, Node, Sense, Wording, children_of
from stochgeom.sensing.tree_text import move_text, reading_text

_ROW: Final = 34.0
_GAP: Final = 34.0
"""Between the text on an edge and the boxes at its ends, in pixels like everything here."""

_HALF: Final = 11.0
"""Half the height of a box."""


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
        return text_width(self.text, TEXT) + 16

    def below(self) -> Iterator[_Placed]:
        """Yield this node and all below it."""
        yield self
        for child in self.children:
            yield from child.below()


def tree_scene(tree: PlanTree, digits: int = 4) -> Scene:
    """Return a plan with sensors as a tree; probabilities have so many decimals.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> from stochgeom.sensing.tree_nodes import Leaf
    >>> leaf = Leaf((mpq(1),), "up", mpq(1))
    >>> tree_scene(PlanTree(Act((mpq(1),), "turn", mpq(1), leaf), ("up",))).labels()
    ['do turn', 'accept up (1.0000)']
    """
    root, _ = _place(tree.root, tree.words, digits, "", 0, 0)
    columns, scene = _columns(root), Scene()
    for placed in root.below():
        _add_edges(scene, placed, columns)
    for placed in root.below():
        x = columns[placed.depth]
        scene.add(_box(placed, x), Label((x + 8, placed.y), placed.text, TEXT, "start"))
    return scene


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
        placed.y, row = -row * _ROW, row + 1
    return placed, row


def _columns(root: _Placed) -> list[float]:
    """Return where the nodes of each depth begin."""
    nodes = list(root.below())
    columns = [0.0]
    for level in range(max(placed.depth for placed in nodes)):
        boxes = max(placed.width for placed in nodes if placed.depth == level)
        texts = max(text_width(placed.edge, TEXT) for placed in nodes if placed.depth == level + 1)
        columns.append(columns[-1] + boxes + _GAP + texts)
    return columns


def _add_edges(scene: Scene, placed: _Placed, columns: list[float]) -> None:
    start = (columns[placed.depth] + placed.width, placed.y)
    bend = start[0] + _GAP / 2
    for child in placed.children:
        end = columns[child.depth]
        scene.add(Line((start, (bend, child.y), (end, child.y)), "branch"))
        if child.edge:
            scene.add(Label((bend + 4, child.y + 0.65 * TEXT), child.edge, TEXT, "start"))
    if isinstance(placed.node, Sense) and len(placed.children) > 1:
        top, bottom = ((bend, child.y) for child in (placed.children[0], placed.children[-1]))
        scene.add(arc_across(start, top, bottom, 0.31 * _GAP))


def arc_across(start: XY, top: XY, bottom: XY, radius: float) -> Line:
    """Return the arc across branches that run from a node to these points and those between.

    Examples
    --------
    >>> arc_across((0, 0), (1, 1), (1, -1), 2**0.5).points[6]
    (1.4142135623730951, 0.0)
    """
    first, last = (math.atan2(y - start[1], x - start[0]) for x, y in (top, bottom))
    steps = [first + (last - first) * k / 12 for k in range(13)]
    points = tuple(
        (start[0] + radius * math.cos(a), start[1] + radius * math.sin(a)) for a in steps
    )
    return Line(points, "both")


def _box(placed: _Placed, x: float) -> Polygon:
    y, right = placed.y, x + placed.width
    if isinstance(placed.node, Act):
        return rectangle((x, y - _HALF), (right, y + _HALF), "act")
    if isinstance(placed.node, Sense):
        a, b = x + 8, right - 8
        corners = ((x, y), (a, y + _HALF), (b, y + _HALF), (right, y), (b, y - _HALF),
                   (a, y - _HALF))  # fmt: skip
        return Polygon(corners, "sense")
    bow = [math.pi * (k / 8 - 0.5) for k in range(9)]
    round_end = [(_HALF * math.cos(a), _HALF * math.sin(a)) for a in bow]
    left = [(x + _HALF - u, y - v) for u, v in round_end]
    return Polygon((*left, *((right - _HALF + u, y + v) for u, v in round_end)), "leaf")
