"""Figs. 4.5 and 4.6: squeeze plans of the house and the 4gon, and what is printed of them.

Fig. 4.6 shows one of two plans. Two arcs as wide as the period have images that fit, and the
printed plan collapses the one with the wider image; ours has the narrower one, which bears more
error, at the same cost and from the third action on with the same ranges.
"""

from __future__ import annotations

from typing import Final

from gmpy2 import mpq

from stochgeom.errors import NoPlanError
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.evolutions import Evolution, PrintedEvolution, evolution
from stochgeom.thesis.parts import catalogue_part

FIGURE_4_5: Final = PrintedEvolution(
    "4.5",
    0,
    ("45",),
    (("0.40", "", "", ""), ("0.50", "", "", "")),
    {1: "5.0", 2: "6.0"},
    rounds=("2.5", "2.0"),
)
"""The house: the angle is in the caption, all else in the text of section 4.8.

The distributions of the figure itself did not survive; of each, the text names the largest number.
"""

FIGURE_4_6: Final = PrintedEvolution(
    "4.6",
    0,
    ("71", "35", "8"),
    (
        ("0.12", "0.14", "0.11", "0.13") * 2,
        ("0.00", "0.25", "0.00", "0.25") * 2,
        ("0.00", "0.25", "0.25", "0.00") * 2,
        ("0.00", "0.50", "0.00", "0.00") * 2,
    ),
    {},
)
"""The 4gon; its costs are those of Table 4.1."""


def figure_4_5() -> Evolution:
    """Recompute Fig. 4.5: two squeezes of the house.

    Examples
    --------
    >>> [row.angle.computed.decimal(1) for row in figure_4_5().rows[1:]]
    ['45.0']
    """
    return evolution(FIGURE_4_5, FeedingProblem(catalogue_part("house")))


def figure_4_6() -> Evolution:
    """Recompute Fig. 4.6: four squeezes of the 4gon.

    Examples
    --------
    >>> [row.angle.computed.decimal(1) for row in figure_4_6().rows[1:]]
    ['70.8', '35.0', '7.6']
    """
    problem = FeedingProblem(catalogue_part("4gon"))
    *shorter, last = problem.preimages
    chain = [*shorter, _other(last, shorter[-1])]
    plan = FeedingPlan(problem.transfer, chain, mpq(1), problem.part)
    return evolution(FIGURE_4_6, problem, plan)


def _other(chosen: Preimage, before: Preimage) -> Preimage:
    """Return the arc a period wide that was not chosen, though its image fits as well."""
    transfer = chosen.transfer
    values, size = transfer.lifted_values, len(transfer)
    for first in range(size):
        last = first + size - 1
        fits = values[last] - values[first] < before.width
        if fits and first != chosen.first:
            return Preimage(transfer, chosen.steps, first, last, chosen.ties)
    raise NoPlanError("no other arc is as wide")
