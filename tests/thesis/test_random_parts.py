"""Sections 4.8 and 5.9: hulls of random points, and what the source prints of them."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.thesis.number_tables import square_root
from stochgeom.thesis.random_parts import (
    POINTS,
    SOURCE_COMPARED,
    SOURCE_PARTS,
    expected_sides,
    random_hull,
)


def test_what_the_source_made():
    assert (POINTS, SOURCE_PARTS, SOURCE_COMPARED) == (10, 2000, 1000)


@pytest.mark.parametrize(("points", "sides"), [(2, 2), (3, 3), (4, mpq(133, 36))])
def test_expected_sides_of_few_points(points, sides):
    """Four points of a square are in convex position with 25 / 36 (Sylvester): 3 + 25 / 36."""
    assert expected_sides(points) == sides


def test_expected_sides_of_one_point_more():
    """Buchta: of an odd number of points the mean follows from that of one less and fewer.

    For five points of any convex region it is 5 / 2 times that of four, less 5.
    """
    assert expected_sides(5) == mpq(5, 2) * expected_sides(4) - 5


def test_expected_sides_by_counting_edges():
    """Twenty thousand times six points: pairs with all others on one side, against the formula."""
    points = np.random.default_rng(1990).random((20_000, 6, 2))
    edges = np.zeros(len(points))
    for i, j in combinations(range(6), 2):
        along = points[:, j] - points[:, i]
        others = points[:, [k for k in range(6) if k not in (i, j)]] - points[:, i, None]
        side = along[:, 0, None] * others[:, :, 1] - along[:, 1, None] * others[:, :, 0] > 0
        edges += side.all(axis=1) | ~side.any(axis=1)
    error = edges.std() / len(edges) ** 0.5
    assert abs(edges.mean() - float(expected_sides(6))) < 4 * error


def test_the_printed_mean_is_a_likely_one():
    """5.9 stands for less than 5.95; a mean of 2000 hulls is 5.962 with an error of .022."""
    sides = [len(random_hull(index).hull) for index in range(400)]
    mean = mpq(sum(sides), len(sides))
    variance = sum((n - mean) ** 2 for n in sides) / mpq(len(sides) - 1)
    error = square_root(variance / SOURCE_PARTS)
    expected = expected_sides(POINTS)
    assert (mean - expected) ** 2 < 16 * variance / len(sides)
    assert expected > mpq("5.95")
    assert expected - mpq("5.95") < error
    assert error.decimal(2) == "0.02"
