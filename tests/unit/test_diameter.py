"""`stochgeom.geometry.diameter`: pieces, extrema and values of small parts."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
import sympy
from gmpy2 import mpq

from stochgeom.errors import FloatRefusedError, NotRationalError
from stochgeom.exact.angles import EIGHTH_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part

RECTANGLE = DiameterFunction(Part([(0, 0), (3, 0), (3, 2), (0, 2)]))
TRIANGLE = DiameterFunction(Part([(0, 0), (4, 0), (1, 2)]))
ALL = {"rectangle": RECTANGLE, "triangle": TRIANGLE}


def degrees(angles, digits=2):
    return [angle.degrees(digits) for angle in angles]


# --- pieces and extrema --------------------------------------------------------------------------


def test_pieces_of_a_rectangle():
    first, second = RECTANGLE.pieces
    assert (first.arc.start, first.arc.width) == (ZERO, QUARTER_TURN)
    assert (first.chord, first.squared_amplitude, first.vertices) == ((3, 2), 13, (0, 2))
    assert first.phase == Angle(0, (3, 2))
    assert (second.arc.start, second.arc.end) == (QUARTER_TURN, HALF_TURN)
    # now vertex 3 is low and vertex 1 is high
    assert (second.chord, second.squared_amplitude, second.vertices) == ((3, -2), 13, (3, 1))
    assert second.phase == Angle(0, (3, -2))


def test_extrema_of_a_rectangle():
    assert list(RECTANGLE.transitions) == [ZERO, QUARTER_TURN]
    assert list(RECTANGLE.minima) == [ZERO, QUARTER_TURN]
    assert list(RECTANGLE.maxima) == [Angle(0, (2, 3)), Angle(0, (-2, 3))]
    assert RECTANGLE.stable.places.tolist() == [0, 1]
    assert RECTANGLE.unstable.places.tolist() == [0, 1]


def test_an_edge_may_be_unstable():
    """The long side of an obtuse triangle is its only stable edge."""
    obtuse = DiameterFunction(Part([(0, 0), (5, 0), (-1, 1)]))
    assert len(obtuse.transitions) == 3
    assert len(obtuse.minima) == len(obtuse.maxima) == 1
    # the long side runs from (5, 0) to (-1, 1)
    assert obtuse.minima[0] == Angle(0, (6, 1))


@pytest.mark.parametrize(
    ("vertices", "minima"),
    [
        # a corner exactly over the end of an edge: a slope of zero on one side, no minimum
        ([(0, 0), (4, 0), (0, 3)], 1),
        ([(0, 0), (4, 0), (4, 3), (1, 1)], 1),
        # ... and strictly inside it
        ([(0, 0), (4, 0), (1, 3)], 3),
        # parallel sides that overlap in a point only, or not at all: no minimum there
        ([(0, 0), (2, 0), (4, 3), (2, 3)], 1),
        ([(0, 0), (2, 0), (5, 3), (3, 3)], 1),
        ([(0, 0), (3, 0), (4, 3), (1, 3)], 2),
        ([(0, 0), (1, 0), (1, 1), (0, 1)], 2),
    ],
)
def test_only_slopes_of_both_signs_make_a_minimum(vertices, minima):
    found = DiameterFunction(Part(vertices))
    assert len(found.minima) == len(found.maxima) == minima


def test_a_maximum_beyond_half_a_turn_is_taken_back():
    # The last piece holds from 128.66 to 218.66 degrees, its maximum is at 184.97 degrees.
    turned = DiameterFunction(Part([(0, 0), (3, 0), (3, 2), (0, 2)]).multiply((4, 5)))
    assert all(ZERO <= angle < HALF_TURN for angle in turned.maxima)
    assert degrees(turned.maxima) == ["4.97", "72.35"]
    assert turned.unstable.places.tolist() == [1, 0]
    assert turned.pieces[1].arc.contains(turned.maxima[0] + HALF_TURN)


def test_only_the_hull_matters():
    star = [(0, 0), (2, 1), (4, 0), (3, 2), (4, 4), (2, 3), (0, 4), (1, 2)]
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    one, other = DiameterFunction(Part(star)), DiameterFunction(Part(square))
    assert list(one.minima) == list(other.minima)
    assert list(one.maxima) == list(other.maxima)
    # contacts keep the numbers of the outline
    assert [piece.vertices for piece in one.pieces] == [(0, 4), (6, 2)]
    assert [piece.vertices for piece in other.pieces] == [(0, 2), (3, 1)]


# --- values --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("theta", "squared"),
    [
        (ZERO, 4),
        (QUARTER_TURN, 9),
        (HALF_TURN, 4),
        (EIGHTH_TURN, mpq(25, 2)),
        (Angle(0, (2, 3)), 13),
        (Angle(5, (2, 3)), 13),
        (Angle(-7, (-2, -3)), 13),
        (Angle(0, (3, 4)), mpq(324, 25)),
        (Angle(0, (-4, 3)), mpq(17 * 17, 25)),
    ],
)
def test_squared_diameters_of_a_rectangle(theta, squared):
    assert RECTANGLE.squared(theta) == squared
    assert RECTANGLE.squared(theta + HALF_TURN) == squared


def test_values_before_the_first_transition():
    first = TRIANGLE.transitions[0]
    assert first == ZERO
    turned = DiameterFunction(TRIANGLE.part.multiply((0, 1)).multiply((1, -3)))
    assert turned.transitions[0] > ZERO
    assert turned.squared(ZERO) == turned.squared(HALF_TURN)
    xs = [y for _, y in turned.part.vertices]
    assert turned.squared(ZERO) == (max(xs) - min(xs)) ** 2


def test_comparison():
    assert RECTANGLE.compare(ZERO, QUARTER_TURN) == -1
    assert RECTANGLE.compare(QUARTER_TURN, ZERO) == 1
    assert RECTANGLE.compare(Angle(0, (2, 3)), Angle(0, (-2, 3))) == 0


@pytest.mark.parametrize("theta", [Angle.from_degrees(71), Angle("1/3", (3, 4))])
def test_squares_are_given_at_rational_directions_only(theta):
    for ask in (RECTANGLE.squared, RECTANGLE.potential, lambda t: RECTANGLE.compare(t, ZERO)):
        with pytest.raises(NotRationalError, match="accepted: directions over it"):
            ask(theta)


def test_potential_is_least_where_the_part_is_stable():
    """App. D.1 with the sign that makes it a potential."""
    assert RECTANGLE.potential(ZERO) == 2
    assert RECTANGLE.potential(ZERO, stiffness="1/3") == mpq(2, 3)
    assert RECTANGLE.potential(Angle(0, (2, 3)), 2) == 13
    with pytest.raises(FloatRefusedError, match="stiffness"):
        RECTANGLE.potential(ZERO, 0.5)


# --- floats and sympy ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ALL)
def test_floats_follow_the_exact_values(name):
    d = ALL[name]
    angles = [Angle(0, (x, y)) for x in range(-5, 6) for y in range(-5, 6) if x or y]
    angles += [angle + HALF_TURN * 3 for angle in angles]
    values = d.evaluate(np.array([angle.to_float() for angle in angles]))
    exact = np.array(
        [math.sqrt(Fraction(int(s.numerator), int(s.denominator))) for s in map(d.squared, angles)]
    )
    assert np.abs(values / exact - 1).max() < 1e-14


def test_floats_keep_their_shape():
    assert RECTANGLE.evaluate(0.0) == 2.0
    grid = np.linspace(-10, 10, 12).reshape(3, 4)
    assert RECTANGLE.evaluate(grid).shape == (3, 4)
    assert (RECTANGLE.evaluate(grid) > 0).all()


@pytest.mark.parametrize("turn", [(1, 0), (4, 5), (-1, 7)])
def test_sympy_follows_the_exact_values(turn):
    d = DiameterFunction(TRIANGLE.part.multiply(turn))
    expression = d.to_sympy()
    theta = sympy.Symbol("theta")
    assert expression.free_symbols == {theta}
    for direction in ((1, 0), (1, 1), (0, 1), (-3, 4), (-5, 1), (4, 3)):
        angle = Angle(0, direction)
        value = expression.subs(theta, angle.to_sympy())
        squared = d.squared(angle)
        assert sympy.simplify(value**2 - sympy.Rational(str(squared))) == 0
        assert value > 0


def test_sympy_takes_the_symbol_it_is_given():
    phi = sympy.Symbol("phi", real=True)
    assert RECTANGLE.to_sympy(phi).free_symbols == {phi}
