"""Classes of equivalent actions: arcs of angles that move every state alike (thesis 4.4.5).

After an action the part is in one of the states v_j, the values of the transfer function. An
action at alpha sends v_j to v_k with b_k <= v_j - alpha < b_{k+1}. As alpha grows, v_j - alpha
falls; at alpha = v_j - b_k it is still on step k, which is closed on the left, and just above it
is on step k - 1. So the effect changes just above the *critical* angles v_j - b_k, and a class is
an arc (low, high] between two neighbouring ones: open below, closed above.

States modulo the period. s(theta + T) = s(theta) + T, so every action commutes with a shift of
all states by T: what it does to the m states of one period tells what it does to the q m states
of a full turn, and alpha and alpha + T do the same but for a shift by T. Hence states are counted
modulo m, angles modulo T, and there are at most m^2 classes. (On a full turn each class stands
for q arcs, which differ by how far they shift the states.)

Two classes can have the same map modulo m: two arcs may both send all states to v_0, and close
different gaps between the states while they do. `ActionClasses.merged` joins them.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from operator import itemgetter
from typing import final, overload

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.angles import Angle
from stochgeom.exact.directions import nominal_angle
from stochgeom.feeding.automaton import Automaton, Map
from stochgeom.transfer.step_function import StepFunction


@final
@dataclass(frozen=True)
class ActionClass:
    """All actions with alpha in (low, high]: they move every state alike.

    Attributes
    ----------
    number : int
        Its place among the classes, from 0.
    low, high : Angle
        `high` in [0, T), `low` below it by at most T.
    steps : tuple of int
        State v_j goes to v_k with k = steps[j], lifted: k may be any whole number.
    """

    number: int
    low: Angle
    high: Angle
    steps: tuple[int, ...]

    @cached_property
    def angle(self) -> Angle:
        """The representative: the simplest rational direction near the middle."""
        return nominal_angle(self.low, self.high)

    @property
    def targets(self) -> Map:
        """For each of the m states of one period the next one, modulo m."""
        return self.targets_on(1)

    def targets_on(self, periods: int) -> Map:
        """Return the next state of each of the states of some periods, modulo their number.

        With ``periods = transfer.order`` these are the states of a full turn.
        """
        m, all_states = len(self.steps), len(self.steps) * periods
        return tuple((k + m * lap) % all_states for lap in range(periods) for k in self.steps)

    def matrix(self, periods: int = 1) -> NDArray[np.int8]:
        """Return the binary transition matrix: a 1 in row j, column k if state j goes to k.

        A hyperstate is a row vector and is multiplied by it from the right (Eq. 2.1).
        """
        targets = self.targets_on(periods)
        matrix = np.zeros((len(targets), len(targets)), dtype=np.int8)
        matrix[np.arange(len(targets)), targets] = 1
        return matrix


@final
class ActionClasses(Sequence[ActionClass]):
    """The classes of actions of a transfer function, by increasing angle.  O(m^2 log m + p m).

    Parameters
    ----------
    transfer : StepFunction
        Of m steps; there are p <= m^2 classes.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> classes = action_classes(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [(c.low.degrees(1), c.high.degrees(1), c.targets) for c in classes]
    [('-33.7', '33.7', (0, 1)), ('33.7', '56.3', (1, 1)),
     ('56.3', '123.7', (1, 0)), ('123.7', '146.3', (1, 1))]
    >>> classes[1].matrix().tolist()
    [[0, 1], [0, 1]]
    """

    def __init__(self, transfer: StepFunction) -> None:
        self.transfer = transfer
        self._classes = tuple(_classes(transfer))
        self._highs = [c.high for c in self._classes]

    def __len__(self) -> int:
        return len(self._classes)

    @overload
    def __getitem__(self, key: int) -> ActionClass: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[ActionClass, ...]: ...
    def __getitem__(self, key: int | slice) -> ActionClass | tuple[ActionClass, ...]:
        return self._classes[key]

    def at(self, alpha: Angle) -> ActionClass:
        """Return the class of an action, its angle taken modulo the period.  O(log m).

        Examples
        --------
        >>> from stochgeom.transfer.squeeze import squeeze_function
        >>> classes = action_classes(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
        >>> classes.at(Angle.from_degrees(-45)).number
        3
        """
        # Above the last critical angle the first class begins, one period on.
        return self._classes[bisect_left(self._highs, alpha % self.transfer.period) % len(self)]

    @cached_property
    def merged(self) -> dict[Map, tuple[ActionClass, ...]]:
        """The different maps modulo m, each with its classes, in order of the first class."""
        found: dict[Map, list[ActionClass]] = {}
        for each in self._classes:
            found.setdefault(each.targets, []).append(each)
        return {targets: tuple(classes) for targets, classes in found.items()}

    def automaton(self) -> Automaton:
        """Return the states modulo T as an automaton; its letters are the keys of `merged`."""
        return Automaton(tuple(self.merged))

    def representatives(self, word: Iterable[int]) -> tuple[ActionClass, ...]:
        """Return for each letter of `automaton` the first of its classes."""
        first = [classes[0] for classes in self.merged.values()]
        return tuple(first[letter] for letter in word)

    def __repr__(self) -> str:
        return f"<{len(self)} classes of actions, {len(self.merged)} different maps>"


def action_classes(transfer: StepFunction) -> ActionClasses:
    """Return the classes of equivalent actions of a transfer function.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> action_classes(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    <4 classes of actions, 3 different maps>
    """
    return ActionClasses(transfer)


def _classes(transfer: StepFunction) -> Iterator[ActionClass]:
    """Walk once around the circle of angles, from one critical angle to the next."""
    m, period = len(transfer), transfer.period
    critical: list[tuple[Angle, int]] = []
    steps: dict[int, tuple[Angle, int]] = {}
    for j, value in enumerate(transfer.values):
        for k, start in enumerate(transfer.breaks):
            laps, alpha = divmod(value - start, period)
            critical.append((alpha, j))
            # Up to its first critical angle, v_j - alpha is on the step whose break it meets there.
            if j not in steps or alpha < steps[j][0]:
                steps[j] = alpha, k + laps * m
    critical.sort(key=itemgetter(0))
    current = [steps[j][1] for j in range(m)]
    low = critical[-1][0] - period
    for number, (high, crossing) in enumerate(groupby(critical, key=itemgetter(0))):
        # Invariant: v_j - alpha is on step current[j] for every alpha in (low, high].
        yield ActionClass(number, low, high, tuple(current))
        for _, j in crossing:
            current[j] -= 1
        low = high
