"""Transfer functions of parts over fields, by mpmath, and by rational parts moved into a field."""

from __future__ import annotations

import mpmath
import pytest
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.feeding.planner import plan_feeding
from stochgeom.geometry.part import Part
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import pushing_bound
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import field_parts, hulls

FEW = settings().max_examples // 10


def extrema_by_mpmath(part):
    """Return minima and maxima of the diameter in radians in [0, pi), from heights alone.

    A minimum is where some chord is level, a maximum where one is upright: all chords are tried.
    """
    points = [(_value(x), _value(y)) for x, y in part.vertices]
    step = mpmath.mpf(10) ** -10  # the parts drawn have no two extrema as close as that

    def diameter(theta):
        heights = [x * mpmath.sin(theta) + y * mpmath.cos(theta) for x, y in points]
        return max(heights) - min(heights)

    def kept(angles, sense):
        found = set()
        for theta in angles:
            before, here, after = (sense * diameter(theta + k * step) for k in (-1, 0, 1))
            if before < here > after:
                found.add(_rounded(theta / (2 * mpmath.pi)))
        return found

    chords = [(b[0] - a[0], b[1] - a[1]) for a in points for b in points if a != b]
    return (
        kept([-mpmath.atan2(y, x) for x, y in chords], -1),
        kept([mpmath.atan2(x, y) for x, y in chords], 1),
    )


def _rounded(turns):
    """Return a number of turns modulo half a turn in 20 decimals."""
    return int(mpmath.nint(turns * 10**20)) % (10**20 // 2)


def _value(number):
    return (
        mpmath.mpf(str(number.to_sympy().evalf(45)))
        if hasattr(number, "to_sympy")
        else (mpmath.mpf(int(number.numerator)) / int(number.denominator))
    )


@settings(max_examples=max(5, FEW // 4))
@given(field_parts())
def test_squeeze_functions_by_mpmath(part):
    with mpmath.workdps(45):
        minima, maxima = extrema_by_mpmath(part)
        squeeze = squeeze_function(part)
        for sequence, expected in (
            (squeeze.lifted_breaks, maxima),
            (squeeze.lifted_values, minima),
        ):
            every = [sequence[k] for k in range(len(squeeze) * squeeze.order)]
            assert {_rounded(mpmath.mpf(angle.turns(35))) for angle in every} == expected


@settings(max_examples=max(10, FEW))
@given(hulls(), st.sampled_from(["sqrt(2)", "1 + sqrt(3)", "sqrt(7)/5", "3 - sqrt(5)"]))
def test_scaling_into_a_field_changes_nothing(part, factor):
    scaled = part.scale(factor)
    assert scaled.field is not None
    assert squeeze_function(scaled) == squeeze_function(part)
    assert hash(squeeze_function(scaled)) == hash(squeeze_function(part))
    if part.center_of_mass_side == 1:
        assert push_grasp_function(scaled) == push_grasp_function(part)


TURNS = [
    (("sqrt(2)", "sqrt(2)"), Angle.from_degrees(45)),
    (("sqrt(3)", "1"), Angle.from_degrees(30)),
    (("1 + sqrt(2)", "1"), Angle.from_degrees("22.5")),
    (("sqrt(5)", "2"), Angle(0, ("sqrt(5)", "2"))),
]


@settings(max_examples=max(10, FEW))
@given(hulls(), st.sampled_from(TURNS))
def test_turning_into_a_field_turns_the_function(part, turn):
    direction, angle = turn
    turned = part.multiply(direction)
    # A part turned by an angle needs that much less of it.
    assert squeeze_function(turned) == squeeze_function(part).rotate(-angle)
    plan, other = plan_feeding(part), plan_feeding(turned)
    assert (plan.steps, plan.probability) == (other.steps, other.probability)
    assert other.verify()


@settings(max_examples=max(10, FEW // 2))
@given(hulls(most=6), st.sampled_from(["0", "1/20", "1/4", "1", "2"]), st.sampled_from(TURNS))
def test_friction_sees_no_difference_either(part, mu, turn):
    assume(part.center_of_mass_side == 1)
    plain = GraspDiagram(part, mu)
    for moved in (part.scale("1 + sqrt(2)"), part.multiply(turn[0])):
        diagram = GraspDiagram(moved, mu)
        assert diagram.bound == plain.bound
        assert diagram.strict_bound == plain.strict_bound
        assert pushing_bound(diagram).decimal(12) == pushing_bound(plain).decimal(12)


@settings(max_examples=max(10, FEW // 2))
@given(field_parts(), st.sampled_from(["squeeze", "push-grasp"]))
def test_plans_of_cut_regular_polygons_do_what_they_claim(part, action):
    plan = plan_feeding(part, action=action)
    assert plan.verify()


def test_the_97_gon():
    part = Part.regular(97)
    assert squeeze_function(part).period == Angle.from_turns("1/194")
    assert plan_feeding(part).verify()


@pytest.mark.parametrize("n", [5, 8, 9])
def test_a_tie_that_is_one_and_one_that_nearly_is(n):
    vertices = list(Part.regular(n).vertices)
    assert squeeze_function(Part(vertices)).order == (n if n % 2 == 0 else 2 * n)
    x, y = vertices[0]
    vertices[0] = x + mpq(1, 10**60), y
    assert squeeze_function(Part(vertices)).order == 2
