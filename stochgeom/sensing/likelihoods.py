"""Likelihoods as they are given: a row for each state, an entry for each reading."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from typing import Any

from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import Number, NumberKind
from stochgeom.errors import FloatRefusedError, SensorError, ShapeMismatchError
from stochgeom.exact.scalars import rational


def rows_by_state(likelihood: Any, states: Iterable[Hashable] | None) -> dict[Any, Any]:
    """Return the rows of a likelihood by state, in the order of the states.

    Raises
    ------
    ShapeMismatchError, UnknownLabelError
        If a state has no row, or a row no state.

    Examples
    --------
    >>> rows_by_state([[0, 1], [1, 0]], "ab")
    Traceback (most recent call last):
    ...
    stochgeom.errors.ProblemError: states: 'ab'; accepted: a list of labels
    >>> rows_by_state([[0, 1], [1, 0]], ["a", "b"])
    {'a': [0, 1], 'b': [1, 0]}
    """
    labels = None if states is None else Labels(states, "state")
    if isinstance(likelihood, Mapping):
        if labels is None:
            return dict(likelihood)
        for state in likelihood:
            labels.number(state, where="likelihood")
        missing = [state for state in labels if state not in likelihood]
        if missing:
            raise ShapeMismatchError(
                f"state {named(missing[0])} has no likelihood; "
                f"accepted: a row for each of the {len(labels)} states"
            )
        return {state: likelihood[state] for state in labels}
    if isinstance(likelihood, str) or not isinstance(likelihood, Iterable):
        raise ShapeMismatchError(
            f"{likelihood!r:.60}; accepted: a mapping from states, or rows", where="likelihood"
        )
    rows = list(likelihood)
    if labels is None:
        return dict(enumerate(rows))
    if len(rows) != len(labels):
        raise ShapeMismatchError(
            f"{len(rows)} rows; accepted: {len(labels)}, one for each state", where="likelihood"
        )
    return dict(zip(labels, rows, strict=True))


def covering(row: Any, readings: Labels, place: str) -> list[Any]:
    """Return one entry for each reading: a likelihood has to cover them.

    Raises
    ------
    ShapeMismatchError, UnknownLabelError
        If a reading has no entry, or an entry no reading.

    Examples
    --------
    >>> covering({"x": 1, "y": 0}, Labels(["y", "x"], "reading"), "likelihood of state 'a'")
    [0, 1]
    """
    if isinstance(row, Mapping):
        for reading in row:
            readings.number(reading, where=place)
        missing = [named(x) for x in readings if x not in row]
        if missing:
            raise ShapeMismatchError(
                f"nothing for the reading {missing[0]}; accepted: a likelihood for every reading",
                where=place,
            )
        return [row[x] for x in readings]
    if isinstance(row, str) or not isinstance(row, Iterable):
        raise ShapeMismatchError(f"{row!r:.60}; accepted: a list of numbers", where=place)
    found = list(row)
    if len(found) != len(readings):
        raise ShapeMismatchError(
            f"{len(found)} likelihoods; accepted: {len(readings)}, one for each reading",
            where=place,
        )
    return found


def sensor_cost(cost: Any, kind: NumberKind) -> Number:
    """Return the cost of consulting a sensor as a number of its kind.

    Raises
    ------
    SensorError
        If it is negative, or a float beside exact likelihoods.

    Examples
    --------
    >>> sensor_cost("1/2", NumberKind.RATIONAL), sensor_cost("1/2", NumberKind.FLOAT)
    (mpq(1,2), 0.5)
    """
    try:
        exact = rational(cost)
    except FloatRefusedError:
        number: Number = cost if kind is NumberKind.FLOAT else -1
    else:
        number = float(exact) if kind is NumberKind.FLOAT else exact
    if not number >= 0:
        raise SensorError(
            f"{cost!r:.40}; accepted: a number of 0 or more, no float beside exact likelihoods",
            where="cost of a sensor",
        )
    return number
