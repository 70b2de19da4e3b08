"""Sensors in the documents of planning problems: the key ``sensors`` of ``stochgeom/problem/1``.

An object, for each sensor an object with the keys

- ``readings``: a list of text;
- ``likelihood``: for each state a row, in a list or an object as transitions are; an entry for each
  reading, in a list or an object;
- ``cost``: a number, what a look costs; may be left out, then looks are free.

Numbers are read as those of the problem.
"""

from __future__ import annotations

from typing import Any, Final

from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import FormatError, ProblemError
from stochgeom.io.exact_json import kind_of, load_json
from stochgeom.io.files import decode_text, naming, read_bytes
from stochgeom.io.problem_json import ACCEPTED, NumberReader, number_json, problem_from_json
from stochgeom.io.rings import shown
from stochgeom.sensing.sensors import Sensor

_KEYS: Final = ("readings", "likelihood", "cost")

Json = dict[str, Any]


def load_sensed_problem(path: str) -> tuple[PlanningProblem, dict[str, Sensor]]:
    """Return the problem that a file holds, and its sensors by name.

    Raises
    ------
    ReadError, FormatError
        If there is no such file, or it is no document of the schema; the place is named.
    ProblemError
        If the problem, or a sensor, is not well formed.
    """
    content = read_bytes(path)
    with naming(path):
        return parse_sensed_problem(decode_text(content))


def parse_sensed_problem(text: str) -> tuple[PlanningProblem, dict[str, Sensor]]:
    r"""Return the problem, and the sensors, that a JSON text describes.

    Examples
    --------
    >>> problem, sensors = parse_sensed_problem('''{
    ...   "states": ["up", "down"], "prior": [0.5, 0.5], "actions": ["turn"],
    ...   "transitions": {"turn": [[0, 1], [1, 0]]},
    ...   "sensors": {"eye": {"readings": ["up", "down"], "cost": "1/8",
    ...                       "likelihood": {"up": [0.9, 0.1], "down": {"up": 0.1, "down": 0.9}}}}
    ... }''')
    >>> sensors["eye"].posterior(problem.prior, "up")
    (mpq(9,10), mpq(1,10))
    """
    document = load_json(text.lstrip("\ufeff"), ACCEPTED)
    problem = problem_from_json(document)
    given = document.get("sensors", {})
    if not isinstance(given, dict):
        raise FormatError(f"{kind_of(given)}; accepted: an object of sensors", where="sensors")
    reader = NumberReader(is_float=not problem.exact)
    return problem, {name: _sensor(name, each, problem, reader) for name, each in given.items()}


def _sensor(name: str, document: Any, problem: PlanningProblem, reader: NumberReader) -> Sensor:
    place = f"sensors, {shown(name)}"
    if not isinstance(document, dict):
        raise FormatError(f"{kind_of(document)}; accepted: an object", where=place)
    for key in document:
        if key not in _KEYS:
            raise FormatError(
                f"accepted keys: {', '.join(_KEYS)}", where=f"{place}, key {shown(key)}"
            )
    for key in ("readings", "likelihood"):
        if key not in document:
            raise FormatError("missing; a sensor needs it", where=f"{place}, key {key}")
    readings, table = document["readings"], document["likelihood"]
    if not isinstance(readings, list) or not all(isinstance(x, str) for x in readings):
        raise FormatError(
            f"{kind_of(readings)}; accepted: a list of text", where=f"{place}, readings"
        )
    if not isinstance(table, dict | list):
        raise FormatError(
            f"{kind_of(table)}; accepted: a list or an object of rows",
            where=f"{place}, likelihood",
        )
    rows = table.items() if isinstance(table, dict) else enumerate(table)
    read = {k: reader.row(row, f"{place}, likelihood, {shown(str(k))}") for k, row in rows}
    try:
        return Sensor(
            [str(x) for x in readings],
            read if isinstance(table, dict) else list(read.values()),
            states=problem.states,
            cost=reader.number(document.get("cost", "0"), f"{place}, cost"),
            name=name,
        )
    except ProblemError as error:
        raise error.within(place) from None


def sensors_document(sensors: dict[str, Sensor]) -> Json:
    """Return sensors as the document of a problem holds them.

    Raises
    ------
    ProblemError
        If a reading or a state is no text.

    Examples
    --------
    >>> sensors_document({"eye": Sensor.noisy(["up", "down"], "1/10", cost=2)})["eye"]["likelihood"]
    {'up': ['9/10', '1/10'], 'down': ['1/10', '9/10']}
    """
    document: Json = {}
    for name, sensor in sensors.items():
        for what, labels in (("reading", sensor.readings), ("state", sensor.states)):
            for label in labels:
                if not isinstance(label, str):
                    raise ProblemError(
                        f"the label {label!r:.40} is no text; accepted: text, to be written to a "
                        "file",
                        where=what,
                    )
        document[name] = {
            "readings": list(sensor.readings),
            "likelihood": {
                state: [number_json(p) for p in row]
                for state, row in zip(sensor.states, sensor.likelihood, strict=True)
            },
            "cost": number_json(sensor.cost),
        }
    return document
