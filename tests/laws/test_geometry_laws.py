"""Laws of parts, hulls and calipers (thesis App. D)."""

from __future__ import annotations

import numpy as np
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.predicates import cross_sign
from stochgeom.geometry.calipers import NO_EDGE, antipodal_pairs, rotate_calipers
from stochgeom.geometry.hull import ConvexHull, convex_hull, convex_outline, locate
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Points
from tests.strategies import circle_parts, directions, parts, rational_parts, shifts

any_part = st.one_of(parts(), rational_parts(), circle_parts())


def cyclic(pairs):
    """Return a cyclic sequence from its smallest member on."""
    start = pairs.index(min(pairs))
    return pairs[start:] + pairs[:start]


def corners(hull):
    return cyclic(hull.points.pairs())


def homogeneous(points):
    """Return the same points with a denominator of its own for each."""
    rows = [
        (x * (k + 2), y * (k + 2), w * (k + 2) * points.scale)
        for k, (x, y, w) in enumerate(points.homogeneous())
    ]
    columns = []
    for column in zip(*rows, strict=True):
        array = np.empty(len(rows), dtype=object)
        array[:] = column
        columns.append(array)
    return Points(*columns, 1)


# --- hull ----------------------------------------------------------------------------------------


@given(any_part)
def test_hull_is_idempotent(part):
    """Refuted by a hull whose own hull has other vertices."""
    hull = part.hull
    again = convex_hull(hull.points)
    assert corners(again) == corners(hull)
    recognised = convex_outline(hull.points)
    assert corners(recognised) == corners(hull)


@given(any_part)
def test_hull_is_strictly_convex_and_holds_every_vertex(part):
    """Refuted by a turn that is not to the left, a vertex right of a hull edge, a wrong number."""
    hull = part.hull.points.pairs()
    n = len(hull)
    for k in range(n):
        (px, py), (qx, qy), (rx, ry) = hull[k], hull[(k + 1) % n], hull[(k + 2) % n]
        assert cross_sign(qx - px, qy - py, rx - qx, ry - qy) == 1
        for x, y in part.vertices:
            assert cross_sign(qx - px, qy - py, x - px, y - py) >= 0
    assert hull == tuple(part.vertices[k] for k in part.hull.indices)


@given(any_part)
def test_both_roads_to_a_hull_agree(part):
    """Refuted by a convex outline whose recognised hull is not the one that sorting finds."""
    assert corners(convex_hull(part.points)) == corners(part.hull)


@given(any_part, st.integers(0, 20), st.booleans(), st.data())
def test_hull_does_not_depend_on_order_start_or_repeats(part, start, backwards, data):
    """Refuted by an equal outline, listed otherwise, with another hull, area or centroid."""
    n = len(part)
    outline = [part.vertices[(k + start) % n] for k in range(n)]
    twice = data.draw(st.sets(st.integers(0, n - 1)))
    outline = [p for k, p in enumerate(outline) for _ in range(2 if k in twice else 1)]
    other = Part(outline[::-1] if backwards else outline)
    assert corners(other.hull) == corners(part.hull)
    assert (other.area, other.centroid) == (part.area, part.centroid)


@given(any_part, st.data())
def test_vertices_on_straight_edges_do_not_matter(part, data):
    """Refuted by a midpoint put into an edge that changes hull, area or centroid."""
    n = len(part)
    chosen = data.draw(st.sets(st.integers(0, n - 1), min_size=1))
    outline = []
    for k, (x, y) in enumerate(part.vertices):
        outline.append((x, y))
        if k in chosen:
            u, v = part.vertices[(k + 1) % n]
            outline.append(((x + u) / 2, (y + v) / 2))
    other = Part(outline)
    assert corners(other.hull) == corners(part.hull)
    assert (other.area, other.centroid) == (part.area, part.centroid)


@given(any_part)
def test_centroid_lies_strictly_inside_the_hull(part):
    """Refuted by a uniform centroid on or outside the hull; vertices are on it or inside."""
    assert part.center_of_mass_side == 1
    assert all(locate(part.hull, vertex) >= 0 for vertex in part.vertices)
    assert all(locate(part.hull, corner) == 0 for corner in part.hull.points.pairs())


# --- maps ----------------------------------------------------------------------------------------


@given(any_part, directions, shifts)
def test_similarity_maps_carry_area_and_centroid(part, factor, shift):
    """Refuted by a centroid that does not move as the vertices do, or a wrong change of area."""
    c, s = factor
    x, y = part.centroid
    turned = part.multiply(factor)
    assert turned.area == part.area * (c * c + s * s)
    assert turned.centroid == (c * x - s * y, s * x + c * y)
    moved = part.translate(*shift)
    assert moved.area == part.area
    assert moved.centroid == (x + mpq(shift[0]), y + mpq(shift[1]))
    mirrored = part.reflect()
    assert mirrored.area == part.area
    assert mirrored.centroid == (x, -y)


@given(any_part, directions, shifts)
def test_similarity_maps_carry_the_hull(part, factor, shift):
    """Refuted by a map after which another set of vertices is on the hull."""
    numbers = sorted(part.hull.indices)
    for other in (part.multiply(factor), part.translate(*shift), part.reflect()):
        assert sorted(other.hull.indices) == numbers


# --- calipers ------------------------------------------------------------------------------------


@given(any_part)
def test_antipodal_pairs_are_at_most_three_halves_n(part):
    """App. D; refuted by a hull with more than 3 n / 2 pairs. A vertex belongs to one at least."""
    pairs = antipodal_pairs(part.hull)
    assert 2 * len(pairs) <= 3 * len(part.hull)
    assert pairs == sorted(set(pairs))
    assert {k for pair in pairs for k in pair} == set(range(len(part.hull)))


@given(any_part)
def test_contacts_move_over_each_edge_once_in_half_a_turn(part):
    """Refuted by an edge flush never or twice, a transition without one, a contact that jumps."""
    calipers, n = rotate_calipers(part.hull), len(part.hull)
    flush = []
    for t in range(len(calipers)):
        before = len(flush)
        for edge, old, new in (
            (calipers.lower_edge[t], calipers.lower_before[t], calipers.lower[t]),
            (calipers.upper_edge[t], calipers.upper_before[t], calipers.upper[t]),
        ):
            if edge == NO_EDGE:
                assert new == old
            else:
                assert (old, new) == ((edge + 1) % n, edge)
                flush.append(int(edge))
        assert len(flush) > before
    assert sorted(flush) == list(range(n))


@given(st.one_of(parts(), rational_parts()))
def test_homogeneous_points_give_the_same_answers(part):
    """Refuted by a hull or a contact that depends on how the points are stored."""
    points = part.hull.points
    other = homogeneous(points)
    assert other.pairs() == points.pairs()
    assert convex_hull(other).indices.tolist() == convex_hull(points).indices.tolist()
    one = rotate_calipers(ConvexHull(points, part.hull.indices))
    two = rotate_calipers(ConvexHull(other, part.hull.indices))
    for name in ("lower", "upper", "lower_edge", "upper_edge"):
        assert getattr(one, name).tolist() == getattr(two, name).tolist()


# --- values --------------------------------------------------------------------------------------


@given(any_part)
def test_repr_reads_back(part):
    """Refuted by a part whose repr evaluates to another part."""
    again = eval(repr(part))
    assert again == part
    assert hash(again) == hash(part)
