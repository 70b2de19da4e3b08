"""The probabilities of noisy bins by MPFR with directed rounding, apart from Arb."""

from __future__ import annotations

import gmpy2
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.sensing.gaussian import gaussian_bins

DIGITS = 12
FEW = settings(max_examples=min(200, settings.default.max_examples))


def below(square, sd, edge, bits=300):
    """Return bounds on the probability that the reading is below an edge."""
    down = gmpy2.context(precision=bits, round=gmpy2.RoundDown)
    up = gmpy2.context(precision=bits, round=gmpy2.RoundUp)
    low = down.sub(edge, up.sqrt(square))
    high = up.sub(edge, down.sqrt(square))
    ends = []
    for context, other, value in ((down, up, low), (up, down, high)):
        scale = other if value > 0 else context
        deviation = context.div(value, scale.mul(sd, scale.sqrt(2)))
        ends.append(context.div(context.add(1, context.erf(deviation)), 2))
    return mpq(ends[0]), mpq(ends[1])


positive = st.sampled_from([mpq(k, 8) for k in (1, 2, 3, 4, 9, 16, 18, 32, 50, 72, 99, 128)])


@FEW
@given(positive, positive, st.sets(positive, max_size=5))
def test_every_bin_is_right(square, sd, edges):
    edges = sorted(edges)
    row, error = gaussian_bins(square, sd, edges, DIGITS)
    assert sum(row) == 1
    tails = [(mpq(0), mpq(0)), *(below(square, sd, edge) for edge in edges), (mpq(1), mpq(1))]
    largest = max(range(len(row)), key=row.__getitem__)
    unit = mpq(1, 10**DIGITS)
    total = mpq(0)
    for k, p in enumerate(row):
        low, high = tails[k + 1][0] - tails[k][1], tails[k + 1][1] - tails[k][0]
        assert high - low < mpq(1, 10**60)
        off = max(abs(p - low), abs(p - high))
        total += off
        if k != largest:
            assert off <= unit / 2 + mpq(1, 10**60)
            assert p.denominator == 1 or (p * 10**DIGITS).denominator == 1
    if len(row) > 1:
        assert total < error
    else:
        assert (row, error) == ((1,), 0)


@pytest.mark.parametrize("sd", [mpq(1, 10**6), mpq(10**9)])
def test_extreme_noise(sd):
    row, _ = gaussian_bins(mpq(4), sd, [mpq(1), mpq(2), mpq(3)], 9)
    if sd < 1:
        assert row == (0, mpq(1, 2), mpq(1, 2), 0)  # an edge at the true value halves it
    else:
        assert row == (mpq("0.5"), 0, 0, mpq("0.5"))


def test_against_a_printed_table():
    """Standard normal distribution at -2, -1, 0, 1, 2, to four decimals."""
    row, _ = gaussian_bins(mpq(9), mpq(1), [mpq(k) for k in (1, 2, 3, 4, 5)], 4)
    assert [str(p) for p in (row[0], row[1], row[2])] == ["57/2500", "1359/10000", "3413/10000"]
