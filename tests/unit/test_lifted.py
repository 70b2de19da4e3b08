"""`LiftedAngles` against a direct double loop on exact angles, by both of its roads."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.vectors import AngleVector
from tests.strategies import TINY, angles, lifted_sequences

EVERYTHING = 1e9
"""A bound on the shadow's error that leaves every decision to exact arithmetic."""


def deg(value):
    return Angle.from_degrees(value)


def lifted(entries, period, error=None, *, by_arrays=False):
    sequence = LiftedAngles(AngleVector.from_angles(entries), period, error=error)
    if by_arrays:
        sequence._few = None  # as if there were many
    return sequence


# --- the slow road -------------------------------------------------------------------------------


def entry(entries, period, k):
    return entries[k % len(entries)] + k // len(entries) * period


def last_below(entries, period, offset):
    found = []
    for i, start in enumerate(entries):
        k = i
        while entry(entries, period, k + 1) < start + offset:
            k += 1
        found.append(k)
    return found


def largest_gaps(entries, period, last):
    gaps = [entry(entries, period, k + 1) - entries[i] for i, k in enumerate(last)]
    return [i for i, gap in enumerate(gaps) if gap == max(gaps)]


@st.composite
def questions(draw):
    """Draw a sequence and an offset in (0, period], often exactly one of its differences."""
    entries, period = draw(lifted_sequences())
    differences = [(a - b) % period for a in entries for b in entries]
    offset = draw(
        st.one_of(
            st.sampled_from([d or period for d in differences]),
            st.integers(1, 18).map(lambda k: deg(5 * k)),
            st.sampled_from([TINY, 2 * TINY, period, period - TINY, deg("2.5"), Angle(0, (3, 2))]),
        )
    )
    offset += draw(st.sampled_from([ZERO, ZERO, TINY, -TINY]))
    return entries, period, min(max(offset, TINY), period)


@given(questions())
def test_both_roads_agree_with_the_double_loop(question):
    entries, period, offset = question
    expected = last_below(entries, period, offset)
    gaps = largest_gaps(entries, period, expected)
    filtered, forced, *by_arrays = (
        lifted(entries, period, error, by_arrays=by_arrays)
        for by_arrays in (False, True)
        for error in (None, EVERYTHING)
    )
    for sequence in (filtered, forced, *by_arrays):
        last = sequence.last_below(offset)
        assert last.tolist() == expected
        assert sequence.largest_gaps(last).tolist() == gaps
    m = len(entries)
    assert forced.exact_decisions == by_arrays[1].exact_decisions == (m if m == 1 else 2 * m)
    assert filtered.exact_decisions == by_arrays[0].exact_decisions <= forced.exact_decisions


@given(questions(), st.booleans(), st.booleans())
def test_a_stage_asks_both_questions_at_once(question, by_arrays, everything):
    entries, period, offset = question
    error = EVERYTHING if everything else None
    images = lifted(entries, period, error, by_arrays=by_arrays)
    breaks = lifted(entries, period, error)
    last, widest = breaks.widest_below(images, offset)
    assert list(last) == last_below(entries, period, offset)
    assert list(widest) == largest_gaps(entries, period, list(last))


@given(questions(), st.integers(0, 30), st.integers(1, 30), st.booleans())
def test_a_gap_does_what_its_angle_does(question, start, steps, by_arrays):
    entries, period, _ = question
    start, steps = start % len(entries), 1 + steps % len(entries)
    sequence = lifted(entries, period, by_arrays=by_arrays)
    gap = sequence.gap(start, start + steps)
    assert gap.angle == entry(entries, period, start + steps) - entries[start]
    assert sequence.last_below(gap).tolist() == last_below(entries, period, gap.angle)


@given(lifted_sequences(), st.integers(-20, 20))
def test_entries_repeat_with_the_period(drawn, k):
    entries, period = drawn
    sequence = lifted(entries, period)
    assert len(sequence) == len(entries)
    assert sequence[k] == entry(entries, period, k)
    assert sequence[k + len(entries)] == sequence[k] + period
    assert sequence[k] < sequence[k + 1]
    assert sequence[np.int64(k)] == sequence[k]


@given(
    st.sampled_from([90, 180, 360]),
    st.sets(st.integers(0, 71), min_size=1, max_size=20),
    st.integers(0, 35),
    st.integers(-3, 3),
)
def test_the_shadow_decides_what_is_well_separated(degrees, cells, steps, turns):
    period = deg(degrees)
    count = degrees // 5
    grid = sorted({5 * (cell % count) for cell in cells})
    entries = [deg(d) + turns * FULL_TURN for d in grid]
    offset = deg(5 * (steps % count)) + deg("2.5")  # never within 2.5 degrees of an entry
    sequence = lifted(entries, period)
    assert sequence.last_below(offset).tolist() == last_below(entries, period, offset)
    assert sequence.exact_decisions == 0


def normalized(drawn):
    """Return entries moved into [0, period), where `position` wants them."""
    entries, period = drawn
    return sorted({a % period for a in entries}), period


@given(lifted_sequences().map(normalized), angles(), st.integers(-9, 9), st.data())
def test_positions_by_both_roads(drawn, theta, turns, data):
    entries, period = drawn
    theta = data.draw(st.sampled_from([theta, *entries])) + turns * period
    theta += data.draw(st.sampled_from([ZERO, TINY, -TINY]))
    sequence = lifted(entries, period)
    k = sequence.position(theta)
    assert entry(entries, period, k) <= theta < entry(entries, period, k + 1)


@given(
    lifted_sequences().map(normalized),
    st.sets(st.integers(0, 71), min_size=1, max_size=4),
    angles(),
    st.data(),
)
def test_positions_of_another_sequence(drawn, cells, theta, data):
    entries, period = drawn
    others = sorted({deg(5 * cell) % period for cell in cells})
    shift = data.draw(st.sampled_from([0, 0, 1, -2, 10**6])) * period
    others = [b + shift for b in others]
    differences = [a - b for a in entries for b in others]
    offset = data.draw(st.sampled_from([theta, *differences]))
    offset += data.draw(st.sampled_from([ZERO, TINY, -TINY]))
    indices = np.array(data.draw(st.lists(st.integers(-40, 40), max_size=8)), dtype=np.intp)
    expected = []
    for j in indices.tolist():
        target = entry(others, period, j) + offset
        k = int((target // period) * len(entries)) - 1
        while entry(entries, period, k + 1) <= target:
            k += 1
        expected.append(k)
    for error in (None, EVERYTHING):
        a, b = lifted(entries, period, error), lifted(others, period, error)
        assert a.positions(b, indices, offset).tolist() == expected
        assert error is None or a.exact_decisions == len(indices)


# --- by hand -------------------------------------------------------------------------------------


def test_a_tie_is_not_below():
    sequence = lifted([deg(0), deg(10), deg(90)], HALF_TURN)
    assert sequence.last_below(deg(10)).tolist() == [0, 1, 2]
    assert sequence.last_below(deg(10) + TINY).tolist() == [1, 1, 2]
    assert sequence.last_below(deg(90)).tolist() == [1, 2, 2]
    assert sequence.last_below(HALF_TURN).tolist() == [2, 3, 4]
    assert sequence.last_below(HALF_TURN - TINY).tolist() == [2, 3, 4]
    assert sequence.last_below(TINY).tolist() == [0, 1, 2]


@pytest.mark.parametrize("by_arrays", [False, True])
@pytest.mark.parametrize("error", [None, EVERYTHING])
def test_neighbours_closer_than_floats_can_tell(error, by_arrays):
    entries = [ZERO, TINY, 2 * TINY, deg(45), deg(45) + TINY, QUARTER_TURN - TINY]
    sequence = lifted(entries, QUARTER_TURN, error, by_arrays=by_arrays)
    assert sequence.last_below(TINY).tolist() == [0, 1, 2, 3, 4, 5]
    assert sequence.last_below(2 * TINY).tolist() == [1, 2, 2, 4, 4, 6]
    assert sequence.last_below(deg(45)).tolist() == [2, 3, 4, 5, 6, 8]
    assert sequence.last_below(QUARTER_TURN).tolist() == [5, 6, 7, 8, 9, 10]
    assert sequence.exact_decisions > 0


@pytest.mark.parametrize("by_arrays", [False, True])
@pytest.mark.parametrize("error", [None, EVERYTHING])
def test_equally_large_gaps_are_all_found_in_order(error, by_arrays):
    entries = [deg(0), deg(30), deg(60) + TINY, deg(90)]
    sequence = lifted(entries, HALF_TURN, error, by_arrays=by_arrays)
    one_step = np.arange(4)
    assert sequence.largest_gaps(one_step).tolist() == [3]
    assert sequence.largest_gaps(one_step[:4] * 0 + [0, 1, 2, 2]).tolist() == [1]
    even = lifted([deg(d) for d in (0, 60, 120)], HALF_TURN, error, by_arrays=by_arrays)
    assert even.largest_gaps(np.arange(3)).tolist() == [0, 1, 2]
    assert even.largest_gaps(np.array([1, 1, 3])).tolist() == [0, 2]


def test_one_largest_gap_needs_no_exact_decision():
    sequence = lifted([deg(d) for d in (0, 10, 30, 60)], QUARTER_TURN)
    assert sequence.largest_gaps(np.array([0, 1, 3, 3])).tolist() == [2]
    assert sequence.exact_decisions == 0


def test_one_entry():
    sequence = lifted([Angle(3, (3, 2))], QUARTER_TURN)
    for offset in (TINY, deg(45), QUARTER_TURN):
        assert sequence.last_below(offset).tolist() == [0]
    assert sequence.largest_gaps(np.array([0])).tolist() == [0]
    assert sequence[-2] == Angle(2, (3, 2)) + HALF_TURN


@pytest.mark.parametrize("turns", [10**6, 10**9 + 1, -(10**9)])
def test_far_from_zero_the_shadow_leaves_more_open(turns):
    entries = [deg(5 * k) + Angle(turns) for k in (0, 1, 5, 17)]
    for offset in (deg(5), deg("2.5"), deg(5) + TINY, QUARTER_TURN):
        sequence = lifted(entries, QUARTER_TURN)
        assert sequence.last_below(offset).tolist() == last_below(entries, QUARTER_TURN, offset)


@pytest.mark.parametrize("turns", [10**6, 2**40 + 1])
def test_long_periods(turns):
    period = Angle(turns)
    third = Angle.from_turns("1/3")
    entries = [ZERO, Angle.from_degrees("1e-9"), third, Angle(turns - 1, (3, 2))]
    for offset in (period, period - TINY, period - Angle.from_degrees("1e-9"), third, TINY):
        sequence = lifted(entries, period)
        last = sequence.last_below(offset)
        assert last.tolist() == last_below(entries, period, offset)
        assert sequence.largest_gaps(last).tolist() == largest_gaps(entries, period, last.tolist())


@pytest.mark.parametrize("turns", [10**6, 10**9 + 7])
def test_a_base_near_zero_and_a_period_far_away(turns):
    period = Angle(turns)
    for direction in [(3, 2), (-5, 1), (1, 7), (-2, -9), (4, -3), (11, 5)]:
        entries = [ZERO, Angle(0, direction)]
        for step in (TINY, -TINY):
            # a_1 + offset is a_2 + step: within `TINY` of the next period's first entry.
            offset = period - entries[1] + step
            sequence = lifted(entries, period)
            assert sequence.last_below(offset).tolist() == last_below(entries, period, offset)
            ends = np.array([1, 2])
            assert sequence.widest(ends - 1, ends).tolist() == [1]


@pytest.mark.parametrize("laps", [10**6, -(10**9), 10**12, 2**40 + 1])
@pytest.mark.parametrize("degrees", [90, 120, 180, 360])
def test_positions_of_far_indices(degrees, laps):
    # After so many periods the floats are off by far more than the shadow's own bound.
    period = deg(degrees)
    steps = [TINY, -TINY, deg("1e-6"), -deg("1e-6")]
    for x, y in [(9, 2), (5, 1), (7, 3), (8, 5)]:
        a, b = lifted([ZERO, Angle(0, (x, y))], period), lifted([deg("0.7")], period)
        for step in steps:
            offset = a[1] - b[0] + step
            expected = 2 * laps + (1 if step > ZERO else 0)
            assert a.positions(b, np.array([laps]), offset).tolist() == [expected]
            far = offset - laps * period  # the other way round: back again by the offset
            assert a.positions(b, np.array([laps]), far).tolist() == [expected - 2 * laps]


@pytest.mark.parametrize("error", [None, EVERYTHING])
def test_positions_by_hand(error):
    a = lifted([deg(10), deg(40), deg(70)], QUARTER_TURN, error)
    b = lifted([ZERO, deg(30)], QUARTER_TURN, error)
    indices = np.array([0, 1, 2, 3, -1])  # 0, 30, 90, 120 and -60 degrees
    assert a.positions(b, indices, ZERO).tolist() == [-1, 0, 2, 3, -3]
    assert a.positions(b, indices, deg(10)).tolist() == [0, 1, 3, 4, -2]
    assert a.positions(b, indices, deg(10) - TINY).tolist() == [-1, 0, 2, 3, -3]
    assert [a.position(deg(d)) for d in (9, 10, 99, 100, -20, -21)] == [-1, 0, 2, 3, -1, -2]
