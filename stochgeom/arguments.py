"""What functions accept, checked at the door: a value of the wrong type is named there and then.

Only what a caller hands in is looked at; the functions behind the door trust what they get.

Examples
--------
>>> as_count("2", "steps")
Traceback (most recent call last):
...
stochgeom.errors.InputError: '2' steps; accepted: whole numbers from 1 on
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final, TypeVar

from stochgeom.errors import InputError

_Value = TypeVar("_Value")

_SHOWN: Final = 60


def shown(value: object) -> str:
    """Return how a message shows a value: on one line, cut, whatever it is.

    Examples
    --------
    >>> shown("two words"), shown(10**5000)
    ("'two words'", 'an int of 16610 bits')
    """
    try:
        text = repr(value)
    except ValueError:  # an int with more digits than Python writes, perhaps within a list
        if isinstance(value, int):
            text = f"an int of {value.bit_length()} bits"
        else:
            text = f"a {type(value).__name__} with an int of too many digits"
    return " ".join(text.split())[:_SHOWN]


def expect(value: _Value, kind: Any, accepted: str, where: str | None = None) -> _Value:
    """Return a value of a class, or of one of a union, as it is.

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
            f"{shown(value)} is of type {type(value).__name__}, not {wanted}; accepted: {accepted}",
            where=where,
        )
    return value


def as_count(
    value: Any,
    what: str,
    *,
    least: int = 1,
    most: int | None = None,
    error: type[InputError] = InputError,
    where: str | None = None,
) -> int:
    """Return a whole number within limits, be it an int or of numpy's; True and 2.0 are none.

    Raises
    ------
    InputError
        If it is another number, or none; ``error`` is its class.

    Examples
    --------
    >>> as_count(2, "turns", most=10)
    2
    """
    try:
        count = None if isinstance(value, bool) else int(value.__index__())
    except (AttributeError, TypeError):  # TypeError: a class, or an array of several
        count = None
    if count is None or count < least or (most is not None and count > most):
        end = "on" if most is None else f"to {most}"
        raise error(
            f"{shown(value)} {what}; accepted: whole numbers from {least} {end}", where=where
        )
    return count


def as_list(
    values: Iterable[_Value],
    accepted: str,
    where: str | None = None,
    error: type[InputError] = InputError,
) -> list[_Value]:
    """Return what can be iterated as a list; text is no list of its letters.

    Raises
    ------
    InputError
        If it is text or cannot be iterated; ``error`` is its class.

    Examples
    --------
    >>> as_list((1, 2), "numbers"), as_list({"a": 1}, "labels")
    ([1, 2], ['a'])
    >>> as_list("2", "a list of angles", where="angles")
    Traceback (most recent call last):
    ...
    stochgeom.errors.InputError: angles: '2'; accepted: a list of angles
    """
    if isinstance(values, str | bytes):
        raise error(f"{shown(values)}; accepted: {accepted}", where=where)
    try:
        iterator = iter(values)
    except TypeError:
        raise error(f"{shown(values)}; accepted: {accepted}", where=where) from None
    return list(iterator)
