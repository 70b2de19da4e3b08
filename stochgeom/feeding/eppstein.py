"""Eppstein's algorithm (1990): shortest reset sequences of monotone maps, in O(k n^2).

States 0, ..., n - 1 stand in a cyclic order. A map f is *monotone* if f(0), f(1), ..., f(n - 1)
are in cyclic order too: the forward ascents a_j = (f(j + 1) - f(j)) mod n add up to n around the
circle, or to 0 if f is constant. Squeezes are monotone maps of the states modulo the period.

An interval (i, l) is the states i, i + 1, ..., i + l - 1, modulo n. A monotone f sends it into the
interval from f(i), over 1 + a_i + ... + a_(i+l-2) states. If those are more than n, the ends of
the interval have met from the far side, which is of no use; otherwise the interval is collapsed
if and only if its image is. So the fewest maps that collapse each of the n^2 intervals are found
backwards from the single states, breadth first.

The whole set is one of the n intervals (i, n), which differ by the gap they leave open, from
i - 1 to i. If a sequence collapses the whole set, its lift to all whole numbers, which moves on
by n over a round, is constant but for one jump in a round; the interval that begins at the jump
is collapsed from end to end. (A constant map has such a lift for each place of the jump.) Hence
the shortest reset sequence is the shortest over these n intervals.

A shorter interval may also be collapsed by a sequence that collapses everything and jumps inside
it; so no interval needs more maps than the whole set does.
"""

from __future__ import annotations

from itertools import accumulate
from typing import final

from stochgeom.errors import InputError
from stochgeom.feeding.automaton import Automaton, Map


def is_monotone(targets: Map) -> bool:
    """Tell whether a map keeps the cyclic order of its states.

    Examples
    --------
    >>> is_monotone((1, 2, 0)), is_monotone((2, 2, 2)), is_monotone((2, 1, 0))
    (True, True, False)
    """
    return sum(_ascents(targets)) in (0, len(targets))


def _ascents(targets: Map) -> list[int]:
    n = len(targets)
    return [(targets[(j + 1) % n] - here) % n for j, here in enumerate(targets)]


@final
class CollapseTable:
    """For every interval of states the fewest maps that send it to one state.  O(k n^2).

    Parameters
    ----------
    automaton : Automaton
        Of monotone maps.

    Raises
    ------
    InputError
        If a map is not monotone.

    Examples
    --------
    >>> table = CollapseTable(Automaton(((0, 0, 1), (1, 2, 0))))
    >>> table.length(0, 2), table.length(1, 2), table.reset_word()
    (1, 2, (0, 0))
    """

    def __init__(self, automaton: Automaton) -> None:
        for letter, targets in enumerate(automaton.maps):
            if not is_monotone(targets):
                raise InputError(
                    f"{targets} is not in cyclic order; accepted: monotone maps",
                    where=f"letter {letter}",
                )
        self.automaton = automaton
        self._following: dict[_Interval, tuple[int, _Interval]] = {}
        self._length = {(state, 1): 0 for state in range(automaton.states)}
        self._fill()
        n = automaton.states
        whole = [(i, n) for i in range(n) if (i, n) in self._length]
        self._whole = min(whole, key=self._length.__getitem__, default=None)

    def _fill(self) -> None:
        """Search backwards from the single states, level by level."""
        before = _intervals_before(self.automaton)
        queue = list(self._length)
        for here in queue:  # it grows while it is read
            for source, letter in before.get(here, ()):
                if source not in self._length:
                    self._length[source] = self._length[here] + 1
                    self._following[source] = letter, here
                    queue.append(source)

    def _start_of(self, first: int, count: int) -> _Interval | None:
        """Return the interval whose way is the shortest for this one: itself, or the whole."""
        n = self.automaton.states
        if not 1 <= count <= n:
            raise InputError(f"an interval of {count} states; accepted: 1 to {n}")
        here = (first % n, count)
        ways = [each for each in (here, self._whole) if each in self._length]
        return min(ways, key=self._length.__getitem__, default=None)

    def length(self, first: int, count: int) -> int | None:
        """Return the fewest maps that collapse `count` states from `first` on, None if none do."""
        start = self._start_of(first, count)
        return None if start is None else self._length[start]

    def word(self, first: int, count: int) -> tuple[int, ...] | None:
        """Return a shortest sequence that collapses `count` states from `first` on."""
        here = self._start_of(first, count)
        if here is None:
            return None
        word = []
        while here in self._following:
            letter, here = self._following[here]
            word.append(letter)
        return tuple(word)

    def reset_word(self) -> tuple[int, ...] | None:
        """Return a shortest sequence that collapses all states, None if none does."""
        return self.word(0, self.automaton.states)


_Interval = tuple[int, int]


def _intervals_before(automaton: Automaton) -> dict[_Interval, list[tuple[_Interval, int]]]:
    """Return for each interval the intervals that a map sends into it, with the letter."""
    n = automaton.states
    before: dict[_Interval, list[tuple[_Interval, int]]] = {}
    for letter, targets in enumerate(automaton.maps):
        ascents = _ascents(targets)
        height = list(accumulate(ascents * 2, initial=0))
        for first, image in enumerate(targets):
            for count in range(2, n + 1):
                span = 1 + height[first + count - 1] - height[first]
                if span <= n:
                    before.setdefault((image, span), []).append(((first, count), letter))
    return before


def eppstein(automaton: Automaton) -> tuple[int, ...] | None:
    """Return a shortest sequence of monotone maps that sends all states to one, None if none does.

    Raises
    ------
    InputError
        If a map is not monotone.

    Notes
    -----
    O(k n^2) time and memory. On the maps of `stochgeom.feeding.action_classes` its length plus
    one, the random first squeeze, is that of the shortest plan up to symmetry (Cor. 5.1.1).

    Examples
    --------
    >>> from stochgeom.feeding.action_classes import action_classes
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> classes = action_classes(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [action.targets for action in classes.representatives(eppstein(classes.automaton()))]
    [(1, 1)]
    """
    return CollapseTable(automaton).reset_word()
