"""Laws of the older planners, and what ties them to phase I (thesis 5.2, 5.4.3)."""

from __future__ import annotations

import sys
from itertools import accumulate, pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import ZERO
from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.automaton import Automaton
from stochgeom.feeding.eppstein import CollapseTable, eppstein, is_monotone
from stochgeom.feeding.execution import composite
from stochgeom.feeding.natarajan import (
    ResetWord,
    mergeable_pairs,
    natarajan,
    shortest_collapse,
)
from stochgeom.feeding.preimages import preimages
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import circle_parts, parts, squeezes, transfer_functions


@st.composite
def automata(draw):
    """Any maps of few states."""
    n = draw(st.integers(1, 5))
    row = st.tuples(*[st.integers(0, n - 1)] * n)
    return Automaton(tuple(draw(st.lists(row, min_size=1, max_size=4))))


@st.composite
def monotone_automata(draw):
    """Maps that keep the cyclic order: lifts that move on by n over a round, or constants."""
    n = draw(st.integers(1, 6))
    maps = []
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, n - 1))
        # n - 1 ascents of at most n in all; the last one closes the round.
        marks = sorted(draw(st.lists(st.integers(0, n), min_size=n - 1, max_size=n - 1)))
        maps.append(tuple((start + mark) % n for mark in (0, *marks)))
    return Automaton(tuple(maps))


class TestCorollary511:
    """Phase I finds the shortest plan up to symmetry.

    Refuted by a part for which the shortest reset sequence of the states modulo T, plus the
    random first squeeze, has another length than the plan of phase I.
    """

    @staticmethod
    def holds_for(s):
        classes = action_classes(s)
        word = eppstein(classes.automaton())
        assert len(word) + 1 == len(list(preimages(s)))
        # And the sequence does it: run on the transfer function itself, at its own angles.
        angles = [ZERO, *(c.angle for c in classes.representatives(word))]
        whole = composite(s, angles)
        assert (len(whole), whole.period) == (1, s.period)

    @given(parts())
    def test_parts(self, part):
        self.holds_for(squeeze_function(part))

    @given(circle_parts())
    def test_parts_in_general_position(self, part):
        self.holds_for(squeeze_function(part))

    @given(transfer_functions())
    def test_other_monotone_step_maps(self, s):
        self.holds_for(s)


@given(st.one_of(squeezes(), transfer_functions()))
def test_intervals_of_states_give_the_widths_of_all_lengths(s):
    """Theorem 5.1 in polynomial time; refuted by an arc that i actions collapse, wider than h_i.

    Every arc of initial steps is an interval of states after the first squeeze, and Eppstein's
    table tells how many actions collapse it.
    """
    table = CollapseTable(action_classes(s).automaton())
    breaks, m = s.lifted_breaks, len(s)
    arcs = [
        (table.length(first, count), breaks[first + count] - breaks[first])
        for first in range(m)
        for count in range(1, m + 1)
    ]
    for p in preimages(s):
        assert max(width for length, width in arcs if length < p.steps) == p.width


@given(transfer_functions())
def test_actions_keep_the_cyclic_order(s):
    """Thesis 5.2; refuted by an action whose map of states is not monotone."""
    assert all(map(is_monotone, action_classes(s).merged))


@given(transfer_functions())
def test_natarajan_finds_a_plan_for_every_part(s):
    """Theorem 5.3 by another planner; refuted by two states modulo T that no actions merge."""
    automaton = action_classes(s).automaton()
    found = natarajan(automaton)
    assert isinstance(found, ResetWord)
    assert automaton.image(found.letters) == {found.state}
    assert len(found.letters) >= len(eppstein(automaton))
    n = automaton.states
    assert len(mergeable_pairs(automaton)) == n * (n - 1) // 2


# --- inclusion -----------------------------------------------------------------------------------


@given(automata())
def test_all_states_collapse_if_and_only_if_every_pair_does(automaton):
    """Natarajan's inclusion property; refuted by a greedy choice that would have to be undone."""
    n = automaton.states
    found, shortest = natarajan(automaton), shortest_collapse(automaton)
    pairs = mergeable_pairs(automaton)
    assert (shortest is not None) == (len(pairs) == n * (n - 1) // 2)
    if shortest is None:
        assert found.holds_for(automaton)
        assert found.pair not in pairs
        assert not found.closure & pairs
    else:
        assert automaton.image(found.letters) == {found.state}
        assert len(found.letters) >= len(shortest.letters)


@given(automata(), st.data())
def test_what_collapses_a_set_collapses_its_subsets(automaton, data):
    """Refuted by a subset that needs more letters than the set."""
    states = data.draw(st.sets(st.integers(0, automaton.states - 1), min_size=1))
    subset = data.draw(st.sets(st.sampled_from(sorted(states)), min_size=1))
    found, smaller = (shortest_collapse(automaton, each) for each in (states, subset))
    if found is not None:
        assert automaton.image(found.letters, subset) == {found.state}
        assert len(smaller.letters) <= len(found.letters)


@given(automata())
def test_mergeable_pairs_are_those_that_search_merges(automaton):
    """Refuted by a pair that backward and forward search judge differently."""
    pairs = {(p, q) for p in range(automaton.states) for q in range(p + 1, automaton.states)}
    merged = {pair for pair in pairs if shortest_collapse(automaton, pair) is not None}
    assert mergeable_pairs(automaton) == merged


# --- Eppstein's table ----------------------------------------------------------------------------


@given(monotone_automata())
def test_no_interval_collapses_sooner(automaton):
    """Refuted by an interval that fewer maps collapse than Eppstein's table says."""
    n, table = automaton.states, CollapseTable(automaton)
    for first in range(n):
        for count in range(1, n + 1):
            states = [(first + j) % n for j in range(count)]
            shortest, length = shortest_collapse(automaton, states), table.length(first, count)
            assert length == (None if shortest is None else len(shortest.letters))
            if length is not None:
                word = table.word(first, count)
                assert len(word) == length
                assert len(automaton.image(word, states)) == 1


# --- 5.2: time -----------------------------------------------------------------------------------


def cerny(n, copies=1):
    """Return Cerny's automaton with each of its two maps so many times: the longest words."""
    turn = tuple((q + 1) % n for q in range(n))
    return Automaton((turn, (1 % n, *range(1, n))) * copies)


def work(plan, automaton):
    """Return how many lines of the planner's module are carried out, loops counted each time."""
    file, lines = plan.__code__.co_filename, [0]

    def trace(frame, event, _):
        if frame.f_code.co_filename != file:
            return None
        lines[0] += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        plan(automaton)
    finally:
        sys.settrace(before)
    return lines[0]


@given(monotone_automata())
@settings(max_examples=100)
def test_eppstein_does_no_more_than_k_n_squared(automaton):
    """Refuted by more than some steps for each map and interval of states."""
    k, n = automaton.letters, automaton.states
    assert work(eppstein, automaton) <= 40 + 20 * k * (n + 1) ** 2


@given(
    st.integers(2, 8).flatmap(lambda n: st.lists(st.permutations(range(n)), min_size=1, max_size=3))
)
@settings(max_examples=100)
def test_natarajan_looks_at_a_pair_once_for_each_map(rows):
    """Where nothing merges, its one search sees all pairs that can be reached: O(k n^2) of n - 1.

    Refuted by more than some steps for each of them and each map. (Words are applied elsewhere, by
    calls that are counted once; k n^4 in all, says the source.)
    """
    automaton = Automaton(tuple(map(tuple, rows)))
    pairs = len(natarajan(automaton).closure)
    assert pairs <= automaton.states * (automaton.states - 1) // 2
    assert work(natarajan, automaton) <= 20 + pairs * (3 + 8 * automaton.letters)


@pytest.mark.parametrize(("plan", "power"), [(eppstein, 2), (natarajan, 3)])
def test_work_grows_as_the_source_says_or_less(plan, power):
    """By doubling the states, and by doubling the maps, where reset words are longest.

    Refuted by more than 2^power times the work, or more than twice: room is left for lower terms.
    """
    counts = [work(plan, cerny(n)) for n in (6, 12, 24, 48)[: 6 - power]]
    for one, other in pairwise(counts):
        assert other <= 1.1 * 2**power * one
    assert counts[-1] > 3 * counts[-2]  # no less than n^2, which both can take
    assert work(plan, cerny(12, copies=2)) <= 2 * work(plan, cerny(12))


@given(monotone_automata())
def test_longer_intervals_need_no_fewer_maps(automaton):
    """Refuted by an interval that needs fewer maps than one inside it."""
    n, table = automaton.states, CollapseTable(automaton)
    for first in range(n):
        lengths = [table.length(first, count) for count in range(1, n + 1)]
        needed = [n**n if length is None else length for length in lengths]
        assert needed == list(accumulate(needed, max))
