"""Plans that weigh the stability of the final grasp."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.errors import CostError, GoalError, GripperErrorError
from stochgeom.exact.angles import HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.feeding.grasp_costs import plan_weighing_grasps, stability_costs
from stochgeom.feeding.planner import plan_feeding
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.stability import stable_grasps
from tests.strategies import hulls

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
FOUR = [(52, 58), (0, 55), (8, 17), (51, 0)]


def test_costs_of_the_rectangle():
    costs = stability_costs(RECTANGLE, "10")
    assert costs == {ZERO: 0, QUARTER_TURN: mpq("401703/100000")}  # 10 (1 - 33.69 / 56.31)
    assert stability_costs(RECTANGLE, 0) == {ZERO: 0, QUARTER_TURN: 0}


def test_equal_grasps_cost_nothing():
    assert set(stability_costs([(0, 0), (1, 0), (1, 1), (0, 1)], 5).values()) == {0}


@given(hulls(), st.sampled_from([0, 1, "1/3", 20]), st.sampled_from([0, 1, 5]))
def test_no_goal_is_cheaper(part, weight, c):
    """Against one problem for each grasp, its cost added to the filter's."""
    costs = stability_costs(part, weight)
    plan = plan_weighing_grasps(part, costs, c)
    assert plan.verify()
    assert min(costs.values()) == 0
    assert max(costs.values()) <= mpq(weight)
    grasp = plan.final_orientation % FeedingProblem(part).transfer.period
    assert grasp in {g.orientation for g in stable_grasps(part)}
    assert plan.cost_ratio == c + costs[grasp]
    for orientation, other in costs.items():
        rival = FeedingProblem(part, goal=orientation).optimal_plan(c + other)
        assert plan.expected_cost <= rival.expected_cost


@given(hulls())
def test_without_weight_it_is_the_optimal_plan(part):
    plain = plan_feeding(part)
    weighed = plan_weighing_grasps(part, stability_costs(part, 0))
    assert weighed.expected_cost == plain.expected_cost
    assert weighed.steps == plain.steps


def test_a_heavy_weight_decides():
    assert plan_weighing_grasps(FOUR, stability_costs(FOUR, 0)).final_orientation.degrees(0) == "91"
    heavy = plan_weighing_grasps(FOUR, stability_costs(FOUR, 1))
    assert heavy.final_orientation.degrees(0) == "22"
    assert heavy.expected_cost.rational == 10


def test_push_grasps_end_in_squeeze_grasps():
    plan = plan_weighing_grasps(FOUR, stability_costs(FOUR, 3), action="push-grasp")
    assert (plan.final_orientation % HALF_TURN).degrees(0) == "22"
    assert plan.verify()


def test_priors_and_errors_go_through():
    prior = DiscretePrior({"0": 1})
    plan = plan_weighing_grasps(FOUR, stability_costs(FOUR, 1), prior=prior)
    assert (plan.steps, plan.probability.rational) == (1, 1)
    with pytest.raises(GripperErrorError):
        plan_weighing_grasps(FOUR, stability_costs(FOUR, 1), gripper_error="-1")


@pytest.mark.parametrize("weight", [-1, "-1/3", "x"])
def test_bad_weights(weight):
    with pytest.raises(CostError, match=r"accepted|or more"):
        stability_costs(RECTANGLE, weight)


@pytest.mark.parametrize("costs", [{}, {Angle(0, (1, 1)): 1}])
def test_no_grasp(costs):
    with pytest.raises(GoalError, match="accepted"):
        plan_weighing_grasps(RECTANGLE, costs)


def test_negative_costs():
    with pytest.raises(CostError):
        plan_weighing_grasps(RECTANGLE, {ZERO: -1})
