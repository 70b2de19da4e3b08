"""`stochgeom.geometry.radius`: pieces, extrema and values of small parts, and corners of input."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
import sympy
from gmpy2 import mpq

from stochgeom.errors import CenterOfMassError, InputError, NotRationalError, NumberLimitError
from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.offset_directions import OffsetDirections
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.geometry.sight import look_around

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
RECTANGLE = RadiusFunction([(0, 0), (3, 0), (3, 2), (0, 2)])
TRIANGLE = RadiusFunction([(0, 0), (4, 0), (0, 3)])
ALL = {"rectangle": RECTANGLE, "triangle": TRIANGLE}


def degrees(angles, digits=2):
    return [angle.degrees(digits) for angle in angles]


# --- pieces and extrema --------------------------------------------------------------------------


def test_pieces_of_a_triangle():
    first, second, third = TRIANGLE.pieces
    assert degrees(TRIANGLE.transitions) == ["0.00", "90.00", "216.87"]
    assert TRIANGLE.flush.tolist() == [0, 2, 1]
    # The edge from (0, 0) to (4, 0) was flush; a turn counter-clockwise is about (0, 0).
    assert (first.arc.start, first.arc.end, first.vertex) == (ZERO, QUARTER_TURN, 0)
    assert (first.chord, first.squared_amplitude) == ((mpq(4, 3), 1), mpq(25, 9))
    assert first.phase == Angle(0, (4, 3))
    assert (second.arc.start, second.vertex, third.vertex) == (QUARTER_TURN, 2, 1)
    assert third.arc.end == FULL_TURN


def test_extrema_of_a_triangle():
    assert degrees(TRIANGLE.minima) == ["0.00", "90.00", "216.87"]
    assert TRIANGLE.stable.places.tolist() == [0, 2, 1]
    assert list(TRIANGLE.maxima) == [Angle(0, d) for d in ((3, 4), (-3, 2), (3, -8))]
    assert TRIANGLE.unstable.places.tolist() == [0, 2, 1]


def test_a_maximum_beyond_a_full_turn_is_taken_back():
    # The last piece holds from 309 to 399 degrees, its maximum is at 365 degrees.
    turned = RadiusFunction(RECTANGLE.part.multiply((4, 5)))
    assert degrees(turned.maxima) == ["4.97", "72.35", "184.97", "252.35"]
    assert turned.unstable.places.tolist() == [0, 3, 2, 1]
    assert turned.pieces[-1].vertex == 0
    assert turned.pieces[-1].arc.contains(turned.maxima[0])


def test_only_the_hull_matters():
    star = [(0, 0), (2, 1), (4, 0), (3, 2), (4, 4), (2, 3), (0, 4), (1, 2)]
    one, other = RadiusFunction(star), RadiusFunction(SQUARE)
    assert list(one.minima) == list(other.minima)
    assert list(one.maxima) == list(other.maxima)
    assert [piece.vertex for piece in one.pieces] == [0, 6, 4, 2]  # numbers of the outline


@pytest.mark.parametrize(
    ("center", "edges"),
    [
        ((2, 2), [0, 3, 2, 1]),
        ((1, 3), [0, 3, 2, 1]),
        (("1e-30", "1e-30"), [0, 3, 2, 1]),  # every foot is strictly inside its edge
    ],
)
def test_every_edge_of_a_square_is_stable_about_any_center(center, edges):
    found = RadiusFunction(Part(SQUARE, center))
    assert found.stable.places.tolist() == found.unstable.places.tolist() == edges


@pytest.mark.parametrize(
    ("center", "edges", "vertices"),
    [
        ((3, 7), [0, 3, 2, 1], [0, 3, 2, 1]),  # the foot on edge 1 is strictly inside it
        ((2, 7), [0, 3, 2], [0, 3, 1]),  # ... at its end: upright over vertex 2 as edge 1 is flush
        ((1, 7), [0, 3, 2], [0, 3, 1]),  # ... beyond its end
        ((1, "6.5"), [0, 3, 2], [0, 3, 1]),
        ((1, "6.4999"), [0, 3, 2, 1], [0, 3, 2, 1]),
    ],
)
def test_a_center_over_the_end_of_an_edge_makes_no_extremum(center, edges, vertices):
    """Edge 1, from (8, 0) to (4, 8), has the end normal through (2, 7) and (1, 6.5)."""
    found = RadiusFunction(Part([(0, 0), (8, 0), (4, 8), (0, 8)], center))
    assert found.flush.tolist() == [0, 3, 2, 1]
    assert found.stable.places.tolist() == edges
    assert found.unstable.places.tolist() == vertices


def test_a_center_straight_above_a_vertex_is_a_maximum():
    """... where that vertex alone touches: the diamond stands on its corner."""
    diamond = RadiusFunction(Part([(0, -3), (3, 0), (0, 3), (-3, 0)], (0, -1)))
    assert ZERO in list(diamond.maxima)
    assert diamond.squared(ZERO) == 4


def test_coordinates_of_many_digits():
    size = 10**400
    huge = RadiusFunction(TRIANGLE.part.scale(size))
    assert list(huge.minima) == list(TRIANGLE.minima)
    assert list(huge.maxima) == list(TRIANGLE.maxima)
    assert huge.squared(EIGHTH_TURN) == TRIANGLE.squared(EIGHTH_TURN) * size**2
    with pytest.raises(NumberLimitError, match=r"Part\.scale"):
        huge.evaluate(0.0)


# --- centres that are no machine integers --------------------------------------------------------

LARGE = [(10**12 * x, 10**12 * y) for x, y in [(0, 0), (4, 0), (6, 4), (0, 3)]]


@pytest.mark.parametrize("near", [0, 1, -1, 10**19, 9 * 10**19, -(10**19)])
def test_long_denominators_are_kept_apart(near):
    """A centre that is, or misses by 1e-20, a point above the end of an edge."""
    shift = Fraction(near, 10**20 + 39)
    part = Part(LARGE, (Fraction(10**12) * 4 + shift, Fraction(10**12) * 2))
    upright = look_around(part).upright
    assert isinstance(upright, OffsetDirections) == (near != 0)
    if near:
        assert 2 * max(map(abs, upright._offset)) <= upright._scale
    found = RadiusFunction(part)
    # The foot on edge 0, from x = 0 to 4e12, is strictly inside only to the left of its end.
    assert (0 in found.stable.places.tolist()) == (near < 0)
    # Exactly, by another road: all in units of the denominator.
    same = RadiusFunction(part.scale(10**20 + 39))
    assert not isinstance(look_around(same.part).upright, OffsetDirections)
    assert list(same.minima) == list(found.minima)
    assert list(same.maxima) == list(found.maxima)
    assert same.stable.places.tolist() == found.stable.places.tolist()
    assert same.unstable.places.tolist() == found.unstable.places.tolist()


def test_a_vertex_near_the_center_takes_the_plain_road():
    part = Part([(-1, -1), (10**15, -1), (-1, 10**15)], ("1/1000003", "1/1000033"))
    assert not isinstance(look_around(part).upright, OffsetDirections)
    assert len(RadiusFunction(part).minima) == 3


# --- bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("center", "side"),
    [
        ((5, 2), "outside"),
        ((-1, -1), "outside"),
        ((10**20, 0), "outside"),
        (("4.0000001", 2), "outside"),
        ((4, 2), "on the boundary of"),
        ((0, 0), "on the boundary of"),
        (("1/3", 4), "on the boundary of"),
    ],
)
@pytest.mark.parametrize("scale", [1, 10**14])
def test_centers_that_are_not_strictly_inside(center, side, scale):
    part = Part(SQUARE, center).scale(scale)
    with pytest.raises(CenterOfMassError) as caught:
        RadiusFunction(part)
    assert isinstance(caught.value, InputError)
    x, y = part.center_of_mass
    assert str(caught.value) == (
        f"center of mass: ({x}, {y}) lies {side} the convex hull; "
        "accepted: a point strictly inside the convex hull"
    )
    assert part.center_of_mass_side == (0 if side.startswith("on") else -1)


def test_a_center_in_a_notch_is_inside_the_hull():
    notched = Part([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], (2, 3))
    assert list(RadiusFunction(notched).minima) == list(RadiusFunction(SQUARE).minima)


@pytest.mark.parametrize("theta", [Angle.from_degrees(71), Angle("1/3", (3, 4))])
def test_squares_are_given_at_rational_directions_only(theta):
    for ask in (RECTANGLE.squared, lambda t: RECTANGLE.compare(t, ZERO)):
        with pytest.raises(NotRationalError, match="accepted: directions over it"):
            ask(theta)


# --- values --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("theta", "squared"),
    [
        (ZERO, 1),
        (QUARTER_TURN, mpq(16, 9)),
        (HALF_TURN, 4),
        (Angle(0, (4, 3)).reduced(), mpq(24**2, 15**2)),
        (Angle(0, (-4, -3)), mpq(144, 225)),
        (Angle(0, (3, 4)), mpq(25, 9)),
        (Angle(7, (3, 4)), mpq(25, 9)),
        (Angle(-7, (3, 4)), mpq(25, 9)),
    ],
)
def test_squared_radii_of_a_triangle(theta, squared):
    """The centre of mass is (4/3, 1)."""
    assert TRIANGLE.squared(theta) == squared


def test_values_before_the_first_transition():
    turned = RadiusFunction(TRIANGLE.part.multiply((1, 3)))
    assert turned.transitions[0] > ZERO
    cy = turned.part.center_of_mass[1]
    assert turned.squared(ZERO) == (cy - min(y for _, y in turned.part.vertices)) ** 2


def test_comparison():
    assert TRIANGLE.compare(ZERO, QUARTER_TURN) == -1
    assert TRIANGLE.compare(QUARTER_TURN, ZERO) == 1
    assert RECTANGLE.compare(ZERO, HALF_TURN) == 0


@pytest.mark.parametrize("name", ALL)
def test_floats_follow_the_exact_values(name):
    r = ALL[name]
    angles = [Angle(0, (x, y)) for x in range(-5, 6) for y in range(-5, 6) if x or y]
    angles += [angle + FULL_TURN * 3 for angle in angles]
    values = r.evaluate(np.array([angle.to_float() for angle in angles]))
    exact = np.array([math.sqrt(Fraction(str(r.squared(angle)))) for angle in angles])
    assert np.abs(values / exact - 1).max() < 1e-14


def test_floats_keep_their_shape():
    assert RECTANGLE.evaluate(0.0) == 1.0
    grid = np.linspace(-10, 10, 12).reshape(3, 4)
    assert RECTANGLE.evaluate(grid).shape == (3, 4)


@pytest.mark.parametrize("turn", [(1, 0), (4, 5), (-1, 7)])
def test_sympy_follows_the_exact_values(turn):
    r = RadiusFunction(TRIANGLE.part.multiply(turn))
    expression, theta = r.to_sympy(), sympy.Symbol("theta")
    assert expression.free_symbols == {theta}
    for direction in ((1, 0), (1, 1), (0, 1), (-3, 4), (-5, -1), (4, -3)):
        angle = Angle(0, direction)
        value = expression.subs(theta, angle.to_sympy())
        assert sympy.simplify(value**2 - sympy.Rational(str(r.squared(angle)))) == 0
        assert value > 0
    phi = sympy.Symbol("phi", real=True)
    assert r.to_sympy(phi).free_symbols == {phi}


def test_repr():
    assert repr(TRIANGLE) == "RadiusFunction(Part([(0, 0), (4, 0), (0, 3)]))"
