"""Finite automata of deterministic actions, and their exchange as plain text.

An automaton has N states and K letters; letter a sends state q to delta(q, a). The states here
are the values of a transfer function modulo its period, the letters the maps of its actions; a
word that sends all states to one is a plan without its first, random action. In the literature
such words are called reset or synchronizing words.

The text is the one that programs for synchronizing words read, state by state:

    K N
    delta(0, 0) delta(0, 1) ... delta(0, K - 1)
    ...
    delta(N - 1, 0) ...         delta(N - 1, K - 1)

All numbers count from 0. Some programs want the first line to be ``N K``: `states_first`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, final

from stochgeom.errors import FormatError, InputError

Map = tuple[int, ...]
"""For each state the next one."""

MAX_ENTRIES: Final = 10_000_000
"""Most entries of a table that is read."""

_MAX_DIGITS: Final = 9


@final
@dataclass(frozen=True, slots=True)
class Automaton:
    """N states and, for each letter, the map from states to states.

    Parameters
    ----------
    maps : tuple of tuple of int
        maps[a][q] = delta(q, a); at least one letter and one state.

    Raises
    ------
    InputError
        If the maps differ in length, are empty, or name a state that does not exist.

    Examples
    --------
    >>> automaton = Automaton(((0, 0, 1), (1, 2, 0)))
    >>> automaton.run((0, 1), 2)
    2
    """

    maps: tuple[Map, ...]

    def __post_init__(self) -> None:
        if not self.maps or not self.maps[0]:
            raise InputError("an automaton without letters or states; accepted: at least one each")
        for letter, row in enumerate(self.maps):
            if len(row) != self.states:
                raise InputError(
                    f"{len(row)} states; accepted: {self.states}, as letter 0 has",
                    where=f"letter {letter}",
                )
            for state, following in enumerate(row):
                if not 0 <= following < self.states:
                    raise InputError(
                        f"state {following}; accepted: 0 to {self.states - 1}",
                        where=f"letter {letter}, state {state}",
                    )

    @property
    def states(self) -> int:
        """N, the number of states."""
        return len(self.maps[0])

    @property
    def letters(self) -> int:
        """K, the number of letters."""
        return len(self.maps)

    def run(self, word: Iterable[int], state: int) -> int:
        """Return the state after all letters of a word."""
        for letter in word:
            state = self.maps[letter][state]
        return state

    def image(self, word: Iterable[int], states: Iterable[int] | None = None) -> frozenset[int]:
        """Return the states that a word makes of a set of states (default: all).

        Examples
        --------
        >>> sorted(Automaton(((0, 0, 1), (1, 2, 0))).image((0,)))
        [0, 1]
        """
        found = frozenset(range(self.states) if states is None else states)
        for letter in word:
            found = frozenset(map(self.maps[letter].__getitem__, found))
        return found


def write_automaton(automaton: Automaton, *, states_first: bool = False) -> str:
    """Return an automaton as text.

    Parameters
    ----------
    automaton : Automaton
        What is written.
    states_first : bool, default False
        Write ``N K`` instead of ``K N`` on the first line.

    Examples
    --------
    >>> print(write_automaton(Automaton(((0, 0, 1), (1, 2, 0)))), end="")
    2 3
    0 1
    0 2
    1 0
    """
    counts = (automaton.letters, automaton.states)
    rows = [counts[::-1] if states_first else counts, *zip(*automaton.maps, strict=True)]
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def read_automaton(text: str, *, states_first: bool = False) -> Automaton:
    r"""Return the automaton that a text describes; empty lines at the end are allowed.

    Raises
    ------
    FormatError
        Naming the line that is not as it should be.

    Examples
    --------
    >>> read_automaton("2 3\n0 1\n0 2\n1 0\n")
    Automaton(maps=((0, 0, 1), (1, 2, 0)))
    """
    lines = text.rstrip().splitlines()
    if not lines:
        raise FormatError("the text is empty; accepted: a line with two counts and a table")
    counts = _numbers(lines[0], 2, "line 1")
    letters, states = counts[::-1] if states_first else counts
    if not letters or not states or letters * states > MAX_ENTRIES:
        raise FormatError(
            f"{letters} letters and {states} states; "
            f"accepted: at least one each and a table of at most {MAX_ENTRIES} entries",
            where="line 1",
        )
    if len(lines) - 1 != states:
        raise FormatError(
            f"{len(lines) - 1} lines follow the first; accepted: {states}, one for each state",
            where=f"line {len(lines)}",
        )
    rows = [_numbers(line, letters, f"line {k}", states) for k, line in enumerate(lines[1:], 2)]
    return Automaton(tuple(zip(*rows, strict=True)))


def _numbers(line: str, count: int, where: str, below: int | None = None) -> Sequence[int]:
    tokens = line.split()
    if len(tokens) != count:
        raise FormatError(f"{len(tokens)} numbers; accepted: {count}", where=where)
    for token in tokens:
        if not (token.isascii() and token.isdigit() and len(token) <= _MAX_DIGITS):
            raise FormatError(
                f"{token[:20]!r}; accepted: whole numbers of at most {_MAX_DIGITS} digits",
                where=where,
            )
    numbers = [int(token) for token in tokens]
    if below is not None and max(numbers) >= below:
        raise FormatError(f"state {max(numbers)}; accepted: 0 to {below - 1}", where=where)
    return numbers
