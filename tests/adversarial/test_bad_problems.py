"""Planning problems that are none, and costs and searches that do not fit one."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost, distance_cost
from stochgeom.decision.circular_variance import VarianceCost
from stochgeom.decision.exhaustive_plans import every_plan
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.perfect_information import observed_policy
from stochgeom.decision.plan_results import Limits
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.random_search import random_plan
from stochgeom.decision.two_argmins import two_argmins
from stochgeom.decision.uniform_difference import cyclic_difference, simulated_difference
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.errors import (
    CostError,
    DuplicateLabelError,
    EmptyProblemError,
    InputError,
    MixedNumbersError,
    NodeLimitError,
    NotStochasticError,
    NumberError,
    ProblemError,
    ShapeMismatchError,
    UnknownLabelError,
)
from stochgeom.exact.angles import Angle
from stochgeom.exact.sums import AngleSum

STAY = [[1, 0], [0, 1]]
HALF = ["1/2", "1/2"]


def problem(states=("a", "b"), prior=HALF, actions=("x",), transitions=(STAY,), **more):
    return PlanningProblem(states, prior, actions, transitions, **more)


GOOD = problem()


@pytest.mark.parametrize(
    ("changes", "kind", "message"),
    [
        ({"prior": ["1/2", "1/3"]}, NotStochasticError, "prior: the sum is 5/6; accepted"),
        ({"prior": [2, -1]}, NotStochasticError, "prior, entry 1: probability -1 is negative"),
        ({"prior": [0.5, 0.6]}, NotStochasticError, "prior: the sum is 1.1"),
        ({"prior": [0.5, 0.4999999]}, NotStochasticError, "prior: the sum is 0.99999989"),
        ({"prior": [1]}, ShapeMismatchError, "prior: 1 probabilities; accepted: 2"),
        ({"prior": "ab"}, ShapeMismatchError, "prior: 'ab'; accepted: a list"),
        ({"prior": 7}, ShapeMismatchError, "prior: 7; accepted: a list"),
        ({"prior": {"c": 1}}, UnknownLabelError, "prior: 'c' is no state; accepted: 'a', 'b'"),
        ({"prior": [float("nan"), 1.0]}, NumberError, "prior, entry 0: nan is not a finite float"),
        ({"prior": [math.inf, 1.0]}, NumberError, "prior, entry 0: inf is not a finite float"),
        ({"prior": ["one", 0]}, NumberError, "prior, entry 0: 'one' is not a number"),
        ({"prior": [None, 1]}, NumberError, "prior, entry 0: None"),
        ({"prior": [True, False]}, NumberError, "prior, entry 0: True is a truth value"),
        (
            {"prior": [0.5, Fraction(1, 2)]},
            MixedNumbersError,
            r"prior, entry 1: Fraction\(1, 2\) is exact, and a float stands at prior, entry 0",
        ),
        (
            {"transitions": [[[0.5, 0.5], [0, 1]]]},
            MixedNumbersError,
            "action 'x', row 'a', entry 0: 0.5 is a float, and an exact number stands at prior, e",
        ),
        (
            {"transitions": [[["1/2", "1/2"], ["1/2", "1/3"]]]},
            NotStochasticError,
            "action 'x', row 'b': the sum is 5/6",
        ),
        (
            {"transitions": [[["3/2", "-1/2"], [0, 1]]]},
            NotStochasticError,
            "action 'x', row 'a', entry 1: probability -1/2 is negative",
        ),
        ({"transitions": [[[1, 0]]]}, ShapeMismatchError, "action 'x': 1 rows; accepted: 2"),
        (
            {"transitions": [[[1, 0, 0], [0, 1, 0]]]},
            ShapeMismatchError,
            "action 'x', row 'a': 3 probabilities; accepted: 2",
        ),
        ({"transitions": []}, ShapeMismatchError, "transitions: 0 matrices; accepted: 1"),
        ({"transitions": {}}, ShapeMismatchError, "action 'x': no matrix; accepted: one for each"),
        ({"transitions": {"y": STAY}}, UnknownLabelError, "transitions: 'y' is no action"),
        ({"transitions": [np.ones((2, 3)) / 3]}, ShapeMismatchError, "row 'a': 3 probabilities"),
        ({"states": ("a", "a")}, DuplicateLabelError, "state 1: the label 'a' stands at 0"),
        ({"actions": ("x", "x")}, DuplicateLabelError, "action 1: the label 'x' stands at 0"),
        ({"states": ()}, EmptyProblemError, "states: no state; accepted: at least one"),
        ({"actions": (), "transitions": ()}, EmptyProblemError, "actions: no action"),
        ({"states": "ab"}, ProblemError, "states: 'ab'; accepted: a list of labels"),
        ({"states": ([1], [2])}, ProblemError, r"state 0: \[1\] cannot be a label"),
        (
            {"prior": [AngleSum(0, [(1, Angle(0, (3, 2)))]), AngleSum("1/2")]},
            NotStochasticError,
            "prior: the sum is 0.5936",
        ),
        (
            {"transitions": [[[AngleSum(0, [(1, Angle(0, (3, 2)))]), 1], [0, 1]]]},
            NumberError,
            "action 'x', row 'a', entry 0",
        ),
    ],
)
def test_what_is_no_problem(changes, kind, message):
    with pytest.raises(kind, match=message):
        problem(**changes)


def test_a_long_list_of_labels_is_cut_short():
    many = [f"state {k}" for k in range(20)]
    ring = PlanningProblem.from_function(many, {many[0]: 1}, ["x"], lambda state, _: state)
    with pytest.raises(UnknownLabelError, match="'state 7' and 12 more"):
        ring.state_number("state 99")
    with pytest.raises(UnknownLabelError, match=r"\[\] is no state"):
        ring.state_number([])


def test_the_message_of_an_unknown_label_is_a_sentence():
    with pytest.raises(KeyError) as caught:
        GOOD.matrix("y")
    assert isinstance(caught.value, UnknownLabelError)
    assert str(caught.value) == "'y' is no action; accepted: 'x'"  # a KeyError's text is quoted


def test_a_function_that_leads_nowhere():
    with pytest.raises(UnknownLabelError, match="action 'x', row 'a': 'c' is no state"):
        PlanningProblem.from_function(["a", "b"], HALF, ["x"], lambda *_: "c")
    with pytest.raises(NotStochasticError, match="action 'x', row 'a': the sum is 1/2"):
        PlanningProblem.from_function(["a", "b"], HALF, ["x"], lambda *_: {"a": "1/2"})


@pytest.mark.parametrize(
    ("cost", "kind", "message"),
    [
        (AdditiveCost(-1), CostError, "cost of action 'x': the cost is -1; accepted: a rational"),
        (AdditiveCost({"x": math.inf}), CostError, "cost of action 'x': the cost is infinite"),
        (AdditiveCost({"y": 1}), UnknownLabelError, "costs of the actions: 'y' is no action"),
        (AdditiveCost(0, {"c": 1}), UnknownLabelError, "costs of the states: 'c' is no state"),
        (AdditiveCost(0.5), CostError, "cost of every action: 0.5 is a binary float"),
        (AdditiveCost(0, {"a": -math.inf}), CostError, "cost of state 'a': -inf is a binary"),
        (AdditiveCost(0, {"a": float("nan")}), CostError, "cost of state 'a': nan"),
        (AdditiveCost("much"), CostError, "cost of every action: 'much' is not a number"),
        (MinimaxCost(0, {"c": 1}), UnknownLabelError, "costs of the states: 'c' is no state"),
        (GoalCost("c"), UnknownLabelError, "goal: 'c' is no state"),
        (GoalCost([]), CostError, "goal: no goal state; accepted: at least one"),
        (GuaranteedCost({"a", "c"}), UnknownLabelError, "goal: 'c' is no state"),
        (IterativeCost("c"), UnknownLabelError, "goal: 'c' is no state"),
        (IterativeCost("a", 1, -1), CostError, "the cost is -1"),
        (VarianceCost({"a": Angle()}), CostError, "orientation of state 'b': None is no orient"),
        (VarianceCost({"c": Angle()}), UnknownLabelError, "orientations: 'c' is no state"),
        (None, ProblemError, "the cost is None; accepted: a PlanCost"),
        ("cheap", ProblemError, "the cost is 'cheap'; accepted: a PlanCost"),
    ],
)
def test_costs_that_do_not_fit(cost, kind, message):
    with pytest.raises(kind, match=message):
        find_plan(GOOD, 2, cost)


def test_costs_of_another_kind_than_the_numbers():
    floats = GOOD.to_float()
    with pytest.raises(CostError, match="the numbers of the problem are float"):
        find_plan(floats, 1, AdditiveCost("1/2"))
    assert find_plan(floats, 1, AdditiveCost(0.5)).cost == 0.5
    with pytest.raises(CostError, match="orientation of state 'a': 0 is no orientation"):
        distance_cost({"a": 0}, Angle())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"horizon": 0}, "horizon: 0 actions; accepted: whole numbers from 1 on"),
        ({"horizon": -1, "shortest": 0}, "horizon: -1 actions; accepted: whole numbers from 0 on"),
        ({"horizon": 2, "shortest": 2}, "shortest = 2; accepted: 0 or 1"),
        ({"horizon": 2, "method": "depth-first"}, "method 'depth-first'; accepted: best-first, "),
        ({"horizon": 2, "node_limit": 0}, "node limit: 0 nodes; accepted: whole numbers from 1 on"),
        ({"horizon": "2"}, "horizon: '2' actions; accepted"),
        ({"horizon": 2, "node_limit": "5"}, "node limit: '5' nodes; accepted"),
        ({"horizon": 2, "time_limit": "5"}, "time limit: '5' is of type str, not Real"),
        ({"horizon": 2, "time_limit": -1.0}, "-1.0 seconds; accepted"),
        ({"horizon": 2, "method": "exhaustive", "threshold": 1}, "a threshold with method"),
        ({"method": "exhaustive"}, "no horizon; accepted: one, for an exhaustive search"),
    ],
)
def test_searches_that_make_no_sense(arguments, message):
    with pytest.raises(InputError, match=message):
        find_plan(GOOD, cost=GoalCost("a"), **arguments)


def test_nothing_bounds_the_length():
    lazy = problem(transitions=[[HALF, HALF]])
    with pytest.raises(InputError, match="an action is free: nothing bounds the length"):
        find_plan(lazy, cost=GoalCost("a"))
    # Deterministic actions reach finitely many hyperstates; prices bound the length.
    assert find_plan(GOOD, cost=GoalCost("a")).proven
    assert find_plan(lazy, cost=GoalCost("a", 1)).proven


def test_a_horizon_beyond_the_node_limit_tells_how_many_nodes():
    two = problem(actions=("x", "y"), transitions=(STAY, STAY))
    with pytest.raises(
        NodeLimitError,
        match="horizon: 2 actions make 2097150 plans of at most 20, the limit is 1000000",
    ):
        find_plan(two, 20, GoalCost("a"), method="exhaustive")
    with pytest.raises(
        NodeLimitError, match=r"more than 2147483646 plans of at most 1000000000, .* at most 18"
    ):
        find_plan(two, 10**9, GoalCost("a"), method="exhaustive")  # at once
    with pytest.raises(NodeLimitError, match="accepted: a horizon of at most 3, or a higher limit"):
        find_plan(two.to_float(), 4, GoalCost("a"), method="exhaustive", node_limit=20)
    # Searches that merge or prune cannot know; they go on as far as they can.
    assert find_plan(two, 20, GoalCost("a")).proven
    assert find_plan(two.to_float(), 20, GoalCost("a")).proven


def test_time_limits(monkeypatch):
    now = iter(range(10**6))
    monkeypatch.setattr("stochgeom.decision.plan_results.time.monotonic", lambda: next(now))
    spread = PlanningProblem.from_matrices(
        ["1/3", "1/3", "1/3"],
        [
            [["1/2", "1/3", "1/6"], ["1/5", "1/5", "3/5"], ["1/7", 0, "6/7"]],
            [["1/3", "1/3", "1/3"], [0, "1/9", "8/9"], ["1/11", "10/11", 0]],
        ],
    )
    for method in ("best-first", "breadth-first"):
        found = find_plan(spread, 12, IterativeCost("0", 0, 1), method=method, time_limit=3.0)
        assert found.reason == "time limit"
        assert not found.proven
        assert found.lower_bound < found.cost
    shares = []
    find_plan(spread, 8, IterativeCost("0", 0, 1), progress=shares.append)
    assert shares == sorted(shares)


def test_limits_that_are_none():
    with pytest.raises(InputError, match=r"^node limit: 0 nodes; accepted"):
        Limits(0)
    with pytest.raises(InputError, match=r"^time limit: 0 seconds; accepted: more than 0"):
        Limits(1, 0)


def test_other_questions():
    with pytest.raises(InputError, match="horizon: -1 actions; accepted: whole numbers from 0 on"):
        next(every_plan(GOOD, -1, shortest=0))
    with pytest.raises(ProblemError, match="IterativeModel is not additive; accepted: Additive"):
        observed_policy(GOOD, 1, IterativeCost("a"))
    with pytest.raises(InputError, match="horizon -1; accepted: 0 or more"):
        observed_policy(GOOD, -1, GoalCost("a"))
    with pytest.raises(InputError, match="3 actions left; accepted: 0 to 1"):
        observed_policy(GOOD, 1, GoalCost("a")).action("a", 3)
    with pytest.raises(InputError, match="0 tries; accepted: whole numbers from 1 on"):
        random_plan(GOOD, 1, GoalCost("a"), seed=0, tries=0)
    with pytest.raises(NumberError, match="loss of action 'x' in state 'a'"):
        two_argmins(GOOD, lambda *_: 0.5)
    with pytest.raises(ShapeMismatchError, match="1 and 2 probabilities"):
        cyclic_difference([1], ["1/2", "1/2"])
    with pytest.raises(NotStochasticError, match="x: the sum is 2"):
        cyclic_difference([1, 1], [1, 0])
    with pytest.raises(InputError, match="0 draws; accepted: whole numbers from 1 on"):
        simulated_difference(lambda source, n: source.uniform(size=n), 0, seed=1)


def test_numbers_stay_what_they_are():
    """No float comes out of an exact problem, no mpq and no mpfr out of a float one."""
    exact = find_plan(GOOD, 2, AdditiveCost("1/2", {"a": 1}))
    assert type(exact.cost) is type(mpq())
    floats = GOOD.to_float()
    for cost in (
        AdditiveCost(0.5, {"a": 1}),
        MinimaxCost(1, {"a": 0.5}),
        IterativeCost("a", 1, 0.5),
        GoalCost("a", 0.5),
        VarianceCost({"a": Angle(), "b": Angle(0, (1, 1))}),
    ):
        for method in ("best-first", "breadth-first", "exhaustive"):
            found = find_plan(floats, 2, cost, method=method)
            assert isinstance(found.cost, float), (cost, method)
            assert isinstance(found.lower_bound, float)
