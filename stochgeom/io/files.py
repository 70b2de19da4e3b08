"""Writing files whole or not at all."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from stochgeom.errors import WriteError


def write_whole(path: str, text: str) -> None:
    """Write a text file so that it is never half there: beside the target, then renamed.

    Raises
    ------
    WriteError
        If the folder is missing or not writable; what stood there before still does.
    """
    target = Path(path)
    temporary: str | None = None
    try:
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:50]}-")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        mask = os.umask(0)  # the only way to read it
        os.umask(mask)
        Path(temporary).chmod(0o666 & ~mask)
        Path(temporary).replace(target)
    except (OSError, ValueError) as error:
        if temporary is not None:
            Path(temporary).unlink(missing_ok=True)
        reason = getattr(error, "strerror", None) or error
        raise WriteError(
            f"cannot be written: {reason}; accepted: a file in a writable folder", where=path
        ) from error
