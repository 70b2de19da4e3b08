"""`stochgeom.feeding.execution` and `.propagation`: plans run forward, claims put to the test."""

from __future__ import annotations

from dataclasses import replace

import pytest
from gmpy2 import mpq

from stochgeom.errors import InvalidArcError, VerificationError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.execution import check_plan, composite, run_angle, run_arc
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.propagation import outcomes
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

RECTANGLE = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
PLAN = FeedingProblem([(-4, 3), (-2, -4), (0, -3), (2, 2), (0, 4)]).geometric_plan()
MOUTH = PLAN.mouth
RANGES = [(action.low, action.angle, action.high) for action in PLAN.actions]
FREE, (LOW_1, MID_1, HIGH_1), (LOW_2, MID_2, HIGH_2) = RANGES
E = Angle(0, (10**12, 1))


def deg(value):
    return Angle.from_degrees(value)


def deg_list(*values):
    return list(map(deg, values))


# --- forward -------------------------------------------------------------------------------------


def test_single_orientations():
    angles = (ZERO, deg(-45))
    assert run_angle(RECTANGLE, angles, deg(10)) == (deg(10), ZERO, ZERO)
    assert run_angle(RECTANGLE, angles, deg(100)) == (deg(100), QUARTER_TURN, HALF_TURN)
    assert run_angle(RECTANGLE, angles, deg(460)) == (deg(460), deg(450), deg(540))
    assert run_angle(RECTANGLE, (), deg(10)) == (deg(10),)


def test_arcs():
    first, second = run_arc(RECTANGLE, (ZERO, deg(-45)), Arc(deg(60), deg(100)))
    assert (first.start, first.end) == (QUARTER_TURN, HALF_TURN)
    assert (second.start, second.end) == (HALF_TURN, HALF_TURN)
    # The half-open end is not taken: 60 + 180 degrees is one step further.
    (image,) = run_arc(RECTANGLE, (ZERO,), Arc(Angle(0, (2, 3)), HALF_TURN))
    assert (image.start, image.end) == (QUARTER_TURN, HALF_TURN)
    (image,) = run_arc(RECTANGLE, (ZERO,), Arc(deg(57), HALF_TURN))
    assert (image.start, image.end) == (QUARTER_TURN, deg(270))


def test_composites():
    angles = (deg(20), deg(-45))
    whole = composite(RECTANGLE, angles)
    for theta in map(deg, (0, 50, 76, 77, 100, 143, 144, 359)):
        assert whole(theta) == run_angle(RECTANGLE, angles, theta)[-1]
    assert composite(RECTANGLE, angles[:1]) == RECTANGLE.after_turning(deg(20))


# --- distributions -------------------------------------------------------------------------------


def test_what_actions_make_of_a_uniform_prior():
    once, twice = outcomes(RECTANGLE, (deg(20), deg(-45)))
    assert (len(once), len(twice)) == (4, 2)
    first, second = once.hyperstate(), twice.hyperstate()
    assert first.orientations == (ZERO, QUARTER_TURN, HALF_TURN, deg(270))
    assert first.probabilities(2) == ("0.31", "0.19", "0.31", "0.19")
    assert once.most_likely() == first.probability(0)
    assert second.orientations == (ZERO, HALF_TURN)
    assert second.widths == (HALF_TURN, HALF_TURN)
    assert twice.most_likely().rational == mpq(1, 2)


def test_the_value_of_the_first_angle_does_not_matter():
    for first in (ZERO, deg(20), deg(-1000), Angle(0, (3, 2))):
        *_, last = outcomes(RECTANGLE, (first, deg(17), deg(-45)))
        assert last.hyperstate().orientations == (ZERO, HALF_TURN)


def test_states_are_joined_around_the_end_of_the_period():
    # Values 10 and 350 = -10; an action at -15 sends -10 and 10 to the same step [0, 100).
    pair = StepFunction([ZERO, deg(100)], [deg(10), deg(350)])
    _, last = outcomes(pair, (ZERO, deg(-15)))
    assert last.hyperstate().orientations == (deg(10),)
    assert last.hyperstate().widths == (FULL_TURN,)
    three = StepFunction(deg_list(0, 100, 200), deg_list(10, 150, 350))
    _, last = outcomes(three, (ZERO, deg(-15)))
    assert last.hyperstate().orientations == (deg(10), deg(150))
    assert last.hyperstate().widths == (deg(260), deg(100))


def test_values_beyond_a_full_turn_are_states_too():
    ahead = StepFunction(deg_list(0, 100), deg_list(350, 400))
    (outcome,) = outcomes(ahead, (ZERO,))
    assert outcome.hyperstate().orientations == (deg(40), deg(350))
    assert outcome.hyperstate().widths == (deg(260), deg(100))
    assert outcome.most_likely() == mpq(26, 36)


# --- what holds ----------------------------------------------------------------------------------


def test_a_plan_that_does_what_it_claims():
    check_plan(PLAN.transfer, MOUTH, RANGES)


def test_a_plan_may_claim_less_than_it_does():
    """A narrower mouth, another angle inside a range, a lower upper end."""
    check_plan(PLAN.transfer, Arc(MOUTH.start + E, MOUTH.width - E), RANGES)
    check_plan(PLAN.transfer, MOUTH, [FREE, (LOW_1, HIGH_1, HIGH_1), RANGES[2]])
    check_plan(PLAN.transfer, MOUTH, [FREE, (LOW_1, MID_1, MID_1), RANGES[2]])


def test_whole_periods_make_no_difference():
    turned = tuple(angle + HALF_TURN for angle in RANGES[1])
    check_plan(PLAN.transfer, MOUTH.rotate(HALF_TURN), [FREE, turned, RANGES[2]])
    last = run_arc(PLAN.transfer, PLAN.angles, MOUTH.rotate(HALF_TURN))[-1]
    assert (last.start, last.width) == (PLAN.final_orientation + HALF_TURN, ZERO)


def test_one_squeeze_has_nothing_to_go_wrong_but_its_mouth():
    square = FeedingProblem([(0, 0), (1, 0), (1, 1), (0, 1)]).geometric_plan()
    check_plan(square.transfer, square.mouth, [FREE])
    with pytest.raises(VerificationError, match="not collapsed"):
        check_plan(square.transfer, Arc(square.mouth.start, square.mouth.width + E), [FREE])


# --- what does not -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "mouth",
    [
        Arc(MOUTH.start, MOUTH.width + E),
        Arc(MOUTH.start - E, MOUTH.width + E),
        MOUTH.rotate(E),
        MOUTH.rotate(-E),
        MOUTH.rotate(QUARTER_TURN),
        Arc(MOUTH.start, FULL_TURN),
    ],
)
def test_another_mouth(mouth):
    with pytest.raises(VerificationError, match="at the nominal angles the mouth is not collapsed"):
        check_plan(PLAN.transfer, mouth, RANGES)


@pytest.mark.parametrize(
    ("k", "claim", "message"),
    [
        # the first turn is no longer 0
        (0, (None, E, None), "at the nominal angles the mouth is not collapsed"),
        (0, (None, -E, None), "at the nominal angles the mouth is not collapsed"),
        # nominal angles beyond the true range
        (1, (LOW_1, HIGH_1 + E, HIGH_1 + E), "at the nominal angles the mouth is not collapsed"),
        (2, (LOW_2, HIGH_2 + E, HIGH_2 + E), "at the nominal angles the mouth is not collapsed"),
        (1, (LOW_1 - E * 2, LOW_1 - E, HIGH_1), "the mouth is not collapsed"),
        (2, (LOW_2 - E * 2, LOW_2 - E, HIGH_2), "the mouth is not collapsed"),
        # ranges wider than the true ones
        (1, (LOW_1, MID_1, HIGH_1 + E), "at the upper ends the mouth is not collapsed"),
        (2, (LOW_2, MID_2, HIGH_2 + E), "at the upper ends the mouth is not collapsed"),
        (1, (LOW_1 - E, MID_1, HIGH_1), "just above the lower ends the mouth is not collapsed"),
        (2, (LOW_2 - E, MID_2, HIGH_2), "just above the lower ends the mouth is not collapsed"),
        # ... and shifted
        (1, (LOW_1 + E, MID_1 + E, HIGH_1 + E), "at the upper ends the mouth is not collapsed"),
        (2, (LOW_2 - E, MID_2 - E, HIGH_2 - E), "just above the lower ends the mouth is not"),
        # lower ends that are not the true ones
        (1, (LOW_1 + E, MID_1, HIGH_1), "action 1: the plan still works at 1.9092°, the open end"),
        (2, (LOW_2 + E, MID_2, HIGH_2), "action 2: the plan still works at 53.9726°, the open end"),
        # a period too long
        (2, (LOW_2, MID_2, HIGH_2 + HALF_TURN), "at the upper ends the plan ends in another"),
        (2, (LOW_2 - HALF_TURN, MID_2, HIGH_2), "just above the lower ends the plan ends in an"),
        # no ranges around their nominal angles
        (1, (LOW_1, LOW_1, HIGH_1), "action 1: 1.9092° is not in its range, above 1.9092° and up"),
        (2, (LOW_2, HIGH_2 + E, HIGH_2), "action 2: 60.0184° is not in its range"),
        (2, (MID_2, MID_2, MID_2), "action 2: 56.3099° is not in its range"),
        (2, (HIGH_2, MID_2, LOW_2), "action 2: 56.3099° is not in its range, above 60.0184°"),
        # the action before, the action after
        (2, RANGES[1], "the mouth is not collapsed"),
        (1, RANGES[2], "action 1: the plan still works at"),
    ],
)  # fmt: skip
def test_another_action(k, claim, message):
    ranges = list(RANGES)
    ranges[k] = claim
    with pytest.raises(VerificationError) as caught:
        check_plan(PLAN.transfer, MOUTH, ranges)
    assert message in str(caught.value)
    assert caught.value.where == (f"action {k}" if message.startswith("action") else None)


@pytest.mark.parametrize(
    ("transfer", "ranges"),
    [
        (PLAN.transfer, RANGES[:-1]),
        (PLAN.transfer, [FREE, RANGES[2], RANGES[1]]),
        (PLAN.transfer, [FREE, *(tuple(angle + QUARTER_TURN for angle in r) for r in RANGES[1:])]),
        (PLAN.transfer.rotate(E), RANGES),
        (RECTANGLE, RANGES),
    ],
)
def test_another_plan_or_part(transfer, ranges):
    with pytest.raises(VerificationError, match="the mouth is not collapsed"):
        check_plan(transfer, MOUTH, ranges)


@pytest.mark.parametrize("k", range(3))
def test_a_plan_made_of_another_preimage(k):
    """`FeedingPlan.verify` finds what `check_plan` finds."""
    assert PLAN.verify() is True
    chain = list(PLAN.preimages)
    chain[k] = replace(chain[k], last=chain[k].last + 1)
    with pytest.raises((VerificationError, InvalidArcError)):  # a range may be empty as well
        FeedingPlan(PLAN.transfer, chain, PLAN.cost_ratio).verify()
