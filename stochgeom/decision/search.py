"""Breadth-first search over hyperstates (thesis 2.4, 4.8).

An open-loop plan is a sequence of actions; each action makes one hyperstate of another. All plans
form a tree: the root is the hyperstate before the first action searched for, a node at depth i is
what a plan of i actions makes of it. The search goes through the tree level by level and keeps
the best hyperstates of each level.

What a hyperstate is, what an action does to it and what it is worth is the caller's: a tuple of
exact probabilities multiplied by matrices, a set of possible states, a map. Hyperstates are
compared by ``==`` and hashed, so they have to be canonical; worths are compared by ``<``, so they
have to be exact (`functools.cmp_to_key` makes a worth of a comparison).

A hyperstate that was reached before, with as many actions or fewer, is *generated* again but not
expanded again: nothing can follow from it that does not follow with fewer actions. So a level
tells the best worth of *at most* so many actions. Where more actions never make a hyperstate
worse, as with deterministic actions and the probability of the most likely state, that is the
best worth of exactly so many.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Generic, Protocol, TypeVar, final

from stochgeom.errors import InputError


class Ordered(Protocol):
    """Anything with an exact total order."""

    def __lt__(self, other: Any, /) -> bool:
        """Tell whether this is worth less than the other."""


Node = TypeVar("Node", bound=Hashable)
Action = TypeVar("Action")
Worth = TypeVar("Worth", bound=Ordered)


@final
@dataclass(frozen=True, slots=True)
class Level(Generic[Node, Worth]):
    """What the plans of at most `length` actions achieve.

    Attributes
    ----------
    length : int
        The number of actions, from 0.
    worth : Worth
        The best worth found; if not `complete`, there may be a better one.
    best : tuple of Node
        The hyperstates of that worth, those of fewer actions first; the first one only, unless
        ties are kept.
    generated : int
        Nodes made so far: the root, and one for each action applied to a hyperstate, duplicates
        included.
    distinct : int
        Different hyperstates among them.
    complete : bool
        Whether no plan of this length does better, and with ties kept whether all as good are
        there: False if the node limit came first.
    """

    length: int
    worth: Worth
    best: tuple[Node, ...]
    generated: int
    distinct: int
    complete: bool


@final
class SearchResult(Generic[Node, Worth]):
    """The levels of a search, from no action on.

    Attributes
    ----------
    levels : tuple of Level
        One for each number of actions; only the last one can be incomplete.
    conclusive : bool
        Whether longer plans do no better: every hyperstate that any plan reaches was found, or
        one of the highest worth.
    """

    def __init__(
        self,
        levels: Sequence[Level[Node, Worth]],
        routes: dict[Node, list[tuple[Node, int]]],
        *,
        conclusive: bool,
    ) -> None:
        self.levels = tuple(levels)
        self.conclusive = conclusive
        self._routes = routes

    @property
    def last(self) -> Level[Node, Worth]:
        """The last level."""
        return self.levels[-1]

    def level(self, length: int) -> Level[Node, Worth]:
        """Return the level of at most `length` actions.

        After a conclusive search, the last level for every greater length.

        Raises
        ------
        InputError
            If the search did not go that far.
        """
        if 0 <= length < len(self.levels):
            return self.levels[length]
        if length > 0 and self.conclusive:
            return self.last
        raise InputError(f"{length} actions; accepted: 0 to {len(self.levels) - 1}")

    def sequences(self, length: int) -> Iterator[tuple[int, ...]]:
        """Yield the numbers of the actions that lead to the best hyperstates of a level.

        With ties kept: every sequence whose beginnings all reach their hyperstate with as few
        actions as possible. If `length` actions are better than any fewer, these are all optimal
        sequences of that length; a detour could be cut short, which would make fewer as good.
        """
        for node in self.level(length).best:
            yield from self._sequences_to(node)

    def _sequences_to(self, node: Node) -> Iterator[tuple[int, ...]]:
        # A stack, not recursion: plans may be longer than Python's recursion limit.
        pending: list[tuple[Node, tuple[int, ...]]] = [(node, ())]
        while pending:
            here, word = pending.pop()
            routes = self._routes[here]
            if not routes:
                yield word
            pending.extend((parent, (action, *word)) for parent, action in reversed(routes))


def breadth_first(
    root: Node,
    actions: Sequence[Action],
    apply: Callable[[Node, Action], Node],
    worth: Callable[[Node], Worth],
    *,
    node_limit: int,
    count_duplicates: bool = True,
    depth: int | None = None,
    keep_ties: bool = False,
    highest: Worth | None = None,
    enough: Callable[[Level[Node, Worth]], bool] | None = None,
    stop: Callable[[int], bool] | None = None,
) -> SearchResult[Node, Worth]:
    """Search all plans, the shorter ones first.

    Parameters
    ----------
    root : Node
        The hyperstate before the first action.
    actions : sequence
        The actions; results name them by their numbers.
    apply : callable
        ``apply(node, action)`` is the next hyperstate, in canonical form.
    worth : callable
        ``worth(node)`` is what a hyperstate is worth, the more the better, exactly ordered. It is
        asked for once for each hyperstate.
    node_limit : int
        Most nodes that are generated; the root counts.
    count_duplicates : bool, default True
        Whether a hyperstate counts each time it is generated, or once.
    depth : int, optional
        Most actions of a plan.
    keep_ties : bool, default False
        Keep all best hyperstates of a level and all shortest ways to them.
    highest : Worth, optional
        Nothing is worth more: the first hyperstate of this worth ends the search, or, with ties
        kept, the level that it is on.
    enough : callable, optional
        ``enough(level)`` ends the search after a complete level.
    stop : callable, optional
        ``stop(generated)`` ends the search as the node limit does: a level is left incomplete. It
        is asked before each node, and told how many there are.

    Raises
    ------
    InputError
        If the node limit is below 1 or the depth below 0.

    Notes
    -----
    Time O(nodes generated), that is at most the number of actions for each different hyperstate;
    memory O(different hyperstates), with ties kept O(nodes generated).

    Examples
    --------
    Two maps of three states; what the plan leaves possible should be as little as possible:

    >>> maps = ((0, 0, 1), (1, 2, 0))
    >>> found = breadth_first(
    ...     frozenset({0, 1, 2}),
    ...     maps,
    ...     lambda states, f: frozenset(f[q] for q in states),
    ...     lambda states: -len(states),
    ...     node_limit=100,
    ... )
    >>> [level.worth for level in found.levels][:3], next(found.sequences(2)), found.conclusive
    ([-3, -2, -1], (0, 0), True)
    """
    if node_limit < 1 or (depth is not None and depth < 0):
        raise InputError(
            f"a limit of {node_limit} nodes and a depth of {depth}; "
            "accepted: at least 1 node, a depth of 0 or more"
        )
    search = _Search(root, actions, apply, worth, highest)
    search.node_limit, search.count_duplicates = node_limit, count_duplicates
    search.keep_ties, search.stop = keep_ties, stop
    while search.frontier and search.last.complete and not search.settled:
        if search.last.length == depth or (enough is not None and enough(search.last)):
            break
        search.go_on()
    conclusive = search.settled or (search.last.complete and not search.frontier)
    return SearchResult(search.levels, search.routes, conclusive=conclusive)


class _Search(Generic[Node, Action, Worth]):
    """A search under way: its levels, its frontier, and how each hyperstate was reached."""

    node_limit: int
    count_duplicates: bool
    keep_ties: bool
    stop: Callable[[int], bool] | None

    def __init__(
        self,
        root: Node,
        actions: Sequence[Action],
        apply: Callable[[Node, Action], Node],
        worth: Callable[[Node], Worth],
        highest: Worth | None,
    ) -> None:
        self._letters = tuple(enumerate(actions))
        self._apply, self._worth, self._highest = apply, worth, highest
        self.routes: dict[Node, list[tuple[Node, int]]] = {root: []}
        self.frontier = [root]
        first = worth(root)
        self.levels = [Level(0, first, (root,), 1, 1, complete=True)]
        self.settled = self._is_highest(first)

    @property
    def last(self) -> Level[Node, Worth]:
        return self.levels[-1]

    def _is_highest(self, worth: Worth) -> bool:
        return self._highest is not None and not worth < self._highest

    def go_on(self) -> None:
        """Search one level more."""
        last, routes = self.last, self.routes
        fresh: dict[Node, Worth] = {}
        count = 0
        # Invariant: `routes` holds what at most last.length actions reach, and `fresh`.
        for node, (k, action) in product(self.frontier, self._letters):
            spent = last.generated + count if self.count_duplicates else len(routes)
            if spent == self.node_limit or (
                self.stop is not None and self.stop(last.generated + count)
            ):
                break
            count += 1
            child = self._apply(node, action)
            if child not in routes:
                routes[child] = [(node, k)]
                fresh[child] = self._worth(child)
                self.settled |= self._is_highest(fresh[child])
                if self.settled and not self.keep_ties:
                    break
            elif self.keep_ties and child in fresh:
                routes[child].append((node, k))
        complete = (self.settled and not self.keep_ties) or (
            count == len(self.frontier) * len(self._letters)
        )
        best, top = self._best(fresh)
        generated = last.generated + count
        self.levels.append(Level(last.length + 1, top, best, generated, len(routes), complete))
        self.frontier = list(fresh)

    def _best(self, fresh: dict[Node, Worth]) -> tuple[tuple[Node, ...], Worth]:
        """Return the best of the last level's best and the new hyperstates, and its worth."""
        best, top = list(self.last.best), self.last.worth
        for node, worth in fresh.items():
            if top < worth:
                best, top = [node], worth
            elif self.keep_ties and not worth < top:
                best.append(node)
        return tuple(best), top
