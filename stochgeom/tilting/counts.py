"""What a robot observed: how often each action led from each state to each outcome.

States and actions are numbered from 1, as on the robot. A trial may end in none of the states;
such an outcome is `OTHER`, has a column of its own and is folded into no other.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from operator import index
from typing import Any, Final, SupportsIndex, TypeAlias, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_count, as_list
from stochgeom.errors import RecordingError

OTHER: Final = "other"
"""The outcome of a trial that ended in none of the states."""

Outcome: TypeAlias = "int | str"
Trial: TypeAlias = tuple[int, int, Outcome]
"""Initial state, action, outcome."""

MOST_KINDS: Final = 1000
"""Most states and most actions: a table of counts has actions x states x states cells."""

_LARGEST_COUNT: Final = 2**53


@final
class TransitionCounts:
    """Observation matrices X_a, one for each action (thesis 6.3).

    Parameters
    ----------
    counts : nested sequences or integer array
        ``counts[a - 1][i - 1][j - 1]`` trials of action a led from state i to state j. A matrix
        that is wider than high by one has the outcome `OTHER` as its last column.

    Raises
    ------
    RecordingError
        If the shape is none of these, or a count is no whole number from 0 on.

    Examples
    --------
    >>> seen = TransitionCounts.from_trials([(1, 1, 2), (1, 1, 2), (2, 1, OTHER)], 2, 1)
    >>> seen.row(1, 1), seen.row(1, 2), seen.total
    ((0, 2, 0), (0, 0, 1), 3)
    """

    def __init__(self, counts: Any) -> None:
        table = _whole_numbers(counts)
        if table.ndim != 3 or 0 in table.shape or table.shape[2] - table.shape[1] not in (0, 1):
            raise RecordingError(
                f"counts of shape {' x '.join(map(str, table.shape)) or 'one number'}; accepted: "
                "actions x states x states, or one column more for other outcomes"
            )
        table.setflags(write=False)
        self._table = table

    @classmethod
    def from_trials(
        cls,
        trials: Iterable[Sequence[Any]],
        states: int = 12,
        actions: int = 12,
        *,
        other: bool = True,
        places: Sequence[str] | None = None,
    ) -> TransitionCounts:
        """Count trials: (initial, action, final), or with how often it was seen as a fourth entry.

        Parameters
        ----------
        trials : iterable of sequences
            States and actions from 1; the final state may be `OTHER`.
        states, actions : int
            How many there are.
        other : bool, default True
            Whether a trial may end in none of the states.
        places : sequence of str, optional
            Where each trial stands in its source, for errors; ``"trial 0"`` and so on otherwise.

        Raises
        ------
        RecordingError
            If a trial names a state or action that does not exist, or a negative count.
        """
        states = as_count(states, "states", most=MOST_KINDS, error=RecordingError)
        actions = as_count(actions, "actions", most=MOST_KINDS, error=RecordingError)
        listed: list[Any] = as_list(trials, "a list of trials", "trials", RecordingError)
        table = np.zeros((actions, states, states + other), dtype=np.int64)
        for k, trial in enumerate(listed):
            place = f"trial {k}" if places is None else places[k]
            # Rows of an array are arrays of one dimension; one of none has no length.
            is_row = isinstance(trial, Sequence) or getattr(trial, "ndim", 0) == 1
            size = len(trial) if is_row else None
            if size not in (3, 4):
                found = f"{trial!r:.60}" if size is None else f"{size} entries"
                raise RecordingError(
                    f"{found}; accepted: initial, action, final, and perhaps a count",
                    where=place,
                )
            i = numbered(trial[0], states, "initial state", place)
            a = numbered(trial[1], actions, "action", place)
            if other and trial[2] == OTHER:
                j = states + 1
            else:
                j = numbered(trial[2], states, "final state", place, other=other)
            count = _as_count(trial[3], place) if size == 4 else 1
            table[a - 1, i - 1, j - 1] += count
        return cls(table)

    # --- what there is ---------------------------------------------------------------------------

    @property
    def table(self) -> NDArray[np.int64]:
        """The counts as an array that cannot be written to: actions x states x outcomes."""
        return self._table

    @property
    def actions(self) -> int:
        """Number of actions."""
        return int(self._table.shape[0])

    @property
    def states(self) -> int:
        """Number of states."""
        return int(self._table.shape[1])

    @property
    def has_other(self) -> bool:
        """Whether a trial may end in none of the states."""
        return bool(self._table.shape[2] > self._table.shape[1])

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """The names of the columns."""
        return (*range(1, self.states + 1), *([OTHER] if self.has_other else []))

    @property
    def total(self) -> int:
        """Number of trials."""
        return int(self._table.sum())

    @property
    def others(self) -> int:
        """Number of trials that ended in none of the states."""
        return int(self._table[:, :, self.states :].sum())

    def row(self, action: int, state: int) -> tuple[int, ...]:
        """Return the counts of the outcomes of an action in a state."""
        a = numbered(action, self.actions, "action")
        i = numbered(state, self.states, "state")
        return tuple(int(count) for count in self._table[a - 1, i - 1])

    def trials(self) -> Iterator[tuple[int, int, Outcome, int]]:
        """Yield (initial, action, outcome, count) for each count that is not 0, by action."""
        names = self.outcomes
        for a, i, j in zip(*map(list, np.nonzero(self._table)), strict=True):
            yield int(i) + 1, int(a) + 1, names[j], int(self._table[a, i, j])

    # --- values ----------------------------------------------------------------------------------

    def __add__(self, other: TransitionCounts) -> TransitionCounts:
        """Return both recordings together."""
        if not isinstance(other, TransitionCounts):
            return NotImplemented
        if self._table.shape != other._table.shape:
            raise RecordingError(
                f"recordings of shapes {self._table.shape} and {other._table.shape} added; "
                "accepted: the same states, actions and outcomes"
            )
        return TransitionCounts(self._table + other._table)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TransitionCounts):
            return NotImplemented
        return bool(np.array_equal(self._table, other._table))

    def __hash__(self) -> int:
        return hash((self._table.shape, self._table.tobytes()))

    def __repr__(self) -> str:
        return (
            f"<TransitionCounts: {self.actions} actions, {self.states} states, "
            f"{self.total} trials, {self.others} of them with another outcome>"
        )


def numbered(
    value: Any, most: int, what: str, place: str | None = None, *, other: bool = False
) -> int:
    """Return a state or action as an int from 1 to `most`.

    Raises
    ------
    RecordingError
        If it is anything else; `place` says where it stands.

    Examples
    --------
    >>> numbered("7", 12, "state")
    7
    """
    try:
        number = int(value) if isinstance(value, str) and value.isdecimal() else index(value)
    except (TypeError, ValueError):
        number = 0
    if isinstance(value, bool) or not 1 <= number <= most:
        also = f", or {OTHER}" if other else ""
        raise RecordingError(
            f"{what} {str(value)[:40]!r}; accepted: 1 to {most}{also}", where=place
        )
    return number


def _as_count(value: SupportsIndex | str, place: str) -> int:
    try:
        count = int(value) if isinstance(value, str) else index(value)
    except (TypeError, ValueError):
        count = -1
    if not 0 <= count <= _LARGEST_COUNT:
        raise RecordingError(
            f"the count {str(value)[:40]!r}; accepted: whole numbers from 0 on", where=place
        )
    return count


def _whole_numbers(counts: Any) -> NDArray[np.int64]:
    try:
        table = np.array(counts)
    except (ValueError, OverflowError):
        table = np.array(None)
    if table.dtype.kind not in "iu":
        raise RecordingError(
            f"counts of type {table.dtype}; accepted: a table of whole numbers, all rows alike"
        )
    wrong = np.argwhere((table < 0) | (table > _LARGEST_COUNT))
    if len(wrong):
        place = ", ".join(
            f"{what} {number + 1}"
            for what, number in zip(("action", "state", "outcome"), wrong[0], strict=False)
        )
        raise RecordingError(
            f"the count {table[tuple(wrong[0])]}; accepted: whole numbers from 0 on", where=place
        )
    return table.astype(np.int64)
