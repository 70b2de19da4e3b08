"""Notes beneath a table: why a printed value does not hold."""

from __future__ import annotations

from collections.abc import Sequence

from stochgeom.thesis.errata import Erratum


def notes_text(notes: Sequence[Erratum | None]) -> list[str]:
    r"""Return a numbered line for each note, after an empty one; None is what nothing explains.

    Examples
    --------
    >>> notes_text([None])
    ['\n(1) differs, and no erratum explains it']
    """
    return [
        f"\n({place}) differs, and no erratum explains it"
        if note is None
        else f"\n({place}) {note.where}: printed {note.printed}; what holds: {note.holds}; "
        f"{note.reason}."
        for place, note in enumerate(notes, start=1)
    ]
