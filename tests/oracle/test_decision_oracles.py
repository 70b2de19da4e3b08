"""Other people's programs on the same problems: backward induction, answer sets, the planner."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.cli.decide_text import decimal
from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.perfect_information import observed_policy
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.planner import plan_transfer
from stochgeom.feeding.planning_problems import planning_problem_of, planning_problem_of_transfer
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import action_prices, parts, problem_tables

FEW = settings(max_examples=40)


# --- observed problems: quantecon's backward induction -------------------------------------------


@FEW
@given(problem_tables(), st.data())
def test_perfect_information_agrees_with_backward_induction(tables, data):
    pytest.importorskip("quantecon", reason="backward induction of another program")
    from quantecon.markov import DiscreteDP, backward_induction

    prior, matrices = tables
    n, m = len(prior), len(matrices)
    prices = data.draw(st.lists(action_prices, min_size=m, max_size=m))
    costs = data.draw(st.lists(st.sampled_from([0, 1, 2, 3.5]), min_size=n, max_size=n))
    # To stop is one action more, to a state where everything is free.
    rewards = np.zeros((n + 1, m + 1))
    chances = np.zeros((n + 1, m + 1, n + 1))
    chances[:, :, n] = 1
    for a, matrix in enumerate(matrices):
        rewards[:n, a] = -float(prices[a])
        chances[:n, a, :n], chances[:n, a, n] = np.array(matrix, dtype=float), 0
    rewards[:n, m] = [-cost for cost in costs]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of the discount factor 1
        values, _ = backward_induction(
            DiscreteDP(rewards, chances, 1.0), 4, np.array([*rewards[:, m]])
        )
    problem = PlanningProblem.from_matrices(prior, matrices)
    exact = AdditiveCost(
        {str(a): price for a, price in enumerate(prices)},
        {str(i): f"{cost}" for i, cost in enumerate(costs)},
    )
    seen = observed_policy(problem, 4, exact)
    found = [float(cost) for cost in seen.costs[4]]
    assert np.abs(np.array(found) + values[0][:n]).max() < 1e-12


@FEW
@given(problem_tables(), st.data())
def test_who_sees_the_state_does_no_worse(tables, data):
    problem = PlanningProblem.from_matrices(*tables)
    costs = data.draw(st.lists(st.integers(0, 3), min_size=len(problem.states), max_size=9))
    cost = AdditiveCost("1/4", dict(zip(problem.states, costs, strict=False)))
    blind = find_plan(problem, 3, cost, shortest=0)
    seen = observed_policy(problem, 3, cost)
    assert not blind.cost < seen.expected_cost
    if problem.deterministic and max(problem.prior) == 1:  # nothing is uncertain
        assert blind.cost == seen.expected_cost


# --- guaranteed plans: conformant planning by answer sets ----------------------------------------

CONFORMANT = """
{ act(A, T) : action(A) } = 1 :- T = 0..length-1.
reach(S, 0) :- start(S).
reach(S2, T+1) :- reach(S1, T), act(A, T), moves(S1, A, S2).
:- reach(S, length), not goal(S).
#show act/2.
"""


def guaranteed_plans(problem, goals, length):
    """Return all plans of a length that are certain to end in the goal, by answer sets."""
    clingo = pytest.importorskip("clingo", reason="conformant planning by another program")
    states, actions = range(len(problem.states)), range(len(problem.actions))
    facts = [f"action({a})." for a in actions]
    facts += [f"start({s})." for s in states if problem.prior[s]]
    facts += [f"goal({s})." for s in goals]
    for a in actions:
        matrix = problem.matrix(problem.actions[a])
        facts += [f"moves({s},{a},{t})." for s in states for t in states if matrix[s][t]]
    control = clingo.Control(["0", "-c", f"length={length}", "--warn=none"])
    control.add("base", [], "\n".join(facts) + CONFORMANT)
    control.ground([("base", [])])
    found = []

    def keep(model):
        steps = sorted(
            (atom.arguments[1].number, atom.arguments[0].number)
            for atom in model.symbols(shown=True)
        )
        found.append(tuple(problem.actions[a] for _, a in steps))

    control.solve(on_model=keep)
    return sorted(found)


@FEW
@given(problem_tables(states=5), st.data())
def test_guaranteed_plans_agree_with_conformant_planning(tables, data):
    problem = PlanningProblem.from_matrices(*tables)
    goals = data.draw(st.sets(st.sampled_from(problem.states), min_size=1))
    numbers = [problem.state_number(goal) for goal in goals]
    found = find_plan(problem, 4, GuaranteedCost(goals), all_optimal=True)
    for length in range(1, 5):
        plans = guaranteed_plans(problem, numbers, length)
        if plans:
            assert found.cost == length
            assert sorted(found.optimal) == plans
            return
    assert not found.feasible


# --- parts: backchaining -------------------------------------------------------------------------


def searched(found, cost_ratio, **settings_of_search):
    """Return the best plan by search: the random first action is part of the prior."""
    cost = IterativeCost(None, 1, 1 + cost_ratio)
    return find_plan(found.problem, None, cost, shortest=0, **settings_of_search)


def success(found):
    """Return the exact probability that a round of a plan succeeds."""
    return AngleSum.of(found.model.success(found.hyperstate))


@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
@pytest.mark.parametrize("name", catalogue_names())
def test_backchaining_and_search_agree_on_the_catalogue(name, action):
    part = catalogue_part(name)
    plan = FeedingProblem(part, action).optimal_plan(1)
    for method in ("best-first", "breadth-first"):
        found = searched(planning_problem_of(part, action), 1, method=method, node_limit=30_000)
        assert found.proven
        assert len(found.plan) + 1 == plan.steps
        assert decimal(found.cost, 9) == plan.expected_cost.decimal(9)
        assert success(found) == AngleSum.of(plan.probability)


@FEW
@given(parts(), st.sampled_from([0, 1, 3]))
def test_backchaining_and_search_agree(part, cost_ratio):
    transfer = squeeze_function(part)
    assume(len(transfer) * transfer.order <= 6)
    plan = plan_transfer(transfer, cost_ratio=cost_ratio)
    found = searched(planning_problem_of_transfer(transfer), cost_ratio, node_limit=2_000)
    assume(found.proven)
    assert len(found.plan) + 1 == plan.steps
    assert success(found) == AngleSum.of(plan.probability)


def test_a_guaranteed_plan_orients_up_to_symmetry():
    found = planning_problem_of(catalogue_part("house"))
    states = found.problem.states
    pair = next(
        {a, b} for a in states for b in states if a < b and abs(float(a) - float(b)) == 180.0
    )
    plan = find_plan(found.problem, 6, GuaranteedCost(pair))
    assert plan.feasible
    assert find_plan(found.problem, 6, GuaranteedCost(states[0])).feasible is False
    assert find_plan(found.problem, 3, GoalCost(pair)).cost == 0
