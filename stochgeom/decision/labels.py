"""Labels of states, actions and readings: any hashable values, each once."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from typing import Any, Final, final

from stochgeom.errors import (
    DuplicateLabelError,
    EmptyProblemError,
    ProblemError,
    UnknownLabelError,
)

_MOST_NAMED: Final = 8


@final
class Labels:
    """A finite list of different labels.

    Parameters
    ----------
    labels : iterable of hashable
        At least one, all different.
    what : str
        What they are the labels of, for messages: ``"state"``.

    Attributes
    ----------
    all : tuple
        The labels in their order.

    Raises
    ------
    EmptyProblemError
        If there is none.
    DuplicateLabelError
        If one stands there twice; both places are named.

    Examples
    --------
    >>> Labels(["up", "down"], "state").number("down")
    1
    >>> Labels(["up", "down"], "state").number("left")
    Traceback (most recent call last):
    ...
    stochgeom.errors.UnknownLabelError: 'left' is no state; accepted: 'up', 'down'
    """

    def __init__(self, labels: Iterable[Hashable], what: str) -> None:
        if isinstance(labels, str | bytes) or not isinstance(labels, Iterable):
            raise ProblemError(f"{labels!r:.60}; accepted: a list of labels", where=f"{what}s")
        self.all: tuple[Any, ...] = tuple(labels)
        self.what = what
        self._numbers: dict[Any, int] = {}
        if not self.all:
            raise EmptyProblemError(f"no {what}; accepted: at least one", where=f"{what}s")
        for k, label in enumerate(self.all):
            if not isinstance(label, Hashable):
                raise ProblemError(
                    f"{label!r:.60} cannot be a label; accepted: text, or another hashable value",
                    where=f"{what} {k}",
                )
            first = self._numbers.setdefault(label, k)
            if first != k:
                raise DuplicateLabelError(
                    f"the label {named(label)} stands at {first} already; accepted: each once",
                    where=f"{what} {k}",
                )

    def number(self, label: Hashable, *, where: str | None = None) -> int:
        """Return the place of a label, from 0.

        Raises
        ------
        UnknownLabelError
            If it is none of them.
        """
        try:
            return self._numbers[label]
        except (KeyError, TypeError):  # TypeError: not hashable, so no label
            shown = ", ".join(named(each) for each in self.all[:_MOST_NAMED])
            more = len(self.all) - _MOST_NAMED
            raise UnknownLabelError(
                f"{named(label)} is no {self.what}; accepted: {shown}"
                + (f" and {more} more" if more > 0 else ""),
                where=where,
            ) from None

    def __len__(self) -> int:
        return len(self.all)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.all)

    def __contains__(self, label: object) -> bool:
        try:
            return label in self._numbers
        except TypeError:
            return False


def named(label: Any) -> str:
    """Return a label as messages show it.

    Examples
    --------
    >>> named("up"), named(3)
    ("'up'", '3')
    """
    return f"{label!r:.40}"
