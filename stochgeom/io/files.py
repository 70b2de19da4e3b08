"""Reading text files with limits; writing files whole or not at all."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from stochgeom.arguments import expect
from stochgeom.errors import FormatError, ReadError, StochgeomError, WriteError
from stochgeom.io.rings import showable

MAX_BYTES: Final = 64 * 2**20
"""Largest file that is read, in bytes of UTF-8."""


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Return the content of a file.

    Raises
    ------
    ReadError
        If it is missing, unreadable or larger than `MAX_BYTES`.
    """
    try:
        source = Path(os.fsdecode(path))
    except TypeError:
        raise ReadError(f"{path!r:.60} is no path; accepted: text, or a pathlib.Path") from None
    place = showable(os.fsdecode(path)) or "''"
    try:
        with source.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: a null character in the path
        reason = getattr(error, "strerror", None) or error
        raise ReadError(
            f"cannot be read: {reason}; accepted: a readable text file", where=place
        ) from error
    if len(content) > MAX_BYTES:
        raise ReadError(f"larger than accepted: at most {MAX_BYTES} bytes", where=place)
    return content


@contextmanager
def naming(path: str | os.PathLike[str]) -> Iterator[None]:
    """Name the file in every error about its content: several may stand on one command line.

    Examples
    --------
    >>> with naming("part.txt"):
    ...     raise FormatError("'1' has 1 field; accepted: two numbers", where="line 3")
    Traceback (most recent call last):
    ...
    stochgeom.errors.FormatError: part.txt, line 3: '1' has 1 field; accepted: two numbers
    """
    try:
        yield
    except StochgeomError as error:
        raise error.within(showable(os.fsdecode(path))) from None


def decode_text(content: bytes) -> str:
    """Return the text of a file's bytes.

    Raises
    ------
    FormatError
        If the bytes are not UTF-8; the place is the offset of the first byte that is not.

    Examples
    --------
    >>> decode_text(b"0 0")
    '0 0'
    """
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        raise FormatError(
            f"byte 0x{content[error.start]:02x} is not UTF-8; accepted: UTF-8 text",
            where=f"byte {error.start}",
        ) from None


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write text or bytes so that the file is never half there: beside the target, then renamed.

    A link is followed. What is no file, such as a pipe or a terminal, is written to and never
    replaced.

    Raises
    ------
    InputError
        If the path is none.
    WriteError
        If the folder is missing or not writable; what stood there before still does.
    """
    expect(path, str | os.PathLike, "the path of a file", "file")
    temporary: str | None = None
    try:
        data = content.encode("utf-8") if isinstance(content, str) else content
        target = Path(path)
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if target.exists() and not target.is_file():
            target.write_bytes(data)
            return
        target = target.resolve()
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:50]}-")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        mask = os.umask(0)  # the only way to read it
        os.umask(mask)
        Path(temporary).chmod(0o666 & ~mask)
        Path(temporary).replace(target)
    except (OSError, ValueError, RuntimeError) as error:  # RuntimeError: a link in a circle
        if temporary is not None:
            Path(temporary).unlink(missing_ok=True)
        reason = getattr(error, "strerror", None) or error
        raise WriteError(
            f"cannot be written: {reason}; accepted: a file in a writable folder",
            where=os.fspath(path) or "''",
        ) from error
