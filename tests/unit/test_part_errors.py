"""Inexact parts: worked cases, perturbed parts beyond the bound, bad input."""

from __future__ import annotations

import math
import random
from decimal import Decimal
from fractions import Fraction

import pytest
from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.errors import FloatRefusedError, InputError, NumberError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, Angle
from stochgeom.exact.outer_arcs import TURN
from stochgeom.feeding.execution import composite
from stochgeom.feeding.nearby_courses import NearbyCourses
from stochgeom.feeding.part_errors import tolerance_of
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry, plan_feeding
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.verification import verify_plan
from stochgeom.geometry.center_error import CenterError
from stochgeom.geometry.contact_zones import squeeze_zones
from stochgeom.geometry.near_contacts import NearbyParts
from stochgeom.geometry.part import Part
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
QUADRANGLE = [(0, 0), (9, 0), (10, 4), (2, 5)]
ACTIONS = {"squeeze": squeeze_function, "push-grasp": push_grasp_function}
CIRCLE = [(Fraction(x, 5), Fraction(y, 5)) for x, y in [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4)]]
CIRCLE += [(Fraction(x, 5), Fraction(y, 5)) for x, y in [(-4, 3), (-5, 0), (-4, -3), (-3, -4)]]
CIRCLE += [(Fraction(x, 5), Fraction(y, 5)) for x, y in [(0, -5), (3, -4), (4, -3)]]


def degrees(arcs):
    return [(round(360 * a / TURN, 3), round(360 * b / TURN, 3)) for a, b in arcs]


class TestZones:
    """With c = 2 epsilon: an arc sine of c / L about the edge, of c / |v| about the maximum."""

    def test_of_the_rectangle(self):
        zones = squeeze_zones(NearbyParts(Part(RECTANGLE)), mpq(1, 100))
        assert zones.period == TURN // 2
        assert degrees(zones.rest_arcs) == [(89.427, 90.573), (179.618, 180.382)]
        assert degrees(zones.uncertain) == [
            (55.992, 56.628),
            (89.427, 90.573),
            (123.372, 124.008),
            (179.618, 180.382),
        ]

    def test_of_a_vertex_inside_an_edge(self):
        corners = [(0, 0), (1, 0), (3, 0), (3, 2), (0, 2)]
        zones = squeeze_zones(NearbyParts(Part(corners)), mpq(1, 100))
        pairs = {tuple(sorted(rest.points)) for rest in zones.rests}
        assert pairs == {(0, 1), (1, 2), (0, 2), (2, 3), (3, 4), (0, 4)}

    def test_are_none_if_everything_may_touch(self):
        assert squeeze_zones(NearbyParts(Part(RECTANGLE)), mpq(3, 2)) is None

    def test_do_not_depend_on_repeated_vertices(self):
        twice = NearbyParts(Part([p for p in RECTANGLE for _ in range(2)]))
        once = NearbyParts(Part(RECTANGLE))
        for epsilon in (mpq(1, 100), mpq(1, 3)):
            assert squeeze_zones(twice, epsilon).rests == squeeze_zones(once, epsilon).rests


class TestCenterError:
    def test_a_given_centre_stays(self):
        assert CenterError(Part(RECTANGLE, (1, 1))).bound(mpq(1)) == 0

    def test_that_of_a_triangle_is_the_mean_of_its_vertices(self):
        assert CenterError(Part([(0, 0), (5, 0), (1, 4)])).bound(mpq(1, 7)) == mpq(1, 7)

    def test_there_is_none_if_the_area_may_vanish(self):
        assert CenterError(Part(RECTANGLE)).bound(mpq(1)) is None
        hole = [(1, 1), ("1.1", 1), (1, "1.1")]
        assert CenterError(Part(RECTANGLE, holes=[hole])).bound(mpq(1, 10)) is None
        assert CenterError(Part(RECTANGLE, holes=[hole])).bound(mpq(1, 100)) is not None

    def test_holes_count(self):
        hole = [(1, 1), (2, 1), (1, "1.5")]
        plain = CenterError(Part(RECTANGLE)).bound(mpq(1, 100))
        assert CenterError(Part(RECTANGLE, holes=[hole])).bound(mpq(1, 100)) > plain


class TestTolerance:
    @pytest.mark.parametrize(
        ("name", "expected"),
        [("triangle", "0.788"), ("rectangle", "0.127"), ("4gon", "1.026"), ("5gon", "0.704")],
    )
    def test_of_the_catalogue(self, name, expected):
        plan = orient_up_to_symmetry(catalogue_part(name))
        assert f"{float(tolerance_of(plan)):.3f}" == expected

    def test_of_the_rectangle_is_where_its_margin_is_spent(self):
        # After the first action a state is off by asin(c / 3) or asin(c / 2); the second action
        # sends it into a break that is off by asin(c / sqrt 13). The least margin is 11.31 degrees.
        plan = plan_feeding(RECTANGLE)
        c = 2 * tolerance_of(plan)
        slack = plan.angles[1] - plan.actions[1].low
        assert slack.degrees(2) == "11.31"
        spent = math.asin(c / 2) + math.asin(c / math.sqrt(13))
        assert abs(spent - math.radians(11.31)) < math.radians(0.05)

    def test_a_plan_that_is_spoiled_by_any_error(self):
        # The roof of the house is stable as soon as one corner stands a little lower.
        house = catalogue_part("house")
        plan = plan_feeding(house)
        assert tolerance_of(plan) == 0
        found = []
        for k, (x, y) in enumerate(house.vertices):
            for dx, dy in CIRCLE:
                corners = list(house.vertices)
                corners[k] = (x + dx * mpq(1, 10**9), y + dy * mpq(1, 10**9))
                found.append(len(squeeze_function(Part(corners))))
        assert max(found) > len(squeeze_function(house))

    def test_one_orientation_is_more_to_ask(self):
        plan = plan_feeding(RECTANGLE)
        assert tolerance_of(plan) > tolerance_of(plan, one_orientation=True) == 0
        corners = [(0, 0), (3, 0), (3, 2), ("0.00003", "2.0001")]
        assert len(squeeze_function(corners)) > 2  # the long edges lie flush one by one
        kite = plan_feeding(QUADRANGLE)
        assert tolerance_of(kite, one_orientation=True) > 0

    def test_gripper_errors_come_on_top(self):
        problem = FeedingProblem(RECTANGLE, gripper_error="5")
        both, exact = problem.geometric_plan(), orient_up_to_symmetry(RECTANGLE)
        assert 0 < tolerance_of(both) < tolerance_of(exact)

    def test_with_a_prior_the_first_action_is_real(self):
        prior = DiscretePrior({"100": 1})
        problem = FeedingProblem(QUADRANGLE, prior=prior, gripper_error="2")
        plan = problem.plan_of(1)
        epsilon = tolerance_of(plan)
        assert epsilon > 0
        (starts,) = verify_plan(problem.part, plan, vertex_error=epsilon).part_errors.starts
        assert plan.mouth.contains(starts.start)
        assert starts.width < plan.mouth.width

    def test_is_a_lower_bound_within_a_thousandth_of_the_method(self):
        plan = plan_feeding(QUADRANGLE)
        epsilon = tolerance_of(plan)
        courses = NearbyCourses.of_plan(plan, plan.part)
        assert courses.report(epsilon).proven
        assert not courses.report(epsilon * mpq(1001, 1000)).proven


def fails(plan, part):
    """Tell whether the plan takes some mouth, without its ends, to other edges or several."""
    nominal, whole = plan.transfer, composite(ACTIONS[plan.action_name](part), plan.angles)
    first = plan.mouth.start - plan.angles[0]
    start, end = (
        nominal(first),
        nominal.lifted_values[nominal.step_before(first + plan.mouth.width)],
    )
    jaws = NearbyParts(plan.part).on_jaws(plan.final_orientation.reduced().direction)
    near = NearbyParts(part)
    for theta in (start + plan.angles[0], end + plan.angles[0]):
        flush = [jaw for jaw in near.on_jaws(whole(theta).reduced().direction) if len(jaw) > 1]
        if not any(pair <= jaw for pair in flush for jaw in jaws):
            return True
    return whole(end + plan.angles[0]) - whole(start + plan.angles[0]) > Angle.from_degrees(90)


def shaken(part, epsilon, chance):
    corners = []
    for x, y in part.vertices:
        dx, dy = chance.choice(CIRCLE)
        corners.append((x + epsilon * mpq(dx), y + epsilon * mpq(dy)))
    return Part(corners, part.center_of_mass if part.has_given_center else None)


@pytest.mark.parametrize(
    ("name", "ratio"),
    [("triangle", 2), ("rectangle", 2), ("4gon", 2), ("5gon", 2), ("wrench", 3)],
)
def test_the_bound_is_not_absurdly_small(name, ratio):
    plan = orient_up_to_symmetry(catalogue_part(name))
    epsilon, chance = tolerance_of(plan), random.Random(1)
    assert not any(fails(plan, shaken(plan.part, epsilon, chance)) for _ in range(20))
    assert any(fails(plan, shaken(plan.part, ratio * epsilon, chance)) for _ in range(150))


class TestVerification:
    def test_says_what_is_proven(self):
        report = verify_plan(RECTANGLE, "0, -45", vertex_error="0.1").part_errors
        assert report.proven
        assert report.vertex_error == mpq(1, 10)
        assert report.probability == mpq(1, 2)
        assert [arc.width for arc in report.starts] == [HALF_TURN]
        assert [(f.start.degrees(1), f.end.degrees(1)) for f in report.finals] == [
            ("176.2", "183.8")
        ]
        assert not report.one_orientation
        assert report.reason is None

    def test_says_why_not(self):
        report = verify_plan(RECTANGLE, "0, -45", vertex_error="0.2").part_errors
        assert not report.proven
        assert "another edge may lie flush in the end" in report.reason
        assert report.starts == report.finals == ()
        assert report.probability == 0

    def test_the_mouth_is_cut_at_its_ends(self):
        report = verify_plan(RECTANGLE, "0", vertex_error="0.01")
        (starts,) = report.part_errors.starts
        assert report.mouth.width.degrees(3) == "112.620"
        assert starts.width.degrees(3) == "111.984"  # less twice asin(0.02 / sqrt 13)
        assert starts.width.rational_turns == report.part_errors.probability

    def test_without_the_keyword_nothing_is_said(self):
        assert verify_plan(RECTANGLE, "0, -45").part_errors is None

    def test_takes_a_plan(self):
        plan = plan_feeding(RECTANGLE)
        epsilon = tolerance_of(plan)
        report = verify_plan(RECTANGLE, plan, vertex_error=epsilon)
        assert report.angles == plan.angles
        assert report.part_errors.proven
        push = plan_feeding(RECTANGLE, action="push-grasp")
        assert verify_plan(RECTANGLE, push, vertex_error=0).transfer == push.transfer

    def test_takes_a_plan_for_another_part(self):
        plan = plan_feeding(RECTANGLE)
        report = verify_plan([(0, 0), (4, 0), (4, 3), (0, 3)], plan, vertex_error="0.01")
        assert report.part_errors.proven

    def test_without_an_error_all_is_known(self):
        report = verify_plan(RECTANGLE, "0, -45", vertex_error=0).part_errors
        assert report.proven
        assert report.one_orientation
        assert [final.width for final in report.finals] == [Angle()]

    def test_angles_beyond_a_turn(self):
        plain = verify_plan(RECTANGLE, "10, -45", vertex_error="0.1").part_errors
        other = verify_plan(RECTANGLE, "370, 315", vertex_error="0.1").part_errors
        assert plain.proven
        assert [f.start for f in other.finals] == [f.start for f in plain.finals]

    @pytest.mark.parametrize("error", ["100", 10**30, Fraction(3, 2)])
    def test_errors_as_large_as_the_part_prove_nothing(self, error):
        assert not verify_plan(RECTANGLE, "0, -45", vertex_error=error).part_errors.proven


class TestBadInput:
    def test_negative(self):
        with pytest.raises(InputError, match=r"vertex error: -1/10; accepted: 0 or more"):
            verify_plan(RECTANGLE, "0", vertex_error="-0.1")

    def test_floats(self):
        with pytest.raises(FloatRefusedError, match="vertex error"):
            verify_plan(RECTANGLE, "0", vertex_error=0.1)

    @pytest.mark.parametrize("error", ["abc", Decimal("nan"), [1], True])
    def test_no_numbers(self, error):
        with pytest.raises(NumberError, match="vertex error"):
            verify_plan(RECTANGLE, "0", vertex_error=error)

    def test_transfer_functions_have_no_vertices(self):
        with pytest.raises(InputError, match="no vertices; accepted: a part"):
            verify_plan(squeeze_function(RECTANGLE), "0", vertex_error="0.1")

    def test_plans_without_a_part(self):
        s = squeeze_function(RECTANGLE)
        with pytest.raises(InputError, match="does not know its part"):
            tolerance_of(FeedingPlan(s, preimages(s), mpq(1)))

    def test_plans_of_other_actions(self):
        s = squeeze_function(RECTANGLE)
        plan = FeedingPlan(s, preimages(s), mpq(1), Part(RECTANGLE), "shake")
        with pytest.raises(InputError, match=r"'shake'; accepted: squeeze, push-grasp"):
            tolerance_of(plan)

    def test_no_plans(self):
        with pytest.raises(InputError, match="is no plan; accepted: a FeedingPlan"):
            tolerance_of("0, -45")


def test_full_turns_of_a_push_grasp():
    plan = orient_up_to_symmetry(QUADRANGLE, action="push-grasp")
    assert plan.mouth.width == FULL_TURN
    report = verify_plan(plan.part, plan, vertex_error=tolerance_of(plan)).part_errors
    assert report.proven
    assert report.probability == 1
