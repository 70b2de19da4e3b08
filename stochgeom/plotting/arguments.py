"""What drawing functions accept, with the errors of what they do not."""

from __future__ import annotations

from typing import Any, Final, TypeVar

from stochgeom.errors import InputError

MOST_TURNS: Final = 10

_Value = TypeVar("_Value")


def expect(value: _Value, kind: Any, accepted: str) -> _Value:
    """Return a value of a class as it is.

    Raises
    ------
    InputError
        If it is of another one; ``accepted`` says where to get it.

    Examples
    --------
    >>> expect("house", int, "a whole number")
    Traceback (most recent call last):
    ...
    stochgeom.errors.InputError: 'house' is of type str, not int; accepted: a whole number
    """
    if not isinstance(value, kind):
        wanted = getattr(kind, "__name__", kind)  # a union has no name
        raise InputError(
            f"{value!r:.60} is of type {type(value).__name__}, not {wanted}; accepted: {accepted}"
        )
    return value


def as_count(value: Any, most: int, what: str) -> int:
    """Return a whole number from 1 to ``most``.

    Raises
    ------
    InputError
        If it is another number, or none.

    Examples
    --------
    >>> as_count(2, MOST_TURNS, "turns")
    2
    """
    try:
        count = int(value.__index__())
    except AttributeError:
        count = 0
    if not 1 <= count <= most:
        raise InputError(f"{value!r:.60} {what}; accepted: whole numbers from 1 to {most}")
    return count
