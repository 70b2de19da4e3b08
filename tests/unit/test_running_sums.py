"""Sums that change at breakpoints, kept whole at a few of them."""

from __future__ import annotations

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.grasping.running_sums import SNAPSHOTS, RunningSums


def degrees(value):
    return Angle.from_degrees(value)


def test_every_sum_is_that_of_the_changes_before_it():
    """More breakpoints than snapshots, terms that come and go."""
    changes = [(degrees(k), k % 7, (-1) ** (k // 7)) for k in range(150)]
    sums = RunningSums(reversed(changes))
    assert len(sums.starts) == 150 > 2 * SNAPSHOTS
    total = dict.fromkeys(range(7), 0)
    for k, (start, term, weight) in enumerate(changes):
        total[term] += weight
        assert sums.starts[k] == start
        assert sums.at(k) == {t: w for t, w in total.items() if w}
        assert sums.at(k) == sums.at(k)  # asking changes nothing


def test_changes_that_cancel_are_no_breakpoint():
    sums = RunningSums([(degrees(5), "a", 1), (degrees(5), "a", -1), (degrees(9), "b", 1)])
    assert sums.starts == [ZERO, degrees(9)]
    assert sums.at(0) == {}


def test_no_changes():
    assert RunningSums([]).starts == [ZERO]
