"""`stochgeom.transfer.squeeze`: the squeeze functions of known parts."""

from __future__ import annotations

import pytest

from stochgeom.exact.angles import EIGHTH_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
OBTUSE = [
    [(0, 0), (5, 0), (-1, 1)],
    [(0, 0), (5, 0), (1, 1)],
    [(0, 0), (1, 9), (0, 7)],
    [(0, 0), (10**40, 0), (-1, 1)],
]
RIGHT = [[(0, 0), (1, 0), (0, 1)], [(0, 0), (4, 3), (-3, 4)]]


def test_rectangle():
    s = squeeze_function(RECTANGLE)
    assert list(s.breaks) == [Angle(0, (2, 3)), Angle(0, (-2, 3))]
    assert list(s.values) == [QUARTER_TURN, HALF_TURN]
    assert (s.period, s.order) == (HALF_TURN, 2)
    assert s(ZERO) == ZERO
    assert s(EIGHTH_TURN) == ZERO
    assert s(Angle(0, (2, 3))) == QUARTER_TURN  # at a maximum the step to the right applies


def test_square_has_the_period_of_its_symmetry():
    s = squeeze_function([(0, 0), (1, 0), (1, 1), (0, 1)])
    assert s == StepFunction([EIGHTH_TURN], [QUARTER_TURN], QUARTER_TURN)
    assert s.order == 4


def test_octagon_with_unequal_angles_has_order_four():
    octagon = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)]
    s = squeeze_function(octagon)
    assert s.order == 4
    assert list(s.values) == [EIGHTH_TURN, QUARTER_TURN]


def test_the_period_may_be_smaller_than_the_symmetry_of_the_part():
    """Errata, T_r: r = 1, yet the period is 90 degrees."""
    assert squeeze_function([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]).order == 4


@pytest.mark.parametrize("vertices", [*OBTUSE, *RIGHT])
def test_obtuse_and_right_triangles_share_one_function(vertices):
    """Fig. 4.4: one step, its value a quarter turn after its break."""
    s = squeeze_function(vertices)
    assert len(s) == 1
    assert s.period == HALF_TURN
    assert s.values[0] - s.breaks[0] == QUARTER_TURN
    assert s.equals_up_to_rotation(squeeze_function(OBTUSE[0]))


def test_an_acute_triangle_has_three_steps():
    s = squeeze_function([(0, 0), (4, 0), (1, 3)])
    assert len(s) == 3
    assert not s.equals_up_to_rotation(squeeze_function(OBTUSE[0]))


@pytest.mark.parametrize(
    ("vertices", "steps"),
    [
        ([(0, 0), (4, 0), (6, 3), (2, 3)], 2),  # parallel edges make one step each pair
        ([(0, 0), (2, 0), (4, 3), (2, 3)], 1),  # they overlap in one point: not stable
        ([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)], 2),  # the roof is not stable
        ([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)], 1),
    ],
)
def test_edges_that_make_no_step_of_their_own(vertices, steps):
    assert len(squeeze_function(vertices)) == steps


def test_parts_diameters_and_vertices_are_taken():
    part = Part(RECTANGLE)
    expected = squeeze_function(RECTANGLE)
    assert squeeze_function(part) == expected
    assert squeeze_function(DiameterFunction(part)) == expected
    assert squeeze_function(iter(RECTANGLE)) == expected


def test_the_center_of_mass_does_not_matter():
    assert squeeze_function(Part(RECTANGLE, center_of_mass=(99, -99))) == squeeze_function(
        RECTANGLE
    )
