"""All plans with sensors of a problem as an AND/OR tree of hyperstates (thesis Fig. 7.4).

The bars in a box are the probabilities of the states, given the readings so far; a branch is an
action or, in a bundle with an arc across it, a reading of one look at a sensor. Beside a box stands
what a plan gains that ends there. Heavy are the ways of the cheapest plans, all that tie, and the
boxes where one of them ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final

from stochgeom.errors import NodeLimitError
from stochgeom.exact.quotients import number_decimal, quotient
from stochgeom.plotting.graph import TEXT
from stochgeom.plotting.hyperstate_trees import BOX, HALF, add_hyperstate, short_label
from stochgeom.plotting.scene import Label, Line, Scene, text_width
from stochgeom.plotting.tree_scenes import arc_across
from stochgeom.sensing.and_or_tree import AndOrTree, Choice, Move
from stochgeom.sensing.tree_nodes import mass_of, posterior_of
from stochgeom.sensing.tree_text import label_text, move_text

MOST_ENDS: Final = 120
"""Trees with more nodes at the horizon are not drawn."""

_ROW: Final = 44.0
_BUNDLE: Final = 10.0
"""Room between the branches of one move and those of the next, in pixels like everything here."""

_GAP: Final = 64.0


@dataclass
class _Placed:
    """A node, the branch to it, and the middle of the left side of its box."""

    node: Choice
    text: str
    edge: str
    heavy: bool
    depth: int
    y: float
    bundles: list[list[_Placed]]

    def below(self) -> Iterator[_Placed]:
        """Yield this node and all below it."""
        yield self
        for bundle in self.bundles:
            for child in bundle:
                yield from child.below()


def and_or_scene(tree: AndOrTree, digits: int = 4) -> Scene:
    """Return the tree of all plans; probabilities and costs have so many decimals.

    Raises
    ------
    NodeLimitError
        If more than `MOST_ENDS` nodes stand at the horizon.
    """
    ends = sum(1 for node in tree.nodes() if not node.moves)
    if ends > MOST_ENDS:
        raise NodeLimitError(
            f"{ends} nodes at the horizon are more than a picture holds; accepted: up to "
            f"{MOST_ENDS}, such as of fewer moves"
        )
    root = _Placing(tree, digits).place(tree.root, "", tree.expected_cost is not None, 0)
    columns, scene = _columns(root), Scene()
    for placed in root.below():
        _add_branches(scene, placed, columns)
    for placed in root.below():
        _add_node(scene, placed, columns.boxes[placed.depth])
    _add_summary(scene, tree, digits)
    return scene


@dataclass
class _Placing:
    """Where the nodes stand: the leaves in rows, the others in the middle of what follows."""

    tree: AndOrTree
    digits: int
    y: float = 0.0

    def place(self, node: Choice, edge: str, heavy: bool, depth: int) -> _Placed:
        """Place a node and all below it, from the next free row on."""
        text = move_text(node.end, self.tree.words, self.digits)
        placed = _Placed(node, text, edge, heavy, depth, 0.0, [])
        for number, move in enumerate(node.moves):
            if number:
                self.y -= _BUNDLE
            placed.bundles.append(
                [
                    self.place(
                        child,
                        self._edge(node, move, reading, child),
                        heavy and number in node.best,
                        depth + 1,
                    )
                    for reading, child in move.branches
                ]
            )
        if placed.bundles:
            placed.y = (placed.bundles[0][0].y + placed.bundles[-1][-1].y) / 2
        else:
            placed.y = self.y
            self.y -= _ROW
        return placed

    def _edge(self, node: Choice, move: Move, reading: Any, child: Choice) -> str:
        if not move.senses:
            return short_label(label_text(move.label))
        share = number_decimal(quotient(mass_of(child.end), mass_of(node.end)), self.digits)
        several = sum(other.senses for other in node.moves) > 1
        sensor = f"{short_label(label_text(move.label))}: " if several else ""
        return f"{sensor}{short_label(label_text(reading))} ({share})"


@dataclass(frozen=True, slots=True)
class _Columns:
    """For each depth where its boxes begin, and where the branches to them turn level."""

    boxes: list[float]
    bends: list[float]


def _columns(root: _Placed) -> _Columns:
    nodes = list(root.below())
    columns = _Columns([0.0], [0.0])
    for level in range(max(placed.depth for placed in nodes)):
        edges = [placed.edge for placed in nodes if placed.depth == level + 1]
        texts = max(text_width(edge, TEXT, bold=True) for edge in edges)
        columns.bends.append(columns.boxes[-1] + BOX + _GAP)
        columns.boxes.append(columns.bends[-1] + texts + 12)
    return columns


def _add_branches(scene: Scene, placed: _Placed, columns: _Columns) -> None:
    start = (columns.boxes[placed.depth] + BOX, placed.y)
    for bundle in placed.bundles:
        bend, end = columns.bends[placed.depth + 1], columns.boxes[placed.depth + 1]
        for child in bundle:
            way = (start, (bend, child.y), (end, child.y))
            scene.add(Line(way, "best" if child.heavy else "branch"))
            at = (bend + 4, child.y + 0.7 * TEXT)
            scene.add(Label(at, child.edge, TEXT, "start", bold=child.heavy))
        if len(bundle) > 1:
            scene.add(arc_across(start, (bend, bundle[0].y), (bend, bundle[-1].y), 0.4 * _GAP))


def _add_node(scene: Scene, placed: _Placed, x: float) -> None:
    ends = placed.heavy and -1 in placed.node.best
    style = "chosen" if ends else "act"
    add_hyperstate(scene, (x, placed.y), posterior_of(placed.node.end), style)
    if placed.bundles:  # under the box, and not under the branches that leave it
        label = Label((x + BOX, placed.y - HALF - 0.8 * TEXT), placed.text, TEXT, "end", bold=ends)
    else:
        label = Label((x + BOX + 8, placed.y), placed.text, TEXT, "start", bold=ends)
    scene.add(label)


def _add_summary(scene: Scene, tree: AndOrTree, digits: int) -> None:
    """Write the number of plans and the least cost above the tree."""
    text = f"{tree.plans:,} plans" if tree.plans > 1 else "1 plan"
    if tree.expected_cost is not None:
        cost = number_decimal(tree.expected_cost, digits)
        text += f"; least expected cost {cost}"
        if tree.best_plans > 1:
            text += f", of {tree.best_plans:,} plans"
    left, _, _, top = scene.bounds()
    scene.add(Label((left, top + 2 * TEXT), text, TEXT, "start"))
