"""What commands print on standard output: text for people, documents for machines."""

from __future__ import annotations

import json
import sys
from typing import Any


def write(text: str) -> None:
    """Print text; characters that the encoding of the output lacks become escapes."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    print(text.encode(encoding, "backslashreplace").decode(encoding))


def write_json(document: dict[str, Any], *, indent: int | None = 1) -> None:
    """Print a document in ASCII, so that it reads the same in every encoding."""
    print(json.dumps(document, indent=indent))
