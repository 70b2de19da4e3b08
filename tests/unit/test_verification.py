"""`stochgeom.feeding.verification` and `.reports`: lists of angles, and what they do."""

from __future__ import annotations

from itertools import accumulate, repeat

import pytest
from gmpy2 import mpq

from stochgeom.errors import (
    CostError,
    InputError,
    InvalidAngleError,
    InvalidPartError,
    NumberError,
    NumberLimitError,
    VerificationError,
)
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding import verification
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry
from stochgeom.feeding.reports import CollapsedArc, Margin
from stochgeom.feeding.verification import MAX_ACTIONS, check_claim, parse_angles, verify_plan
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
WIDE, NARROW = Angle(0, (-5, 12)), Angle(0, (5, 12))  # 112.62 and 67.38 degrees
FIRST, SECOND = Angle(0, (2, 3)), Angle(0, (-2, 3))  # the breaks, 56.31 and 123.69 degrees
ONE_STEP = StepFunction([Angle()], [QUARTER_TURN])
"""All orientations go to 90 degrees: the period is a full turn."""


def deg(value):
    return Angle.from_degrees(value)


def ranges(report):
    """Return the margins after the first, in degrees with two decimals."""
    return [(margin.low.degrees(2), margin.high.degrees(2)) for margin in report.margins[1:]]


# --- worked by hand ------------------------------------------------------------------------------


class TestRectangle:
    """Breaks at 56.31 and 123.69 degrees, values 90 and 180, modulo 180."""

    def test_a_plan_that_orients_it(self):
        report = verify_plan(RECTANGLE, "0, -45")
        assert report.steps == 2
        assert report.collapsed == (CollapsedArc(Arc(FIRST, HALF_TURN), HALF_TURN),)
        assert report.mouth == Arc(FIRST, HALF_TURN)
        assert report.final_orientation == HALF_TURN
        assert report.final_orientations == 2
        assert report.hyperstate.orientations == (ZERO, HALF_TURN)
        assert report.orients_up_to_symmetry
        assert report.probability.rational == mpq(1, 2)
        assert report.probability_up_to_symmetry.rational == 1
        assert report.expected_cost.rational == 6
        assert report.expected_cost_up_to_symmetry.rational == 3
        assert report.best_width == HALF_TURN
        assert not report.better_exists
        assert report.first_misfit is None

    def test_its_margins(self):
        """The range is that of the planner's action: nothing before it narrows the image."""
        free, second = verify_plan(RECTANGLE, "0, -45").margins
        assert free == Margin(ZERO, None, None)
        assert (free.below, free.above) == (None, None)
        assert second == Margin(deg(-45), -FIRST, Angle(-1, (3, -2)))
        assert second.below.degrees(2) == second.above.degrees(2) == "11.31"

    def test_a_plan_that_does_not(self):
        """At 10 degrees both states fall back: 90 - 10 to 90, 180 - 10 to 180."""
        report = verify_plan(RECTANGLE, "0, 10", 3)
        assert report.collapsed == (
            CollapsedArc(Arc(FIRST, NARROW), QUARTER_TURN),
            CollapsedArc(Arc(SECOND, WIDE), HALF_TURN),
        )
        assert report.mouth == Arc(SECOND, WIDE)
        assert report.final_orientations == 4
        assert not report.orients_up_to_symmetry
        assert report.probability.decimal(4) == "0.3128"
        assert report.expected_cost.decimal(3) == "15.983"  # (2 + 3) 360 / 112.62
        assert report.best_probability.rational == mpq(1, 2)
        assert report.better_exists
        assert report.first_misfit == 1
        # 180 degrees comes back to itself between the breaks: 180 - 236.31 < alpha <= 56.31.
        assert ranges(report) == [("-56.31", "56.31")]

    def test_the_first_action_moves_the_arcs(self):
        report = verify_plan(RECTANGLE, "30, 315, 20")
        assert report.mouth == Arc(FIRST + deg(30), HALF_TURN)
        assert ranges(report) == [("303.69", "326.31"), ("-56.31", "56.31")]
        # 90 + 123.69 degrees is beyond the period: that arc starts at 33.69, half a turn earlier.
        moved = verify_plan(RECTANGLE, "90, 10")
        assert [item.arc.start.degrees(2) for item in moved.collapsed] == ["33.69", "146.31"]
        assert [item.orientation for item in moved.collapsed] == [ZERO, QUARTER_TURN]

    def test_one_action(self):
        report = verify_plan(RECTANGLE, [deg(71)])
        assert report.mouth == Arc((SECOND + deg(71)) % HALF_TURN, WIDE)
        assert report.margins == (Margin(deg(71), None, None),)
        assert report.first_misfit is None
        assert not report.better_exists

    def test_text_form(self):
        assert repr(verify_plan(RECTANGLE, "0, -45")) == (
            "<PlanReport: 2 actions, 2 final orientations, probability 0.5000>"
        )
        assert repr(verify_plan(ONE_STEP, "0")) == (
            "<PlanReport: 1 action, 1 final orientation, probability 1.0000>"
        )


class TestFigure46:
    """The 4gon, its plan as the source prints it: the gripper at 0, 71, 35 and 8 degrees."""

    part = catalogue_part("4gon")

    def test_the_printed_poses_orient_it(self):
        report = verify_plan(self.part, "0, 71, 35, 8", cumulative=True)
        assert list(report.angles) == [deg(0), deg(71), deg(-36), deg(-27)]
        assert report.orients_up_to_symmetry
        assert report.final_orientations == 2
        assert report.expected_cost.rational == 10
        assert report.first_misfit is None
        assert ranges(report) == [
            ("64.41", "77.12"),
            ("-46.17", "-25.45"),
            ("-46.17", "-8.59"),
        ]

    def test_as_relative_angles_they_do_not(self):
        """Half the mouth is lost at the third action, the one numbered 2."""
        report = verify_plan(self.part, "0, 71, 35, 8")
        assert report.probability.decimal(4) == "0.2504"
        assert report.final_orientations == 4
        assert report.first_misfit == 2
        assert report.better_exists

    def test_the_first_three_of_them_are_not_the_best_three(self):
        """They lead to a period in four steps; three steps can do better than 0.25."""
        report = verify_plan(self.part, "0, 71, 35", cumulative=True)
        assert report.first_misfit == 1
        assert report.probability.decimal(2) == "0.25"
        assert report.best_probability.decimal(2) == "0.38"

    def test_the_planners_own_plan(self):
        plan = orient_up_to_symmetry(self.part)
        assert list(accumulate(plan.angles)) == list(plan.cumulative_angles)
        report = verify_plan(self.part, plan.cumulative_angles, cumulative=True)
        assert report.angles == plan.angles
        assert report.mouth == plan.mouth
        assert report.final_orientation == plan.final_orientation.reduced()


def test_margins_may_be_larger_than_the_ranges_of_a_plan():
    """The part of decision 6: its third action still works at the planner's `low`."""
    plan = FeedingProblem([(-4, 3), (-2, -4), (0, -3), (2, 2), (0, 4)]).geometric_plan()
    report = verify_plan(plan.transfer, plan.angles)
    assert report.mouth == plan.mouth
    margin, action = report.margins[2], plan.actions[2]
    assert margin.low < action.low
    assert action.high <= margin.high
    at_low = [*plan.angles[:2], action.low]
    assert verify_plan(plan.transfer, at_low).orients_up_to_symmetry
    assert not verify_plan(plan.transfer, [*plan.angles[:2], margin.low]).orients_up_to_symmetry


class TestFullTurn:
    """Maps of period 360 degrees: a mouth that is the whole circle has no ends."""

    # breaks at 0 and 15 degrees, values 0 and 105
    two_steps = StepFunction([deg(0), deg(15)], [deg(0), deg(105)])

    def test_one_step_needs_no_angle(self):
        report = verify_plan(ONE_STEP, "0, 200, 7")
        assert report.mouth == Arc(ZERO, FULL_TURN)
        assert report.final_orientation == QUARTER_TURN
        for margin in report.margins[1:]:
            assert margin.high - margin.low == FULL_TURN
            assert margin.low < margin.angle <= margin.high

    @pytest.mark.parametrize("alpha", [90, 105, 120, 345, 360, 270])
    def test_the_range_around_the_angle(self, alpha):
        """Both states, 0 and 105, must be turned into [15, 360).

        0 - alpha is outside for alpha in (345, 360], 105 - alpha for alpha in (90, 105].
        """
        report = verify_plan(self.two_steps, [ZERO, deg(alpha)])
        collapses = not (345 < alpha <= 360 or 90 < alpha <= 105)
        assert report.orients_up_to_symmetry is collapses
        if collapses:
            low, high = (0, 90) if alpha <= 90 else (105, 345)
            assert ranges(report) == [(f"{low}.00", f"{high}.00")]


def test_a_long_plan():
    """Two thousand actions, most of them of no use."""
    angles = [ZERO, deg(-45), *repeat(deg(10), 1998)]
    report = verify_plan(RECTANGLE, angles)
    assert report.orients_up_to_symmetry
    assert report.expected_cost.rational == 2 * 2001
    assert len(report.margins) == 2000
    assert report.first_misfit is None


def test_extra_actions_before_a_period_is_collapsed():
    """More steps than phase I needs: every arc of a period's width can be rescued for a while."""
    report = verify_plan(RECTANGLE, "0, 10, 10, 10")
    assert report.best_width == HALF_TURN
    assert report.better_exists
    assert report.first_misfit == 3
    assert verify_plan(RECTANGLE, "0, 10, 10, -45").first_misfit is None


def test_parts_and_transfer_functions_are_the_same_thing():
    part = verify_plan(catalogue_part("house"), "0, 45")
    function = verify_plan(squeeze_function(catalogue_part("house")), "0, 45")
    assert part.collapsed == function.collapsed
    assert part.margins == function.margins
    assert part.transfer == function.transfer


# --- angles --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "angles"),
    [
        ("0", [ZERO]),
        ("0, 71, 35.5, 8", [ZERO, deg(71), deg("71/2"), deg(8)]),
        ("0 71\n35.5\t8", [ZERO, deg(71), deg("35.5"), deg(8)]),
        (" 0 , 71 ", [ZERO, deg(71)]),
        ("-45, +45, 1e2, 1/3, .5, 5.", [deg(d) for d in (-45, 45, 100, "1/3", "1/2", 5)]),
        ("0.1, 33.69006752597979", [deg("1/10"), deg("33.69006752597979")]),
        ("45°, -71.5°", [deg(45), deg("-143/2")]),
        ("3:2, -1:0, 0:-7", [Angle(0, (3, 2)), HALF_TURN, Angle(0, (0, -1))]),
        ("(3, 2), (3,2) ( 1/2 , 1/3 )", [Angle(0, (3, 2))] * 3),
        ("0.1:0.2", [Angle(0, (1, 2))]),
    ],
)
def test_angles_in_text(text, angles):
    assert list(parse_angles(text)) == angles


@pytest.mark.parametrize(
    ("text", "place", "entry"),
    [
        ("0, abc", 1, "'abc'"),
        ("0, 71, nan", 2, "'nan'"),
        ("inf", 0, "'inf'"),
        ("0, 7 1x", 2, "'1x'"),
        ("71,5,,8", 2, "',8'"),
        (",0", 0, "',0'"),
        ("0,", 1, "''"),
        ("0, 3:", 1, "'3:'"),
        ("0, :2", 1, "':2'"),
        ("0, 3:2:1", 1, "'3:2:1'"),
        ("0:0", 0, "'0:0'"),
        ("(0, 0)", 0, "'(0, 0)'"),
        ("(3)", 0, "'(3)'"),
        ("(1, 2, 3)", 0, "'(1, 2, 3)'"),
        ("()", 0, "'()'"),
        ("0, (3, 2", 1, "'(3, 2'"),
        ("0, 3, 2)", 2, "'2)'"),
        ("5(3, 2)", 0, "'5(3, 2)'"),
        ("(3, 2)5", 0, "'(3, 2)5'"),
        ("-(3, 2)", 0, "'-(3, 2)'"),
        ("(3:2)", 0, "'(3:2)'"),
        ("((3, 2))", 0, "'((3, 2))'"),
        ("1/0", 0, "'1/0'"),
        ("0, 1;2", 1, "'1;2'"),
        ("0, ٣", 1, "'٣'"),
        ("0x10", 0, "'0x10'"),
    ],
)
def test_what_is_no_angle(text, place, entry):
    with pytest.raises(InvalidAngleError) as caught:
        parse_angles(text)
    assert caught.value.where == f"action {place}"
    assert str(caught.value).startswith(f"action {place}: {entry} is no angle; accepted: degrees")


def test_long_numbers_are_refused_by_length():
    with pytest.raises(NumberLimitError) as caught:
        parse_angles("0, 1e999999999")
    assert caught.value.where == "action 1"
    with pytest.raises(NumberLimitError):
        parse_angles("9" * 10**6)
    for word in ("x" * 10**4, "x" * 10**6):
        with pytest.raises(InputError) as long:
            parse_angles(word)
        assert len(str(long.value)) < 250


@pytest.mark.parametrize("text", ["", "   ", "\n"])
def test_no_angles(text):
    for call in (parse_angles, lambda text: verify_plan(RECTANGLE, text)):
        with pytest.raises(InputError, match=r"^angles: no actions; accepted: at least one"):
            call(text)


def test_no_angles_in_a_list():
    with pytest.raises(InputError, match=r"^angles: no actions"):
        verify_plan(RECTANGLE, [])


def test_more_than_a_million_actions():
    """Of an endless plan only a million and one angles are looked at."""
    assert MAX_ACTIONS == 10**6
    with pytest.raises(InputError, match=r"^angles: too many; accepted: at most 1000000 actions"):
        verify_plan(RECTANGLE, repeat(ZERO))


def test_the_limit_holds_for_text(monkeypatch):
    monkeypatch.setattr(verification, "MAX_ACTIONS", 3)
    assert len(parse_angles("1 2 3")) == 3
    for text in ("1 2 3 4", "1 2 3 4 x", "1 " * 10**6):
        with pytest.raises(InputError, match="too many; accepted: at most 3 actions"):
            parse_angles(text)


@pytest.mark.parametrize("other", [71, 71.0, "71", None, (3, 2)], ids=repr)
def test_objects_that_are_no_angles(other):
    with pytest.raises(InputError, match=r"^action 1: .* is no Angle; accepted: angles, or text"):
        verify_plan(RECTANGLE, [ZERO, other])


def test_other_bad_input():
    with pytest.raises(CostError):
        verify_plan(RECTANGLE, "0", -1)
    with pytest.raises(InvalidPartError):
        verify_plan([(0, 0), (1, 1), (2, 2)], "0")
    with pytest.raises(InputError, match=r"action 'push'"):
        verify_plan(RECTANGLE, "0", action="push")


def test_huge_angles():
    """Only the angle modulo a full turn matters, and the margins stay where the angle is."""
    report = verify_plan(RECTANGLE, "0, 36000000000000000000000000000315")
    assert report.orients_up_to_symmetry
    (_, margin) = report.margins
    assert margin.below.degrees(2) == margin.above.degrees(2) == "11.31"
    assert margin.high.degrees(0) == "36000000000000000000000000000326"
    assert (
        verify_plan(RECTANGLE, "0, 3.6e5000").collapsed == verify_plan(RECTANGLE, "0, 0").collapsed
    )


# --- claims --------------------------------------------------------------------------------------

GOOD = verify_plan(RECTANGLE, "0, -45")
BAD = verify_plan(RECTANGLE, "0, 10")


@pytest.mark.parametrize(
    "claim", ["up-to-symmetry", "probability=0.5", "probability=1/2", "probability=1e-9"]
)
def test_claims_that_hold(claim):
    check_claim(GOOD, claim)


@pytest.mark.parametrize(
    ("claim", "message"),
    [
        ("up-to-symmetry", "the plan ends in 4 orientations, not in 2 equivalent ones"),
        ("probability=0.5", "the most likely final orientation has the probability 0.3128"),
        ("probability=0.3129", "the most likely final orientation has the probability 0.3128"),
        ("probability=0.31284", "the most likely final orientation has the probability 0.31283"),
        ("probability=1", "the most likely final orientation has the probability 0.3128"),
    ],
)
def test_claims_that_fail(claim, message):
    with pytest.raises(VerificationError) as caught:
        check_claim(BAD, claim)
    assert caught.value.where == claim
    assert str(caught.value).startswith(f"{claim}: {message}")


def test_probabilities_are_compared_exactly():
    """0.5 is reached, anything above it is not; 112.62 / 360 is irrational."""
    check_claim(GOOD, "probability=0.5")
    with pytest.raises(VerificationError):
        check_claim(GOOD, "probability=0." + "5" + "0" * 60 + "1")
    digits = BAD.probability.decimal(60)
    below, above = digits[:-1] + "0", digits[:-4] + "9999"
    check_claim(BAD, f"probability={below}")
    with pytest.raises(VerificationError):
        check_claim(BAD, f"probability={above}")


@pytest.mark.parametrize(
    ("claim", "message"),
    [
        ("", "claim: ''; accepted: up-to-symmetry, probability=P"),
        ("up to symmetry", "claim: 'up to symmetry'; accepted: up-to-symmetry, probability=P"),
        ("up-to-symmetry=1", "claim: 'up-to-symmetry=1'; accepted"),
        ("Probability=1", "claim: 'Probability=1'; accepted"),
        ("probability=0", "claim: 'probability=0'; accepted: probabilities above 0, up to 1"),
        ("probability=1.5", "claim: 'probability=1.5'; accepted: probabilities above 0"),
        ("probability=-1", "claim: 'probability=-1'; accepted: probabilities above 0"),
        ("x" * 1000, "claim: 'xxxxx"),
    ],
)
def test_what_cannot_be_claimed(claim, message):
    with pytest.raises(InputError) as caught:
        check_claim(GOOD, claim)
    assert str(caught.value).startswith(message)
    assert len(str(caught.value)) < 150


@pytest.mark.parametrize("claim", ["probability", "probability=", "probability=half"])
def test_probabilities_that_are_no_numbers(claim):
    with pytest.raises(NumberError, match=r"^claim: .* is not a number"):
        check_claim(GOOD, claim)
