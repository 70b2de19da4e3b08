"""Natarajan's planner (1989): merge two states, then two of those that are left, and so on.

Given k maps of n states, find a sequence of them that sends all states to one (thesis 5.2). A
sequence that merges two given states is found in the graph of pairs: a pair {p, q} is joined by
each map f to {f(p), f(q)}. The planner takes any two states that are left, merges them, applies
the sequence to all, and repeats.

Why it never has to go back, the *inclusion property*: a sequence that collapses the whole set
collapses every subset, and what earlier choices left of the whole set is a subset of it. So all
states collapse if and only if every pair does; a pair that cannot be merged proves that no
sequence collapses the whole, and the set of all pairs it can become is the proof.

A subset may collapse although the whole does not; then the choice of pairs matters, and the
question is PSPACE-complete (Kozen 1977). `shortest_collapse` answers it by search over sets.

The sequences are not the shortest. On states modulo the period of a transfer function they are
plans up to symmetry without their first, random action.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from typing import final

from stochgeom.decision.search import breadth_first
from stochgeom.errors import InputError
from stochgeom.feeding.automaton import Automaton

Pair = tuple[int, int]
"""Two different states, the smaller one first."""


@final
@dataclass(frozen=True, slots=True)
class ResetWord:
    """A sequence of letters that sends every state to one.

    Attributes
    ----------
    letters : tuple of int
        The sequence; empty if there is one state.
    state : int
        Where all states end.
    """

    letters: tuple[int, ...]
    state: int


@final
@dataclass(frozen=True, slots=True)
class UnmergeablePair:
    """Two states that no sequence sends to one, with the proof.

    Attributes
    ----------
    pair : tuple of int
        The two states.
    closure : frozenset of pairs
        Every pair that it can become. No map sends one of them to a single state or to a pair
        that is not among them.
    """

    pair: Pair
    closure: frozenset[Pair]

    def holds_for(self, automaton: Automaton) -> bool:
        """Check the proof.  O(k pairs)."""
        following = (
            _pair(f[p], f[q]) for f in automaton.maps for p, q in self.closure
        )  # None for two states that were merged
        return self.pair in self.closure and all(pair in self.closure for pair in following)


def natarajan(automaton: Automaton) -> ResetWord | UnmergeablePair:
    """Return a sequence that sends all states to one, or a pair that none merges.

    Notes
    -----
    At most n - 1 searches of O(k n^2) each, and the application of their results. The source
    says O(k n^4).

    Examples
    --------
    >>> natarajan(Automaton(((0, 0, 1), (1, 2, 0))))
    ResetWord(letters=(0, 0), state=0)
    >>> natarajan(Automaton(((0, 0, 2),)))
    UnmergeablePair(pair=(0, 2), closure=frozenset({(0, 2)}))
    """
    letters: list[int] = []
    states = frozenset(range(automaton.states))
    while len(states) > 1:
        first, second, *_ = sorted(states)
        found = _merge(automaton, (first, second))
        if isinstance(found, UnmergeablePair):
            return found
        letters += found
        states = automaton.image(found, states)
    return ResetWord(tuple(letters), min(states))


def _merge(automaton: Automaton, pair: Pair) -> list[int] | UnmergeablePair:
    """Return the shortest sequence that merges a pair.  O(k n^2)."""
    came_from: dict[Pair, tuple[Pair, int] | None] = {pair: None}
    queue = deque([pair])
    while queue:
        here = queue.popleft()
        for letter, f in enumerate(automaton.maps):
            following = _pair(f[here[0]], f[here[1]])
            if following is None:
                return _way(came_from, here, letter)
            if following not in came_from:
                came_from[following] = here, letter
                queue.append(following)
    return UnmergeablePair(pair, frozenset(came_from))


def _way(came_from: dict[Pair, tuple[Pair, int] | None], last: Pair, last_letter: int) -> list[int]:
    word = [last_letter]
    step = came_from[last]
    while step is not None:
        word.append(step[1])
        step = came_from[step[0]]
    return word[::-1]


def _pair(p: int, q: int) -> Pair | None:
    if p == q:
        return None
    return (p, q) if p < q else (q, p)


def mergeable_pairs(automaton: Automaton) -> frozenset[Pair]:
    """Return the pairs of states that some sequence merges.  O(k n^2).

    All states collapse if and only if these are all pairs: the inclusion property.

    Examples
    --------
    >>> sorted(mergeable_pairs(Automaton(((0, 0, 2),))))
    [(0, 1)]
    """
    before: dict[Pair | None, list[Pair]] = {}
    for p in range(automaton.states):
        for q in range(p + 1, automaton.states):
            for f in automaton.maps:
                before.setdefault(_pair(f[p], f[q]), []).append((p, q))
    found: set[Pair] = set()
    pending: list[Pair | None] = [None]
    while pending:
        for pair in before.get(pending.pop(), ()):
            if pair not in found:
                found.add(pair)
                pending.append(pair)
    return frozenset(found)


def shortest_collapse(
    automaton: Automaton, states: Iterable[int] | None = None, *, node_limit: int = 100_000
) -> ResetWord | None:
    """Return a shortest sequence that sends a set of states (default: all) to one, or None.

    Parameters
    ----------
    automaton : Automaton
        Any maps, monotone or not.
    states : iterable of int, optional
        The set to collapse.
    node_limit : int, default 100,000
        Most sets of states that are generated: there may be 2^n.

    Raises
    ------
    InputError
        If the set is empty or names a state that does not exist, or if the node limit is
        reached before the answer.

    Examples
    --------
    A subset collapses, the whole does not:

    >>> automaton = Automaton(((0, 0, 2),))
    >>> shortest_collapse(automaton, {0, 1}), shortest_collapse(automaton)
    (ResetWord(letters=(0,), state=0), None)
    """
    root = frozenset(range(automaton.states) if states is None else states)
    if not root or not root <= set(range(automaton.states)):
        raise InputError(
            f"states {sorted(root)}; accepted: at least one of 0 to {automaton.states - 1}"
        )
    found = breadth_first(
        root,
        automaton.maps,
        lambda node, f: frozenset([f[state] for state in node]),
        lambda node: -len(node),
        node_limit=node_limit,
        highest=-1,
    )
    if found.last.worth == -1:
        word = next(found.sequences(found.last.length))
        return ResetWord(word, automaton.run(word, min(root)))
    if not found.last.complete:
        raise InputError(f"no answer after {node_limit} sets of states; accepted: a higher limit")
    return None
