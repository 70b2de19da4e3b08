"""The nodes of plans with sensors: an action, a look at a sensor, an end.

A node holds its *joint hyperstate*: for each state the probability that the readings so far were
made and the state is that one now. Its sum is the probability of coming there, and divided by that
sum it is the hyperstate.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Any, TypeAlias, final

from stochgeom.exact.quotients import quotient


@final
@dataclass(frozen=True, slots=True)
class Leaf:
    """The end of a subplan.

    Attributes
    ----------
    weights : tuple of numbers
        The joint hyperstate.
    decision : label
        What is decided, such as the state that is accepted.
    gain : number
        What the decision gains, times the probability of coming here; for the acceptance of a
        state the probability that it is the right one.
    truncated : bool
        Whether the subplan was cut off because its gain was good enough.
    """

    weights: tuple[Any, ...]
    decision: Hashable
    gain: Any
    truncated: bool = False


@final
@dataclass(frozen=True, slots=True)
class Act:
    """An action and what follows it.

    Attributes
    ----------
    weights : tuple of numbers
        The joint hyperstate before the action.
    action : label
        The action.
    cost : number
        Its cost.
    child : Node
        The plan from then on.
    """

    weights: tuple[Any, ...]
    action: Hashable
    cost: Any
    child: Node


@final
@dataclass(frozen=True, slots=True)
class Sense:
    """A look at a sensor, and what follows each reading.

    Attributes
    ----------
    weights : tuple of numbers
        The joint hyperstate before.
    sensor : label
        Which sensor.
    cost : number
        Its cost.
    branches : tuple of (label, Node)
        The readings of positive probability and the plans that follow them.
    """

    weights: tuple[Any, ...]
    sensor: Hashable
    cost: Any
    branches: tuple[tuple[Hashable, Node], ...]


Node: TypeAlias = "Leaf | Act | Sense"


def mass_of(node: Node) -> Any:
    """Return the probability of coming to a node.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> mass_of(Leaf((mpq(1, 4), mpq(1, 4)), "a", mpq(1, 4)))
    mpq(1,2)
    """
    return sum(node.weights[1:], start=node.weights[0])


def children_of(node: Node) -> tuple[Node, ...]:
    """Return the nodes right below a node."""
    if isinstance(node, Act):
        return (node.child,)
    return tuple(child for _, child in node.branches) if isinstance(node, Sense) else ()


def posterior_of(node: Node) -> tuple[Any, ...]:
    """Return the hyperstate of a node: its joint hyperstate over the probability of coming there.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> posterior_of(Leaf((mpq(1, 4), mpq(1, 12)), "a", mpq(1, 4)))
    (mpq(3,4), mpq(1,4))
    """
    total = mass_of(node)
    return tuple(quotient(weight, total) for weight in node.weights)


@final
@dataclass(frozen=True, slots=True)
class Wording:
    """How texts and drawings speak of a tree.

    Attributes
    ----------
    accepts : bool
        Whether the gain of a decision is the probability that it is right; otherwise it is a loss,
        with the sign turned.
    action_form : str
        How an action is named, such as ``"do {}"``.
    decision_form : str
        How a decision is named, such as ``"{}°"`` where states are labelled by their degrees.
    """

    accepts: bool = True
    action_form: str = "do {}"
    decision_form: str = "{}"
