"""Breadth-first search: counting, limits, ties; against all sequences of actions."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.decision.costs import as_cost_ratio, length_bound, theorem_4_1_bound
from stochgeom.decision.search import breadth_first
from stochgeom.errors import CostError, InputError

CYCLE = ((0, 0, 1), (1, 2, 0))
"""Letter 0 merges states 0 and 1, letter 1 turns all states on by one."""


def image(states, f):
    return frozenset(f[q] for q in states)


def search(maps, states, node_limit=1000, **options):
    return breadth_first(
        frozenset(states), maps, image, lambda s: -len(s), node_limit=node_limit, **options
    )


class TestCounting:
    def test_the_root_and_duplicates_count(self):
        found = search(CYCLE, {0, 1, 2}, depth=1)
        # Letter 0 gives {0, 1}; letter 1 gives the root again.
        assert [(lv.generated, lv.distinct) for lv in found.levels] == [(1, 1), (3, 2)]

    def test_duplicates_are_not_expanded(self):
        found = search(CYCLE, {0, 1, 2}, depth=2)
        # Of the two nodes of level 1 only {0, 1} is expanded: to {0} and {1, 2}.
        assert (found.last.generated, found.last.distinct) == (5, 4)

    @pytest.mark.parametrize(("limit", "levels"), [(1, 2), (2, 2), (3, 3), (4, 3), (5, 4)])
    def test_the_limit_is_kept(self, limit, levels):
        found = search(CYCLE, {0, 1, 2}, limit)
        assert found.last.generated == limit
        assert len(found.levels) == levels
        assert [lv.complete for lv in found.levels] == [True] * (levels - 1) + [False]
        assert not found.conclusive

    @pytest.mark.parametrize(("limit", "generated"), [(1, 1), (2, 2), (3, 4), (4, 5), (7, 11)])
    def test_the_limit_of_different_nodes_is_kept(self, limit, generated):
        found = search(CYCLE, {0, 1, 2}, limit, count_duplicates=False)
        assert (found.last.distinct, found.last.generated) == (limit, generated)
        assert not found.last.complete

    def test_as_many_different_nodes_as_there_are_is_no_limit(self):
        found = search(CYCLE, {0, 1, 2}, 8, count_duplicates=False)
        assert (found.last.distinct, found.last.generated, found.conclusive) == (7, 15, True)

    def test_an_incomplete_level_tells_what_it_found(self):
        found = search(CYCLE, {0, 1, 2}, 4)
        assert (found.last.worth, found.last.complete) == (-1, False)

    def test_a_search_that_finds_everything_ends(self):
        found = search(CYCLE, {0, 1, 2}, 10**6)
        assert found.last.complete
        assert found.conclusive
        assert found.last.distinct == 7  # every set of states but the empty one
        assert found.level(10**9) == found.last

    def test_the_highest_worth_ends_it_at_once(self):
        found = search(CYCLE, {0, 1, 2}, highest=-1)
        assert [(lv.worth, lv.complete) for lv in found.levels] == [
            (-3, True),
            (-2, True),
            (-1, True),
        ]
        assert found.last.generated == 4
        assert found.conclusive
        assert found.level(7).worth == -1

    def test_a_root_of_the_highest_worth_ends_it_before_the_start(self):
        found = search(CYCLE, {2}, highest=-1)
        assert (len(found.levels), found.last.generated, found.conclusive) == (1, 1, True)
        assert list(found.sequences(0)) == [()]
        assert list(found.sequences(5)) == [()]

    def test_enough_is_asked_after_each_complete_level(self):
        asked = []
        found = search(CYCLE, {0, 1, 2}, enough=lambda lv: asked.append(lv) or lv.length == 1)
        assert [lv.length for lv in asked] == [0, 1]
        assert len(found.levels) == 2
        assert not found.conclusive

    def test_no_actions_are_a_complete_search(self):
        found = search((), {0, 1})
        assert found.conclusive
        assert found.level(3).worth == -2


class TestTies:
    # Two ways to bring both states to one, three to leave two.
    MAPS = ((0, 0), (1, 1), (1, 0))

    def test_one_is_kept(self):
        found = search(self.MAPS, {0, 1}, depth=1)
        assert len(found.last.best) == 1
        assert list(found.sequences(1)) == [(0,)]

    def test_all_are_kept_on_request(self):
        found = search(self.MAPS, {0, 1}, depth=1, keep_ties=True)
        assert found.last.best == (frozenset({0}), frozenset({1}))
        assert list(found.sequences(1)) == [(0,), (1,)]

    def test_all_ways_to_a_hyperstate_are_kept(self):
        found = search((*self.MAPS, (0, 0)), {0, 1}, depth=1, keep_ties=True)
        assert sorted(found.sequences(1)) == [(0,), (1,), (3,)]

    def test_the_level_is_finished_for_ties(self):
        found = search(self.MAPS, {0, 1}, highest=-1, keep_ties=True)
        assert (found.last.generated, found.last.complete) == (4, True)
        cut = search(self.MAPS, {0, 1}, 2, highest=-1, keep_ties=True)
        assert (cut.last.worth, cut.last.complete, cut.conclusive) == (-1, False, True)

    def test_longer_ties_join_the_shorter_ones(self):
        found = search(((0, 0, 2), (0, 2, 2)), {0, 1, 2}, 100, keep_ties=True)
        assert found.level(1).best == (frozenset({0, 2}),)
        assert sorted(found.sequences(4)) == [(0,), (1,)]


def test_a_long_plan_is_read_without_recursion():
    n = 5000
    found = breadth_first(
        0, (1,), lambda q, a: min(q + a, n), lambda q: q, node_limit=2 * n, highest=n
    )
    assert next(found.sequences(n)) == (0,) * n


class TestStochasticActions:
    """Hyperstates are exact distributions, actions are stochastic matrices."""

    half, third = Fraction(1, 2), Fraction(1, 3)
    matrices = (((1, 0), (half, half)), ((third, 1 - third), (0, 1)))

    def run(self, depth):
        return breadth_first(
            (self.half, self.half),
            self.matrices,
            lambda row, p: tuple(
                sum(x * r[j] for x, r in zip(row, p, strict=True)) for j in (0, 1)
            ),
            max,
            node_limit=1000,
            depth=depth,
        )

    def test_probabilities_are_exact(self):
        found = self.run(2)
        # Letter 0 twice: (7/8, 1/8); letter 1 twice: (1/18, 17/18).
        assert [lv.worth for lv in found.levels] == [
            Fraction(1, 2),
            Fraction(5, 6),
            Fraction(17, 18),
        ]
        assert list(found.sequences(2)) == [(1, 1)]
        assert found.last.distinct == 7  # no two sequences lead to one distribution


class TestErrors:
    @pytest.mark.parametrize(("limit", "depth"), [(0, None), (-3, 1), (5, -1)])
    def test_limits_that_make_no_sense(self, limit, depth):
        with pytest.raises(InputError, match="at least 1 node"):
            search(CYCLE, {0}, limit, depth=depth)

    @pytest.mark.parametrize("length", [-1, 3])
    def test_levels_that_were_not_searched(self, length):
        with pytest.raises(InputError, match=f"{length} actions; accepted: 0 to 2"):
            search(CYCLE, {0, 1, 2}, depth=2).level(length)


# --- against all sequences -----------------------------------------------------------------------


@st.composite
def maps(draw):
    n = draw(st.integers(1, 4))
    row = st.tuples(*[st.integers(0, n - 1)] * n)
    return draw(st.lists(row, min_size=1, max_size=3))


@given(maps(), st.booleans())
def test_levels_are_the_best_of_all_sequences(letters, keep_ties):
    """Refuted by a sequence of actions that does better than the level of its length."""
    n = len(letters[0])
    found = search(letters, range(n), 10**6, depth=4, keep_ties=keep_ties)
    fewest, before = n, n + 1
    for length in range(5):
        worths = {}
        for word in product(range(len(letters)), repeat=length):
            states = frozenset(range(n))
            for letter in word:
                states = image(states, letters[letter])
            worths[word] = len(states)
        fewest = min(fewest, *worths.values())
        assert found.level(length).worth == -fewest
        if keep_ties and fewest < before:
            optimal = {word for word, left in worths.items() if left == fewest}
            assert set(found.sequences(length)) == optimal
        before = fewest


# --- costs ---------------------------------------------------------------------------------------


class TestCosts:
    def test_theorem_4_1(self):
        assert theorem_4_1_bound(5) == 20
        assert theorem_4_1_bound(5, "1/3") == 13
        assert theorem_4_1_bound(3, 0) == 6

    def test_the_sharper_bound(self):
        assert length_bound(5) == 9
        assert length_bound(5, 0) == 5
        assert length_bound(3, "1/2") == 4

    @pytest.mark.parametrize("bound", [theorem_4_1_bound, length_bound])
    def test_bad_input(self, bound):
        with pytest.raises(InputError, match="1 or more"):
            bound(0)
        with pytest.raises(CostError, match="negative"):
            bound(3, -1)
        with pytest.raises(CostError, match="cost ratio"):
            bound(3, 0.5)

    def test_a_ratio_is_exact(self):
        assert as_cost_ratio("0.1") == Fraction(1, 10)
