"""Vectors and matrices as they are given: their shapes, their labels, their sums."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, Final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import Number, NumberKind, numbered, read_number
from stochgeom.errors import NotStochasticError, ShapeMismatchError
from stochgeom.exact.angle_base import AngleBase
from stochgeom.exact.sums import AngleSum

ROW_TOLERANCE: Final = 1e-9
"""How far the sum of a float distribution may be from 1. Exact ones sum to exactly 1."""


def listed(values: Any, labels: Labels, place: str) -> list[Any]:
    """Return one entry for each label, from a sequence, or from a mapping that leaves out zeros.

    Raises
    ------
    ShapeMismatchError
        If there are too few or too many.
    UnknownLabelError
        If a mapping has a key that is no label.

    Examples
    --------
    >>> listed({"b": 1}, Labels("a b c".split(), "state"), "prior")
    [0, 1, 0]
    """
    if isinstance(values, Mapping):
        listed: list[Any] = [0] * len(labels)
        for label, value in values.items():
            listed[labels.number(label, where=place)] = value
        return listed
    found = _items(values, place)
    if len(found) != len(labels):
        raise ShapeMismatchError(
            f"{len(found)} probabilities; accepted: {len(labels)}, one for each state", where=place
        )
    return found


def listed_tables(transitions: Any, actions: Labels, states: Labels) -> list[list[list[Any]]]:
    """Return for each action its rows, in the orders of the labels.

    Raises
    ------
    ShapeMismatchError
        If a matrix, a row or an entry is missing or one too many.
    UnknownLabelError
        If there is a matrix for an action that does not exist.
    """
    if isinstance(transitions, Mapping):
        for label in transitions:
            actions.number(label, where="transitions")
        missing = [label for label in actions if label not in transitions]
        if missing:
            raise ShapeMismatchError(
                f"no matrix; accepted: one for each of the {len(actions)} actions",
                where=f"action {named(missing[0])}",
            )
        given = [transitions[label] for label in actions]
    else:
        given = _items(transitions, "transitions")
        if len(given) != len(actions):
            raise ShapeMismatchError(
                f"{len(given)} matrices; accepted: {len(actions)}, one for each action",
                where="transitions",
            )
    tables = []
    for label, table in zip(actions, given, strict=True):
        place = f"action {named(label)}"
        rows = (
            _rows_by_state(table, states, place)
            if isinstance(table, Mapping)
            else (_items(table, place))
        )
        if len(rows) != len(states):
            raise ShapeMismatchError(
                f"{len(rows)} rows; accepted: {len(states)}, one for each state", where=place
            )
        tables.append(
            [
                listed(row, states, f"{place}, row {named(state)}")
                for state, row in zip(states, rows, strict=True)
            ]
        )
    return tables


def _rows_by_state(table: Mapping[Any, Any], states: Labels, place: str) -> list[Any]:
    for state in table:
        states.number(state, where=place)
    for state in states:
        if state not in table:
            raise ShapeMismatchError(
                "no row; accepted: one for each state", where=f"{place}, row {named(state)}"
            )
    return [table[state] for state in states]


def _items(values: Any, place: str) -> list[Any]:
    if isinstance(values, np.ndarray):
        return list(values)
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise ShapeMismatchError(f"{values!r:.60}; accepted: a list", where=place)
    return list(values)


def distribution(values: list[Any], kind: NumberKind, place: str) -> list[Number]:
    """Return numbers of a kind that are not negative and sum to 1.

    Raises
    ------
    NotStochasticError
        If they do not; the entry or the sum is told.

    Examples
    --------
    >>> distribution(["1/2", 0.25], NumberKind.FLOAT, "prior")
    Traceback (most recent call last):
    ...
    stochgeom.errors.NumberError: prior, entry 0: '1/2' is not a finite float; accepted: a number
    """
    shares = [read_number(value, kind, where) for value, where in numbered(values, place)]
    for k, share in enumerate(shares):
        if share < 0:
            raise NotStochasticError(
                f"probability {share} is negative; accepted: 0 or more", where=f"{place}, entry {k}"
            )
    if kind is NumberKind.FLOAT:
        total: Any = math.fsum(shares)
        sums_to_one = abs(total - 1) <= ROW_TOLERANCE
    else:
        total = sum(shares, start=mpq(0))
        sums_to_one = total == 1
    if not sums_to_one:
        raise NotStochasticError(
            f"the sum is {total}; accepted: probabilities of sum 1", where=place
        )
    if kind is NumberKind.ANGLE_SUMS:
        base = AngleBase(map(AngleSum.of, shares))  # then equal sums of them look equal, too
        return [base.write(AngleSum.of(share)) for share in shares]
    return shares
