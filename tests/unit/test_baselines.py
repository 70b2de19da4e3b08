"""Natarajan's and Eppstein's planners on automata whose answers are known."""

from __future__ import annotations

import pytest

from stochgeom.errors import InputError
from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.automaton import Automaton
from stochgeom.feeding.eppstein import CollapseTable, eppstein, is_monotone
from stochgeom.feeding.natarajan import (
    ResetWord,
    UnmergeablePair,
    mergeable_pairs,
    natarajan,
    shortest_collapse,
)
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function


def cerny(n):
    """Return Cerny's automaton, whose shortest reset word has (n - 1)^2 letters."""
    turn = tuple((q + 1) % n for q in range(n))
    return Automaton((turn, (1 % n, *range(1, n))))


TRAP = Automaton(((3, 3, 4, 3, 4), (1, 2, 0, 3, 4), (3, 1, 3, 3, 3)))
"""Letter 0 merges 0 and 1 at once, and drives 2 into a state of its own for ever."""

STUCK = Automaton(((0, 0, 2), (1, 0, 2)))
"""States 0 and 1 merge; state 2 stays by itself."""


class TestNatarajan:
    @pytest.mark.parametrize("n", range(1, 8))
    def test_cerny(self, n):
        found = natarajan(cerny(n))
        assert cerny(n).image(found.letters) == {found.state}
        assert len(found.letters) >= (n - 1) ** 2

    def test_one_state_needs_no_letter(self):
        assert natarajan(Automaton(((0,),))) == ResetWord((), 0)

    def test_a_pair_that_never_merges_is_shown(self):
        found = natarajan(STUCK)
        assert found == UnmergeablePair((0, 2), frozenset({(0, 2), (1, 2)}))
        assert found.holds_for(STUCK)

    def test_permutations_merge_nothing(self):
        turn = Automaton(((1, 2, 3, 0),))
        found = natarajan(turn)
        assert found == UnmergeablePair((0, 1), frozenset({(0, 1), (1, 2), (2, 3), (0, 3)}))
        assert mergeable_pairs(turn) == frozenset()

    @pytest.mark.parametrize(
        "wrong",
        [
            UnmergeablePair((0, 2), frozenset({(0, 2)})),  # letter 1 leads out
            UnmergeablePair((0, 2), frozenset({(1, 2)})),  # the pair itself is not there
            UnmergeablePair((0, 1), frozenset({(0, 1), (0, 2), (1, 2)})),  # letter 0 merges it
            UnmergeablePair((0, 2), frozenset()),
        ],
    )
    def test_a_wrong_proof_is_refused(self, wrong):
        assert not wrong.holds_for(STUCK)


class TestInclusion:
    def test_a_subset_collapses_though_the_whole_does_not(self):
        assert shortest_collapse(STUCK, {0, 1}) == ResetWord((0,), 0)
        assert shortest_collapse(STUCK) is None
        assert mergeable_pairs(STUCK) == {(0, 1)}

    def test_for_a_subset_the_choice_of_the_pair_matters(self):
        """Merging 0 and 1 first, as short as can be, leaves a pair that never merges."""
        assert shortest_collapse(TRAP, {0, 1}) == ResetWord((0,), 3)
        assert TRAP.image((0,), {0, 1, 2}) == {3, 4}
        word = shortest_collapse(TRAP, {0, 1, 2})
        assert len(word.letters) == 2
        assert TRAP.image(word.letters, {0, 1, 2}) == {word.state}

    def test_a_single_state_is_collapsed(self):
        assert shortest_collapse(STUCK, [2]) == ResetWord((), 2)

    @pytest.mark.parametrize("states", [[], [3], [-1, 0]])
    def test_bad_subsets(self, states):
        with pytest.raises(InputError, match="accepted: at least one of 0 to 2"):
            shortest_collapse(STUCK, states)

    def test_the_limit_is_kept(self):
        with pytest.raises(InputError, match="no answer after 20 sets"):
            shortest_collapse(cerny(6), node_limit=20)


class TestEppstein:
    @pytest.mark.parametrize("n", range(1, 9))
    def test_cerny(self, n):
        word = eppstein(cerny(n))
        assert len(word) == (n - 1) ** 2
        assert len(cerny(n).image(word)) == 1

    def test_rotations_collapse_nothing(self):
        table = CollapseTable(Automaton(((1, 2, 3, 0), (0, 1, 2, 3))))
        assert table.reset_word() is None
        assert [table.length(2, count) for count in (1, 2, 3, 4)] == [0, None, None, None]
        assert table.word(2, 2) is None
        assert table.word(2, 1) == ()

    def test_a_constant_map_collapses_every_interval(self):
        table = CollapseTable(Automaton(((1, 2, 3, 0), (2, 2, 2, 2))))
        assert {table.length(i, count) for i in range(4) for count in range(2, 5)} == {1}
        assert table.word(3, 4) == (1,)

    def test_an_interval_may_need_the_word_for_the_whole(self):
        """The gap from 2 to 0 is never closed; they meet around the far side, with state 1."""
        automaton = Automaton(((0, 0, 1),))
        table = CollapseTable(automaton)
        assert (table.length(2, 2), table.word(2, 2)) == (2, (0, 0))
        assert table.reset_word() == (0, 0)
        assert shortest_collapse(automaton, {2, 0}) == ResetWord((0, 0), 0)

    def test_numbers_of_states_are_taken_modulo_n(self):
        table = CollapseTable(cerny(4))
        assert table.length(5, 2) == table.length(1, 2) == table.length(-3, 2)

    @pytest.mark.parametrize(
        ("targets", "monotone"),
        [
            ((0,), True),
            ((1, 0), True),
            ((0, 1, 2, 3), True),
            ((3, 0, 1, 2), True),
            ((2, 2, 2, 2), True),
            ((3, 3, 0, 0), True),
            ((0, 2, 1, 3), False),
            ((0, 2, 0, 2), False),
            ((3, 2, 1, 0), False),
        ],
    )
    def test_monotone_maps(self, targets, monotone):
        assert is_monotone(targets) == monotone

    def test_other_maps_are_refused(self):
        with pytest.raises(InputError, match=r"letter 1: \(2, 1, 0\) is not in cyclic order"):
            eppstein(Automaton(((0, 1, 2), (2, 1, 0))))

    @pytest.mark.parametrize("count", [0, 5])
    def test_intervals_that_do_not_exist(self, count):
        with pytest.raises(InputError, match="accepted: 1 to 4"):
            CollapseTable(cerny(4)).length(0, count)


@pytest.mark.parametrize(
    ("name", "letters"),
    [("triangle", 2), ("rectangle", 1), ("house", 1), ("4gon", 3), ("wrench", 2)],
)
def test_parts_of_the_source(name, letters):
    """One letter fewer than the plan has squeezes: the first squeeze is at a random angle."""
    automaton = action_classes(squeeze_function(catalogue_part(name))).automaton()
    assert len(eppstein(automaton)) == letters
    assert len(natarajan(automaton).letters) >= letters
