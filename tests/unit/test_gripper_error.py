"""`stochgeom.feeding.gripper_error`: bounds, accepted errors, and plans of known tolerance."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest
from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.errors import GripperErrorError, InputError, NoPlanError
from stochgeom.exact.angles import EIGHTH_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.decimals import Rounding
from stochgeom.feeding.actions import Action
from stochgeom.feeding.gripper_error import (
    ErrorBound,
    as_gripper_error,
    largest_gripper_error,
    least_slack,
    most_tolerant_chain,
)
from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding, plan_transfer
from stochgeom.feeding.preimages import Preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLACK = Angle(0, (-5, 12)) - QUARTER_TURN  # the wide step less a quarter turn, 22.62
S = squeeze_function(RECTANGLE)

# --- bounds --------------------------------------------------------------------------------------


class TestErrorBound:
    def test_the_bound_itself_is_not_borne(self):
        bound = ErrorBound(Angle.from_degrees(5))
        assert bound.allows(ZERO)
        assert bound.allows(Angle.from_degrees("2.4999"))
        assert not bound.allows(Angle.from_degrees("2.5"))
        assert not bound.allows(Angle.from_degrees(3))

    def test_order(self):
        small, large = ErrorBound(EIGHTH_TURN), ErrorBound(QUARTER_TURN)
        assert small < large
        assert large >= small
        assert max(small, large) is large
        assert ErrorBound(EIGHTH_TURN) == small
        assert len({small, ErrorBound(EIGHTH_TURN), large}) == 2

    def test_decimals_are_rounded_down(self):
        bound = ErrorBound(SLACK)  # 11.30993247...
        assert [bound.degrees(d) for d in (0, 1, 2, 4, 6)] == [
            "11",
            "11.3",
            "11.30",
            "11.3099",
            "11.309932",
        ]
        assert bound.degrees(4, Rounding.UP) == "11.3100"
        assert bound.degrees(2, Rounding.NEAREST) == "11.31"
        assert str(bound) == "11.3099°"

    def test_rational_bounds_are_recognised(self):
        assert ErrorBound(EIGHTH_TURN).degrees(1) == "22.5"
        assert ErrorBound(Angle.from_degrees("0.1")).degrees(2) == "0.05"
        assert ErrorBound(Angle.from_turns(mpq(1, 2160))).degrees(5) == "0.08333"


# --- what is accepted ----------------------------------------------------------------------------


class TestAccepted:
    @pytest.mark.parametrize(
        ("value", "turns"),
        [
            ("0.5", mpq(1, 720)),
            (0, mpq(0)),
            (1, mpq(1, 360)),
            (Fraction(1, 3), mpq(1, 1080)),
            (Decimal("2.5"), mpq(1, 144)),
            ("1/3", mpq(1, 1080)),
            ("179.999", mpq(179999, 360000)),
        ],
    )
    def test_exact_numbers_of_degrees(self, value, turns):
        assert as_gripper_error(value).rational_turns == turns

    def test_angles_are_taken_as_they_are(self):
        angle = Angle(0, (7, 1))
        assert as_gripper_error(angle) is angle

    @pytest.mark.parametrize(
        "value",
        ["-1", -1, "-0.0001", Angle(0, (7, -1)) - Angle(1), "180", 180, 1000, HALF_TURN, Angle(3)],
    )
    def test_negative_and_absurd_errors(self, value):
        with pytest.raises(GripperErrorError, match="accepted: an exact angle, or degrees") as e:
            as_gripper_error(value)
        assert e.value.where == "gripper error"

    @pytest.mark.parametrize("value", [0.5, float("nan"), "nan", "inf", "", "5°", "five", None, []])
    def test_what_is_no_exact_number(self, value):
        with pytest.raises(GripperErrorError, match="from 0 to less than 180 degrees"):
            as_gripper_error(value)

    @pytest.mark.parametrize("plan", [plan_feeding, orient_up_to_symmetry, FeedingProblem])
    def test_every_way_in_refuses_them(self, plan):
        for value in ("-1", 0.5, "180"):
            with pytest.raises(GripperErrorError):
                plan(RECTANGLE, gripper_error=value)
        with pytest.raises(GripperErrorError):
            plan_transfer(S, gripper_error="-1")


# --- the rectangle by hand -----------------------------------------------------------------------


class TestRectangle:
    """Two steps: the image of a quarter turn has to go into the wide step, 112.62 degrees."""

    def test_the_slack(self):
        plan = orient_up_to_symmetry(RECTANGLE)
        assert least_slack(plan.preimages) == SLACK == plan.actions[1].tolerance
        assert plan.error_bound == ErrorBound(SLACK) == largest_gripper_error(S)
        assert plan.margin == EIGHTH_TURN - Angle(0, (3, 2))  # 11.31: the middle is exact here

    def test_just_below_the_bound(self):
        plan = orient_up_to_symmetry(RECTANGLE, gripper_error="11.3099")
        assert plan.steps == 2
        assert plan.gripper_error == Angle.from_degrees("11.3099")
        assert plan.verify()

    @pytest.mark.parametrize("delta", ["11.31", 20, "56.3", "100", "179"])
    def test_above_the_bound(self, delta):
        with pytest.raises(NoPlanError, match=r"error of .*; accepted: less than 11\.3099°"):
            orient_up_to_symmetry(RECTANGLE, gripper_error=delta)

    @pytest.mark.parametrize("delta", ["11.31", 20, "56.3", "179"])
    def test_one_random_squeeze_bears_any_error(self, delta):
        plan = plan_feeding(RECTANGLE, 10, gripper_error=delta)
        assert plan.steps == 1
        assert plan.error_bound is plan.margin is None
        assert plan.verify()

    def test_at_the_bound_itself(self):
        """2 delta = slack: a tie, and ties fail."""
        half = Angle(0, (5, 1))  # half of SLACK: 2 arctan(1/5) = arctan(5/12)
        assert 2 * half == SLACK
        with pytest.raises(NoPlanError):
            orient_up_to_symmetry(RECTANGLE, gripper_error=half)
        chain = list(Preimages(S, SLACK))
        assert [p.steps for p in chain] == [1]
        slightly_less = half - Angle(0, (10**9, 1))
        assert orient_up_to_symmetry(RECTANGLE, gripper_error=slightly_less).steps == 2

    def test_a_chain_that_stalls_says_so(self):
        chain = Preimages(S, SLACK)
        assert not chain.stalled
        assert len(list(chain)) == 1
        assert chain.stalled
        assert not chain.complete
        assert chain.of_steps(5).steps == 1


def test_one_squeeze_of_a_square_bears_any_error():
    s = squeeze_function(SQUARE)
    assert largest_gripper_error(s) is None
    assert orient_up_to_symmetry(SQUARE, gripper_error="179").steps == 1


def test_a_larger_error_may_ask_for_another_chain():
    """The key: its shortest plan bears 0.84 degrees, a longer one nearly 15.34."""
    problem = FeedingProblem(catalogue_part("key"))
    assert problem.geometric_plan().steps == 3
    assert problem.geometric_plan().error_bound.degrees(2) == "0.84"
    assert problem.largest_gripper_error().degrees(2) == "15.34"
    longer = orient_up_to_symmetry(problem.part, gripper_error="15.34")
    assert longer.steps > 3
    assert longer.verify()


def test_widths_need_not_grow_under_error():
    """A stage that is no wider ends the chain; the next one could not be wider either."""
    problem = FeedingProblem(catalogue_part("4gon"), gripper_error="18")
    widths = [p.width for p in problem.preimages]
    assert len(widths) == 2
    assert problem.preimages.stalled
    assert sorted(set(widths)) == widths


# --- most tolerant plans -------------------------------------------------------------------------


class TestMostTolerant:
    problem = FeedingProblem(catalogue_part("key"))

    def test_a_narrower_stage_leaves_more_slack(self):
        usual, tolerant = self.problem.plan_of(3), self.problem.most_tolerant(3)
        assert (usual.error_bound.degrees(2), tolerant.error_bound.degrees(2)) == ("0.84", "5.62")
        assert usual.mouth.width == tolerant.mouth.width == HALF_TURN
        assert tolerant.preimages[1].width < usual.preimages[1].width
        assert tolerant.verify()
        assert tolerant.expected_cost == usual.expected_cost

    def test_one_step_has_no_slack(self):
        chain = most_tolerant_chain(self.problem.transfer, 1)
        assert least_slack(chain) is None
        assert chain[0].width == self.problem.preimages.of_steps(1).width

    @pytest.mark.parametrize("steps", [0, -1, 4, 100])
    def test_more_steps_than_help(self, steps):
        with pytest.raises(InputError, match=f"{steps} steps; accepted: 1 to 3"):
            self.problem.most_tolerant(steps)

    def test_an_error_that_not_even_this_plan_bears(self):
        problem = FeedingProblem(catalogue_part("key"), gripper_error=6)
        with pytest.raises(NoPlanError, match=r"error of 6\.0000°; accepted: less than 5\.62"):
            problem.most_tolerant(3)
        assert FeedingProblem(problem.part, gripper_error=5).most_tolerant(3).verify()

    def test_a_literal_part(self):
        corners = [(2, -2), (4, -4), (-3, -3), (-2, 3), (-1, 3), (-1, 0), (0, 4)]
        problem = FeedingProblem(corners)
        assert problem.plan_of(3).error_bound.degrees(3) == "9.813"
        assert problem.most_tolerant(3).error_bound.degrees(3) == "12.433"
        assert problem.largest_gripper_error().degrees(3) == "19.452"


# --- other priors --------------------------------------------------------------------------------


class TestPriors:
    prior = DiscretePrior({"100": "1/2", "190": "1/2"})

    def test_the_mouth_shrinks_by_the_error_at_both_ends(self):
        plan = plan_feeding(RECTANGLE, 0, prior=self.prior, gripper_error=5)
        exact = FeedingProblem(RECTANGLE, prior=self.prior).plan_of(plan.steps)
        assert exact.mouth.width - plan.mouth.width == Angle.from_degrees(10)
        assert plan.probability.rational == 1
        assert plan.verify()

    def test_an_error_that_leaves_nothing(self):
        with pytest.raises(NoPlanError, match=r"accepted: less than 56\.3099°"):
            plan_feeding(RECTANGLE, prior=self.prior, gripper_error=60)
        problem = FeedingProblem(RECTANGLE, prior=self.prior, gripper_error=60)
        assert problem.placement(1) is None
        with pytest.raises(NoPlanError, match="no plan of 1 steps"):
            problem.probability(1)
        with pytest.raises(NoPlanError, match="the first action may miss it by 60"):
            _ = problem.plan_of(1).mouth

    def test_an_error_that_leaves_a_little(self):
        plan = plan_feeding(RECTANGLE, prior=self.prior, gripper_error=56)
        assert plan.mouth.width == Angle(0, (-5, 12)) - Angle.from_degrees(112)
        assert plan.probability.rational == Fraction(1, 2)


# --- actions -------------------------------------------------------------------------------------


class TestActions:
    def test_a_margin_moves_the_angle_inwards_only_if_it_has_to(self):
        low, high = Angle.from_degrees(0), Angle.from_degrees(10)
        plain = Action(low, high)
        assert Action(low, high, Angle.from_degrees(1)).angle == plain.angle
        narrow = Action(low, high, Angle.from_degrees("4.99"))
        assert Angle.from_degrees("4.99") < narrow.angle < Angle.from_degrees("5.01")

    def test_a_free_angle(self):
        assert Action(None, None).angle == ZERO
        assert Action(None, None, free_angle=EIGHTH_TURN).angle == EIGHTH_TURN
        assert Action(None, None).tolerance is None
