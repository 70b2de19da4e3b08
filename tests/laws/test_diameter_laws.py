"""Laws of the diameter function (thesis Def. 4.1, App. D)."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from tests.strategies import (
    circle_parts,
    directions,
    parts,
    rational_orientations,
    rational_parts,
    ratios,
    shifts,
)

any_part = st.one_of(parts(), rational_parts(), circle_parts())
diameters = any_part.map(DiameterFunction)


def height(chord, theta):
    """Return the height of a chord turned by theta, times the length of theta's direction."""
    (vx, vy), (x, y) = chord, theta.direction
    return vx * y + vy * x


# --- Def. 4.1 ------------------------------------------------------------------------------------


@given(any_part, rational_orientations)
def test_diameter_of_a_part_is_that_of_its_hull(part, theta):
    """Refuted by an orientation at which the two differ."""
    of_part, of_hull = DiameterFunction(part), DiameterFunction(Part(part.hull.points.pairs()))
    assert of_part.squared(theta) == of_hull.squared(theta)
    assert list(of_part.transitions) == list(of_hull.transitions)
    assert list(of_part.minima) == list(of_hull.minima)
    assert list(of_part.maxima) == list(of_hull.maxima)


@given(diameters, rational_orientations)
def test_diameter_has_period_half_a_turn(d, theta):
    """Refuted by a theta with d(theta + 180 degrees) != d(theta)."""
    assert d.squared(theta + HALF_TURN) == d.squared(theta)
    assert d.compare(theta, theta - HALF_TURN) == 0


@given(diameters)
def test_diameter_is_continuous_at_transitions(d):
    """Refuted by a transition where the sinusoids on its left and right differ."""
    pieces = d.pieces
    for k, piece in enumerate(pieces):
        left, theta = pieces[k - 1], piece.arc.start
        if k == 0:
            # Half a turn earlier the last sinusoid has the same, positive, height.
            assert height(left.chord, theta + HALF_TURN) == height(piece.chord, theta) > 0
        else:
            assert height(left.chord, theta) == height(piece.chord, theta) > 0


@given(diameters)
def test_pieces_tile_half_a_turn(d):
    """Refuted by a gap or an overlap, or a piece without its own two vertices."""
    pieces = d.pieces
    for piece, following in pairwise(pieces):
        assert piece.arc.end == following.arc.start
    assert pieces[-1].arc.end == pieces[0].arc.start + HALF_TURN
    assert pieces[0].arc.start >= ZERO
    for piece in pieces:
        assert ZERO < piece.arc.width < HALF_TURN
        (ax, ay), (bx, by) = (d.part.vertices[k] for k in piece.vertices)
        assert piece.chord == (bx - ax, by - ay)
        assert piece.squared_amplitude == piece.chord[0] ** 2 + piece.chord[1] ** 2
        assert piece.phase == Angle(0, piece.chord)


@given(diameters, rational_orientations)
def test_each_piece_gives_the_diameter_on_its_arc(d, theta):
    """Refuted by a theta where the piece that holds it gives another value, or more than |v|."""
    x, y = theta.direction
    (piece,) = [p for p in d.pieces if p.arc.contains(theta) or p.arc.contains(theta + HALF_TURN)]
    assert d.squared(theta) == mpq(height(piece.chord, theta)) ** 2 / (x * x + y * y)
    assert 0 < d.squared(theta) <= piece.squared_amplitude


@given(any_part)
def test_the_largest_diameter_is_that_of_the_point_set(part):
    """Refuted by a maximum that is not the largest distance of two vertices."""
    d = DiameterFunction(part)
    farthest = max((a - c) ** 2 + (b - e) ** 2 for (a, b), (c, e) in combinations(part.vertices, 2))
    assert max(map(d.squared, d.maxima)) == farthest


# --- extrema -------------------------------------------------------------------------------------


@given(diameters)
def test_minima_and_maxima_alternate(d):
    """Refuted by two minima in a row, or a maximum that is not above its neighbours."""
    minima, maxima = list(d.minima), list(d.maxima)
    assert len(minima) == len(maxima) >= 1
    assert all(ZERO <= angle < HALF_TURN for angle in (*minima, *maxima))
    assert minima == sorted(set(minima))
    assert maxima == sorted(set(maxima))
    merged = sorted([(a, "min") for a in minima] + [(a, "max") for a in maxima])
    kinds = [kind for _, kind in merged]
    assert all(kind != kinds[k - 1] for k, kind in enumerate(kinds))
    angles = [angle for angle, _ in merged]
    for k, (angle, kind) in enumerate(merged):
        above = d.compare(angle, angles[k - 1])
        assert above == (1 if kind == "max" else -1)


@given(diameters, rational_orientations)
def test_diameter_rises_and_falls_between_extrema(d, theta):
    """Refuted by a theta outside the values of the two extrema that enclose it."""
    around = sorted([*d.minima, *d.maxima])
    around = [around[-1] - HALF_TURN, *around, around[0] + HALF_TURN]
    rest = theta % HALF_TURN
    before = max(angle for angle in around if angle <= rest)
    after = min(angle for angle in around if angle > rest)
    low, high = sorted(map(d.squared, (before, after)))
    if rest == before:
        assert d.squared(theta) in (low, high)
    else:
        assert low < d.squared(theta) < high


@given(diameters)
def test_minima_lie_at_transitions_and_maxima_inside_pieces(d):
    """Refuted by a minimum with no edge flush, or a maximum whose chord is not upright."""
    transitions = list(d.transitions)
    assert set(d.minima) <= set(transitions)
    assert [transitions[k] for k in d.stable.places] == list(d.minima)
    for angle, place in zip(d.maxima, d.unstable.places, strict=True):
        piece = d.pieces[place]
        assert piece.arc.contains(angle) or piece.arc.contains(angle + HALF_TURN)
        assert angle not in transitions
        assert d.squared(angle) == piece.squared_amplitude


@given(diameters, st.integers(1, 10**6))
def test_extrema_are_strict_on_both_sides(d, closeness):
    """Refuted by an extremum with a neighbour as low, or as high."""
    step = Angle(0, (10**12 + closeness, 1))
    for angle in d.minima:
        assert d.compare(angle, angle + step) == d.compare(angle, angle - step) == -1
    for angle in d.maxima:
        assert d.compare(angle, angle + step) == d.compare(angle, angle - step) == 1


# --- maps ----------------------------------------------------------------------------------------


@given(any_part, directions, shifts, rational_orientations)
def test_turning_a_part_moves_its_diameter_function(part, factor, shift, theta):
    """d'(theta) = |z| d(theta + arg z) for the part times z; refuted by any other value."""
    c, s = factor
    d = DiameterFunction(part)
    other = DiameterFunction(part.translate(*shift).multiply(factor))
    turn = Angle(0, factor)
    assert other.squared(theta) == d.squared(theta + turn) * (c * c + s * s)
    assert list(other.minima) == sorted((angle - turn) % HALF_TURN for angle in d.minima)
    assert list(other.maxima) == sorted((angle - turn) % HALF_TURN for angle in d.maxima)


@given(any_part, rational_orientations)
def test_reflecting_a_part_reflects_its_diameter_function(part, theta):
    """d'(theta) = d(-theta); refuted by any other value."""
    d, other = DiameterFunction(part), DiameterFunction(part.reflect())
    assert other.squared(theta) == d.squared(-theta)
    assert list(other.minima) == sorted(-angle % HALF_TURN for angle in d.minima)
    assert list(other.maxima) == sorted(-angle % HALF_TURN for angle in d.maxima)


@given(diameters, rational_orientations, rational_orientations, ratios.map(abs))
def test_potential_orders_rational_orientations_as_the_diameter_does(d, one, other, stiffness):
    """App. D.1 with the sign of the errata; refuted by a wider orientation of less potential."""
    difference = d.potential(one, stiffness) - d.potential(other, stiffness)
    assert difference == mpq(stiffness) * (d.squared(one) - d.squared(other)) / 2
    if stiffness:
        assert (difference > 0) - (difference < 0) == d.compare(one, other)


# --- floats --------------------------------------------------------------------------------------


@given(
    st.one_of(parts(), rational_parts()), st.lists(rational_orientations, min_size=1, max_size=5)
)
def test_float_values_are_near_the_exact_ones(part, thetas):
    """Refuted by a relative difference above 1e-9."""
    d = DiameterFunction(part)
    values = d.evaluate(np.array([theta.to_float() for theta in thetas]))
    for value, theta in zip(values, thetas, strict=True):
        assert abs(value**2 / float(d.squared(theta)) - 1) < 1e-9
