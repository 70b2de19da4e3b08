"""Worked cases of `stochgeom.geometry.simplicity` and its order of edges."""

from __future__ import annotations

import pytest
from gmpy2 import mpz

from stochgeom.errors import InvalidPartError, TooFewVerticesError
from stochgeom.geometry.segments import ConflictKind, contains, pair_conflict
from stochgeom.geometry.simplicity import Conflict, find_conflict
from stochgeom.geometry.sweep_order import Place, SweepOrder, line_through

CROSSING, TOUCHING, OVERLAPPING = ConflictKind


def ring(*pairs):
    return [(mpz(x), mpz(y), mpz(1)) for x, y in pairs]


SQUARE = ring((0, 0), (6, 0), (6, 6), (0, 6))


def edge(ax, ay, bx, by):
    return (ax, ay, 1), (bx, by, 1)


# --- find_conflict -------------------------------------------------------------------------------


def test_simple_outlines_have_no_conflict():
    assert find_conflict([ring((0, 0), (1, 0), (0, 1))]) is None
    assert find_conflict([SQUARE]) is None
    assert find_conflict([SQUARE[::-1]]) is None
    assert find_conflict([ring((0, 0), (3, 1), (6, 0), (4, 3), (6, 6), (3, 5), (0, 6))]) is None


def test_straight_angles_are_no_conflict():
    assert find_conflict([ring((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 1))]) is None


def test_crossing():
    assert find_conflict([ring((0, 0), (2, 2), (2, 0), (0, 2))]) == Conflict(
        CROSSING, (0, 0), (0, 2)
    )


def test_vertex_on_an_edge_touches():
    on_the_floor = ring((0, 0), (4, 0), (4, 4), (2, 0), (0, 4))
    assert find_conflict([on_the_floor]) == Conflict(TOUCHING, (0, 0), (0, 3))
    on_a_wall = ring((0, 0), (4, 0), (4, 4), (0, 4), (0, 3), (4, 2), (0, 1))
    conflict = find_conflict([on_a_wall])
    assert conflict.kind is TOUCHING
    assert conflict.first == (0, 1)
    assert conflict.second in [(0, 4), (0, 5)]


def test_equal_vertices_touch():
    conflict = find_conflict([ring((0, 0), (2, 2), (4, 0), (4, 4), (2, 2), (0, 4))])
    assert conflict == Conflict(TOUCHING, (0, 0), (0, 3))


def test_spike_overlaps():
    spike_to_the_right = ring((0, 0), (6, 0), (6, 3), (9, 3), (6, 3), (6, 6), (0, 6))
    assert find_conflict([spike_to_the_right]) == Conflict(OVERLAPPING, (0, 2), (0, 3))
    half_way_back = ring((0, 0), (6, 0), (6, 3), (9, 3), (7, 3), (7, 6), (0, 6))
    assert find_conflict([half_way_back]).kind is OVERLAPPING
    assert find_conflict([ring((0, 0), (3, 0), (1, 0))]).kind is OVERLAPPING


def test_shared_stretch_overlaps():
    outline = ring((0, 0), (6, 0), (6, 2), (4, 2), (4, 0), (2, 0), (2, 2), (0, 2))
    assert find_conflict([outline]) == Conflict(OVERLAPPING, (0, 0), (0, 4))


def test_rings_may_lie_anywhere_but_not_meet():
    inside = ring((1, 1), (2, 1), (2, 2))
    outside = ring((7, 0), (8, 0), (8, 8))
    assert find_conflict([SQUARE, inside, outside]) is None
    through = ring((5, 3), (7, 3), (7, 4))
    conflict = find_conflict([SQUARE, through])
    assert conflict.kind is CROSSING
    assert conflict.first == (0, 1)
    assert conflict.second[0] == 1
    assert find_conflict([SQUARE, ring((0, 3), (1, 2), (1, 4))]).kind is TOUCHING
    assert find_conflict([SQUARE, SQUARE]).kind is OVERLAPPING


def test_no_rings():
    assert find_conflict([]) is None


def test_denominators_are_taken_into_account():
    third = [(mpz(1), mpz(0), mpz(3)), (mpz(4), mpz(0), mpz(2)), (mpz(1), mpz(1), mpz(1))]
    assert find_conflict([third]) is None
    same_point = [(0, 0, 1), (2, 2, 1), (4, 0, 1), (12, 12, 3), (6, 6, 3), (0, 20, 5)]
    assert find_conflict([same_point]).kind is TOUCHING


def test_plain_integers_are_welcome():
    assert find_conflict([[(0, 0, 1), (2, 2, 1), (2, 0, 1), (0, 2, 1)]]).kind is CROSSING


def test_too_few_vertices():
    with pytest.raises(TooFewVerticesError, match="ring 1: 2 vertices"):
        find_conflict([SQUARE, SQUARE[:2]])


def test_repeated_consecutive_vertices():
    with pytest.raises(InvalidPartError, match="ring 1, vertex 2: equal to a neighbouring"):
        find_conflict([SQUARE, [(1, 1, 1), (3, 2, 1), (6, 4, 2), (1, 2, 1)]])


# --- pair_conflict -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("first", "second", "kind"),
    [
        (edge(0, 0, 2, 2), edge(0, 2, 2, 0), CROSSING),
        (edge(0, 0, 2, 2), edge(0, 2, 1, 1), TOUCHING),
        (edge(0, 0, 2, 2), edge(2, 2, 3, 0), TOUCHING),
        (edge(0, 0, 2, 2), edge(3, 3, 2, 2), TOUCHING),
        (edge(0, 0, 2, 2), edge(3, 3, 1, 1), OVERLAPPING),
        (edge(0, 0, 0, 9), edge(0, 4, 0, 3), OVERLAPPING),
        (edge(0, 0, 2, 2), edge(0, 0, 2, 2), OVERLAPPING),
        (edge(0, 0, 2, 2), edge(3, 3, 4, 4), None),
        (edge(0, 0, 2, 2), edge(0, 1, 2, 3), None),
        (edge(0, 0, 2, 2), edge(0, 5, 5, 0), None),
        (edge(0, 0, 2, 2), edge(3, 2, 3, 4), None),
        (edge(0, 0, 2, 2), edge(5, 5, 6, 7), None),
    ],
)
def test_pair_conflict(first, second, kind):
    for one in (first, first[::-1]):
        for other in (second, second[::-1]):
            assert pair_conflict(one, other) is kind
            assert pair_conflict(other, one) is kind


def test_consecutive_edges():
    assert pair_conflict(edge(0, 0, 2, 0), edge(2, 0, 0, 1), consecutive=True) is None
    assert pair_conflict(edge(0, 0, 2, 0), edge(2, 0, 3, 0), consecutive=True) is None
    assert pair_conflict(edge(0, 0, 2, 0), edge(2, 0, -3, 0), consecutive=True) is OVERLAPPING
    assert pair_conflict(edge(0, 2, 0, 0), edge(0, 0, 0, 1), consecutive=True) is OVERLAPPING


# --- contains ------------------------------------------------------------------------------------


def test_contains():
    arrow = ring((0, 0), (4, 2), (0, 4), (2, 2))
    places = {(1, 2, 1): -1, (2, 2, 1): 0, (3, 2, 1): 1, (5, 2, 1): -1, (-1, 2, 1): -1}
    places |= {(0, 0, 1): 0, (-1, 0, 1): -1, (1, 1, 2): 0, (2, 1, 1): 0, (2, 3, 2): -1}
    for around in (arrow, arrow[::-1]):
        assert {point: contains(around, point) for point in places} == places


def test_contains_along_horizontal_edges():
    steps = ring((0, 0), (6, 0), (6, 2), (4, 2), (4, 1), (2, 1), (2, 2), (0, 2))
    assert [contains(steps, (x, 1, 1)) for x in range(-1, 8)] == [-1, 0, 1, 0, 0, 0, 1, 0, -1]
    assert [contains(steps, (x, 2, 1)) for x in range(-1, 8)] == [-1, 0, 0, 0, -1, 0, 0, 0, -1]
    assert [contains(steps, (x, 0, 1)) for x in range(-1, 8)] == [-1] + [0] * 7 + [-1]


# --- the order of edges --------------------------------------------------------------------------


def test_order_follows_insertions_and_removals():
    """A thousand horizontal edges, put in and taken out in a scattered order."""
    scattered = [k * 377 % 1000 for k in range(1000)]
    order, places = SweepOrder(), {}
    for height in scattered:
        left = (mpz(0), mpz(height), mpz(1))
        below, above, hit = order.locate(left)
        assert hit is None
        assert (below and below.edge) == max((h for h in places if h < height), default=None)
        assert (above and above.edge) == min((h for h in places if h > height), default=None)
        places[height] = Place(height, left, (mpz(1), mpz(height), mpz(1)), 0)
        order.insert(places[height], below, above)
    for height in scattered[:500]:
        order.remove(places.pop(height))
    for height in range(1000):
        below, above, hit = order.locate((0, height, 1))
        assert (hit is not None) == (height in places)
        if hit is None:
            assert (below and below.edge) == max((h for h in places if h < height), default=None)
            assert (above and above.edge) == min((h for h in places if h > height), default=None)
    for place in places.values():
        order.remove(place)
    assert order.locate((0, 0, 1)) == (None, None, None)


def test_vertical_edge_has_the_smaller_x_above_it():
    place = Place(0, (1, 0, 1), (1, 5, 1), 0)
    assert place.line == line_through((1, 0, 1), (1, 5, 1))
    assert place.side((0, 2, 1)) > 0
    assert place.side((1, 2, 1)) == 0
    assert place.side((2, 2, 1)) < 0
