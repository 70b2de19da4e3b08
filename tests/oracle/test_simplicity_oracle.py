"""`stochgeom.geometry.simplicity` against all pairs of edges, met by their parameters."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import combinations, cycle

from gmpy2 import mpz
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.geometry.segments import ConflictKind, contains, pair_conflict
from stochgeom.geometry.simplicity import find_conflict

MANY = max(2_000, settings().max_examples)


# --- the slow road -------------------------------------------------------------------------------


def plain(point):
    """Return both coordinates as fractions, or as integers if they are, for speed."""
    x, y, w = map(int, point)
    return (x // w, y // w) if x % w == y % w == 0 else (Fraction(x, w), Fraction(y, w))


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def meeting(first, second):
    """Return how two segments meet, from the parameters of their common points."""
    (a, b), (c, d) = first, second
    along, across, gap = minus(b, a), minus(d, c), minus(c, a)
    det = cross(along, across)
    if det != 0:
        t, u = Fraction(cross(gap, across), det), Fraction(cross(gap, along), det)
        if not (0 <= t <= 1 and 0 <= u <= 1):
            return None
        return ConflictKind.CROSSING if 0 < t < 1 and 0 < u < 1 else ConflictKind.TOUCHING
    if cross(gap, along) != 0:
        return None
    ends = sorted(Fraction(dot(minus(end, a), along), dot(along, along)) for end in (c, d))
    low, high = max(ends[0], 0), min(ends[1], 1)
    if low > high:
        return None
    return ConflictKind.OVERLAPPING if low < high else ConflictKind.TOUCHING


def all_conflicts(rings):
    edges = {
        (number, k): (plain(point), plain(ring[(k + 1) % len(ring)]))
        for number, ring in enumerate(rings)
        for k, point in enumerate(ring)
    }
    found = {}
    for (one, first), (other, second) in combinations(edges.items(), 2):
        kind = meeting(first, second)
        gap = other[1] - one[1]
        consecutive = one[0] == other[0] and gap in (1, len(rings[one[0]]) - 1)
        if kind is not None and (not consecutive or kind is ConflictKind.OVERLAPPING):
            found[one, other] = kind
    return found


def slow_contains(ring, point):
    """Count the edges that a ray crosses whose direction avoids every vertex."""
    p = plain(point)
    edges = [(plain(q), plain(ring[k - 1])) for k, q in enumerate(ring)]
    if any(cross(minus(a, p), minus(b, p)) == 0 >= dot(minus(a, p), minus(b, p)) for a, b in edges):
        return 0
    directions = ((Fraction(7), Fraction(1, k)) for k in range(1, 1000))
    ray = next(d for d in directions if all(cross(d, minus(a, p)) != 0 for a, _ in edges))
    crossed = 0
    for a, b in edges:
        if cross(ray, minus(a, p)) * cross(ray, minus(b, p)) < 0:
            along = minus(b, a)
            crossed += cross(minus(a, p), along) / cross(ray, along) > 0
    return 1 if crossed % 2 else -1


# --- inputs --------------------------------------------------------------------------------------


def _distinct_neighbours(pairs):
    """Drop each pair that equals the next one, cyclically."""
    return [p for k, p in enumerate(pairs) if p != pairs[(k + 1) % len(pairs)]]


def _around(pairs):
    """Put points into the order of an x-monotone polygon: simple unless points are collinear."""
    pairs = sorted(pairs)
    chord = minus(pairs[-1], pairs[0])
    above = [p for p in pairs[1:-1] if cross(chord, minus(p, pairs[0])) > 0]
    below = [p for p in pairs[1:-1] if p not in above]
    return [pairs[0], *below, pairs[-1], *above[::-1]]


@st.composite
def _ring(draw, reach=4, most=8, scale=1, shift=(0, 0)):
    """Vertices on a small grid: as drawn, or monotone, or monotone with one vertex moved.

    Some of the homogeneous points carry a needless factor.
    """
    side = 2 * reach + 1
    point = st.integers(0, side * side - 1).map(lambda k: (k // side - reach, k % side - reach))
    mode = draw(st.sampled_from(["as drawn", "monotone", "monotone", "moved"]))
    pairs = draw(st.lists(point, min_size=3, max_size=most, unique=mode != "as drawn"))
    if mode != "as drawn":
        pairs = _around(pairs)[:: draw(st.sampled_from([1, -1]))]
    if mode == "moved":
        pairs[len(pairs) // 2] = draw(point)
    pairs = _distinct_neighbours(pairs)
    assume(len(pairs) >= 3)
    factors = draw(st.sampled_from([[1], [2], [1, 2, 3]]))
    placed = [(scale * x + shift[0], scale * y + shift[1]) for x, y in pairs]
    return [(mpz(x * w), mpz(y * w), mpz(w)) for (x, y), w in zip(placed, cycle(factors))]


@st.composite
def _rings(draw):
    """An outline and one or two small rings, which often lie inside it or apart from it."""
    rings = [draw(_ring(scale=3))]
    for _ in range(draw(st.integers(1, 2))):
        shift = draw(st.integers(-10, 10)), draw(st.integers(-10, 10))
        rings.append(draw(_ring(reach=1, most=4, shift=shift)))
    return rings


def _bent(rings):
    """Map the plane projectively: lines stay lines, and meet as before, at fractional places."""
    return [[(x, y, 50 * w + x + 2 * y) for x, y, w in ring] for ring in rings]


_straight = st.one_of(_ring().map(lambda ring: [ring]), _rings())
_input = st.one_of(_straight, _straight.map(_bent))


def test_all_answers_are_common():
    seen = Counter()

    @settings(max_examples=500, derandomize=True, database=None)
    @given(_input)
    def look(rings):
        conflict = find_conflict(rings)
        seen[len(rings) > 1, conflict and conflict.kind] += 1

    look()
    assert len(seen) == 8  # simple, crossing, touching, overlapping; with and without holes
    assert min(seen.values()) >= 5
    assert min(seen[False, None], seen[True, None]) >= 25


# --- the comparison ------------------------------------------------------------------------------


@settings(max_examples=MANY)
@given(_input)
def test_conflict_is_found_iff_there_is_one(rings):
    expected = all_conflicts(rings)
    conflict = find_conflict(rings)
    if conflict is None:
        assert not expected
    else:
        assert expected[conflict.first, conflict.second] is conflict.kind
        assert find_conflict(rings) == conflict


@given(_input, st.randoms(use_true_random=False))
def test_answer_does_not_depend_on_start_direction_or_axes(rings, random):
    def turned(ring):
        start = random.randrange(len(ring))
        ring = (ring[start:] + ring[:start])[:: random.choice((1, -1))]
        return [(sx * p[i], sy * p[1 - i], p[2]) for p in ring]

    i, sx, sy = random.randrange(2), random.choice((1, -1)), random.choice((1, -1))
    answer = find_conflict(rings) is None
    assert (find_conflict([turned(ring) for ring in rings]) is None) == answer


@given(st.tuples(*[st.tuples(st.integers(-3, 3), st.integers(-3, 3))] * 4), st.integers(1, 3))
def test_pair_conflict_is_the_meeting_of_the_parameters(corners, w):
    a, b, c, d = [(Fraction(x), Fraction(y)) for x, y in corners]
    assume(a != b)
    assume(c != d)
    p, q, r, s = [(mpz(x * w), mpz(y * w), mpz(w)) for x, y in corners]
    assert pair_conflict((p, q), (r, s)) is meeting((a, b), (c, d))


@given(_ring(), st.tuples(st.integers(-9, 9), st.integers(-9, 9), st.integers(1, 2)))
def test_contains_is_the_parity_of_a_ray(ring, point):
    assume(find_conflict([ring]) is None)
    assert contains(ring, point) == slow_contains(ring, point)
