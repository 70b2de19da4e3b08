"""Hostile outlines for `stochgeom.geometry.simplicity`: every degeneracy, in every direction."""

from __future__ import annotations

from itertools import product

import pytest
from gmpy2 import mpz

from stochgeom.geometry.segments import ConflictKind, contains
from stochgeom.geometry.simplicity import find_conflict

CROSSING, TOUCHING, OVERLAPPING = ConflictKind


def ring(*pairs, w=1):
    return [(mpz(x), mpz(y), mpz(w)) for x, y in pairs]


def turned(rings, matrix):
    (a, b), (c, d) = matrix
    return [[(a * x + b * y, c * x + d * y, w) for x, y, w in ring] for ring in rings]


AXES = [((a, 0), (0, b)) for a, b in product((1, -1), repeat=2)]
AXES += [((0, a), (b, 0)) for a, b in product((1, -1), repeat=2)]
OBLIQUE = ((3, -4), (4, 3))


def answers(*rings):
    """Return the kinds found under all symmetries of the grid, the rotation (3, 4), reversal."""
    kinds = set()
    for matrix, step in product([*AXES, OBLIQUE], (1, -1)):
        conflict = find_conflict([ring[::step] for ring in turned(rings, matrix)])
        kinds.add(conflict and conflict.kind)
    return kinds


SQUARE = ring((0, 0), (6, 0), (6, 6), (0, 6))


@pytest.mark.parametrize(
    ("kinds", "rings"),
    [
        # vertical and horizontal edges one above the other, without contact
        ({None}, [ring((0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 4), (0, 4))]),
        ({None}, [SQUARE, ring((6, 7), (7, 7), (6, 9)), ring((0, -3), (0, -1), (-1, -1))]),
        ({None}, [SQUARE, ring((1, 1), (1, 5), (2, 5)), ring((2, 1), (2, 4), (3, 4))]),
        # a vertex on an edge: from inside, from outside, with one or two edges beyond it
        ({TOUCHING}, [ring((0, 0), (6, 0), (6, 6), (3, 0), (0, 6))]),
        ({TOUCHING}, [ring((0, 0), (6, 0), (6, 6), (4, 6), (2, 0), (3, 6), (0, 6))]),
        ({TOUCHING}, [SQUARE, ring((6, 3), (8, 2), (8, 4))]),
        ({TOUCHING}, [SQUARE, ring((1, 3), (6, 3), (1, 4))]),
        # a vertex on a vertex
        ({TOUCHING}, [SQUARE, ring((6, 6), (9, 7), (7, 9))]),
        ({TOUCHING}, [SQUARE, ring((0, 0), (2, 1), (1, 2))]),
        ({TOUCHING}, [ring((0, 0), (3, 3), (6, 0), (6, 6), (3, 3), (0, 6))]),
        ({TOUCHING}, [ring((0, 0), (3, 3), (6, 0), (0, 6), (3, 3), (6, 6))]),
        # corner to corner along one line: only a point is shared
        ({TOUCHING}, [ring((0, 0), (2, 0), (2, 2)), ring((2, 0), (4, 0), (4, -2))]),
        # spikes: tip free, tip on an edge's line, two steps long
        ({OVERLAPPING}, [ring((0, 0), (6, 0), (6, 3), (9, 3), (6, 3), (6, 6), (0, 6))]),
        ({OVERLAPPING, TOUCHING}, [ring((0, 0), (6, 0), (6, 8), (6, 6), (0, 6))]),
        ({OVERLAPPING}, [ring((0, 0), (4, 0), (8, 0))]),
        ({OVERLAPPING}, [ring((0, 0), (8, 0), (4, 0), (2, 0))]),
        # edges along edges: equal, nested, staggered
        ({OVERLAPPING}, [SQUARE, SQUARE]),
        ({OVERLAPPING}, [SQUARE, ring((6, 0), (9, 3), (6, 6))]),
        ({OVERLAPPING, TOUCHING}, [SQUARE, ring((6, 2), (9, 3), (6, 4))]),
        ({OVERLAPPING, TOUCHING}, [SQUARE, ring((6, 4), (9, 5), (6, 8))]),
        # crossings at an interior point that the sweep line passes with other events
        ({CROSSING}, [ring((0, 0), (6, 6), (6, 0), (0, 6))]),
        ({CROSSING}, [ring((0, 0), (4, 0), (4, 4)), ring((3, -9), (3, 2), (9, -9))]),
    ],
)
def test_each_contact_in_every_direction(kinds, rings):
    assert answers(*rings) <= kinds
    assert answers(*rings[::-1]) <= kinds


def test_edges_that_only_become_neighbours_when_what_is_between_them_ends():
    low, high = ring((0, 0), (20, 20), (20, -9)), ring((0, 8), (8, 1), (8, 2))
    between = ring((-1, 4), (1, 3), (2, 4), (1, 5))
    assert answers(low, high, between) == {CROSSING}


def test_many_edges_through_one_point():
    directions = [(k, 100 - abs(k)) for k in range(-99, 100)]
    points = [p for x, y in directions for p in [(x, y), (-x, -y)]]
    assert answers(ring(*points)) == {CROSSING}
    through_a_vertex = ring((0, 0), (200, 1), (200, 2))
    assert None not in answers(ring(*points), through_a_vertex)


# --- long outlines -------------------------------------------------------------------------------


def comb(teeth):
    """Four vertices a tooth; every long edge vertical."""
    tooth = [(0, 1), (0, 90), (2, 90), (2, 1)]
    points = [(4 * k + x, y) for k in range(teeth) for x, y in tooth]
    return ring(*points, (4 * teeth, -1), (0, -1))


def spiral(corners):
    """Two polygonal spirals around the origin, joined at both ends."""
    around = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    inner = [(k * around[k % 4][0], k * around[k % 4][1]) for k in range(4, corners + 4)]
    outer = [
        ((k + 2) * around[k % 4][0], (k + 2) * around[k % 4][1]) for k in range(4, corners + 4)
    ]
    return ring(*inner, *outer[::-1])


@pytest.mark.parametrize("outline", [comb(500), spiral(1_000)], ids=["comb", "spiral"])
def test_long_outlines(outline):
    assert len(outline) >= 2_000
    assert answers(outline) == {None}
    middle = len(outline) // 4 + 1
    onto_another = [*outline]
    onto_another[middle] = outline[middle + 10]
    assert None not in answers(onto_another)
    far_out = [*outline]
    far_out[middle] = (mpz(10**4), mpz(10**4), mpz(1))
    assert None not in answers(far_out)


def test_a_thousand_collinear_points_a_side():
    side = [(k, 0) for k in range(1_000)]
    square = side
    for _ in range(3):
        square = [*side, *((1_000 - y, x) for x, y in square)]
    assert answers(ring(*square)) == {None}
    dented = [*square]
    dented[1_500] = (0, 500)  # a vertex of the opposite side
    assert answers(ring(*dented)) <= {TOUCHING, CROSSING, OVERLAPPING}
    hook = ring((500, 1), (900, 1), (900, 0), (901, 0), (901, 2))
    assert answers(ring(*square), hook) <= {TOUCHING, OVERLAPPING}


def test_thousands_of_edges_are_open_when_the_conflict_comes():
    fans = [(x, y) for k in range(5_000) for x, y in [(0, 2 * k), (10**6 + k, 2 * k + 1)]]
    outline = [*fans, (0, 10**4), (-1, 10**4), (-1, 0)]
    assert find_conflict([ring(*outline)]) is None
    outline[4_001] = (10**6 + 2_000, 4_003)  # the next tip lies there or the edges cross
    assert find_conflict([ring(*outline)]) is not None


def test_multiplications_grow_like_n_log_n():
    count = 0

    class Counted(int):
        def __mul__(self, other):
            nonlocal count
            count += 1
            return int(self) * int(other)

        __rmul__ = __mul__

    def effort(teeth):
        nonlocal count
        count = 0
        tips = [(x, y) for k in range(teeth) for x, y in [(k % 7, 2 * k), (99, 2 * k + 1)]]
        outline = [*tips, (0, 2 * teeth), (-1, 2 * teeth), (-1, 0)]
        assert find_conflict([[(Counted(x), Counted(y), 1) for x, y in outline]]) is None
        return count

    # 16 log(16 n) / log(n) is 22 here; 256 would be quadratic.
    assert effort(4_000) < 40 * effort(250)


# --- large and nearly equal numbers --------------------------------------------------------------

TINY = mpz(2) ** 200  # 1 / TINY is the smallest step


def notched(step):
    """A notch whose tip is `step` / 2^200 above the edge from (0, 0) to (10, 7)."""
    outline = [(0, 0), (10, 7), (10, 20), (4, 2), (0, 20)]
    scaled = [(5 * TINY * x, 5 * TINY * y) for x, y in outline]
    scaled[3] = 20 * TINY, 14 * TINY + 5 * step
    return ring(*scaled, w=5 * TINY)


def test_two_to_the_minus_200_decides():
    assert answers(notched(1)) == {None}
    assert answers(notched(0)) == {TOUCHING}
    assert answers(notched(-1)) == {CROSSING}


def test_edges_whose_directions_differ_by_two_to_the_minus_200():
    assert answers(ring((0, 0), (TINY, 0), (TINY // 2, 1))) == {None}
    assert answers(ring((0, 0), (TINY, 0), (TINY // 2, 0))) == {OVERLAPPING}
    zigzag = [(x, y) for k in range(200) for x, y in [(0, 2 * k), (TINY, 2 * k + 1)]]
    closed = [*zigzag, (0, 400), (-TINY, 400), (-TINY, 0)]
    assert answers(ring(*closed, w=TINY)) == {None}
    closed[201] = TINY, 199  # the tip before it, from the same root
    assert answers(ring(*closed, w=TINY)) == {OVERLAPPING}
    closed[201] = TINY, 198
    assert answers(ring(*closed, w=TINY)) == {CROSSING}


@pytest.mark.parametrize("far", [0, 7 * mpz(10) ** 400], ids=["near", "far"])
def test_coordinates_of_400_digits(far):
    big = mpz(10) ** 399 + 1
    for lift, kind in [(1, None), (0, TOUCHING), (-1, CROSSING)]:
        points = [(0, 0), (6 * big, 2 * big), (6 * big, 9 * big), (3 * big, big + lift), (0, big)]
        assert answers(ring(*((x + far, y - far) for x, y in points))) == {kind}


def test_denominators_of_400_digits():
    outline = [(0, 0), (6, 2), (6, 9), (3, 1), (0, 1)]
    factors = [mpz(10) ** 400 + k for k in range(5)]
    for lift, kind in [(1, None), (0, TOUCHING), (-1, CROSSING)]:
        points = [(x * w, y * w, w) for (x, y), w in zip(outline, factors, strict=True)]
        x, y, w = points[3]
        points[3] = x, y + lift, w
        assert answers(points) == {kind}


def test_contains_by_two_to_the_minus_200():
    triangle = ring((0, 0), (7, 3), (0, 9))
    for step in (1, 0, -1):
        assert contains(triangle, (14 * TINY, 6 * TINY + step, 4 * TINY)) == step
        assert contains(triangle[::-1], (14 * TINY, 6 * TINY + step, 4 * TINY)) == step
