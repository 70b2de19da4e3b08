"""A folder of results that is written whole or not at all."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
from pathlib import Path
from types import TracebackType

from stochgeom.errors import WriteError
from stochgeom.io.files import write_whole


class ResultFolder:
    """Collects files in a hidden folder inside the target and moves them out at the end.

    If the work fails, nothing appears, and a folder that was made for it is gone again. Files of
    other names that stand in the target are left alone.

    Parameters
    ----------
    path : str
        The target; made if it is missing.

    Raises
    ------
    WriteError
        On entering: if the target cannot be made, is no folder, or is not writable.
    """

    def __init__(self, path: str) -> None:
        self.path = path
        self._target = Path(path)
        self._made: list[Path] = []
        self._staging = Path()

    def __enter__(self) -> ResultFolder:
        try:
            missing = [p for p in (self._target, *self._target.parents) if not p.exists()]
            self._target.mkdir(parents=True, exist_ok=True)
            self._made = missing
            self._staging = Path(tempfile.mkdtemp(prefix=".reproduce-", dir=self._target))
        except (OSError, ValueError) as error:
            self._forget()
            reason = getattr(error, "strerror", None) or error
            raise WriteError(
                f"cannot be written: {reason}; accepted: a writable folder, or one that can be "
                "made",
                where=self.path,
            ) from error
        return self

    def path_of(self, name: str) -> Path:
        """Return where a file is written to before it is moved."""
        return self._staging / name

    def write(self, name: str, text: str) -> str:
        """Write a text file and return its name."""
        write_whole(self.path_of(name), text)
        return name

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            if kind is None:
                self._publish()
        finally:
            shutil.rmtree(self._staging, ignore_errors=True)
            if kind is not None:
                self._forget()

    def _publish(self) -> None:
        """Move the files out, after a look whether something stands in the way."""
        moves = [(file, self._target / file.name) for file in sorted(self._staging.iterdir())]
        for _, goal in moves:
            if goal.is_dir():
                raise WriteError(
                    "cannot be written: a folder of that name stands there; accepted: a folder "
                    "for results without it",
                    where=str(goal),
                )
        for file, goal in moves:
            try:
                file.replace(goal)
            except OSError as error:
                raise WriteError(
                    f"cannot be written: {error.strerror or error}; accepted: a file in a "
                    "writable folder",
                    where=str(goal),
                ) from error

    def _forget(self) -> None:
        """Remove the folders that were made, if they are empty."""
        for folder in self._made:
            with contextlib.suppress(OSError):
                folder.rmdir()
