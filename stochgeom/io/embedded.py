"""JSON documents inside HTML pages: data blocks that no browser runs and any program can read.

A block is ``<script type="application/json" id="NAME">``, its document in ASCII and with no ``<``,
so that it ends at the next ``</script>``.
"""

from __future__ import annotations

import json
import re
from typing import Any, Final

_OPENING: Final = '<script type="application/json" id="{}">'
_ENDING: Final = "</script>"

CERTIFICATE: Final = "stochgeom-certificate"
PLAN: Final = "stochgeom-plan"


def data_block(name: str, document: dict[str, Any]) -> str:
    r"""Return a document as a block of an HTML page.

    Examples
    --------
    >>> print(data_block("note", {"text": "</script>"}))
    <script type="application/json" id="note">
    {"text":"\u003c/script>"}
    </script>
    """
    text = json.dumps(document, separators=(",", ":")).replace("<", "\\u003c")
    return f"{_OPENING.format(name)}\n{text}\n{_ENDING}"


def find_block(page: bytes, name: str) -> bytes | None:
    """Return the JSON text of the first block of that name, None if the page has none.

    Examples
    --------
    >>> find_block(data_block("note", {"a": "1"}).encode(), "note")
    b'{"a":"1"}'
    """
    pattern = re.escape(_OPENING.format(name)) + "(.*?)" + re.escape(_ENDING)
    found = re.search(pattern.encode(), page, re.DOTALL)
    return found[1].strip() if found else None


def is_page(content: bytes) -> bool:
    """Tell whether a file begins like an HTML page.

    Examples
    --------
    >>> is_page(b"<!DOCTYPE html>"), is_page(b'{"schema": 1}')
    (True, False)
    """
    return content.lstrip()[:15].lower().startswith((b"<!doctype html", b"<html"))
