"""Counts of trials, and what makes none."""

from __future__ import annotations

import numpy as np
import pytest

from stochgeom.errors import RecordingError
from stochgeom.tilting.counts import OTHER, TransitionCounts

TRIALS = [(1, 1, 2), (1, 1, 2), (2, 1, OTHER), (2, 2, 1)]


def test_trials_are_counted():
    seen = TransitionCounts.from_trials(TRIALS, 2, 2)
    assert seen.row(1, 1) == (0, 2, 0)
    assert seen.row(1, 2) == (0, 0, 1)
    assert seen.row(2, 2) == (1, 0, 0)
    assert (seen.total, seen.others, seen.states, seen.actions) == (4, 1, 2, 2)
    assert seen.outcomes == (1, 2, OTHER)
    assert sorted(seen.trials(), key=str) == [(1, 1, 2, 2), (2, 1, OTHER, 1), (2, 2, 1, 1)]


def test_a_fourth_entry_is_a_count():
    assert TransitionCounts.from_trials([(1, 1, 2, 2), (2, 1, OTHER), (2, 2, 1)], 2, 2) == (
        TransitionCounts.from_trials(TRIALS, 2, 2)
    )


def test_text_is_read():
    assert TransitionCounts.from_trials([("1", "2", "2", "5")], 2, 2).row(2, 1) == (0, 5, 0)


def test_recordings_add_up():
    seen = TransitionCounts.from_trials(TRIALS, 2, 2)
    assert (seen + seen).row(1, 1) == (0, 4, 0)
    assert hash(seen) == hash(TransitionCounts(seen.table))
    with pytest.raises(RecordingError, match="the same states"):
        seen + TransitionCounts([[[1]]])
    with pytest.raises(TypeError):
        seen + 1


def test_the_table_cannot_be_written_to():
    with pytest.raises(ValueError, match="read-only"):
        TransitionCounts([[[1]]]).table[0, 0, 0] = 2


def test_the_callers_array_stays_its_own():
    own = np.ones((1, 1, 1), dtype=np.int64)
    seen = TransitionCounts(own)
    own[0, 0, 0] = 7
    assert seen.row(1, 1) == (1,)


@pytest.mark.parametrize(
    ("trial", "message"),
    [
        ((0, 1, 1), "trial 0: initial state '0'; accepted: 1 to 12"),
        ((13, 1, 1), "trial 0: initial state '13'; accepted: 1 to 12"),
        ((OTHER, 1, 1), "trial 0: initial state 'other'; accepted: 1 to 12"),
        ((1, 13, 1), "trial 0: action '13'; accepted: 1 to 12"),
        ((1, -1, 1), "trial 0: action '-1'; accepted: 1 to 12"),
        ((1, 1, 13), "trial 0: final state '13'; accepted: 1 to 12, or other"),
        ((1, 1, 1.0), "trial 0: final state '1.0'; accepted: 1 to 12, or other"),
        ((1, True, 1), "trial 0: action 'True'; accepted: 1 to 12"),
        ((1, 1, 1, -1), "trial 0: the count '-1'; accepted: whole numbers from 0 on"),
        ((1, 1, 1, 0.5), "trial 0: the count '0.5'; accepted: whole numbers from 0 on"),
        ((1, 1, 1, 2**60), "trial 0: the count '1152921504606846976'"),
        ((1, 1), "trial 0: 2 entries; accepted: initial, action, final"),
    ],
)
def test_a_bad_trial_is_named(trial, message):
    with pytest.raises(RecordingError) as caught:
        TransitionCounts.from_trials([trial])
    assert str(caught.value).startswith(message)


def test_other_is_refused_where_there_is_none():
    with pytest.raises(RecordingError, match=r"final state .other.; accepted: 1 to 2$"):
        TransitionCounts.from_trials([(1, 1, OTHER)], 2, 1, other=False)


@pytest.mark.parametrize(
    ("counts", "message"),
    [
        ([[[1, -1]]], "action 1, state 1, outcome 2: the count -1"),
        ([[1]], "counts of shape 1 x 1; accepted: actions x states x states"),
        ([[[1, 2, 3]]], "counts of shape 1 x 1 x 3"),
        ([[[1], [2]]], "counts of shape 1 x 2 x 1"),
        ([], "counts of type float64"),
        ([[[0.5]]], "counts of type float64"),
        ([[[1], [1, 2]]], "counts of type object"),
        (5, "counts of shape one number"),
    ],
)
def test_a_bad_table_is_refused(counts, message):
    with pytest.raises(RecordingError) as caught:
        TransitionCounts(counts)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(("states", "actions"), [(0, 1), (1, 0), (-1, 1), (1001, 1)])
def test_sizes_are_checked(states, actions):
    with pytest.raises(RecordingError, match="accepted: whole numbers from 1 to 1000"):
        TransitionCounts.from_trials([], states, actions)
