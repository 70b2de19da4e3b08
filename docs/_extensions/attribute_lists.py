"""Attributes that share a line of a docstring, ``low, high : Angle``, become an entry each.

Napoleon splits such lines among parameters, but not among attributes.
"""

from __future__ import annotations

import re
from itertools import pairwise
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sphinx.application import Sphinx

_SHARED = re.compile(r"(\w+(?:, \w+)+) : (.*)")


def split_entries(lines: list[str]) -> list[str]:
    """Return the lines of a docstring with an entry for each attribute.

    Examples
    --------
    >>> docstring = ["Attributes", "----------", "a, b : int", "    Ends.", "c : int", "    Other."]
    >>> split_entries(docstring)[2:]
    ['a : int', '    Ends.', 'b : int', '    Ends.', 'c : int', '    Other.']
    """
    try:
        start = 2 + next(
            k for k, two in enumerate(pairwise(lines)) if two == ("Attributes", "-" * 10)
        )
    except StopIteration:
        return lines
    result, k = lines[:start], start
    while k < len(lines):
        end = k + 1
        while end < len(lines) and (not lines[end] or lines[end].startswith(" ")):
            end += 1
        shared = _SHARED.fullmatch(lines[k])
        for name in shared[1].split(", ") if shared else ():
            result += [f"{name} : {shared[2]}", *lines[k + 1 : end]]
        if not shared:
            result += lines[k:end]
        k = end
    return result


def process(app: Sphinx, what: str, name: str, value: Any, options: Any, lines: list[str]) -> None:  # noqa: ARG001
    """Change the lines of a docstring in place, as Sphinx asks for."""
    lines[:] = split_entries(lines)


def setup(app: Sphinx) -> dict[str, Any]:
    """Look at every docstring before napoleon does, which comes at 500."""
    app.connect("autodoc-process-docstring", process, priority=400)
    return {"version": "1", "parallel_read_safe": True}
