"""Planning problems as JSON documents: the schema ``stochgeom/problem/1``.

A document is an object with the keys

- ``schema``: ``"stochgeom/problem/1"``, may be left out;
- ``name``: text, may be left out;
- ``numbers``: ``"exact"`` (the default: 0.1 is one tenth) or ``"float"``;
- ``states``, ``actions``: lists of text;
- ``prior``: a list of numbers in the order of the states, or an object that names the states whose
  probability is not 0;
- ``transitions``: an object, for each action a list of rows, or an object of rows by state; a row
  is a list or an object as the prior is;
- ``cost``: see `stochgeom.io.cost_json`; may be left out;
- ``sensors``: see `stochgeom.io.sensors_json`; may be left out, and is left to it.

Numbers are JSON numbers or text such as ``"1/3"``. An exact number may be a sum of angles in full
turns, ``{"constant": "1/3", "angles": [["1/2", {"turns": "0", "direction": ["3", "2"]}]]}``.
Everything is written as text, so that it reads back exactly, floats included.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from stochgeom.decision.number_kinds import NumberKind, as_float
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import FormatError, ProblemError, StochgeomError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import parse_rational, rational_text
from stochgeom.exact.sums import AngleSum
from stochgeom.io.cost_json import cost_from_json, cost_to_json
from stochgeom.io.exact_json import kind_of, load_json
from stochgeom.io.files import decode_text, naming, read_bytes
from stochgeom.io.rings import shown

SCHEMA: Final = "stochgeom/problem/1"

ACCEPTED: Final = 'accepted: a JSON object with "states", "prior", "actions" and "transitions"'
_KEYS: Final = (
    *("schema", "name", "numbers", "states", "prior", "actions", "transitions"),
    *("cost", "sensors"),
)

Json = dict[str, Any]


def load_problem(path: str) -> PlanningProblem:
    """Return the problem that a file holds.

    Raises
    ------
    ReadError, FormatError
        If there is no such file, or it is no document of the schema; the place is named.
    ProblemError
        If the problem is not well formed.
    """
    content = read_bytes(path)
    with naming(path):
        return parse_problem(decode_text(content))


def parse_problem(text: str) -> PlanningProblem:
    r"""Return the problem that a JSON text describes.

    Examples
    --------
    >>> parse_problem('''{
    ...   "states": ["heads", "tails"], "prior": {"heads": 1}, "actions": ["throw"],
    ...   "transitions": {"throw": [[0.5, 0.5], ["1/2", "1/2"]]}
    ... }''').run(["throw"])
    (mpq(1,2), mpq(1,2))
    """
    return problem_from_json(load_json(text.lstrip("\ufeff"), ACCEPTED))


def problem_from_json(document: Any) -> PlanningProblem:
    """Return the problem of a document that `stochgeom.io.exact_json.load_json` has read.

    Raises
    ------
    FormatError
        If a key is missing, unknown, or holds something else than it should.
    """
    if not isinstance(document, dict):
        raise FormatError(f"{kind_of(document)}; {ACCEPTED}")
    if document.get("schema", SCHEMA) != SCHEMA:
        raise FormatError(f"{kind_of(document['schema'])}; accepted: {SCHEMA}", where="schema")
    for key in document:
        if key not in _KEYS:
            raise FormatError(f"accepted keys: {', '.join(_KEYS)}", where=f"key {shown(key)}")
    for key in ("states", "prior", "actions", "transitions"):
        if key not in document:
            raise FormatError(f"missing; {ACCEPTED}", where=f"key {key}")
    numbers = document.get("numbers", "exact")
    if numbers not in ("exact", "float"):
        raise FormatError(f"{kind_of(numbers)}; accepted: exact, float", where="numbers")
    name = document.get("name")
    if name is not None and not isinstance(name, str):
        raise FormatError(f"{kind_of(name)}; accepted: text", where="name")
    reader = NumberReader(is_float=numbers == "float")
    cost = document.get("cost")
    problem = PlanningProblem(
        _labels(document["states"], "states"),
        reader.row(document["prior"], "prior"),
        _labels(document["actions"], "actions"),
        reader.tables(document["transitions"]),
        None if cost is None else cost_from_json(cost, reader.number),
        name=name,
    )
    if problem.cost is not None:
        problem.cost.on(problem)  # names in it that the problem does not have are found here
    return problem


class NumberReader:
    """Reads numbers of one kind, alone, in rows and in tables."""

    def __init__(self, *, is_float: bool) -> None:
        self._is_float = is_float

    def number(self, value: Any, place: str) -> Any:
        """Return a number; `place` is where it stands."""
        if isinstance(value, dict) and not self._is_float:
            return _read_sum(value, place)
        if not isinstance(value, str):
            raise FormatError(f"{kind_of(value)}; accepted: a number, or its text", where=place)
        exact = parse_rational(value, where=place)
        return as_float(exact, place) if self._is_float else exact

    def row(self, value: Any, place: str) -> Any:
        """Return a list of numbers, or numbers by label."""
        if isinstance(value, dict):
            return {key: self.number(v, f"{place}, {shown(key)}") for key, v in value.items()}
        if not isinstance(value, list):
            raise FormatError(f"{kind_of(value)}; accepted: a list or an object", where=place)
        return [self.number(v, f"{place}, entry {k}") for k, v in enumerate(value)]

    def tables(self, value: Any) -> dict[str, Any]:
        """Return the rows of each action."""
        if not isinstance(value, dict):
            raise FormatError(
                f"{kind_of(value)}; accepted: an object with rows for each action",
                where="transitions",
            )
        tables: dict[str, Any] = {}
        for action, table in value.items():
            place = f"transitions, action {shown(action)}"
            if isinstance(table, dict):
                tables[action] = {
                    state: self.row(row, f"{place}, row {shown(state)}")
                    for state, row in table.items()
                }
            elif isinstance(table, list):
                tables[action] = [self.row(row, f"{place}, row {k}") for k, row in enumerate(table)]
            else:
                raise FormatError(
                    f"{kind_of(table)}; accepted: a list or an object of rows", where=place
                )
        return tables


def _labels(value: Any, place: str) -> list[str]:
    if not isinstance(value, list):
        raise FormatError(f"{kind_of(value)}; accepted: a list of text", where=place)
    for k, label in enumerate(value):
        if not isinstance(label, str):
            raise FormatError(f"{kind_of(label)}; accepted: text", where=f"{place}, entry {k}")
    return [str(label) for label in value]


def _read_sum(value: Json, place: str) -> AngleSum:
    if not set(value) <= {"constant", "angles", "decimal"}:
        raise FormatError("accepted: an object with constant and angles", where=place)
    terms = []
    for k, pair in enumerate(value.get("angles", [])):
        where = f"{place}, angle {k}"
        try:
            factor, angle = pair
            x, y = angle["direction"]
            turns = angle.get("turns", "0")
            numbers = [parse_rational(n, where=where) for n in (factor, turns, x, y)]
        except (TypeError, ValueError, KeyError, AttributeError) as error:
            if isinstance(error, StochgeomError):
                raise
            raise FormatError(
                f'{kind_of(pair)}; accepted: [FACTOR, {{"turns": T, "direction": [X, Y]}}]',
                where=where,
            ) from None
        terms.append((numbers[0], Angle(numbers[1], (numbers[2], numbers[3]))))
    return AngleSum(parse_rational(value.get("constant", "0"), where=place), terms)


# --- writing -------------------------------------------------------------------------------------


def problem_document(problem: PlanningProblem) -> Json:
    """Return the document of a problem; reading it gives an equal problem.

    Raises
    ------
    ProblemError
        If a label is no text, or the cost is of a kind that has no document.

    Examples
    --------
    >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
    >>> document = problem_document(turn)
    >>> document["prior"], document["transitions"]["turn"]
    (['1/4', '3/4'], [['0', '1'], ['1', '0']])
    >>> problem_from_json(document) == turn
    True
    """
    check_problem(problem)
    for what, labels in (("state", problem.states), ("action", problem.actions)):
        for label in labels:
            if not isinstance(label, str):
                raise ProblemError(
                    f"the label {label!r:.40} is no text; accepted: text, to be written to a file",
                    where=what,
                )
    document: Json = {"schema": SCHEMA}
    if problem.name is not None:
        document["name"] = problem.name
    if problem.numbers is NumberKind.FLOAT:
        document["numbers"] = "float"
    document["states"] = list(problem.states)
    document["prior"] = [number_json(p) for p in problem.prior]
    document["actions"] = list(problem.actions)
    document["transitions"] = {
        action: [[number_json(p) for p in row] for row in problem.matrix(action)]
        for action in problem.actions
    }
    if problem.cost is not None:
        document["cost"] = cost_to_json(problem.cost, number_json)
    return document


def number_json(value: Any) -> Any:
    """Return a number of any kind as text that reads back exactly, or as an object of angles."""
    if isinstance(value, AngleSum):
        if not value.terms:
            return rational_text(value.constant)
        return {
            "constant": rational_text(value.constant),
            "angles": [[rational_text(q), _angle(angle)] for q, angle in value.terms],
            "decimal": value.decimal(4),
        }
    if isinstance(value, float):
        return repr(float(value))
    return str(value) if isinstance(value, str) else rational_text(value)


def _angle(angle: Angle) -> Mapping[str, Any]:
    return {
        "turns": rational_text(angle.turn_part),
        "direction": [str(number) for number in angle.direction],
    }
