"""Where the source does not agree with itself or with its own definitions.

Each entry says what is printed, what holds, and why; `tests/thesis` recomputes or proves every
entry it cites.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final


@final
@dataclass(frozen=True, slots=True)
class Erratum:
    """One disagreement.

    Attributes
    ----------
    where : str
        Table cell, equation or figure.
    printed, holds, reason : str
        What the source prints, what is true, and the argument.
    """

    where: str
    printed: str
    holds: str
    reason: str


TABLE_4_1: Final = {
    ("4gon", 3): Erratum(
        "Table 4.1, 4gon, 3-step",
        "16.0",
        "about 10.6 for the rebuilt part, at most 11.0 for any part with the printed Fig. 4.6",
        "the last two squeezes of Fig. 4.6 merge two states that are not neighbours, and a "
        "monotone map that merges two states merges all between them (Lemma 5.1); so a random "
        "squeeze and these two bring at least .14 + .11 + .13 - .015 = .365 together, at a cost "
        "of at most 4 / .365; 16.0 is 4 / .25, read off the trace of the 4-step plan",
    ),
    ("key", 3): Erratum(
        "Table 4.1, key, 3-step",
        "8.2",
        "8.0",
        "6.2 at two steps means h_2 >= 172.8 degrees; an arc of 180 degrees misses one gap between "
        "neighbouring stable orientations in its image, so three steps collapse it once some gap "
        "exceeds 180 - h_2 <= 7.2 degrees; at most 11 gaps share 180 degrees, so the largest is "
        "more than 16.3",
    ),
}
"""Cells of Table 4.1 that no part with the rest of the printed numbers can have."""
