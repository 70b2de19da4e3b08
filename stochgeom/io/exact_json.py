"""JSON whose numbers are kept as their text, so that 0.1 stays one tenth."""

from __future__ import annotations

import json
from typing import Any

from stochgeom.errors import FormatError
from stochgeom.io.rings import shown


class NumberText(str):
    """The text of a JSON number, told apart from a JSON string."""

    __slots__ = ()


def load_json(text: str, accepted: str) -> Any:
    """Parse JSON, its numbers as `NumberText`; NaN and infinity among them, for others to refuse.

    Parameters
    ----------
    text : str
        A JSON document.
    accepted : str
        What would have been: the end of the messages.

    Raises
    ------
    FormatError
        For broken JSON, JSON nested too deeply, and a key that stands twice in one object.

    Examples
    --------
    >>> load_json('{"weight": 0.10}', "accepted: JSON")
    {'weight': '0.10'}
    """
    try:
        return json.loads(
            text,
            parse_int=NumberText,
            parse_float=NumberText,
            parse_constant=NumberText,
            object_pairs_hook=_without_repeats,
        )
    except json.JSONDecodeError as error:
        # Only the reason is told here: its place goes into `where`.
        end = " (the text ends here)" if error.pos >= len(text.rstrip()) else ""
        raise FormatError(
            f"broken JSON: {error.msg}{end}; {accepted}",
            where=f"line {error.lineno}, column {error.colno}",
        ) from None
    except RecursionError:
        raise FormatError(f"JSON nested too deeply; {accepted}") from None


def _without_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for key, value in pairs:
        if key in result:
            raise FormatError(
                "this key stands twice in one object; accepted: each key once",
                where=f"key {shown(key)}",
            )
        result[key] = value
    return result


def kind_of(value: Any) -> str:
    """Say what a JSON value is; never its whole content, which may be long or deep.

    Examples
    --------
    >>> kind_of([1, 2]), kind_of("a"), kind_of(None)
    ('a list of 2', "the text 'a'", 'null')
    """
    if isinstance(value, NumberText):
        return f"the number {value[:20]}"
    if isinstance(value, str):
        return f"the text {shown(value)}"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    if isinstance(value, dict):
        return "an object"
    return {None: "null", True: "true", False: "false"}[value]
