"""Optimal plans with sensors by slower roads, on plain fractions.

*All trees.* Every tree of so many moves is made, with every decision at every end, and worth its
pair (expected cost of a round, probability of success): no pruning, no prices, no merging.

*The endless game.* Rounds that are repeated are a Markov decision process on beliefs: to stop wins
with some probability and begins anew otherwise. Its least expected total cost is what Dinkelbach's
iteration should find, though nothing in it is a quotient. Storm computes it exactly; where it is
not installed, that test is skipped.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.angles import Angle
from stochgeom.exact.quotients import quotient
from stochgeom.exact.sums import AngleSum
from stochgeom.sensing.decisions import lose_by_table
from stochgeom.sensing.planners import iterative_sensor_plan, sensor_plan
from stochgeom.sensing.sensors import Sensor
from tests.strategies import action_prices, directions, likelihoods, look_prices, problem_tables

FEW = settings(max_examples=min(400, settings.default.max_examples))
FEWER = settings(max_examples=min(150, settings.default.max_examples))


@st.composite
def games(draw, *, states=3, actions=2, readings=2):
    """A prior, matrices with prices, a likelihood with a price, the cost of a round."""
    prior, tables = draw(problem_tables(states=states, actions=actions))
    prices = [Fraction(draw(action_prices)) for _ in tables]
    table = draw(likelihoods(len(prior), readings=readings))
    look = Fraction(draw(look_prices))
    return prior, tables, prices, table, look, Fraction(draw(st.sampled_from([1, 1, 2, "1/3"])))


def moved(weights, matrix):
    return tuple(
        sum((w * row[k] for w, row in zip(weights, matrix, strict=True)), start=0 * weights[0])
        for k in range(len(weights))
    )


def seen(weights, table, reading):
    return tuple(w * row[reading] for w, row in zip(weights, table, strict=True))


def all_trees(game, weights, moves, gains):
    """Return the pairs (cost, gain) of all trees below a joint hyperstate."""
    _, tables, prices, table, look, _ = game
    pairs = {(Fraction(0), sum(w * g for w, g in zip(weights, row, strict=True))) for row in gains}
    if moves == 0:
        return pairs
    mass = sum(weights)
    for matrix, price in zip(tables, prices, strict=True):
        below = all_trees(game, moved(weights, matrix), moves - 1, gains)
        pairs |= {(cost + mass * price, gain) for cost, gain in below}
    branches = [
        all_trees(game, seen(weights, table, x), moves - 1, gains) for x in range(len(table[0]))
    ]
    for chosen in product(*branches):
        cost, gain = (sum(pair[k] for pair in chosen) for k in (0, 1))
        pairs.add((cost + mass * look, gain))
    return pairs


def unit_gains(count):
    return [tuple(int(j == k) for j in range(count)) for k in range(count)]


def planned(game, moves, **settings):
    prior, tables, prices, table, look, round_cost = game
    problem = PlanningProblem.from_matrices(prior, tables)
    sensor = Sensor(range(len(table[0])), table, states=problem.states, cost=look)
    costs = dict(zip(problem.actions, prices, strict=True))
    return iterative_sensor_plan(
        problem, sensor, moves, action_costs=costs, round_cost=round_cost, **settings
    )


@FEW
@given(games(), st.integers(0, 2))
def test_no_tree_costs_less(game, moves):
    pairs = all_trees(game, tuple(game[0]), moves, unit_gains(len(game[0])))
    least = min((game[-1] + cost) / gain for cost, gain in pairs if gain)
    plan = planned(game, moves)
    assert plan.expected_cost == least
    assert plan.proven
    assert plan.tree.depth <= moves


@FEWER
@given(games(states=2, actions=1), st.just(3))
def test_no_deeper_tree_costs_less(game, moves):
    pairs = all_trees(game, tuple(game[0]), moves, unit_gains(len(game[0])))
    assert planned(game, moves).expected_cost == min(
        (game[-1] + cost) / gain for cost, gain in pairs if gain
    )


@FEW
@given(games(), st.integers(0, 2), st.data())
def test_no_tree_loses_less(game, moves, data):
    """Additive costs: a table of losses instead of acceptances."""
    prior, tables, prices, table, look, _ = game
    loss = st.sampled_from([0, 0, 1, 2, Fraction(5, 2)])
    losses = data.draw(
        st.lists(st.lists(loss, min_size=len(prior), max_size=len(prior)), min_size=1, max_size=3)
    )
    gains = [tuple(-Fraction(value) for value in row) for row in losses]
    least = min(cost - gain for cost, gain in all_trees(game, tuple(prior), moves, gains))
    problem = PlanningProblem.from_matrices(prior, tables)
    plan = sensor_plan(
        problem,
        Sensor(range(len(table[0])), table, states=problem.states, cost=look),
        moves,
        action_costs=dict(zip(problem.actions, prices, strict=True)),
        decisions=lose_by_table(problem, dict(enumerate(losses))),
    )
    assert plan.expected_cost == least == plan.lower_bound


@FEWER
@given(games(), st.integers(0, 2), directions)
def test_irrational_priors(game, moves, direction):
    """One state splits in two by an angle; all quotients are compared exactly."""
    share = AngleSum(0, [(1, Angle(0, direction))])
    prior, *rest = game
    if len(prior) < 2 or share == 0:
        return
    whole = mpq(prior[0] + prior[1])
    exact = (share * whole, (1 - share) * whole, *map(mpq, prior[2:]))
    game = (exact, *rest)
    pairs = all_trees(game, tuple(map(AngleSum.of, exact)), moves, unit_gains(len(prior)))
    round_cost = mpq(rest[-1])
    costs = [quotient(round_cost + cost, gain) for cost, gain in pairs if gain > 0]
    plan = planned(game, moves)
    assert plan.expected_cost == min(costs)
    assert plan.proven


# --- the endless game ----------------------------------------------------------------------------


def beliefs(game, moves):
    """Return the choices at each belief with so many moves left: (reward, {next: chance})."""
    prior, tables, prices, table, look, round_cost = game
    root = (tuple(prior), moves)
    choices, pending = {"won": [(Fraction(0), {"won": Fraction(1)})]}, [root]
    while pending:
        here = pending.pop()
        if here in choices:
            continue
        belief, left = here
        best = max(belief)
        found = [(round_cost, {"won": best, root: 1 - best})]
        if left:
            for matrix, price in zip(tables, prices, strict=True):
                found.append((price, {(moved(belief, matrix), left - 1): Fraction(1)}))
            chances = {}
            for x in range(len(table[0])):
                joint = seen(belief, table, x)
                mass = sum(joint)
                if mass:
                    following = (tuple(w / mass for w in joint), left - 1)
                    chances[following] = chances.get(following, 0) + mass
            found.append((look, chances))
        choices[here] = found
        pending += [state for _, chances in found for state in chances]
    return root, choices


def drn(root, choices):
    """Return a Markov decision process in Storm's own text form."""
    order = [root, *(state for state in choices if state != root)]
    number = {state: k for k, state in enumerate(order)}
    lines = ["@type: MDP", "@value_type: rational", "@parameters", "", "@reward_models", "cost"]
    lines += ["@nr_states", str(len(order)), "@nr_choices"]
    lines += [str(sum(map(len, choices.values()))), "@model"]
    for state in order:
        label = "init" if state == root else "won" if state == "won" else ""
        lines.append(f"state {number[state]} [0] {label}".rstrip())
        for k, (reward, chances) in enumerate(choices[state]):
            lines.append(f"\taction {k} [{reward}]")
            entries = sorted((number[after], p) for after, p in chances.items() if p)
            lines += [f"\t\t{after} : {p}" for after, p in entries]
    return "\n".join(lines) + "\n"


@FEWER
@given(game=games(), moves=st.integers(0, 2))
def test_the_endless_game_costs_as_much(tmp_path_factory, game, moves):
    stormpy = pytest.importorskip("stormpy")
    path = tmp_path_factory.mktemp("storm") / "game.drn"
    path.write_text(drn(*beliefs(game, moves)))
    model = stormpy.build_model_from_drn[stormpy.Rational](str(path))
    (formula,) = stormpy.parse_properties('R{"cost"}min=? [F "won"]')
    found = stormpy.model_checking(model, formula).get_value(model.initial_states[0])
    assert planned(game, moves).expected_cost == mpq(str(found))
