"""Recordings of a robot's trials, from CSV or JSON, and control models made of them.

A CSV file has a trial to a line, states and actions counted from 1::

    initial, action, final
    7, 1, 3
    7, 1, other

The first line may name the columns, in any order; a column ``count`` says how often the trial was
seen. Commas, semicolons, tabs and blanks separate; ``#`` begins a comment. The final state may be
``other``: none of the states.

JSON is a list of such rows, or the document that `stochgeom tilt simulate` writes::

    {"schema": "stochgeom/tilt-observations/1", "states": 12, "actions": 12, "other": true,
     "observations": [[INITIAL, ACTION, FINAL, COUNT], ...]}

with ``"alpha": "1/100"`` in it if it is to be a model with that Dirichlet parameter.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, final

from gmpy2 import mpq

from stochgeom.errors import FormatError
from stochgeom.exact.scalars import RationalLike, parse_rational, rational, rational_text
from stochgeom.io.exact_json import kind_of, load_json
from stochgeom.io.files import decode_text, naming, read_bytes, write_whole
from stochgeom.io.rings import shown
from stochgeom.tilting.counts import MOST_KINDS, OTHER, TransitionCounts, numbered
from stochgeom.tilting.estimation import ALPHA, TransitionModel

SCHEMA: Final = "stochgeom/tilt-observations/1"

ACCEPTED: Final = (
    "accepted: CSV with initial state, action, final state in each line, or JSON with a list of "
    '"observations"'
)

_COLUMNS: Final = ("initial", "action", "final", "count")
_SEPARATOR: Final = re.compile(r"\s*[,;\t]\s*|\s+")
_GAP: Final = re.compile(r"[\s,]*")
_KEYS: Final = frozenset(
    {"schema", "states", "actions", "other", "alpha", "observations", "simulation"}
)


@final
@dataclass(frozen=True, slots=True)
class Recording:
    """What a file holds.

    Attributes
    ----------
    counts : TransitionCounts
        The observations.
    alpha : mpq or None
        The Dirichlet parameter, if the file names one.
    simulation : dict or None
        What the file says of the simulation it comes from.
    """

    counts: TransitionCounts
    alpha: mpq | None = None
    simulation: Mapping[str, Any] | None = None

    def model(self, alpha: RationalLike | None = None) -> TransitionModel:
        """Return the control model, with `alpha` if given, else the file's, else 1/100."""
        chosen = alpha if alpha is not None else self.alpha
        return TransitionModel(self.counts, ALPHA if chosen is None else chosen)


def load_recording(path: str, states: int | None = None, actions: int | None = None) -> Recording:
    """Read a recording.

    Parameters
    ----------
    path : str
        A CSV or JSON file.
    states, actions : int, optional
        How many there are; by default what the file says, else 12.

    Raises
    ------
    ReadError
        If the file cannot be read.
    FormatError
        If it is neither CSV nor JSON of the form above.
    RecordingError
        If a line names a state or an action that does not exist, or a negative count.
    """
    content = read_bytes(path)
    with naming(path):
        return parse_recording(decode_text(content), states, actions)


def parse_recording(text: str, states: int | None = None, actions: int | None = None) -> Recording:
    r"""Return the recording that the content of a file describes; see `load_recording`.

    Examples
    --------
    >>> parse_recording("7,1,3\n7,1,other\n").counts
    <TransitionCounts: 12 actions, 12 states, 2 trials, 1 of them with another outcome>
    >>> parse_recording("initial,action,final\n7,1,3\n7,13,3\n")
    Traceback (most recent call last):
    ...
    stochgeom.errors.RecordingError: line 3: action '13'; accepted: 1 to 12
    """
    body = text.lstrip("\ufeff")
    if body.lstrip().startswith(("{", "[")):
        return _from_json(body, states, actions)
    rows, places = _csv_rows(body)
    other = any(row[2].casefold() == OTHER for row in rows)
    trials = [[*row[:2], row[2].casefold(), *row[3:]] for row in rows]
    counts = TransitionCounts.from_trials(
        trials, states or 12, actions or 12, other=other, places=places
    )
    return Recording(counts)


# --- CSV -----------------------------------------------------------------------------------------


def _csv_rows(text: str) -> tuple[list[list[str]], list[str]]:
    rows: list[list[str]] = []
    places: list[str] = []
    order: list[int] | None = None
    for number, line in enumerate(text.splitlines(), start=1):
        body = line.partition("#")[0].strip()
        if not body:
            continue
        fields, place = _SEPARATOR.split(body), f"line {number}"
        if order is None and not rows and fields[0][:1].isalpha():
            order = _header(fields, place)
            continue
        if len(fields) not in (3, 4) or (order is not None and len(fields) != len(order)):
            raise FormatError(
                f"{shown(body)}; accepted: initial state, action, final state, and perhaps a count",
                where=place,
            )
        rows.append(fields if order is None else [fields[k] for k in order])
        places.append(place)
    if not rows:
        raise FormatError(f"no trials; {ACCEPTED}")
    return rows, places


def _header(fields: Sequence[str], place: str) -> list[int]:
    names = [name.casefold() for name in fields]
    wanted = _COLUMNS[: len(names)]
    if len(names) < 3 or sorted(names) != sorted(wanted):
        raise FormatError(
            f"the columns {shown(', '.join(fields))}; accepted: initial, action, final, and "
            "perhaps count",
            where=place,
        )
    return [names.index(name) for name in wanted]


# --- JSON ----------------------------------------------------------------------------------------


def _from_json(text: str, states: int | None, actions: int | None) -> Recording:
    document = load_json(text, ACCEPTED)
    if isinstance(document, list):
        document = {"observations": document}
    unknown = sorted(set(document) - _KEYS)
    if unknown:
        raise FormatError(f"accepted keys: {', '.join(sorted(_KEYS))}", where=f"key {unknown[0]}")
    if document.get("schema", SCHEMA) != SCHEMA:
        raise FormatError(f"{kind_of(document['schema'])}; accepted: {SCHEMA}", where="key schema")
    rows = document.get("observations")
    if not isinstance(rows, list) or not rows:
        raise FormatError(f"{kind_of(rows)}; accepted: a list of trials", where="observations")
    places = _places(text, len(rows))
    for row, place in zip(rows, places, strict=True):
        if not isinstance(row, list) or not all(isinstance(entry, str) for entry in row):
            raise FormatError(
                f"{kind_of(row)}; accepted: [initial, action, final] or with a count", where=place
            )
    other = document.get("other", any(row[2:3] == [OTHER] for row in rows))
    if not isinstance(other, bool):
        raise FormatError(f"{kind_of(other)}; accepted: true or false", where="key other")
    counts = TransitionCounts.from_trials(
        rows,
        states or _size(document, "states"),
        actions or _size(document, "actions"),
        other=other,
        places=places,
    )
    return Recording(counts, _alpha(document), document.get("simulation"))


def _size(document: Mapping[str, Any], key: str) -> int:
    if key not in document:
        return 12
    return numbered(document[key], MOST_KINDS, f"number of {key}", f"key {key}")


def _alpha(document: Mapping[str, Any]) -> mpq | None:
    value = document.get("alpha")
    if value is None:
        return None
    if not isinstance(value, str):
        raise FormatError(f"{kind_of(value)}; accepted: a number", where="key alpha")
    return parse_rational(value, where="key alpha")


def _places(text: str, count: int) -> list[str]:
    """Return the line where each observation begins; its number, should that not be found."""
    decoder, places = json.JSONDecoder(), []
    start = re.match(r"\s*\[", text) or re.search(r'"observations"\s*:\s*\[', text)
    position = start.end() if start else len(text)
    line, seen = 1, 0
    try:
        for _ in range(count):
            gap = _GAP.match(text, position)
            position = gap.end() if gap else position
            line, seen = line + text.count("\n", seen, position), position
            places.append(f"line {line}")
            _, position = decoder.raw_decode(text, position)
    except ValueError:
        return [f"observation {k}" for k in range(count)]
    return places


# --- writing -------------------------------------------------------------------------------------


def recording_document(
    counts: TransitionCounts,
    alpha: RationalLike | None = None,
    simulation: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Return the document of a recording, or of a model if alpha is given."""
    document: dict[str, Any] = {
        "schema": SCHEMA,
        "states": counts.states,
        "actions": counts.actions,
        "other": counts.has_other,
    }
    if alpha is not None:
        document["alpha"] = rational_text(rational(alpha, where="alpha"))
    if simulation is not None:
        document["simulation"] = dict(simulation)
    return {**document, "observations": [list(trial) for trial in counts.trials()]}


def save_recording(path: str, document: Mapping[str, Any]) -> None:
    """Write a recording's document, an observation to a line.

    Raises
    ------
    WriteError
        If the file cannot be written.
    """
    head = json.dumps({k: v for k, v in document.items() if k != "observations"}, indent=1)
    rows = ",\n  ".join(json.dumps(row) for row in document["observations"])
    write_whole(path, f'{head[:-2]},\n "observations": [\n  {rows}\n ]\n}}\n')
