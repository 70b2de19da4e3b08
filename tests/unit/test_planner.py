"""`stochgeom.feeding.planner`: phase II on known parts, and what it refuses."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.errors import CostError, InputError, SelfIntersectionError
from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry, plan_feeding
from stochgeom.geometry.part import Part

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
HOUSE = [(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]
FOUR_STEPS = [(-4, 3), (-2, -4), (0, -3), (2, 2), (0, 4)]
"""Its widths rise slowly: the shortest plan up to symmetry has several steps."""

COSTS = [0, "0.1234567", "1/3", 1, 10**6, "1e-30", Fraction(10**30, 7), Decimal("2.5")]


# --- worked cases --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("vertices", "costs", "best"),
    [
        (RECTANGLE, ["6.39", "6.00", "8.00", "10.00"], 2),
        (HOUSE, ["5.03", "6.00", "8.00", "10.00"], 1),
        ([(0, 0), (1, 0), (1, 1), (0, 1)], ["8.00", "12.00", "16.00"], 1),
        ([(0, 0), (5, 0), (-1, 1)], ["4.00", "6.00"], 1),
    ],
)
def test_expected_costs(vertices, costs, best):
    problem = FeedingProblem(vertices)
    assert [problem.expected_cost(i + 1).decimal(2) for i in range(len(costs))] == costs
    plan = problem.optimal_plan()
    assert plan.steps == best
    assert plan.expected_cost.decimal(2) == costs[best - 1]


def test_probabilities():
    problem = FeedingProblem(RECTANGLE)
    assert [problem.probability(i).decimal(4) for i in (1, 2, 3)] == ["0.3128", "0.5000", "0.5000"]
    assert problem.probability(2).rational == mpq(1, 2)


def test_both_ways_to_ask_agree():
    for vertices in (RECTANGLE, np.array(RECTANGLE), Part(RECTANGLE, name="it")):
        problem = FeedingProblem(vertices)
        plan, shortest = plan_feeding(vertices, "1/3"), orient_up_to_symmetry(vertices, "1/3")
        assert plan.actions == problem.optimal_plan("1/3").actions
        assert shortest.actions == problem.geometric_plan("1/3").actions
        assert plan.cost_ratio == shortest.cost_ratio == mpq(1, 3)
        assert plan.action_name == "squeeze"
    assert plan_feeding(Part(RECTANGLE, name="it")).part.name == "it"


@pytest.mark.parametrize("cost_ratio", COSTS)
@pytest.mark.parametrize("vertices", [RECTANGLE, HOUSE, FOUR_STEPS])
def test_every_cost_ratio_is_exact(vertices, cost_ratio):
    problem = FeedingProblem(vertices)
    plan = problem.optimal_plan(cost_ratio)
    c = Fraction(str(cost_ratio))
    assert plan.cost_ratio == mpq(c.numerator, c.denominator)
    # The costs to 80 digits of the widths: no two of these plans cost the same.
    longest = problem.geometric_plan().steps
    turns = [Fraction(problem.preimages.of_steps(i).width.turns(80)) for i in range(1, longest + 1)]
    costs = [(i + c) / h for i, h in enumerate(turns, 1)]
    assert plan.steps == 1 + costs.index(min(costs))


def test_dear_filters_ask_for_long_plans_and_cheap_ones_for_short_plans():
    problem = FeedingProblem(FOUR_STEPS)
    lengths = [problem.optimal_plan(c).steps for c in (0, "1/3", 1, 3, 10, 10**6)]
    assert lengths == sorted(lengths)
    assert lengths[0] == 1
    assert lengths[-1] == problem.geometric_plan().steps > 2


@pytest.mark.parametrize(
    ("vertices", "c", "costs"),
    [
        ([(-1, -2), (2, -2), (1, 4), (-3, 3)], 0, ["6.098", "6.177", "6.000"]),
        ([(-1, -2), (3, -1), (4, 1), (-1, 2)], 0, ["6.098", "6.419", "6.000"]),
        (
            [(-1, -1), (3, -3), (4, 3), (-3, 3)],
            "1/3",
            ["8.813", "8.719", "8.889", "8.667"],
        ),
    ],
)
def test_costs_may_rise_before_they_fall(vertices, c, costs):
    """One more step that does not pay is no reason to stop."""
    problem = FeedingProblem(vertices)
    assert [problem.expected_cost(i + 1, c).decimal(3) for i in range(len(costs))] == costs
    assert problem.optimal_plan(c).steps == len(costs)


def test_no_more_preimages_are_computed_than_needed():
    problem = FeedingProblem(FOUR_STEPS)
    problem.optimal_plan(0)
    assert len(problem.preimages.found()) < problem.geometric_plan().steps


def test_plans_of_every_length():
    problem = FeedingProblem(FOUR_STEPS)
    longest = problem.geometric_plan().steps
    for steps in range(1, longest + 1):
        plan = problem.plan_of(steps, "1/7")
        assert (plan.steps, len(plan.actions)) == (steps, steps)
        assert plan.expected_cost == problem.expected_cost(steps, "1/7")
        assert plan.probability == problem.probability(steps)
        assert plan.orients_up_to_symmetry == (steps == longest)
        assert plan.verify()
    assert problem.plan_of(longest).mouth.width == problem.transfer.period == HALF_TURN


# --- refusing ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("cost_ratio", "message"),
    [
        (-1, "-1 is negative; accepted: 0 or more"),
        ("-1/7", "-1/7 is negative; accepted: 0 or more"),
        ("-1e-40", "is negative; accepted: 0 or more"),
        (0.5, "binary float; give text or a Fraction"),
        (float("nan"), "binary float"),
        (float("inf"), "binary float"),
        (np.float64(1), "binary float"),
        ("nan", "accepted: whole numbers, fractions and decimals"),
        ("inf", "accepted: whole numbers, fractions and decimals"),
        ("cheap", "'cheap' is not a number"),
        ("", "accepted: whole numbers"),
        ("1/0", "divides by zero"),
        ("1e999999999", "accepted: exponents"),
        (None, "not an exact number"),
        (True, "truth value"),
        ((1, 2), "not an exact number"),
    ],
)
def test_cost_ratios_that_are_none(cost_ratio, message):
    problem = FeedingProblem(RECTANGLE)
    for ask in (
        lambda: plan_feeding(RECTANGLE, cost_ratio),
        lambda: orient_up_to_symmetry(RECTANGLE, cost_ratio),
        lambda: problem.expected_cost(1, cost_ratio),
        lambda: problem.plan_of(1, cost_ratio),
    ):
        with pytest.raises(CostError) as caught:
            ask()
        assert caught.value.where == "cost ratio"
        assert message in caught.value.message
        assert "cost ratio: " in str(caught.value)


@pytest.mark.parametrize("action", ["push", "push-grasp?", "", "SQUEEZE", None, 3, ["squeeze"]])
def test_unknown_actions(action):
    for ask in (plan_feeding, orient_up_to_symmetry):
        with pytest.raises(InputError, match=r"accepted: .*squeeze") as caught:
            ask(RECTANGLE, action=action)
        assert repr(action) in caught.value.message


@pytest.mark.parametrize("steps", [0, -3, 3, 100])
def test_plans_of_other_lengths(steps):
    fresh, used = FeedingProblem(RECTANGLE), FeedingProblem(RECTANGLE)
    used.geometric_plan()
    for problem in (fresh, used):
        with pytest.raises(InputError) as caught:
            problem.plan_of(steps)
        assert caught.value.message == f"{steps} steps; accepted: 1 to 2 for this part"


def test_an_outline_that_is_none():
    with pytest.raises(SelfIntersectionError):
        plan_feeding([(0, 0), (1, 1), (1, 0), (0, 1)])


def test_costs_beyond_the_last_preimage_go_on():
    problem = FeedingProblem(RECTANGLE)
    assert problem.expected_cost(100, "1/2").rational == 201
    assert len(problem.preimages.found()) == 2


def test_the_first_action_is_free():
    plan = plan_feeding(FOUR_STEPS, 100)
    first, *others = plan.actions
    assert (first.low, first.high, first.tolerance) == (None, None, None)
    assert first.angle == Angle()
    assert all(action.low < action.angle < action.high for action in others)
