"""Sections 4.8 and 5.9: how the random parts are made, and what searching them finds."""

from __future__ import annotations

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.feeding.exhaustive import NODE_LIMIT, search_plans
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.random_parts import (
    COMPARISON_LIMIT,
    POINTS,
    SEED,
    SIDE,
    SOURCE_COMPARED,
    SOURCE_PARTS,
    comparison,
    random_hull,
    search_trial,
    searched_parts,
)

PARTS = 200


def test_what_the_source_says_of_its_experiments():
    """2000 parts and 1000, the hulls of 10 points each, and 1000 nodes at most."""
    assert (SOURCE_PARTS, SOURCE_COMPARED, POINTS, NODE_LIMIT) == (2000, 1000, 10, 1000)
    assert COMPARISON_LIMIT > NODE_LIMIT


def test_parts_are_hulls_of_ten_points_of_a_square():
    """By scipy's hulls of the same points; refuted by another part for one of the numbers."""
    hull = pytest.importorskip("scipy.spatial").ConvexHull
    for index in range(30):
        pairs = np.random.default_rng((SEED, index)).integers(0, SIDE, (10, 2))
        expected = {tuple(pairs[k]) for k in hull(pairs.astype(float)).vertices}
        assert {(int(x), int(y)) for x, y in random_hull(index).vertices} == expected
    assert random_hull(0) == random_hull(0) != random_hull(1)
    assert random_hull(0, seed=1) != random_hull(0)


def test_nearly_all_parts_are_solved():
    """99 in 100 in the source; refuted by fewer than 97 here, or a plan that backchaining beats."""
    trials = [search_trial(index) for index in range(PARTS)]
    assert sum(trial.solved for trial in trials) >= 97 * PARTS // 100
    for index, trial in enumerate(trials):
        if trial.solved:
            assert trial.steps == FeedingProblem(random_hull(index)).optimal_plan(1).steps
    assert all(trial.distinct <= NODE_LIMIT for trial in trials)


def test_the_limit_is_what_leaves_parts_unsolved():
    """A part that 30 nodes do not settle is settled by a thousand, by the same plan or better."""
    transfers = [FeedingProblem(random_hull(index)).transfer for index in range(20)]
    short = [search_plans(s, cost_ratio=1, node_limit=30) for s in transfers]
    assert not all(found.solved for found in short)
    for s, found in zip(transfers, short, strict=True):
        longer = search_plans(s, cost_ratio=1, node_limit=NODE_LIMIT)
        assert longer.solved >= found.solved
        if found.solved:
            assert longer.optimal_steps(1) == found.optimal_steps(1)


def test_the_table_counts_what_the_trials_say():
    """Means and percentages, added up apart."""
    trials = [search_trial(index) for index in range(25)]
    table = searched_parts("sec4.8", 25)
    rows = {row[0]: row[1:] for row in table.rows}
    assert len(rows) == len(table.rows)
    numbers = {name: mpq(row[0].value) for name, row in rows.items() if "error" not in name}
    assert numbers["mean number of sides"] == mpq(sum(trial.sides for trial in trials), 25)
    solved = "percent solved, each hyperstate counted once"
    assert numbers[solved] == 4 * sum(trial.solved for trial in trials)
    assert numbers["percent solved, duplicates counted"] == 4 * sum(
        t.solved and t.generated <= 1000 for t in trials
    )
    printed = {name: row[1] for name, row in rows.items() if row[1]}
    assert printed == {"mean number of sides": "5.9", solved: "99"}


def test_section_5_9_the_plans_of_exhaustive_search():
    """Refuted by one part for which search, phase I and Eppstein's algorithm disagree."""
    found = [comparison(index) for index in range(60)]
    assert all(each.agrees for each in found)
    assert all(each.lengths >= 1 for each in found)
    assert max(each.shortest for each in found) >= 3
