"""Plain text tables."""

from __future__ import annotations

from collections.abc import Sequence


def table(header: Sequence[str], rows: Sequence[Sequence[str]], *, left: Sequence[int] = ()) -> str:
    """Return rows under a header, columns right aligned except those in `left`.

    Examples
    --------
    >>> print(table(["part", "cost"], [["house", "5.0"], ["key", "16.2"]], left=[0]))
      part   cost
      house   5.0
      key    16.2
    """
    lines = [list(header), *map(list, rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(header))]
    return "\n".join(
        "  "
        + "  ".join(
            cell.ljust(width) if k in left else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in lines
    )


def count(number: int, noun: str) -> str:
    """Return ``"1 squeeze"`` or ``"4 squeezes"``.

    Examples
    --------
    >>> count(1, "squeeze"), count(2, "filter pass"), count(3, "erratum")
    ('1 squeeze', '2 filter passes', '3 errata')
    """
    if number == 1:
        return f"1 {noun}"
    if noun == "erratum":
        return f"{number} errata"
    return f"{number} {noun}es" if noun.endswith(("s", "sh", "ch")) else f"{number} {noun}s"
