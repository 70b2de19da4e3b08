"""The best plan, by going through all products of actions with plain fractions."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.circular_variance import VarianceCost
from stochgeom.decision.entropy import EntropyCost
from stochgeom.decision.exhaustive_plans import count_plans
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_results import METHODS
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.random_search import random_plan
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.exact.angles import Angle
from tests.strategies import plan_cases, problem_tables

FEW = settings(max_examples=60)


def move(vector, matrix):
    """Multiply a row by a matrix, entry by entry."""
    columns = range(len(vector))
    return [sum((vector[i] * matrix[i][j] for i in columns), start=Fraction(0)) for j in columns]


def brute_force(tables, horizon, shortest, cost):
    """Return the least cost and all plans that have it with the fewest actions."""
    prior, matrices = tables
    best, plans = None, []
    for length in range(shortest, horizon + 1):
        for plan in product(range(len(matrices)), repeat=length):
            vector = prior
            for action in plan:
                vector = move(vector, matrices[action])
            value = cost(plan, vector)
            if best is None or value < best:
                best, plans = value, [plan]
            elif value == best and len(plans[0]) == length:
                plans.append(plan)
    return best, plans


def additive(prices, costs):
    def cost(plan, vector):
        if any(p and c == math.inf for p, c in zip(vector, costs, strict=True)):
            return math.inf
        ends = sum(p * c for p, c in zip(vector, costs, strict=True) if p)
        return sum(prices[a] for a in plan) + ends

    return cost


def minimax(prices, costs):
    return lambda plan, vector: (
        sum(prices[a] for a in plan) + max(c for p, c in zip(vector, costs, strict=True) if p)
    )


def iterative(prices, goal, test):
    def cost(plan, vector):
        p = max(vector) if goal is None else sum(vector[i] for i in goal)
        return math.inf if p == 0 else (sum(prices[a] for a in plan) + test) / p

    return cost


def search_of(case):
    """Return the tables, the library's cost and the oracle's cost of a drawn case."""
    tables, kind, prices, details = case
    named = {str(action): price for action, price in enumerate(prices)}
    if kind == "iterative":
        goal, test = details
        labels = None if goal is None else [str(i) for i in goal]
        return tables, IterativeCost(labels, named, test), iterative(prices, goal, test)
    states = {str(i): cost for i, cost in enumerate(details)}
    if kind == "minimax":
        return tables, MinimaxCost(named, states), minimax(prices, details)
    return tables, AdditiveCost(named, states), additive(prices, details)


@pytest.mark.parametrize("kind", ["additive", "minimax", "iterative"])
@FEW
@given(data=st.data())
def test_every_method_finds_the_best_plans(kind, data):
    tables, cost, plain = search_of(data.draw(plan_cases(kind)))
    shortest = data.draw(st.integers(0, 1))
    problem = PlanningProblem.from_matrices(*tables)
    best, plans = brute_force(tables, 3, shortest, plain)
    for method in METHODS:
        found = find_plan(problem, 3, cost, method=method, shortest=shortest, all_optimal=True)
        assert found.proven
        assert float(found.cost) == math.inf if best == math.inf else found.cost == best
        expected = sorted(tuple(map(str, plan)) for plan in plans)
        if found.feasible:
            assert sorted(found.optimal) == expected
        assert found.plan in expected
        assert found.hyperstate == problem.run(found.plan)
        alone = find_plan(problem, 3, cost, method=method, shortest=shortest)
        assert alone.plan in expected


@pytest.mark.parametrize("kind", ["additive", "minimax", "iterative"])
@FEW
@given(data=st.data())
def test_best_first_makes_no_more_nodes_than_the_whole_tree(kind, data):
    """2.4: the worst case of branch and bound is the exhaustive one; refuted by one node more.

    The root, which is no plan here, is a node as well.
    """
    tables, cost, _ = search_of(data.draw(plan_cases(kind)))
    problem, horizon = PlanningProblem.from_matrices(*tables), data.draw(st.integers(1, 4))
    keep = data.draw(st.booleans())
    found = find_plan(problem, horizon, cost, method="best-first", all_optimal=keep)
    assert found.nodes <= count_plans(len(problem.actions), horizon, shortest=0)
    every = find_plan(problem, horizon, cost, method="exhaustive", all_optimal=keep)
    assert every.nodes == count_plans(len(problem.actions), horizon)
    assert every.cost == found.cost or float(every.cost) == float(found.cost) == math.inf


@FEW
@given(plan_cases("additive"), st.fractions(-2, 6, max_denominator=8))
def test_a_plan_that_is_good_enough_ends_the_search(case, threshold):
    """7.1.2: refuted by a plan dearer than the threshold while a cheaper one exists."""
    tables, cost, _ = search_of(case)
    problem = PlanningProblem.from_matrices(*tables)
    best = find_plan(problem, 3, cost)
    enough = find_plan(problem, 3, cost, threshold=threshold)
    assert enough.nodes <= best.nodes
    if best.feasible and best.cost <= threshold:
        assert enough.cost <= threshold
    else:
        assert enough.proven
        assert enough.plan == best.plan
    if not enough.proven:
        assert enough.reason == "threshold"
        assert enough.lower_bound <= best.cost


@pytest.mark.parametrize("kind", ["additive", "minimax", "iterative"])
@FEW
@given(data=st.data())
def test_no_plan_undercuts_a_bound(kind, data):
    tables, cost, plain = search_of(data.draw(plan_cases(kind)))
    problem = PlanningProblem.from_matrices(*tables)
    model = cost.on(problem)
    beginning = data.draw(st.lists(st.sampled_from(problem.actions), max_size=2))
    hyperstate, spent = problem.run(beginning), model.spent_on(beginning)
    numbers = tuple(map(int, beginning))
    least = min(
        plain(numbers + more, [Fraction(p) for p in problem.run(map(str, more), hyperstate)])
        for k in range(3)
        for more in product(range(len(tables[1])), repeat=k)
    )
    for left in (2, None):
        assert not float(least) < float(model.bound(spent, hyperstate, left))
        bound = model.bound(spent, hyperstate, left)
        assert float(bound) == math.inf or not least < bound
    assert not float(least) < float(model.floor(spent))


@FEW
@given(plan_cases("additive"), st.integers(1, 60))
def test_a_search_cut_short_says_so_and_its_bound_holds(case, limit):
    tables, cost, plain = search_of(case)
    problem = PlanningProblem.from_matrices(*tables)
    best, _ = brute_force(tables, 3, 1, plain)
    for method in ("best-first", "breadth-first"):
        found = find_plan(problem, 3, cost, method=method, node_limit=limit)
        assert found.nodes <= limit + 1
        assert found.reason == ("proven" if found.proven else "node limit")
        assert not best < found.lower_bound
        if found.proven:
            assert float(found.cost) == float(best)
        elif found.plan:
            assert not found.cost < best
            assert model_cost(cost, problem, found.plan) == found.cost


def model_cost(cost, problem, plan):
    return cost.on(problem).of_plan(plan)


@FEW
@given(problem_tables(), st.booleans())
def test_spread_costs(tables, by_entropy):
    problem = PlanningProblem.from_matrices(*tables)
    n = len(tables[0])
    angles = {str(i): Angle(0, (i - 2, 1)) for i in range(n)}
    cost = EntropyCost() if by_entropy else VarianceCost(angles)

    def plain(plan, vector):
        if by_entropy:
            return -sum(float(p) * math.log2(p) for p in vector if p)
        x, y = (
            sum(float(p) * f(a.to_float()) for p, a in zip(vector, angles.values(), strict=True))
            for f in (math.cos, math.sin)
        )
        return 1 - x * x - y * y

    costs = []
    for method in METHODS:
        found = find_plan(problem, 2, cost, method=method, all_optimal=True)
        costs.append(found.cost)
        assert found.proven
        least = min(
            plain(plan, problem.run(map(str, plan)))
            for k in (1, 2)
            for plan in product(range(len(tables[1])), repeat=k)
        )
        assert abs(float(found.cost) - least) < 1e-12
        rounded = find_plan(problem.to_float(), 2, cost, method=method)
        assert abs(rounded.cost - least) < 1e-12
    assert costs[0] == costs[1] == costs[2]


@FEW
@given(plan_cases("iterative"))
def test_without_a_horizon_where_prices_are_positive(case):
    tables, cost, _ = search_of(case)
    prices = {label: price + Fraction(1, 4) for label, price in cost.actions.items()}
    problem = PlanningProblem.from_matrices(*tables)
    cost = IterativeCost(cost.goal, prices, cost.test)
    found = find_plan(problem, None, cost, node_limit=3000)
    assume(found.proven)
    limit = cost.on(problem).longest(found.cost)
    assert limit is None or len(found.plan) <= limit
    goal = None if cost.goal is None else [int(g) for g in cost.goal]
    best, _ = brute_force(tables, 4, 1, iterative(list(prices.values()), goal, cost.test))
    assert not best < found.cost
    by_levels = find_plan(problem, None, cost, method="breadth-first", node_limit=3000)
    assert not by_levels.proven or by_levels.cost == found.cost


@pytest.mark.parametrize("kind", ["additive", "minimax", "iterative"])
@FEW
@given(data=st.data())
def test_float_problems_agree_with_exact_ones(kind, data):
    tables, cost, plain = search_of(data.draw(plan_cases(kind)))
    exact = PlanningProblem.from_matrices(*tables)
    rounded = exact.to_float()
    floats = as_floats(cost)
    best, _ = brute_force(tables, 3, 1, plain)
    for method in METHODS:
        found = find_plan(rounded, 3, floats, method=method)
        assert found.cost == float(best) or abs(found.cost - float(best)) < 1e-9
        assert not found.problem.exact


def as_floats(cost):
    if isinstance(cost, IterativeCost):
        return IterativeCost(cost.goal, floats_of(cost.actions), float(cost.test))
    return type(cost)(floats_of(cost.actions), floats_of(cost.states))


def floats_of(table):
    return {label: float(value) for label, value in table.items()}


@FEW
@given(plan_cases("additive"), st.integers(0, 5))
def test_random_plans_are_plans(case, seed):
    tables, cost, plain = search_of(case)
    problem = PlanningProblem.from_matrices(*tables)
    best, _ = brute_force(tables, 3, 1, plain)
    found = random_plan(problem, 3, cost, seed=seed, tries=20)
    assert model_cost(cost, problem, found.plan) == found.cost
    assert not found.cost < best
    assert not best < found.lower_bound
    if found.proven:
        assert float(found.cost) == float(best)
    assert random_plan(problem, 3, cost, seed=seed, tries=20).plan == found.plan


def test_a_plan_of_twelve_states_is_found_by_all_roads():
    # A walk on a ring that slips; the goal is opposite to a certain start.
    ring = [str(k) for k in range(12)]

    def move_on(state, action):
        k = int(state)
        to = (k + {"back": -1, "on": 1, "far": 3}[action]) % 12
        return {ring[to]: mpq(9, 10), state: mpq(1, 10)}

    problem = PlanningProblem.from_function(ring, {"0": 1}, ["back", "on", "far"], move_on)
    cost = AdditiveCost("1/20", {s: 1 for s in ring if s != "6"})
    found = [find_plan(problem, 4, cost, method=method) for method in METHODS]
    assert {result.cost for result in found} == {mpq(1) + mpq(1, 10) - mpq(81, 100)}
    assert found[0].nodes < found[2].nodes == 120
