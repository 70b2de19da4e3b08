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

TABLE_C_1: Final = {
    ("rectangle", "0.05"): Erratum(
        "Table C.1, rectangle, mu = .05",
        "0.99",
        "0.9978, which rounds to 1.00",
        "no rectangle has .99 there and the two other cells of its row: the cell is capped or cut; "
        "every other cell of the table is rounded",
    ),
}
"""Cells of Table C.1 that do not follow from the rest."""

GRASP_TABLE_SIDES: Final = Erratum(
    "Tables 3.1 and C.1, rectangle, sides",
    "3",
    "4",
    "a rectangle has four; Table 4.1 prints 4",
)

EQUATION_3_14: Final = Erratum(
    "Eq. 3.14",
    "0 for even n from floor(pi / alpha) on",
    "0 for even n exactly when n alpha is at least pi",
    "n = 12 at mu = .25 is floor(pi / alpha), and 12 alpha is 168.4 degrees: the bound is .0643",
)

LIMIT_OF_3_13: Final = Erratum(
    "1.5, 3.1, 3.11, 3.12 and 7.4, the bound as friction goes to 0",
    "goes to 1",
    "has a limit that depends on the part, and is 1 at mu = 0 only",
    "the bound of App. C goes to 1, and Eq. 3.13's does for parts such as even regular polygons; "
    "where a push of some length may end within a vanishing wedging interval it stays below: 0 for "
    "the triangle, the 4gon and the key, .0704 for the wrench, .5 for the house",
)

APPENDIX_C_TEXT: Final = Erratum(
    "App. C, text on the two bounds and on the density",
    "equal only when friction is so high that almost all is wedged; an exponential density",
    "both are 1 without friction, where nothing wedges; a logarithmic density",
    "Eq. C.9 exceeds C.8 by the factor 1 + ln(L / b), which is 1 at b = L: no wedging interval "
    "between the stable and the unstable orientation; and the density is ln(L / x)",
)

APPENDIX_E: Final = {
    "angles": Erratum(
        "Fig. E.5, plan angles",
        "25, 79, -23",
        "-42, -95 and -144 for the rebuilt part (the middles of the ranges, added up)",
        "the printed distributions make every action after the first turn the states the same way, "
        "each by less than the widest step, .285 of a turn or 102.6 degrees; the increments of the "
        "printed angles, 25, 54 and -102, do not have one sign, and turned the long way round they "
        "are too large, as are -23, or 25 the other way, if each is a turn of its own. The first "
        "two increments already exclude each other if they are middles of ranges: "
        "with y the distances from the stable orientations up to the ends of their steps, the "
        "ranges are [y_3, y_4) and [y_2, y_4), both below y_4, so the second middle is less than "
        "twice the first, and 54 is more than 2 x 25",
    ),
    "cost": Erratum(
        "App. E, text on the 4gon",
        "the 1-step plan is the cheapest one, 3.7",
        "7.1 for one step; 7.1, 5.5, 5.3 and 5.0 for 1 to 4 steps of the rebuilt part",
        "the most likely state after one action has .28 in Fig. E.5, and 2 / .285 is more than 7; "
        "3.7 is 2 / .54, the cost of one step over the probability of three",
    ),
}
"""What Appendix E says of the 4gon and no 4gon with four stable edges can have."""

SENSORS: Final = {
    "7.5": Erratum(
        "Eq. 7.5",
        "sum of m(x) / p(x)",
        "1 / sum of m(x) p(x)",
        "a part that is not accepted falls back and is grasped and sensed anew, so its reading "
        "does not last; a round succeeds with probability sum of m(x) p(x). With the prior (.6, "
        ".1, .1, .1, .1) and a sensor that tells the first state from the rest, the printed sum is "
        "2.2, and 1.667 without any sensor; in truth the sensor lowers the cost to 1.429",
    ),
}
"""What chapter 7 says of plans with sensors and does not hold."""
