"""Timing: warm-up, rounds, medians, and ratios of things timed alternately.

A *round* runs everything that is to be compared once, one thing after the other: A B A B, so that
a machine that slows down for a while slows both. Of the samples of all rounds the median is
reported, with the least and the most; a ratio is a ratio of medians. The garbage collector runs
between the rounds and stays on inside them, as it does for users.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter
from typing import TypeVar

import numpy as np

Result = TypeVar("Result")

LEAST_SAMPLE = 5e-3
"""Seconds: shorter actions are repeated inside one sample until they take this long."""


@dataclass(frozen=True)
class Samples:
    """The seconds of one action, a sample for each round."""

    seconds: tuple[float, ...]

    @property
    def median(self) -> float:
        """Median of the samples."""
        return median(self.seconds)

    @property
    def least(self) -> float:
        """Smallest sample."""
        return min(self.seconds)

    @property
    def most(self) -> float:
        """Largest sample."""
        return max(self.seconds)

    def per(self, items: int) -> Samples:
        """Return the seconds of one of `items` equal parts of the action."""
        return Samples(tuple(value / items for value in self.seconds))

    def over(self, other: Samples) -> float:
        """Return the ratio of the medians."""
        return self.median / other.median


class Clock:
    """Times the actions of one round and hands on what they return."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}

    def time(self, label: str, action: Callable[[], Result]) -> Result:
        """Run an action; its seconds are added to those of `label` in this round."""
        start = perf_counter()
        result = action()
        self.seconds[label] = self.seconds.get(label, 0.0) + perf_counter() - start
        return result


def measure_rounds(
    one_round: Callable[[Clock], object], rounds: int, warm_up: int = 1
) -> dict[str, Samples]:
    """Return the samples of every label that `one_round` times, after warm-up rounds.

    Examples
    --------
    >>> found = measure_rounds(lambda clock: clock.time("sum", lambda: sum(range(9))), rounds=3)
    >>> len(found["sum"].seconds)
    3
    """
    found: dict[str, list[float]] = {}
    for number in range(warm_up + rounds):
        gc.collect()
        clock = Clock()
        one_round(clock)
        if number >= warm_up:
            for label, seconds in clock.seconds.items():
                found.setdefault(label, []).append(seconds)
    return {label: Samples(tuple(seconds)) for label, seconds in found.items()}


def measure_small(actions: Mapping[str, Callable[[], object]], rounds: int) -> dict[str, Samples]:
    """Return samples of short actions, each repeated inside a sample, timed alternately.

    Examples
    --------
    >>> found = measure_small({"none": lambda: None}, rounds=2)
    >>> found["none"].median < 1e-4
    True
    """
    counts = {label: _count_for(action) for label, action in actions.items()}

    def one_round(clock: Clock) -> None:
        for label, action in actions.items():
            clock.time(label, lambda action=action, n=counts[label]: _repeat(action, n))

    found = measure_rounds(one_round, rounds)
    return {label: samples.per(counts[label]) for label, samples in found.items()}


def _repeat(action: Callable[[], object], count: int) -> None:
    for _ in range(count):
        action()


def _count_for(action: Callable[[], object]) -> int:
    count = 1
    while True:
        start = perf_counter()
        _repeat(action, count)
        seconds = perf_counter() - start
        if seconds >= LEAST_SAMPLE:
            return count
        count *= 2 if seconds <= 0 else max(2, min(100, int(LEAST_SAMPLE / seconds) + 1))


def growth_exponent(sizes: Sequence[int], seconds: Sequence[float]) -> float:
    """Return k of the least squares fit seconds = a sizes**k, in logarithms.

    Examples
    --------
    >>> round(growth_exponent([10, 100, 1000], [3.0, 300.0, 30000.0]), 6)
    2.0
    """
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])
