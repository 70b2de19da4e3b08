"""The tree of all plans with sensors against the plans themselves, listed one by one on fractions.

A plan is listed as its pair (expected cost of the moves, gain); how many there are, the least cost
and how many attain it are then read off the list. The oracle knows of no tree, price or value.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from hypothesis import given, settings
from hypothesis import strategies as st

import stochgeom as sg
from tests.strategies import action_prices, likelihoods, look_prices, problem_tables

FEW = settings(max_examples=min(300, settings.default.max_examples))


def all_plans(weights, matrices, prices, likelihood, look, gains, moves):
    """Return the pairs of all plans of up to so many moves, as often as there are such plans."""
    plans = [
        (Fraction(0), max(sum(w * g for w, g in zip(weights, row, strict=True)) for row in gains))
    ]
    if moves == 0:
        return plans
    rest = (matrices, prices, likelihood, look, gains, moves - 1)
    for matrix, price in zip(matrices, prices, strict=True):
        after = [
            sum(w * row[k] for w, row in zip(weights, matrix, strict=True))
            for k in range(len(weights))
        ]
        plans += [(cost + sum(weights) * price, gain) for cost, gain in all_plans(after, *rest)]
    joints = [
        [w * row[x] for w, row in zip(weights, likelihood, strict=True)]
        for x in range(len(likelihood[0]))
    ]
    below = [all_plans(joint, *rest) for joint in joints if any(joint)]
    for chosen in product(*below):
        costs, values = zip(*chosen, strict=True)
        plans.append((sum(costs) + sum(weights) * look, sum(values)))
    return plans


def check(tree, plans, costs):
    assert tree.plans == len(plans)
    assert tree.expected_cost == min(costs)
    assert tree.best_plans == costs.count(min(costs))


@st.composite
def games(draw):
    """Draw a prior, matrices with prices, a likelihood, the price of a look."""
    prior, matrices = draw(problem_tables(states=3, actions=2))
    prices = [Fraction(draw(action_prices)) for _ in matrices]
    likelihood = draw(likelihoods(len(prior), readings=2))
    return prior, matrices, prices, likelihood, Fraction(draw(look_prices))


def made(game, cost):
    prior, matrices, prices, likelihood, look = game
    problem = sg.PlanningProblem.from_matrices(prior, matrices)
    named = dict(zip(problem.actions, prices, strict=True))
    sensor = sg.Sensor(range(len(likelihood[0])), likelihood, states=problem.states, cost=look)
    return problem.with_cost(cost(named)), sensor


@FEW
@given(games(), st.integers(0, 2))
def test_plans_that_are_repeated(game, moves):
    problem, sensor = made(game, lambda prices: sg.IterativeCost(actions=prices))
    gains = [[int(j == k) for j in range(len(game[0]))] for k in range(len(game[0]))]
    plans = all_plans(*game, gains, moves)
    costs = [(1 + cost) / gain for cost, gain in plans]
    tree = sg.all_sensor_plans(problem, sensor, moves)
    check(tree, plans, costs)
    # At the price of the best plan a round is worth exactly its own cost.
    assert tree.root.least == -1


@FEW
@given(games(), st.integers(0, 2), st.data())
def test_plans_that_are_carried_out_once(game, moves, data):
    losses = [Fraction(data.draw(st.sampled_from([0, 0, 1, 2, "5/2"]))) for _ in game[0]]
    problem, sensor = made(
        game,
        lambda prices: sg.AdditiveCost(
            actions=prices, states={str(k): loss for k, loss in enumerate(losses) if loss}
        ),
    )
    plans = all_plans(*game, [[-loss for loss in losses]], moves)
    tree = sg.all_sensor_plans(problem, sensor, moves)
    check(tree, plans, [cost - gain for cost, gain in plans])
    assert tree.root.least == tree.expected_cost
