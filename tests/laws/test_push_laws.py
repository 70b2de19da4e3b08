"""Laws of the radius function, the push and the push-grasp (thesis App. E), and of composition."""

from __future__ import annotations

from itertools import pairwise
from math import gcd

import numpy as np
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import CenterOfMassError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push import push_function
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import (
    TINY,
    centered_parts,
    circle_parts,
    directions,
    large_directions,
    long_centered_parts,
    orientations,
    parts,
    rational_orientations,
    ratios,
    rotations,
    shifts,
    symmetric_hulls,
    transfer_functions,
)

any_part = st.one_of(
    centered_parts(), centered_parts(), centered_parts(), circle_parts(), long_centered_parts()
)
radii = any_part.map(RadiusFunction)
positive = ratios.filter(lambda factor: factor > 0)


def height(chord, theta):
    """Return the height of a chord turned by theta, times the length of theta's direction."""
    (vx, vy), (x, y) = chord, theta.direction
    return vx * y + vy * x


# --- the radius function -------------------------------------------------------------------------


@given(any_part, rational_orientations)
def test_radius_of_a_part_is_that_of_its_hull(part, theta):
    """Refuted by an orientation at which the two differ."""
    hull = Part(part.hull.points.pairs(), part.center_of_mass)
    of_part, of_hull = RadiusFunction(part), RadiusFunction(hull)
    assert of_part.squared(theta) == of_hull.squared(theta)
    assert list(of_part.transitions) == list(of_hull.transitions)
    assert list(of_part.minima) == list(of_hull.minima)
    assert list(of_part.maxima) == list(of_hull.maxima)


@given(any_part, rational_orientations)
def test_radii_half_a_turn_apart_make_the_diameter(part, theta):
    """d(theta) = r(theta) + r(theta + 180 degrees); refuted by any other sum."""
    r, d = RadiusFunction(part), DiameterFunction(part)
    low, high, total = r.squared(theta), r.squared(theta + HALF_TURN), d.squared(theta)
    # (a + b)^2 = d^2 exactly if 4 a^2 b^2 = (d^2 - a^2 - b^2)^2 and d is not less than a and b.
    assert 4 * low * high == (total - low - high) ** 2
    assert total > low + high


@given(radii)
def test_pieces_tile_a_full_turn_and_fit_together(r):
    """Refuted by a gap, a jump, or a chord that does not belong to its vertex."""
    pieces = r.pieces
    assert pieces[0].arc.start >= ZERO
    assert pieces[-1].arc.end == pieces[0].arc.start + FULL_TURN
    for piece, following in pairwise((*pieces, pieces[0])):
        theta = following.arc.start
        assert piece.arc.end.reduced() == theta
        assert height(piece.chord, theta) == height(following.chord, theta) > 0
        x, y = r.part.vertices[piece.vertex]
        cx, cy = r.part.center_of_mass
        assert piece.chord == (cx - x, cy - y)
        assert piece.squared_amplitude == piece.chord[0] ** 2 + piece.chord[1] ** 2
        assert piece.phase == Angle(0, piece.chord)


@given(radii, rational_orientations)
def test_each_piece_gives_the_radius_on_its_arc(r, theta):
    """Refuted by a theta where the piece that holds it gives another value, or more than |v|."""
    x, y = theta.direction
    (piece,) = [p for p in r.pieces if p.arc.contains(theta)]
    assert r.squared(theta) == mpq(height(piece.chord, theta)) ** 2 / (x * x + y * y)
    assert 0 < r.squared(theta) <= piece.squared_amplitude
    assert r.squared(theta) == r.squared(theta - FULL_TURN)


@given(radii)
def test_minima_and_maxima_alternate(r):
    """Refuted by two minima in a row, or a maximum that is not above its neighbours."""
    minima, maxima = list(r.minima), list(r.maxima)
    assert len(minima) == len(maxima) >= 1
    assert all(ZERO <= angle < FULL_TURN for angle in (*minima, *maxima))
    merged = sorted([(a, "min") for a in minima] + [(a, "max") for a in maxima])
    assert [a for a, kind in merged if kind == "min"] == minima
    assert [a for a, kind in merged if kind == "max"] == maxima
    for k, (angle, kind) in enumerate(merged):
        assert kind != merged[k - 1][1]
        assert r.compare(angle, merged[k - 1][0]) == (1 if kind == "max" else -1)


@given(radii, st.integers(1, 10**6))
def test_extrema_are_strict_on_both_sides(r, closeness):
    """Refuted by an extremum with a neighbour as low, or as high."""
    step = Angle(0, (10**60 + closeness, 1))  # a centre may miss an end normal by 1e-32
    for angle in r.minima:
        assert r.compare(angle, angle + step) == r.compare(angle, angle - step) == -1
    for angle in r.maxima:
        assert r.compare(angle, angle + step) == r.compare(angle, angle - step) == 1


@given(radii)
def test_places_tell_what_touches_the_jaw(r):
    """Refuted by a minimum whose edge is not level, or a maximum whose vertex is not below."""
    points, (cx, cy) = r.part.hull.points, r.part.center_of_mass
    for angle, edge in zip(r.minima, r.stable.places, strict=True):
        (ax, ay), (bx, by) = points.point(int(edge)), points.point((int(edge) + 1) % len(points))
        assert (Angle(0, (bx - ax, by - ay)) + angle).reduced() == ZERO
    for angle, vertex in zip(r.maxima, r.unstable.places, strict=True):
        x, y = points.point(int(vertex))
        assert (Angle(0, (cx - x, cy - y)) + angle).reduced() == Angle(0, (0, 1))
        assert r.squared(angle) == (cx - x) ** 2 + (cy - y) ** 2


@given(any_part, directions, shifts, rational_orientations)
def test_turning_a_part_moves_its_radius_function(part, factor, shift, theta):
    """r'(theta) = |z| r(theta + arg z) for the part times z; refuted by any other value."""
    c, s = factor
    r, turn = RadiusFunction(part), Angle(0, factor)
    other = RadiusFunction(part.translate(*shift).multiply(factor))
    assert other.squared(theta) == r.squared(theta + turn) * (c * c + s * s)
    assert list(other.minima) == sorted((angle - turn).reduced() for angle in r.minima)
    assert list(other.maxima) == sorted((angle - turn).reduced() for angle in r.maxima)


@given(centered_parts(), st.lists(rational_orientations, min_size=1, max_size=5))
def test_float_values_are_near_the_exact_ones(part, thetas):
    """Refuted by a difference above 1e-9 of the diameter."""
    r, d = RadiusFunction(part), DiameterFunction(part)
    values = r.evaluate(np.array([theta.to_float() for theta in thetas]))
    for value, theta in zip(values, thetas, strict=True):
        size = float(d.squared(theta)) ** 0.5
        assert abs(value - float(r.squared(theta)) ** 0.5) < 1e-9 * size


@given(
    st.one_of(parts(), symmetric_hulls()),
    st.tuples(st.integers(-9, 9), st.integers(-9, 9)),
    st.sampled_from([1, 2, 3 * 10**14]),
    st.sampled_from([0, 1, -1]),
)
def test_a_center_is_refused_exactly_where_the_part_says_it_is_not_inside(part, half, size, near):
    """Refuted by a radius about a centre on the hull or outside it, or by none about one inside."""
    x, y = (mpq(v, 2) * size + mpq(near, 10**30) for v in half)
    part = Part(part.scale(size).vertices, (x, y))
    try:
        assert len(RadiusFunction(part).minima) >= 1
    except CenterOfMassError as error:
        side = {"on": 0, "outside": -1}[str(error).split(" lies ")[1].split()[0]]
        assert part.center_of_mass_side == side
    else:
        assert part.center_of_mass_side == 1


# --- push and push-grasp -------------------------------------------------------------------------


@given(any_part)
def test_values_of_a_push_lie_inside_their_steps(part):
    """b_j < v_j < b_(j+1); refuted by a step that does not hold its own value."""
    s = push_function(part)
    for k in range(len(s)):
        assert s.lifted_breaks[k] < s.lifted_values[k] < s.lifted_breaks[k + 1]
        assert s(s.values[k]) == s.values[k]


@given(any_part)
def test_no_push_ends_at_a_break_of_the_squeeze(part):
    """Refuted by a stable edge that lies flush where the diameter is largest."""
    push, breaks = push_function(part), DiameterFunction(part).maxima
    assert not {value % HALF_TURN for value in push.values} & set(breaks)


@given(any_part, orientations)
def test_push_grasp_is_squeeze_after_push(part, theta):
    """Refuted by an orientation at which the two roads part."""
    push, squeeze, both = push_function(part), squeeze_function(part), push_grasp_function(part)
    for angle in (theta, *push.breaks, *push.values, *both.values):
        assert both(angle) == squeeze(push(angle))
        assert both(angle - TINY) == squeeze(push(angle - TINY))
    assert set(both.breaks) <= {push.lifted_breaks[k] for k in range(len(push) * push.order)}


@given(any_part, orientations, orientations)
def test_push_grasps_are_monotone(part, one, other):
    """Refuted by two orientations that change places."""
    low, high = sorted((one, other))
    for s in (push_function(part), push_grasp_function(part)):
        assert s(low) <= s(high)
        assert s(low + s.period) == s(low) + s.period


@given(any_part, orientations)
def test_the_upper_jaw_pushes_half_a_turn_on(part, theta):
    """s_up(theta) = s(theta + 180 degrees) - 180 degrees; refuted by any other value."""
    for function in (push_function, push_grasp_function):
        lower, upper = function(part), function(part, upper_jaw=True)
        assert upper(theta) == lower(theta + HALF_TURN) - HALF_TURN
        upside_down = function(part.multiply((-1, 0)))
        assert upper == upside_down


@given(any_part, shifts, positive, rotations)
def test_similarity(part, shift, factor, direction):
    """Refuted by a moved, scaled or turned part whose map is not the one turned along."""
    for function in (push_function, push_grasp_function):
        s = function(part)
        assert function(part.translate(*shift)) == s
        assert function(part.scale(factor)) == s
        assert function(part.rotate(direction)) == s.rotate(-Angle(0, direction))


@given(any_part, st.one_of(directions, large_directions))
def test_multiplication_by_any_direction(part, direction):
    """Refuted by a part turned and scaled whose map is not s(theta + beta) - beta."""
    for function in (push_function, push_grasp_function):
        s = function(part)
        assert function(part.multiply(direction)) == s.rotate(-Angle(0, direction))


@given(any_part, st.integers(0, 20), st.booleans())
def test_vertex_order_and_start(part, start, backwards):
    """Refuted by the same outline, listed otherwise, with another map."""
    n = len(part)
    vertices = [part.vertices[(k + start) % n] for k in range(n)]
    other = Part(vertices[::-1] if backwards else vertices, part.center_of_mass)
    assert push_function(other) == push_function(part)
    assert push_grasp_function(other) == push_grasp_function(part)


def mirrored(s):
    """Return the map theta -> -s(-theta), made closed on the left."""
    values = [-s.lifted_values[k - 1] for k in range(len(s))]
    return StepFunction([-b for b in s.breaks][::-1], values[::-1], s.period)


@given(any_part)
def test_reflection(part):
    """A mirror image in the x axis is pushed by the other jaw; refuted by any other map."""
    image = part.reflect()
    for function in (push_function, push_grasp_function):
        assert function(image) == mirrored(function(part, upper_jaw=True))
        assert function(image, upper_jaw=True) == mirrored(function(part))


@given(symmetric_hulls())
def test_symmetric_parts_have_symmetric_pushes(part):
    """Refuted by a part that half a turn maps to itself, with a push that half a turn changes."""
    for function in (push_function, push_grasp_function):
        assert function(part).order % 2 == 0


# --- composition ---------------------------------------------------------------------------------


def slowly_composed(outer, inner):
    """Return the composite by applying both maps, one exact angle at a time."""
    shared = gcd(outer.order, inner.order)
    count = len(inner) * (inner.order // shared)
    return StepFunction(
        [inner.lifted_breaks[k] for k in range(count)],
        [outer(inner.lifted_values[k]) for k in range(count)],
        Angle.from_turns(mpq(1, shared)),
    )


lifts = st.sampled_from([0, 1, -1, 2, -5, 1000, -(2**29)])


def lifted(s, turns):
    """Return the map theta -> s(theta) + 2 pi turns."""
    return StepFunction(s.breaks, s.values.rotate(Angle(turns)), s.period)


any_map = st.builds(lifted, transfer_functions(), lifts)


@given(any_map, any_map)
def test_composition_is_that_of_single_angles(outer, inner):
    """Values on breaks, with a grid of 5 degrees, are the rule; refuted by any other map."""
    assert outer.compose(inner) == slowly_composed(outer, inner)


@given(any_map, any_map, rational_orientations)
def test_composition_applies_one_map_after_the_other(outer, inner, theta):
    """Refuted by a break, an angle just before one, or another angle with another value."""
    both = outer.compose(inner)
    assert both(theta) == outer(inner(theta))
    for angle in inner.breaks[:3]:
        assert both(angle) == outer(inner(angle))
        assert both(angle - TINY) == outer(inner(angle - TINY))


@given(any_map, any_map, rational_orientations, st.sampled_from([ZERO, TINY, -TINY]))
def test_composition_of_turned_maps(outer, inner, alpha, tiny):
    """Values that meet breaks, or miss them by less than floats show; refuted by another map."""
    turned = outer.after_turning(alpha + tiny)
    inner = inner.rotate(alpha)
    assert turned.compose(inner) == slowly_composed(turned, inner)


@given(any_map, any_map)
def test_composition_by_exact_decisions_alone(outer, inner):
    """With a shadow that is worth nothing every decision is exact; refuted by another map."""
    expected = outer.compose(inner)
    outer.lifted_breaks = LiftedAngles(outer.breaks, outer.period, error=1e3)
    assert outer.compose(inner) == expected
    assert outer.lifted_breaks.exact_decisions >= len(inner)


@given(any_part)
def test_push_values_are_told_from_squeeze_breaks_by_floats(part):
    """Refuted by an exact decision where no push value is near a squeeze break."""
    outer, inner = squeeze_function(part), push_function(part)
    assert outer.compose(inner) == slowly_composed(outer, inner)
    period = outer.period.to_float()
    ways = [(v.to_float() - b.to_float()) % period for v in inner.values for b in outer.breaks]
    if all(1e-9 < way < period - 1e-9 for way in ways):
        assert outer.lifted_breaks.exact_decisions == 0
