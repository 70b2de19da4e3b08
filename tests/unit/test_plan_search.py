"""Searches for plans: what is kept, what is dropped, and which of equal plans is returned."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.entropy import EntropyCost
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_results import METHODS
from stochgeom.decision.plan_search import best_action, find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.worst_case_costs import MinimaxCost

each_method = pytest.mark.parametrize("method", METHODS)


def detour():
    """Two ways to one hyperstate: three cheap actions, or two dear ones that leave time for more.

    A part lies with either side up; two more actions from place x turn it the right side up.
    """
    moves = {
        "cheap": {"start": "a", "a": "b", "b": "x"},
        "dear": {"start": "c", "c": "x"},
        "turn": {"x": "y", "y": "end"},
    }
    places = ["start", "a", "b", "c", "x", "y", "end"]
    states = [(place, side) for place in places for side in (0, 1)]

    def move(state, action):
        place, side = state
        to = moves[action].get(place, place)
        return (to, 0 if to == "end" else side)

    prior = {("start", 0): "1/2", ("start", 1): "1/2"}
    prices = {"cheap": "1/100", "dear": "1/10", "turn": "1/100"}
    return PlanningProblem.from_function(states, prior, list(moves), move, EntropyCost(prices))


@each_method
def test_a_shorter_way_is_kept_beside_a_cheaper_one(method):
    found = find_plan(detour(), 4, method=method)
    assert found.plan == ("dear", "dear", "turn", "turn")
    assert found.cost == mpq(22, 100)
    longer = find_plan(detour(), 5, method=method)
    assert longer.plan == ("cheap", "cheap", "cheap", "turn", "turn")
    assert longer.cost == mpq(5, 100)


def test_the_cheaper_way_is_found_without_a_horizon():
    found = find_plan(detour())
    assert (found.proven, found.cost) == (True, mpq(5, 100))


@each_method
def test_all_optimal_plans_by_different_ways(method):
    """Two switches: in either order, and the two hyperstates between are different."""
    states = [(x, y) for x in (0, 1) for y in (0, 1)]
    switches = PlanningProblem.from_function(
        states,
        {(0, 0): 1},
        ["x", "y", "wait"],
        lambda s, a: (int(a == "x") or s[0], int(a == "y") or s[1]),
        GuaranteedCost([(1, 1)]),
    )
    found = find_plan(switches, 3, method=method, all_optimal=True)
    assert sorted(found.optimal) == [("x", "y"), ("y", "x")]
    assert find_plan(switches, 3, method=method).plan in found.optimal
    assert find_plan(switches, 1, method=method).feasible is False


@each_method
@pytest.mark.parametrize("exact", [True, False])
def test_of_equal_costs_the_fewest_actions(method, exact):
    stay = PlanningProblem.from_matrices([1, 0], {"stay": [[1, 0], [0, 1]]})
    problem = stay if exact else stay.to_float()
    found = find_plan(problem, 3, GoalCost("1"), method=method, all_optimal=True)
    assert found.optimal == (("stay",),)
    nothing = find_plan(problem, 3, GoalCost("1"), method=method, shortest=0, all_optimal=True)
    assert nothing.optimal == ((),)
    assert nothing.cost == found.cost == 1


@each_method
def test_doing_nothing_counts_only_if_asked_for(method):
    away = PlanningProblem.from_matrices([1, 0], {"go": [[0, 1], [0, 1]]}, cost=GoalCost("0"))
    assert find_plan(away, 2, method=method).cost == 1
    assert find_plan(away, 2, method=method, shortest=0).plan == ()
    assert find_plan(away, 2, method=method, shortest=0).cost == 0


def test_the_best_action_and_all_as_good():
    problem = PlanningProblem.from_matrices(
        ["1/2", "1/2"], {"l": [[1, 0]] * 2, "r": [[0, 1]] * 2, "-": [[1, 0], [0, 1]]}
    )
    found = best_action(problem, IterativeCost())
    assert found.optimal == (("l",), ("r",))
    assert found.cost == 2
    assert best_action(problem, GoalCost("0", {"l": "1/4"})).optimal == (("l",),)


def test_pruning_saves_nodes():
    line = [str(k) for k in range(30)]
    walk = PlanningProblem.from_function(
        line,
        {"10": 1},
        ["down", "up", "jump"],
        lambda s, a: line[max(0, min(29, int(s) + {"down": -1, "up": 1, "jump": 5}[a]))],
        AdditiveCost(1, {s: abs(int(s) - 23) * 10 for s in line}),
    )
    found = find_plan(walk, 12)
    assert (found.cost, len(found.plan)) == (5, 5)  # 10 + 5 + 5 + 5 - 2, or + 1 + 1 + 1
    by_levels = find_plan(walk, 12, method="breadth-first")
    assert by_levels.cost == found.cost
    assert found.nodes < by_levels.nodes < 3**6


@pytest.mark.parametrize("price", [0, "1/100"])
def test_a_horizon_far_away(price):
    """Bounds do not look further than they can compute; they hold nevertheless."""
    leaky = PlanningProblem.from_matrices(
        ["1/3", "1/3", "1/3"],
        {
            "a": [["1/2", "1/3", "1/6"], ["1/5", "1/5", "3/5"], ["1/7", 0, "6/7"]],
            "b": [["1/3", "1/3", "1/3"], [0, "1/9", "8/9"], ["1/11", "10/11", 0]],
        },
    )
    for cost in (
        GoalCost("0", price),
        IterativeCost("0", price, 1),
        IterativeCost(None, price, 1),
        MinimaxCost(price, {"1": 1}),
    ):
        found = find_plan(leaky, 10**6, cost, node_limit=300)
        short = find_plan(leaky, 3, cost)
        assert not short.cost < found.lower_bound
        if found.proven:
            assert not short.cost < found.cost


def test_a_result_describes_itself():
    found = find_plan(detour(), 4, node_limit=5)
    assert not found.proven
    assert found.reason == "node limit"
    assert found.lower_bound <= mpq(5, 100) * 10
    assert len(found) == len(found.plan)
    assert found.hyperstate == detour().run(found.plan)
    satisfied = find_plan(detour(), 5, threshold="1/4")
    assert satisfied.cost <= mpq(1, 4)
    assert satisfied.reason in ("threshold", "proven")
