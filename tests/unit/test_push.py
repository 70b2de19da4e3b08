"""`stochgeom.transfer.push` and `push_grasp`: the functions of known parts."""

from __future__ import annotations

import pytest

from stochgeom.errors import CenterOfMassError
from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push import push_function
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

TRIANGLE = [(0, 0), (4, 0), (0, 3)]
SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
HOUSE = Part([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)], (0, "2/5"))
FOUR_SIDES = Part([(52, 58), (0, 55), (8, 17), (51, 0)], (28, 32))
SLANTED = [(0, 0), (8, 0), (4, 8), (0, 8)]


def degrees(angles, digits=1):
    return [angle.degrees(digits) for angle in angles]


# --- pushes --------------------------------------------------------------------------------------


def test_a_triangle_goes_to_its_nearest_edges():
    s = push_function(TRIANGLE)
    assert list(s.breaks) == [Angle(0, d) for d in ((3, 4), (-3, 2), (3, -8))]
    assert list(s.values) == [QUARTER_TURN, Angle(0, (-4, -3)), FULL_TURN]
    assert s.order == 1
    assert s(ZERO) == ZERO
    assert s(Angle(0, (3, 4))) == QUARTER_TURN  # at a maximum the step to the right applies


def test_a_square_has_the_period_of_its_symmetry():
    expected = StepFunction([EIGHTH_TURN], [QUARTER_TURN], QUARTER_TURN)
    assert push_function(SQUARE) == push_grasp_function(SQUARE) == expected


def test_a_square_about_another_center_has_none():
    s = push_function(Part(SQUARE, ("1/2", 0)))
    assert (s.order, len(s)) == (1, 4)
    assert list(s.values) == [QUARTER_TURN, HALF_TURN, Angle.from_degrees(270), FULL_TURN]


@pytest.mark.parametrize(
    ("center", "steps"),
    [
        ((3, 7), 4),
        ((2, 7), 3),  # over the end of the slanted edge: no step of width zero
        ((1, 7), 3),
    ],
)
def test_edges_that_make_no_step(center, steps):
    part = Part(SLANTED, center)
    assert len(push_function(part)) == steps
    # ... though the jaws hold the slanted edge, or do not, whatever the centre of mass.
    assert squeeze_function(part) == squeeze_function(SLANTED)


def test_an_edge_stable_for_the_jaws_and_not_for_the_push():
    """The slanted top of this part is held by jaws; a push tips it over its end."""
    part, level = Part([(0, 0), (6, 0), (6, 3), (0, 6)], ("5.5", 1)), Angle(0, (2, 1))
    assert level in [value % HALF_TURN for value in squeeze_function(part).values]
    assert level + HALF_TURN in list(RadiusFunction(part).transitions)
    pushed = push_function(part)
    assert level + HALF_TURN not in [value.reduced() for value in pushed.values]
    assert pushed(level + HALF_TURN) == HALF_TURN + QUARTER_TURN


def test_parallel_edges_are_told_apart():
    """Jaws hold both of two parallel edges or none, a push each by itself."""
    lozenge = [(0, 0), (8, 0), (10, 2), (2, 2)]
    assert set(RadiusFunction(Part(lozenge, (5, 1))).minima) >= {ZERO, HALF_TURN}
    minima = set(RadiusFunction(Part(lozenge, (9, "1.5"))).minima)
    assert HALF_TURN in minima
    assert ZERO not in minima


def test_collinear_vertices_and_notches_do_not_matter():
    many = [(-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, "1/2"), (-1, 1), (-1, 0)]
    center = ("1/3", "1/7")
    assert push_function(Part(many, center)) == push_function(Part(SQUARE, center))
    assert push_grasp_function(Part(many, center)) == push_grasp_function(Part(SQUARE, center))


def test_coordinates_of_many_digits():
    part = Part(SLANTED, ("1/3", "7/11"))
    assert push_grasp_function(part.scale(10**400)) == push_grasp_function(part)
    nearly = Part([(10**400 * x, 10**400 * y) for x, y in SQUARE], (1, 0))
    assert push_function(nearly).order == 1
    assert push_function(Part(nearly.vertices)).order == 4


def test_what_is_taken():
    part = Part(TRIANGLE)
    expected = push_function(part)
    assert push_function(TRIANGLE) == push_function(iter(TRIANGLE)) == expected
    assert push_function(RadiusFunction(part)) == expected
    assert push_grasp_function(iter(TRIANGLE)) == push_grasp_function(part)


@pytest.mark.parametrize("function", [push_function, push_grasp_function])
@pytest.mark.parametrize("center", [(1, 0), (2, 2), (0, -1)])
def test_a_center_that_is_not_strictly_inside(function, center):
    with pytest.raises(CenterOfMassError, match="accepted: a point strictly inside"):
        function(Part(SQUARE, center))


# --- push-grasps (thesis App. E) -----------------------------------------------------------------


def test_the_squeeze_turns_what_the_push_has_aligned():
    s = push_grasp_function(TRIANGLE)
    assert list(s.breaks) == [Angle(0, (-3, 2)), Angle(0, (3, -8))]
    # The short sides are stable under the push; the squeeze goes on to the long one.
    assert list(s.values) == [Angle(0, (-4, -3)), Angle(1, (4, 3))]


def test_a_value_may_lie_outside_its_own_step():
    """The push goes to 45 degrees or more, the squeeze from there back across the break."""
    part = Part([(0, 0), (8, 0), (1, 4), (-2, 3)], ("1.5", "1.5"))
    s = push_grasp_function(part)
    assert degrees(s.breaks) == ["45.0", "113.2", "168.7", "283.0"]
    assert degrees(s.values) == ["29.7", "180.0", "209.7", "360.0"]
    assert s(EIGHTH_TURN) < s.breaks[0]
    assert s.power(2)(EIGHTH_TURN) == ZERO


def test_a_random_push_grasp_of_the_four_sided_part():
    """Fig. E.5, first row: .26 .21 .25 .28 by increasing jaw angle, the decreasing theta."""
    s = push_grasp_function(FOUR_SIDES)
    assert s.order == 1
    assert [w.turns(2) for w in s.widths[::-1]] == ["0.25", "0.28", "0.26", "0.21"]


def test_a_random_push_grasp_of_the_house():
    """Fig. E.8, first row: .20 .40 .40."""
    s = push_grasp_function(HOUSE)
    assert s.order == 1
    assert [w.turns(2) for w in s.widths] == ["0.40", "0.40", "0.20"]
    assert list(s.values) == [QUARTER_TURN, Angle.from_degrees(270), FULL_TURN]


def test_the_other_jaw():
    s = push_grasp_function(HOUSE, upper_jaw=True)
    assert [w.turns(2) for w in s.widths] == ["0.40", "0.20", "0.40"]
    assert list(s.values) == [QUARTER_TURN, HALF_TURN, Angle.from_degrees(270)]
    assert push_function(HOUSE, upper_jaw=True) == push_function(HOUSE).rotate(HALF_TURN)
