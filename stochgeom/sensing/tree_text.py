"""Plan trees as text, and in the language of Graphviz."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count, groupby
from typing import Any, Final

from stochgeom.exact.quotients import number_decimal, quotient
from stochgeom.sensing.tree_nodes import Act, Leaf, Node, Sense, Wording, mass_of

_MOST_NAMED: Final = 3
"""Readings that are named one by one where several share a line."""


def label_text(label: Any) -> str:
    """Return a label for people; angles in degrees.

    Examples
    --------
    >>> from stochgeom.exact.angles import QUARTER_TURN
    >>> label_text(QUARTER_TURN), label_text("up"), label_text(("2.00", "3.00"))
    ('90.0000°', 'up', '2.00, 3.00')
    """
    if isinstance(label, tuple):
        return ", ".join(map(label_text, label))
    return str(label)


def move_text(node: Node, words: Wording, digits: int) -> str:
    """Return what is done at a node: ``"read eye"``, ``"do turn"``, ``"accept up (0.9000)"``."""
    if isinstance(node, Act):
        return words.action_form.format(label_text(node.action))
    if isinstance(node, Sense):
        return f"read {label_text(node.sensor)}"
    worth = quotient(node.gain if words.accepts else 0 - node.gain, mass_of(node))
    decision = words.decision_form.format(label_text(node.decision))
    text = f"{decision} ({number_decimal(worth, digits)})"
    return ("accept " if words.accepts else "") + text + (", good enough" * node.truncated)


def reading_text(reading: Any, child: Node, parent: Node, digits: int) -> str:
    """Return a reading with its probability, given that the parent is reached."""
    share = quotient(mass_of(child), mass_of(parent))
    return f"{label_text(reading)} ({number_decimal(share, digits)})"


def tree_text(root: Node, words: Wording, digits: int = 4) -> str:
    """Return a tree as text: a line for each move, and for each reading with its probability.

    Neighbouring readings that end in the same decision share a line, and there their probabilities
    are taken together.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> half, ends = mpq(1, 2), [Leaf((mpq(k, 8),), "up", mpq(1, 8)) for k in (2, 1, 1)]
    >>> print(tree_text(Sense((half,), "eye", 0, tuple(zip("xyz", ends))), Wording(), 2))
    read eye
      x, y, z (1.00): accept up (0.75)
    """
    return "\n".join(_lines(root, words, digits, "", ""))


def _lines(node: Node, words: Wording, digits: int, lead: str, indent: str) -> Iterator[str]:
    yield lead + move_text(node, words, digits)
    if isinstance(node, Act):
        yield from _lines(node.child, words, digits, indent, indent)
    elif isinstance(node, Sense):
        for reading, child in _with_like_ends_joined(node):
            text = f"{indent}  {reading_text(reading, child, node, digits)}"
            if isinstance(child, Leaf):
                yield f"{text}: {move_text(child, words, digits)}"
            else:
                yield text
                yield from _lines(child, words, digits, f"{indent}    ", f"{indent}    ")


def _with_like_ends_joined(node: Sense) -> Iterator[tuple[Any, Node]]:
    """Yield the branches, neighbouring ones that end in the same decision as one."""
    for decision, grouped in groupby(node.branches, key=_end_of):
        branches = list(grouped)
        if decision is None or len(branches) == 1:
            yield from branches
            continue
        leaves = [leaf for _, leaf in branches if isinstance(leaf, Leaf)]
        weights, gain = leaves[0].weights, leaves[0].gain
        for leaf in leaves[1:]:
            weights = tuple(a + b for a, b in zip(weights, leaf.weights, strict=True))
            gain = gain + leaf.gain
        yield (
            _joined([label_text(reading) for reading, _ in branches]),
            replace(leaves[0], weights=weights, gain=gain),
        )


def _end_of(branch: tuple[Any, Node]) -> tuple[Any, bool] | None:
    _, node = branch
    return (node.decision, node.truncated) if isinstance(node, Leaf) else None


def _joined(readings: list[str]) -> str:
    if len(readings) <= _MOST_NAMED:
        return ", ".join(readings)
    return f"{readings[0]}, ..., {readings[-1]} [{len(readings)} readings]"


def tree_dot(root: Node, words: Wording, digits: int = 4) -> str:
    """Return a tree in the language of Graphviz.

    Sensings are diamonds, actions boxes, leaves ellipses; the edges of a sensing carry the readings
    with their probabilities.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> leaf = Leaf((mpq(1),), "up", mpq(1))
    >>> print(tree_dot(Act((mpq(1),), "turn", mpq(1), leaf), Wording()))
    digraph plan {
      rankdir=LR;
      n0 [shape=box, label="do turn"];
      n1 [shape=ellipse, label="accept up (1.0000)"];
      n0 -> n1;
    }
    """
    lines: list[str] = []
    _dot(root, words, digits, lines, count())
    return "\n".join(["digraph plan {", "  rankdir=LR;", *lines, "}"])


_SHAPES: Final = {Act: "box", Sense: "diamond", Leaf: "ellipse"}


def _dot(node: Node, words: Wording, digits: int, lines: list[str], numbers: Iterator[int]) -> str:
    """Write a subtree; return the name of its first node."""
    # A subplan may be one object in several places; each place is a node of its own.
    name = f"n{next(numbers)}"
    text = _quoted(move_text(node, words, digits))
    lines.append(f"  {name} [shape={_SHAPES[type(node)]}, label={text}];")
    if isinstance(node, Act):
        lines.append(f"  {name} -> {_dot(node.child, words, digits, lines, numbers)};")
    elif isinstance(node, Sense):
        for reading, child in node.branches:
            label = _quoted(reading_text(reading, child, node, digits))
            below = _dot(child, words, digits, lines, numbers)
            lines.append(f"  {name} -> {below} [label={label}];")
    return name


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'
