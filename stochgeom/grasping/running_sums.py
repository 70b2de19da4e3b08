"""Sums of many terms that change at breakpoints: which term counts how often, between any two."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import Final, Generic, TypeVar, final

from stochgeom.exact.angles import ZERO, Angle

Term = TypeVar("Term", bound=Hashable)

SNAPSHOTS: Final = 16
"""How many sums are kept whole: all of them would take quadratic memory."""


@final
class RunningSums(Generic[Term]):
    """Whole weights of terms, piecewise constant from 0 on.

    Parameters
    ----------
    changes : iterable of (Angle, term, int)
        From which breakpoint on, 0 or more, a term counts with how much more weight.

    Attributes
    ----------
    starts : list of Angle
        0 and the breakpoints at which a weight changes, increasing.

    Examples
    --------
    >>> place = Angle(0, (1, 1))
    >>> sums = RunningSums([(ZERO, "a", 1), (place, "b", 2), (place, "a", -1)])
    >>> [sums.at(k) for k in range(len(sums.starts))]
    [{'a': 1}, {'b': 2}]
    """

    def __init__(self, changes: Iterable[tuple[Angle, Term, int]]) -> None:
        found: dict[Angle, dict[Term, int]] = {ZERO: {}}
        for start, term, weight in changes:
            here = found.setdefault(start, {})
            here[term] = here.get(term, 0) + weight
        kept = {
            start: {term: weight for term, weight in change.items() if weight}
            for start, change in found.items()
        }
        self.starts = sorted(start for start, change in kept.items() if change or not start)
        self._changes = [kept[start] for start in self.starts]
        self._stride = -(-len(self.starts) // SNAPSHOTS)
        self._snapshots: list[dict[Term, int]] = []
        total: dict[Term, int] = {}
        for k, change in enumerate(self._changes):
            _add(total, change)
            if k % self._stride == 0:
                self._snapshots.append(total.copy())

    def at(self, k: int) -> dict[Term, int]:
        """Return the weights from breakpoint k to the next, those of 0 left out."""
        place = k // self._stride
        total = self._snapshots[place].copy()
        for change in self._changes[place * self._stride + 1 : k + 1]:
            _add(total, change)
        return total


def _add(total: dict[Term, int], change: dict[Term, int]) -> None:
    for term, weight in change.items():
        found = total.get(term, 0) + weight
        if found:
            total[term] = found
        else:
            total.pop(term, None)
