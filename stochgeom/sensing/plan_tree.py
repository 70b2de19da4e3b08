"""Plans with sensors as trees (thesis 7.2.2, 7.2.4).

An inner node of the tree acts and has one child, or senses and has a child for each reading that is
possible; a leaf decides: it accepts a state, names a part, or just ends. All plans together are an
AND/OR tree: OR between the moves, AND between the readings of one sensing.

Costs and gains weighted with the probabilities of the nodes add up, which is the recursion of
7.2.4: the cost of a plan is that of its first move plus the costs of its subplans, each weighted
with the marginal probability of its reading.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, final

from stochgeom.display import Displayed, render
from stochgeom.sensing.tree_nodes import Act, Leaf, Node, Sense, Wording, children_of, mass_of
from stochgeom.sensing.tree_text import tree_dot, tree_text


@final
@dataclass(frozen=True)
class PlanTree(Displayed):
    """A plan with sensors.

    Parameters
    ----------
    root : Node
        The first move.
    states : tuple of labels
        The states that joint hyperstates are about.
    accepts : bool, default True
        Whether the gain of a decision is the probability that it is right; otherwise it is a loss,
        with the sign turned.
    action_form : str, default "do {}"
        How texts name an action.
    decision_form : str, default "{}"
        How texts name a decision, such as ``"{}°"`` for angles.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> half = mpq(1, 2)
    >>> tree = PlanTree(
    ...     Sense((half, half), "eye", mpq(1, 4), (
    ...         ("left", Leaf((half, mpq(0)), "left", half)),
    ...         ("right", Leaf((mpq(0), half), "right", half)),
    ...     )),
    ...     ("left", "right"),
    ... )
    >>> tree.cost, tree.gain, tree.depth
    (mpq(1,4), mpq(1,1), 1)
    >>> print(tree.text())
    read eye
      left (0.5000): accept left (1.0000)
      right (0.5000): accept right (1.0000)
    """

    root: Node
    states: tuple[Any, ...]
    accepts: bool = True
    action_form: str = "do {}"
    decision_form: str = "{}"

    def nodes(self) -> Iterator[Node]:
        """Yield all nodes, each before those below it."""
        pending = [self.root]
        while pending:
            node = pending.pop()
            yield node
            pending.extend(reversed(children_of(node)))

    def leaves(self) -> Iterator[Leaf]:
        """Yield the leaves from left to right."""
        return (node for node in self.nodes() if isinstance(node, Leaf))

    @cached_property
    def cost(self) -> Any:
        """The expected cost of the moves, from the recursion of 7.2.4."""
        return _expected_cost(self.root)

    @cached_property
    def gain(self) -> Any:
        """The expected gain of the decisions: of acceptances, the probability of success."""
        gains = [leaf.gain for leaf in self.leaves()]
        return sum(gains[1:], start=gains[0])

    @cached_property
    def depth(self) -> int:
        """The most moves on a way from the root to a leaf."""
        return _height(self.root, (Act, Sense))

    @cached_property
    def sensings(self) -> int:
        """The most looks at sensors on a way from the root to a leaf."""
        return _height(self.root, (Sense,))

    @cached_property
    def highest_cost(self) -> Any:
        """The largest sum of costs on a way from the root to a leaf."""
        return _highest_cost(self.root)

    @property
    def truncated(self) -> bool:
        """Whether a subplan was cut off because it was good enough."""
        return any(leaf.truncated for leaf in self.leaves())

    @property
    def words(self) -> Wording:
        """How texts and drawings speak of the tree."""
        return Wording(self.accepts, self.action_form, self.decision_form)

    # --- pictures --------------------------------------------------------------------------------

    def text(self, digits: int = 4) -> str:
        """Return the tree as text, a line for each move and reading."""
        return tree_text(self.root, self.words, digits)

    def dot(self, digits: int = 4) -> str:
        """Return the tree in the language of Graphviz; readings of one sensing are joined."""
        return tree_dot(self.root, self.words, digits)

    def svg(self, digits: int = 4) -> str:
        """Return the tree as a drawing, a scalable vector graphic."""
        return str(render(self, "svg", digits))

    def __repr__(self) -> str:
        leaves = sum(1 for _ in self.leaves())
        return f"<PlanTree: {self.depth} moves deep, {leaves} leaves>"


def _expected_cost(node: Node) -> Any:
    """Return the cost of a subplan times the probability of coming to it."""
    if isinstance(node, Leaf):
        return 0 * node.weights[0]
    total = mass_of(node) * node.cost
    for child in children_of(node):
        total = total + _expected_cost(child)
    return total


def _height(node: Node, counted: tuple[type, ...]) -> int:
    below = max((_height(child, counted) for child in children_of(node)), default=0)
    return below + isinstance(node, counted)


def _highest_cost(node: Node) -> Any:
    if isinstance(node, Leaf):
        return 0
    return node.cost + max(_highest_cost(child) for child in children_of(node))
