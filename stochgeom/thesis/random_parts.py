"""Random parts of sections 4.8 and 5.9: how far exhaustive search gets, and that it agrees.

A part is the convex hull of 10 random points of a square. It depends on the seed and its own number
only. The source does not say how its points were drawn; ours are whole numbers, uniform.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import comb
from typing import Final, final

import numpy as np
from gmpy2 import mpq

from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.eppstein import eppstein
from stochgeom.feeding.exhaustive import NODE_LIMIT, first_disagreement, search_plans
from stochgeom.feeding.preimages import preimages
from stochgeom.geometry.hull import convex_hull
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Points
from stochgeom.thesis.number_tables import ExactNumber, NumberTable, square_root
from stochgeom.thesis.tables import Cell
from stochgeom.transfer.squeeze import squeeze_function

SEED: Final = 1990
POINTS: Final = 10
SIDE: Final = 10**6
"""Side of the square: coordinates are whole numbers."""

SOURCE_PARTS: Final = 2000
SOURCE_COMPARED: Final = 1000
COMPARISON_LIMIT: Final = 1_000_000
"""Nodes for the comparison: as good as no limit."""


def random_hull(index: int, seed: int = SEED) -> Part:
    """Return the hull of 10 random points of a square, the same for the same two numbers."""
    pairs = np.random.default_rng((seed, index)).integers(0, SIDE, (POINTS, 2))
    return Part(convex_hull(Points.from_pairs(pairs)).points.pairs())


@final
@dataclass(frozen=True, slots=True)
class Trial:
    """What the search for the optimal plan of one part took."""

    sides: int
    states: int
    steps: int
    """Steps of the optimal plan."""
    solved: bool
    generated: int
    distinct: int
    in_tree: int
    """Nodes of the same levels if duplicates were expanded again: the whole tree."""


@final
@dataclass(frozen=True, slots=True)
class Comparison:
    """How far all plans of one part were gone through, and whether the others agree."""

    lengths: int
    """Plan lengths that were compared."""
    solved: bool
    agrees: bool
    shortest: int
    """Steps of the shortest plan up to symmetry."""


def search_trial(index: int) -> Trial:
    """Search for the optimal plan at a cost ratio of 1, as in section 4.8."""
    part = random_hull(index)
    transfer = squeeze_function(part)
    found = search_plans(transfer, cost_ratio=1, node_limit=NODE_LIMIT, count_duplicates=False)
    branches = len(found.classes)
    return Trial(
        len(part.hull),
        len(transfer),
        found.optimal_steps(1),
        found.solved,
        found.generated,
        found.distinct,
        sum(branches**level for level in range(len(found.lengths))),
    )


def comparison(index: int) -> Comparison:
    """Compare every plan length with phase I and the shortest plan with Eppstein's."""
    transfer = squeeze_function(random_hull(index))
    chain = preimages(transfer)
    found = search_plans(transfer, node_limit=COMPARISON_LIMIT)
    shortest = len(list(chain))
    word = eppstein(action_classes(transfer).automaton())
    same = first_disagreement(found, chain) is None
    return Comparison(
        sum(length.complete for length in found.lengths),
        found.solved,
        same and word is not None and len(word) + 1 == shortest,
        shortest,
    )


def expected_sides(points: int) -> mpq:
    """Return the exact mean number of corners of the hull of random points of a square.

    Of all pairs of points those are edges that have all others on one side. A pair's line cuts off
    a triangle of legs a and b at one of four corners, with the density a b / 3 of its legs over the
    unit square (chord**3 / 3 times the measure of lines), or runs from side to side at heights s
    and t, in two ways, with the density 1 / 3; the areas are a b / 2 and (s + t) / 2.

    Examples
    --------
    >>> expected_sides(3), expected_sides(4)
    (mpq(3,1), mpq(133,36))
    """
    others = points - 2
    cut_off = mpq(1, 2**others * (others + 2) ** 2) + sum(
        comb(others, k) * mpq((-1) ** k, 2**k * (k + 2) ** 2) for k in range(others + 1)
    )
    across = 2 * mpq(2 ** (others + 2) - 2, 2**others * (others + 1) * (others + 2))
    return mpq(comb(points, 2), 3) * (4 * cut_off + 2 * across)


Tell = Callable[[float], None]


def searched_parts(title: str, count: int = SOURCE_PARTS, tell: Tell | None = None) -> NumberTable:
    """Repeat the experiment of section 4.8; some ten seconds for 2000 parts.

    The numbers of the source are means of another random sample, so they are set beside ours and
    not judged.
    """
    trials = []
    for index in range(count):
        trials.append(search_trial(index))
        if tell is not None:
            tell((index + 1) / count)
    sides = mpq(sum(trial.sides for trial in trials), count)
    spread = mpq(sum((trial.sides - sides) ** 2 for trial in trials)) / count
    error = square_root(spread / SOURCE_PARTS)
    solved = mpq(100 * sum(trial.solved for trial in trials), count)
    by_tree = mpq(100 * sum(t.solved and t.generated <= NODE_LIMIT for t in trials), count)
    rows = (
        ("mean number of sides", ExactNumber(sides), "5.9"),
        ("its expectation, exactly", ExactNumber(expected_sides(POINTS)), ""),
        (f"standard error of a mean of {SOURCE_PARTS}", error, ""),
        ("percent solved, each hyperstate counted once", ExactNumber(solved), "99"),
        ("percent solved, duplicates counted", ExactNumber(by_tree), ""),
    )
    notes = (
        (
            f"{count} random hulls, seed {SEED}, {NODE_LIMIT} nodes, filter cost 1. The source has "
            "another sample of 2000, so that its numbers are not judged."
        ),
    )
    return NumberTable(title, ("of the random parts", "computed", "source"), rows, notes)


def compared_parts(
    title: str, count: int = SOURCE_COMPARED, tell: Tell | None = None
) -> NumberTable:
    """Repeat the experiment of section 5.9: the same plans as by exhaustive search, always."""
    found = []
    for index in range(count):
        found.append(comparison(index))
        if tell is not None:
            tell((index + 1) / count)
    agreeing = ExactNumber(mpq(100 * sum(c.agrees for c in found), count))
    complete = ExactNumber(mpq(100 * sum(c.solved for c in found), count))
    rows = (
        ("percent of parts with the same plans", Cell(agreeing, "100", None)),
        ("percent searched to the end", complete),
        (
            "mean steps of the shortest plan",
            ExactNumber(mpq(sum(c.shortest for c in found), count)),
        ),
    )
    notes = (f"{count} random hulls, seed {SEED}; the third road is Eppstein's algorithm.",)
    return NumberTable(title, ("of the random parts", "computed"), rows, notes)
