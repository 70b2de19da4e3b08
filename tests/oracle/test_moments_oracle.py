"""Area and centroid of long outlines: sums on arrays beside sums of Python integers."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.geometry.moments import ring_sums
from stochgeom.geometry.part import Part


def plain_sums(x, y):
    total = [0, 0, 0]
    for k in range(len(x)):
        cross = x[k - 1] * y[k] - x[k] * y[k - 1]
        total = [
            total[0] + cross,
            total[1] + cross * (x[k - 1] + x[k]),
            total[2] + cross * (y[k - 1] + y[k]),
        ]
    return tuple(total)


@given(st.integers(0, 2**32), st.sampled_from([1, 2, 5, 130, 4095, 4096, 4097, 9000]))
def test_sums_over_outlines(seed, count):
    bits = seed % 52 + 1
    values = np.random.default_rng(seed).integers(-(2**bits) + 1, 2**bits, (2, count))
    assert ring_sums(*values) == plain_sums(*values.tolist())


def test_sums_of_the_largest_coordinates():
    most = 2**52 - 1
    for pattern in ([most, -most, -most, most], [most] * 4, [-most, -most, most, most]):
        x = np.array(pattern * 2500)
        y = np.roll(x, 1)
        assert ring_sums(x, y) == plain_sums(x.tolist(), y.tolist())


def test_sums_over_many_vertices():
    """More than one block could add up exactly in float64."""
    values = np.random.default_rng(1).integers(-(2**52) + 1, 2**52, (2, 60_000))
    assert ring_sums(*values) == plain_sums(*values.tolist())


def test_long_outlines_take_the_array_road():
    corners = [(k, 0) for k in range(100)] + [(100, k) for k in range(100)] + [(0, 100)]
    long, short = Part(corners), Part([(0, 0), (100, 0), (100, 99), (0, 100)])
    assert (long.area, long.center_of_mass) == (short.area, short.center_of_mass)
    halves = Part([(Fraction(x, 2), Fraction(y, 2)) for x, y in corners])
    assert halves.area == short.area / 4
    assert halves.center_of_mass == tuple(value / 2 for value in short.center_of_mass)
