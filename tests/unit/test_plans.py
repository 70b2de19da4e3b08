"""`stochgeom.feeding.plans`: the plan of a rectangle by hand, and a plan of three steps."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest
import sympy
from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import Action
from stochgeom.geometry.part import Part

RECTANGLE = FeedingProblem(Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="rectangle"))
TWO = RECTANGLE.geometric_plan()
ONE = RECTANGLE.plan_of(1, "1/2")
THREE = FeedingProblem([(-4, 3), (-2, -4), (0, -3), (2, 2), (0, 4)]).geometric_plan()

BREAK = Angle(0, (2, 3))  # 56.31 degrees


# --- actions -------------------------------------------------------------------------------------


def test_the_plan_of_a_rectangle():
    """Both states are turned until the wide step holds them."""
    assert TWO.steps == 2
    assert TWO.mouth == Arc(BREAK, HALF_TURN)
    assert TWO.final_orientation == HALF_TURN
    free, second = TWO.actions
    assert free == Action(None, None)
    # The image is [90, 180]; the wide step is [180 - 56.31, 180 + 56.31).
    assert second.low == HALF_TURN - (HALF_TURN + BREAK)
    assert second.high == QUARTER_TURN - (HALF_TURN - BREAK)
    assert second.tolerance == Angle(0, (-5, 12)) - QUARTER_TURN
    assert second.angle == -EIGHTH_TURN
    assert TWO.angles == (ZERO, -EIGHTH_TURN)
    assert TWO.cumulative_angles == (ZERO, -EIGHTH_TURN)
    assert TWO.orients_up_to_symmetry
    assert TWO.verify()


def test_a_plan_of_one_step():
    assert ONE.steps == 1
    assert ONE.actions == (Action(None, None),)
    assert ONE.mouth.width == Angle(0, (-5, 12))
    assert not ONE.orients_up_to_symmetry
    assert ONE.verify()


def test_cumulative_angles_add_up():
    total = ZERO
    for angle, sum_so_far in zip(THREE.angles, THREE.cumulative_angles, strict=True):
        total += angle
        assert sum_so_far == total
    assert THREE.cumulative_angles[-1] == THREE.angles[1] + THREE.angles[2]


def test_nominal_angles_are_simple_and_near_the_middle():
    for action in THREE.actions[1:]:
        eighth = action.tolerance.to_float() / 8
        middle = (action.low.to_float() + action.high.to_float()) / 2
        assert abs(action.angle.to_float() - middle) < 1.01 * eighth
        assert max(map(abs, action.angle.direction)) < 10


def test_actions_are_values():
    assert len({Action(ZERO, HALF_TURN), Action(ZERO, HALF_TURN), Action(ZERO, FULL_TURN)}) == 2
    with pytest.raises(FrozenInstanceError):
        TWO.actions[1].low = ZERO


# --- what a plan is worth ------------------------------------------------------------------------


def test_probability_of_one_and_of_any_final_orientation():
    assert TWO.probability.rational == mpq(1, 2)
    assert TWO.probability_up_to_symmetry.rational == 1
    assert ONE.probability.decimal(6) == "0.312833"
    assert ONE.probability_up_to_symmetry.decimal(6) == "0.625666"
    assert ONE.probability.to_sympy() == (sympy.pi - sympy.atan(sympy.Rational(12, 5))) / (
        2 * sympy.pi
    )


def test_cost_of_one_and_of_any_final_orientation():
    assert TWO.expected_cost.rational == 6
    assert TWO.expected_cost_up_to_symmetry.rational == 3
    assert ONE.cost_ratio == mpq(1, 2)
    assert ONE.expected_cost.decimal(4) == "4.7949"
    assert ONE.expected_cost_up_to_symmetry.decimal(4) == "2.3974"
    expected_cost = ONE.expected_cost.to_sympy()
    assert str(sympy.N(expected_cost, 30)) == ONE.expected_cost.decimal(29)


def test_a_cost_ratio_of_zero_and_a_huge_one():
    free, dear = RECTANGLE.plan_of(2, 0), RECTANGLE.plan_of(2, "1e50")
    assert free.expected_cost.rational == 4
    assert dear.expected_cost.rational == 2 * (10**50 + 2)


# --- running a plan ------------------------------------------------------------------------------


def test_single_orientations_are_traced():
    assert TWO.execute(Angle.from_degrees(100)) == (
        Angle.from_degrees(100),
        QUARTER_TURN,
        HALF_TURN,
    )
    assert TWO.execute(ZERO) == (ZERO, ZERO, ZERO)
    assert TWO.execute(BREAK)[-1] == HALF_TURN
    assert TWO.execute(TWO.mouth.end)[-1] == FULL_TURN


def test_arcs_are_traced():
    first, second = TWO.execute_arc()
    assert (first.start, first.end) == (QUARTER_TURN, HALF_TURN)
    assert (second.start, second.width) == (HALF_TURN, ZERO)
    whole = TWO.execute_arc(Arc(BREAK, FULL_TURN))
    assert whole[-1].width == HALF_TURN


def test_distributions():
    assert TWO.distribution(1).probabilities(2) == ("0.31", "0.19", "0.31", "0.19")
    assert TWO.distribution(2) == TWO.distribution()
    assert TWO.distribution().orientations == (ZERO, HALF_TURN)
    assert [len(THREE.distribution(step)) for step in (1, 2, 3)] == [8, 4, 2]
    for step, outcome in enumerate(THREE.outcomes(), 1):
        assert outcome.hyperstate() == THREE.distribution(step)


@pytest.mark.parametrize("theta", [30, "30", 0.5, None])
def test_orientations_are_angles(theta):
    with pytest.raises(InputError, match=r"orientation: .* is no Angle; accepted"):
        TWO.execute(theta)
    if theta is not None:
        with pytest.raises(InputError, match=r"arc: .* is no Arc; accepted"):
            TWO.execute_arc(theta)


@pytest.mark.parametrize("step", [0, -1, 3, 100])
def test_distributions_after_other_numbers_of_steps(step):
    with pytest.raises(InputError, match=f"step {step}; accepted: 1 to 2"):
        TWO.distribution(step)


def test_a_plan_for_a_part_whose_period_is_a_quarter_turn():
    plan = FeedingProblem([(0, 0), (1, 0), (1, 1), (0, 1)]).optimal_plan()
    assert plan.steps == 1
    assert plan.orients_up_to_symmetry
    assert plan.probability.rational == mpq(1, 4)
    assert plan.probability_up_to_symmetry.rational == 1
    assert (plan.expected_cost.rational, plan.expected_cost_up_to_symmetry.rational) == (8, 2)
    assert len(plan.distribution()) == 4


# --- text ----------------------------------------------------------------------------------------


def test_repr():
    assert repr(TWO) == (
        "<FeedingPlan for rectangle: 2 squeeze actions, expected cost 6.0000, probability 0.5000>"
    )
    assert repr(ONE).startswith("<FeedingPlan for rectangle: 1 squeeze action, expected cost 4.79")
    assert repr(THREE).startswith("<FeedingPlan: 3 squeeze actions, ")


def test_an_action_s_decimals_work_as_they_stand():
    # The middle of a narrow range needs more digits than asked for.
    narrow = Action(Angle.from_degrees("10.00001"), Angle.from_degrees("10.00004"))
    angle, low, high = narrow.decimals(2)
    assert (low, high) == ("10.00001", "10.00004")
    assert mpq(low) < mpq(angle) <= mpq(high)
    third = Action(Angle.from_degrees("100/3"), Angle.from_degrees("200/3"))
    assert third.decimals(1)[1:] == ("33.4", "66.6")
    with pytest.raises(InputError, match="has no range"):
        Action(None, None).decimals()
