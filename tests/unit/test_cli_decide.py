"""`stochgeom decide`: what it prints, its documents, its exit codes."""

from __future__ import annotations

import json

import pytest
from gmpy2 import mpq

from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.feeding.planning_problems import planning_problem_of
from stochgeom.io.problem_json import problem_document
from stochgeom.thesis.parts import catalogue_part
from tests.commands import call

COIN = {
    "name": "coin",
    "states": ["heads", "tails"],
    "prior": ["2/3", "1/3"],
    "actions": ["turn", "throw"],
    "transitions": {"turn": [[0, 1], [1, 0]], "throw": [["1/2", "1/2"], ["1/2", "1/2"]]},
    "cost": {"kind": "iterative", "goal": ["tails"]},
}


@pytest.fixture
def file(tmp_path):
    """Write a problem, changed in some keys; None takes a key away."""

    def write(**changes):
        path = tmp_path / "problem.json"
        document = {key: value for key, value in {**COIN, **changes}.items() if value is not None}
        path.write_text(json.dumps(document), encoding="utf-8")
        return str(path)

    return write


def test_the_text(capsys, file):
    result = call(capsys, "decide", file(), "--horizon", "3")
    assert result.code == 0
    assert (
        result.out
        == """\
coin: 2 states, 2 actions, exact numbers
cost: expected cost of rounds until the plan ends in the goal

Optimal plan of at most 3 actions
  step  action   possible states  most likely  probability
     0  (prior)                2  heads             0.6667
     1  turn                   2  tails             0.6667

cost 3.0000
a round succeeds with probability 0.6667, 1.5000 rounds on average
rounds that are enough, with which probability: 1 round (50 %), 3 rounds (90 %), 5 rounds (99 %)
No plan that was asked for costs less (proven; 3 nodes, 3 of them different).
"""
    )


def test_the_document(capsys, file):
    document = call(capsys, "decide", file(), "--horizon", "3", "--json").document
    assert document["schema"] == "stochgeom/decision/1"
    assert document["plan"] == ["turn"]
    assert document["cost"] == {"exact": "3", "decimal": "3.0000"}
    assert document["hyperstate"][0] == {"exact": "1/3", "decimal": "0.3333"}
    assert document["proven"] is True
    assert document["rounds"]["quantiles"]["9/10"] == 3


def test_all_optimal_plans(capsys, file):
    goal = {"kind": "goal", "goal": ["heads", "tails"]}
    result = call(capsys, "decide", file(cost=goal), "--horizon", "2", "--all")
    assert "2 plans are optimal and as short:\n  turn\n  throw\n" in result.out
    result = call(capsys, "decide", file(cost=goal), "--horizon", "2", "--allow-empty")
    assert "(prior)" in result.out
    assert "turn" not in result.out


def test_many_optimal_plans_are_cut_short(capsys, file):
    states = {"states": ["a"], "prior": [1], "actions": [f"x{k}" for k in range(30)]}
    tables = {f"x{k}": [[1]] for k in range(30)}
    path = file(**states, transitions=tables, cost={"kind": "additive"})
    assert (
        "and 10 more; --json prints all"
        in call(capsys, "decide", path, "--horizon", "1", "--all").out
    )


def test_the_value_of_floats_is_said_to_be_one(capsys, file):
    path = file(numbers="float", prior=[0.5, 0.5])
    result = call(capsys, "decide", path, "--horizon", "3")
    assert "float numbers" in result.out
    assert "(up to the rounding of floats;" in result.out
    assert call(capsys, "decide", path, "--horizon", "3", "--json").document["cost"] == {
        "exact": "4.0",
        "decimal": "4.0000",
    }


def test_no_plan_is_exit_code_1(capsys, file):
    path = file(cost={"kind": "guaranteed", "goal": ["tails"]})
    result = call(capsys, "decide", path, "--horizon", "3")
    assert result.code == 1
    assert "No plan of at most 3 actions has a finite cost." in result.out
    document = call(capsys, "decide", path, "--horizon", "3", "--json").document
    assert document["cost"] == {"exact": None, "decimal": "infinite"}


def test_a_limit_is_told(capsys, file):
    path = file(cost={"kind": "iterative", "goal": ["tails"]}, prior=["99/100", "1/100"])
    result = call(capsys, "decide", path, "--horizon", "9", "--node-limit", "2")
    assert "NOT proven optimal: ended by the node limit" in result.out
    assert "no plan costs less than" in result.out
    document = call(
        capsys, "decide", path, "--horizon", "9", "--node-limit", "2", "--json"
    ).document
    assert document["proven"] is False
    assert document["ended_by"] == "node limit"


def test_a_threshold(capsys, file):
    result = call(capsys, "decide", file(), "--horizon", "5", "--threshold", "100", "--json")
    assert result.document["plan"]
    assert mpq(result.document["cost"]["exact"]) <= 100


@pytest.mark.parametrize("method", ["best-first", "breadth-first", "exhaustive"])
def test_every_method(capsys, file, method):
    result = call(capsys, "decide", file(), "--horizon", "4", "--method", method, "--json")
    assert result.document["cost"]["exact"] == "3"


def test_a_part(capsys, tmp_path):
    problem = planning_problem_of(catalogue_part("4gon"), cost=IterativeCost(None, 1, 2)).problem
    path = tmp_path / "4gon.json"
    path.write_text(json.dumps(problem_document(problem)), encoding="utf-8")
    result = call(capsys, "decide", str(path), "--horizon", "3")
    assert result.code == 0
    assert "cost 10.0000\n" in result.out
    document = call(capsys, "decide", str(path), "--horizon", "1", "--json").document
    assert "angles" in document["hyperstate"][0]["exact"]


def test_a_pomdp_file_is_written(capsys, file, tmp_path):
    target = tmp_path / "coin.POMDP"
    path = file(cost={"kind": "goal", "goal": ["tails"]})
    assert call(capsys, "decide", path, "--horizon", "1", "--pomdp", str(target)).code == 0
    assert "states: heads tails stopped" in target.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"cost": None}, "key cost: missing; accepted: "),
        ({"prior": [1, 1]}, "prior: the sum is 2; accepted: probabilities of sum 1"),
        ({"prior": ["3/2", "-1/2"]}, "prior, entry 1: probability -1/2 is negative"),
        ({"prior": [1]}, "prior: 1 probabilities; accepted: 2"),
        ({"prior": {"edge": 1}}, "prior: 'edge' is no state; accepted: 'heads', 'tails'"),
        ({"states": []}, "states: no state; accepted: at least one"),
        ({"actions": [], "transitions": {}}, "actions: no action; accepted: at least one"),
        ({"states": ["a", "a"]}, "state 1: the label 'a' stands at 0 already"),
        ({"states": "ab"}, "states: the text 'ab'; accepted: a list of text"),
        ({"states": ["a", None]}, "states, entry 1: null; accepted: text"),
        ({"actions": ["turn"]}, "transitions: 'throw' is no action; accepted: 'turn'"),
        ({"transitions": {"turn": COIN["transitions"]["turn"]}}, "action 'throw': no matrix"),
        ({"transitions": []}, "transitions: a list of 0; accepted: an object"),
        ({"transitions": {"turn": 1, "throw": 1}}, "action 'turn': the number 1; accepted: a list"),
        (
            {"transitions": {**COIN["transitions"], "turn": [[0, 1], ["1/2", "1/3"]]}},
            "action 'turn', row 'tails': the sum is 5/6; accepted: probabilities of sum 1",
        ),
        (
            {"transitions": {**COIN["transitions"], "turn": [[0, 1]]}},
            "action 'turn': 1 rows; accepted: 2, one for each state",
        ),
        (
            {"transitions": {**COIN["transitions"], "turn": {"heads": [0, 1]}}},
            "action 'turn', row 'tails': no row; accepted: one for each state",
        ),
        ({"cost": {"kind": "best"}}, "cost, kind: the text 'best'; accepted: additive, minimax"),
        ({"cost": {"kind": "goal"}}, "cost, key goal: missing; a cost of kind goal needs it"),
        ({"cost": {"kind": "goal", "goal": ["x"]}}, "goal: 'x' is no state"),
        ({"cost": {"kind": "goal", "goal": []}}, "goal: no goal state; accepted: at least one"),
        ({"cost": {"kind": "entropy", "actions": -1}}, "cost of action 'turn': the cost is -1"),
        (
            {"cost": {"kind": "additive", "states": {"edge": 1}}},
            "costs of the states: 'edge' is no state",
        ),
        ({"cost": {"kind": "additive", "action": 1}}, "cost, key 'action': accepted keys: kind"),
        (
            {"cost": {"kind": "variance", "orientations": {"heads": 0}}},
            "orientation of state 'tails': None is no orientation",
        ),
        ({"schema": "stochgeom/plan/1"}, "schema: the text 'stochgeom/plan/1'; accepted"),
        ({"numbers": "real"}, "numbers: the text 'real'; accepted: exact, float"),
        ({"sensor": {}}, "key 'sensor': accepted keys: schema"),
        ({"numbers": "float", "prior": ["1e400", 0]}, "prior, entry 0: the number is too large"),
        ({"prior": [{"angles": [["1"]]}, "1/2"]}, "prior, entry 0, angle 0: a list of 1; accept"),
        ({"prior": [{"angle": []}, 1]}, "prior, entry 0: accepted: an object with constant and"),
        ({"name": 7}, None),
    ],
)
def test_bad_problems_are_one_line_and_exit_code_2(capsys, file, changes, message):
    path = file(**changes)
    result = call(capsys, "decide", path, "--horizon", "2")
    if message is None:
        assert result.code == 0
        return
    assert result.code == 2
    assert result.out == ""
    assert result.err.startswith(f"stochgeom: {path}")
    assert message in result.err
    assert result.err.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--horizon", "x"], "--horizon: 'x'; accepted: whole numbers from 0 on"),
        (["--horizon", "0"], "horizon: 0 actions; accepted: whole numbers from 1 on"),
        (["--horizon", "2", "--node-limit", "0"], "node limit: 0 nodes"),
        (["--horizon", "2", "--time-limit", "0"], "0.0 seconds; accepted"),
        (["--horizon", "2", "--time-limit", "soon"], "--time-limit: 'soon' is not a number"),
        (["--horizon", "30", "--method", "exhaustive"], "make 2147483646 plans of at most 30"),
        (["--horizon", "2", "--time-limit", "1e400"], "--time-limit: the number is too large"),
        (["--horizon", "2", "--threshold", "low"], "--threshold: 'low' is not a number"),
        (["--horizon", "2", "--digits", "-1"], "--digits"),
    ],
)
def test_bad_arguments(capsys, file, arguments, message):
    result = call(capsys, "decide", file(), *arguments)
    assert result.code == 2
    assert message in result.err


def test_free_actions_need_a_horizon(capsys, file):
    result = call(capsys, "decide", file(cost={"kind": "entropy"}))
    assert result.code == 2
    assert "nothing bounds the length of a plan" in result.err
