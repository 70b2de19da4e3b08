"""Regular polygons and other parts over fields: everything that works on rational parts."""

from __future__ import annotations

import mpmath
import pytest
from gmpy2 import mpq

from stochgeom.errors import (
    InputError,
    MixedFieldsError,
    NotRationalError,
    NumberError,
    NumberLimitError,
    SelfIntersectionError,
    TooFewVerticesError,
)
from stochgeom.exact.angles import Angle
from stochgeom.feeding.part_errors import tolerance_of
from stochgeom.feeding.planner import plan_feeding
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function

TRIANGLE = Part([(0, 0), (1, 0), ("1/2", "sqrt(3)/2")])


@pytest.mark.parametrize("n", range(3, 31))
def test_the_period_is_that_of_the_symmetry(n):
    part = Part.regular(n)
    squeeze = squeeze_function(part)
    # T_r of thesis 4.4.5: 2 pi / r for an even r, pi / r for an odd one.
    assert squeeze.period == Angle.from_turns(mpq(1, n if n % 2 == 0 else 2 * n))
    assert len(squeeze) == 1
    assert push_grasp_function(part).period == Angle.from_turns(mpq(1, n))
    plan = plan_feeding(part)
    assert (plan.steps, plan.verify()) == (1, True)
    assert plan.probability.rational == mpq(1, squeeze.order)


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 20, 97, 100])
def test_vertices_by_mpmath(n):
    part = Part.regular(n)
    assert len(part.hull) == len(part) == n
    assert part.centroid == (0, 0)
    with mpmath.workdps(30):
        for k, (x, y) in enumerate(part.vertices):
            assert abs(float(x) - mpmath.cos(2 * mpmath.pi * k / n)) < 1e-15
            assert abs(float(y) - mpmath.sin(2 * mpmath.pi * k / n)) < 1e-15
            assert x * x + y * y == 1
        area = n * mpmath.sin(2 * mpmath.pi / n) / 2
        assert abs(float(part.area) - area) < 1e-14


def test_exact_diameters_and_radii_of_the_pentagon():
    diameter = DiameterFunction(Part.regular(5))
    least, most = diameter.squared(diameter.minima[0]), diameter.squared(diameter.maxima[0])
    assert str(most) == "3 + g"  # the diagonal: twice the sine of 72 degrees, squared
    assert abs(float(least) - (1 + mpmath.cos(mpmath.pi / 5)) ** 2) < 1e-14
    assert diameter.compare(diameter.minima[0], diameter.minima[1]) == 0
    radius = RadiusFunction(Part.regular(5))
    assert radius.squared(radius.maxima[0]) == 1
    with pytest.raises(NotRationalError, match=r"71\.0000° is no number of the part's field"):
        diameter.squared(Angle.from_degrees(71))


@pytest.mark.parametrize("n", range(3, 13))
def test_the_diameter_is_known_wherever_an_edge_is_flush(n):
    # Chords may be rational where the orientation is not: the hexagon's upright diagonal.
    diameter = DiameterFunction(Part.regular(n))
    for theta in (*diameter.transitions, *diameter.maxima):
        value = mpmath.mpf(float(diameter.squared(theta)))
        assert abs(value - diameter.evaluate(theta.to_float()) ** 2) < 1e-12


def test_text_makes_the_same_triangle():
    squeeze = squeeze_function(TRIANGLE)
    assert squeeze.period == Angle.from_degrees(60)
    assert squeeze.values[0] == Angle.from_degrees(60)
    assert str(TRIANGLE.area) == "1/4*sqrt(3)"
    assert eval(repr(TRIANGLE), {"Part": Part}) == TRIANGLE
    assert str(TRIANGLE.center_of_mass[1]) == "1/6*sqrt(3)"


def test_maps_of_the_plane():
    turned = TRIANGLE.rotate(("sqrt(3)/2", "1/2"))
    assert turned.vertices[1] == Part([(0, 0), ("sqrt(3)/2", "1/2"), (0, 1)]).vertices[1]
    assert squeeze_function(turned).values[0] == Angle.from_degrees(30)
    back = (
        TRIANGLE.scale("sqrt(3)")
        .scale("sqrt(3)/3")
        .translate("sqrt(3)", 0)
        .translate("-sqrt(3)", 0)
    )
    assert back == TRIANGLE
    with pytest.raises(NotRationalError, match="accepted: directions of rational length"):
        TRIANGLE.rotate(("sqrt(3)", "sqrt(3)"))


def test_a_cut_pentagon_has_a_long_plan():
    vertices = list(Part.regular(5).vertices)
    vertices[1] = tuple(x * mpq(9, 10) for x in vertices[1])
    part = Part(vertices)
    plan = plan_feeding(part)
    assert (plan.steps, plan.probability.rational, plan.verify()) == (5, mpq(1, 2), True)
    pushed = plan_feeding(part, action="push-grasp")
    assert (pushed.probability.rational, pushed.verify()) == (1, True)


@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
def test_tolerances_scale_with_the_part(action):
    # A rational part, and the same turned by 30 degrees and doubled.
    plain = Part([(0, 0), (10, 0), (12, 5), (5, 11)])
    turned = plain.multiply(("sqrt(3)", "1"))
    small, large = (tolerance_of(plan_feeding(part, action=action)) for part in (plain, turned))
    assert small > 0
    assert abs(large / small - 2) < mpq(1, 100)


def test_holes_and_centres_over_a_field():
    part = Part([(0, 0), (4, 0), (4, 4), (0, 4)], holes=[[(1, 1), ("sqrt(2)", 1), (1, 2)]])
    assert str(part.area) == "33/2 - 1/2*sqrt(2)"
    assert part.center_of_mass_side == 1
    given = Part([(0, 0), (4, 0), (0, 4)], center_of_mass=("sqrt(2)", 1))
    assert push_grasp_function(given).order == 1


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: Part.regular(2), TooFewVerticesError, "regular polygon of 2 vertices"),
        (lambda: Part.regular(-5), TooFewVerticesError, "accepted: 3 or more"),
        (lambda: Part.regular(2.5), InputError, "2.5 vertices; accepted: whole numbers"),
        (lambda: Part.regular(10**6), NumberLimitError, "3 to 1000 vertices"),
        (
            lambda: Part([(0, 0), ("sqrt(2)", 0), (0, "sqrt(3)")]),
            MixedFieldsError,
            r"vertex 2, y: sqrt\(3\) is in Q\(sqrt\(3\)\), vertex 1, x in Q\(sqrt\(2\)\)",
        ),
        (
            lambda: Part([(0, 0), ("sqrt(2)", 0), (0, 1)], center_of_mass=("sqrt(3)/9", "1/9")),
            MixedFieldsError,
            "center of mass: .* vertices in",
        ),
        (
            lambda: Part(
                [(0, 0), (9, 0), (0, 9)], holes=[[(1, 1), (1, "sqrt(2)"), ("sqrt(3)", 1)]]
            ),
            MixedFieldsError,
            "hole 0, vertex 2, x",
        ),
        (lambda: Part([(0, 0), (1, 0), (0, "sqrt(-3)")]), NumberError, "vertex 2, y: .*root of -3"),
        (
            lambda: Part([(0, 0), ("sqrt(2)", "sqrt(2)"), ("sqrt(2)", 0), (0, "sqrt(2)")]),
            SelfIntersectionError,
            "cross",
        ),
    ],
)
def test_bad_input(make, error, words):
    with pytest.raises(error, match=words):
        make()
